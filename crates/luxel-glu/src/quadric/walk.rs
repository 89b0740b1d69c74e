//! From a grid of corners to points, lines and facets.

use super::{DrawStyle, Normals, Orientation, Quadric};
use crate::drawing::Drawing;

const POINTS: u32 = 0;
const LINE_STRIP: u32 = 3;
const QUADS: u32 = 7;
const QUAD_STRIP: u32 = 8;

/// A corner of a facet.
pub(super) struct Corner {
    pub(super) position: [f64; 3],
    /// The surface's normal there, outwards.
    pub(super) normal: [f64; 3],
    pub(super) texture: [f64; 2],
}

/// A shape: columns `0..=across` by rows `0..=up`.
pub(super) trait Shape {
    /// Steps across.
    fn across(&self) -> u32;
    /// Steps up.
    fn up(&self) -> u32;
    /// Whether the last column is the first.
    fn is_closed(&self) -> bool;
    /// Whether the row is a single point.
    fn is_point(&self, row: u32) -> bool;
    /// The corner at a column and a row. Both may lie between two: so they give the normal of the facet there.
    fn corner(&self, column: f64, row: f64) -> Corner;
    /// The rows that a silhouette draws.
    fn silhouette_rows(&self) -> Vec<u32>;
    /// The columns that a silhouette draws.
    fn silhouette_columns(&self) -> Vec<u32>;
}

/// Draws `shape`.
pub(super) fn draw(quadric: &Quadric, shape: &impl Shape, drawing: &mut impl Drawing) {
    let mut walk = Walk { quadric, shape, drawing };
    match quadric.draw_style {
        DrawStyle::Point => walk.points(),
        DrawStyle::Line => {
            walk.rows(&(0..=shape.up()).collect::<Vec<_>>());
            walk.columns(&columns(shape));
        }
        DrawStyle::Silhouette => {
            walk.rows(&shape.silhouette_rows());
            walk.columns(&shape.silhouette_columns());
        }
        DrawStyle::Fill if quadric.normals == Normals::Flat => walk.flat_facets(),
        DrawStyle::Fill => walk.smooth_facets(),
    }
}

/// All columns, each once.
pub(super) fn columns(shape: &impl Shape) -> Vec<u32> {
    let last = if shape.is_closed() { shape.across() } else { shape.across() + 1 };
    (0..last).collect()
}

struct Walk<'a, S, D> {
    quadric: &'a Quadric,
    shape: &'a S,
    drawing: &'a mut D,
}

impl<S: Shape, D: Drawing> Walk<'_, S, D> {
    fn points(&mut self) {
        self.drawing.begin(POINTS);
        for row in 0..=self.shape.up() {
            for column in columns(self.shape) {
                self.vertex(column, row, true);
            }
        }
        self.drawing.end();
    }

    fn rows(&mut self, rows: &[u32]) {
        for &row in rows.iter().filter(|row| !self.shape.is_point(**row)) {
            self.drawing.begin(LINE_STRIP);
            for column in 0..=self.shape.across() {
                self.vertex(column, row, true);
            }
            self.drawing.end();
        }
    }

    fn columns(&mut self, columns: &[u32]) {
        for &column in columns {
            self.drawing.begin(LINE_STRIP);
            for row in 0..=self.shape.up() {
                self.vertex(column, row, true);
            }
            self.drawing.end();
        }
    }

    fn smooth_facets(&mut self) {
        for row in 0..self.shape.up() {
            self.drawing.begin(QUAD_STRIP);
            for column in 0..=self.shape.across() {
                for row in self.counterclockwise(row) {
                    self.vertex(column, row, true);
                }
            }
            self.drawing.end();
        }
    }

    /// Quads of their own, since neighbours have other normals; the corner that flat shading lights is that of a strip.
    fn flat_facets(&mut self) {
        for row in 0..self.shape.up() {
            self.drawing.begin(QUADS);
            for column in 0..self.shape.across() {
                let middle = self.shape.corner(f64::from(column) + 0.5, f64::from(row) + 0.5);
                self.normal(middle.normal);
                let [first, second] = self.counterclockwise(row);
                self.vertex(column + 1, first, false);
                self.vertex(column, first, false);
                self.vertex(column, second, false);
                self.vertex(column + 1, second, false);
            }
            self.drawing.end();
        }
    }

    /// A row and the next one, in the order in which a strip's quads are counter-clockwise.
    fn counterclockwise(&self, row: u32) -> [u32; 2] {
        match self.quadric.orientation {
            Orientation::Outside => [row, row + 1],
            Orientation::Inside => [row + 1, row],
        }
    }

    fn vertex(&mut self, column: u32, row: u32, with_normal: bool) {
        let corner = self.shape.corner(column.into(), row.into());
        if with_normal && self.quadric.normals != Normals::None {
            self.normal(corner.normal);
        }
        if self.quadric.textured {
            self.drawing.tex_coord(corner.texture);
        }
        self.drawing.vertex(corner.position);
    }

    fn normal(&mut self, outwards: [f64; 3]) {
        self.drawing.normal(match self.quadric.orientation {
            Orientation::Outside => outwards,
            Orientation::Inside => outwards.map(|x| -x),
        });
    }
}
