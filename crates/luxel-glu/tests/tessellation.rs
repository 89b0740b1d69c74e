//! Tessellated polygons beside winding numbers that are counted point by point (GLU 1.3, chapter 5).

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_glu::{Listener, Tessellator};
use proptest::prelude::*;

const WINDING_RULE: u32 = 100_140;
const BOUNDARY_ONLY: u32 = 100_141;

/// Takes down all that a tessellator says. Handles are places in `positions`.
#[derive(Default)]
struct Notes {
    positions: Vec<[f64; 3]>,
    primitives: Vec<(u32, Vec<usize>)>,
    flags: Vec<bool>,
    flag: bool,
    errors: Vec<u32>,
    flags_wanted: bool,
    combines: bool,
    combined: usize,
}

impl Listener for Notes {
    fn begin(&mut self, mode: u32) {
        self.primitives.push((mode, Vec::new()));
    }

    fn edge_flag(&mut self, is_outline: bool) {
        self.flag = is_outline;
    }

    fn wants_edge_flags(&self) -> bool {
        self.flags_wanted
    }

    fn vertex(&mut self, handle: usize) {
        self.primitives.last_mut().unwrap().1.push(handle);
        self.flags.push(self.flag);
    }

    fn end(&mut self) {}

    fn error(&mut self, error: u32) {
        self.errors.push(error);
    }

    fn combine(
        &mut self,
        coordinates: [f64; 3],
        _: [usize; 4],
        weights: [f32; 4],
    ) -> Option<usize> {
        assert!(
            (weights.iter().sum::<f32>() - 1.0).abs() < 1e-5,
            "weights {weights:?} add up to 1"
        );
        self.combined += 1;
        self.positions.push(coordinates);
        self.combines.then(|| self.positions.len() - 1)
    }
}

type Contours = Vec<Vec<[f64; 2]>>;

fn tessellate(contours: &Contours, rule: u32, boundary_only: bool) -> Notes {
    let mut notes = Notes { flags_wanted: true, combines: true, ..Notes::default() };
    let mut tessellator = Tessellator::default();
    tessellator.set_property(WINDING_RULE, f64::from(rule), &mut notes);
    tessellator.set_property(BOUNDARY_ONLY, f64::from(u8::from(boundary_only)), &mut notes);
    tessellator.set_normal([0.0, 0.0, 1.0]);
    tessellator.begin_polygon(&mut notes);
    for contour in contours {
        tessellator.begin_contour(&mut notes);
        for &[x, y] in contour {
            notes.positions.push([x, y, 0.0]);
            let handle = notes.positions.len() - 1;
            tessellator.vertex([x, y, 0.0], handle, &mut notes);
        }
        tessellator.end_contour(&mut notes);
    }
    tessellator.end_polygon(&mut notes);
    notes
}

/// How often contours wind about a point: upward edges to its right, less downward ones.
fn winding(contours: &Contours, [px, py]: [f64; 2]) -> i32 {
    let mut sum = 0;
    for contour in contours {
        for (at, a) in contour.iter().enumerate() {
            let b = contour[(at + 1) % contour.len()];
            let side = (b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0]);
            if a[1] <= py && b[1] > py && side > 0.0 {
                sum += 1;
            } else if a[1] > py && b[1] <= py && side < 0.0 {
                sum -= 1;
            }
        }
    }
    sum
}

fn is_inside(winding: i32, rule: u32) -> bool {
    match rule {
        100_130 => winding % 2 != 0,
        100_131 => winding != 0,
        100_132 => winding > 0,
        100_133 => winding < 0,
        _ => winding.abs() >= 2,
    }
}

fn area(p: [[f64; 3]; 3]) -> f64 {
    ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0])) / 2.0
}

/// How far a point is from the nearest edge of the contours.
fn distance_to_edges(contours: &Contours, p: [f64; 2]) -> f64 {
    let mut least = f64::INFINITY;
    for contour in contours {
        for (at, a) in contour.iter().enumerate() {
            let b = contour[(at + 1) % contour.len()];
            let (d, v) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
            let length = d[0] * d[0] + d[1] * d[1];
            let along = if length > 0.0 {
                ((v[0] * d[0] + v[1] * d[1]) / length).clamp(0.0, 1.0)
            } else {
                0.0
            };
            least = least.min((v[0] - along * d[0]).hypot(v[1] - along * d[1]));
        }
    }
    least
}

/// Checks coverage at the points of a lattice, in triangles and in outlines.
fn check(contours: &Contours, size: f64) {
    for rule in 100_130..=100_134 {
        let notes = tessellate(contours, rule, false);
        assert_eq!(notes.errors, []);
        let corner = |handle: usize| notes.positions[handle];
        let triangles: Vec<[[f64; 3]; 3]> = notes
            .primitives
            .iter()
            .flat_map(|(mode, handles)| {
                assert_eq!(*mode, 4);
                assert_eq!(handles.len() % 3, 0);
                handles
                    .chunks(3)
                    .map(|t| [corner(t[0]), corner(t[1]), corner(t[2])])
                    .collect::<Vec<_>>()
            })
            .collect();
        for triangle in &triangles {
            assert!(
                area(*triangle) > -1e-6 * size * size,
                "triangles are counter-clockwise: {triangle:?}"
            );
        }
        let outlines = tessellate(contours, rule, true);
        let loops: Contours = outlines
            .primitives
            .iter()
            .map(|(mode, handles)| {
                assert_eq!(*mode, 2);
                handles
                    .iter()
                    .map(|&at| [outlines.positions[at][0], outlines.positions[at][1]])
                    .collect()
            })
            .collect();
        for i in 0..24 {
            for j in 0..24 {
                // Off all whole numbers.
                let p =
                    [size * (f64::from(i) + 0.337) / 24.0, size * (f64::from(j) + 0.411) / 24.0];
                if distance_to_edges(contours, p) < 1e-4 * size {
                    continue;
                }
                let inside = is_inside(winding(contours, p), rule);
                let covers = |t: &&[[f64; 3]; 3]| {
                    let q = [p[0], p[1], 0.0];
                    area([t[0], t[1], q]) > 0.0
                        && area([t[1], t[2], q]) > 0.0
                        && area([t[2], t[0], q]) > 0.0
                };
                let covering = triangles.iter().filter(covers).count();
                assert_eq!(covering, usize::from(inside), "rule {rule}, at {p:?}, of {contours:?}");
                assert_eq!(
                    winding(&loops, p),
                    i32::from(inside),
                    "outline, rule {rule}, at {p:?}, of {contours:?}"
                );
            }
        }
    }
}

#[test]
fn a_square_is_two_triangles_whose_diagonal_is_no_outline() {
    let square = vec![vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]];
    let notes = tessellate(&square, 100_130, false);
    assert_eq!(notes.primitives.len(), 1);
    assert_eq!(notes.primitives[0].1.len(), 6);
    assert_eq!(notes.flags.iter().filter(|flag| !**flag).count(), 2);
    assert_eq!(notes.combined, 0);
    check(&square, 1.0);
}

#[test]
fn holes_are_cut_out_and_islands_in_them_kept() {
    let ring = |low: f64, high: f64| vec![[low, low], [high, low], [high, high], [low, high]];
    check(&vec![ring(0.0, 9.0), ring(1.0, 8.0), ring(2.0, 7.0), ring(4.0, 5.0)], 9.0);
    let mut hole = ring(2.0, 7.0);
    hole.reverse();
    check(&vec![ring(0.0, 9.0), hole], 9.0);
}

#[test]
fn squares_of_any_size_are_two_triangles() {
    for size in [1e-305, 1e-300, 1e-150, 1e149] {
        let square = vec![vec![[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]]];
        let notes = tessellate(&square, 100_130, false);
        assert_eq!(notes.errors, []);
        let corners: usize = notes.primitives.iter().map(|(_, handles)| handles.len()).sum();
        assert_eq!(corners, 6, "of a square of side {size}");
    }
}

#[test]
fn a_pentagram_is_wound_twice_in_the_middle() {
    let star: Vec<[f64; 2]> = (0..5)
        .map(|i| {
            let angle = f64::from(2 * i) * 72.0f64.to_radians();
            [5.0 + 4.9 * libm_sin(angle), 5.0 + 4.9 * libm_sin(angle + 90.0f64.to_radians())]
        })
        .collect();
    check(&vec![star.clone()], 10.0);
    let notes = tessellate(&vec![star], 100_134, false);
    // The pentagon in the middle: five new vertices, three triangles.
    assert_eq!((notes.combined, notes.primitives[0].1.len()), (5, 9));
}

/// The Taylor series; the platform's sine is banned, and here any will do.
fn libm_sin(x: f64) -> f64 {
    let (mut term, mut sum) = (x, x);
    for n in 1..30 {
        term *= -x * x / f64::from(2 * n * (2 * n + 1));
        sum += term;
    }
    sum
}

#[test]
fn edges_on_edges_and_vertices_on_vertices_are_joined() {
    // Two squares with a common side, a third on half of theirs, a spike, a vertex that comes twice.
    check(
        &vec![
            vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]],
            vec![[4.0, 0.0], [8.0, 0.0], [8.0, 4.0], [4.0, 4.0]],
            vec![[2.0, 4.0], [6.0, 4.0], [6.0, 8.0], [2.0, 8.0]],
            vec![[1.0, 5.0], [1.0, 8.0], [1.0, 5.0], [1.0, 5.0]],
        ],
        8.0,
    );
    // The same square twice, and against itself.
    let square = vec![[1.0, 1.0], [7.0, 1.0], [7.0, 7.0], [1.0, 7.0]];
    let mut reversed = square.clone();
    reversed.reverse();
    check(&vec![square.clone(), square.clone()], 8.0);
    check(&vec![square, reversed], 8.0);
}

#[test]
fn crossings_without_a_combine_callback_are_an_error() {
    let mut notes = Notes::default();
    let mut tessellator = Tessellator::default();
    tessellator.begin_polygon(&mut notes);
    tessellator.begin_contour(&mut notes);
    for (at, [x, y]) in [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]].into_iter().enumerate() {
        tessellator.vertex([x, y, 0.0], at, &mut notes);
    }
    tessellator.end_contour(&mut notes);
    tessellator.end_polygon(&mut notes);
    assert_eq!((notes.errors, notes.primitives.len()), (vec![100_156], 0));
}

#[test]
fn calls_out_of_order_are_errors_and_are_mended() {
    let mut notes = Notes::default();
    let mut tessellator = Tessellator::default();
    tessellator.vertex([0.0; 3], 0, &mut notes);
    tessellator.end_polygon(&mut notes);
    tessellator.begin_contour(&mut notes);
    tessellator.begin_polygon(&mut notes);
    assert_eq!(notes.errors, [100_151, 100_152, 100_154, 100_151, 100_154, 100_153]);
    let mut notes = Notes::default();
    tessellator.set_property(WINDING_RULE, 7.0, &mut notes);
    tessellator.set_property(100_142, 1.5, &mut notes);
    tessellator.set_property(5, 0.0, &mut notes);
    assert_eq!(tessellator.property(5, &mut notes), None);
    assert_eq!(notes.errors, [100_901, 100_901, 100_900, 100_900]);
}

#[test]
fn coordinates_that_are_not_numbers_are_errors_and_end() {
    let mut notes = Notes { combines: true, ..Notes::default() };
    let mut tessellator = Tessellator::default();
    tessellator.begin_polygon(&mut notes);
    tessellator.begin_contour(&mut notes);
    for x in [f64::NAN, f64::INFINITY, -1e200, 1e-320, 3.0, 0.0] {
        tessellator.vertex([x, 1.0 - x, x * x], 0, &mut notes);
    }
    tessellator.end_contour(&mut notes);
    tessellator.end_polygon(&mut notes);
    assert!(notes.errors.contains(&100_155));
}

#[test]
fn the_normal_is_found_so_that_areas_are_positive() {
    for (axis, turned) in [(0, false), (1, false), (2, false), (0, true), (1, true), (2, true)] {
        let mut notes = Notes { combines: true, ..Notes::default() };
        let mut tessellator = Tessellator::default();
        tessellator.begin_polygon(&mut notes);
        tessellator.begin_contour(&mut notes);
        let mut corners =
            vec![[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]];
        if turned {
            corners.reverse();
        }
        let place = |[u, v]: [f64; 2]| {
            let mut p = [7.0; 3];
            p[(axis + 1) % 3] = u;
            p[(axis + 2) % 3] = v;
            p
        };
        for corner in corners {
            notes.positions.push(place(corner));
            let handle = notes.positions.len() - 1;
            tessellator.vertex(place(corner), handle, &mut notes);
        }
        tessellator.end_contour(&mut notes);
        tessellator.end_polygon(&mut notes);
        let handles = &notes.primitives[0].1;
        let mut sum = 0.0;
        for t in handles.chunks(3) {
            let corner = |at: usize| {
                let p = notes.positions[t[at]];
                [p[(axis + 1) % 3], p[(axis + 2) % 3], 0.0]
            };
            let part = area([corner(0), corner(1), corner(2)]);
            assert_eq!(part > 0.0, !turned, "axis {axis}");
            sum += part;
        }
        assert_eq!(sum.abs(), 7.0);
    }
}

fn contours(most: i32) -> impl Strategy<Value = Contours> {
    let coordinate = (0..=most).prop_map(f64::from);
    let vertex = [coordinate.clone(), coordinate];
    prop::collection::vec(prop::collection::vec(vertex, 0..9), 1..4)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    // Few positions, so that vertices, edges and crossings coincide often.
    #[test]
    fn coarse_polygons_cover_what_their_rule_says(contours in contours(6)) {
        check(&contours, 6.0);
    }

    #[test]
    fn fine_polygons_cover_what_their_rule_says(contours in contours(100_003)) {
        check(&contours, 100_003.0);
    }
}
