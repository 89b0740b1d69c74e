//! The point that is lit.

use luxel_math::Vec3;

/// A point of a surface, as the equation wants it.
///
/// World directions, with the eye as the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint<N> {
    /// Where it lies, relative to the eye.
    pub position: Vec3<N>,
    /// N: the normal of the side that is seen, of unit length.
    pub normal: Vec3<N>,
    /// V: towards the eye, of unit length; against the viewing direction for parallel projections.
    pub view: Vec3<N>,
    /// The distance from the eye along the viewing axis, for fog.
    pub depth: N,
}
