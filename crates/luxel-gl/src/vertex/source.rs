//! Where the vertices of a draw are.

use super::fetch::ArrayDraw;
use super::vertices::Vertices;
use super::view::VertexView;
use super::weld::Welded;
use crate::state::current::Current;
use std::borrow::Cow;
use std::sync::Arc;

/// Vertices of primitives of one mode.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "there is one for each draw, and most are runs")]
pub(crate) enum VertexSource<'a> {
    /// One after the other: the mode, and the vertices.
    Run(u32, Cow<'a, Vertices>),
    /// Of a display list.
    Welded(Arc<Welded>),
    Arrays(Arc<ArrayDraw>),
}

impl VertexSource<'_> {
    pub(crate) fn mode(&self) -> u32 {
        match self {
            Self::Run(mode, _) => *mode,
            Self::Welded(welded) => welded.mode,
            Self::Arrays(arrays) => arrays.mode,
        }
    }

    /// The vertices; attributes that aren't kept with them are what is current.
    pub(crate) fn vertices(&self, current: &Current) -> VertexView<'_> {
        match self {
            Self::Run(_, vertices) => vertices.view(current),
            Self::Welded(welded) => welded.vertices.view(current),
            Self::Arrays(arrays) => arrays.vertices.view(current),
        }
    }

    /// Their order; `None` for one after the other.
    pub(crate) fn elements(&self) -> Option<&[u32]> {
        match self {
            Self::Run(..) => None,
            Self::Welded(welded) => Some(&welded.elements),
            Self::Arrays(arrays) => arrays.elements.as_deref(),
        }
    }

    /// Bytes that it takes.
    pub(crate) fn bytes(&self) -> usize {
        let vertices = match self {
            Self::Run(_, vertices) => vertices.bytes(),
            Self::Welded(welded) => welded.vertices.bytes(),
            Self::Arrays(arrays) => arrays.vertices.bytes(),
        };
        vertices + self.elements().map_or(0, size_of_val)
    }

    /// The same, with vertices of its own.
    pub(crate) fn into_owned(self) -> VertexSource<'static> {
        match self {
            Self::Run(mode, vertices) => VertexSource::Run(mode, Cow::Owned(vertices.into_owned())),
            Self::Welded(welded) => VertexSource::Welded(welded),
            Self::Arrays(arrays) => VertexSource::Arrays(arrays),
        }
    }
}
