//! Packets that ask for any hit.
//!
//! As with all packets, an interval around the rays chooses the children of a node; each ray tests only the
//! boxes of leaves by itself. The order of what is visited doesn't matter, so nothing is sorted. Children are
//! written to where they would wait and stay there if they are hit, as those of a [group](super::group):
//! which are can't be predicted. Sixteen rays to a light far away visit 8.6 nodes and 4.2 leaves of 100 000
//! triangles; with the eight boxes of each node tested by each ray, they took 1.1 times as long.

use super::group::{LEAVES, ROOM, hits_of_block};
use super::packet::{GROUPS, Packet, RayInterval};
use super::sheared_interval::ShearedInterval;
use super::stack::TraversalStack;
use super::target::RayTarget;
use crate::intersect::{PACKET, load, width};
use crate::tree::{Child, Node, WIDTH, block_at};
use luxel_math::{Simd, prelude::*};

/// Children of a node that are put without a branch. Packets to a light hit one or two of most nodes; one or
/// three instead of two are as fast, all eight take 1.03 of the time.
const USUAL: usize = 2;

/// Traces the rays of a packet that ask for any hit.
///
/// Outlined: one copy per lane type, for rays in rows and in columns.
#[inline(never)]
pub(super) fn trace_any<S: Simd, N: Lanes>(
    simd: S,
    lanes: N,
    target: &RayTarget<'_>,
    (packet, interval): (&mut Packet, &RayInterval),
    stack: &TraversalStack,
) {
    lanes.vectorized(
        #[inline(always)]
        || trace(simd, lanes.zero(), target, (packet, interval), stack),
    );
}

#[inline(always)]
fn trace<S: Simd, N: Lanes>(
    simd: S,
    lanes: N,
    target: &RayTarget<'_>,
    (packet, interval): (&mut Packet, &RayInterval),
    stack: &TraversalStack,
) {
    let nodes: &[Node] = target.tree.nodes;
    let farthest = packet.farthest(lanes);
    let sheared = ShearedInterval::new(interval, packet.axes, target);
    let groups = packet.count.min(PACKET / width::<N>());
    // Rays that miss the box around all have an empty range.
    let mut left = [0_u32; GROUPS];
    for group in 0..groups {
        left[group] = lanes.zero().less_or_equal(load(lanes, &packet.nearest, group)).bits();
    }
    let mut leaves = [0_u32; ROOM];
    let mut vertices = [[lanes; 3]; WIDTH];
    let (mut top, mut waiting) = (1, 0);
    stack.put_for(0, Child::inner(0), 0);
    loop {
        let next = stack.pop_for(&mut top);
        if waiting >= LEAVES || next.is_none() {
            for leaf in &leaves[..waiting.min(ROOM)] {
                let (node, slot) = (&nodes[*leaf as usize / WIDTH], *leaf as usize % WIDTH);
                let (mut asking, mut any) = ([0; GROUPS], 0);
                for group in 0..groups {
                    asking[group] = packet.box_hits(lanes, group, node, slot) & left[group];
                    any |= asking[group];
                }
                let Some(mut start) = node.children[slot].as_block().filter(|_| any != 0) else {
                    continue;
                };
                while let Some(block) = block_at(target.tree.words, start) {
                    let triangles = sheared.passing(simd, block, packet.axes);
                    for group in 0..groups {
                        let asking = asking[group] & left[group];
                        if triangles != 0 && asking != 0 {
                            let (of, by) = ((block, triangles), (group, asking));
                            left[group] &=
                                !hits_of_block(simd, lanes, target, packet, of, by, &mut vertices);
                        }
                    }
                    let header = block.header();
                    if !header.more_follow() {
                        break;
                    }
                    start += header.len();
                }
            }
            let mut any_left = 0;
            for group in 0..groups {
                any_left |= left[group];
            }
            waiting = 0;
            if any_left == 0 {
                break;
            }
        }
        let Some((parent, _)) = next else { break };
        let node = &nodes[parent as usize];
        let (_, mut bits) = interval.hit_children(simd, node, packet.reversed, farthest);
        let mut put = |bits: u32, asks: u32| {
            let slot = bits.trailing_zeros() as usize % WIDTH;
            let child = node.children[slot];
            stack.put_for(top, child, 0);
            leaves[waiting % ROOM] = parent * WIDTH as u32 + slot as u32;
            let is_leaf = child.leaf_bit();
            top += (asks & !is_leaf) as usize;
            waiting += (asks & is_leaf) as usize;
        };
        for _ in 0..USUAL {
            put(bits, u32::from(bits != 0));
            bits &= bits.wrapping_sub(1);
        }
        while bits != 0 {
            put(bits, 1);
            bits &= bits - 1;
        }
    }
    for group in 0..groups {
        let all = lanes.zero().less_or_equal(load(lanes, &packet.nearest, group)).bits();
        let mut blocked = all & !left[group];
        while blocked != 0 {
            packet.block_ray(group * width::<N>() + blocked.trailing_zeros() as usize);
            blocked &= blocked - 1;
        }
    }
}
