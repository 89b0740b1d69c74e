//! What covers pixels.

use super::smooth::Figure;
use crate::primitive::line::{LineWalk, major_axis};
use luxel_visibility::{DepthPlane, Triangle};

/// The two ends of a line that clipping has left.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineEnds {
    /// In steps of 1/256 pixel.
    pub(crate) places: [[i32; 2]; 2],
    pub(crate) depths: [f32; 2],
    /// Of each the weights of three vertices.
    pub(crate) weights: [[f32; 3]; 2],
    pub(crate) w: [f64; 2],
}

impl LineEnds {
    /// The axis that the line runs more along: 0 for x, 1 for y.
    #[inline(always)]
    pub(crate) fn major(&self) -> usize {
        major_axis(self.places[0], self.places[1])
    }

    /// The fragments of the line.
    #[inline]
    pub(crate) fn walk(&self) -> LineWalk {
        LineWalk::new(self.places[0], self.places[1])
    }
}

/// What covers pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    Triangle(Triangle),
    /// A column of pixels across each fragment of a line; the counter of stipples where it begins.
    Line {
        line: LineEnds,
        width: i32,
        counter: u32,
    },
    /// The part of a smooth polygon that one of its triangles colours: the outline's number among those of the pieces, and
    /// the triangle's in the outline; its depths.
    Smooth {
        outline: u32,
        triangle: u32,
        depth: DepthPlane,
    },
    /// Left and bottom of the batch's bitmap; its depth.
    Bitmap {
        corner: [i32; 2],
        depth: f32,
    },
    /// The batch's image; its depth, unless it has depths of its own.
    Image {
        depth: f32,
    },
    /// A rectangle about a line, which may end within pixels; the counter unless it is never stippled.
    Band {
        line: LineEnds,
        width: f32,
        counter: Option<u32>,
    },
    /// A disc, which may end within pixels: its centre in steps of 1/256 pixel, and its diameter; its depth, and the
    /// weights of three vertices.
    Disc {
        centre: [i32; 2],
        size: f32,
        depth: f32,
        weights: [f32; 3],
    },
    /// Left, bottom, and the side of a square of pixels; its depth, and the weights of three vertices.
    Point {
        corner: [i32; 2],
        side: i32,
        depth: f32,
        weights: [f32; 3],
    },
}

impl Shape {
    /// The figure of a shape that may end within pixels; `None` for others, and for a line that is a place.
    pub(super) fn figure(&self) -> Option<Figure> {
        match *self {
            Self::Band { line, width, .. } => Figure::band(line.places, width),
            Self::Disc { centre, size, .. } => Some(Figure::disc(centre, size)),
            _ => None,
        }
    }
}
