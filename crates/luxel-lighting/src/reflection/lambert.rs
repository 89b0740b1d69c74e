//! Ideal diffuse reflection.

use super::{Incidence, Surface};
use crate::Spread;
use luxel_math::{Lanes, Rgb};

/// k_d O_d max(N.L, 0) (Lambert, *Photometria*, 1760): a beam spreads over the more surface the
/// more it slants, and the surface sends what it gets equally into all directions.
#[inline(always)]
pub(crate) fn diffuse<N: Lanes, K: Spread<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> Rgb<N> {
    surface.diffuse() * incidence.n_dot_l.positive_part()
}
