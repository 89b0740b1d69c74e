//! Which pixels a line has: the rule of the diamond's exit (OpenGL 1.5, section 3.4.1), in exact integers.
//!
//! A fragment belongs to a line if the line leaves the diamond |x - x_f| + |y - y_f| < 1/2 about the pixel's centre. A
//! line that runs more along x (x-major) has one fragment in each column whose centre lies between its ends: there it
//! crosses the middle of a diamond. At the start there is one more if the line begins within a diamond whose middle it has
//! passed; at the end there is one fewer if it ends within the diamond.
//!
//! Lines through corners of pixels or diamonds are as if moved by (-e, -e^2) for a small e: by 1/4 and 1/16 of a step of
//! 1/256 pixel here, so that no place is on a border and all stays in integers.

use luxel_math::SUBPIXELS;

/// Finer steps in one of 1/256 pixel.
const FINER: i64 = 16;
/// What lines are moved by.
const MOVED: [i64; 2] = [4, 1];
/// Finer steps of a pixel.
const STEP: i64 = SUBPIXELS as i64 * FINER;
const HALF: i64 = STEP / 2;

/// The fragments of a line between two places in steps of 1/256 pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LineWalk {
    /// 0 for a line along x, 1 along y.
    pub(crate) major: usize,
    /// The first and the last pixel along the major axis, in the order of the line; how many there are.
    pub(crate) first: i32,
    pub(crate) step: i32,
    pub(crate) count: i32,
    from: [i64; 2],
    delta: [i64; 2],
}

/// The axis that a line runs more along: 0 for x, 1 for y.
#[inline(always)]
pub(crate) fn major_axis(from: [i32; 2], to: [i32; 2]) -> usize {
    let [across, up] = [to[0].abs_diff(from[0]), to[1].abs_diff(from[1])];
    usize::from(up > across)
}

impl LineWalk {
    #[inline]
    pub(crate) fn new(from: [i32; 2], to: [i32; 2]) -> Self {
        let major = major_axis(from, to);
        let finer = |place: [i32; 2]| {
            let [x, y] = place.map(|at| i64::from(at) * FINER);
            [x - MOVED[0], y - MOVED[1]]
        };
        let (from, to) = (finer(from), finer(to));
        let delta = [to[0] - from[0], to[1] - from[1]];
        let along = |pair: [i64; 2]| chosen(pair, major);
        let (start, end) = (along(from), along(to));
        let step = if end < start { -1 } else { 1 };
        // Pixels whose centre the line passes.
        let (first, last) = if step > 0 {
            ((start + HALF - 1).div_euclid(STEP), (end - HALF).div_euclid(STEP))
        } else {
            ((start - HALF).div_euclid(STEP), (end + HALF - 1).div_euclid(STEP))
        };
        let mut walk =
            Self { major, first: first as i32, step: step as i32, count: 0, from, delta };
        let mut count = (last - first) * step + 1;
        let begins_within = diamond(from);
        if begins_within.is_some_and(|pixel| along(pixel) == first - step) {
            walk.first -= walk.step;
            count += 1;
        }
        // Where it ends within a diamond, that one isn't left.
        if let Some(pixel) = diamond(to)
            && count > 0
            && along(pixel) == i64::from(walk.first) + (count - 1) * step
        {
            count -= 1;
        }
        walk.count = count.max(0) as i32;
        walk
    }

    /// Pixel number `index`: its column and row.
    pub(crate) fn pixel(&self, index: i32) -> [i32; 2] {
        let along = self.first + index * self.step;
        let (major, minor) = (self.major, 1 - self.major);
        let length = chosen(self.delta, major);
        let start = chosen(self.from, minor);
        let across = if length == 0 {
            start
        } else {
            // Rounded down to whole steps: the pixel is the same.
            let way = i64::from(along) * STEP + HALF - chosen(self.from, major);
            let within = way.clamp(length.min(0), length.max(0));
            start + (chosen(self.delta, minor) * within).div_euclid(length)
        };
        let across = across.div_euclid(STEP) as i32;
        if major == 0 { [along, across] } else { [across, along] }
    }
}

/// The value along an axis. A place in an array would go through memory, where what is written in parts and read whole
/// waits.
#[inline(always)]
fn chosen([x, y]: [i64; 2], axis: usize) -> i64 {
    if axis == 0 { x } else { y }
}

/// The pixel whose diamond holds a place.
fn diamond(place: [i64; 2]) -> Option<[i64; 2]> {
    let pixel = place.map(|at| at.div_euclid(STEP));
    let distance = |axis: usize| (place[axis] - pixel[axis] * STEP - HALF).abs();
    (distance(0) + distance(1) < HALF).then_some(pixel)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn pixels(from: [i32; 2], to: [i32; 2]) -> Vec<[i32; 2]> {
        let walk = LineWalk::new(from, to);
        (0..walk.count).map(|index| walk.pixel(index)).collect()
    }

    /// The centre of a pixel, and a little more.
    fn at(x: i32, y: i32, more: i32) -> [i32; 2] {
        [x * 256 + 128 + more, y * 256 + 128]
    }

    #[test]
    fn section_3_4_1_the_last_pixel_of_a_line_between_centres_is_left_to_the_next_line() {
        assert_eq!(pixels(at(1, 1, 0), at(4, 1, 0)), [[1, 1], [2, 1], [3, 1]]);
        assert_eq!(pixels(at(4, 1, 0), at(1, 1, 0)), [[4, 1], [3, 1], [2, 1]]);
        assert_eq!(pixels([128, 128], [128, 1024 + 128]).len(), 4);
        assert!(pixels(at(2, 2, 10), at(2, 2, -10)).is_empty());
    }

    #[test]
    fn section_3_4_1_lines_between_pixels_belong_to_the_left_and_the_lower_one() {
        assert_eq!(pixels([512, 0], [512, 768]), [[1, 0], [1, 1], [1, 2]]);
        assert_eq!(pixels([0, 512], [768, 512]), [[0, 1], [1, 1], [2, 1]]);
    }

    #[test]
    fn section_3_4_1_a_line_that_begins_behind_the_middle_of_a_diamond_leaves_it() {
        assert_eq!(pixels(at(1, 1, 100), at(3, 1, 0)), [[1, 1], [2, 1]]);
        // Beyond the corner of the diamond.
        assert_eq!(pixels([256 + 250, 256 + 10], at(3, 1, 0)), [[2, 1]]);
        // It ends between two diamonds: the last one is left.
        assert_eq!(pixels(at(1, 1, 0), [3 * 256 + 253, 256 + 130]), [[1, 1], [2, 1]]);
    }

    proptest! {
        #[test]
        fn section_3_4_1_every_fragment_is_a_diamond_that_the_line_leaves(
            from in [0..2048_i32, 0..2048_i32], to in [0..2048_i32, 0..2048_i32],
        ) {
            let found = pixels(from, to);
            // A diamond's interior that holds a point of the line, but not its end, is left.
            let inside = |[x, y]: [f64; 2], pixel: [i32; 2]| {
                let centre = pixel.map(|at| f64::from(at) * 256.0 + 128.0);
                128.0 - (x - centre[0]).abs() - (y - centre[1]).abs()
            };
            let [a, b] = [from, to].map(|end| end.map(f64::from));
            for y in 0..8 {
                for x in 0..8 {
                    let pixel = [x, y];
                    let passes = (0..=4000).any(|t| {
                        let t = f64::from(t) / 4000.0;
                        inside([a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t], pixel) > 1.0
                    });
                    let ends = inside(b, pixel);
                    if passes && ends < -1.0 {
                        prop_assert!(found.contains(&pixel), "{pixel:?} of {found:?}");
                    }
                    if ends > 1.0 {
                        prop_assert!(!found.contains(&pixel), "{pixel:?} of {found:?}");
                    }
                }
            }
            let touches = |pixel: &[i32; 2]| {
                (0..=4000).any(|t| {
                    let t = f64::from(t) / 4000.0;
                    inside([a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t], *pixel) > -2.0
                })
            };
            prop_assert!(found.iter().all(touches), "{:?}", found);
        }
    }
}
