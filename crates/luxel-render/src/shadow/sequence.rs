//! Places on a disc with low discrepancy, scrambled by pixel: where rays to a light with an extent, and rays
//! of openness, go.

use luxel_math::SUBPIXELS;

/// Distinct angles.
const ANGLES: usize = 1 << 10;

/// Places on the unit disc, evenly spread for any number of them that is a power of two.
pub(crate) struct DiscSequence {
    /// The cosine and the sine of each angle.
    circle: Vec<[f64; 2]>,
}

/// What scrambles the sequence of one sample for one purpose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Scramble([u32; 2]);

impl Scramble {
    /// Of a sample at a place of the window, in pixels; `purpose` tells sequences of one sample apart.
    pub(crate) fn new(position: [f64; 2], purpose: u32) -> Self {
        let [x, y] = position.map(|side| (side * f64::from(SUBPIXELS)).round() as i32 as u32);
        let mixed = mix(mix(mix(x) ^ y) ^ purpose);
        Self([mixed, mix(mixed)])
    }
}

/// A number that looks random: each bit depends on all of `number` (the finalizer of MurmurHash3, by
/// Austin Appleby, with the constants that Chris Wellons found to be less biased).
fn mix(number: u32) -> u32 {
    let number = (number ^ number >> 16).wrapping_mul(0x7feb_352d);
    let number = (number ^ number >> 15).wrapping_mul(0x846c_a68b);
    number ^ number >> 16
}

impl DiscSequence {
    pub(crate) fn new() -> Self {
        let angle = |step: usize| (step as f64 + 0.5) * (std::f64::consts::TAU / ANGLES as f64);
        let place = |step| [libm::cos(angle(step)), libm::sin(angle(step))];
        Self { circle: (0..ANGLES).map(place).collect() }
    }

    /// The place of this number: r = sqrt(u), and the angle 2 pi v, for the points (u, v) of the first two
    /// dimensions of Sobol's sequence, whose bits are flipped by the scramble. Flipped bits leave points as
    /// evenly spread (Kollig and Keller, *Efficient Multidimensional Sampling*, 2002).
    pub(crate) fn place(&self, number: u32, Scramble([first, second]): Scramble) -> [f64; 2] {
        let u = number.reverse_bits() ^ first;
        let v = sobol(number) ^ second;
        // In the middle of its cell: never 0 nor 1.
        let radius = ((f64::from(u) + 0.5) * (1.0 / 4_294_967_296.0)).sqrt();
        let [cosine, sine] = self.circle[(v >> 22) as usize % ANGLES];
        [radius * cosine, radius * sine]
    }
}

/// The second dimension of Sobol's sequence.
fn sobol(mut number: u32) -> u32 {
    let (mut direction, mut result) = (1_u32 << 31, 0);
    while number != 0 {
        if number & 1 == 1 {
            result ^= direction;
        }
        number >>= 1;
        direction ^= direction >> 1;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_part_of_the_disc_has_its_share_of_any_power_of_two() {
        let disc = DiscSequence::new();
        for purpose in 0..20 {
            let scramble = Scramble::new([3.5, 7.25], purpose);
            for count in [16_u32, 64, 256] {
                // Rings of equal area, and quarters of the circle.
                let mut cells = [[0_u32; 4]; 4];
                for number in 0..count {
                    let [x, y] = disc.place(number, scramble);
                    let ring = ((x * x + y * y) * 4.0) as usize;
                    let quarter = usize::from(x < 0.0) + 2 * usize::from(y < 0.0);
                    cells[ring][quarter] += 1;
                }
                assert_eq!(cells, [[count / 16; 4]; 4], "{count} {scramble:?}");
            }
        }
    }

    #[test]
    fn neighbouring_samples_have_other_places() {
        let disc = DiscSequence::new();
        let place = |x: f64, purpose| disc.place(0, Scramble::new([x, 4.5], purpose));
        assert_ne!(place(10.5, 0), place(11.5, 0));
        assert_ne!(place(10.5, 0), place(10.5, 1));
        assert_eq!(place(10.5, 0), place(10.5, 0));
        // No direction is preferred.
        let mut mean = [0.0; 2];
        for x in 0..4096 {
            let [u, v] = place(f64::from(x) + 0.5, 0);
            mean = [mean[0] + u / 4096.0, mean[1] + v / 4096.0];
        }
        assert!(mean[0].abs() < 0.03 && mean[1].abs() < 0.03, "{mean:?}");
    }
}
