//! Groups: up to sixteen rays that ask for any hit and share their signs and longest axis.
//!
//! Each ray tests each box that it comes to, and only such: rays that begin close together share their way
//! through the tree until they part, whatever their directions. Where they go can't be predicted, so there
//! is no branch on it: all children of a node are written to where they would wait, nodes on the stack and
//! leaves in a list of their own, and stay there if any ray asks for them. Leaves wait until there are a few.
//!
//! What was tried instead, and was slower: an interval around all rays that chooses the children to test,
//! nodes in a queue instead of a stack, and the boxes of all children at once for a ray that is alone.

use super::packet::Packet;
use super::stack::TraversalStack;
use super::target::RayTarget;
use crate::intersect::{block_hits, intersect_block, lane, load, width};
use crate::tree::{Block, Child, Node, WIDTH, block_at};
use luxel_math::{Simd, prelude::*};

/// From so many leaves on, they are tested. With one, eight and 24 rays of openness took 1.02, 1.00 and 1.01
/// of the time, rays that are blocked 0.87, 1.10 and 1.25.
pub(super) const LEAVES: usize = 4;
/// Room for those and for what a node adds.
pub(super) const ROOM: usize = 16;
const _: () = assert!(LEAVES + WIDTH < ROOM);

/// Up to this many rays are intersected with a block one by one, more with one triangle at a time.
const ALONE: u32 = 2;

/// Traces the rays of a packet of one group.
#[inline(always)]
pub(super) fn trace_group<S: Simd, N: Lanes>(
    simd: S,
    lanes: N,
    target: &RayTarget<'_>,
    packet: &mut Packet,
    stack: &TraversalStack,
) {
    let nodes: &[Node] = target.tree.nodes;
    let slabs = GroupSlabs::new(lanes, packet);
    // Rays that miss the box around all have an empty range.
    let all = lanes.zero().less_or_equal(slabs.end).bits();
    let mut left = all;
    let mut leaves = [(Child::NONE, 0); ROOM];
    let mut vertices = [[lanes; 3]; WIDTH];
    let (mut top, mut waiting) = (1, 0);
    stack.put_for(0, Child::inner(0), all);
    while left != 0 {
        let next = stack.pop_for(&mut top);
        if waiting >= LEAVES || next.is_none() {
            for (leaf, asking) in &leaves[..waiting.min(ROOM)] {
                let asking = asking & left;
                if asking != 0 {
                    left &=
                        !leaf_hits(simd, lanes, target, packet, (*leaf, 0, asking), &mut vertices);
                }
            }
            waiting = 0;
        }
        let Some((child, asking)) = next else { break };
        let node = &nodes[child as usize];
        let found = slabs.hits(node);
        for slot in 0..WIDTH {
            let (child, asking) = (node.children[slot], found[slot] & asking & left);
            stack.put_for(top, child, asking);
            leaves[waiting % ROOM] = (child, asking);
            let (asks, is_leaf) = (u32::from(asking != 0), child.leaf_bit());
            top += (asks & !is_leaf) as usize;
            waiting += (asks & is_leaf) as usize;
        }
    }
    let mut blocked = all & !left;
    while blocked != 0 {
        packet.block_ray(blocked.trailing_zeros() as usize);
        blocked &= blocked - 1;
    }
}

/// The rays of a group, of those that ask, that hit a triangle of a leaf.
#[inline(always)]
fn leaf_hits<S: Simd, N: Lanes>(
    simd: S,
    lanes: N,
    target: &RayTarget<'_>,
    packet: &Packet,
    (leaf, group, asking): (Child, usize, u32),
    vertices: &mut [[N; 3]; WIDTH],
) -> u32 {
    let mut hits = 0;
    let Some(mut start) = leaf.as_block() else { return 0 };
    while let Some(block) = block_at(target.tree.words, start) {
        let header = block.header();
        let all = u32::MAX >> (u32::BITS - header.count() as u32);
        hits |= hits_of_block(simd, lanes, target, packet, (block, all), (group, asking), vertices);
        if !header.more_follow() {
            break;
        }
        start += header.len();
    }
    hits
}

/// The rays of a group, of those that ask, that hit one of some triangles of a block.
#[inline(always)]
pub(super) fn hits_of_block<S: Simd, N: Lanes>(
    simd: S,
    lanes: N,
    target: &RayTarget<'_>,
    packet: &Packet,
    (block, triangles): (Block<'_>, u32),
    (group, asking): (usize, u32),
    vertices: &mut [[N; 3]; WIDTH],
) -> u32 {
    if asking.count_ones() > ALONE {
        let of = (block, target.positions, triangles);
        let range = [&packet.start, &packet.nearest];
        let rays = (&packet.sheared, group, packet.axes, range);
        let is_negative = packet.reversed[packet.longest] != 0;
        return block_hits(simd, lanes, of, rays, (asking, is_negative), vertices);
    }
    let (mut hits, mut rays) = (0, asking);
    while rays != 0 {
        let ray = rays.trailing_zeros() as usize;
        rays &= rays - 1;
        let of = group * width::<N>() + ray;
        let range = [lane(&packet.start, of), lane(&packet.nearest, of)];
        let sheared = packet.ray(of);
        let (_, bits) = intersect_block(simd, block, target.positions, &sheared, range);
        hits |= u32::from(bits != 0) << ray;
    }
    hits
}

/// The rays of a group in the form of the slab test: (plane - origin) * inverse.
struct GroupSlabs<N> {
    near: [N; 3],
    far: [N; 3],
    inverse: [N; 3],
    start: N,
    end: N,
    reversed: [usize; 3],
}

impl<N: Lanes> GroupSlabs<N> {
    #[inline(always)]
    fn new(lanes: N, packet: &Packet) -> Self {
        let mut slabs = Self {
            near: [lanes; 3],
            far: [lanes; 3],
            inverse: [lanes; 3],
            start: load(lanes, &packet.start, 0),
            end: load(lanes, &packet.nearest, 0),
            reversed: packet.reversed,
        };
        for axis in 0..3 {
            let inverse = load(lanes, &packet.inverse[axis], 0);
            slabs.near[axis] = load(lanes, &packet.near_origin[axis], 0);
            slabs.far[axis] = load(lanes, &packet.far_origin[axis], 0);
            slabs.inverse[axis] = inverse;
        }
        slabs
    }

    /// The rays that hit each of a node's children.
    #[inline(always)]
    fn hits(&self, node: &Node) -> [u32; WIDTH] {
        let mut found = [0; WIDTH];
        let [inverse_x, inverse_y, inverse_z] = self.inverse;
        let lanes = self.start;
        let [x, y, z] = self.reversed;
        let (near_x, far_x) = (&node.planes[0][x & 1], &node.planes[0][(x ^ 1) & 1]);
        let (near_y, far_y) = (&node.planes[1][y & 1], &node.planes[1][(y ^ 1) & 1]);
        let (near_z, far_z) = (&node.planes[2][z & 1], &node.planes[2][(z ^ 1) & 1]);
        for slot in 0..WIDTH {
            let near_x = (lanes.constant(near_x[slot]) - self.near[0]) * inverse_x;
            let near_y = (lanes.constant(near_y[slot]) - self.near[1]) * inverse_y;
            let near_z = (lanes.constant(near_z[slot]) - self.near[2]) * inverse_z;
            let far_x = (lanes.constant(far_x[slot]) - self.far[0]) * inverse_x;
            let far_y = (lanes.constant(far_y[slot]) - self.far[1]) * inverse_y;
            let far_z = (lanes.constant(far_z[slot]) - self.far[2]) * inverse_z;
            let near = near_x.maximum(near_y).maximum(near_z.maximum(self.start));
            let far = far_x.minimum(far_y).minimum(far_z.minimum(self.end));
            found[slot] = near.less_or_equal(far).bits();
        }
        found
    }
}
