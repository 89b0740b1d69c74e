//! Batches: many rays, in packets where they are coherent.

use super::packet::{LEAST, PACKETS, Packet};
use super::packet_kind::{PacketKind, kinds_of};
use super::packet_traversal::trace_packet;
use super::query::RayQuery;
use super::single_ray::{RaySetup, set_up, trace, trace_in_turns, trace_unusual};
use super::stack::{STACKS, TURNS, TraversalStack};
use super::target::RayTarget;
use crate::intersect::{PACKET, width};
use crate::ray::Ray;
use crate::tree::WIDTH;
use luxel_math::{
    Simd, dispatch_long, f32x8, f32x16, has_wide_registers, is_specialized, prelude::*,
};
use luxel_parallel::fill;

/// Rays per task.
const CHUNK: usize = 1024;

/// Fewer rays of a kind that go all ways are traced singly.
const LEAST_OF_GROUP: usize = 4;

/// Rays that are sorted by kind together, if they go all ways.
const MANY: usize = 256;

/// Places for kinds; more than there are, so that any five bits are one.
const SLOTS: usize = 1 << 5;

/// The numbers of rays that need no sorting.
static IN_ORDER: [u8; MANY] = {
    let mut order = [0; MANY];
    let mut at = 0;
    while at < MANY {
        order[at] = at as u8;
        at += 1;
    }
    order
};

/// Trees of more bytes exceed the caches: incoherent rays wait for memory and take turns.
const FAR: usize = 1 << 24;

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
    let size = if Q::ANY && !together { MANY } else { PACKET };
    'runs: for (rays, answers) in rays.chunks(size).zip(answers.chunks_mut(size)) {
        let mut is_single = [true; MANY];
        let common = match rays.len() {
            LEAST..=PACKET => packet.load(simd, rays),
            _ => None,
        };
        // Not copied where nothing is sorted: for sixteen rays, that took as long as a node.
        let sorted;
        let (order, starts): (&[u8; MANY], &[usize; SLOTS + 1]) = match common {
            Some(_) => (&IN_ORDER, &[0; SLOTS + 1]),
            None => {
                sorted = sorted_by_kind(simd, rays);
                (&sorted.0, &sorted.1)
            }
        };
        let (least, most) = match Q::ANY && !together {
            true => (LEAST_OF_GROUP, width::<N>()),
            false => (LEAST, PACKET),
        };
        for number in 0..common.map_or(PacketKind::COUNT, |_| 1) {
            let kind = common.unwrap_or(PacketKind::of_number(number));
            let of_kind = match common {
                Some(_) => &order[..rays.len()],
                None => &order[starts[number]..starts[number + 1]],
            };
            for indices in of_kind.chunks(most).filter(|indices| indices.len() >= least) {
                if common.is_none() || rays.len() > most {
                    packet.load_selected(simd, rays, indices);
                }
                if !packet.prepare(lanes, target, kind, indices.len()) {
                    continue;
                }
                if packet.count > 0 {
                    let goes_all_ways = Q::ANY && !together;
                    let interval =
                        if goes_all_ways { None } else { packet.interval(lanes, target) };
                    if interval.is_none() && !(Q::ANY && indices.len() <= width::<N>()) {
                        continue;
                    }
                    let of = (&mut *packet, interval);
                    trace_packet::<S, N, Q>(simd, lanes, target, of, &stacks[0]);
                }
                let index = |at: usize| usize::from(indices[at]);
                packet.write_answers::<N, Q>(lanes, target, answers, index);
                if common.is_some() && rays.len() <= most {
                    continue 'runs;
                }
                for &index in indices {
                    is_single[usize::from(index)] = false;
                }
            }
        }
        let rest = (0..rays.len()).filter(|index| is_single[*index]);
        trace_rest::<S, Q>(simd, target, rays, rest, answers, stacks);
    }
}

/// The numbers of up to 256 rays in the order of their kinds, and where those of each kind begin.
#[inline(always)]
fn sorted_by_kind<S: Simd>(simd: S, rays: &[Ray]) -> ([u8; MANY], [usize; SLOTS + 1]) {
    let mut kinds = [0_u32; MANY];
    let mut starts = [0; SLOTS + 1];
    let count = rays.len().min(MANY);
    for (kinds, rays) in kinds.as_chunks_mut::<WIDTH>().0.iter_mut().zip(rays.chunks(WIDTH)) {
        *kinds = kinds_of(simd, rays);
    }
    let (kinds, _) = kinds.split_at(count);
    for &kind in kinds {
        starts[(kind as usize % SLOTS) + 1] += 1;
    }
    for number in 0..SLOTS {
        starts[number + 1] += starts[number];
    }
    let (mut order, mut next) = ([0; MANY], starts);
    for (ray, kind) in (0_u8..=u8::MAX).zip(kinds.iter()) {
        let at = &mut next[*kind as usize % SLOTS];
        order[*at % MANY] = ray;
        *at += 1;
    }
    (order, starts)
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
