//! Snapping: vertices and edges close to a window position, points and lines within a tolerance.

use crate::surface_hit::{Element, PickHit};
use crate::view::PickView;
use crate::window::PhysicalPosition;
use glam::{DVec3, DVec4};

/// A vertex near a window position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearVertex {
    /// The vertex's index in the object's mesh.
    pub index: u32,
    /// The position in world space.
    pub position: DVec3,
    /// The position in the window, in pixels.
    pub window: [f64; 2],
    /// The distance from the query position, in pixels.
    pub pixels: f64,
}

/// The nearest point of an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearEdge {
    /// The edge's ends, by their indices in the object's mesh.
    pub vertices: [u32; 2],
    /// The point on the edge, in world space.
    pub position: DVec3,
    /// The position in the window, in pixels.
    pub window: [f64; 2],
    /// The distance from the query position, in pixels.
    pub pixels: f64,
}

/// The polygon of the file that contains a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearPolygon {
    /// Its index in the mesh; the triangle's own if the file has triangles.
    pub number: u32,
    /// Its nearest corner in the window; `None` if none lies beyond the near plane.
    pub vertex: Option<NearVertex>,
    /// Its nearest edge in the window.
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

/// The result of snapping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapped {
    /// The object, by its index in [`Picker::objects`](crate::Picker::objects).
    pub object: usize,
    /// A visible triangle of the feature.
    pub triangle: u32,
    /// The feature.
    pub to: SnappedTo,
}

/// A feature that a cursor snaps to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SnappedTo {
    /// A corner of a polygon.
    Vertex(NearVertex),
    /// A point on an edge of a polygon.
    Edge(NearEdge),
    /// A point on a surface.
    Face {
        /// The position in world space.
        position: DVec3,
        /// The position in the window, in pixels.
        window: [f64; 2],
        /// The distance from the query position, in pixels.
        pixels: f64,
    },
}

impl PickView<'_> {
    /// The polygon of a hit, with the vertex and edge nearest to the hit in the window; `None` for points
    /// and lines.
    #[must_use]
    pub fn polygon_of(&self, hit: &PickHit) -> Option<NearPolygon> {
        let Element::Triangle(triangle) = hit.element else { return None };
        let [x, y] = self.window_of(hit.position)?;
        Some(self.nearest_in_polygon(hit.object, triangle, [x, y]))
    }

    /// The nearest visible vertex, edge or surface within `tolerance` pixels of a window position. Points
    /// and lines don't snap.
    #[must_use]
    pub fn snap(
        &self,
        place: impl Into<PhysicalPosition>,
        to: SnapTo,
        tolerance: f64,
    ) -> Option<Snapped> {
        let [x, y] = place.into().to_array();
        let mut best: Option<(f64, Snapped)> = None;
        let mut visited = std::collections::BTreeSet::new();
        for [px, py] in pixels_around(x, y, tolerance) {
            let Some((object, Element::Triangle(triangle))) = self.owner_at([px, py]) else {
                continue;
            };
            if to != SnapTo::Face && !visited.insert((object, triangle)) {
                continue;
            }
            let feature = match to {
                SnapTo::Vertex => self
                    .nearest_in_polygon(object, triangle, [x, y])
                    .vertex
                    .map(|vertex| (vertex.pixels, SnappedTo::Vertex(vertex))),
                SnapTo::Edge => self
                    .nearest_in_polygon(object, triangle, [x, y])
                    .edge
                    .map(|edge| (edge.pixels, SnappedTo::Edge(edge))),
                SnapTo::Face => self.at([px, py]).map(|hit| {
                    let (dx, dy) = (px - x, py - y);
                    let pixels = (dx * dx + dy * dy).sqrt();
                    let (position, window) = (hit.position, [px, py]);
                    (pixels, SnappedTo::Face { position, window, pixels })
                }),
            };
            if let Some((pixels, to)) = feature
                && pixels <= tolerance
                && best.is_none_or(|(least, _)| pixels < least)
            {
                best = Some((pixels, Snapped { object, triangle, to }));
            }
            // Positions are sorted by distance.
            if to == SnapTo::Face && best.is_some() {
                break;
            }
        }
        best.map(|(_, snapped)| snapped)
    }

    /// The nearest visible point or line within `tolerance` pixels of a window position.
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
        pixels_around(x, y, tolerance).into_iter().find_map(|[px, py]| {
            let (_, element) = self.owner_at([px, py])?;
            let is_stroke = !matches!(element, Element::Triangle(_));
            if is_stroke { self.at([px, py]) } else { None }
        })
    }

    /// Projects a world-space point to window pixels from the upper left; `None` outside the near and far
    /// planes.
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

    fn nearest_in_polygon(&self, object: usize, triangle: u32, [x, y]: [f64; 2]) -> NearPolygon {
        let rays = self.picker.rays();
        let (body, at) = rays.in_body(object, triangle);
        let mesh = rays.mesh(body);
        let own = mesh.range_of(self.picker.objects()[object].section);
        let (first, first_vertex) = (own.triangles.start, own.positions.start);
        let world_from_mesh = self.picker.objects()[object].world_from_mesh.matrix();
        let place = |vertex: u32| world_from_mesh.transform_point3(mesh.position(vertex));
        let distance = |[px, py]: [f64; 2]| ((px - x) * (px - x) + (py - y) * (py - y)).sqrt();
        // The triangles of a polygon are consecutive.
        let at = at as usize;
        let (number, run) = match &mesh.polygons {
            None => (triangle, at..at + 1),
            Some(polygons) => {
                // A section's polygons are numbered on from those before it.
                let first = if mesh.sections.is_empty() { 0 } else { polygons[first as usize] };
                let number = polygons[at];
                let before =
                    polygons[..at].iter().rev().take_while(|other| **other == number).count();
                let after = polygons[at..].iter().take_while(|other| **other == number).count();
                (number - first, at - before..at + after)
            }
        };
        // Interior edges belong to two triangles, once in each direction.
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
                let pixels = distance(window);
                if polygon.vertex.is_none_or(|vertex| pixels < vertex.pixels) {
                    polygon.vertex =
                        Some(NearVertex { index: from - first_vertex, position, window, pixels });
                }
            }
            let ends = [position, place(to)];
            if let Some((along, window)) = self.nearest_on(ends, [x, y]) {
                let pixels = distance(window);
                if polygon.edge.is_none_or(|edge| pixels < edge.pixels) {
                    let position = ends[0] + (ends[1] - ends[0]) * along;
                    let vertices = [from, to].map(|vertex| vertex - first_vertex);
                    polygon.edge = Some(NearEdge { vertices, position, window, pixels });
                }
            }
        }
        polygon
    }

    /// The point of a world-space line nearest in the window: its parameter and window position. `None` if
    /// no part lies between the near and far planes.
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
        // Perspective-correct interpolation along the edge.
        let (from, to) = ((1.0 - t) / start.w, t / end.w);
        let along = part[0] + (part[1] - part[0]) * (to / (from + to));
        Some((along, [p[0] + dx * t, p[1] + dy * t]))
    }
}

fn is_between_planes(clip: DVec4) -> bool {
    clip.w + clip.z >= 0.0 && clip.w - clip.z >= 0.0 && clip.w > 0.0
}

/// A position, then the pixel centres within a distance, nearest first.
fn pixels_around(x: f64, y: f64, tolerance: f64) -> Vec<[f64; 2]> {
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
