//! Which faces of triangles a view leaves out.

use luxel_scene::Sides;

/// Which faces are left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CullFaces {
    /// None.
    #[default]
    None,
    /// Those whose corners run clockwise in the window: the back faces.
    Clockwise,
    /// Those whose corners run counter-clockwise: the back faces of a mirrored instance.
    CounterClockwise,
}

/// Which faces a view leaves out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cull {
    /// As the material says.
    #[default]
    Auto,
    /// None.
    None,
    /// Back faces.
    Back,
}

impl Cull {
    /// What that means for faces of a material, in an instance that mirrors or doesn't.
    #[must_use]
    pub fn faces(self, sides: Sides, mirrored: bool) -> CullFaces {
        let back = if mirrored { CullFaces::CounterClockwise } else { CullFaces::Clockwise };
        match (self, sides) {
            (Self::None, _) | (Self::Auto, Sides::Both) => CullFaces::None,
            (Self::Back, _) | (Self::Auto, Sides::Front) => back,
        }
    }
}
