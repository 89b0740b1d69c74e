//! Slivers: everything between the near and far planes inside a region of the window, clipped exactly at
//! its sides.
//!
//! Each triangle is clipped in homogeneous coordinates of f64 against the planes through the
//! region's sides and the near and far planes (Sutherland and Hodgman 1974); the depths of the
//! rest are those that selection mode would report (OpenGL 2.1, section 5.2). The tree culls what lies
//! entirely outside one of the planes.

use crate::frustum::{Frustum, PLANES, Planes, frustum_planes};
use crate::region::Region;
use crate::view::PickView;
use glam::{DMat4, DVec3, DVec4};
use luxel_bvh::WIDTH;
use luxel_parallel::{gather, map};
use luxel_scene::Mesh;
use luxel_visibility::clip_by_plane;
use std::ops::Range;

/// The part of an object inside a region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliverHit {
    /// The object, by its index in [`Picker::objects`](crate::Picker::objects).
    pub object: usize,
    /// The least window depth of the part inside, 0 near to 1 far.
    pub z_min: f64,
    /// The greatest.
    pub z_max: f64,
    /// The number of triangles that reach inside, front or back, culled or not.
    pub triangles: u64,
    /// The number of points and lines that do.
    pub strokes: u64,
}

/// Which objects count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Inclusion {
    /// Those that reach inside.
    #[default]
    Touching,
    /// Those that lie entirely inside the region and between the near and far planes.
    Enclosed,
}

/// Depths and counts of clipped polygons.
#[derive(Clone, Copy, Default)]
struct ClippedDepths {
    z_min: f64,
    z_max: f64,
    count: u64,
    /// The number of polygons entirely inside.
    whole: u64,
}

const EMPTY: ClippedDepths =
    ClippedDepths { z_min: f64::INFINITY, z_max: f64::NEG_INFINITY, count: 0, whole: 0 };

/// The most corners of a clipped triangle.
const CORNERS: usize = 3 + PLANES;

/// Leaves per task.
const LEAVES_PER_TASK: usize = 256;

impl PickView<'_> {
    /// The objects in a rectangle of the window, by upper left corner and size in pixels; `None` for an
    /// empty rectangle.
    #[must_use]
    pub fn rectangle(&self, x: f64, y: f64, width: f64, height: f64) -> Option<Vec<SliverHit>> {
        let region = Region::rectangle(x, y, width, height).ok()?;
        Some(self.sliver(&region, Inclusion::Touching))
    }

    /// The objects in a region of the window, in order.
    #[must_use]
    pub fn sliver(&self, region: &Region, inclusion: Inclusion) -> Vec<SliverHit> {
        gather(self.picker.rays().bodies(), LEAVES_PER_TASK, &|run, hits| {
            run.for_each(|body| self.add_hits(body, region, inclusion, hits));
        })
    }

    /// The triangles of one object that reach into a region, each with its least and greatest window
    /// depth inside, in the order of the mesh.
    ///
    /// # Panics
    /// If there is no such object.
    #[must_use]
    pub fn triangles_in(&self, object: usize, region: &Region) -> Vec<(u32, [f64; 2])> {
        let rays = self.picker.rays();
        let (body, first) = rays.in_body(object, 0);
        let (mesh, clipper) = (rays.mesh(body), Clipper::new(self, body, region));
        let own = mesh.range_of(self.picker.objects()[object].section).triangles;
        let mut depths = Vec::new();
        clipper.frustum.visit_leaves(rays.tree(body).bvh, |triangles| {
            for triangle in triangles.iter().filter(|triangle| own.contains(triangle)) {
                let reach = clipper.triangle(mesh, *triangle);
                if reach.count > 0 {
                    depths.push((*triangle - first, [reach.z_min, reach.z_max]));
                }
            }
        });
        depths.sort_unstable_by_key(|(triangle, _)| *triangle);
        depths
    }

    /// Appends the objects of a body that are in a region.
    fn add_hits(
        &self,
        body: usize,
        region: &Region,
        inclusion: Inclusion,
        hits: &mut Vec<SliverHit>,
    ) {
        let rays = self.picker.rays();
        let (mesh, clipper) = (rays.mesh(body), Clipper::new(self, body, region));
        let mut candidates: Vec<u32> = Vec::new();
        clipper.frustum.visit_leaves(rays.tree(body).bvh, |triangles| {
            candidates.extend_from_slice(triangles);
        });
        let hit = |object, of: &Range<u32>, candidates: &[u32]| {
            clipper.object_hit((object, mesh, of.len()), candidates, inclusion)
        };
        if mesh.sections.is_empty() {
            let all = 0..mesh.triangles.len() as u32;
            hits.extend(hit(rays.objects_of(body).start, &all, &candidates));
            return;
        }
        candidates.sort_unstable();
        let same = |a: &u32, b: &u32| mesh.section_of(*a).0 == mesh.section_of(*b).0;
        let of_objects: Vec<&[u32]> = candidates.chunk_by(same).collect();
        hits.extend(gather(of_objects.len(), LEAVES_PER_TASK, &|run, hits| {
            for candidates in &of_objects[run] {
                let (object, _) = rays.in_object(body, candidates[0]);
                let of = mesh.range_of(self.picker.objects()[object].section).triangles;
                hits.extend(hit(object, &of, candidates));
            }
        }));
    }
}

impl Clipper<'_> {
    /// An object of a mesh, which has so many triangles, of which these may reach into the region.
    fn object_hit(
        &self,
        (object, mesh, triangles): (usize, &Mesh, usize),
        candidates: &[u32],
        inclusion: Inclusion,
    ) -> Option<SliverHit> {
        let faces = map(candidates.len(), LEAVES_PER_TASK * WIDTH, &|run| {
            let run = candidates[run].iter();
            run.fold(EMPTY, |all, &triangle| all.merge(self.triangle(mesh, triangle)))
        });
        let faces = faces.into_iter().fold(EMPTY, ClippedDepths::merge);
        let points = mesh.points.iter().flat_map(|points| &points.indices);
        let lines = mesh.lines.iter().flat_map(|lines| &lines.segments);
        let strokes = points
            .map(|&at| self.polygon(&[mesh.position(at)]))
            .chain(lines.map(|ends| self.polygon(&ends.map(|at| mesh.position(at)))))
            .fold(EMPTY, ClippedDepths::merge);
        let all = faces.merge(strokes);
        if inclusion == Inclusion::Enclosed {
            let points = mesh.points.iter().map(|points| points.indices.len()).sum::<usize>();
            let lines = mesh.lines.iter().map(|lines| lines.segments.len()).sum::<usize>();
            if all.whole != (triangles + points + lines) as u64 {
                return None;
            }
        }
        let ClippedDepths { z_min, z_max, .. } = all;
        let (triangles, strokes) = (faces.count, strokes.count);
        (all.count > 0).then_some(SliverHit { object, z_min, z_max, triangles, strokes })
    }
}

impl ClippedDepths {
    fn merge(self, other: Self) -> Self {
        Self {
            z_min: self.z_min.min(other.z_min),
            z_max: self.z_max.max(other.z_max),
            count: self.count + other.count,
            whole: self.whole + other.whole,
        }
    }
}

/// Clips one body.
struct Clipper<'r> {
    region: &'r Region,
    pieces: Vec<Planes>,
    clip_from_mesh: DMat4,
    /// The frustum of the whole region.
    frustum: Frustum,
    /// The window's width and height in pixels.
    window: [f64; 2],
}

impl<'r> Clipper<'r> {
    fn new(view: &PickView<'_>, body: usize, region: &'r Region) -> Self {
        let rays = view.picker.rays();
        let (of, tree) = (&rays.objects()[rays.objects_of(body).start], rays.tree(body));
        let projection = view.camera().projection.clip_from_view(view.size());
        let clip_from_world = projection * view.camera().view_from_world;
        let window = [f64::from(view.size().width), f64::from(view.size().height)];
        let clip_from_tree = clip_from_world * tree.world_from_tree.matrix();
        let hull = frustum_planes(&region.hull(), window);
        let frustum = Frustum::new(&hull, &clip_from_tree, tree.bvh.bounds(), [0.0; PLANES]);
        Self {
            region,
            pieces: region.pieces().iter().map(|piece| frustum_planes(piece, window)).collect(),
            clip_from_mesh: clip_from_world * of.world_from_mesh.matrix(),
            frustum,
            window,
        }
    }

    fn triangle(&self, mesh: &Mesh, triangle: u32) -> ClippedDepths {
        let corners = mesh.triangles[triangle as usize].map(|vertex| mesh.position(vertex));
        self.polygon(&corners)
    }

    /// Clips a point, a line or a triangle.
    fn polygon(&self, corners: &[DVec3]) -> ClippedDepths {
        let mut clip = [DVec4::ZERO; 3];
        for (clip, corner) in clip.iter_mut().zip(corners) {
            *clip = self.clip_from_mesh * corner.extend(1.0);
        }
        let clip = &clip[..corners.len()];
        let mut depths = EMPTY;
        let mut whole = false;
        for planes in &self.pieces {
            let (piece, uncut) = clip_polygon(clip, planes);
            whole |= uncut;
            depths.z_min = depths.z_min.min(piece[0]);
            depths.z_max = depths.z_max.max(piece[1]);
        }
        if depths.z_min <= depths.z_max {
            depths.count = 1;
            let is_whole = whole || self.pieces.len() > 1 && self.encloses(clip);
            depths.whole = u64::from(is_whole);
        }
        depths
    }

    /// Whether a polygon lies entirely inside the region, though across several of its pieces.
    fn encloses(&self, corners: &[DVec4]) -> bool {
        let between = |corner: &DVec4| corner.w + corner.z >= 0.0 && corner.w - corner.z >= 0.0;
        let mut places = [[0.0; 2]; 3];
        for (place, corner) in places.iter_mut().zip(corners) {
            *place = [
                (corner.x / corner.w + 1.0) * 0.5 * self.window[0],
                (1.0 - corner.y / corner.w) * 0.5 * self.window[1],
            ];
        }
        corners.iter().all(between) && self.region.encloses(&places[..corners.len()])
    }
}

/// The least and the greatest depth, 0 near to 1 far, of what lies of a point, a line or a triangle in clip
/// coordinates inside of the clip volume; `None` if nothing does.
///
/// # Panics
/// With more than three corners.
#[must_use]
pub fn depths_in_volume(corners: &[DVec4]) -> Option<[f64; 2]> {
    assert!(corners.len() <= 3, "a triangle at most, not {} corners", corners.len());
    let (depths, _) = clip_polygon(corners, &luxel_scene::CLIP_VOLUME);
    (depths[0] <= depths[1]).then_some(depths)
}

/// The least and greatest window depth of a polygon's part inside the planes (inverted if there is
/// none), and whether all of it is inside.
pub(crate) fn clip_polygon(corners: &[DVec4], planes: &Planes) -> ([f64; 2], bool) {
    const NONE: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];
    let mut polygon = [DVec4::ZERO; CORNERS + 1];
    polygon[..corners.len()].copy_from_slice(corners);
    let mut count = corners.len();
    let mut whole = true;
    for plane in planes {
        let source = polygon;
        let mut distances = [0.0; CORNERS + 1];
        let mut outside = 0;
        for (distance, corner) in distances.iter_mut().zip(&source[..count]) {
            *distance = plane.dot(*corner);
            outside += usize::from(*distance < 0.0);
        }
        if outside == count {
            return (NONE, false);
        }
        if outside == 0 {
            continue;
        }
        whole = false;
        let mut kept = 0;
        let mut keep = |corner: DVec4| {
            if kept <= CORNERS {
                polygon[kept] = corner;
                kept += 1;
            }
        };
        // A line is clipped once in each direction.
        clip_by_plane(
            &source[..count],
            &distances[..count],
            |inside, outside, t| *inside + (*outside - *inside) * t,
            &mut keep,
        );
        count = kept;
    }
    let mut range = NONE;
    for corner in &polygon[..count] {
        let depth = ((corner.z / corner.w + 1.0) * 0.5).clamp(0.0, 1.0);
        range = [range[0].min(depth), range[1].max(depth)];
    }
    (range, whole)
}
