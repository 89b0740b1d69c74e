//! What a pixel doesn't show: surfaces behind what is seen, back faces that are left out, and what
//! lies next to a pixel that nothing covers. Asked of the fill rule of picks, which is the frame's.

use luxel::math::SimdLevel;
use luxel::pick::{Element, PickError, PickHit, PickView, Picker, Quality};
use luxel::render::{Cull, ExplainedSample, Explanation, Seen, View};
use luxel::scene::{Scene, Size};

/// What the samples of an entry don't show.
#[derive(Clone, Debug, Default)]
pub(super) struct Hidden {
    /// Back faces that would be seen if they were drawn, nearest first.
    pub(super) culled: Vec<PickHit>,
    /// What lies behind all that is seen, nearest first.
    pub(super) behind: Vec<PickHit>,
}

/// What lies nearest in the picture to a pixel that nothing covers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest {
    /// The object, by its place among the scene's.
    pub(super) object: usize,
    /// A pixel that shows it.
    pub(super) pixel: [u32; 2],
    /// How far apart the pixels are.
    pub(super) pixels: f64,
}

/// What a pixel doesn't show.
#[derive(Clone, Debug, Default)]
pub(super) struct Unseen {
    /// For each entry of the explanation.
    pub(super) entries: Vec<Hidden>,
    /// Where nothing covers the pixel, and something lies within [`NEAREST_WITHIN`].
    pub(super) nearest: Option<Nearest>,
}

/// How far around a pixel without a surface something is looked for, in pixels.
pub(super) const NEAREST_WITHIN: i64 = 100;

impl Unseen {
    /// Asks for the places that an explanation is about.
    ///
    /// # Errors
    /// [`PickError`] if a mesh has too many triangles, or the machine lacks the instructions.
    pub(super) fn new(
        scene: &Scene,
        view: &View,
        explanation: &Explanation,
        simd: SimdLevel,
    ) -> Result<Self, PickError> {
        let picker = Picker::with(scene, Quality::Fast, simd)?;
        let of = |cull| PickView::new(&picker, view.camera, view.size, cull);
        let (drawn, all) = (of(view.cull)?, of(Cull::None)?);
        let hidden = |entry: &ExplainedSample| {
            let [x, y] = entry.at;
            hidden(entry, &drawn.through(x, y), all.through(x, y))
        };
        let entries = explanation.samples.iter().map(hidden).collect();
        let empty = explanation
            .samples
            .iter()
            .all(|entry| entry.seen.iter().all(|seen| matches!(seen, Seen::Background { .. })));
        let nearest = if empty { nearest(&drawn, view.size, explanation.pixel) } else { None };
        Ok(Self { entries, nearest })
    }
}

fn hidden(entry: &ExplainedSample, drawn: &[PickHit], all: Vec<PickHit>) -> Hidden {
    let is = |hit: &PickHit, seen: &Seen| {
        seen.surface().is_some_and(|surface| {
            surface.object == hit.object
                && match hit.element {
                    Element::Triangle(number) => surface.triangle == Some(number),
                    Element::Point(_) | Element::Line(_) => surface.triangle.is_none(),
                }
        })
    };
    let is_seen = |hit: &PickHit| entry.seen.iter().any(|seen| is(hit, seen));
    let last = entry.seen.last();
    let before_last = |hit: &&PickHit| !last.is_some_and(|seen| is(hit, seen));
    let is_drawn = |hit: &PickHit| {
        drawn.iter().any(|other| (other.object, other.element) == (hit.object, hit.element))
    };
    Hidden {
        culled: all.iter().take_while(before_last).filter(|hit| !is_drawn(hit)).cloned().collect(),
        behind: drawn.iter().filter(|hit| !is_seen(hit)).cloned().collect(),
    }
}

/// The nearest pixel whose centre shows something, by rings of pixels.
fn nearest(view: &PickView<'_>, size: Size, pixel: [u32; 2]) -> Option<Nearest> {
    let [x, y] = pixel.map(i64::from);
    let mut best: Option<(i64, Nearest)> = None;
    for ring in 1..=NEAREST_WITHIN {
        // A ring's pixels are no nearer than its number.
        if best.is_some_and(|(squared, _)| squared <= ring * ring) {
            break;
        }
        let side = (-ring..ring)
            .flat_map(|along| [[along, -ring], [ring, along], [-along, ring], [-ring, -along]]);
        for [right, down] in side {
            let squared = right * right + down * down;
            let (Ok(column), Ok(row)) = (u32::try_from(x + right), u32::try_from(y + down)) else {
                continue;
            };
            let inside = column < size.width && row < size.height;
            if !inside || best.is_some_and(|(other, _)| other <= squared) {
                continue;
            }
            let found = view.owner_at(f64::from(column) + 0.5, f64::from(row) + 0.5);
            if let Some((object, _)) = found {
                let pixels = (squared as f64).sqrt();
                best = Some((squared, Nearest { object, pixel: [column, row], pixels }));
            }
        }
    }
    best.map(|(_, nearest)| nearest)
}
