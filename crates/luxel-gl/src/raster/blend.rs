//! Comparisons, blending and logical operations (OpenGL 1.5, sections 4.1.4 to 4.1.10), in lanes.

use super::pipeline::Blend;
use super::shade::Colors;
use crate::enums as gl;
use luxel_math::{Lanes, Mask, Simd, f32x16, prelude::*, u32x16};

/// Where a value that comes passes the comparison with one that is there.
#[inline(always)]
pub(super) fn compare<N: Lanes>(func: u32, incoming: N, stored: N) -> N::Mask {
    match func {
        gl::NEVER => incoming.equal(incoming).splat_like(false),
        gl::LESS => incoming.less(stored),
        gl::LEQUAL => incoming.less_or_equal(stored),
        gl::EQUAL => incoming.equal(stored),
        gl::GREATER => stored.less(incoming),
        gl::GEQUAL => stored.less_or_equal(incoming),
        gl::NOTEQUAL => !incoming.equal(stored),
        _ => incoming.equal(incoming).splat_like(true),
    }
}

/// A channel's factor by its name (table 4.2).
#[inline(always)]
fn factor<S: Simd>(
    name: u32,
    channel: usize,
    source: &Colors<S>,
    destination: &Colors<S>,
    constant: &[f32; 4],
) -> f32x16<S> {
    let splat = |value: f32| f32x16::splat(source[0].simd, value);
    match name {
        gl::ZERO => splat(0.0),
        gl::SRC_COLOR => source[channel],
        gl::ONE_MINUS_SRC_COLOR => splat(1.0) - source[channel],
        gl::DST_COLOR => destination[channel],
        gl::ONE_MINUS_DST_COLOR => splat(1.0) - destination[channel],
        gl::SRC_ALPHA => source[3],
        gl::ONE_MINUS_SRC_ALPHA => splat(1.0) - source[3],
        gl::DST_ALPHA => destination[3],
        gl::ONE_MINUS_DST_ALPHA => splat(1.0) - destination[3],
        gl::CONSTANT_COLOR => splat(constant[channel]),
        gl::ONE_MINUS_CONSTANT_COLOR => splat(1.0 - constant[channel]),
        gl::CONSTANT_ALPHA => splat(constant[3]),
        gl::ONE_MINUS_CONSTANT_ALPHA => splat(1.0 - constant[3]),
        gl::SRC_ALPHA_SATURATE if channel < 3 => source[3].minimum(splat(1.0) - destination[3]),
        _ => splat(1.0),
    }
}

/// Blends a source with what is there, within 0 and 1.
#[inline(always)]
pub(super) fn blended<S: Simd>(
    blend: &Blend,
    source: &Colors<S>,
    destination: &Colors<S>,
) -> Colors<S> {
    [
        blended_channel(blend, 0, source, destination),
        blended_channel(blend, 1, source, destination),
        blended_channel(blend, 2, source, destination),
        blended_channel(blend, 3, source, destination),
    ]
}

/// One channel of what is blended: so, without a loop, all stay in registers.
#[inline(always)]
fn blended_channel<S: Simd>(
    Blend { equations, factors, constant }: &Blend,
    channel: usize,
    source: &Colors<S>,
    destination: &Colors<S>,
) -> f32x16<S> {
    let of_alpha = usize::from(channel == 3);
    let [from, to] = [factors[2 * of_alpha], factors[2 * of_alpha + 1]];
    let (s, d) = (source[channel], destination[channel]);
    let weighted_s = s * factor(from, channel, source, destination, constant);
    let weighted_d = d * factor(to, channel, source, destination, constant);
    let blended = match equations[of_alpha] {
        gl::MIN => s.minimum(d),
        gl::MAX => s.maximum(d),
        gl::FUNC_SUBTRACT => weighted_s - weighted_d,
        gl::FUNC_REVERSE_SUBTRACT => weighted_d - weighted_s,
        _ => weighted_s + weighted_d,
    };
    blended.clamped(0.0, 1.0)
}

/// A logical operation on bytes (table 4.4).
#[inline(always)]
pub(super) fn logic<S: Simd>(operation: u32, s: u32x16<S>, d: u32x16<S>) -> u32x16<S> {
    let all = u32x16::splat(s.simd, u32::MAX);
    let not = |value: u32x16<S>| value ^ all;
    match operation {
        gl::CLEAR => u32x16::splat(s.simd, 0),
        gl::AND => s & d,
        gl::AND_REVERSE => s & not(d),
        gl::AND_INVERTED => not(s) & d,
        gl::NOOP => d,
        gl::XOR => s ^ d,
        gl::OR => s | d,
        gl::NOR => not(s | d),
        gl::EQUIV => not(s ^ d),
        gl::INVERT => not(d),
        gl::OR_REVERSE => s | not(d),
        gl::COPY_INVERTED => not(s),
        gl::OR_INVERTED => not(s) | d,
        gl::NAND => not(s & d),
        gl::SET => all,
        _ => s,
    }
}
