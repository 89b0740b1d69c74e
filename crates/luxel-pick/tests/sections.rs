//! Objects that share a mesh, beside the same objects with a mesh each.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_pick::{Inclusion, PickView, Picker, Region, SnapTo};
use luxel_scene::{
    Camera, DVec3, Joiner, Lens, MaterialId, Part, Projection, Scene, SceneMaterial, Size,
    primitives::icosphere,
};
use luxel_visibility::Cull;

const SIZE: Size = Size { width: 64, height: 48 };

/// Balls that hide one another in part, each of another shape; the triangles of every second are quads.
fn joined() -> Scene {
    let mut joiner = Joiner::new(1000);
    for number in 0..25_u8 {
        let mut ball = icosphere(0.45, 2);
        let at = f32::from(number);
        let place = [at % 5.0 - 2.0, (at / 5.0).floor() * 0.8 - 1.6, 0.3 * (at % 3.0)];
        for position in &mut ball.positions {
            position[0] *= 1.0 + 0.01 * at;
            *position = [0, 1, 2].map(|axis| position[axis] + place[axis]);
        }
        let count = ball.triangles.len() as u32;
        ball.parts = vec![Part { first: 0, count, material: MaterialId(0) }];
        if number % 2 == 0 {
            ball.polygons = Some((0..count).map(|triangle| triangle / 2).collect());
        }
        joiner.push(format!("ball {number}"), ball);
    }
    let mut scene = Scene::default();
    joiner.finish(&mut scene);
    scene.materials = vec![SceneMaterial::default()];
    scene
}

/// What all the ways of picking find.
fn found(scene: Scene) -> Vec<String> {
    let picker = Picker::new(scene).unwrap();
    let camera = Camera {
        view_from_world: Camera::look_at(DVec3::new(0.6, 0.8, 6.0), DVec3::ZERO, DVec3::Y),
        projection: Projection {
            lens: Lens::Perspective { fov_y_radians: 0.7 },
            near: 0.5,
            far: 50.0,
        },
    };
    let view = PickView::new(&picker, camera, SIZE, Cull::Auto).unwrap();
    let mut found = vec![format!("{:?}", view.visible_ids())];
    for y in (0..SIZE.height).step_by(3) {
        for x in (0..SIZE.width).step_by(3) {
            let place = [f64::from(x) + 0.3, f64::from(y) + 0.8];
            let ([at, through], owner) =
                ([view.at(place).into_iter().collect(), view.through(place)], view.owner_at(place));
            let polygon = at.first().and_then(|hit| view.polygon_of(hit));
            found.push(format!("{at:?} {through:?} {owner:?} {polygon:?}"));
            for to in [SnapTo::Vertex, SnapTo::Edge, SnapTo::Face] {
                found.push(format!("{:?}", view.snap(place, to, 4.0)));
            }
        }
    }
    for [x, y, width, height] in [[0.0, 0.0, 64.0, 48.0], [14.0, 8.0, 30.0, 31.0]] {
        let region = Region::rectangle(x, y, width, height).unwrap();
        found.push(format!("{:?}", view.visible_in(&region)));
        for inclusion in [Inclusion::Touching, Inclusion::Enclosed] {
            let hits = view.sliver(&region, inclusion);
            assert!(!hits.is_empty());
            found.push(format!("{hits:?}"));
            for hit in hits {
                found.push(format!("{:?}", view.triangles_in(hit.object, &region)));
            }
        }
    }
    found
}

#[test]
fn sections_are_picked_as_meshes_of_their_own() {
    let joined = joined();
    let separate = joined.separated().into_owned();
    assert_eq!((joined.meshes.len(), separate.meshes.len()), (1, 25));
    let [joined, separate] = [joined, separate].map(found);
    assert!(joined.iter().filter(|found| found.contains("object: 24")).count() > 5);
    for (joined, separate) in joined.iter().zip(&separate) {
        assert_eq!(joined, separate);
    }
}
