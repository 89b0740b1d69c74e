//! What keeps light away from a point.

use luxel_math::{F64Lanes, LANES, Lanes};

/// How much of the light around a point reaches it, lane by lane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Occlusion<'v> {
    /// V of each light, by its place in the list: 0 in its shadow, 1 where nothing is in the way, as
    /// everywhere where none is given.
    pub visibility: Option<&'v [[f32; LANES]]>,
    /// Openness: the part of the light from all around that arrives. It multiplies the ambient terms and,
    /// as an approximation, what is mirrored of the environment.
    pub openness: Option<&'v [f32; LANES]>,
}

impl Occlusion<'_> {
    /// Nothing keeps any light away.
    pub const NONE: Self = Self { visibility: None, openness: None };
}

/// G': how much of a light a normal N from a normal map may take that the surface under the map, with its
/// smooth normal N_s, turns away from.
///
/// ```text
/// G = min(1, (N_s.L) / ((N.L) (N_s.N)))
/// G' = -G^3 + G^2 + G
/// ```
///
/// 0 where N_s.L <= 0, and 1 where N.L <= 0, which takes no light. Bumps that lean towards a light behind
/// the surface would shine until the surface shadows itself, and end there at once. G' takes their light
/// away smoothly before. It is 1 wherever N = N_s, and its slope is 0 at G = 1 (Chiang, Li and Burley,
/// *Taming the Shadow Terminator*, SIGGRAPH Talks 2019).
///
/// `cosines` are N_s.L, N.L and N_s.N.
#[must_use]
#[inline(always)]
pub fn terminator<F: F64Lanes>([smooth_dot_l, n_dot_l, smooth_dot_n]: [F; 3]) -> F::F32 {
    let limit = n_dot_l * smooth_dot_n;
    let one = limit.constant(1.0);
    let g = smooth_dot_l / limit;
    let curved = (((one - g) * g + one) * g).to_f32();
    let is_above = (limit - smooth_dot_l).is_positive();
    let factor = curved.select(is_above, curved.one()).masked(smooth_dot_l.is_positive());
    factor.select(n_dot_l.is_positive(), curved.one())
}

#[cfg(test)]
mod tests {
    use super::terminator;

    #[test]
    fn the_terminator_is_smooth_where_it_begins_and_black_where_the_surface_turns_away() {
        assert_eq!(terminator([0.5, 0.5, 1.0]), 1.0, "N is the surface's own normal");
        assert_eq!(terminator([-0.1, -0.2, 0.9]), 1.0, "there is no light to take away");
        assert_eq!(terminator([0.9, 0.5, 0.8]), 1.0, "the surface faces the light more than N");
        assert_eq!(terminator([0.0, 0.1, 0.9]), 0.0);
        assert_eq!(terminator([-0.2, 0.1, 0.9]), 0.0);
        // -G^3 + G^2 + G at G = 1/2.
        assert_eq!(terminator([0.2, 0.5, 0.8]), 0.625);
        let mut last = 0.0;
        for step in 1..=1000 {
            let value = terminator([f64::from(step) / 1000.0 * 0.4, 0.5, 0.8]);
            assert!(value >= last && value - last < 2e-3, "{step}: {last}, {value}");
            last = value;
        }
        // Its slope is 0 at the end.
        assert!(1.0 - terminator([0.4 * 0.999, 0.5, 0.8]) < 3e-6);
    }

    #[test]
    fn rounding_leaves_flat_surfaces_fully_lit() {
        for step in 1..100 {
            let cosine = f64::from(step) / 100.0;
            for error in [1.0 - 1e-7, 1.0 + 1e-7] {
                assert_eq!(terminator([cosine * error, cosine, 1.0]), 1.0);
            }
        }
    }
}
