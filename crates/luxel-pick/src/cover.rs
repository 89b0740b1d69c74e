//! Which triangles cover a sample: candidates from the tree, asked by the fill rule.
//!
//! The line of sight through the sample is as thick as snapping and rounding may carry a triangle;
//! what boxes it meets hold all triangles that can cover the sample. Boxes also bound the depth of
//! what is in them, by the frame's own arithmetic, so that near ones hide far ones.

use crate::bvh::{Ahead, Block, Child, Head, Node, Slabs, WIDTH, corners, meet, number};
use crate::view::{Geometry, Instance, PickView, Thickness};
use crate::world_rays::NearRay;
use glam::DVec3;
use luxel_math::{SUBPIXELS, Simd, dispatch};
use luxel_visibility::Coverage;
use std::cell::RefCell;

/// A triangle that covers a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Covering {
    /// The instance, by its place in the view.
    pub(crate) instance: usize,
    pub(crate) triangle: u32,
    /// The reversed depth, 1 near and 0 far, by which frames decide.
    pub(crate) depth: f32,
}

impl Covering {
    /// Whether it is seen rather than another one.
    fn hides(&self, other: &Self) -> bool {
        let order = |of: &Self| (of.instance, of.triangle);
        self.depth > other.depth || self.depth == other.depth && order(self) < order(other)
    }
}

/// A thick line of sight.
struct Beam {
    slabs: Slabs,
    farthest: f32,
}

/// Children still to be visited, with the nearest depth of anything in them.
type Waiting = Vec<(f32, Child)>;

thread_local! {
    static WAITING: RefCell<Waiting> = const { RefCell::new(Vec::new()) };
}

impl PickView<'_> {
    /// What a sample sees; its position is in steps of 1/256 pixel.
    pub(crate) fn owner(&self, position: [i32; 2]) -> Option<Covering> {
        let mut best: Option<Covering> = None;
        for number in self.instances_at(position.map(|steps| steps.div_euclid(SUBPIXELS))) {
            let least = best.map_or(0.0, |best| best.depth);
            let mut visit = |covering: Covering| {
                if best.is_none_or(|best| covering.hides(&best))
                    && !self.is_hole(&covering, position)
                {
                    best = Some(covering);
                }
                best.map_or(0.0, |best| best.depth)
            };
            self.each_covering(number, position, &mut visit, least);
        }
        best
    }

    /// Everything under a sample, nearest first.
    pub(crate) fn all_covering(&self, position: [i32; 2]) -> Vec<Covering> {
        let mut all = Vec::new();
        for number in self.instances_at(position.map(|steps| steps.div_euclid(SUBPIXELS))) {
            self.each_covering(
                number,
                position,
                &mut |covering| {
                    if !self.is_hole(&covering, position) {
                        all.push(covering);
                    }
                    0.0
                },
                0.0,
            );
        }
        all.sort_by(|a, b| {
            let order = |of: &Covering| (of.instance, of.triangle);
            b.depth.total_cmp(&a.depth).then(order(a).cmp(&order(b)))
        });
        all
    }

    /// Visits the triangles that cover a sample, of the instance at a place of the view; `visit` gives
    /// the depth below which nothing counts any more.
    fn each_covering(
        &self,
        place: usize,
        position: [i32; 2],
        visit: &mut dyn FnMut(Covering) -> f32,
        least: f32,
    ) {
        let instance = &self.instances[place];
        let geometry = self.geometry(instance);
        let Some(beam) = self.beam(instance, position) else { return };
        let positions = &geometry.mesh.positions[..];
        let mut found = |block: &Block, lane: usize| {
            let triangle = number(block, lane);
            let part = part_of(&geometry, triangle);
            let corners = if instance.bounds_tell_depth {
                // The same are in the leaf, at hand.
                corners(block, lane, positions, [0, 1, 2])
            } else {
                let vertices = geometry.mesh.triangles[triangle as usize];
                vertices.map(|vertex| positions[vertex as usize])
            };
            let cull = instance.parts[part].cull;
            let depth = instance.probe.covers(corners, cull, position)?;
            Some(visit(Covering { instance: place, triangle, depth }))
        };
        WAITING.with_borrow_mut(|waiting| {
            dispatch!(self.picker.level, simd =>
                descend(simd, instance, &geometry, &beam, least, waiting, &mut found));
        });
    }

    /// The line of sight through a sample in the coordinates of an instance's tree, as thick as it
    /// must be; `None` if it passes the instance by.
    fn beam(&self, instance: &Instance, position: [i32; 2]) -> Option<Beam> {
        let [x, y] = position.map(|steps| f64::from(steps) / f64::from(SUBPIXELS));
        let (origin, direction) = self.rays.ray(x, y);
        let origin = instance.tree_from_view.transform_point3(origin);
        let direction = instance.tree_from_view.transform_vector3(direction);
        let parallel = self.camera.projection.is_orthographic();
        let Thickness { snapped, rounded, wide, largest } = instance.thickness?;
        // t counts distance along the viewing axis. Parallel rays start in the eye's plane, and the
        // scene may lie on both sides of it.
        let first = if parallel { f64::NEG_INFINITY } else { 0.0 };
        let near = NearRay::new(origin, direction, [first, f64::INFINITY], wide)?;
        let (start, grows) = if parallel { (1.0, 0.0) } else { (near.start, near.scale) };
        let f32s = |vector: DVec3| vector.as_vec3().to_array().map(f32::next_up);
        let farthest = near.ray.range[1];
        let slabs = Slabs::widening(
            near.ray.origin,
            near.ray.direction,
            [0.0, farthest],
            largest,
            f32s(snapped * start + rounded),
            f32s(snapped * grows),
        );
        Some(Beam { slabs, farthest })
    }

    /// Whether the surface isn't there: cut away, or wholly transparent.
    pub(crate) fn is_hole(&self, covering: &Covering, position: [i32; 2]) -> bool {
        let instance = &self.instances[covering.instance];
        let geometry = self.geometry(instance);
        let part = part_of(&geometry, covering.triangle);
        if instance.parts[part].coverage == Coverage::Opaque {
            return false;
        }
        let barycentric = self.forms(instance, covering.triangle).barycentric(&self.rays, position);
        let scene = self.picker.scene;
        let material = &scene.materials[geometry.mesh.parts[part].material.index()];
        scene.is_hole(geometry.mesh, covering.triangle, barycentric, material)
    }
}

/// The part of its mesh that a triangle belongs to.
pub(crate) fn part_of(geometry: &Geometry<'_>, triangle: u32) -> usize {
    let parts = &geometry.mesh.parts;
    if parts.len() < 2 {
        return 0;
    }
    parts.partition_point(|part| part.first <= triangle).saturating_sub(1)
}

/// Visits the triangles in the leaves that a line of sight meets, by block and place there, what may
/// be nearest first.
#[inline(always)]
fn descend<S: Simd>(
    simd: S,
    instance: &Instance,
    geometry: &Geometry<'_>,
    beam: &Beam,
    mut least: f32,
    waiting: &mut Waiting,
    found: &mut dyn FnMut(&Block, usize) -> Option<f32>,
) {
    let nodes: &[Node] = geometry.bvh.nodes();
    let ahead = Ahead { nodes, words: geometry.bvh.leaves().words() };
    waiting.clear();
    if !nodes.is_empty() {
        waiting.push((f32::INFINITY, Child::inner(0)));
    }
    while let Some((nearest, child)) = waiting.pop() {
        if nearest < least {
            continue;
        }
        if let Some(start) = child.as_block() {
            geometry.bvh.leaves().each_block(start, &mut |block| {
                for lane in 0..Head::of(block).count() {
                    least = found(block, lane).unwrap_or(least);
                }
            });
            continue;
        }
        let node = &nodes[child.0 as usize];
        let (_, mut bits) = meet(simd, node, &beam.slabs, beam.farthest);
        ahead.read_children(node, bits);
        let bottom = waiting.len();
        while bits != 0 {
            let slot = bits.trailing_zeros() as usize & (WIDTH - 1);
            bits &= bits - 1;
            let nearest = instance.nearest(node, slot);
            if nearest < least {
                continue;
            }
            waiting.push((nearest, node.children[slot]));
            let mut place = waiting.len() - 1;
            while place > bottom && waiting[place - 1].0 > waiting[place].0 {
                waiting.swap(place - 1, place);
                place -= 1;
            }
        }
    }
}

impl Instance {
    /// No sample of what is in a node's child has a larger depth.
    fn nearest(&self, node: &Node, slot: usize) -> f32 {
        if !self.bounds_tell_depth {
            return f32::INFINITY;
        }
        let bounds = node.bounds(slot);
        self.probe.nearest(bounds.low, bounds.high)
    }
}
