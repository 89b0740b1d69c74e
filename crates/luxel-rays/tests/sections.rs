//! Objects that share a mesh, beside the same objects with a mesh each.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod common;

use common::Random;
use luxel_math::LANES;
use luxel_rays::{Blocker, RayLanes, SceneRays, Spread, WorldRay};
use luxel_scene::{
    AlphaMode, Joiner, MaterialId, Part, Scene, SceneMaterial, primitives::icosphere,
};

/// Balls among one another, each of one of these materials in turn.
fn joined(modes: &[AlphaMode]) -> Scene {
    let mut random = Random(7);
    let mut joiner = Joiner::new(1000);
    for number in 0..40 {
        let mut ball = icosphere(0.3, 2);
        let [x, y, z] = (random.vector() * 2.0).as_vec3().to_array();
        for position in &mut ball.positions {
            *position = [position[0] + x, position[1] + y, position[2] + z];
        }
        let material = MaterialId(number % modes.len() as u32);
        ball.parts = vec![Part { first: 0, count: ball.triangles.len() as u32, material }];
        joiner.push(format!("ball {number}"), ball);
    }
    let mut scene = Scene::default();
    joiner.finish(&mut scene);
    let material =
        |&alpha_mode| SceneMaterial { alpha_mode, opacity: 0.4, ..SceneMaterial::default() };
    scene.materials = modes.iter().map(material).collect();
    scene
}

/// What rays find: the same for both, and something.
#[test]
fn rays_find_sections_as_meshes_of_their_own_whatever_they_are_made_of() {
    let (opaque, glass) = (AlphaMode::Opaque, AlphaMode::Blend);
    for (modes, bodies) in [(&[opaque, opaque][..], 1), (&[glass], 1), (&[opaque, glass], 40)] {
        let joined = joined(modes);
        let separate = joined.separated().into_owned();
        assert_eq!((joined.meshes.len(), separate.meshes.len()), (1, 40));
        let [joined, separate] = [joined, separate].map(|scene| SceneRays::new(scene).unwrap());
        assert_eq!((joined.bodies(), joined.objects().len()), (bodies, 40));
        let mut random = Random(11);
        let rays: Vec<WorldRay> =
            (0..2000).map(|_| WorldRay::new(random.vector() * 4.0, random.vector())).collect();
        let (mut found, mut objects) = (0, std::collections::BTreeSet::new());
        for ray in &rays {
            let hits = joined.all(ray);
            assert_eq!(hits, separate.all(ray), "{modes:?} {ray:?}");
            assert_eq!(joined.closest(ray), hits.first().copied());
            assert_eq!(joined.any(ray), !hits.is_empty());
            // Distances of blockers are those of the trees, in f32, whose boxes differ.
            let [ours, theirs] = [joined.blockers(ray), separate.blockers(ray)];
            assert_eq!(ours.len(), theirs.len());
            for (one, other) in ours.iter().zip(theirs) {
                assert_eq!(Blocker { t: other.t, ..*one }, other);
                assert!((one.t - other.t).abs() < 1e-6 * (1.0 + other.t), "{one:?} {other:?}");
            }
            assert_eq!(joined.transmittance(ray), separate.transmittance(ray));
            for hit in hits {
                let (body, triangle) = joined.in_body(hit.object, hit.triangle);
                assert_eq!(joined.in_object(body, triangle), (hit.object, hit.triangle));
                assert_eq!(joined.body_of(hit.object), body);
                assert!(joined.objects_of(body).contains(&hit.object));
                let place = joined.places(hit.object, hit.triangle).unwrap().at([0.2, 0.3, 0.5]);
                let other = separate.places(hit.object, hit.triangle).unwrap().at([0.2, 0.3, 0.5]);
                assert_eq!(place, other);
                found += 1;
                objects.insert(hit.object);
            }
        }
        assert!(found > 300 && objects.len() == 40, "{found} hits of {} objects", objects.len());
        assert_eq!(joined.closest_of_each(&rays), separate.closest_of_each(&rays));
        assert_eq!(joined.any_of_each(&rays), separate.any_of_each(&rays));
        for spread in [Spread::Narrow, Spread::Wide] {
            for rays in rays.chunks(LANES) {
                let mut lanes = RayLanes::NONE;
                rays.iter().enumerate().for_each(|(lane, ray)| lanes.put(lane, ray));
                let lanes = [lanes];
                let through = [&joined, &separate].map(|of| {
                    let mut through = [[2.0; LANES]];
                    of.transmittance_of_lanes(&lanes, spread, &mut through);
                    through
                });
                assert_eq!(through[0], through[1]);
            }
        }
    }
}

#[test]
fn rays_meet_only_the_sections_that_are_listed() {
    let scene = std::sync::Arc::new(joined(&[AlphaMode::Opaque]));
    let level = SceneRays::new(scene.clone()).unwrap().level();
    let mut objects = scene.objects();
    let quality = luxel_rays::Quality::Thorough;
    let all = SceneRays::of_objects(scene.clone(), objects.clone(), quality, level).unwrap();
    objects.retain(|object| object.section % 2 == 1);
    let some = SceneRays::of_objects(scene, objects, quality, level).unwrap();
    assert_eq!((some.objects().len(), some.bodies()), (20, 20));
    let mut random = Random(3);
    let mut left_out = 0;
    for _ in 0..500 {
        let ray = WorldRay::new(random.vector() * 4.0, random.vector());
        let (odd, even): (Vec<_>, Vec<_>) =
            all.all(&ray).into_iter().partition(|hit| hit.object % 2 == 1);
        left_out += even.len();
        let found: Vec<_> = some.all(&ray).iter().map(|hit| (2 * hit.object + 1, hit.t)).collect();
        assert_eq!(found, odd.iter().map(|hit| (hit.object, hit.t)).collect::<Vec<_>>());
    }
    assert!(left_out > 50, "{left_out}");
}
