//! Rasterizes a part of the window: the tree finds the triangles that may reach it, and a frame of
//! `luxel-visibility` over those decides which pixel shows which.

use crate::coverage_query::{CoveringTriangle, positions};
use crate::frustum::{Frustum, PLANES, frustum_planes};
use crate::region::Region;
use crate::view::{Geometry, PickView};
use luxel_math::SUBPIXELS;
use luxel_parallel::{each, gather, sort_u32};
use luxel_scene::{Mesh, Part};
use luxel_visibility::{
    Clusters, Frame, Frames, Instance as FrameInstance, Samples, TILE, Tile, TooManyTriangles,
    TriangleId,
};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// Columns and rows of the window.
pub(crate) type Pixels = [Range<u32>; 2];

/// Tiles per task.
const TILES_PER_TASK: usize = 4;

/// The possibly visible part of an instance.
struct VisibleMesh<'v> {
    /// The instance's index in the view.
    instance: usize,
    mesh: Cow<'v, Mesh>,
    /// The instance's triangles in `mesh`; `None` for all.
    triangles: Option<Vec<u32>>,
    /// The ranks of triangles of `mesh`.
    ranks: Cow<'v, [(u32, u8)]>,
    clusters: Clusters,
}

/// A pixel with the instance and triangle that it shows.
pub(crate) struct PixelOwner {
    pub(crate) pixel: [u32; 2],
    pub(crate) instance: usize,
    pub(crate) triangle: u32,
}

impl PickView<'_> {
    /// Visits the visible triangles of pixels, tile by tile on all threads, in no particular order.
    ///
    /// # Errors
    /// [`TooManyTriangles`] if a frame can't number them.
    pub(crate) fn visit_visible(
        &self,
        [columns, rows]: &Pixels,
        visit: &(dyn Fn(&mut dyn Iterator<Item = PixelOwner>) + Sync),
    ) -> Result<(), TooManyTriangles> {
        if columns.is_empty() || rows.is_empty() {
            return Ok(());
        }
        let around = [columns.start, rows.start, columns.end, rows.end].map(f64::from);
        let visible: Vec<VisibleMesh<'_>> =
            gather(self.placed.instances().len(), 1, &|run, visible| {
                if !self.placed.is_repeated(run.start) {
                    visible.extend(self.visible_mesh(run.start, around));
                }
            });
        let instances = visible.iter().map(|visible| {
            let instance = &self.placed.instances()[visible.instance];
            FrameInstance {
                mesh: &visible.mesh,
                clusters: &visible.clusters,
                view_from_local: &self.placed.space(visible.instance).view_from_local,
                parts: Arc::clone(&instance.parts),
                ranks: &visible.ranks,
                is_repeated: false,
            }
        });
        let (projection, level) = (&self.camera().projection, self.picker.level());
        let frame = Frame::new(instances.collect(), projection, self.size(), Samples::ONE, level)?;
        let shown = |id: TriangleId| {
            let of = frame.triangle(id)?;
            let VisibleMesh { instance, triangles, .. } = &visible[of.instance];
            let triangle = triangles.as_ref().map_or(of.triangle, |all| all[of.triangle as usize]);
            Some((*instance, triangle))
        };
        let hole = |id: TriangleId, position: [i32; 2]| {
            shown(id).is_some_and(|(instance, triangle)| {
                let mesh = self.geometry(instance).mesh;
                let corners = positions(mesh, triangle);
                self.is_hole(
                    &CoveringTriangle { instance, triangle, corners, depth: 0.0 },
                    position,
                )
            })
        };
        let [across, _] = frame.tiles();
        let of_tile = |tile: &mut Tile, number: usize| {
            frame.draw_opaque(level, number, &hole, tile);
            let [left, top] = tile.origin().map(i32::cast_unsigned);
            let within = |range: &Range<u32>, first: u32| {
                range.start.max(first)..range.end.min(first + TILE.cast_unsigned())
            };
            let columns = within(columns, left);
            let pixels = within(rows, top).flat_map(|y| columns.clone().map(move |x| [x, y]));
            let tile = &*tile;
            visit(&mut pixels.filter_map(|pixel @ [x, y]| {
                let id = tile.id((x - left).cast_signed(), (y - top).cast_signed(), 0);
                let (instance, triangle) = shown(id)?;
                Some(PixelOwner { pixel, instance, triangle })
            }));
        };
        let tiles = |range: &Range<u32>| {
            (range.start / TILE.cast_unsigned()) as usize
                ..range.end.div_ceil(TILE.cast_unsigned()) as usize
        };
        let columns = tiles(columns);
        let numbers: Vec<usize> = tiles(rows)
            .flat_map(|row| columns.clone().map(move |column| row * across + column))
            .filter(|&number| !frame.is_tile_empty(number))
            .collect();
        each(numbers.chunks(TILES_PER_TASK), &|numbers| {
            let mut tile = Tile::new(1);
            for &number in numbers {
                of_tile(&mut tile, number);
            }
        });
        Ok(())
    }

    /// The part of an instance that may be visible between left, top, right and bottom, if any.
    fn visible_mesh(
        &self,
        number: usize,
        [left, top, right, bottom]: [f64; 4],
    ) -> Option<VisibleMesh<'_>> {
        let instance = self.tree(number);
        let ranks = self.placed.ranks(&self.placed.instances()[number]);
        let Geometry { mesh, bvh } = self.geometry(number);
        let window = [f64::from(self.size().width), f64::from(self.size().height)];
        let clip_from_tree = self.camera().projection.clip_from_view(self.size())
            * instance.tree_from_view.inverse();
        // Snapping moves corners by a constant number of pixels, and one in proportion to distance.
        // Planes are in units of 2 w pixels.
        let pixels = |steps: f64| steps / f64::from(SUBPIXELS);
        let grow = pixels(instance.reach.constant);
        let (width, height) = (right - left + 2.0 * grow, bottom - top + 2.0 * grow);
        let region = Region::rectangle(left - grow, top - grow, width, height).ok()?;
        let [x, y] = instance.reach.by_distance.map(|steps| 2.0 * pixels(steps));
        let beyond: [f64; PLANES] = [x, x, y, y, 0.0, 0.0];
        let planes = frustum_planes(&region.hull(), window);
        let frustum = Frustum::new(&planes, &clip_from_tree, bvh.bounds(), beyond);
        let mut triangles: Vec<u32> = Vec::new();
        frustum.visit_leaves(bvh, |leaf| triangles.extend_from_slice(leaf));
        if triangles.is_empty() {
            return None;
        }
        // Extracting pays for less than half of a mesh.
        if triangles.len() > mesh.triangles.len() / 2 {
            let clusters = Clusters::new(mesh, Frames::One);
            return Some(VisibleMesh {
                instance: number,
                mesh: Cow::Borrowed(mesh),
                triangles: None,
                ranks: Cow::Borrowed(ranks),
                clusters,
            });
        }
        // At equal depth the first triangle of the file is visible: order matters.
        sort_u32(&mut triangles);
        let mesh = extract(mesh, &triangles);
        let clusters = Clusters::new(&mesh, Frames::One);
        let own = |&(triangle, rank): &(u32, u8)| {
            let place = triangles.binary_search(&triangle).ok()?;
            Some((place as u32, rank))
        };
        let ranks = ranks.iter().filter_map(own).collect();
        let (mesh, triangles) = (Cow::Owned(mesh), Some(triangles));
        Some(VisibleMesh { instance: number, mesh, triangles, ranks, clusters })
    }
}

/// Extracts triangles of a mesh, given in order; they share no vertices.
fn extract(mesh: &Mesh, triangles: &[u32]) -> Mesh {
    let corners = |&triangle: &u32| {
        mesh.triangles[triangle as usize].map(|vertex| mesh.positions[vertex as usize])
    };
    let part = |part: &Part| {
        let before = |end: u32| triangles.partition_point(|&triangle| triangle < end) as u32;
        let first = before(part.first);
        Part { first, count: before(part.first + part.count) - first, ..*part }
    };
    Mesh {
        origin: mesh.origin,
        positions: triangles.iter().flat_map(corners).collect(),
        triangles: (0..triangles.len() as u32).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]).collect(),
        parts: mesh.parts.iter().map(part).collect(),
        ..Mesh::default()
    }
}
