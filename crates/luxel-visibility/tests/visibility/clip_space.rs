//! Triangles in clip coordinates against the definition, in f64: b with the point's x/w and y/w.

use crate::random::cases;
use crate::scene::best;
use glam::{DMat3, DVec3};
use luxel_scene::Size;
use luxel_visibility::{Fragment, rasterize};
use proptest::prelude::*;

type Vertex = [f32; 4];

/// Barycentrics and z/w where a triangle passes through a place in normalized device coordinates.
fn meet(corners: [Vertex; 3], [x, y]: [f64; 2]) -> Option<([f64; 3], f64)> {
    let corners = corners.map(|corner| corner.map(f64::from));
    let columns = corners.map(|[cx, cy, _, cw]| DVec3::new(cx - x * cw, cy - y * cw, 1.0));
    let matrix = DMat3::from_cols(columns[0], columns[1], columns[2]);
    let b = (matrix.determinant() != 0.0).then(|| matrix.inverse() * DVec3::Z)?.to_array();
    let mean = |i: usize| b.iter().zip(corners).map(|(b, corner)| b * corner[i]).sum::<f64>();
    let (z, w) = (mean(2), mean(3));
    let is_seen = b.iter().all(|&b| b >= 0.0) && w > 0.0 && z.abs() <= w;
    is_seen.then_some((b, z / w))
}

/// What a place sees, if nothing else is as near.
fn nearest(vertices: &[Vertex], faces: &[[u32; 3]], at: [f64; 2]) -> Option<Option<u32>> {
    let mut hits: Vec<(f64, u32)> = Vec::new();
    for (number, face) in (0..).zip(faces) {
        let corners = face.map(|vertex| vertices[vertex as usize]);
        hits.extend(meet(corners, at).map(|(_, depth)| (depth, number)));
    }
    hits.sort_by(|a, b| a.0.total_cmp(&b.0));
    match hits[..] {
        [] => Some(None),
        [(a, _), (b, _), ..] if b - a < 1e-4 => None,
        [(_, number), ..] => Some(Some(number)),
    }
}

/// Compares all pixels whose surroundings, some steps of the window's grid, see one thing; how many see a
/// triangle.
fn compare(vertices: &[Vertex], faces: &[[u32; 3]], size: Size) -> Result<usize, TestCaseError> {
    let fragments = rasterize(vertices, faces, size, best()).unwrap();
    let Size { width, height } = size;
    prop_assert_eq!(fragments.len(), (width * height) as usize);
    let mut compared = 0;
    for (at, found) in fragments.iter().enumerate() {
        let (column, row) = (at as u32 % width, at as u32 / width);
        let place = |right: f64, down: f64| {
            [
                2.0 * (f64::from(column) + 0.5 + right) / f64::from(width) - 1.0,
                1.0 - 2.0 * (f64::from(row) + 0.5 + down) / f64::from(height),
            ]
        };
        let around = [[0.0, 0.0], [0.02, 0.0], [-0.02, 0.0], [0.0, 0.02], [0.0, -0.02]];
        let seen = around.map(|[right, down]| nearest(vertices, faces, place(right, down)));
        let Some(expected) = seen[0].filter(|_| seen.iter().all(|other| *other == seen[0])) else {
            continue;
        };
        let pixel = [column, row];
        prop_assert_eq!(found.map(|found| found.triangle), expected, "at {:?}", pixel);
        let Some(Fragment { triangle, barycentric, depth }) = *found else { continue };
        let corners = faces[triangle as usize].map(|vertex| vertices[vertex as usize]);
        let (b, z) = meet(corners, place(0.0, 0.0)).unwrap();
        for (found, expected) in barycentric.iter().zip(b) {
            prop_assert!((f64::from(*found) - expected).abs() < 1e-6, "{found} at {pixel:?}");
        }
        prop_assert!((f64::from(depth) - z).abs() < 1e-6, "{depth} at {pixel:?}");
        compared += 1;
    }
    Ok(compared)
}

/// Points that a perspective with an oblique near plane, or one without, has projected.
fn projected(points: &[[f32; 3]], perspective: bool) -> Vec<Vertex> {
    let of = |&[x, y, z]: &[f32; 3]| match perspective {
        true => [x, y, 1.02 * (z + 3.0) - 0.4 + 0.1 * x, z + 3.0],
        false => [0.5 * x, 0.5 * y, 0.3 * z, 1.0],
    };
    points.iter().map(of).collect()
}

fn points() -> impl Strategy<Value = Vec<[f32; 3]>> {
    prop::collection::vec([-3.0..3.0_f32, -3.0..3.0_f32, -3.5..3.0_f32], 3..12)
}

fn faces_of(count: usize) -> Vec<[u32; 3]> {
    let count = count as u32;
    (0..count - 2).map(|first| [first, first + 1, (first + 5) % count]).collect()
}

const SIZE: Size = Size { width: 83, height: 70 };

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn projected_triangles_are_seen_where_their_homogeneous_coordinates_say(
        points in points(), perspective in any::<bool>(),
    ) {
        compare(&projected(&points, perspective), &faces_of(points.len()), SIZE)?;
    }

    #[test]
    fn vertices_that_no_single_projection_made_are_drawn_all_the_same(
        vertices in prop::collection::vec(
            [-3.0..3.0_f32, -3.0..3.0_f32, -2.0..2.0_f32, 0.3..3.0_f32], 3..9),
    ) {
        compare(&vertices, &faces_of(vertices.len()), SIZE)?;
    }
}

#[test]
fn a_window_filling_triangle_covers_all_pixels_right_way_up() {
    let vertices = [[-1.0, -1.0, 0.0, 1.0], [3.0, -1.0, 0.0, 1.0], [-1.0, 3.0, 0.5, 1.0]];
    let compared = compare(&vertices, &[[0, 1, 2]], SIZE).unwrap();
    assert_eq!(compared, (SIZE.width * SIZE.height) as usize);
    let fragments = rasterize(&vertices, &[[0, 1, 2]], SIZE, best()).unwrap();
    // The last corner is the upper one.
    assert!(fragments[0].unwrap().barycentric[2] > 0.49);
}

#[test]
fn of_equal_depths_the_first_triangle_is_seen() {
    let vertices = [[-1.0, -1.0, 0.25, 1.0], [3.0, -1.0, 0.25, 1.0], [-1.0, 3.0, 0.25, 1.0]];
    let fragments = rasterize(&vertices, &[[0, 1, 2], [2, 1, 0]], SIZE, best()).unwrap();
    assert!(fragments.iter().all(|fragment| fragment.unwrap().triangle == 0));
}

#[test]
fn nothing_to_draw_shows_nothing_and_lines_or_huge_numbers_do_no_harm() {
    let none = rasterize(&[], &[], SIZE, best()).unwrap();
    assert!(none.iter().all(Option::is_none));
    let extremes =
        [[0.0; 4], [f32::MAX; 4], [f32::MIN, f32::MAX, 1e-40, -1e-40], [1e30, 1.0, 0.0, 1.0]];
    let faces = [[0, 0, 0], [0, 1, 2], [1, 2, 3], [3, 3, 1]];
    rasterize(&extremes, &faces, SIZE, best()).unwrap();
}
