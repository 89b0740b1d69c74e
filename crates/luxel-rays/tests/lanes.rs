//! Rays that are traced together, through scenes of one object, several and many.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod common;

use common::Random;
use luxel_math::LANES;
use luxel_rays::{RayLanes, SceneRays, Spread, WorldRay};
use luxel_scene::{DVec3, Scene, demos};

/// Batches as openness asks for them, from sixteen places all ways; some are far from everything.
fn batches(scene: &Scene, count: usize) -> Vec<Vec<RayLanes>> {
    let mut random = Random(41);
    let objects = scene.objects();
    let mut places = Vec::new();
    for object in &objects {
        let mesh = &scene.meshes[object.mesh.index()];
        for vertex in (0..mesh.positions.len() as u32).step_by(97) {
            places.push(object.world_from_mesh.transform_point3(mesh.position(vertex)));
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
