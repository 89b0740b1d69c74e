//! The triangle test, watertight (Woop, Benthin and Wald 2013).
//!
//! Corners are taken relative to the ray's origin and sheared so that the ray runs along the axis of
//! its largest component; what remains is whether the origin lies inside a triangle of the plane. An
//! edge function in `f32` never has the wrong sign, but it can round to 0: then, and only then, it is
//! computed again in `f64`, where products are exact and so is the sign of their difference.
//! Triangles that share an edge therefore agree on which side of it a ray passes, and no ray passes
//! through a closed mesh. Moeller and Trumbore's test needs no shear, but leaks at shared edges.
//!
//! A ray exactly through an edge or a corner hits all triangles there. The distance is then computed
//! from the edge alone, whichever triangle it belongs to, so that all hits have the same distance
//! and the lowest triangle number wins.

use super::lane_rows::{Row, ShearedRows, lane, load, width};
use super::sheared::{ShearedRay, edge_functions};
use crate::ray::axis_order;
use crate::tree::{Block, Gathered, VertexRows, WIDTH, gather, gather_corner, load_row};
use luxel_math::{LANES, Simd, f32x8, mask32x8, permuted, prelude::*};

/// The distance at which a ray through an edge or corner hits a triangle, computed in `f64`; `None`
/// for a miss.
fn on_edge(corners: [[f32; 3]; 3]) -> Option<f32> {
    let weights = edge_functions(&corners);
    let negative = weights.iter().any(|weight| *weight < 0.0);
    let positive = weights.iter().any(|weight| *weight > 0.0);
    let sum = weights[0] + weights[1] + weights[2];
    if negative && positive || sum == 0.0 {
        return None;
    }
    let corners = corners.map(|corner| corner.map(f64::from));
    let mut zeros = (0..3).filter(|&corner| weights[corner] == 0.0);
    let t = match (zeros.next(), zeros.next()) {
        // Through a corner: the one whose weight is left.
        (Some(i), Some(j)) => corners[3 - i - j][2],
        // Through an edge, taken the same way round whichever triangle it belongs to.
        (Some(opposite), None) => {
            let [mut p, mut q] = [corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]];
            if p > q {
                (p, q) = (q, p);
            }
            let axis = usize::from((q[1] - p[1]).abs() > (q[0] - p[0]).abs());
            p[2] + (q[2] - p[2]) * (-p[axis] / (q[axis] - p[axis]))
        }
        _ => {
            let [u, v, w] = weights;
            (u * corners[0][2] + v * corners[1][2] + w * corners[2][2]) / sum
        }
    };
    Some(t as f32)
}

/// Repeats the test with [`on_edge`] for the lanes whose bit is set in `uncertain`; returns all hits.
/// `corners` yields a lane's corners in the frame of its ray.
#[inline(always)]
fn on_edges(
    corners: impl Fn(usize) -> [[f32; 3]; 3],
    range: impl Fn(usize) -> [f32; 2],
    is_negative: bool,
    mut uncertain: u32,
    distances: &mut [f32],
    mut hits: u32,
) -> u32 {
    while uncertain != 0 {
        let lane = uncertain.trailing_zeros() as usize;
        uncertain &= uncertain - 1;
        hits &= !(1 << lane);
        // The ends of edges are compared in this order, that of one winding.
        let corners =
            corners(lane).map(|[x, y, z]| if is_negative { [y, x, z] } else { [x, y, z] });
        let [nearest, farthest] = range(lane);
        if let Some(t) = on_edge(corners)
            && nearest <= t
            && t <= farthest
        {
            distances[lane] = t;
            hits |= 1 << lane;
        }
    }
    hits
}

/// [`on_edges`] for the triangles of a block.
#[cold]
#[inline(never)]
fn on_edges_of_block(
    block: Block<'_>,
    positions: &[[f32; 3]],
    ray: ShearedRay,
    range: [f32; 2],
    uncertain: u32,
    (distances, hits): (&mut [f32; WIDTH], u32),
) -> u32 {
    let axes = axis_order(ray.last);
    let corners = |lane| ray.transform(block.corners_by_axes(lane, positions, axes));
    on_edges(corners, |_| range, ray.is_negative, uncertain, distances, hits)
}

/// [`on_edges`] for triangles whose vertices are gathered.
#[cold]
#[inline(never)]
fn on_edges_of_gathered(
    gathered: &Gathered,
    ray: ShearedRay,
    range: [f32; 2],
    uncertain: u32,
    (distances, hits): (&mut [f32; WIDTH], u32),
) -> u32 {
    let axes = axis_order(ray.last);
    let corner = |corner: usize, lane: usize| axes.map(|axis| gathered[axis][corner][lane]);
    let corners = |lane| ray.transform([0, 1, 2].map(|number| corner(number, lane)));
    on_edges(corners, |_| range, ray.is_negative, uncertain, distances, hits)
}

/// [`on_edges`] for one triangle and the rays of a group, from `first` on.
#[cold]
#[inline(never)]
fn on_edges_of_rays(
    corners: [[f32; 3]; 3],
    (rays, first): (&ShearedRows, usize),
    is_negative: bool,
    [start, end]: [&Row; 2],
    uncertain: u32,
    (distances, hits): (&mut [f32; LANES], u32),
) -> u32 {
    let transformed = |at: usize| rays.ray(first + at, 2, is_negative).transform(corners);
    let range = |at: usize| [lane(start, first + at), lane(end, first + at)];
    on_edges(transformed, range, is_negative, uncertain, distances, hits)
}

/// Pairs of a ray and a triangle, lane by lane: x, y and z of each corner in the ray's frame.
type Transformed<N> = [[N; 3]; 3];

/// The distances at which a ray hits a block's triangles, and a bit for each hit within `range`.
///
/// Transforms each shared vertex once and permutes the results to corners.
#[inline(always)]
pub(crate) fn intersect_block<S: Simd>(
    simd: S,
    block: Block<'_>,
    positions: &[[f32; 3]],
    ray: &ShearedRay,
    range: [f32; 2],
) -> ([f32; WIDTH], u32) {
    let head = block.header();
    let [kx, ky, kz] = axis_order(ray.last);
    let zero = f32x8::splat(simd, 0.0);
    let mut corners: Transformed<f32x8<S>> = [[zero; 3]; 3];
    match head.rows() {
        VertexRows::Shared => {
            let [x, y, z] = transform_rows(simd, block, [kx, ky, kz], ray);
            let words = block.triangle_words(simd);
            for (corner, at) in [words, words >> 3, words >> 6].into_iter().enumerate() {
                corners[0][corner] = permuted(simd, x, at);
                corners[1][corner] = permuted(simd, y, at);
                corners[2][corner] = permuted(simd, z, at);
            }
        }
        VertexRows::Separate => {
            for corner in 0..3 {
                let rows = [3 * corner + kx, 3 * corner + ky, 3 * corner + kz];
                let [x, y, z] = transform_rows(simd, block, rows, ray);
                (corners[0][corner], corners[1][corner], corners[2][corner]) = (x, y, z);
            }
        }
        VertexRows::Numbers => {
            let is_x = mask32x8::splat(simd, ray.last == 0);
            let chosen = [is_x, mask32x8::splat(simd, ray.last == 1)];
            for corner in 0..3 {
                let [x, y, z] = transform_corner(simd, block, corner, positions, ray, chosen);
                (corners[0][corner], corners[1][corner], corners[2][corner]) = (x, y, z);
            }
        }
    }
    let ends = range.map(|t| f32x8::splat(simd, t));
    let mut distances = [0.0; WIDTH];
    let (t, mut hits, uncertain) = intersect_lanes(&corners, ends, (1 << head.count()) - 1);
    t.store_slice(&mut distances);
    if uncertain != 0 {
        let found = (&mut distances, hits);
        hits = on_edges_of_block(block, positions, *ray, range, uncertain, found);
    }
    (distances, hits)
}

/// Transforms rows of a block, in the order of the ray's axes.
#[inline(always)]
fn transform_rows<S: Simd>(
    simd: S,
    block: Block<'_>,
    [x, y, z]: [usize; 3],
    ray: &ShearedRay,
) -> [f32x8<S>; 3] {
    transform(load_row(simd, block, x), load_row(simd, block, y), load_row(simd, block, z), ray)
}

/// Transforms one corner of each triangle, in a block that stores vertex numbers.
#[inline(always)]
fn transform_corner<S: Simd>(
    simd: S,
    block: Block<'_>,
    corner: usize,
    positions: &[[f32; 3]],
    ray: &ShearedRay,
    [is_x, is_y]: [mask32x8<S>; 2],
) -> [f32x8<S>; 3] {
    let [x, y, z] = gather_corner(simd, block, corner, positions);
    let first = is_x.select(y, is_y.select(z, x));
    let second = is_x.select(z, is_y.select(x, y));
    let last = is_x.select(x, is_y.select(y, z));
    transform(first, second, last, ray)
}

#[inline(always)]
fn transform<S: Simd>(
    first: f32x8<S>,
    second: f32x8<S>,
    last: f32x8<S>,
    ray: &ShearedRay,
) -> [f32x8<S>; 3] {
    let along = last - ray.origin[2];
    [
        first - ray.origin[0] - along * ray.shear[0],
        second - ray.origin[1] - along * ray.shear[1],
        along * ray.shear[2],
    ]
}

/// [`intersect_block`] for triangles whose vertices are gathered already, as for the second ray of a
/// packet that reaches a leaf.
#[inline(always)]
pub(crate) fn intersect_gathered<S: Simd>(
    simd: S,
    gathered: &Gathered,
    count: usize,
    ray: &ShearedRay,
    range: [f32; 2],
) -> ([f32; WIDTH], u32) {
    let [kx, ky, kz] = axis_order(ray.last);
    let [x, y, z] = [&gathered[kx & 3], &gathered[ky & 3], &gathered[kz & 3]];
    let mut corners: Transformed<f32x8<S>> = [[f32x8::splat(simd, 0.0); 3]; 3];
    for corner in 0..3 {
        let row = |rows: &[[f32; WIDTH]; 3]| f32x8::simd_from(simd, rows[corner]);
        let [x, y, z] = transform(row(x), row(y), row(z), ray);
        (corners[0][corner], corners[1][corner], corners[2][corner]) = (x, y, z);
    }
    let ends = range.map(|t| f32x8::splat(simd, t));
    let mut distances = [0.0; WIDTH];
    let (t, mut hits, uncertain) = intersect_lanes(&corners, ends, (1 << count) - 1);
    t.store_slice(&mut distances);
    if uncertain != 0 {
        let found = (&mut distances, hits);
        hits = on_edges_of_gathered(gathered, *ray, range, uncertain, found);
    }
    (distances, hits)
}

/// The distances at which a group of rays hits one triangle of a block, and a bit for each of the `active`
/// rays that hits it within its range. `axes` is the order of the rays' axes.
///
/// Corners are read one number at a time: an array of all nine would be gathered, from rows that are still
/// being stored.
#[inline(always)]
pub(crate) fn intersect_rays<N: Lanes>(
    lanes: N,
    (gathered, axes, of): (&Gathered, [usize; 3], usize),
    (rays, group): (&ShearedRows, usize),
    is_negative: bool,
    range: [&Row; 2],
    active: u32,
) -> (N, u32) {
    let [kx, ky, kz] = axes;
    let [of_x, of_y, of_z] = [&gathered[kx & 3], &gathered[ky & 3], &gathered[kz & 3]];
    let of = of & (WIDTH - 1);
    let x = load(lanes, &rays.origin[0], group);
    let y = load(lanes, &rays.origin[1], group);
    let z = load(lanes, &rays.origin[2], group);
    let shear_x = load(lanes, &rays.shear[0], group);
    let shear_y = load(lanes, &rays.shear[1], group);
    let shear_z = load(lanes, &rays.shear[2], group);
    let mut transformed: Transformed<N> = [[lanes; 3]; 3];
    for corner in 0..3 {
        let along = lanes.constant(of_z[corner][of]) - z;
        transformed[0][corner] = lanes.constant(of_x[corner][of]) - x - along * shear_x;
        transformed[1][corner] = lanes.constant(of_y[corner][of]) - y - along * shear_y;
        transformed[2][corner] = along * shear_z;
    }
    let ends = [load(lanes, range[0], group), load(lanes, range[1], group)];
    let (mut t, mut hits, uncertain) = intersect_lanes(&transformed, ends, active);
    if uncertain != 0 {
        let mut distances = [0.0; LANES];
        t.store(&mut distances, 0);
        let (rays, found) = ((rays, group * width::<N>()), (&mut distances, hits));
        let corner = |corner: usize| [of_x, of_y, of_z].map(|rows| rows[corner][of]);
        let corners = [corner(0), corner(1), corner(2)];
        hits = on_edges_of_rays(corners, rays, is_negative, range, uncertain, found);
        t = t.load(&distances, 0);
    }
    (t, hits)
}

/// The rays of a group that hit one of some triangles of a block, of those whose bit is set in `active`.
///
/// Vertices that triangles share are transformed once, into `vertices`. Which rays pass on one side of all
/// three edges decides whether anything else is computed: of all triangles first, since a branch for each
/// waits for its answer and is often predicted wrongly (rays to a light take 0.95 of the time).
#[inline(always)]
pub(crate) fn block_hits<S: Simd, N: Lanes>(
    simd: S,
    lanes: N,
    (block, positions, mut triangles): (Block<'_>, &[[f32; 3]], u32),
    (rays, group, axes, range): (&ShearedRows, usize, [usize; 3], [&Row; 2]),
    (active, is_negative): (u32, bool),
    vertices: &mut [[N; 3]; WIDTH],
) -> u32 {
    let header = block.header();
    let mut hits = 0;
    if header.rows() != VertexRows::Shared {
        let gathered = gather(simd, block, positions);
        while triangles != 0 {
            let of = triangles.trailing_zeros() as usize & (WIDTH - 1);
            triangles &= triangles - 1;
            let triangle = (&gathered, axes, of);
            hits |= intersect_rays(lanes, triangle, (rays, group), is_negative, range, active).1;
        }
        return hits;
    }
    let x = load(lanes, &rays.origin[0], group);
    let y = load(lanes, &rays.origin[1], group);
    let z = load(lanes, &rays.origin[2], group);
    let shear_x = load(lanes, &rays.shear[0], group);
    let shear_y = load(lanes, &rays.shear[1], group);
    let [row_x, row_y, row_z] = axes.map(|axis| block.row(axis));
    for vertex in 0..header.row_length() {
        let vertex = vertex & (WIDTH - 1);
        let at = |row: &[u32; WIDTH]| lanes.constant(f32::from_bits(row[vertex]));
        let along = at(&row_z) - z;
        vertices[vertex] =
            [at(&row_x) - x - along * shear_x, at(&row_y) - y - along * shear_y, along];
    }
    let zero = lanes.zero();
    let (mut passing, mut passed) = ([0; WIDTH], 0);
    while triangles != 0 {
        let of = triangles.trailing_zeros() as usize & (WIDTH - 1);
        triangles &= triangles - 1;
        let [a, b, c] = block.vertices_of(of).map(|vertex| &vertices[vertex]);
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let least = u.minimum(v).minimum(w);
        let most = u.maximum(v).maximum(w);
        let passes = !(least.less(zero) & zero.less(most));
        let bits = passes.bits() & active;
        passing[of] = bits;
        passed |= u32::from(bits != 0) << of;
    }
    while passed != 0 {
        let of = passed.trailing_zeros() as usize & (WIDTH - 1);
        passed &= passed - 1;
        let [a, b, c] = block.vertices_of(of).map(|vertex| &vertices[vertex]);
        let scale = load(lanes, &rays.shear[2], group);
        let corners =
            [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2] * scale, b[2] * scale, c[2] * scale]];
        let ends = [load(lanes, range[0], group), load(lanes, range[1], group)];
        let (_, mut found, uncertain) = intersect_lanes(&corners, ends, passing[of]);
        if uncertain != 0 {
            let corners = block.corners_by_axes(of, positions, axes);
            let mut distances = [0.0; LANES];
            let rays = (rays, group * width::<N>());
            found = on_edges_of_rays(
                corners,
                rays,
                is_negative,
                range,
                uncertain,
                (&mut distances, found),
            );
        }
        hits |= found;
    }
    hits
}

/// The test itself, in lanes: edge functions and the distance. Also returns a bit for each lane in which
/// an edge function is 0, which [`on_edges`] repeats exactly. It computes the corners anew: if they were
/// handed on, they would occupy registers here.
#[inline(always)]
fn intersect_lanes<N: Lanes>(
    [x, y, z]: &Transformed<N>,
    range: [N; 2],
    counted: u32,
) -> (N, u32, u32) {
    let u = x[2] * y[1] - y[2] * x[1];
    let v = x[0] * y[2] - y[0] * x[2];
    let w = x[1] * y[0] - y[1] * x[0];
    let zero = u.zero();
    let negative = u.less(zero) | v.less(zero) | w.less(zero);
    let positive = zero.less(u) | zero.less(v) | zero.less(w);
    let candidates = !(negative & positive);
    let counted = candidates.bits() & counted;
    if counted == 0 {
        return (zero, 0, 0);
    }
    let unknown = u.equal(zero) | v.equal(zero) | w.equal(zero);
    let sum = u + v + w;
    let t = (u * z[0] + v * z[1] + w * z[2]) / sum;
    let within = range[0].less_or_equal(t) & t.less_or_equal(range[1]);
    let uncertain = unknown.bits() & counted;
    (t, within.bits() & counted & !uncertain, uncertain)
}
