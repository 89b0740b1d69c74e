//! Faces: what clipping left of the triangles of a frame, with their places in the window and in
//! depth, and which of them may lie in one place.

use super::convex::bounds;
use super::web::{Place, Polygon, Web};
use luxel_math::SUBPIXELS;
use luxel_visibility::{TriangleId, rank_step};

/// A triangle, or a part of one, in the window.
#[derive(Clone, Debug)]
pub(super) struct Face {
    pub(super) id: TriangleId,
    /// Its place in the order of the scene.
    pub(super) number: u64,
    /// Whether it hides what lies behind it.
    pub(super) opaque: bool,
    /// Window depth a x + b y + c.
    plane: [f64; 3],
    pub(super) bounds: [f64; 4],
    /// Convex parts that don't overlap; one, but where ways round were cut.
    pub(super) polygons: Vec<Polygon>,
}

impl Face {
    /// `depths` are those of `places`; `None` for what is seen edge-on.
    pub(super) fn new(
        web: &mut Web,
        id: TriangleId,
        number: u64,
        opaque: bool,
        places: &[Place],
        depths: &[f64],
    ) -> Option<Self> {
        let plane = plane(places, depths)?;
        let polygon = web.polygon(places)?;
        let bounds = bounds(places.iter().copied());
        Some(Self { id, number, opaque, plane, bounds, polygons: vec![polygon] })
    }

    /// The same face with a [rank](luxel_scene::CoplanarRanks) among those in its plane, as pictures show it.
    pub(super) fn with_rank(mut self, rank: u8, depths: &[f64]) -> Self {
        let steps = f64::from(SUBPIXELS);
        let slope = [self.plane[0] / steps, self.plane[1] / steps];
        // Depth is reversed there.
        let nearest = 1.0 - depths.iter().copied().fold(1.0, f64::min);
        self.plane[2] += f64::from(rank) * rank_step(slope, nearest);
        self
    }

    /// A part of this face.
    pub(super) fn part(&self, web: &Web, polygons: Vec<Polygon>) -> Self {
        let bounds = bounds(polygons.iter().flat_map(|polygon| web.places(polygon)));
        Self { bounds, polygons, ..self.clone() }
    }

    /// Window depth at a place of its plane.
    pub(super) fn depth(&self, [x, y]: Place) -> f64 {
        self.plane[0] * x + self.plane[1] * y + self.plane[2]
    }

    pub(super) fn places(&self, web: &Web) -> Vec<Vec<Place>> {
        self.polygons.iter().map(|polygon| web.places(polygon).collect()).collect()
    }

    pub(super) fn is_apart(&self, other: &Self) -> bool {
        let ([left, top, right, bottom], [l, t, r, b]) = (self.bounds, other.bounds);
        r <= left || l >= right || b <= top || t >= bottom
    }
}

/// The plane through the places that make the largest triangle with the first.
fn plane(places: &[Place], depths: &[f64]) -> Option<[f64; 3]> {
    let [x0, y0] = *places.first()?;
    let z0 = *depths.first()?;
    let mut best = (0.0_f64, [0.0; 3]);
    for at in 1..places.len().saturating_sub(1) {
        let [(x1, y1, z1), (x2, y2, z2)] =
            [at, at + 1].map(|at| (places[at][0] - x0, places[at][1] - y0, depths[at] - z0));
        let area = x1 * y2 - x2 * y1;
        if area.abs() > best.0.abs() {
            let (a, b) = ((z1 * y2 - z2 * y1) / area, (x1 * z2 - x2 * z1) / area);
            best = (area, [a, b, z0 - a * x0 - b * y0]);
        }
    }
    (best.0.abs() > 1e-9 && best.1.iter().all(|value| value.is_finite())).then_some(best.1)
}

/// The window in cells, each with the faces that may reach into it.
pub(super) struct Grid {
    side: f64,
    across: usize,
    down: usize,
    /// Where each cell's faces begin, and the end of all.
    starts: Vec<u32>,
    faces: Vec<u32>,
}

impl Grid {
    /// Of the faces that `takes` takes.
    pub(super) fn new(faces: &[Face], [width, height]: [f64; 2], takes: &[bool]) -> Self {
        // About as many cells as faces, of at least 4 pixels.
        let count = takes.iter().filter(|takes| **takes).count().max(1) as f64;
        let side = (width * height / count).sqrt().max(4.0);
        let [across, down] = [width, height].map(|extent| (extent / side).ceil().max(1.0) as usize);
        let mut grid = Self { side, across, down, starts: Vec::new(), faces: Vec::new() };
        let taken = || faces.iter().zip(takes).enumerate().filter(|(_, (_, takes))| **takes);
        let mut starts = vec![0_u32; across * down + 1];
        for (_, (face, _)) in taken() {
            grid.cells(face.bounds, |cell| starts[cell + 1] += 1);
        }
        for cell in 0..across * down {
            starts[cell + 1] += starts[cell];
        }
        let mut next = starts.clone();
        let mut list = vec![0; starts[across * down] as usize];
        for (number, (face, _)) in taken() {
            grid.cells(face.bounds, |cell| {
                list[next[cell] as usize] = number as u32;
                next[cell] += 1;
            });
        }
        (grid.starts, grid.faces) = (starts, list);
        grid
    }

    fn cells(&self, [left, top, right, bottom]: [f64; 4], mut visit: impl FnMut(usize)) {
        let cell = |at: f64, count: usize| ((at / self.side) as usize).min(count - 1);
        for row in cell(top, self.down)..=cell(bottom, self.down) {
            for column in cell(left, self.across)..=cell(right, self.across) {
                visit(row * self.across + column);
            }
        }
    }

    /// Visits the faces whose boxes share a part of the window with a face's, each once, until
    /// `visit` says that it is enough.
    pub(super) fn near(&self, faces: &[Face], face: &Face, mut visit: impl FnMut(u32) -> bool) {
        let [left, top, ..] = face.bounds;
        let cell = |at: f64, count: usize| ((at / self.side) as usize).min(count - 1);
        let mut enough = false;
        self.cells(face.bounds, |number| {
            if enough {
                return;
            }
            let (column, row) = (number % self.across, number / self.across);
            let (start, end) = (self.starts[number] as usize, self.starts[number + 1] as usize);
            for &other in &self.faces[start..end] {
                let there = &faces[other as usize];
                // In the first of the cells that both reach.
                let first = |a: f64, b: f64, count: usize| cell(a.max(b), count);
                if first(left, there.bounds[0], self.across) == column
                    && first(top, there.bounds[1], self.down) == row
                    && !face.is_apart(there)
                {
                    enough = visit(other);
                    if enough {
                        return;
                    }
                }
            }
        });
    }
}

/// Runs a question for many faces on all threads; the answers keep their order.
pub(super) fn for_each<T: Send>(faces: &[u32], ask: impl Fn(u32) -> T + Sync) -> Vec<T> {
    luxel_parallel::gather(faces.len(), 64, &|run, found| {
        found.extend(faces[run].iter().map(|&face| ask(face)));
    })
}
