//! Points and lines as what can be seen of them: small squares and thin rectangles that face the
//! eye, a few pixels wide at any distance.
//!
//! They are made anew for every view, in view space, and go the way of all triangles from there.

use crate::cluster::{Clusters, Frames};
use glam::{DVec2, DVec3};
use luxel_scene::{Camera, MaterialId, Mesh, Object, Part, Scene, Size};

/// Width of lines in pixels.
pub const LINE_WIDTH: f64 = 1.5;
/// Lines are cut where they come nearer than this, times the near plane's distance.
const CUT: f64 = 1.0 + 1e-6;

/// The points and lines of one object.
#[derive(Clone, Debug)]
pub struct Strokes {
    /// The object, by its place.
    pub object: usize,
    /// Rectangles in view space: two triangles each, first the points, then the lines.
    pub mesh: Mesh,
    /// The mesh, cut into clusters.
    pub clusters: Clusters,
    /// The point or line of each rectangle: counted through all points of the object's mesh, then
    /// on through all lines. What lies wholly before the near plane has no rectangle.
    pub elements: Vec<u32>,
}

/// The strokes of all objects that have any, with points of this side in pixels.
#[must_use]
pub fn strokes(
    scene: &Scene,
    objects: &[Object],
    camera: &Camera,
    size: Size,
    point_size: f32,
) -> Vec<Strokes> {
    let lens = PixelSize::of(camera, size);
    let mut all = Vec::new();
    for (number, object) in objects.iter().enumerate() {
        let source = &scene.meshes[object.mesh.index()];
        if source.points.is_empty() && source.lines.is_empty() {
            continue;
        }
        let view_from_mesh = camera.view_from_world * object.world_from_mesh.matrix();
        let mut builder = Builder {
            lens: &lens,
            half_point: f64::from(point_size) * 0.5,
            source,
            mesh: Mesh::default(),
            elements: Vec::new(),
            element: 0,
        };
        let place = |index: u32| view_from_mesh.transform_point3(source.position(index));
        for points in &source.points {
            let first = builder.mesh.triangles.len();
            for &index in &points.indices {
                builder.point(place(index), index);
                builder.element += 1;
            }
            builder.part(first, points.material);
        }
        for lines in &source.lines {
            let first = builder.mesh.triangles.len();
            for &[from, to] in &lines.segments {
                builder.line([place(from), place(to)], [from, to]);
                builder.element += 1;
            }
            builder.part(first, lines.material);
        }
        let Builder { mesh, elements, .. } = builder;
        let clusters = Clusters::new(&mesh, Frames::One);
        all.push(Strokes { object: number, mesh, clusters, elements });
    }
    all
}

/// How large a pixel is in view space.
struct PixelSize {
    /// Across and down: at distance 1 for perspectives, anywhere for parallel rays.
    at_one: DVec2,
    parallel: bool,
    near: f64,
}

impl PixelSize {
    fn of(camera: &Camera, size: Size) -> Self {
        let projection = &camera.projection;
        let clip = projection.clip_from_view(size);
        let pixels = DVec2::new(f64::from(size.width), f64::from(size.height));
        let at_one = DVec2::new(2.0 / clip.x_axis.x, 2.0 / clip.y_axis.y) / pixels;
        Self { at_one, parallel: projection.is_orthographic(), near: projection.near }
    }

    fn at(&self, place: DVec3) -> DVec2 {
        if self.parallel { self.at_one } else { self.at_one * -place.z }
    }

    /// Where a place lies in the window, in pixels from any fixed point.
    fn window(&self, place: DVec3) -> DVec2 {
        place.truncate() / self.at(place)
    }

    fn is_before_near(&self, place: DVec3) -> bool {
        -place.z < self.near * CUT
    }
}

struct Builder<'a> {
    lens: &'a PixelSize,
    /// Half the side of points, in pixels.
    half_point: f64,
    source: &'a Mesh,
    mesh: Mesh,
    elements: Vec<u32>,
    /// The point or line at hand.
    element: u32,
}

impl Builder<'_> {
    /// A square about a place.
    fn point(&mut self, place: DVec3, index: u32) {
        if !place.is_finite() || self.lens.is_before_near(place) {
            return;
        }
        let half = (self.lens.at(place) * self.half_point).extend(0.0);
        let corner = |x: f64, y: f64| place + half * DVec3::new(x, y, 0.0);
        let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        self.rectangle(corners, [index; 4]);
    }

    /// A rectangle along a line, cut at the near plane.
    fn line(&mut self, mut ends: [DVec3; 2], indices: [u32; 2]) {
        let outside = ends.map(|end| self.lens.is_before_near(end));
        if outside == [true, true] || !ends.iter().all(|end| end.is_finite()) {
            return;
        }
        for (cut, kept) in [(0, 1), (1, 0)] {
            if outside[cut] {
                let (a, b) = (ends[kept], ends[cut]);
                let t = (-a.z - self.lens.near * CUT) / (b.z - a.z);
                ends[cut] = a + (b - a) * t;
            }
        }
        let [from, to] = ends;
        let along = (self.lens.window(to) - self.lens.window(from)).normalize_or(DVec2::X);
        let across = DVec2::new(-along.y, along.x) * (LINE_WIDTH * 0.5);
        let aside =
            |place: DVec3, side: f64| place + (self.lens.at(place) * across * side).extend(0.0);
        let corners = [aside(from, -1.0), aside(to, -1.0), aside(to, 1.0), aside(from, 1.0)];
        self.rectangle(corners, [indices[0], indices[1], indices[1], indices[0]]);
    }

    fn rectangle(&mut self, corners: [DVec3; 4], sources: [u32; 4]) {
        let first = self.mesh.positions.len() as u32;
        self.elements.push(self.element);
        self.mesh.positions.extend(corners.map(|corner| corner.as_vec3().to_array()));
        self.mesh.triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|corner| first + corner)));
        // Attribute vertices of points and lines are numbered like their positions.
        if self.source.attribute_corners.is_none() && !self.source.colors.is_empty() {
            let color = |at: u32| self.source.colors.get(at as usize).copied().unwrap_or([1.0; 4]);
            self.mesh.colors.extend(sources.map(color));
        }
    }

    fn part(&mut self, first: usize, material: MaterialId) {
        let count = (self.mesh.triangles.len() - first) as u32;
        self.mesh.parts.push(Part { first: first as u32, count, material });
    }
}
