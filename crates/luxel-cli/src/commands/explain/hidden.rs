//! What a pixel doesn't show: surfaces behind what is seen, back faces that are left out, and what
//! lies next to a pixel that nothing covers.

use luxel::render::{
    Cull, ExplainedSample, Explanation, NearestObject, RenderError, Renderer, Seen, SurfaceBelow,
    View,
};

/// What the samples of an entry don't show.
#[derive(Clone, Debug, Default)]
pub(super) struct Hidden {
    /// Back faces that would be seen if they were drawn, nearest first.
    pub(super) culled: Vec<SurfaceBelow>,
    /// What lies behind all that is seen, nearest first.
    pub(super) behind: Vec<SurfaceBelow>,
}

/// What a pixel doesn't show.
#[derive(Clone, Debug, Default)]
pub(super) struct Unseen {
    /// For each entry of the explanation.
    pub(super) entries: Vec<Hidden>,
    /// Where nothing covers the pixel, and something lies within [`NEAREST_WITHIN`].
    pub(super) nearest: Option<NearestObject>,
}

/// How far around a pixel without a surface something is looked for, in pixels.
pub(super) const NEAREST_WITHIN: u32 = 100;

impl Unseen {
    /// Asks for the places that an explanation is about.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub(super) fn new(
        renderer: &Renderer<'_>,
        view: &View,
        explanation: &Explanation,
    ) -> Result<Self, RenderError> {
        let with_backs = View { cull: Cull::None, ..view.clone() };
        let hidden = |entry: &ExplainedSample| {
            let drawn = renderer.below(view, entry.at)?;
            Ok(hidden(entry, &drawn, &renderer.below(&with_backs, entry.at)?))
        };
        let entries = explanation.samples.iter().map(hidden).collect::<Result<_, RenderError>>()?;
        let mut seen = explanation.samples.iter().flat_map(|entry| &entry.seen);
        let nearest = if seen.any(|seen| seen.surface().is_some()) {
            None
        } else {
            renderer.nearest_object(view, explanation.pixel, NEAREST_WITHIN)?
        };
        Ok(Self { entries, nearest })
    }
}

fn hidden(entry: &ExplainedSample, drawn: &[SurfaceBelow], all: &[SurfaceBelow]) -> Hidden {
    let is = |below: &SurfaceBelow, seen: &Seen| {
        seen.surface().is_some_and(|surface| {
            (surface.object, surface.triangle) == (below.object, below.triangle)
        })
    };
    let is_seen = |below: &&SurfaceBelow| entry.seen.iter().any(|seen| is(below, seen));
    let last = entry.seen.last();
    let before_last = |below: &&SurfaceBelow| !last.is_some_and(|seen| is(below, seen));
    let is_drawn = |below: &&SurfaceBelow| {
        let same =
            |other: &SurfaceBelow| (other.object, other.triangle) == (below.object, below.triangle);
        drawn.iter().any(same)
    };
    let culled = all.iter().take_while(before_last).filter(|below| !is_drawn(below));
    let behind = drawn.iter().filter(|below| !is_seen(below));
    Hidden { culled: culled.cloned().collect(), behind: behind.cloned().collect() }
}
