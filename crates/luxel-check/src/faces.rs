//! Faults of single triangles: no area, duplicates, slivers.

use crate::surface::{RUN, Surface};
use luxel_parallel::{gather, sort_u128};
use luxel_scene::{Mesh, Scene, Sides};

/// A triangle whose height is less than this fraction of its longest edge has no area: its normal depends
/// on the rounding of its corners, about 1e-7 of their coordinates in f32.
const FLAT: f64 = 1e-6;

/// A triangle whose longest edge is at least this many times its height is a sliver.
const SLIVER: f64 = 40.0;

/// A sliver is harmless if the normal of the corner at its longest edge agrees with the edge's there,
/// within this angle. Cylinders consist of slivers whose corners lie at the ends of the longest edge; in
/// flat faces all normals agree.
const SLIVER_TURN_DEGREES: f64 = 15.0;

/// The least distance of the corner from the ends of the longest edge, as a fraction of its length.
const FROM_ENDS: f64 = 0.05;

/// From this proportion on, a triangle is a sliver whatever its normals: a thousand pixels long, it is less
/// than a pixel wide, and its normal depends on the last digits of its corners.
const NEEDLE: f64 = 1000.0;

/// The longest edge's length and the height above it.
fn proportions(surface: &Surface<'_>, triangle: u32) -> (f64, f64) {
    let [a, b, c] = surface.corners(triangle);
    let longest = (b - a).length().max((c - b).length()).max((a - c).length());
    let height = if longest > 0.0 { surface.area_vector(triangle).length() / longest } else { 0.0 };
    (longest, height)
}

/// Triangles without area.
pub(crate) fn degenerate(surface: &Surface<'_>) -> Vec<u32> {
    let is_flat = |triangle: &u32| {
        let (longest, height) = proportions(surface, *triangle);
        height <= FLAT * longest
    };
    filtered(surface, &is_flat)
}

/// Triangles over the same places as an earlier one, except back sides of one-sided triangles; and those
/// back sides, which form a surface of their own.
pub(crate) fn duplicates(
    surface: &Surface<'_>,
    scene: &Scene,
    is_degenerate: &[bool],
) -> (Vec<u32>, Vec<u32>) {
    let sides = sides_of(surface.mesh, scene);
    // The places, then in 32 bits the side and the triangle's index, which is below 2^31.
    let key = |triangle: usize| {
        let mut places = surface.triangles[triangle];
        // Two swaps are a rotation: the parity distinguishes the sides.
        let mut swaps = 0;
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            if places[i] > places[j] {
                places.swap(i, j);
                swaps ^= 1;
            }
        }
        let [a, b, c] = places.map(u128::from);
        a << 96 | b << 64 | c << 32 | swaps << 31 | triangle as u128
    };
    let triangle_of = |key: u128| key as u32 & !(1 << 31);
    let swaps_of = |key: u128| key as u32 >> 31;
    let mut keys = gather(surface.triangles.len(), RUN, &|run, keys| {
        keys.extend(run.filter(|&triangle| !is_degenerate[triangle]).map(key));
    });
    sort_u128(&mut keys);
    let (mut duplicates, mut backs) = (Vec::new(), Vec::new());
    let same = keys.chunk_by(|one, other| one >> 32 == other >> 32);
    for same in same.filter(|same| same.len() > 1) {
        let first = same.iter().map(|&key| triangle_of(key)).min().unwrap_or_default();
        let parity =
            same.iter().find(|&&key| triangle_of(key) == first).map_or(0, |&key| swaps_of(key));
        let mut has_back = false;
        for &key in same.iter().filter(|&&key| triangle_of(key) != first) {
            let triangle = triangle_of(key);
            let is_back = swaps_of(key) != parity && sides[triangle as usize] == Sides::Front;
            if is_back && !has_back {
                has_back = true;
                backs.push(triangle);
            } else {
                duplicates.push(triangle);
            }
        }
    }
    duplicates.sort_unstable();
    backs.sort_unstable();
    (duplicates, backs)
}

/// The visible sides of each triangle.
fn sides_of(mesh: &Mesh, scene: &Scene) -> Vec<Sides> {
    let mut sides = vec![Sides::Both; mesh.triangles.len()];
    for part in &mesh.parts {
        let of_part = scene.materials.get(part.material.index()).map_or(Sides::Both, |m| m.sides);
        let run = part.first as usize..(part.first + part.count) as usize;
        if let Some(run) = sides.get_mut(run) {
            run.fill(of_part);
        }
    }
    sides
}

/// Slivers whose corner's normal disagrees with the longest edge's, and needles.
pub(crate) fn slivers(
    surface: &Surface<'_>,
    normals: &[[luxel_scene::DVec3; 3]],
    is_excluded: &[bool],
) -> Vec<u32> {
    let least_cosine = libm::cos(SLIVER_TURN_DEGREES.to_radians());
    let is_sliver = |triangle: &u32| {
        if is_excluded[*triangle as usize] {
            return false;
        }
        let corners = surface.corners(*triangle);
        let length = |k: usize| corners[k].distance(corners[(k + 1) % 3]);
        let k = (0..3).max_by(|&one, &other| length(one).total_cmp(&length(other))).unwrap_or(0);
        let [from, to, corner] = [k, (k + 1) % 3, (k + 2) % 3];
        let longest = length(k);
        let height = surface.area_vector(*triangle).length() / longest;
        if height * NEEDLE <= longest {
            return true;
        }
        let way = corners[to] - corners[from];
        let t = (corners[corner] - corners[from]).dot(way) / (longest * longest);
        if height * SLIVER > longest || !(FROM_ENDS..=1.0 - FROM_ENDS).contains(&t) {
            return false;
        }
        let normals = &normals[*triangle as usize];
        let within = (normals[from] * (1.0 - t) + normals[to] * t).normalize_or_zero();
        within.dot(normals[corner]) < least_cosine
    };
    filtered(surface, &is_sliver)
}

/// The triangles that satisfy a predicate.
fn filtered(surface: &Surface<'_>, holds: &(impl Fn(&u32) -> bool + Sync)) -> Vec<u32> {
    gather(surface.triangles.len(), RUN, &|run, found| {
        found.extend((run.start as u32..run.end as u32).filter(holds));
    })
}
