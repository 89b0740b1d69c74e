//! Where in a pixel its samples lie.

use luxel_math::SUBPIXELS;

/// Samples a pixel: the pattern of positions, in steps of 1/256 pixel from the upper left corner.
///
/// One sample is the centre; more are the standard patterns of Direct3D 11.3 (functional
/// specification, section 19.2.4) and Vulkan (section 25.3), given there in sixteenths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Samples {
    /// Where the only sample lies, if there is one.
    only: [i32; 2],
    positions: &'static [[i32; 2]],
    /// Sample numbers by their distance from the centre.
    by_distance: &'static [u8],
}

/// Most samples of a pixel.
pub const MAX_SAMPLES: usize = 16;

/// Sixteenths of a pixel, as the specifications give them, to steps of 1/256.
const fn from_sixteenths<const N: usize>(sixteenths: [[i32; 2]; N]) -> [[i32; 2]; N] {
    let mut positions = sixteenths;
    let mut sample = 0;
    while sample < N {
        positions[sample][0] *= SUBPIXELS / 16;
        positions[sample][1] *= SUBPIXELS / 16;
        sample += 1;
    }
    positions
}

/// Sample numbers by distance from the centre; equally far ones by number.
const fn by_distance<const N: usize>(positions: [[i32; 2]; N]) -> [u8; N] {
    const fn squared_distance([x, y]: [i32; 2]) -> i32 {
        let (dx, dy) = (x - SUBPIXELS / 2, y - SUBPIXELS / 2);
        dx * dx + dy * dy
    }
    let mut order = [0; N];
    let mut placed = 0;
    while placed < N {
        let mut slot = placed;
        let here = squared_distance(positions[placed]);
        while slot > 0 && squared_distance(positions[order[slot - 1] as usize]) > here {
            order[slot] = order[slot - 1];
            slot -= 1;
        }
        order[slot] = placed as u8;
        placed += 1;
    }
    order
}

macro_rules! pattern {
    ($name:ident, $count:literal, $sixteenths:expr) => {
        const $name: Samples = {
            const POSITIONS: [[i32; 2]; $count] = from_sixteenths($sixteenths);
            const ORDER: [u8; $count] = by_distance(POSITIONS);
            Samples { only: POSITIONS[0], positions: &POSITIONS, by_distance: &ORDER }
        };
    };
}

pattern!(ONE, 1, [[8, 8]]);
pattern!(TWO, 2, [[12, 12], [4, 4]]);
pattern!(FOUR, 4, [[6, 2], [14, 6], [2, 10], [10, 14]]);
pattern!(EIGHT, 8, [[9, 5], [7, 11], [13, 9], [5, 3], [3, 13], [1, 7], [11, 15], [15, 1]]);
#[rustfmt::skip]
pattern!(SIXTEEN, 16, [
    [9, 9], [7, 5], [5, 10], [12, 7], [3, 6], [10, 13], [13, 11], [11, 3],
    [6, 14], [8, 1], [4, 2], [2, 12], [0, 8], [15, 4], [14, 15], [1, 0],
]);

impl Samples {
    /// The pixel's centre alone.
    pub const ONE: Self = ONE;

    /// One sample in each pixel, elsewhere than at the centre: in steps of 1/256 pixel, from 0 to
    /// 255, from the upper left corner.
    #[must_use]
    pub const fn one_at(position: [i32; 2]) -> Self {
        Self { only: [position[0] & (SUBPIXELS - 1), position[1] & (SUBPIXELS - 1)], ..ONE }
    }

    /// The pattern of 1, 2, 4, 8 or 16 samples; `None` for other counts.
    #[must_use]
    pub const fn new(count: u32) -> Option<Self> {
        match count {
            1 => Some(ONE),
            2 => Some(TWO),
            4 => Some(FOUR),
            8 => Some(EIGHT),
            16 => Some(SIXTEEN),
            _ => None,
        }
    }

    /// How many samples a pixel has.
    #[must_use]
    pub const fn count(self) -> usize {
        self.positions.len()
    }

    /// The position of each sample in its pixel, in steps of 1/256 pixel.
    #[must_use]
    pub const fn positions(&self) -> &[[i32; 2]] {
        if self.positions.len() == 1 { std::slice::from_ref(&self.only) } else { self.positions }
    }

    /// The sample numbers, nearest to the pixel's centre first.
    #[must_use]
    pub const fn nearest_first(self) -> &'static [u8] {
        self.by_distance
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_pattern_has_its_samples_in_distinct_rows_and_columns() {
        for count in [2, 4, 8, 16] {
            let samples = Samples::new(count).unwrap();
            assert_eq!(samples.count() as u32, count);
            for axis in 0..2 {
                let mut taken: Vec<_> = samples.positions().iter().map(|p| p[axis]).collect();
                taken.sort_unstable();
                taken.dedup();
                assert_eq!(taken.len() as u32, count, "axis {axis}");
            }
        }
        assert_eq!(Samples::new(3), None);
    }

    #[test]
    fn a_single_sample_lies_where_it_was_put() {
        assert_eq!(Samples::ONE.positions(), [[128, 128]]);
        let moved = Samples::one_at([3, 255]);
        assert_eq!((moved.positions(), moved.count()), (&[[3, 255]][..], 1));
    }

    #[test]
    fn the_nearest_sample_comes_first() {
        let distance = |samples: Samples, sample: u8| {
            let [x, y] = samples.positions()[sample as usize];
            (x - 128).pow(2) + (y - 128).pow(2)
        };
        for count in [1, 2, 4, 8, 16] {
            let samples = Samples::new(count).unwrap();
            let order = samples.nearest_first();
            assert!(order.windows(2).all(|pair| {
                let (a, b) = (distance(samples, pair[0]), distance(samples, pair[1]));
                a < b || a == b && pair[0] < pair[1]
            }));
        }
    }
}
