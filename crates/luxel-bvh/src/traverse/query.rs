//! What a ray asks: its closest hit, or whether it hits anything.

use super::target::{NearestHit, RayTarget};
use crate::intersect::ShearedRay;
use crate::ray::RayHit;

/// A kind of query. Kernels are generic over it, so that both kinds run the same tests.
pub(crate) trait RayQuery {
    /// Whether traversal ends at the first hit.
    const ANY: bool;
    /// The answer for one ray.
    type Answer: Copy + Send;
    /// The answer for a ray that hits nothing.
    const MISS: Self::Answer;

    fn answer(target: &RayTarget<'_>, ray: &ShearedRay, nearest: NearestHit) -> Self::Answer;
}

/// The closest hit; of equally close ones that on the lowest triangle.
pub(crate) struct ClosestHit;

/// Whether there is any hit.
pub(crate) struct AnyHit;

impl RayQuery for ClosestHit {
    const ANY: bool = false;
    type Answer = Option<RayHit>;
    const MISS: Option<RayHit> = None;

    #[inline(always)]
    fn answer(target: &RayTarget<'_>, ray: &ShearedRay, nearest: NearestHit) -> Option<RayHit> {
        target.resolve(ray, nearest)
    }
}

impl RayQuery for AnyHit {
    const ANY: bool = true;
    type Answer = bool;
    const MISS: bool = false;

    #[inline(always)]
    fn answer(_: &RayTarget<'_>, _: &ShearedRay, nearest: NearestHit) -> bool {
        nearest.is_hit()
    }
}
