//! From inside a closed surface, every sample sees it: through the near plane's and the guard
//! band's clipping, from any place, at any scale.

use crate::random::cases;
use crate::scene::best;
use crate::solid::{View, bumpy, direction};
use glam::{DMat4, DVec3};
use luxel_scene::{Lens, Mesh, primitives};
use luxel_visibility::{CullFaces, PartUse};
use proptest::prelude::*;

fn is_closed(view: &View) -> Result<(), TestCaseError> {
    let picture = view.draw(best());
    for (number, position) in view.sample_positions() {
        let seen = picture.seen[number];
        prop_assert!(seen.is_some(), "nothing is seen at {:?}", position);
        prop_assert!(seen.is_some_and(|(depth, _)| (0.0..=1.0).contains(&depth)));
    }
    Ok(())
}

fn moved(mesh: Mesh, origin: DVec3, scale: [f32; 3]) -> Mesh {
    let mut mesh = Mesh { origin, ..mesh };
    for position in &mut mesh.positions {
        *position = std::array::from_fn(|axis| position[axis] * scale[axis]);
    }
    mesh
}

fn lens() -> impl Strategy<Value = Lens> {
    prop_oneof![
        (0.05..3.0).prop_map(|fov_y_radians| Lens::Perspective { fov_y_radians }),
        (10.0..300.0, 10.0..300.0, -50.0..150.0, -50.0..150.0)
            .prop_map(|(fx, fy, cx, cy)| Lens::Intrinsics { fx, fy, cx, cy }),
    ]
}

proptest! {
    #![proptest_config(cases(120))]

    #[test]
    fn a_sphere_is_closed_around_the_eye(
        (place, towards, reach) in (direction(), direction(), 0.0..0.5),
        lens in lens(),
        frequency in 1..8_u32,
        near in prop::sample::select(vec![1e-2, 1e-4, 1e-7]),
        samples in prop::sample::select(vec![1, 4]),
    ) {
        let eye = place * reach;
        let mesh = bumpy(frequency);
        let view = View::look(mesh, eye, eye + towards, lens, [near, 10.0]);
        is_closed(&View { samples, ..view })?;
    }

    #[test]
    fn a_room_is_closed_though_its_corners_are_a_million_away(
        (place, towards) in (direction(), direction()),
        lens in lens(),
        scale in prop::sample::select(vec![
            [1.0, 1.0, 1.0], [1e6, 1.0, 1.0], [1.0, 1e6, 1e6], [1e6, 1e6, 1e6], [1e-2, 1e3, 1.0],
        ]),
        near in prop::sample::select(vec![1e-1, 1e-3]),
    ) {
        let room = moved(primitives::cuboid(DVec3::splat(8.0)), DVec3::ZERO, scale);
        let [x, y, z] = scale.map(f64::from);
        let eye = place * 2.0 * DVec3::new(x.min(1.0), y.min(1.0), z.min(1.0));
        let smallest = x.min(y).min(z).min(1.0);
        let far = if near > 0.01 { f64::INFINITY } else { 1e8 };
        is_closed(&View::look(room, eye, eye + towards, lens, [near * smallest, far]))?;
    }

    #[test]
    fn a_room_far_from_the_world_s_origin_is_closed(
        (place, towards) in (direction(), direction()),
        lens in lens(),
    ) {
        let origin = DVec3::new(1e7, -3e7, 2e7);
        let room = moved(primitives::cuboid(DVec3::splat(3.0)), origin, [1.0; 3]);
        let eye = origin + place;
        is_closed(&View::look(room, eye, eye + towards, lens, [1e-3, 100.0]))?;
    }

    #[test]
    fn culled_faces_are_those_that_the_eye_sees_from_behind(
        towards in direction(), inside in any::<bool>(),
    ) {
        let eye = if inside { DVec3::ZERO } else { towards * -4.0 };
        let lens = Lens::Perspective { fov_y_radians: 0.4 };
        let view = View::look(bumpy(4), eye, eye + towards, lens, [0.1, 10.0]);
        let culled = |cull| View { part: PartUse { cull, ..view.part }, ..view.clone() }.draw(best());
        let (fronts, backs) = (culled(CullFaces::Clockwise), culled(CullFaces::CounterClockwise));
        let all = view.draw(best());
        let shown = if inside { &backs } else { &fronts };
        // At outlines, a face's corners may turn over as they are snapped.
        let other = shown.seen.iter().zip(&all.seen).filter(|(shown, all)| shown != all).count();
        prop_assert!(other < 10, "{} samples see the other side", other);
        prop_assert_eq!(fronts.seen.iter().any(Option::is_some), !inside);
        prop_assert!(backs.seen.iter().any(Option::is_some));
    }
}

#[test]
fn numbers_that_overflow_draw_nothing_and_harm_nothing() {
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    for scale in [1e30, 3e38, f32::INFINITY, f32::NAN, -f32::INFINITY, 1e-38, 0.0] {
        for stretched in [1.0, 1e300, 0.0] {
            let mesh = moved(bumpy(3), DVec3::ZERO, [scale, 1.0, scale]);
            let mut view = View::look(mesh, DVec3::ZERO, DVec3::ONE, lens, [1e-3, 1e3]);
            view.view_from_mesh *= DMat4::from_scale(DVec3::new(1.0, stretched, 1.0));
            let picture = view.draw(best());
            let depths = picture.seen.iter().flatten().map(|&(depth, _)| depth);
            assert!(depths.into_iter().all(|depth| (0.0..=1.0).contains(&depth)));
        }
    }
}

#[test]
fn a_vertex_that_is_no_number_takes_only_its_own_triangles_away() {
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    let mut mesh = bumpy(3);
    let whole = View::look(mesh.clone(), DVec3::Z * 4.0, DVec3::ZERO, lens, [0.1, 10.0]);
    let broken = mesh.triangles.iter().position(|triangle| triangle.contains(&7)).unwrap();
    mesh.positions[7] = [f32::NAN; 3];
    let damaged = View { mesh: mesh.clone(), ..whole.clone() };
    assert!(mesh.triangles[broken].contains(&7));
    let (before, after) = (whole.draw(best()), damaged.draw(best()));
    for (before, after) in before.seen.iter().zip(&after.seen) {
        let lost = before.is_some_and(|(_, (_, t))| mesh.triangles[t as usize].contains(&7));
        assert!(lost || before == after, "{before:?} became {after:?}");
        assert!(after.is_none_or(|(_, (_, t))| !mesh.triangles[t as usize].contains(&7)));
    }
}

#[test]
fn the_last_column_and_row_of_the_widest_window_are_drawn_when_clipped() {
    let lens = Lens::Perspective { fov_y_radians: 1.0 };
    for size in [[16384, 8], [8, 16384], [32766, 8]] {
        let view = View::look(bumpy(2), DVec3::ZERO, DVec3::Z, lens, [1e-5, 10.0]);
        let size = luxel_scene::Size { width: size[0], height: size[1] };
        let seen = View { size, ..view }.draw(best()).seen;
        assert!(seen.iter().all(Option::is_some), "{size:?}");
    }
}
