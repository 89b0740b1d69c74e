//! The read-only state shared by all rays through a mesh.

use crate::aabb::Aabb;
use crate::bvh::Bvh;
use crate::intersect::ShearedRay;
use crate::ray::{RayHit, axis_order};
use crate::tree::{Block, TreeView, block_at};
use luxel_math::Level;

/// A tree and its mesh, in the form that kernels read.
#[derive(Clone, Copy)]
pub(crate) struct RayTarget<'m> {
    pub(crate) tree: TreeView<'m>,
    pub(crate) positions: &'m [[f32; 3]],
    /// The lowest and highest corner of the box around all; the fourth lane is unbounded. Inverted for
    /// a tree over nothing.
    pub(crate) bounds: [[f32; 4]; 2],
    /// The largest absolute coordinates of that box, and 0.
    pub(crate) largest: [f32; 4],
    /// The longest side of that box.
    pub(crate) extent: f32,
    pub(crate) level: Level,
}

/// The nearest hit so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NearestHit {
    pub(crate) t: f32,
    /// The triangle's number; `u32::MAX` without a hit.
    pub(crate) triangle: u32,
    /// The first word of its block, and its lane there.
    pub(crate) block: u32,
    pub(crate) lane: u32,
}

impl NearestHit {
    /// No hit yet, and nothing beyond `t` counts.
    pub(crate) const fn before(t: f32) -> Self {
        Self { t, triangle: u32::MAX, block: 0, lane: 0 }
    }

    #[inline(always)]
    pub(crate) fn is_hit(&self) -> bool {
        self.triangle != u32::MAX
    }
}

impl<'m> RayTarget<'m> {
    pub(crate) fn new(bvh: &'m Bvh, positions: &'m [[f32; 3]], level: Level) -> Self {
        let within = bvh.aabb();
        let [x, y, z] = within.map_or([0.0; 3], |bounds| bounds.largest());
        let largest = [x, y, z, 0.0];
        let extent = within.map_or(0.0, |bounds| bounds.longest_side());
        let Aabb { low, high } = within.unwrap_or(Aabb::EMPTY);
        let corner = |[x, y, z]: [f32; 3], end| [x, y, z, end];
        let bounds = [corner(low, f32::NEG_INFINITY), corner(high, f32::INFINITY)];
        Self { tree: bvh.view(), positions, bounds, largest, extent, level }
    }

    /// The memory of the tree, in bytes.
    #[inline(always)]
    pub(crate) fn memory(&self) -> usize {
        size_of_val(self.tree.nodes) + size_of_val(self.tree.words)
    }

    /// The hit with its barycentric coordinates.
    #[inline(always)]
    pub(crate) fn resolve(&self, ray: &ShearedRay, nearest: NearestHit) -> Option<RayHit> {
        if !nearest.is_hit() {
            return None;
        }
        let block = block_at(self.tree.words, nearest.block as usize)?;
        Some(self.hit_on(ray, block, nearest.lane as usize, nearest.t))
    }

    /// The hit on a triangle of a block at the distance `t`.
    #[inline(always)]
    pub(crate) fn hit_on(&self, ray: &ShearedRay, block: Block<'_>, lane: usize, t: f32) -> RayHit {
        let corners = block.corners_by_axes(lane, self.positions, axis_order(ray.last));
        RayHit { t, triangle: block.triangle(lane), barycentric: ray.barycentric(corners) }
    }
}
