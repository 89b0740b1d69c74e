//! Rays through scenes of several objects, against asking every triangle of every object in f64.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_pick::{Picker, WorldRay};
use luxel_scene::{DMat4, DVec3, MaterialId, MeshId, Node, Part, Scene, SceneMaterial, primitives};

/// Spheres in a lattice far from the origin, some stretched, mirrored or flattened.
fn scene() -> Scene {
    let mut mesh = primitives::icosphere(1.0, 5);
    mesh.parts =
        vec![Part { first: 0, count: mesh.triangles.len() as u32, material: MaterialId(0) }];
    let mut scene = Scene {
        meshes: vec![mesh].into(),
        materials: vec![SceneMaterial::default()],
        ..Scene::default()
    };
    for number in 0..60_u32 {
        let at = |step: u32| f64::from(number / step % 4) * 3.0;
        let place = DVec3::new(3e5 + at(1), -2e5 + at(4), at(16));
        let scale = match number % 4 {
            0 => DVec3::ONE,
            1 => DVec3::new(-0.7, 1.2, 0.9),
            2 => DVec3::new(1.0, 1e-7, 1.0),
            _ => DVec3::new(0.5, 0.0, 1.4),
        };
        let turned = DMat4::from_rotation_x(f64::from(number));
        let placed = DMat4::from_translation(place) * turned * DMat4::from_scale(scale);
        let node = Node::root(format!("{number}"), Some(MeshId(0)));
        scene.nodes.push(node.at(None, placed));
    }
    scene
}

#[test]
fn the_nearest_of_all_objects_is_that_of_asking_all_triangles() {
    let scene = scene();
    let picker = Picker::new(scene.clone()).unwrap();
    let objects = scene.objects();
    let middle = DVec3::new(3e5 + 4.5, -2e5 + 4.5, 4.5);
    let mut hits = 0;
    for number in 0..400 {
        let angle = f64::from(number);
        let spread = |k: f64| libm::sin(angle * k + k) * 6.0;
        let origin = middle + DVec3::new(spread(1.1), spread(2.3), spread(3.7)) * 4.0;
        let target = middle + DVec3::new(spread(0.7), spread(1.9), spread(5.3));
        let ray = WorldRay::new(origin, target - origin);
        let mut expected: Vec<(f64, usize, u32, f64)> = Vec::new();
        for (object_number, object) in objects.iter().enumerate() {
            let mesh = &scene.meshes[0];
            for (triangle, corners) in (0..).zip(&mesh.triangles) {
                let [a, b, c] = corners.map(|corner| {
                    object.world_from_mesh.matrix().transform_point3(mesh.position(corner))
                });
                let (ab, ac) = (b - a, c - a);
                let p = ray.direction.cross(ac);
                let determinant = ab.dot(p);
                let q = (origin - a).cross(ab);
                let (v, w) =
                    ((origin - a).dot(p) / determinant, ray.direction.dot(q) / determinant);
                let t = ac.dot(q) / determinant;
                let inside = v.min(w).min(1.0 - v - w);
                if inside > -1e-4 && t > 0.0 {
                    expected.push((t, object_number, triangle, inside));
                }
            }
        }
        expected.sort_by(|a, b| a.0.total_cmp(&b.0));
        let closest = picker.closest(&ray);
        let certain = expected.iter().find(|hit| hit.3 > 1e-4);
        match closest {
            None => assert!(certain.is_none(), "missed {certain:?}"),
            Some(hit) => {
                hits += 1;
                assert!(
                    certain.is_none_or(|certain| hit.t <= certain.0 + 1e-5),
                    "{hit:?} {certain:?}"
                );
                let own = expected.iter().any(|other| {
                    (other.1, other.2) == (hit.object, hit.triangle)
                        && (other.0 - hit.t).abs() < 1e-5
                });
                assert!(own, "{hit:?} isn't among {expected:?}");
                let along = origin + ray.direction * hit.t;
                assert!(hit.position.distance(along) < 1e-4, "{hit:?} {along}");
                // At an edge, and where a flat sphere lies on itself, the two may take either one.
                assert!((picker.all(&ray)[0].t - hit.t).abs() < 1e-6);
            }
        }
        assert_eq!(picker.any(&ray), closest.is_some());
    }
    assert!(hits > 150, "{hits}");
}
