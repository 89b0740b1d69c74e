use super::*;
use proptest::prelude::*;

fn cut(corners: &[[f64; 3]]) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    triangulate(corners, &mut triangles);
    triangles
}

fn area(corners: &[[f64; 3]]) -> f64 {
    let [x, y, z] = newell_normal(corners);
    (x * x + y * y + z * z).sqrt() / 2.0
}

/// Area of each triangle, signed by the polygon's orientation.
fn signed_areas(corners: &[[f64; 3]], triangles: &[[u32; 3]]) -> Vec<f64> {
    let normal = newell_normal(corners);
    let length = area(corners) * 2.0;
    let of = |triangle: &[u32; 3]| {
        let own = newell_normal(&triangle.map(|corner| corners[corner as usize]));
        (0..3).map(|axis| own[axis] * normal[axis]).sum::<f64>() / length / 2.0
    };
    triangles.iter().map(of).collect()
}

/// Triangles that are all the polygon's way round and whose areas sum up to the polygon's can
/// neither overlap nor leave gaps.
fn assert_tiles(corners: &[[f64; 3]], triangles: &[[u32; 3]]) {
    assert_eq!(triangles.len(), corners.len() - 2);
    let whole = area(corners);
    let areas = signed_areas(corners, triangles);
    let lowest = areas.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(lowest >= -1e-12 * whole, "a triangle is turned over: {lowest}");
    let sum: f64 = areas.iter().sum();
    assert!((sum - whole).abs() <= 1e-9 * whole, "{sum} of {whole}");
}

fn flat_polygon(points: &[[f64; 2]]) -> Vec<[f64; 3]> {
    points.iter().map(|&[x, y]| [x, y, 0.0]).collect()
}

/// A polygon of the plane, put somewhere in space.
fn tilted(points: &[[f64; 2]]) -> Vec<[f64; 3]> {
    let place =
        |&[x, y]: &[f64; 2]| [0.25 * x - 0.5 * y + 3.0, 0.75 * x + 0.5 * y, x - 0.125 * y - 7.0];
    points.iter().map(place).collect()
}

#[test]
fn convex_polygons_are_fans_from_the_first_corner() {
    let square = flat_polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    assert_eq!(cut(&square), [[0, 1, 2], [0, 2, 3]]);
    let hexagon: Vec<_> = (0..6)
        .map(|corner| f64::from(corner) * std::f64::consts::FRAC_PI_3)
        .map(|angle| [libm::cos(angle), libm::sin(angle)])
        .collect();
    assert_eq!(cut(&tilted(&hexagon)), [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]);
}

#[test]
fn concave_quads_are_cut_at_the_reflex_corner_wherever_it_is() {
    let mut dart = vec![[0.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 4.0]];
    for _ in 0..4 {
        assert_tiles(&tilted(&dart), &cut(&tilted(&dart)));
        let mirrored: Vec<_> = dart.iter().rev().copied().collect();
        assert_tiles(&flat_polygon(&mirrored), &cut(&flat_polygon(&mirrored)));
        dart.rotate_left(1);
    }
}

#[test]
fn corners_on_straight_edges_do_not_make_triangles_without_area() {
    let square = [
        [0.0, 0.0],
        [1.0, 0.0],
        [2.0, 0.0],
        [2.0, 1.0],
        [2.0, 2.0],
        [1.0, 2.0],
        [0.0, 2.0],
        [0.0, 1.0],
    ];
    let square = flat_polygon(&square);
    let triangles = cut(&square);
    assert_tiles(&square, &triangles);
    assert!(signed_areas(&square, &triangles).iter().all(|&area| area > 0.0));
}

#[test]
fn a_hole_joined_by_a_bridge_stays_a_hole() {
    // The outline, then over the bridge round the hole and back: two places are named twice.
    let outline = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let hole = [[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0]];
    for outer in 0..4 {
        let mut polygon: Vec<_> = (0..5).map(|step| outline[(outer + step) % 4]).collect();
        polygon.extend((0..5).map(|step| hole[([0, 3, 2, 1][outer] + step) % 4]));
        for _ in 0..polygon.len() {
            let corners = tilted(&polygon);
            assert_tiles(&corners, &cut(&corners));
            polygon.rotate_left(1);
        }
    }
}

#[test]
fn two_holes_at_one_corner_of_the_outline_stay_holes() {
    let mut polygon = vec![
        [0.0, 0.0],
        [9.0, 0.0],
        [9.0, 9.0],
        [0.0, 9.0],
        [0.0, 0.0],
        [2.0, 6.0],
        [3.0, 8.0],
        [4.0, 6.0],
        [2.0, 6.0],
        [0.0, 0.0],
        [6.0, 2.0],
        [6.0, 4.0],
        [8.0, 2.0],
        [6.0, 2.0],
    ];
    for _ in 0..polygon.len() {
        assert_tiles(&flat_polygon(&polygon), &cut(&flat_polygon(&polygon)));
        polygon.rotate_left(1);
    }
}

#[test]
fn repeated_corners_and_spikes_are_cut_away() {
    let polygon = [
        [0.0, 0.0],
        [0.0, 0.0],
        [2.0, 0.0],
        [5.0, 0.0],
        [2.0, 0.0],
        [2.0, 2.0],
        [2.0, 2.0],
        [2.0, 2.0],
        [0.0, 2.0],
    ];
    assert_tiles(&flat_polygon(&polygon), &cut(&flat_polygon(&polygon)));
}

#[test]
fn polygons_without_an_answer_still_give_their_count() {
    let bow_tie = flat_polygon(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]);
    assert_eq!(cut(&bow_tie).len(), 2);
    assert_eq!(cut(&[[1.0, 2.0, 3.0]; 7]).len(), 5);
    assert_eq!(cut(&[[f64::NAN, 0.0, 0.0]; 5]).len(), 3);
    assert_eq!(cut(&[[f64::MAX, 0.0, 0.0], [0.0; 3], [0.0, f64::MIN, 1.0], [1.0; 3]]).len(), 2);
    assert_eq!(cut(&[[0.0; 3]; 2]).len(), 0);
    assert_eq!(cut(&[]).len(), 0);
}

#[test]
fn a_pentagram_with_many_rounds_ends_soon() {
    let star: Vec<_> = (0..20_001)
        .map(|corner| f64::from(corner) * 2.0 * std::f64::consts::PI * 7_000.0 / 20_001.0)
        .map(|angle| [libm::cos(angle), libm::sin(angle)])
        .collect();
    let start = std::time::Instant::now();
    assert_eq!(cut(&flat_polygon(&star)).len(), 19_999);
    assert!(start.elapsed().as_secs() < 20);
}

#[test]
fn combs_and_spirals_of_many_corners_are_tiled_quickly() {
    let mut comb = vec![];
    for tooth in 0..20_000 {
        let x = f64::from(tooth);
        comb.extend([[x, 0.0], [x + 0.5, 100.0]]);
    }
    comb.extend([[20_000.0, -1.0], [0.0, -1.0]]);
    comb.reverse();
    let mut spiral = vec![];
    for step in 0..10_000 {
        let angle = f64::from(step) * 0.01;
        spiral.push([angle * libm::cos(angle), angle * libm::sin(angle)]);
    }
    for step in (0..10_000).rev() {
        let angle = f64::from(step) * 0.01;
        let radius = angle + 1.0;
        spiral.push([radius * libm::cos(angle), radius * libm::sin(angle)]);
    }
    for polygon in [comb, spiral] {
        let corners = tilted(&polygon);
        let start = std::time::Instant::now();
        let triangles = cut(&corners);
        assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
        assert_tiles(&corners, &triangles);
    }
}

#[test]
fn outlines_that_cross_themselves_end_with_their_count_of_triangles() {
    let mut state = 1_u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / f64::from(1_u32 << 31)
    };
    for count in [4, 5, 7, 50, 460, 500, 3_000, 100_000] {
        for _ in 0..(500 / count).max(1) {
            let corners: Vec<_> = (0..count).map(|_| [random(), random(), random()]).collect();
            assert_eq!(cut(&corners).len(), count - 2, "{count} corners");
        }
    }
    // Forth and back along a line, with a little area: hardly an ear is convex.
    let folded: Vec<_> = (0..20_000)
        .map(|corner| [f64::from(corner * 7_919 % 20_000), f64::from(corner % 2)])
        .collect();
    assert_eq!(cut(&flat_polygon(&folded)).len(), 19_998);
}

proptest! {
    #[test]
    fn star_shaped_polygons_are_tiled(radii in prop::collection::vec(0.05_f64..10.0, 3..60)) {
        let step = 2.0 * std::f64::consts::PI / radii.len() as f64;
        let polygon: Vec<_> = radii
            .iter()
            .enumerate()
            .map(|(corner, radius)| (radius, corner as f64 * step))
            .map(|(radius, angle)| [radius * libm::cos(angle), radius * libm::sin(angle)])
            .collect();
        let corners = tilted(&polygon);
        assert_tiles(&corners, &cut(&corners));
    }

    #[test]
    fn outlines_along_a_grid_are_tiled(heights in prop::collection::vec((1_u8..5, 1_u8..4), 1..30)) {
        // Steps up and down, with corners on straight edges wherever two heights are equal.
        let mut polygon = vec![];
        let mut x = 0.0;
        for (height, width) in heights {
            polygon.push([x, f64::from(height)]);
            x += f64::from(width);
            polygon.push([x, f64::from(height)]);
        }
        polygon.extend([[x, 0.0], [0.0, 0.0]]);
        assert_tiles(&flat_polygon(&polygon), &cut(&flat_polygon(&polygon)));
        polygon.reverse();
        assert_tiles(&flat_polygon(&polygon), &cut(&flat_polygon(&polygon)));
    }

    #[test]
    fn any_corners_give_their_count(
        corners in prop::collection::vec(prop::array::uniform3(-3_i8..3), 3..30),
    ) {
        let corners: Vec<_> = corners.iter().map(|corner| corner.map(f64::from)).collect();
        let triangles = cut(&corners);
        prop_assert_eq!(triangles.len(), corners.len() - 2);
        for triangle in triangles {
            prop_assert!(triangle.iter().all(|&corner| (corner as usize) < corners.len()));
            // Every triangle is the polygon's way round as far as its corners are numbered.
            let turns = (0..3).filter(|&at| triangle[at] > triangle[(at + 1) % 3]).count();
            prop_assert_eq!(turns, 1);
        }
    }
}
