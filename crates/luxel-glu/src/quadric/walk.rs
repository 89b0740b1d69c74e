//! From a grid of corners to points, lines and facets.

use super::{DrawStyle, Normals, Orientation, Quadric};
use crate::drawing::Drawing;

const POINTS: u32 = 0;
const LINE_STRIP: u32 = 3;
const TRIANGLE_FAN: u32 = 6;
const QUADS: u32 = 7;
const QUAD_STRIP: u32 = 8;

/// A corner of a facet.
pub(super) struct Corner {
    pub(super) position: [f64; 3],
    /// The surface's normal there, outwards.
    pub(super) normal: [f64; 3],
    pub(super) texture: [f64; 2],
}

/// Steps across and up: columns `0..=across` by rows `0..=up`.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    pub(super) across: u32,
    pub(super) up: u32,
}

/// A surface over parts of the way across and up, from 0 to 1.
pub(super) trait Shape {
    /// Whether facets beside each other lie in different planes, so that a silhouette draws the edges between them.
    const IS_CURVED_ACROSS: bool;
    /// The same of facets above each other.
    const IS_CURVED_UP: bool;
    /// Whether lines come from the last row on, and run from there to the first one, as those of SGI's library do: which
    /// pixels they have depends on it.
    const LINES_RUN_DOWN: bool = false;
    /// Whether the last column is the first.
    fn is_closed(&self) -> bool {
        true
    }
    /// Whether the first row is a single point, and whether the last one is.
    fn ends_in_points(&self) -> [bool; 2];
    /// Whether smooth facets about such a point are a fan, as SGI's library makes them: flat shading lights each of them by
    /// a corner of its own then. Else the point is a corner of each.
    fn has_fans(&self, textured: bool) -> bool {
        let _ = textured;
        false
    }
    /// The surface there.
    fn corner(&self, across: f64, up: f64) -> Corner;
}

/// Draws `shape`.
pub(super) fn draw(quadric: &Quadric, shape: &impl Shape, grid: Grid, drawing: &mut impl Drawing) {
    let mut walk = Walk { quadric, shape, grid, drawing };
    match quadric.draw_style {
        DrawStyle::Point => walk.points(),
        DrawStyle::Line => walk.lines(true, true),
        DrawStyle::Silhouette => walk.silhouette(),
        DrawStyle::Fill if quadric.normals == Normals::Flat => walk.flat_facets(),
        DrawStyle::Fill => walk.smooth_facets(),
    }
}

struct Walk<'a, S, D> {
    quadric: &'a Quadric,
    shape: &'a S,
    grid: Grid,
    drawing: &'a mut D,
}

impl<S: Shape, D: Drawing> Walk<'_, S, D> {
    /// All columns, each once.
    fn distinct_columns(&self) -> std::ops::Range<u32> {
        let Grid { across, .. } = self.grid;
        0..if self.shape.is_closed() { across } else { across + 1 }
    }

    fn points(&mut self) {
        self.drawing.begin(POINTS);
        for row in 0..=self.grid.up {
            for column in self.distinct_columns() {
                self.vertex(column, row, true);
            }
        }
        self.drawing.end();
    }

    fn silhouette(&mut self) {
        self.lines(S::IS_CURVED_UP, S::IS_CURVED_ACROSS);
    }

    /// The first and the last row and, of surfaces that aren't closed, column; those between if they are wanted.
    fn lines(&mut self, inner_rows: bool, inner_columns: bool) {
        let Grid { across, up } = self.grid;
        for row in self.rows().filter(|&row| inner_rows || row == 0 || row == up) {
            self.row(row);
        }
        let is_end = |column| column == 0 || column == across;
        let has_ends = !self.shape.is_closed();
        for column in self.distinct_columns() {
            if inner_columns || has_ends && is_end(column) {
                self.column(column);
            }
        }
    }

    /// A row, unless it is a single point.
    fn row(&mut self, row: u32) {
        let [first, last] = self.shape.ends_in_points();
        if row == 0 && first || row == self.grid.up && last {
            return;
        }
        self.drawing.begin(LINE_STRIP);
        for column in 0..=self.grid.across {
            self.vertex(column, row, true);
        }
        self.drawing.end();
    }

    fn column(&mut self, column: u32) {
        self.drawing.begin(LINE_STRIP);
        for row in self.rows() {
            self.vertex(column, row, true);
        }
        self.drawing.end();
    }

    /// All rows in the order of lines.
    fn rows(&self) -> impl Iterator<Item = u32> + use<S, D> {
        let up = self.grid.up;
        (0..=up).map(move |row| if S::LINES_RUN_DOWN { up - row } else { row })
    }

    fn smooth_facets(&mut self) {
        let up = self.grid.up;
        let [mut first, mut last] = self.shape.ends_in_points();
        if up < 2 || !self.shape.has_fans(self.quadric.textured) {
            (first, last) = (false, false);
        }
        for row in 0..up {
            if row == 0 && first {
                self.fan(0, 1);
                continue;
            }
            if row + 1 == up && last {
                self.fan(up, row);
                continue;
            }
            self.drawing.begin(QUAD_STRIP);
            for column in 0..=self.grid.across {
                for row in self.counterclockwise(row) {
                    self.vertex(column, row, true);
                }
            }
            self.drawing.end();
        }
    }

    /// The facets between a row that is a point and the row beside it.
    fn fan(&mut self, point: u32, beside: u32) {
        let across = self.grid.across;
        let backwards = (point > beside) == (self.quadric.orientation == Orientation::Outside);
        self.drawing.begin(TRIANGLE_FAN);
        self.vertex(0, point, true);
        for column in 0..=across {
            self.vertex(if backwards { across - column } else { column }, beside, true);
        }
        self.drawing.end();
    }

    /// Quads of their own, since neighbours have other normals; the corner that flat shading lights is that of a strip.
    fn flat_facets(&mut self) {
        for row in 0..self.grid.up {
            self.drawing.begin(QUADS);
            for column in 0..self.grid.across {
                let middle = self.corner(f64::from(column) + 0.5, f64::from(row) + 0.5);
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

    /// The corner at a column and a row. Both may lie between two: so they give the normal of the facet there.
    fn corner(&self, column: f64, row: f64) -> Corner {
        let Grid { across, up } = self.grid;
        self.shape.corner(column / f64::from(across), row / f64::from(up))
    }

    fn vertex(&mut self, column: u32, row: u32, with_normal: bool) {
        let corner = self.corner(column.into(), row.into());
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
