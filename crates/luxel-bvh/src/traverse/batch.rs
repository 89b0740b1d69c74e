//! Batches: many rays, in packets where they are coherent.

use super::packet::{LEAST, Packet};
use super::packet_kind::PacketKind;
use super::packet_traversal::trace_packet;
use super::query::RayQuery;
use super::single_ray::{RaySetup, set_up, trace, trace_in_turns, trace_unusual};
use super::stack::{STACKS, TURNS, TraversalStack};
use super::target::RayTarget;
use crate::intersect::PACKET;
use crate::ray::Ray;
use luxel_math::{
    Simd, dispatch_long, f32x8, f32x16, has_wide_registers, is_specialized, prelude::*,
};
use luxel_parallel::fill;
use std::cell::RefCell;

/// Rays per task.
const CHUNK: usize = 1024;

/// Trees of more bytes exceed the caches: incoherent rays wait for memory and take turns.
const FAR: usize = 1 << 24;

thread_local! {
    static PACKETS: RefCell<Box<Packet>> = RefCell::new(Box::new(Packet::new()));
}

/// Traces rays on all threads of the current pool. `answers` must be as long as `rays`.
pub(crate) fn trace_batch<Q: RayQuery>(
    target: &RayTarget<'_>,
    rays: &[Ray],
    answers: &mut [Q::Answer],
) {
    fill(answers, CHUNK, &|start, answers| {
        trace_here::<Q>(target, &rays[start..start + answers.len()], true, answers);
    });
}

/// Traces rays on this thread, those that run close together in packets, unless none is to be
/// `together`. `answers` must be as long as `rays`.
///
/// Outlined: one copy of its kernels.
#[inline(never)]
pub(crate) fn trace_here<Q: RayQuery>(
    target: &RayTarget<'_>,
    rays: &[Ray],
    together: bool,
    answers: &mut [Q::Answer],
) {
    // Reset here, where it stays in the cache.
    answers.fill(Q::MISS);
    PACKETS.with_borrow_mut(|packet| {
        STACKS.with(|stacks| {
            dispatch_long!(target.level, simd => trace_run::<_, Q>(simd, target, (rays, together), answers, packet, &stacks.turns));
        });
    });
}

/// Traces rays in groups as wide as the machine's registers; all of them singly where packets aren't
/// [worth their code](is_specialized).
#[inline(always)]
fn trace_run<S: Simd, Q: RayQuery>(
    simd: S,
    target: &RayTarget<'_>,
    (rays, together): (&[Ray], bool),
    answers: &mut [Q::Answer],
    packet: &mut Packet,
    stacks: &[TraversalStack; TURNS],
) {
    if const { !is_specialized::<S>() } {
        trace_rest::<S, Q>(simd, target, rays, 0..rays.len(), answers, stacks);
    } else if has_wide_registers(simd) {
        let lanes = f32x16::splat(simd, 0.0);
        trace_in_packets::<S, _, Q>(simd, lanes, target, (rays, together), answers, packet, stacks);
    } else {
        let lanes = f32x8::splat(simd, 0.0);
        trace_in_packets::<S, _, Q>(simd, lanes, target, (rays, together), answers, packet, stacks);
    }
}

/// Traces coherent rays of one kind in packets and the rest singly.
#[inline(always)]
fn trace_in_packets<S: Simd, N: Lanes, Q: RayQuery>(
    simd: S,
    lanes: N,
    target: &RayTarget<'_>,
    (rays, together): (&[Ray], bool),
    answers: &mut [Q::Answer],
    packet: &mut Packet,
    stacks: &[TraversalStack; TURNS],
) {
    for (rays, answers) in rays.chunks(PACKET).zip(answers.chunks_mut(PACKET)) {
        let mut is_single = [true; PACKET];
        if together {
            if let Some(kind) = packet.load(simd, rays)
                && rays.len() >= LEAST
            {
                if packet.prepare(lanes, target, kind, rays.len()) {
                    trace_packet::<S, N, Q>(simd, lanes, target, packet, &stacks[0]);
                    packet.write_answers::<N, Q>(lanes, target, answers, |index| index);
                    continue;
                }
            } else {
                let mut kinds = [PacketKind::NONE; PACKET];
                for (kind, ray) in kinds.iter_mut().zip(rays) {
                    *kind = PacketKind::of(ray);
                }
                let kinds = &mut kinds[..rays.len()];
                let mut counts = [0_u8; PacketKind::COUNT];
                for kind in kinds.iter() {
                    counts[kind.number()] += 1;
                }
                for first in 0..kinds.len() {
                    let kind = kinds[first];
                    if kind == PacketKind::NONE || usize::from(counts[kind.number()]) < LEAST {
                        continue;
                    }
                    let mut indices = [0_u8; PACKET];
                    let mut count = 0;
                    for (index, other) in (0_u8..).zip(kinds.iter_mut()) {
                        indices[count & (PACKET - 1)] = index;
                        count += usize::from(*other == kind);
                        *other = if *other == kind { PacketKind::NONE } else { *other };
                    }
                    let indices = &indices[..count];
                    packet.load_selected(simd, rays, indices);
                    if !packet.prepare(lanes, target, kind, count) {
                        continue;
                    }
                    trace_packet::<S, N, Q>(simd, lanes, target, packet, &stacks[0]);
                    packet.write_answers::<N, Q>(lanes, target, answers, |at| {
                        usize::from(indices[at])
                    });
                    for &index in indices {
                        is_single[usize::from(index)] = false;
                    }
                }
            }
        }
        let rest = (0..rays.len()).filter(|index| is_single[*index]);
        trace_rest::<S, Q>(simd, target, rays, rest, answers, stacks);
    }
}

/// Traces incoherent rays: in turns where the tree exceeds the caches, else one by one.
#[inline(always)]
fn trace_rest<S: Simd, Q: RayQuery>(
    simd: S,
    target: &RayTarget<'_>,
    rays: &[Ray],
    rest: impl Iterator<Item = usize>,
    answers: &mut [Q::Answer],
    stacks: &[TraversalStack; TURNS],
) {
    if target.memory() >= FAR {
        trace_in_turns::<S, Q>(simd, target, rays, rest, answers, stacks);
    } else {
        for index in rest {
            let ray = &rays[index];
            answers[index] = match set_up(simd, target, ray) {
                RaySetup::Unusual => trace_unusual::<Q>(target, ray),
                RaySetup::Misses => Q::MISS,
                RaySetup::Hits(slabs) => trace::<S, Q>(simd, target, ray, &slabs, &stacks[0]),
            };
        }
    }
}
