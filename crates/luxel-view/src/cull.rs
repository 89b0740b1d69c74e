//! Which faces of triangles a view leaves out.

/// Which faces a view leaves out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Cull {
    /// As the material specifies.
    #[default]
    Auto,
    /// None.
    None,
    /// Back faces.
    Back,
}
