//! What a picture doesn't show: the surfaces under a place of it, one behind the other, and what lies
//! next to a pixel that nothing covers. Both by the frame's own fill rule, tile by tile.

use super::ledger::{ExplainedSample, Explanation, Seen};
use super::steps_of;
use crate::frame::{FrameNeeds, RenderError, Renderer};
use luxel_math::SUBPIXELS;
use luxel_scene::Size;
use luxel_view::View;
use luxel_visibility::{CoveragePolicy, Cull, Region, Samples, TILE, Tile, TriangleId};

/// A surface under a place of the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceBelow {
    /// The object, by its place among [`Renderer::objects`].
    pub object: usize,
    /// The triangle, by its number in the object; `None` for points and lines.
    pub triangle: Option<u32>,
    /// The place in world space.
    pub position: [f64; 3],
    /// The distance from the eye along the viewing axis.
    pub z: f64,
    /// Window depth, 0 near to 1 far.
    pub depth: f64,
}

/// What lies nearest in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestObject {
    /// The object, by its place among [`Renderer::objects`].
    pub object: usize,
    /// A pixel that shows it at its centre.
    pub pixel: [u32; 2],
    /// How far away that is, in pixels.
    pub distance: f64,
}

/// What the samples of an entry don't show.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hidden {
    /// Back faces that would be seen if they were drawn, nearest first.
    pub culled: Vec<SurfaceBelow>,
    /// What lies behind all that is seen, nearest first.
    pub behind: Vec<SurfaceBelow>,
}

/// What a pixel doesn't show.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Unseen {
    /// For each entry of the explanation.
    pub entries: Vec<Hidden>,
    /// Where nothing covers the pixel, and something lies within [`NEAREST_WITHIN`].
    pub nearest: Option<NearestObject>,
}

/// How far around a pixel without a surface something is looked for, in pixels.
pub const NEAREST_WITHIN: u32 = 100;

/// Most surfaces that are told of one place.
const MOST_BELOW: usize = 256;

impl Renderer {
    /// The surfaces under a place of a view, in pixels from its upper left corner and rounded to
    /// 1/256, nearest first, 256 at most: as if all of them were of glass. Back faces are among them
    /// if the view draws them.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible, or the place lies outside of it.
    pub fn below(&self, view: &View, place: [f64; 2]) -> Result<Vec<SurfaceBelow>, RenderError> {
        let steps = steps_of(place, view.size).ok_or(RenderError::Outside(view.size))?;
        let sample = Samples::one_at(steps.map(|steps| steps % SUBPIXELS));
        let below = self.below_samples(view, Some(sample), &[steps])?;
        Ok(below.into_iter().next().unwrap_or_default())
    }

    /// [`Renderer::below`] at samples of one pixel, given by steps of 1/256 pixel from the window's corner. `pattern` holds
    /// them; it is the view's if it is `None`.
    fn below_samples(
        &self,
        view: &View,
        pattern: Option<Samples>,
        samples: &[[i32; 2]],
    ) -> Result<Vec<Vec<SurfaceBelow>>, RenderError> {
        let Some([x, y]) = samples.first().map(|steps| steps.map(|steps| steps / SUBPIXELS)) else {
            return Ok(Vec::new());
        };
        let view = view.clone().with_edges(None);
        let eye = view.camera.eye();
        let needs = FrameNeeds {
            coverage: CoveragePolicy::LAYERS,
            samples: pattern,
            part: Some(Region { x, y, width: 1, height: 1 }),
            ..FrameNeeds::PICTURE
        };
        self.with_scene(&view, &needs, |scene, cutouts| {
            let frame = scene.frame;
            let holes = cutouts.finder(frame, self.level());
            let [across, _] = frame.tiles();
            let number = (y / TILE) as usize * across + (x / TILE) as usize;
            let surface = |id: TriangleId, steps: [i32; 2]| {
                let of = frame.triangle(id)?;
                let weights = frame.forms(of).barycentric(frame.rays(), steps);
                let [a, b, c] = frame.corners_in_view(of);
                let [_, second, third] = weights.map(f64::from);
                let in_view = a + (b - a) * second + (c - a) * third;
                let z = -in_view.z;
                let (object, triangle) = scene.placed.object_of(of.instance, of.triangle);
                Some(SurfaceBelow {
                    object,
                    triangle,
                    position: (scene.space(of.instance).view().world_from_view * in_view + eye)
                        .to_array(),
                    z,
                    depth: view.camera.projection.window_depth(z),
                })
            };
            let below = |&steps: &[i32; 2]| {
                let found = frame.blended_at(number, steps, &holes).into_iter().take(MOST_BELOW);
                found.filter_map(|id| surface(id, steps)).collect()
            };
            samples.iter().map(below).collect()
        })
    }

    /// The nearest pixel to one, at most `within` pixels away, whose centre shows something; `None`
    /// where there is none.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible, or the pixel lies outside of it.
    pub fn nearest_object(
        &self,
        view: &View,
        pixel: [u32; 2],
        within: u32,
    ) -> Result<Option<NearestObject>, RenderError> {
        let Size { width, height } = view.size;
        if pixel[0] >= width || pixel[1] >= height {
            return Err(RenderError::Outside(view.size));
        }
        let view = view.clone().with_edges(None).with_samples(1);
        let first = pixel.map(|side| side.saturating_sub(within));
        let last =
            [0, 1].map(|axis| pixel[axis].saturating_add(within).min([width, height][axis] - 1));
        let [wide, high] = [0, 1].map(|axis| (last[axis] - first[axis] + 1) as i32);
        let [x, y] = first.map(|side| side as i32);
        let needs = FrameNeeds {
            coverage: CoveragePolicy::NEAREST,
            part: Some(Region { x, y, width: wide, height: high }),
            ..FrameNeeds::PICTURE
        };
        self.with_scene(&view, &needs, |scene, cutouts| {
            let frame = scene.frame;
            let holes = cutouts.finder(frame, self.level());
            let tile_side = TILE as u32;
            let [across, _] = frame.tiles();
            let mut tile = Tile::new(1);
            let mut nearest: Option<(u64, NearestObject)> = None;
            let [first, last] = [first, last].map(|pixel| pixel.map(|side| side / tile_side));
            for row in first[1]..=last[1] {
                for column in first[0]..=last[0] {
                    let number = row as usize * across + column as usize;
                    frame.draw_opaque(self.level(), number, &holes, &mut tile);
                    for (x, y) in (0..TILE).flat_map(|y| (0..TILE).map(move |x| (x, y))) {
                        let (block, lane) = Tile::place(x, y);
                        let id = TriangleId(tile.planes()[0].ids[block][lane]);
                        let Some(of) = frame.triangle(id) else { continue };
                        let at = [column * tile_side + x as u32, row * tile_side + y as u32];
                        let away = [0, 1].map(|axis| u64::from(at[axis].abs_diff(pixel[axis])));
                        let squared = away[0] * away[0] + away[1] * away[1];
                        let known = nearest.map_or(u64::from(within).pow(2), |(known, _)| known);
                        let better =
                            if nearest.is_none() { squared <= known } else { squared < known };
                        if better && at[0] < width && at[1] < height {
                            let (object, _) = scene.placed.object_of(of.instance, of.triangle);
                            let distance = (squared as f64).sqrt();
                            nearest =
                                Some((squared, NearestObject { object, pixel: at, distance }));
                        }
                    }
                }
            }
            nearest.map(|(_, nearest)| nearest)
        })
    }
}

impl Unseen {
    /// Asks for the places that an explanation is about.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub fn new(
        renderer: &Renderer,
        view: &View,
        explanation: &Explanation,
    ) -> Result<Self, RenderError> {
        let outside = || RenderError::Outside(view.size);
        let steps = |entry: &ExplainedSample| steps_of(entry.at, view.size).ok_or_else(outside);
        let samples = explanation.samples.iter().map(steps).collect::<Result<Vec<_>, _>>()?;
        let only = explanation.position.and_then(|_| samples.first());
        let pattern = only.map(|steps| Samples::one_at(steps.map(|steps| steps % SUBPIXELS)));
        let drawn = renderer.below_samples(view, pattern, &samples)?;
        let with_backs = view.clone().with_cull(Cull::None);
        let all = renderer.below_samples(&with_backs, pattern, &samples)?;
        let entries = explanation.samples.iter().zip(drawn.iter().zip(&all));
        let entries = entries.map(|(entry, (drawn, all))| hidden(entry, drawn, all)).collect();
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
