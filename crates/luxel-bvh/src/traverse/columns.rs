//! Occlusion queries of rays that are stored in columns: packets without transposition.

use super::any_packet::trace_any;
use super::batch::trace_here;
use super::packet::{PACKETS, Packet};
use super::query::AnyHit;
use super::stack::{STACKS, TraversalStack};
use super::target::RayTarget;
use crate::intersect::{PACKET, width};
use crate::ray::{Ray, RayColumns};
use luxel_math::{
    LANES, Simd, dispatch_long, f32x8, f32x16, has_wide_registers, is_specialized, lanes_of,
    prelude::*,
};

/// The columns of a packet.
const TOGETHER: usize = PACKET / LANES;

/// Whether rays hit anything, a bit for each lane. Coherent rays are traced in packets.
///
/// `hits` must be as long as `rays`.
pub(crate) fn any_of_columns(target: &RayTarget<'_>, rays: &[RayColumns], hits: &mut [u32]) {
    for (rays, hits) in rays.chunks(TOGETHER).zip(hits.chunks_mut(TOGETHER)) {
        let is_done = PACKETS.with_borrow_mut(|packet| {
            STACKS.with(|stacks| {
                dispatch_long!(target.level, simd => trace_columns(simd, target, rays, hits, packet, &stacks.turns[0]))
            })
        });
        if !is_done {
            trace_as_rows(target, rays, hits);
        }
    }
}

/// Traces rays as a packet; returns `false`, with no answer, if they are not of one kind.
#[inline(always)]
fn trace_columns<S: Simd>(
    simd: S,
    target: &RayTarget<'_>,
    rays: &[RayColumns],
    hits: &mut [u32],
    packet: &mut Packet,
    stack: &TraversalStack,
) -> bool {
    if const { !is_specialized::<S>() } {
        false
    } else if has_wide_registers(simd) {
        let lanes = f32x16::splat(simd, 0.0);
        trace_packet(simd, lanes, target, rays, hits, packet, stack)
    } else {
        let lanes = f32x8::splat(simd, 0.0);
        trace_packet(simd, lanes, target, rays, hits, packet, stack)
    }
}

#[inline(always)]
fn trace_packet<S: Simd, N: Lanes>(
    simd: S,
    lanes: N,
    target: &RayTarget<'_>,
    rays: &[RayColumns],
    hits: &mut [u32],
    packet: &mut Packet,
    stack: &TraversalStack,
) -> bool {
    let Some(kind) = packet.load_columns(simd, rays) else { return false };
    if !packet.prepare(lanes, target, kind, rays.len() * LANES) {
        return false;
    }
    hits.fill(0);
    if packet.count == 0 {
        return true;
    }
    let Some(interval) = packet.interval(lanes, target) else { return false };
    trace_any(simd, lanes, target, (packet, &interval), stack);
    let width = width::<N>();
    for group in 0..packet.count.min(PACKET / width) {
        let first = packet.number(group) * width;
        hits[first / LANES] |= packet.hits(lanes, group) << (first % LANES);
    }
    true
}

/// Traces rays of several kinds, and those of unusual lengths.
#[cold]
#[inline(never)]
fn trace_as_rows(target: &RayTarget<'_>, rays: &[RayColumns], hits: &mut [u32]) {
    let of_column =
        |of: &RayColumns| -> Vec<Ray> { lanes_of(of.lanes).map(|lane| of.ray(lane)).collect() };
    let rows: Vec<Ray> = rays.iter().flat_map(of_column).collect();
    let mut answers = vec![false; rows.len()];
    trace_here::<AnyHit>(target, &rows, true, &mut answers);
    let mut answers = answers.into_iter();
    for (rays, hits) in rays.iter().zip(hits) {
        *hits = 0;
        for (lane, is_hit) in lanes_of(rays.lanes).zip(&mut answers) {
            *hits |= u32::from(is_hit) << lane;
        }
    }
}
