//! The order in which triangles are cut into clusters: along a curve that fills space, so that
//! neighbours in the order are neighbours in space, whatever the file's order.

use super::block::CLUSTER_TRIANGLES;
use luxel_math::LANES;
use luxel_parallel::{fill, map};
use luxel_scene::Mesh;
use std::ops::Range;

/// Bits of a cell's coordinate along each axis.
const BITS: u32 = 9;

/// Triangles that one task places. Nothing depends on it.
const TASK_TRIANGLES: usize = 1 << 14;

/// The triangles of a range, by their places in the mesh's list, along a Hilbert curve through the
/// cells of a grid of 512 cells a side; in the file's order within a cell.
pub(crate) fn along_curve(mesh: &Mesh, range: Range<usize>) -> Vec<u32> {
    let triangles = &mesh.triangles[range.clone()];
    let of_tasks = map(triangles.len(), TASK_TRIANGLES, &|task| {
        let centres = triangles[task].iter().map(|corners| centre(mesh, corners));
        centres.fold(EMPTY, |bounds, centre| union(bounds, (centre, centre)))
    });
    let (low, high) = of_tasks.into_iter().fold(EMPTY, union);
    let scale = (1 << BITS) as f32 / longest_side((low, high));
    let mut keys = vec![0; triangles.len()];
    fill(&mut keys, TASK_TRIANGLES, &|start, keys| {
        let triangles = &triangles[start..start + keys.len()];
        place(mesh, triangles, range.start + start, low, scale, keys);
    });
    sort_by_cell(&mut keys);
    keys.into_iter().map(|key| key as u32).collect()
}

/// Runs of a file's order that are looked at.
const SAMPLED_RUNS: usize = 256;
/// How long, in parts of the whole, runs may be for a file's order to keep neighbours together: with
/// three times as long ones, a frame loses more than ordering would have taken.
const LOCAL: f32 = 1.0 / 6.0;

/// Whether triangles that follow one another in a range lie close together, as far as some runs as
/// long as clusters tell.
pub(crate) fn is_local(mesh: &Mesh, range: Range<usize>) -> bool {
    let triangles = &mesh.triangles[range];
    let runs = triangles.len().div_ceil(CLUSTER_TRIANGLES);
    if runs <= 1 {
        return true;
    }
    let mut all = EMPTY;
    let (mut sum, mut count) = (0.0, 0.0);
    for run in triangles.chunks(CLUSTER_TRIANGLES).step_by(runs.div_ceil(SAMPLED_RUNS)) {
        let positions = run.as_flattened().iter().map(|&corner| mesh.positions[corner as usize]);
        let bounds = positions.fold(EMPTY, |bounds, position| union(bounds, (position, position)));
        all = union(all, bounds);
        sum += longest_side(bounds);
        count += 1.0;
    }
    // Comparisons with what is no number are false.
    let whole = longest_side(all);
    whole < f32::INFINITY && sum <= LOCAL * count * whole
}

fn longest_side((low, high): Bounds) -> f32 {
    [0, 1, 2].map(|axis| high[axis] - low[axis]).into_iter().fold(0.0, f32::max)
}

/// Three times the centroid, which does as well.
fn centre(mesh: &Mesh, corners: &[u32; 3]) -> [f32; 3] {
    let [a, b, c] = corners.map(|corner| mesh.positions[corner as usize]);
    [0, 1, 2].map(|axis| a[axis] + b[axis] + c[axis])
}

/// Keys to sort triangles by: the place on the curve above, the number below.
fn place(
    mesh: &Mesh,
    triangles: &[[u32; 3]],
    first: usize,
    low: [f32; 3],
    scale: f32,
    keys: &mut [u64],
) {
    let mut number = first as u64;
    for (triangles, keys) in triangles.chunks(LANES).zip(keys.chunks_mut(LANES)) {
        let mut cells = [[0; LANES]; 3];
        for (lane, corners) in triangles.iter().enumerate() {
            let centre = centre(mesh, corners);
            for axis in 0..3 {
                // What is no number, or infinite, goes to a side.
                let cell = ((centre[axis] - low[axis]) * scale) as u32;
                cells[axis][lane] = cell.min((1 << BITS) - 1);
            }
        }
        for (key, along) in keys.iter_mut().zip(along_hilbert_curve(cells)) {
            *key = u64::from(along) << u32::BITS | number;
            number += 1;
        }
    }
}

/// Sorts by the upper halves, and leaves the order of equal ones: digit by digit from the lowest
/// (Knuth, volume 3, section 5.2.5), four times as fast here as sorting by comparisons.
fn sort_by_cell(keys: &mut Vec<u64>) {
    const DIGITS: u32 = 3;
    const MASK: u64 = (1 << BITS) - 1;
    let mut sorted = vec![0; keys.len()];
    for digit in 0..DIGITS {
        let digit_of = |key: u64| (key >> (u32::BITS + digit * BITS) & MASK) as usize;
        let mut places = [0_usize; 1 << BITS];
        for &key in &*keys {
            places[digit_of(key)] += 1;
        }
        let mut next = 0;
        for place in &mut places {
            (*place, next) = (next, next + *place);
        }
        for &key in &*keys {
            let place = &mut places[digit_of(key)];
            sorted[*place] = key;
            *place += 1;
        }
        std::mem::swap(keys, &mut sorted);
    }
}

type Bounds = ([f32; 3], [f32; 3]);

const EMPTY: Bounds = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);

fn union((low, high): Bounds, (other_low, other_high): Bounds) -> Bounds {
    (
        [0, 1, 2].map(|axis| low[axis].min(other_low[axis])),
        [0, 1, 2].map(|axis| high[axis].max(other_high[axis])),
    )
}

/// How far along a Hilbert curve cells of the grid lie (Skilling 2004, "Programming the Hilbert
/// curve"). Without branches and sixteen at a time, for the compiler to make vectors of.
fn along_hilbert_curve([mut x, mut y, mut z]: [[u32; LANES]; 3]) -> [u32; LANES] {
    // From the cells' coordinates to the curve's digits, transposed.
    for bit in (1..BITS).rev() {
        let below = (1 << bit) - 1;
        for lane in 0..LANES {
            x[lane] ^= below & (x[lane] >> bit & 1).wrapping_neg();
        }
        for other in [&mut y, &mut z] {
            for lane in 0..LANES {
                let is_set = (other[lane] >> bit & 1).wrapping_neg();
                let swapped = (x[lane] ^ other[lane]) & below & !is_set;
                x[lane] ^= swapped | below & is_set;
                other[lane] ^= swapped;
            }
        }
    }
    let mut along = [0; LANES];
    for lane in 0..LANES {
        // Gray code.
        y[lane] ^= x[lane];
        z[lane] ^= y[lane];
        let mut flips = 0;
        for bit in 1..BITS {
            flips ^= ((1 << bit) - 1) & (z[lane] >> bit & 1).wrapping_neg();
        }
        let [x, y, z] = [x, y, z].map(|axis| spread(axis[lane] ^ flips));
        along[lane] = x << 2 | y << 1 | z;
    }
    along
}

/// The lowest ten bits with two zeros between each.
fn spread(bits: u32) -> u32 {
    let bits = (bits | bits << 16) & 0x0300_00ff;
    let bits = (bits | bits << 8) & 0x0300_f00f;
    let bits = (bits | bits << 4) & 0x030c_30c3;
    (bits | bits << 2) & 0x0924_9249
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_scene::primitives;

    #[test]
    fn cells_along_the_curve_share_a_face() {
        // The first 32^3 cells of the curve fill a cube of 32 cells a side.
        let mut cells = Vec::new();
        for x in 0..32 {
            for y in 0..32 {
                for z in 0..32 {
                    let [along, ..] = along_hilbert_curve([x, y, z].map(|at| [at; LANES]));
                    cells.push((along, [x, y, z]));
                }
            }
        }
        cells.sort_unstable();
        for (place, pair) in cells.windows(2).enumerate() {
            let [(at, [x, y, z]), (next, [u, v, w])] = [pair[0], pair[1]];
            assert_eq!((at, next), (place as u32, place as u32 + 1), "a cell is left out");
            let steps = x.abs_diff(u) + y.abs_diff(v) + z.abs_diff(w);
            assert_eq!(steps, 1, "from {:?} to {:?}", [x, y, z], [u, v, w]);
        }
    }

    #[test]
    fn every_triangle_of_the_range_is_there_once() {
        let mesh = primitives::icosphere(1.0, 12);
        let mut order = along_curve(&mesh, 100..500);
        order.sort_unstable();
        assert_eq!(order, (100..500).collect::<Vec<u32>>());
    }

    #[test]
    fn long_rows_keep_neighbours_together_and_a_shuffled_file_does_not() {
        let mut mesh = primitives::plane(glam::DVec2::new(6.0, 2.0), 1000, 50);
        let count = mesh.triangles.len();
        assert!(is_local(&mesh, 0..count));
        // A stride that shares no factor with the count.
        let shuffled = (0..count).map(|at| mesh.triangles[at * 7919 % count]).collect();
        mesh.triangles = shuffled;
        assert!(!is_local(&mesh, 0..count));
        mesh.positions[5] = [f32::NAN; 3];
        mesh.positions[9] = [f32::INFINITY; 3];
        assert!(!is_local(&mesh, 0..count));
    }

    #[test]
    fn what_is_no_number_is_ordered_all_the_same() {
        let mut mesh = primitives::icosphere(1.0, 4);
        mesh.positions[3] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
        mesh.positions[7] = [3e38, 3e38, -3e38];
        let count = mesh.triangles.len();
        assert_eq!(along_curve(&mesh, 0..count).len(), count);
    }
}
