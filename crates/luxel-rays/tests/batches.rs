//! Batched queries equal single ones.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod common;

use common::Random;
use luxel_rays::{SceneRays, WorldRay};
use luxel_scene::{DVec3, Scene, demos};

/// Rays side by side through a window, from all around, from inside, of limited ranges, and invalid
/// ones: without a direction, or with numbers that are not finite.
fn rays_about(scene: &Scene) -> Vec<WorldRay> {
    let bounds = scene.bounds();
    let (middle, radius) = (bounds.centre(), bounds.radius());
    let mut random = Random(77);
    let mut rays = Vec::new();
    let eye = middle + DVec3::new(0.4, 0.7, 3.0) * radius;
    for at in 0..3_000 {
        let across = DVec3::new(f64::from(at % 60) - 29.5, f64::from(at / 60) - 24.5, 0.0) / 30.0;
        rays.push(WorldRay::new(eye, middle + across * radius - eye));
    }
    for at in 0..3_000 {
        let origin = middle + random.vector() * radius * [0.3, 3.0, 500.0][at % 3];
        let direction = middle + random.vector() * radius - origin;
        let range = [[0.0, f64::INFINITY], [0.5, f64::INFINITY], [0.0, 0.9], [0.95, 1.05]][at % 4];
        rays.push(WorldRay { origin, direction, range });
    }
    for at in (0..rays.len()).step_by(17) {
        match at % 3 {
            0 => rays[at].direction = DVec3::ZERO,
            1 => rays[at].origin.x = f64::NAN,
            _ => rays[at].direction.y = f64::INFINITY,
        }
    }
    rays
}

#[test]
fn batched_queries_equal_single_ones_through_one_few_and_many_objects() {
    let mut counts = Vec::new();
    for name in ["lab-terminator", "cornell", "plane", "spheres"] {
        let scene = SceneRays::new(demos::demo(name).unwrap()).unwrap();
        counts.push(scene.objects().len());
        let rays = rays_about(scene.scene());
        let (closest, any) = (scene.closest_of_each(&rays), scene.any_of_each(&rays));
        let mut hits = 0;
        for ((ray, closest), any) in rays.iter().zip(&closest).zip(&any) {
            assert_eq!(*closest, scene.closest(ray), "{name}: {ray:?}");
            assert_eq!(*any, scene.any(ray), "{name}: {ray:?}");
            hits += usize::from(*any);
        }
        assert!(hits * 10 > rays.len() && hits * 10 < 9 * rays.len(), "{name}: {hits}");
    }
    counts.sort_unstable();
    assert!(
        counts[0] == 1 && counts[3] > 8 && counts.iter().any(|of| (2..=8).contains(of)),
        "{counts:?}"
    );
}
