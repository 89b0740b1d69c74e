//! A view as vectors: SVG with hidden surfaces removed.
//!
//! 1. `primitives`: triangles are clipped to the view volume, as for feedback.
//! 2. `order`: what is seen at none of sixteen samples a pixel, and proves to be covered by what is
//!    seen, is dropped; the rest gets an order in which what is nearer comes later, cut where
//!    triangles pass through one another or overlap in a ring. This is exact but for rounding: no
//!    polygon has one depth.
//! 3. `flatten`: faces are cut into pieces of nearly one colour, lit as the picture's pixels are.
//! 4. `hidden`: pieces that are hidden, and not next to seen ones, are dropped.
//! 5. `paint`: pieces of nearly one colour become areas without seams between them, in the order of
//!    `schedule`.
//! 6. `document`, `path`: areas become text, cut out by their silhouette.

mod convex;
mod document;
mod face;
mod flatten;
mod hidden;
mod order;
mod paint;
mod path;
mod schedule;
mod ways;
mod web;

use crate::context::ShadingContext;
use crate::coverage::AlphaTest;
use crate::frame::{FrameNeeds, RenderError, Renderer};
use crate::vector::primitives::{Clipper, InWindow, is_culled};
use document::Document;
use face::{Face, Grid, for_each};
use flatten::{Flattener, Sampler, largest_range};
use hidden::{Hiding, needed};
use luxel_view::{Shading, ShadingMode, View};
use luxel_visibility::{Coverage, Samples, Tile, TriangleId, TriangleOf};
use paint::paint;
use ways::Ways;
use web::{Place, Web};

/// Most pieces of one picture: each takes about 300 bytes while it is made.
pub const MAX_PIECES: usize = 4_000_000;

/// How a view becomes vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SvgOptions {
    /// How far a colour may be from the picture's, in steps of 8 bits, above 0.
    pub tolerance: f32,
    /// The most pieces, [`MAX_PIECES`] or less.
    pub max_pieces: usize,
}

impl Default for SvgOptions {
    fn default() -> Self {
        Self { tolerance: 2.0, max_pieces: MAX_PIECES }
    }
}

/// A picture as vectors.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Svg {
    /// The document.
    pub text: String,
    /// Triangles of the scene, and parts of cut ones, that are painted.
    pub faces: usize,
    /// Pieces of nearly one colour.
    pub pieces: usize,
    /// Areas that are painted, each of them a path.
    pub paths: usize,
}

impl Renderer {
    /// Draws a view as SVG. Light, textures and fog are those of the picture, looked at where colours
    /// change; edges aren't drawn. Pieces less than half a pixel wide get one
    /// colour.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible, or has too many pieces.
    pub fn svg(&self, view: &View, options: &SvgOptions) -> Result<Svg, RenderError> {
        // What subdivided shading approximates is what this approximates.
        let mode = match view.shading.mode {
            ShadingMode::Subdivided { .. } => ShadingMode::Phong,
            mode => mode,
        };
        let shading = Shading { mode, ..view.shading };
        let view = view.clone().with_shading(shading).with_edges(None);
        let needs = FrameNeeds { samples: Samples::new(16), ..FrameNeeds::PICTURE };
        self.with_scene(&view, &needs, |scene, cutouts| {
            let seen = seen(self, scene, cutouts);
            draw(self, scene, &view, options, &seen)
        })?
    }
}

/// A bit for each opaque triangle that a sample sees.
struct SeenBits(Vec<u64>);

impl SeenBits {
    fn holds(&self, id: TriangleId) -> bool {
        self.0.get(id.0 as usize / 64).is_some_and(|bits| bits >> (id.0 % 64) & 1 == 1)
    }
}

fn seen(renderer: &Renderer, scene: &ShadingContext<'_>, cutouts: &AlphaTest<'_>) -> SeenBits {
    let numbers = scene.frame.tiles_by_load();
    let tiles: Vec<Vec<u32>> = luxel_parallel::map(numbers.len(), 1, &|run| {
        let mut tile = Tile::new(scene.frame.samples().count());
        let holes = cutouts.finder(scene.frame, renderer.level());
        scene.frame.draw_opaque(renderer.level(), numbers[run.start] as usize, &holes, &mut tile);
        let ids = tile.planes().iter().flat_map(|plane| plane.ids.as_flattened());
        let mut ids: Vec<u32> = ids.copied().filter(|&id| id != TriangleId::NONE.0).collect();
        ids.sort_unstable();
        ids.dedup();
        ids
    });
    let most = tiles.iter().flatten().max().map_or(0, |&id| id as usize / 64 + 1);
    let mut bits = vec![0; most];
    for &id in tiles.iter().flatten() {
        bits[id as usize / 64] |= 1 << (id % 64);
    }
    SeenBits(bits)
}

fn draw(
    renderer: &Renderer,
    scene: &ShadingContext<'_>,
    view: &View,
    options: &SvgOptions,
    seen: &SeenBits,
) -> Result<Svg, RenderError> {
    let limit = options.max_pieces.min(MAX_PIECES);
    let too_many = || RenderError::TooManyPieces(limit);
    let window = [f64::from(view.size.width), f64::from(view.size.height)];
    let mut web = Web::default();
    let mut faces = visible_faces(&mut web, scene, view, seen);
    if faces.len() > limit {
        return Err(too_many());
    }
    let order = order::order(&mut web, &mut faces, window, limit);
    let tolerance = options.tolerance.max(0.01);
    let sampler = Sampler::new(scene, renderer.level());
    let mut flattener = Flattener { web: &mut web, sampler, tolerance, pieces: Vec::new(), limit };
    let count = faces.len();
    let hiding: Hiding = faces
        .iter()
        .map(|face| if face.opaque { face.places(flattener.web) } else { Vec::new() })
        .collect();
    for (number, face) in (0..).zip(faces) {
        for polygon in face.polygons {
            if !flattener.flatten(number, face.id, polygon) {
                return Err(too_many());
            }
        }
    }
    let mut pieces = std::mem::take(&mut flattener.pieces);
    let mut needed = needed(&web, &pieces, &Ways::new(&web, &pieces), &order, &hiding).into_iter();
    pieces.retain(|_| needed.next().unwrap_or(true));
    let mut document = Document::default();
    let range = largest_range(tolerance);
    let silhouette = paint(&web, &pieces, order, range, |area| document.area(area));
    let paths = document.paths;
    Ok(Svg { text: document.finish(view, &silhouette), faces: count, pieces: pieces.len(), paths })
}

/// All faces that may be seen, in the order of the scene.
fn visible_faces(
    web: &mut Web,
    scene: &ShadingContext<'_>,
    view: &View,
    seen: &SeenBits,
) -> Vec<Face> {
    let frame = scene.frame;
    let mut ids: Vec<(u64, TriangleId, TriangleOf)> = frame
        .triangle_ids()
        .filter_map(|id| {
            let of = frame.triangle(id)?;
            Some(((of.instance as u64) << 32 | u64::from(of.triangle), id, of))
        })
        .collect();
    ids.sort_unstable_by_key(|(number, ..)| *number);
    let mut clipper = Clipper::new(&view.camera.projection, view.size);
    let mut clipped: Vec<InWindow> = Vec::new();
    let (mut faces, mut known, mut places, mut depths) =
        (Vec::new(), Vec::new(), Vec::<Place>::new(), Vec::new());
    for (number, id, of) in ids {
        clipper.clipped(&frame.corners_in_view(of), &mut clipped);
        let part = frame.use_of(of);
        if clipped.is_empty() || is_culled(&clipped, part.cull) {
            continue;
        }
        places.clear();
        places.extend(clipped.iter().map(|corner| corner.place));
        depths.clear();
        depths.extend(clipped.iter().map(|corner| corner.depth));
        let opaque = part.coverage == Coverage::Opaque;
        if let Some(face) = Face::new(web, id, number, opaque, &places, &depths) {
            let face = face.with_rank(frame.rank_of(of), &depths);
            known.push(seen.holds(id));
            faces.push(face);
        }
    }
    let grid = Grid::new(&faces, [f64::from(view.size.width), f64::from(view.size.height)], &known);
    let asked: Vec<u32> = (0..faces.len() as u32).filter(|&face| !known[face as usize]).collect();
    let hidden = for_each(&asked, |face| {
        (face, order::is_hidden(web, &faces, &grid, &faces[face as usize]))
    });
    for (face, hidden) in hidden {
        known[face as usize] = !hidden;
    }
    let mut shown = known.into_iter();
    faces.retain(|_| shown.next().unwrap_or(true));
    faces
}
