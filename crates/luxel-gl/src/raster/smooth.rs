//! Figures that end anywhere within pixels: smooth points, lines and polygons, of which pixels are covered in part (OpenGL
//! 1.5, sections 3.3, 3.4.2 and 3.5), and those of framebuffers with several samples (sections 3.3.1 and 3.4.4).

use super::outline::Outline;
use super::piece_sink::PieceSink;
use crate::plane::{LANE_X, LANE_Y, TILE_BLOCKS, block_origin};
use luxel_math::{LANES, SUBPIXELS, Simd};
use luxel_visibility::{BLOCK, DepthPlane, Sink, TILE};

/// Half of a pixel's diagonal.
pub(super) const HALF_DIAGONAL: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Places in a row of a pixel, by which the part is found that a disc covers.
const PLACES: usize = 16;

/// A figure of the window, in pixels.
#[derive(Clone, Copy, Debug)]
pub(super) enum Figure {
    Disc {
        centre: [f64; 2],
        radius: f64,
    },
    /// A rectangle about a line: where that begins, the direction of unit length, how long and half as wide as it is.
    Band {
        from: [f64; 2],
        along: [f64; 2],
        length: f64,
        half: f64,
    },
}

impl Figure {
    /// The rectangle of a width about the line between two places in steps of 1/256 pixel; `None` if they are one.
    pub(super) fn band(ends: [[i32; 2]; 2], width: f32) -> Option<Self> {
        let [from, to] = ends.map(pixels);
        let way = [to[0] - from[0], to[1] - from[1]];
        let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
        let along = way.map(|part| part / length);
        (length > 0.0).then(|| Self::Band { from, along, length, half: f64::from(width) / 2.0 })
    }

    /// The disc of a size about a place in steps of 1/256 pixel.
    pub(super) fn disc(centre: [i32; 2], size: f32) -> Self {
        Self::Disc { centre: pixels(centre), radius: f64::from(size) / 2.0 }
    }

    /// How far along the line and how far to the left of it a place lies.
    fn local([x, y]: [f64; 2], from: [f64; 2], along: [f64; 2]) -> [f64; 2] {
        let (x, y) = (x - from[0], y - from[1]);
        [x * along[0] + y * along[1], y * along[0] - x * along[1]]
    }

    /// How far along its line a place lies; 0 for a disc.
    fn along(&self, place: [f64; 2]) -> f64 {
        match *self {
            Self::Disc { .. } => 0.0,
            Self::Band { from, along, .. } => Self::local(place, from, along)[0],
        }
    }

    /// Whether a place is within it.
    fn holds(&self, place: [f64; 2]) -> bool {
        match *self {
            Self::Disc { centre, radius } => {
                let (x, y) = (place[0] - centre[0], place[1] - centre[1]);
                x * x + y * y < radius * radius
            }
            Self::Band { from, along, length, half } => {
                let [u, v] = Self::local(place, from, along);
                (0.0..length).contains(&u) && (-half..half).contains(&v)
            }
        }
    }

    /// The part of a pixel that it covers.
    fn coverage(&self, pixel: [i32; 2]) -> f64 {
        let [x, y] = pixel.map(f64::from);
        let middle = [x + 0.5, y + 0.5];
        match *self {
            Self::Disc { centre, radius } => {
                let (dx, dy) = (middle[0] - centre[0], middle[1] - centre[1]);
                let distance = (dx * dx + dy * dy).sqrt();
                if distance + HALF_DIAGONAL <= radius {
                    return 1.0;
                }
                if distance - HALF_DIAGONAL >= radius {
                    return 0.0;
                }
                let step = 1.0 / PLACES as f64;
                let at = |number: usize| (number as f64 + 0.5) * step;
                let held = (0..PLACES * PLACES).filter(|number| {
                    self.holds([x + at(number % PLACES), y + at(number / PLACES)])
                });
                held.count() as f64 * step * step
            }
            Self::Band { from, along, length, half } => {
                let [u, v] = Self::local(middle, from, along);
                let least = (u.min(length - u)).min(half - v.abs());
                if least >= HALF_DIAGONAL {
                    return 1.0;
                }
                if least <= -HALF_DIAGONAL {
                    return 0.0;
                }
                // A pixel that four lines have cut has eight corners at most.
                let (mut corners, mut spare) = ([[0.0; 2]; 8], [[0.0; 2]; 8]);
                for (corner, [right, up]) in
                    corners.iter_mut().zip([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
                {
                    *corner = Self::local([x + right, y + up], from, along);
                }
                let mut count = 4;
                for (axis, sign, limit) in
                    [(0, 1.0, 0.0), (0, -1.0, -length), (1, 1.0, -half), (1, -1.0, -half)]
                {
                    count =
                        cut(&mut corners, &mut spare, count, |corner| corner[axis] * sign - limit);
                }
                area(&corners[..count]).clamp(0.0, 1.0)
            }
        }
    }

    /// Pixels that it may reach: left, bottom, right, top, the last two beyond.
    pub(super) fn bounds(&self) -> [i32; 4] {
        let (low, high) = match *self {
            Self::Disc { centre, radius } => {
                (centre.map(|at| at - radius), centre.map(|at| at + radius))
            }
            Self::Band { from, along, length, half } => {
                let ends =
                    [0, 1].map(|axis: usize| [from[axis], from[axis] + along[axis] * length]);
                // Across it the axes change places.
                let reach = [along[1].abs() * half, along[0].abs() * half];
                let low = [0, 1].map(|axis: usize| ends[axis][0].min(ends[axis][1]) - reach[axis]);
                let high = [0, 1].map(|axis: usize| ends[axis][0].max(ends[axis][1]) + reach[axis]);
                (low, high)
            }
        };
        let [left, bottom] = low.map(|at| at.floor() as i32);
        let [right, top] = high.map(|at| at.floor() as i32 + 1);
        [left, bottom, right, top]
    }
}

fn pixels(place: [i32; 2]) -> [f64; 2] {
    place.map(|at| f64::from(at) / f64::from(SUBPIXELS))
}

/// Keeps what of a convex polygon has no negative distance; how many corners that has. `spare` is as long as `corners`.
pub(super) fn cut(
    corners: &mut [[f64; 2]],
    spare: &mut [[f64; 2]],
    count: usize,
    distance: impl Fn([f64; 2]) -> f64,
) -> usize {
    let before = &mut spare[..count];
    before.copy_from_slice(&corners[..count]);
    let mut kept = 0;
    let mut keep = |corner: [f64; 2]| {
        if let Some(place) = corners.get_mut(kept) {
            *place = corner;
            kept += 1;
        }
    };
    for at in 0..count {
        let (a, b) = (before[at], before[(at + 1) % count]);
        let (d, e) = (distance(a), distance(b));
        if d >= 0.0 {
            keep(a);
        }
        if (d >= 0.0) != (e >= 0.0) {
            let t = d / (d - e);
            keep([a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]);
        }
    }
    kept
}

/// The area of a polygon that runs counter-clockwise.
pub(super) fn area(corners: &[[f64; 2]]) -> f64 {
    let mut sum = 0.0;
    for (at, a) in corners.iter().enumerate() {
        let b = corners[(at + 1) % corners.len()];
        sum += a[0] * b[1] - a[1] * b[0];
    }
    sum / 2.0
}

/// How depths run along a figure, and which parts of a line are left out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    /// At the line's ends.
    pub(super) depths: [f32; 2],
    /// The counter of a line's stipple where it begins, with what one bit stands for and the bits.
    pub(super) stipple: Option<(u32, (u32, u16))>,
}

impl Course {
    fn depth(&self, along: f64, figure: &Figure) -> f32 {
        let [from, to] = self.depths.map(f64::from);
        match figure {
            Figure::Disc { .. } => self.depths[0],
            Figure::Band { length, .. } => {
                (from + (to - from) * (along / length).clamp(0.0, 1.0)) as f32
            }
        }
    }

    fn shows(&self, along: f64) -> bool {
        self.stipple.is_none_or(|(counter, (factor, pattern))| {
            let pixel = along.max(0.0) as u32;
            pattern >> (counter.wrapping_add(pixel) / factor % 16) & 1 == 1
        })
    }
}

/// The fragments of a figure in the tile, whose alphas are multiplied by the part of a pixel that is covered.
pub(super) fn covered_in_part<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    figure: &Figure,
    course: Course,
) {
    let covered = |pixel: [i32; 2]| {
        let along = figure.along(pixel.map(|at| f64::from(at) + 0.5));
        let part = figure.coverage(pixel);
        (part > 0.0 && course.shows(along)).then(|| (part, course.depth(along, figure)))
    };
    put_covered(sink, figure.bounds(), &covered);
}

/// The fragments in the tile that one triangle of an outline colours, whose alphas are multiplied by the part of a pixel that
/// the outline covers.
pub(super) fn covered_by_outline<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    (outline, triangle): (&Outline, usize),
    depth: &DepthPlane,
) {
    let covered = |pixel: [i32; 2]| {
        let middle = pixel.map(|at| at * SUBPIXELS + SUBPIXELS / 2);
        outline.coverage(triangle, pixel).map(|part| (part, depth.at(middle)))
    };
    put_covered(sink, outline.bounds(triangle), &covered);
}

/// The fragments in the tile of which a part is covered, and their depths.
fn put_covered<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    bounds: [i32; 4],
    covered: &dyn Fn([i32; 2]) -> Option<(f64, f32)>,
) {
    let [low, high] = within(sink, bounds);
    for block in 0..TILE_BLOCKS {
        let first = block_origin(block);
        if (0..2).any(|axis| first[axis] >= high[axis] || first[axis] + BLOCK <= low[axis]) {
            continue;
        }
        let (mut coverage, mut depths, mut lanes) = ([0.0; LANES], [0.0; LANES], 0);
        for lane in 0..LANES {
            let at = [first[0] + LANE_X[lane], first[1] + LANE_Y[lane]];
            if (0..2).any(|axis| at[axis] < low[axis] || at[axis] >= high[axis]) {
                continue;
            }
            let pixel = [sink.origin[0] + at[0], sink.origin[1] + at[1]];
            if let Some((part, depth)) = covered(pixel) {
                lanes |= 1 << lane;
                coverage[lane] = part as f32;
                depths[lane] = depth;
            }
        }
        if lanes != 0 {
            sink.coverage = Some(coverage);
            sink.by_all_tests(lanes, &depths, block);
        }
    }
}

/// The fragments of a figure in the tile that hold a sample, which lies at `offset` in pixels, in steps of 1/256.
#[inline(always)]
pub(super) fn sampled<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    figure: &Figure,
    course: Course,
    offset: [i32; 2],
) {
    let [low, high] = within(sink, figure.bounds());
    let offset = pixels(offset);
    for y in low[1]..high[1] {
        for x in low[0]..high[0] {
            let place = [
                f64::from(sink.origin[0] + x) + offset[0],
                f64::from(sink.origin[1] + y) + offset[1],
            ];
            let along = figure.along(place);
            if figure.holds(place) && course.shows(along) {
                sink.sample([x, y], [0; 2], course.depth(along, figure));
            }
        }
    }
}

/// The tile's own pixels within bounds that may be drawn to.
fn within<S>(sink: &PieceSink<'_, '_, S>, bounds: [i32; 4]) -> [[i32; 2]; 2] {
    let low = |axis: usize| (bounds[axis] - sink.origin[axis]).max(sink.tests.limits[axis]).max(0);
    let high = |axis: usize| {
        (bounds[axis + 2] - sink.origin[axis]).min(sink.tests.limits[axis + 2]).min(TILE)
    };
    [[low(0), low(1)], [high(0), high(1)]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The part of a pixel in a figure, by many places.
    fn counted(figure: &Figure, [x, y]: [i32; 2]) -> f64 {
        let at = |number: i32| (f64::from(number) + 0.5) / 200.0;
        let places = (0..200 * 200).filter(|number| {
            figure.holds([f64::from(x) + at(number % 200), f64::from(y) + at(number / 200)])
        });
        places.count() as f64 / 40000.0
    }

    /// The sum of the parts of all pixels, of which some are counted, too, within a tolerance.
    fn summed(figure: &Figure, tolerance: f64) -> f64 {
        let [left, bottom, right, top] = figure.bounds();
        let mut sum = 0.0;
        for (x, y) in (bottom..top).flat_map(|y| (left..right).map(move |x| (x, y))) {
            let coverage = figure.coverage([x, y]);
            sum += coverage;
            if (x + y) % 3 == 0 {
                let counted = counted(figure, [x, y]);
                assert!((coverage - counted).abs() < tolerance, "{coverage}, not {counted}");
            }
        }
        sum
    }

    proptest! {
        #[test]
        fn section_3_4_2_the_parts_of_pixels_are_those_of_the_rectangle(
            from in [0..2048_i32, 0..2048_i32], to in [0..2048_i32, 0..2048_i32], width in 0.5..5.0_f32,
        ) {
            prop_assume!(from != to);
            let figure = Figure::band([from, to], width).unwrap();
            let sum = summed(&figure, 0.01);
            let Figure::Band { length, half, .. } = figure else { unreachable!() };
            prop_assert!((sum - 2.0 * length * half).abs() < 1e-9 * sum + 1e-9);
        }

        #[test]
        fn section_3_3_the_parts_of_pixels_are_those_of_the_disc(
            centre in [0..2048_i32, 0..2048_i32], size in 1.0..9.0_f32,
        ) {
            let sum = summed(&Figure::disc(centre, size), 0.06);
            let radius = f64::from(size) / 2.0;
            let area = std::f64::consts::PI * radius * radius;
            prop_assert!((sum - area).abs() < 0.02 * area + 0.08, "{} instead of {}", sum, area);
        }
    }

    #[test]
    fn a_place_without_length_has_no_band() {
        assert!(Figure::band([[5, 5]; 2], 3.0).is_none());
    }
}
