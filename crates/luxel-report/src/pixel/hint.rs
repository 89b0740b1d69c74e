//! Hints at settings.

use luxel_render::Cull;

/// A setting that explains why something is invisible. It is data: programs word it as their
/// flag or button ([`Report::with_hint_text`](crate::Report::with_hint_text)).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Hint {
    /// The view leaves back faces out ([`Cull::Back`]).
    ViewCullsBackFaces,
    /// The material of the surface shows its front only.
    MaterialIsOneSided,
}

impl Hint {
    /// Why a back face is left out of a view with this culling.
    #[must_use]
    pub fn of_culling(cull: Cull) -> Self {
        match cull {
            Cull::Back => Self::ViewCullsBackFaces,
            Cull::Auto | Cull::None => Self::MaterialIsOneSided,
        }
    }

    /// The hint as a clause of a sentence.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::ViewCullsBackFaces => "the view leaves back faces out",
            Self::MaterialIsOneSided => "its material shows one side only",
        }
    }
}
