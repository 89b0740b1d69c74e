//! Which faces of triangles are left out.

use luxel_scene::Sides;
use luxel_view::Cull;

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

impl CullFaces {
    /// What a view's choice means for faces of a material, in an instance that mirrors or doesn't.
    #[must_use]
    pub fn of(cull: Cull, sides: Sides, mirrored: bool) -> Self {
        let back = if mirrored { Self::CounterClockwise } else { Self::Clockwise };
        match (cull, sides) {
            (Cull::None, _) | (Cull::Auto, Sides::Both) => Self::None,
            (Cull::Back, _) | (Cull::Auto, Sides::Front) => back,
        }
    }
}
