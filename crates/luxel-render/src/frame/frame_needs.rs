//! What a frame is prepared for.

use crate::context::Heard;
use luxel_visibility::{CoveragePolicy, Region, Samples};

/// What a frame is for, beside its view.
#[derive(Clone, Copy)]
pub(crate) struct FrameNeeds {
    pub(crate) coverage: CoveragePolicy,
    /// The sample pattern; the view's if it is `None`.
    pub(crate) samples: Option<Samples>,
    /// What witnesses hear beside what shading needs.
    pub(crate) heard: Heard,
    /// Tiles with these pixels are drawn; all tiles if it is `None`.
    pub(crate) part: Option<Region>,
}

impl FrameNeeds {
    /// A picture of the view.
    pub(crate) const PICTURE: Self =
        Self { coverage: CoveragePolicy::DRAWN, samples: None, heard: Heard::NOTHING, part: None };
}
