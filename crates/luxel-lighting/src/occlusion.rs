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

/// G': how much of a light the shading normal N may take that the surface itself, with its geometric
/// normal N_g, turns away from.
///
/// ```text
/// G = min(1, (N_g.L) / ((N.L) (N_g.N)))
/// G' = -G^3 + G^2 + G
/// ```
///
/// and 0 where N_g.L <= 0. Between corners whose normals differ from the triangle's, light would end at
/// the edge of the triangle that turns away from it, since there the surface shadows itself: a coarse ball
/// would have a jagged terminator. G' takes the light away smoothly before. It is 1 wherever N = N_g, and
/// its slope is 0 at G = 1 (Chiang, Li and Burley, *Taming the Shadow Terminator*, SIGGRAPH Talks 2019).
///
/// `cosines` are N_g.L, N.L and N_g.N; expects N.L > 0.
#[must_use]
#[inline(always)]
pub fn terminator<F: F64Lanes>([geometric_dot_l, n_dot_l, geometric_dot_n]: [F; 3]) -> F::F32 {
    let limit = n_dot_l * geometric_dot_n;
    let one = limit.constant(1.0);
    let g = geometric_dot_l / limit;
    let curved = (((one - g) * g + one) * g).to_f32();
    let is_above = (limit - geometric_dot_l).is_positive();
    curved.select(is_above, curved.one()).masked(geometric_dot_l.is_positive())
}

#[cfg(test)]
mod tests {
    use super::terminator;

    #[test]
    fn the_terminator_is_smooth_where_it_begins_and_black_where_the_surface_turns_away() {
        assert_eq!(terminator([0.5, 0.5, 1.0]), 1.0, "N is the surface's own normal");
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
