//! Packet traversal.
//!
//! Where a leaf is reached, its box is tested against each ray, eight or sixteen side by side, with the
//! operations of a single ray; then its triangles against the rays that hit the box. For each group
//! the kernel decides whether it intersects the group with one triangle at a time or its rays with the
//! block one by one. Sixteen rays at a time with AVX-512 take six sevenths of the time of eight on the
//! uneven mesh of the measurements, 0.97 at a million triangles.
//!
//! A block is gathered once for all rays. Intersecting single rays with the block's own rows instead
//! was a twentieth slower at a million triangles: gathering pays from the second ray on.

use super::any_packet::trace_any;
use super::group::trace_group;
use super::packet::{GROUPS, Packet, RayInterval};
use super::query::RayQuery;
use super::stack::TraversalStack;
use super::target::RayTarget;
use crate::intersect::{PACKET, intersect_gathered, intersect_rays, lane, width};
use crate::tree::{Block, Node, WIDTH, block_at, gather};
use luxel_math::{LANES, Simd, prelude::*};

/// Intersects a leaf's triangles with the rays that hit its box; returns whether any ray got nearer.
#[inline(always)]
fn intersect_leaf<S: Simd, N: Lanes, Q: RayQuery>(
    simd: S,
    lanes: N,
    target: &RayTarget<'_>,
    packet: &mut Packet,
    node: &Node,
    slot: usize,
    mut start: usize,
) -> bool {
    let slot = slot & (WIDTH - 1);
    let mut active = [0_u32; GROUPS];
    let mut any_active = 0;
    for group in 0..packet.count.min(PACKET / width::<N>()) {
        let bits = packet.box_hits(lanes, group, node, slot);
        active[group] = bits;
        any_active |= bits;
    }
    if any_active == 0 {
        return false;
    }
    let mut any = false;
    while let Some(block) = block_at(target.tree.words, start) {
        any |=
            intersect_block::<S, N, Q>(simd, lanes, target, packet, &active, (block, start as u32));
        let header = block.header();
        if !header.more_follow() {
            break;
        }
        start += header.len();
    }
    any
}

/// Intersects a block's triangles with the rays whose bit is set; returns whether any ray got nearer.
#[inline(always)]
fn intersect_block<S: Simd, N: Lanes, Q: RayQuery>(
    simd: S,
    lanes: N,
    target: &RayTarget<'_>,
    packet: &mut Packet,
    active: &[u32; GROUPS],
    (block, start): (Block<'_>, u32),
) -> bool {
    let count = block.count();
    let gathered = gather(simd, block, target.positions);
    let is_negative = packet.reversed[packet.longest] != 0;
    let mut any = false;
    for (group, &active) in active.iter().enumerate() {
        let mut active = active;
        if active == 0 {
            continue;
        }
        if active.count_ones() as usize <= count {
            // One ray against the block costs what one triangle against the group does.
            while active != 0 {
                let ray = group * width::<N>() + active.trailing_zeros() as usize;
                active &= active - 1;
                let sheared = packet.ray(ray);
                let range = [lane(&packet.start, ray), lane(&packet.nearest, ray)];
                let (distances, mut hits) =
                    intersect_gathered(simd, &gathered, count, &sheared, range);
                while hits != 0 {
                    let of = hits.trailing_zeros() as usize & (WIDTH - 1);
                    hits &= hits - 1;
                    any |= packet.record::<Q>(
                        ray,
                        distances[of],
                        block.triangle(of),
                        [start, of as u32],
                    );
                }
            }
            continue;
        }
        for of in 0..count {
            let range = [&packet.start, &packet.nearest];
            let sheared = (&packet.sheared, group);
            let (t, mut hits) = intersect_rays(
                lanes,
                (&gathered, packet.axes, of),
                sheared,
                is_negative,
                range,
                active,
            );
            if hits == 0 {
                continue;
            }
            let mut distances = [0.0; LANES];
            t.store(&mut distances, 0);
            while hits != 0 {
                let lane = hits.trailing_zeros() as usize & (LANES - 1);
                hits &= hits - 1;
                let ray = group * width::<N>() + lane;
                any |= packet.record::<Q>(
                    ray,
                    distances[lane],
                    block.triangle(of),
                    [start, of as u32],
                );
            }
        }
    }
    any
}

/// Traces the rays of a packet, those that ask for any hit as a group if there is no interval around them.
#[inline(always)]
pub(crate) fn trace_packet<S: Simd, N: Lanes, Q: RayQuery>(
    simd: S,
    lanes: N,
    target: &RayTarget<'_>,
    (packet, interval): (&mut Packet, Option<RayInterval>),
    stack: &TraversalStack,
) {
    let nodes: &[Node] = target.tree.nodes;
    let mut top = 0;
    let Some(interval) = interval else {
        if Q::ANY {
            trace_group(simd, lanes, target, packet, stack);
        }
        return;
    };
    if Q::ANY {
        trace_any(simd, lanes, target, (packet, &interval), stack);
        return;
    }
    let mut farthest = packet.farthest(lanes);
    let mut index = 0;
    loop {
        let (distances, bits) =
            interval.hit_children(simd, &nodes[index], packet.reversed, farthest);
        // The node's index times eight, and the slot.
        let mut words = [0; WIDTH];
        for slot in 0..WIDTH {
            words[slot] = (index * WIDTH + slot) as u32;
        }
        target.tree.prefetch_children(&nodes[index], bits);
        stack.push(&mut top, &words, &distances, bits);
        loop {
            let Some(word) = stack.pop(&mut top, farthest) else { return };
            let (node, slot) = (&nodes[word as usize / WIDTH], word as usize % WIDTH);
            match node.children[slot].as_block() {
                Some(start) => {
                    if intersect_leaf::<S, N, Q>(simd, lanes, target, packet, node, slot, start) {
                        farthest = packet.farthest(lanes);
                    }
                }
                None => {
                    index = node.children[slot].0 as usize;
                    break;
                }
            }
        }
    }
}
