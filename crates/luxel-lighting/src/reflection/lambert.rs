//! Ideal diffuse reflection.

use super::description::COSINE;
use super::{Incidence, Reflection, ReflectionModel, Surface};
use crate::Broadcast;
use crate::parameter::{K_A, K_D};
use luxel_math::{Lanes, Rgb};

pub(super) static MODEL: ReflectionModel = ReflectionModel {
    reflection: Reflection::Lambert,
    name: "lambert",
    help: "matt: the same light into all directions",
    formula: "k_d O_d max(N.L, 0)",
    source: "Lambert 1760",
    parameters: &[&K_A, &K_D],
    own: &[],
    highlight: None,
    diffuse: &[COSINE],
    specular: None,
};

/// k_d O_d max(N.L, 0) (Lambert, *Photometria*, 1760): a beam spreads over the more surface the
/// more it slants, and the surface reflects equally into all directions.
#[inline(always)]
pub(crate) fn diffuse<N: Lanes, K: Broadcast<N>>(
    surface: &Surface<'_, N, K>,
    incidence: &Incidence<N>,
) -> Rgb<N> {
    surface.diffuse() * incidence.n_dot_l.positive_part()
}
