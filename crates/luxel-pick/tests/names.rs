//! Selection with names against asking every primitive by itself, and points and lines near a
//! place.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_pick::{Element, HitRecord, PickView, Picker, Selection, Viewport, pick_matrix};
use luxel_scene::{
    Camera, DMat4, DVec2, DVec3, DVec4, Lens, Lines, MaterialId, Mesh, MeshId, Node, Points,
    Projection, Scene, SceneMaterial, Size,
};
use luxel_visibility::Cull;
use proptest::prelude::*;

const SIZE: Size = Size { width: 64, height: 48 };

/// What is drawn, or done to the names.
#[derive(Clone, Debug)]
enum Step {
    Init,
    Push(u32),
    Load(u32),
    Pop,
    Point([f64; 3]),
    Line([[f64; 3]; 2]),
    Triangle([[f64; 3]; 3]),
}

fn place() -> impl Strategy<Value = [f64; 3]> {
    // Before and behind the eye, within and beside the window.
    [-4.0..4.0, -4.0..4.0, -12.0..2.0]
}

fn step() -> impl Strategy<Value = Step> {
    prop_oneof![
        Just(Step::Init),
        (0..9_u32).prop_map(Step::Push),
        (0..9_u32).prop_map(Step::Load),
        Just(Step::Pop),
        place().prop_map(Step::Point),
        prop::array::uniform2(place()).prop_map(Step::Line),
        prop::array::uniform3(place()).prop_map(Step::Triangle),
    ]
}

/// Least and greatest depth of what the clip volume holds of a point, line or triangle, by looking
/// at many places of it: never more than there is, nearly all of it.
fn sampled(clip_from_object: &DMat4, corners: &[[f64; 3]]) -> Option<[f64; 2]> {
    let corners: Vec<DVec4> = corners
        .iter()
        .map(|&corner| *clip_from_object * DVec3::from_array(corner).extend(1.0))
        .collect();
    let mut depths: Option<[f64; 2]> = None;
    let fine = 160;
    for i in 0..=fine {
        for j in 0..=fine - i {
            let (u, v) = (f64::from(i) / f64::from(fine), f64::from(j) / f64::from(fine));
            let at = match corners[..] {
                [a] => a,
                [a, b] => a.lerp(b, u),
                [a, b, c] => a * (1.0 - u - v) + b * u + c * v,
                _ => return None,
            };
            let inside = [at.x, at.y, at.z].iter().all(|side| side.abs() <= at.w);
            if inside && at.w > 0.0 {
                let depth = (at.z / at.w + 1.0) * 0.5;
                let [low, high] = depths.unwrap_or([depth; 2]);
                depths = Some([low.min(depth), high.max(depth)]);
            }
            if corners.len() < 3 {
                break;
            }
        }
    }
    depths
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn records_hold_what_was_drawn_under_their_names(
        steps in prop::collection::vec(step(), 1..24),
        centre in [0.0..64.0, 0.0..48.0], size in [2.0..60.0, 2.0..60.0],
    ) {
        let lens = Lens::Perspective { fov_y_radians: 0.9 };
        let projection = Projection { lens, near: 0.5, far: 10.0 }.clip_from_view(SIZE);
        let (centre, size) = (DVec2::from_array(centre), DVec2::from_array(size));
        let clip = pick_matrix(centre, size, Viewport::of(SIZE)).unwrap() * projection;
        let mut selection = Selection::new(clip, 10_000);
        // By hand: the names at each primitive, and what is certainly inside of it.
        let mut names: Vec<u32> = Vec::new();
        let mut runs: Vec<(Vec<u32>, Vec<[f64; 2]>)> = vec![(Vec::new(), Vec::new())];
        for step in &steps {
            let corners: Vec<[f64; 3]> = match step {
                Step::Init => { selection.init_names(); names.clear(); vec![] }
                Step::Push(name) => { selection.push_name(*name).unwrap(); names.push(*name); vec![] }
                Step::Load(name) => {
                    let loaded = selection.load_name(*name);
                    prop_assert_eq!(loaded.is_ok(), !names.is_empty());
                    if let Some(top) = names.last_mut() { *top = *name; } else { continue }
                    vec![]
                }
                Step::Pop => {
                    let popped = selection.pop_name();
                    prop_assert_eq!(popped.is_ok(), names.pop().is_some());
                    if popped.is_err() { continue }
                    vec![]
                }
                Step::Point(at) => { selection.point((*at).into()); vec![*at] }
                Step::Line(ends) => { selection.line(ends.map(DVec3::from)); ends.to_vec() }
                Step::Triangle(of) => { selection.triangle(of.map(DVec3::from)); of.to_vec() }
            };
            if corners.is_empty() {
                runs.push((names.clone(), Vec::new()));
            } else if let Some(depths) = sampled(&clip, &corners) {
                runs.last_mut().unwrap().1.push(depths);
            }
        }
        let selected = selection.finish();
        prop_assert!(!selected.overflowed);
        // Each run with something inside has a record, in order, with its names and depths.
        let mut records = selected.records.iter();
        for (names, depths) in runs.iter().filter(|(_, depths)| !depths.is_empty()) {
            let low = depths.iter().map(|depths| depths[0]).fold(1.0, f64::min);
            let high = depths.iter().map(|depths| depths[1]).fold(0.0, f64::max);
            // Records in between are of slivers that fell between the places looked at.
            let found = records.by_ref().find(|record: &&HitRecord| {
                record.names == *names && record.z_min <= low + 1e-9 && record.z_max >= high - 1e-9
            });
            prop_assert!(found.is_some(), "{names:?} {low} {high} of {:?}", selected.records);
        }
        for record in &selected.records {
            prop_assert!(0.0 <= record.z_min && record.z_min <= record.z_max && record.z_max <= 1.0);
        }
    }
}

/// A point at pixel (20.5, 24.5) and a line along row 40.5 from x = 10.5 to 50.5.
fn strokes() -> Scene {
    let at = |x: f32, y: f32| [(x - 32.0) / 16.0, (24.0 - y) / 16.0, 0.0];
    let mesh = Mesh {
        positions: vec![at(20.5, 24.5), at(10.5, 40.5), at(50.5, 40.5)],
        points: vec![Points { indices: vec![0], material: MaterialId(0) }],
        lines: vec![Lines { segments: vec![[1, 2]], material: MaterialId(0) }],
        ..Mesh::default()
    };
    Scene {
        meshes: vec![mesh].into(),
        materials: vec![SceneMaterial::default()],
        nodes: vec![Node::root("strokes", Some(MeshId(0)))],
        ..Scene::default()
    }
}

#[test]
fn points_and_lines_are_hit_within_so_many_pixels_and_no_farther() {
    let scene = strokes();
    let picker = Picker::new(scene.clone()).unwrap();
    let camera = Camera {
        view_from_world: Camera::look_at(DVec3::Z * 5.0, DVec3::ZERO, DVec3::Y),
        projection: Projection { lens: Lens::Orthographic { height: 3.0 }, near: 1.0, far: 9.0 },
    };
    let view = PickView::new(&picker, camera, SIZE, Cull::Auto).unwrap();
    // A point covers 3x3 pixels, a line 1.5 pixels across: what the frame shows is hit as it is.
    let shown = |x, y| view.at([x, y]).map(|hit| hit.element);
    assert_eq!(shown(20.5, 24.5), Some(Element::Point(0)));
    assert_eq!(shown(21.5, 25.5), Some(Element::Point(0)));
    assert_eq!(shown(23.5, 24.5), None);
    assert_eq!(shown(30.5, 40.5), Some(Element::Line(0)));
    assert_eq!(shown(30.5, 42.5), None);
    let near = |x, y, within| view.stroke_near([x, y], within).map(|hit| hit.element);
    for off in [2.5, 4.5, 7.5] {
        assert_eq!(near(30.5, 40.5 + off, off + 0.75), Some(Element::Line(0)), "{off}");
        assert_eq!(near(30.5, 40.5 + off, off - 1.5), None, "{off}");
        assert_eq!(near(20.5 - off, 24.5, off + 0.5), Some(Element::Point(0)), "{off}");
        assert_eq!(near(20.5 - off, 24.5, off - 2.5), None, "{off}");
    }
    // Of two, the nearer one to the place.
    assert_eq!(near(20.5, 31.5, 20.0), Some(Element::Point(0)));
    assert_eq!(near(20.5, 35.5, 20.0), Some(Element::Line(0)));
}
