//! How parts of a mesh are drawn.

use super::CullFaces;

/// How a part of a mesh is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PartUse {
    /// The faces that are left out.
    pub cull: CullFaces,
    /// What its triangles do to what lies behind them.
    pub coverage: Coverage,
}

/// What a triangle does to what lies behind it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Coverage {
    /// Hides it.
    #[default]
    Opaque,
    /// Hides it but for holes.
    Cutout,
    /// Lets it through: drawn in layers.
    Blended,
}
