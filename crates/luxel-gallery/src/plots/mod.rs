//! The plots of light and reflection. Every value on them is computed by luxel's own equation.

pub(crate) mod beam;
pub(crate) mod falloff;
pub(crate) mod lobes;
pub(crate) mod microsurface;
pub(crate) mod point;
pub(crate) mod spheres;
