//! Triangles that share edges: every sample of their union once, nothing outside of it.

use crate::random::cases;
use crate::scene::{Corner, Picture, Scene, best, no_holes};
use luxel_visibility::{Coverage, CullFaces, PartUse};
use proptest::prelude::*;

const BLENDED: PartUse = PartUse { cull: CullFaces::None, coverage: Coverage::Blended };

/// Whether a polygon holds a sample moved a little to the right and far less down: an odd number of
/// edges cross the row beyond it.
fn polygon_holds(outline: &[[i32; 2]], [x, y]: [i32; 2]) -> bool {
    let after = |corner: usize| outline[(corner + 1) % outline.len()];
    let crosses_beyond = |&corner: &usize| {
        let ([px, py], [qx, qy]) = (outline[corner], after(corner));
        if (py <= y) == (qy <= y) {
            return false;
        }
        let [px, py, qx, qy, x, y] = [px, py, qx, qy, x, y].map(i64::from);
        let rise = qy - py;
        // px + (y - py) (qx - px) / rise > x
        ((y - py) * (qx - px) - (x - px) * rise) * rise.signum() > 0
    };
    (0..outline.len()).filter(crosses_beyond).count() % 2 == 1
}

/// Draws triangles as blended layers of one depth: a sample in two of them has two layers.
fn check(
    outline: &[[i32; 2]],
    triangles: &[[[i32; 2]; 3]],
    samples: u32,
) -> Result<(), TestCaseError> {
    let corners: Vec<_> =
        triangles.iter().map(|t| t.map(|[x, y]| Corner { x, y, z: 512 })).collect();
    let scene = Scene::of([80, 72], samples, &corners, BLENDED);
    let built = scene.build();
    let layers = Picture::layers(&built.frame(best()), best(), &no_holes);
    prop_assert!(layers.len() <= 1, "a sample lies in {} triangles", layers.len());
    for (number, position) in scene.sample_positions() {
        let covered = layers.first().is_some_and(|layer| layer.seen[number].is_some());
        prop_assert_eq!(covered, polygon_holds(outline, position), "at {:?}", position);
    }
    Ok(())
}

/// Corners around a middle, at growing angles: a star-shaped polygon, and its middle.
fn star() -> impl Strategy<Value = ([i32; 2], Vec<[i32; 2]>)> {
    let directions: Vec<[i32; 2]> = (0..32)
        .map(|step| {
            let angle = f64::from(step) * std::f64::consts::TAU / 32.0;
            [libm::cos(angle), libm::sin(angle)].map(|value| (value * 1024.0) as i32)
        })
        .collect();
    let middle = prop_oneof![
        (30..50, 30..42).prop_map(|(x, y)| [x * 256 + 128, y * 256 + 128]),
        (7000..13000, 7000..11000).prop_map(|(x, y)| [x, y]),
    ];
    (middle, prop::collection::vec((1..4_usize, 20..11_000_i32), 11..32)).prop_map(
        move |(middle, spokes)| {
            let mut step = 0;
            let mut outline = Vec::new();
            for (turn, length) in spokes {
                // On pixel centres where that is possible.
                let raw: [i32; 2] =
                    std::array::from_fn(|axis| directions[step % 32][axis] * length / 1024);
                let whole = raw.map(|value| value / 256 * 256);
                let [dx, dy] = if length % 2 == 0 && whole != [0, 0] { whole } else { raw };
                outline.push([middle[0] + dx, middle[1] + dy]);
                step += turn;
                if step >= 32 {
                    break;
                }
            }
            (middle, outline)
        },
    )
}

proptest! {
    #![proptest_config(cases(150))]

    #[test]
    fn a_grid_of_moved_corners_covers_its_rectangle_once(
        moves in prop::collection::vec((-5_i32..=5, -5_i32..=5, any::<bool>()), 49),
        samples in prop::sample::select(vec![1, 2, 4, 8]),
    ) {
        // Squares of 10 pixels whose corners move by less than a quarter of it, so that they stay convex: in steps of
        // three eighths of a pixel, or to pixel centres.
        let corner = |column: i32, row: i32| {
            let at = [column, row].map(|number| number * 2560 + 640);
            let inner = (1..7).contains(&column) && (1..6).contains(&row);
            if !inner {
                return at;
            }
            let (dx, dy, on_centre) = moves[(row * 7 + column) as usize];
            [at[0] + dx * 96, at[1] + dy * 96]
                .map(|value| if on_centre { value / 256 * 256 + 128 } else { value })
        };
        let mut triangles = Vec::new();
        for row in 0..6 {
            for column in 0..7 {
                let (a, b) = (corner(column, row), corner(column + 1, row));
                let (c, d) = (corner(column, row + 1), corner(column + 1, row + 1));
                // Either diagonal, and either way round.
                match moves[(row * 7 + column) as usize].0 & 3 {
                    0 => triangles.extend([[a, b, d], [a, d, c]]),
                    1 => triangles.extend([[d, a, b], [d, a, c]]),
                    2 => triangles.extend([[a, b, c], [b, c, d]]),
                    _ => triangles.extend([[c, a, b], [d, b, c]]),
                }
            }
        }
        let outline = [corner(0, 0), corner(7, 0), corner(7, 6), corner(0, 6)];
        check(&outline, &triangles, samples)?;
    }

    #[test]
    fn a_polygon_cut_into_ears_is_covered_once((_, outline) in star(), samples in 1..3_u32) {
        let corners: Vec<_> = outline.iter().map(|&[x, y]| [f64::from(x), f64::from(y), 0.0]).collect();
        let mut triangles = Vec::new();
        luxel_scene::triangulate(&corners, &mut triangles);
        let triangles: Vec<_> =
            triangles.iter().map(|t| t.map(|corner| outline[corner as usize])).collect();
        // Only where the star is a simple polygon that the cut respects.
        let area = |p: [i32; 2], q: [i32; 2], r: [i32; 2]| crate::oracle::doubled_area(p, q, r);
        let sum: i128 = triangles.iter().map(|&[a, b, c]| area(a, b, c).abs()).sum();
        let whole: i128 = (1..outline.len() - 1)
            .map(|last| area(outline[0], outline[last], outline[last + 1]))
            .sum();
        prop_assume!(sum == whole.abs());
        check(&outline, &triangles, samples)?;
    }

    #[test]
    fn a_fan_about_a_point_covers_its_outline_once((middle, outline) in star(), samples in 1..3_u32) {
        let count = outline.len();
        let fan: Vec<_> =
            (0..count).map(|i| [middle, outline[i], outline[(i + 1) % count]]).collect();
        prop_assume!(fan.iter().all(|&[a, b, c]| crate::oracle::doubled_area(a, b, c) > 0));
        check(&outline, &fan, samples)?;
    }
}
