use super::*;
use crate::primitives;
use glam::DVec3;

const FIRST: MeshId = MeshId(0);

fn right(meshes: &Meshes) -> f64 {
    meshes.bounds_of(FIRST, &DMat4::IDENTITY).max.x
}

fn measured() -> Meshes {
    let meshes: Meshes = vec![primitives::cuboid(DVec3::splat(2.0))].into();
    assert!(!meshes.has_trees());
    assert_eq!(right(&meshes), 1.0);
    assert!(meshes.has_trees());
    meshes
}

#[test]
fn whatever_changes_a_mesh_drops_what_was_measured() {
    let shift = |mesh: &mut Mesh| mesh.positions.iter_mut().for_each(|[x, ..]| *x += 4.0);
    let changes: [&dyn Fn(&mut Meshes); 7] = [
        &|meshes| shift(&mut meshes[0]),
        &|meshes| meshes.iter_mut().for_each(shift),
        &|meshes| {
            for mesh in meshes {
                shift(mesh);
            }
        },
        &|meshes| meshes.first_mut().into_iter().for_each(shift),
        &|meshes| meshes[0].origin.x = 4.0,
        &|meshes| {
            let mut mesh = meshes.remove(0);
            shift(&mut mesh);
            meshes.push(mesh);
        },
        &|meshes| {
            let mut list = Vec::from(std::mem::take(meshes));
            shift(&mut list[0]);
            *meshes = list.into();
        },
    ];
    for (number, change) in changes.iter().enumerate() {
        let mut meshes = measured();
        change(&mut meshes);
        assert!(!meshes.has_trees(), "{number}");
        assert_eq!(right(&meshes), 5.0, "{number}");
    }
    // Other triangles draw other positions.
    let mut meshes = measured();
    meshes[0].triangles.clear();
    assert!(meshes.bounds_of(FIRST, &DMat4::IDENTITY).is_empty());
}

#[test]
fn copies_share_what_was_measured_until_they_differ() {
    let original = measured();
    let mut copy = original.clone();
    assert!(copy.has_trees());
    copy[0].origin.x = 4.0;
    assert!(original.has_trees() && !copy.has_trees());
    assert_eq!((right(&original), right(&copy)), (1.0, 5.0));
    // The first measurement of a copy, after the other has changed.
    let mut original: Meshes = vec![primitives::cuboid(DVec3::splat(2.0)); 2].into();
    assert_eq!(original.bounds_of(MeshId(1), &DMat4::IDENTITY).max.x, 1.0);
    let copy = original.clone();
    original[0].origin.x = 4.0;
    assert_eq!((right(&copy), right(&original)), (1.0, 5.0));
}

#[test]
fn threads_that_need_a_tree_at_once_dont_wait_for_each_other() {
    let mesh = primitives::icosphere(1.0, 60);
    let expected = mesh.bounds(&DMat4::IDENTITY);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
    for _ in 0..20 {
        let meshes: Meshes = std::iter::once(mesh.clone()).collect();
        let bounds = pool.install(|| {
            luxel_parallel::map(12, 1, &|_| Some(meshes.bounds_of(FIRST, &DMat4::IDENTITY)))
        });
        assert!(bounds.into_iter().flatten().all(|bounds| bounds == expected));
    }
}
