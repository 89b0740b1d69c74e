use super::*;
use crate::{DVec3, NodeId};

#[test]
fn every_listed_demo_exists_and_no_other() {
    for (name, about) in names() {
        assert!(demo(name).is_some_and(|scene| scene.triangle_count() > 0), "{name}");
        assert!(!about.is_empty() && !about.contains('\n'), "{name}");
    }
    assert!(demo("").is_none() && demo("Teapot").is_none());
}

#[test]
fn every_index_is_in_range_and_parts_cover_the_triangles() {
    for (name, _) in names() {
        let scene = demo(name).unwrap();
        for mesh in &scene.meshes {
            let all = |corners: &[[u32; 3]], count: usize| {
                corners.iter().flatten().all(|&index| (index as usize) < count)
            };
            assert!(all(&mesh.triangles, mesh.positions.len()), "{name}");
            assert!(all(mesh.attribute_corners(), mesh.normals.len()), "{name}");
            assert_eq!(mesh.attribute_corners().len(), mesh.triangles.len(), "{name}");
            assert_eq!(mesh.uvs[0].len(), mesh.normals.len(), "{name}");
            assert!([0, mesh.normals.len()].contains(&mesh.colors.len()), "{name}");
            let mut next = 0;
            for part in &mesh.parts {
                assert_eq!(part.first, next, "{name}");
                assert!(part.material.index() < scene.materials.len(), "{name}");
                next += part.count;
            }
            assert_eq!(next as usize, mesh.triangles.len(), "{name}");
        }
        for texture in scene.materials.iter().filter_map(|material| material.base_color.as_ref()) {
            assert!(texture.texture.index() < scene.textures.len(), "{name}");
        }
    }
}

#[test]
fn nodes_form_a_tree_under_one_root_with_the_demos_name() {
    for (name, _) in names() {
        let scene = demo(name).unwrap();
        for (index, node) in scene.nodes.iter().enumerate() {
            // Parents stand before their children, so there is no cycle.
            assert!(node.parent.is_none_or(|parent| parent.index() < index), "{name}");
            assert!(node.mesh.is_none_or(|mesh| mesh.index() < scene.meshes.len()), "{name}");
            assert!(node.parent_from_node.matrix().is_finite(), "{name}");
            assert_eq!(scene.path(NodeId(index as u32))[0], name);
        }
        let mut paths: Vec<_> =
            scene.objects().iter().map(|object| scene.path(object.node).join("/")).collect();
        let count = paths.len();
        paths.sort();
        paths.dedup();
        assert_eq!(paths.len(), count, "{name}: two objects have one path");
    }
}

#[test]
fn cameras_look_at_the_scene_and_lights_shine_somewhere() {
    for (name, _) in names() {
        let scene = demo(name).unwrap();
        let world = scene.world_from_nodes();
        for camera in &scene.cameras {
            let view_from_world = world[camera.node.unwrap().index()].inverse();
            let centre = view_from_world.transform_point3(scene.bounds().centre());
            assert!(centre.z < 0.0, "{name}: the scene lies behind its camera");
            assert!(centre.truncate().length() < -centre.z * 0.2, "{name}: {centre}");
        }
        for light in &scene.lights {
            assert!(light.position.is_finite() && light.direction != DVec3::ZERO, "{name}");
        }
    }
}

#[test]
fn things_of_the_plane_stand_on_the_ground_and_on_each_other() {
    let scene = demo("plane").unwrap();
    let bounds_of = |name: &str| {
        let objects = scene.objects();
        let object = objects.iter().find(|object| scene.nodes[object.node.index()].name == name);
        let object = object.unwrap_or_else(|| panic!("no {name}"));
        scene.meshes[object.mesh.index()].bounds(&object.world_from_mesh.matrix())
    };
    for name in ["body", "column", "cube", "sphere", "cone"] {
        let bounds = bounds_of(name);
        assert!(bounds.min.y.abs() < 2e-3, "{name} does not stand on the ground: {bounds:?}");
        let ground = bounds_of("ground");
        assert!(ground.union(&bounds).max.with_y(0.0) == ground.max, "{name} is off the ground");
    }
    for (below, above) in [("column", "ball"), ("cube", "torus")] {
        let gap = bounds_of(above).min.y - bounds_of(below).max.y;
        assert!(gap.abs() < 1e-6, "{above} floats {gap} over {below}");
    }
}

#[test]
fn faces_of_the_room_look_into_it() {
    let scene = demo("cornell").unwrap();
    let centre = DVec3::new(278.0, 273.0, 279.5);
    for object in scene.objects() {
        let mesh = &scene.meshes[object.mesh.index()];
        let in_room = scene.path(object.node).contains(&"room");
        let middle = mesh.bounds(&object.world_from_mesh.matrix()).centre();
        let inside = if in_room { centre } else { middle };
        for (triangle, corners) in mesh.triangles.iter().enumerate() {
            let [a, b, c] = corners.map(|index| mesh.position(index));
            let towards = (b - a).cross(c - a).dot(inside - a);
            let name = &scene.nodes[object.node.index()].name;
            assert_eq!(towards > 0.0, in_room, "{name}: triangle {triangle}");
        }
    }
}
