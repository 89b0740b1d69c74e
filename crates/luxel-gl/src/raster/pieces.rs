//! The pieces of a batch: what covers pixels, and what shades them.

use super::batch::Batch;
use super::outline::Outline;
use super::shape::Shape;
use crate::vertex::UsedVertices;
use luxel_visibility::{CullFaces, TILE, Triangle, WindowVertex};

/// Where a primitive's colours come from: three vertices of the batch, of which a line has two and a point one; in flat
/// shading the colour of one vertex; of which side.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Shade {
    pub(crate) corners: [u32; 3],
    pub(crate) flat: Option<u32>,
    pub(crate) side: u8,
}

/// A part of a primitive. Most are triangles as their vertices lie in the window, which are set up where they are drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) shade: Shade,
    /// What its depths are moved by, in steps of the buffer.
    pub(crate) offset: f32,
    /// The place of its shape among the others; [`OF_CORNERS`] for the triangle of its corners.
    shape: u32,
    tiles: [u8; 4],
}

/// In the place of a shape.
const OF_CORNERS: u32 = u32::MAX;

impl Piece {
    /// The tiles that it may reach: the first and the last column and row.
    pub(super) fn tiles(&self) -> [usize; 4] {
        self.tiles.map(usize::from)
    }

    /// Whether it is the triangle of its corners, as they lie in the window.
    #[inline(always)]
    pub(super) fn is_of_corners(&self) -> bool {
        self.shape == OF_CORNERS
    }

    /// Its corners in the window.
    #[inline(always)]
    pub(super) fn corners(&self, batch: &Batch) -> [WindowVertex; 3] {
        self.shade.corners.map(|corner| batch.vertices.window[corner as usize])
    }

    /// The triangle of its corners, set up.
    #[inline(always)]
    pub(super) fn triangle(&self, batch: &Batch) -> Option<Triangle> {
        Triangle::new(self.corners(batch), CullFaces::None)
    }
}

/// Pieces of one batch in the order of its primitives.
#[derive(Debug, Default)]
pub(crate) struct Pieces {
    list: Vec<Piece>,
    shapes: Vec<Shape>,
    /// Of smooth polygons.
    outlines: Vec<Outline>,
}

impl Pieces {
    /// One shape in the colours of the batch's first vertex.
    pub(crate) fn of_raster(batch: &Batch, shape: Shape) -> Self {
        let mut pieces = Self::default();
        pieces.push(batch, shape, Shade::default(), 0.0);
        pieces
    }

    /// Appends a shape, unless it reaches no pixel.
    pub(super) fn push(&mut self, batch: &Batch, shape: Shape, shade: Shade, offset: f32) {
        let bounds = match shape {
            Shape::Smooth { outline, triangle, .. } => {
                let [left, bottom, right, top] = self.outline(outline).bounds(triangle as usize);
                let [l, b, r, t] = batch.polygon_region;
                [left.max(l), bottom.max(b), right.min(r), top.min(t)]
            }
            _ => batch.bounds(&shape),
        };
        if let Some(tiles) = tiles(bounds) {
            self.list.push(Piece { shade, offset, shape: self.shapes.len() as u32, tiles });
            self.shapes.push(shape);
        }
    }

    /// Appends the triangle of a primitive's corners, which reaches some tiles: the first and the last column and row.
    #[inline(always)]
    pub(super) fn push_triangle(&mut self, tiles: [u8; 4], shade: Shade, offset: f32) {
        self.list.push(Piece { shade, offset, shape: OF_CORNERS, tiles });
    }

    /// Keeps an outline: its number.
    pub(super) fn put_outline(&mut self, outline: Outline) -> u32 {
        self.outlines.push(outline);
        self.outlines.len() as u32 - 1
    }

    /// The outline with a number.
    pub(super) fn outline(&self, number: u32) -> &Outline {
        &self.outlines[number as usize]
    }

    /// Takes note of the vertices whose colours are used.
    pub(crate) fn note(&self, used: &UsedVertices) {
        for Piece { shade: Shade { corners, flat, .. }, .. } in &self.list {
            for &vertex in corners.iter().chain(flat) {
                used.note(vertex);
            }
        }
    }

    /// All of them.
    pub(super) fn list(&self) -> &[Piece] {
        &self.list
    }

    /// A piece's shape; `None` for the triangle of its corners.
    #[inline(always)]
    pub(super) fn shape(&self, piece: &Piece) -> Option<&Shape> {
        self.shapes.get(piece.shape as usize)
    }

    /// Bytes that they take.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self.list.as_slice())
            + size_of_val(self.shapes.as_slice())
            + self.outlines.iter().map(Outline::bytes).sum::<usize>()
    }

    /// How many there is room for.
    pub(super) fn capacity(&self) -> usize {
        self.list.capacity().max(self.shapes.capacity()).max(self.outlines.capacity())
    }

    pub(super) fn clear(&mut self) {
        self.list.clear();
        self.shapes.clear();
        self.outlines.clear();
    }
}

/// The tiles of some pixels; `None` without any.
#[inline(always)]
fn tiles([left, bottom, right, top]: [i32; 4]) -> Option<[u8; 4]> {
    let some = left < right && bottom < top;
    // A side of a framebuffer is 256 tiles at most.
    some.then(|| [left, bottom, right - 1, top - 1].map(|at| (at / TILE) as u8))
}
