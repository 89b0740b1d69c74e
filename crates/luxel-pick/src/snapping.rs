//! Snapping: vertices and edges close to a window position, points and lines within a tolerance.

use crate::surface_hit::{Element, PickHit};
use crate::view::PickView;
use crate::window::PhysicalPosition;
use glam::{DVec3, DVec4};

/// A vertex near a place of the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearVertex {
    /// The position, by its place in the object's mesh.
    pub index: u32,
    /// Where it lies in the world.
    pub position: DVec3,
    /// Where it lies in the window, in pixels.
    pub window: [f64; 2],
    /// How far from the place asked about, in pixels.
    pub pixels: f64,
}

/// The nearest place of an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearEdge {
    /// The edge's ends, by their places in the object's mesh.
    pub vertices: [u32; 2],
    /// The place on the edge, in the world.
    pub position: DVec3,
    /// Where it lies in the window, in pixels.
    pub window: [f64; 2],
    /// How far from the place asked about, in pixels.
    pub pixels: f64,
}

/// The polygon of the file that a hit triangle is part of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearPolygon {
    /// Its number in the mesh: the triangle's own where the file has triangles.
    pub number: u32,
    /// Its corner that lies nearest in the window; `None` if none lies before the near plane.
    pub vertex: Option<NearVertex>,
    /// Its edge that comes nearest in the window.
    pub edge: Option<NearEdge>,
}

/// What to snap to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SnapTo {
    /// Corners of polygons.
    Vertex,
    /// Edges of polygons.
    Edge,
    /// Surfaces.
    Face,
}

/// What a place of the window snaps to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapped {
    /// The object, by its place in [`Picker::objects`](crate::Picker::objects).
    pub object: usize,
    /// A triangle there that is seen.
    pub triangle: u32,
    /// What of it, and where.
    pub to: SnappedTo,
}

/// See [`Snapped`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SnappedTo {
    /// A corner of a polygon.
    Vertex(NearVertex),
    /// A place on an edge of a polygon.
    Edge(NearEdge),
    /// A place on a surface.
    Face {
        /// Where it lies in the world.
        position: DVec3,
        /// Where it lies in the window, in pixels.
        window: [f64; 2],
        /// How far from the place asked about, in pixels.
        pixels: f64,
    },
}

impl PickView<'_> {
    /// The polygon of a hit, with its vertex and edge that lie nearest to the hit in the window;
    /// `None` for points and lines.
    #[must_use]
    pub fn polygon_of(&self, hit: &PickHit) -> Option<NearPolygon> {
        let Element::Triangle(triangle) = hit.element else { return None };
        let [x, y] = self.window_of(hit.position)?;
        Some(self.polygon_near(hit.object, triangle, [x, y]))
    }

    /// What is seen within `tolerance` pixels of a place and lies nearest to it: a vertex or edge of
    /// a polygon, or a surface. `None` if there is nothing. Points and lines don't hold a cursor.
    #[must_use]
    pub fn snap(
        &self,
        place: impl Into<PhysicalPosition>,
        to: SnapTo,
        tolerance: f64,
    ) -> Option<Snapped> {
        let [x, y] = place.into().to_array();
        let mut best: Option<(f64, Snapped)> = None;
        let mut asked = std::collections::BTreeSet::new();
        for [px, py] in around(x, y, tolerance) {
            let Some((object, Element::Triangle(triangle))) = self.owner_at([px, py]) else {
                continue;
            };
            if to != SnapTo::Face && !asked.insert((object, triangle)) {
                continue;
            }
            let found = match to {
                SnapTo::Vertex => self
                    .polygon_near(object, triangle, [x, y])
                    .vertex
                    .map(|vertex| (vertex.pixels, SnappedTo::Vertex(vertex))),
                SnapTo::Edge => self
                    .polygon_near(object, triangle, [x, y])
                    .edge
                    .map(|edge| (edge.pixels, SnappedTo::Edge(edge))),
                SnapTo::Face => self.at([px, py]).map(|hit| {
                    let (dx, dy) = (px - x, py - y);
                    let pixels = (dx * dx + dy * dy).sqrt();
                    let (position, window) = (hit.position, [px, py]);
                    (pixels, SnappedTo::Face { position, window, pixels })
                }),
            };
            if let Some((pixels, to)) = found
                && pixels <= tolerance
                && best.is_none_or(|(least, _)| pixels < least)
            {
                best = Some((pixels, Snapped { object, triangle, to }));
            }
            // Places come nearest first.
            if to == SnapTo::Face && best.is_some() {
                break;
            }
        }
        best.map(|(_, snapped)| snapped)
    }

    /// The nearest point or line that is seen within `tolerance` pixels of a place.
    #[must_use]
    pub fn stroke_near(
        &self,
        place: impl Into<PhysicalPosition>,
        tolerance: f64,
    ) -> Option<PickHit> {
        let [x, y] = place.into().to_array();
        if self.placed.strokes().is_empty() {
            return None;
        }
        around(x, y, tolerance).into_iter().find_map(|[px, py]| {
            let (_, element) = self.owner_at([px, py])?;
            let is_stroke = !matches!(element, Element::Triangle(_));
            if is_stroke { self.at([px, py]) } else { None }
        })
    }

    /// Where a place of the world lies in the window, in pixels from the upper left; `None` before
    /// the near plane and beyond the far one.
    #[must_use]
    pub fn window_of(&self, place: DVec3) -> Option<[f64; 2]> {
        let clip = self.clip_of(place);
        (is_between_planes(clip)).then(|| self.window_of_clip(clip))
    }

    fn clip_of(&self, place: DVec3) -> DVec4 {
        let projection = self.camera().projection.clip_from_view(self.size());
        projection * (self.camera().view_from_world * place.extend(1.0))
    }

    fn window_of_clip(&self, clip: DVec4) -> [f64; 2] {
        [
            (clip.x / clip.w + 1.0) * 0.5 * f64::from(self.size().width),
            (1.0 - clip.y / clip.w) * 0.5 * f64::from(self.size().height),
        ]
    }

    fn polygon_near(&self, object: usize, triangle: u32, [x, y]: [f64; 2]) -> NearPolygon {
        let mesh = self.picker.mesh(object);
        let world_from_mesh = &self.picker.objects[object].world_from_mesh;
        let place = |vertex: u32| world_from_mesh.transform_point3(mesh.position(vertex));
        let from_asked = |[px, py]: [f64; 2]| ((px - x) * (px - x) + (py - y) * (py - y)).sqrt();
        // The polygon's triangles follow one another.
        let at = triangle as usize;
        let (number, run) = match &mesh.polygons {
            None => (triangle, at..at + 1),
            Some(polygons) => {
                let number = polygons[at];
                let before =
                    polygons[..at].iter().rev().take_while(|other| **other == number).count();
                let after = polygons[at..].iter().take_while(|other| **other == number).count();
                (number, at - before..at + after)
            }
        };
        // An edge inside of the polygon runs through two of its triangles, once each way.
        let mut edges: Vec<[u32; 2]> =
            mesh.triangles[run].iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
        edges.sort_unstable();
        let mut polygon = NearPolygon { number, vertex: None, edge: None };
        for &[from, to] in &edges {
            if edges.binary_search(&[to, from]).is_ok() && from != to {
                continue;
            }
            let position = place(from);
            if let Some(window) = self.window_of(position) {
                let pixels = from_asked(window);
                if polygon.vertex.is_none_or(|vertex| pixels < vertex.pixels) {
                    polygon.vertex = Some(NearVertex { index: from, position, window, pixels });
                }
            }
            let ends = [position, place(to)];
            if let Some((along, window)) = self.nearest_on(ends, [x, y]) {
                let pixels = from_asked(window);
                if polygon.edge.is_none_or(|edge| pixels < edge.pixels) {
                    let position = ends[0] + (ends[1] - ends[0]) * along;
                    let vertices = [from, to];
                    polygon.edge = Some(NearEdge { vertices, position, window, pixels });
                }
            }
        }
        polygon
    }

    /// The place of a line in the world that lies nearest in the window: how far along, and where in
    /// the window. `None` if no part lies between the near and far planes.
    fn nearest_on(&self, ends: [DVec3; 2], [x, y]: [f64; 2]) -> Option<(f64, [f64; 2])> {
        let [from, to] = ends.map(|end| self.clip_of(end));
        let mut part = [0.0_f64, 1.0_f64];
        for (a, b) in [(from.w + from.z, to.w + to.z), (from.w - from.z, to.w - to.z)] {
            match (a < 0.0, b < 0.0) {
                (true, true) => return None,
                (true, false) => part[0] = part[0].max(a / (a - b)),
                (false, true) => part[1] = part[1].min(a / (a - b)),
                (false, false) => {}
            }
        }
        if part[0] > part[1] {
            return None;
        }
        let at = |along: f64| from + (to - from) * along;
        let [start, end] = part.map(at);
        let [p, q] = [start, end].map(|clip| self.window_of_clip(clip));
        let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
        let squared = dx * dx + dy * dy;
        let dot = (x - p[0]) * dx + (y - p[1]) * dy;
        let t = if squared > 0.0 { (dot / squared).clamp(0.0, 1.0) } else { 0.0 };
        // A step along the edge in the window is a perspective one along it in the world.
        let (from, to) = ((1.0 - t) / start.w, t / end.w);
        let along = part[0] + (part[1] - part[0]) * (to / (from + to));
        Some((along, [p[0] + dx * t, p[1] + dy * t]))
    }
}

fn is_between_planes(clip: DVec4) -> bool {
    clip.w + clip.z >= 0.0 && clip.w - clip.z >= 0.0 && clip.w > 0.0
}

/// A place, then the centres of the pixels around it within a distance, nearest first.
fn around(x: f64, y: f64, tolerance: f64) -> Vec<[f64; 2]> {
    let reach = tolerance.clamp(0.0, 256.0).ceil() as i64;
    let mut places = Vec::new();
    for row in -reach..=reach {
        for column in -reach..=reach {
            let place = [x.floor() + 0.5 + column as f64, y.floor() + 0.5 + row as f64];
            let (dx, dy) = (place[0] - x, place[1] - y);
            let squared = dx * dx + dy * dy;
            if squared <= tolerance * tolerance {
                places.push((squared, place));
            }
        }
    }
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    std::iter::once([x, y]).chain(places.into_iter().map(|(_, place)| place)).collect()
}
