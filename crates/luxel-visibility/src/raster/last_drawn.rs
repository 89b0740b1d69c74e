//! The triangle that was drawn last into a tile.

use super::setup::Triangle;
use crate::types::TriangleId;

/// The triangle that was drawn last into a tile, where it has no holes.
///
/// One that repeats it and was submitted later is hidden wherever it is: it has the same depths. So copies of
/// a triangle that fills the window cost their setup alone, where their cluster as a whole repeats none.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LastDrawn(Option<(Triangle, TriangleId)>);

impl LastDrawn {
    /// Whether a triangle repeats the last one, in whose place it is taken otherwise. `comes_first` tells
    /// whether a triangle was submitted before this one. Mark the closure `#[inline(always)]`.
    #[inline(always)]
    pub(super) fn repeats(
        &mut self,
        triangle: &Triangle,
        id: TriangleId,
        comes_first: impl Fn(TriangleId) -> bool,
    ) -> bool {
        match &self.0 {
            Some((last, first)) if last == triangle && comes_first(*first) => true,
            _ => {
                self.0 = Some((*triangle, id));
                false
            }
        }
    }
}
