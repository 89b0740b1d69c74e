//! The environment as matt surfaces see it: spherical harmonics.

use super::blur::Pyramid;
use luxel_math::{Lanes, Rgb, Vec3};

/// The irradiance over directions, over pi, as a polynomial: factors of 1, y, z, x, xy, yz, 3 z^2 - 1, xz
/// and x^2 - y^2.
///
/// A matt surface averages the light of a half space by its cosine, which leaves little of any detail: nine
/// numbers a channel give its light with an error of 1 % on average (Ramamoorthi and Hanrahan, *An
/// Efficient Representation for Irradiance Environment Maps*, SIGGRAPH 2001). Where all light comes from
/// one small place, the error is up to 3/32 of what a surface that faces it gets, also on the far side.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Harmonics([[f32; 3]; 9]);

/// Of each harmonic, the squares of its norm, times A_l / pi: 1, 2/3 and 1/4.
const FACTORS: [f64; 9] = {
    use std::f64::consts::PI;
    let (constant, linear, square) = (0.25 / PI, 0.75 / PI * 2.0 / 3.0, 3.75 / PI / 4.0);
    [
        constant,
        linear,
        linear,
        linear,
        square,
        square,
        // 5 / (16 pi) and 15 / (16 pi)
        square / 12.0,
        square,
        square / 4.0,
    ]
};

fn terms([x, y, z]: [f64; 3]) -> [f64; 9] {
    [1.0, y, z, x, x * y, y * z, 3.0 * z * z - 1.0, x * z, x * x - y * y]
}

impl Harmonics {
    /// The harmonics of the light of all cells, and its mean.
    pub(super) fn new(pyramid: &Pyramid) -> (Self, [f32; 3]) {
        let mut sums = [[0.0_f64; 3]; 9];
        let mut areas = 0.0;
        for (light, area, middle) in pyramid.finest() {
            areas += f64::from(area);
            for (sums, term) in sums.iter_mut().zip(terms(middle.map(f64::from))) {
                for channel in 0..3 {
                    sums[channel] += term * f64::from(light[channel]);
                }
            }
        }
        let mean = sums[0].map(|sum| (sum / areas) as f32);
        let mut factors = [[0.0; 3]; 9];
        for (number, factors) in factors.iter_mut().enumerate() {
            *factors = sums[number].map(|sum| (sum * FACTORS[number]) as f32);
        }
        (Self(factors), mean)
    }

    /// The irradiance over pi of a surface with this normal, of unit length: the light of a white matt
    /// surface. Not below 0, where the sum of so few harmonics may be.
    #[inline(always)]
    pub(super) fn at<N: Lanes>(&self, normal: Vec3<N>) -> Rgb<N> {
        let Vec3 { x, y, z } = normal;
        let simd = x;
        let one = simd.one();
        let terms =
            [one, y, z, x, x * y, y * z, simd.constant(3.0) * z * z - one, x * z, x * x - y * y];
        let mut sum = Rgb::black(simd);
        for (factor, term) in self.0.iter().zip(terms) {
            sum = sum + Rgb::splat(simd, *factor) * term;
        }
        Rgb::new(sum.r.positive_part(), sum.g.positive_part(), sum.b.positive_part())
    }
}
