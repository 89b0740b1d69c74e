//! Rays that are traced together, through scenes of one object, several and many.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod common;

use common::Random;
use luxel_math::LANES;
use luxel_rays::{RayLanes, SceneRays, Spread, WorldRay};
use luxel_scene::{
    AlphaMode, DMat4, DVec3, MaterialId, MeshId, Node, Part, Scene, SceneMaterial, demos,
    primitives::icosphere,
};

/// Batches as openness asks for them, from sixteen places all ways; some are far from everything.
fn batches(scene: &Scene, count: usize) -> Vec<Vec<RayLanes>> {
    let mut random = Random(41);
    let objects = scene.objects();
    let mut places = Vec::new();
    for object in &objects {
        let mesh = &scene.meshes[object.mesh.index()];
        for vertex in (0..mesh.positions.len() as u32).step_by(97) {
            places.push(object.world_from_mesh.matrix().transform_point3(mesh.position(vertex)));
        }
    }
    let low = places.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = places.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    let size = (high - low).length();
    let batch = |at: usize| {
        let place = places[at * 31 % places.len()];
        let (end, away) = match at % 4 {
            0 => (0.1 * size, 0.001 * size),
            1 => (0.5 * size, 0.2 * size),
            2 => (f64::INFINITY, 0.01 * size),
            _ => (3.0 * size, 300.0 * size),
        };
        let origins: Vec<DVec3> = (0..LANES).map(|_| place + random.vector() * away).collect();
        let rays = |_| {
            let mut lanes = RayLanes::NONE;
            for (lane, &origin) in origins.iter().enumerate().skip(at % 3) {
                let direction = match at % 4 {
                    3 => place + random.vector() * size - origin,
                    _ => random.vector(),
                };
                let range = [0.0, end];
                lanes.put(lane, &WorldRay { origin, direction, range });
            }
            lanes
        };
        (0..16).map(rays).collect()
    };
    (0..count).map(batch).collect()
}

#[test]
fn as_much_light_comes_along_rays_together_as_alone_however_many_objects_there_are() {
    for name in ["teapot", "cornell", "plane", "spheres"] {
        let scene = demos::demo(name).unwrap();
        let rays = SceneRays::new(scene).unwrap();
        let (mut blocked, mut all) = (0, 0);
        for batch in batches(rays.scene(), 120) {
            for spread in [Spread::Wide, Spread::Narrow] {
                let mut through = vec![[2.0; LANES]; batch.len()];
                rays.transmittance_of_lanes(&batch, spread, &mut through);
                for (lanes, through) in batch.iter().zip(&through) {
                    for (lane, &through) in through.iter().enumerate() {
                        let ray = lanes.ray(lane);
                        let expected = if lanes.lanes >> lane & 1 == 0 {
                            1.0
                        } else {
                            rays.transmittance(&ray)
                        };
                        assert_eq!(through, expected, "{name}, {spread:?}: {ray:?}");
                        (blocked, all) = (blocked + usize::from(through < 1.0), all + 1);
                    }
                }
            }
        }
        assert!(blocked * 20 > all && blocked * 20 < 19 * all, "{name}: {blocked} of {all}");
    }
}

/// Balls among one another, each a body: opaque ones, glass of two kinds, and masks that are all there or all hole.
fn balls(count: u32) -> Scene {
    let material =
        |alpha_mode, opacity| SceneMaterial { alpha_mode, opacity, ..SceneMaterial::default() };
    let mask = AlphaMode::Mask { cutoff: 0.5 };
    let mut scene = Scene {
        materials: vec![
            material(AlphaMode::Blend, 0.4),
            material(AlphaMode::Blend, 0.7),
            material(mask, 0.3),
            material(AlphaMode::Blend, 0.2),
            material(mask, 0.9),
            material(AlphaMode::Opaque, 1.0),
        ],
        ..Scene::default()
    };
    for material in (0..scene.materials.len() as u32).map(MaterialId) {
        let mut ball = icosphere(0.3, 2);
        ball.parts = vec![Part { first: 0, count: ball.triangles.len() as u32, material }];
        scene.meshes.push(ball);
    }
    let mut random = Random(7);
    for number in 0..count {
        let mesh = MeshId(number % scene.meshes.len() as u32);
        scene.nodes.push(Node {
            parent_from_node: DMat4::from_translation(random.vector() * 1.2).into(),
            ..Node::root(format!("ball {number}"), Some(mesh))
        });
    }
    scene
}

/// Bundles of rays that run close together, each another way through the middle.
fn bundles(count: usize) -> Vec<Vec<RayLanes>> {
    let mut random = Random(5);
    let bundle = |_| {
        let (origin, direction) = (random.vector() * 3.0, random.vector());
        let direction = direction - origin;
        let mut lanes = |number| {
            let mut lanes = RayLanes::NONE;
            for lane in (0..LANES).filter(|lane| (lane + number) % 7 != 0) {
                let origin = origin + random.vector() * 0.1;
                lanes.put(lane, &WorldRay::new(origin, direction + random.vector() * 0.1));
            }
            lanes
        };
        (0..4).map(&mut lanes).collect()
    };
    (0..count).map(bundle).collect()
}

#[test]
fn bodies_that_let_light_through_weaken_it_once_each_and_none_that_an_opaque_one_blocks() {
    for count in [1, 2, 6, 12, 60] {
        let rays = SceneRays::new(balls(count)).unwrap();
        let (mut partly, mut blocked, mut free) = (0, 0, 0);
        let narrow = bundles(300).into_iter().map(|bundle| (bundle, Spread::Narrow));
        let wide = batches(rays.scene(), 40).into_iter().map(|batch| (batch, Spread::Wide));
        for (batch, spread) in narrow.chain(wide) {
            let mut through = vec![[2.0; LANES]; batch.len()];
            rays.transmittance_of_lanes(&batch, spread, &mut through);
            for (lanes, through) in batch.iter().zip(&through) {
                for lane in (0..LANES).filter(|lane| lanes.lanes >> lane & 1 != 0) {
                    let (ray, through) = (lanes.ray(lane), through[lane]);
                    let blockers = rays.blockers(&ray);
                    let expected = match blockers.iter().any(|blocker| blocker.alpha >= 1.0) {
                        true => 0.0,
                        false => blockers.iter().fold(1.0, |part, of| part * (1.0 - of.alpha)),
                    };
                    let place = format!("{count} balls, {spread:?}: {ray:?}");
                    assert_eq!(through, expected, "{place}: {blockers:?}");
                    assert_eq!(rays.transmittance(&ray), expected, "{place}: {blockers:?}");
                    match through {
                        0.0 => blocked += 1,
                        1.0 => free += 1,
                        _ => partly += 1,
                    }
                }
            }
        }
        let is_mixed = partly > 1000 && free > 1000 && (blocked > 1000 || count < 6);
        assert!(is_mixed, "{count}: {partly} {blocked} {free}");
    }
}

#[test]
fn thousands_of_surfaces_in_the_way_of_rays_together_weaken_each_as_alone() {
    let mut scene = balls(2);
    scene.materials[0].opacity = 0.000_5;
    let ball = &mut scene.meshes[0];
    ball.triangles = ball.triangles.repeat(1500);
    ball.attribute_corners = ball.attribute_corners.take().map(|corners| corners.repeat(1500));
    ball.parts[0].count = ball.triangles.len() as u32;
    let middle = scene.objects()[0].world_from_mesh.matrix().transform_point3(DVec3::ZERO);
    let rays = SceneRays::new(scene).unwrap();
    let mut random = Random(3);
    let mut lanes = || {
        let mut lanes = RayLanes::NONE;
        for lane in 0..LANES {
            let direction = DVec3::NEG_Z + random.vector() * 0.01;
            lanes.put(lane, &WorldRay::new(middle + DVec3::Z, direction));
        }
        lanes
    };
    let bundle = [lanes(), lanes()];
    let mut through = [[2.0; LANES]; 2];
    rays.transmittance_of_lanes(&bundle, Spread::Narrow, &mut through);
    for (lanes, through) in bundle.iter().zip(&through) {
        for (lane, &through) in through.iter().enumerate() {
            let blockers = rays.blockers(&lanes.ray(lane));
            assert!(blockers.len() >= 3000, "{}", blockers.len());
            let expected = blockers.iter().fold(1.0, |part, of| part * (1.0 - of.alpha));
            assert!(through == expected && (0.01..0.99).contains(&through), "{through}");
        }
    }
}
