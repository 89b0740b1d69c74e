//! Silhouettes that are straight where the surface is curved.

use crate::kd_tree::MAX_RESULTS;
use crate::surface::{Edges, HalfEdge, RUN, Surface, half_edge_of};
use luxel_parallel::fill;
use luxel_scene::{Camera, DMat4, DVec3, DVec4, Size};

/// The least cosine between the normals on both sides of a smooth edge.
const MIN_SMOOTH_COSINE: f64 = 0.999;

/// The least length of the next edge of a curved outline, as a fraction of the edge's length.
const MIN_NEXT_LENGTH: f64 = 0.4;

/// The cosine of its largest turn: a hexagon's is 60 degrees, zigzags aren't curves.
const MIN_TURN_COSINE: f64 = 0.4;

/// A visibly straight edge of a curved outline.
pub(crate) struct Facet {
    pub(crate) half_edge: HalfEdge,
    /// The deviation of the curve from the edge, in pixels.
    pub(crate) pixels: f64,
}

/// The view of a mesh, in its own coordinates.
pub(crate) struct MeshView {
    clip_from_mesh: DMat4,
    world_from_mesh: DMat4,
    eye: DVec3,
    /// The view direction of an orthographic camera.
    parallel: Option<DVec3>,
    size: DVec3,
}

impl MeshView {
    /// The view of a mesh relative to its origin.
    pub(crate) fn new(camera: &Camera, size: Size, world_from_mesh: &DMat4, origin: DVec3) -> Self {
        let world_from_mesh = *world_from_mesh * DMat4::from_translation(origin);
        let clip_from_view = camera.projection.clip_from_view(size);
        let (width, height) = (f64::from(size.width), f64::from(size.height));
        Self {
            clip_from_mesh: clip_from_view * camera.view_from_world * world_from_mesh,
            world_from_mesh,
            eye: camera.eye(),
            parallel: camera.projection.is_orthographic().then(|| camera.direction()),
            size: DVec3::new(width * 0.5, height * 0.5, 0.0),
        }
    }

    /// A place in pixels from the window's centre; `None` behind the eye.
    fn pixel(&self, place: DVec3) -> Option<DVec3> {
        self.pixel_and_depth(place).map(|(pixel, _)| pixel)
    }

    /// The same, with the depth that interpolation divides by: 1 for orthographic cameras.
    pub(crate) fn pixel_and_depth(&self, place: DVec3) -> Option<(DVec3, f64)> {
        let clip: DVec4 = self.clip_from_mesh * place.extend(1.0);
        (clip.w > 1e-9).then(|| {
            let (x, y) = (clip.x / clip.w * self.size.x, clip.y / clip.w * self.size.y);
            (DVec3::new(x, y, 0.0), clip.w)
        })
    }

    /// Whether a triangle in front of the eye lies outside the window.
    pub(crate) fn is_beside_window(&self, corners: &[Option<(DVec3, f64)>; 3]) -> bool {
        let [Some((a, _)), Some((b, _)), Some((c, _))] = *corners else { return false };
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        low.x > self.size.x || low.y > self.size.y || high.x < -self.size.x || high.y < -self.size.y
    }

    fn is_in_window(&self, pixel: DVec3) -> bool {
        pixel.x.abs() <= self.size.x && pixel.y.abs() <= self.size.y
    }

    /// Whether a triangle is front-facing.
    fn faces_eye(&self, corners: [DVec3; 3]) -> bool {
        let [a, b, c] = corners.map(|corner| self.world_from_mesh.transform_point3(corner));
        let towards = self.parallel.map_or(self.eye - a, |direction| -direction);
        (b - a).cross(c - a).dot(towards) > 0.0
    }
}

/// An edge of the outline in the window, with the pixels of its ends.
struct Outline {
    half_edge: HalfEdge,
    other: HalfEdge,
    ends: [u32; 2],
    pixels: [DVec3; 2],
}

impl Outline {
    fn length(&self) -> f64 {
        self.pixels[0].distance(self.pixels[1])
    }
}

/// The edges of the outline that deviate from their curve by more than a number of pixels.
///
/// An edge belongs to the outline where one of its triangles shows its front and the other its back.
/// It approximates a curve perpendicular to the projected vertex normals at its ends: an arc that turns
/// by their angle t, and rises over its chord of length c by c / 2 tan(t / 4). If the outline continues
/// in much shorter edges, these make the turn and the long edge is meant to be straight; zigzags aren't
/// outlines of curves.
pub(crate) fn facets(
    surface: &Surface<'_>,
    edges: &Edges,
    normals: &[[DVec3; 3]],
    view: &MeshView,
    least_pixels: f64,
) -> Vec<Facet> {
    let outline = outline(surface, edges, view);
    // The directions from each place along the outline.
    let mut ways: Vec<(u32, HalfEdge, DVec3)> = Vec::with_capacity(2 * outline.len());
    for Outline { half_edge, ends, pixels: [begin, end], .. } in &outline {
        ways.push((ends[0], *half_edge, *end - *begin));
        ways.push((ends[1], *half_edge, *begin - *end));
    }
    ways.sort_unstable_by_key(|(place, half_edge, _)| (*place, *half_edge));
    let goes_on = |edge: &Outline, k: usize| {
        let into = edge.pixels[k] - edge.pixels[1 - k];
        let first = ways.partition_point(|(other, ..)| *other < edge.ends[k]);
        let here = ways[first..].iter().take_while(|(other, ..)| *other == edge.ends[k]);
        // Where more edges meet, it isn't the outline of a curve.
        let mut here = here.take(MAX_RESULTS);
        here.any(|(_, half_edge, way)| {
            *half_edge != edge.half_edge
                && way.length() >= MIN_NEXT_LENGTH * into.length()
                && way.dot(into) >= MIN_TURN_COSINE * way.length() * into.length()
        })
    };
    let mut facets = Vec::new();
    for edge in outline.iter().filter(|edge| goes_on(edge, 0) && goes_on(edge, 1)) {
        let at = |half_edge: HalfEdge, place: u32| {
            let triangle = (half_edge / 3) as usize;
            let corner = surface.triangles[triangle].iter().position(|&other| other == place);
            corner.map_or(DVec3::ZERO, |corner| normals[triangle][corner])
        };
        let ends = edge.ends.map(|place| at(edge.half_edge, place));
        let beyond = edge.ends.map(|place| at(edge.other, place));
        if ends[0].dot(beyond[0]) < MIN_SMOOTH_COSINE || ends[1].dot(beyond[1]) < MIN_SMOOTH_COSINE
        {
            continue;
        }
        // Projected normals: a step along each, relative to the edge.
        let places = edge.ends.map(|place| surface.at(place));
        let step = 0.01 * places[0].distance(places[1]);
        let shown = |k: usize| {
            let pixel = view.pixel(places[k] + ends[k] * step)?;
            Some((pixel - edge.pixels[k]).normalize_or_zero())
        };
        let (Some(first), Some(last)) = (shown(0), shown(1)) else { continue };
        let turn = libm::acos(first.dot(last).clamp(-1.0, 1.0));
        let pixels = edge.length() * 0.5 * libm::tan(turn * 0.25);
        if pixels >= least_pixels {
            facets.push(Facet { half_edge: edge.half_edge, pixels });
        }
    }
    facets
}

/// The outline in the window, in order of its edges.
fn outline(surface: &Surface<'_>, edges: &Edges, view: &MeshView) -> Vec<Outline> {
    let mut faces_eye = vec![false; surface.triangles.len()];
    fill(&mut faces_eye, RUN, &|start, run| {
        for (triangle, faces_eye) in (start as u32..).zip(run) {
            *faces_eye = view.faces_eye(surface.corners(triangle));
        }
    });
    let mut outline = Vec::new();
    for edge in edges.iter() {
        let [half_edge, other] = *edge else { continue };
        let [half_edge, other] = [half_edge, other].map(half_edge_of);
        if faces_eye[(half_edge / 3) as usize] == faces_eye[(other / 3) as usize] {
            continue;
        }
        let ends = surface.ends(half_edge);
        let [Some(begin), Some(end)] = ends.map(|place| view.pixel(surface.at(place))) else {
            continue;
        };
        if view.is_in_window(begin) && view.is_in_window(end) {
            outline.push(Outline { half_edge, other, ends, pixels: [begin, end] });
        }
    }
    outline
}
