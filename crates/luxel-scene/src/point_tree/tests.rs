use super::*;
use crate::primitives;
use std::collections::BTreeSet;

fn points(tree: &PointTree, mesh: &Mesh) -> Vec<[f32; 3]> {
    let leaves = 0..tree.len().div_ceil(LEAF);
    let mut room = [[0.0; 3]; LEAF];
    leaves.flat_map(|leaf| tree.leaf(mesh, leaf, &mut room).to_vec()).collect()
}

fn bits(points: &[[f32; 3]]) -> BTreeSet<[u32; 3]> {
    points.iter().map(|point| point.map(f32::to_bits)).collect()
}

/// The same mesh, its positions far from their neighbours.
fn shuffled(mut mesh: Mesh) -> Mesh {
    let count = mesh.positions.len();
    let place = |at: usize| at * 7919 % count;
    let mut positions = mesh.positions.clone();
    for (at, position) in mesh.positions.iter().enumerate() {
        positions[place(at)] = *position;
    }
    assert_eq!(bits(&positions), bits(&mesh.positions));
    mesh.positions = positions;
    mesh.triangles =
        mesh.triangles.iter().map(|corners| corners.map(|at| place(at as usize) as u32)).collect();
    mesh
}

#[test]
fn a_mesh_in_order_needs_no_list_of_points_and_a_shuffled_one_is_sorted() {
    let mesh = primitives::icosphere(1.0, 40);
    let tree = PointTree::new(&mesh);
    assert!(tree.order.is_none());
    assert_eq!(points(&tree, &mesh), mesh.positions);

    let shuffled = shuffled(mesh.clone());
    let tree = PointTree::new(&shuffled);
    let order = tree.order.as_ref().unwrap();
    assert_eq!(order.iter().collect::<BTreeSet<_>>().len(), mesh.positions.len());
    assert_eq!(bits(&points(&tree, &shuffled)), bits(&mesh.positions));
    let in_place = leaves(&shuffled, tree.order.as_deref(), tree.len());
    assert!(!is_scattered(&in_place, tree.bounds()));
}

#[test]
fn positions_that_are_not_drawn_are_not_in_the_tree() {
    let mut mesh = primitives::icosphere(1.0, 40);
    let far = mesh.positions.len();
    mesh.positions.push([9.0; 3]);
    let tree = PointTree::new(&mesh);
    assert_eq!(points(&tree, &mesh), mesh.positions[..far]);
    assert_eq!(tree.bounds(), PointTree::new(&primitives::icosphere(1.0, 40)).bounds());
    let nothing = PointTree::new(&Mesh { positions: vec![[0.0; 3]; 500], ..Mesh::default() });
    assert_eq!((nothing.len(), nothing.levels().len()), (0, 0));
}

#[test]
fn each_node_holds_the_points_below_it() {
    let mesh = primitives::icosphere(1.0, 40);
    let tree = PointTree::new(&mesh);
    let mut points_below = LEAF;
    for level in tree.levels() {
        for (number, node) in level.iter().enumerate() {
            for (child, found) in node.children().enumerate() {
                let below =
                    mesh.positions.chunks(points_below).nth(WIDTH * number + child).unwrap();
                let leaves = below.chunks(LEAF).map(Dop::of);
                assert_eq!(found, leaves.fold(Dop::default(), |all, leaf| all.union(&leaf)));
            }
        }
        points_below *= WIDTH;
    }
    assert!(points_below >= tree.len());
}

#[test]
fn a_tree_takes_two_bytes_a_point() {
    let mesh = primitives::icosphere(1.0, 71);
    let tree = PointTree::new(&mesh);
    let nodes: usize = tree.levels().iter().map(Vec::capacity).sum();
    let bytes = nodes * size_of::<Node>();
    assert!(bytes < 2 * tree.len(), "{bytes} bytes for {} points", tree.len());
}
