//! Ideal diffuse reflection.

use super::{Incidence, Surface};
use luxel_math::{Number, Rgb};

/// k_d O_d max(N.L, 0) (Lambert, *Photometria*, 1760): a beam spreads over the more surface the
/// more it slants, and the surface sends what it gets equally into all directions.
#[inline(always)]
pub(crate) fn diffuse<N: Number>(surface: &Surface<'_, N>, incidence: &Incidence<N>) -> Rgb<N> {
    surface.of.diffuse * incidence.n_dot_l.positive_part()
}
