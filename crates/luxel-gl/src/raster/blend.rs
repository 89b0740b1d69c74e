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

/// The factors of one side for red, green, blue and alpha by one name (table 4.2).
#[inline(always)]
fn factors_by<S: Simd>(
    name: u32,
    source: &Colors<S>,
    destination: &Colors<S>,
    constant: &[f32; 4],
) -> Colors<S> {
    let splat = |value: f32| f32x16::splat(source[0].simd, value);
    let one = splat(1.0);
    let rest_of = |[r, g, b, a]: Colors<S>| [one - r, one - g, one - b, one - a];
    let all = |value: f32x16<S>| [value; 4];
    let [r, g, b, a] = *constant;
    let of_constant = [splat(r), splat(g), splat(b), splat(a)];
    match name {
        gl::ZERO => all(splat(0.0)),
        gl::SRC_COLOR => *source,
        gl::ONE_MINUS_SRC_COLOR => rest_of(*source),
        gl::DST_COLOR => *destination,
        gl::ONE_MINUS_DST_COLOR => rest_of(*destination),
        gl::SRC_ALPHA => all(source[3]),
        gl::ONE_MINUS_SRC_ALPHA => all(one - source[3]),
        gl::DST_ALPHA => all(destination[3]),
        gl::ONE_MINUS_DST_ALPHA => all(one - destination[3]),
        gl::CONSTANT_COLOR => of_constant,
        gl::ONE_MINUS_CONSTANT_COLOR => rest_of(of_constant),
        gl::CONSTANT_ALPHA => all(splat(constant[3])),
        gl::ONE_MINUS_CONSTANT_ALPHA => all(splat(1.0 - constant[3])),
        gl::SRC_ALPHA_SATURATE => {
            let saturated = source[3].minimum(one - destination[3]);
            [saturated, saturated, saturated, one]
        }
        _ => all(one),
    }
}

/// The factors of one side, named for colours and for alpha.
#[inline(always)]
fn factors<S: Simd>(
    [of_colors, of_alpha]: [u32; 2],
    source: &Colors<S>,
    destination: &Colors<S>,
    constant: &[f32; 4],
) -> Colors<S> {
    let mut factors = factors_by(of_colors, source, destination, constant);
    if of_alpha != of_colors {
        factors[3] = factors_by(of_alpha, source, destination, constant)[3];
    }
    factors
}

/// Blends a source with what is there, within 0 and 1.
#[inline(always)]
pub(super) fn blended<S: Simd>(
    blend: &Blend,
    source: &Colors<S>,
    destination: &Colors<S>,
) -> Colors<S> {
    let [from, to, alpha_from, alpha_to] = blend.factors;
    let from = factors([from, alpha_from], source, destination, &blend.constant);
    let to = factors([to, alpha_to], source, destination, &blend.constant);
    let mut colors = *source;
    for (channel, color) in colors.iter_mut().enumerate() {
        let (s, d) = (source[channel], destination[channel]);
        let (weighted_s, weighted_d) = (s * from[channel], d * to[channel]);
        let blended = match blend.equations[usize::from(channel == 3)] {
            gl::MIN => s.minimum(d),
            gl::MAX => s.maximum(d),
            gl::FUNC_SUBTRACT => weighted_s - weighted_d,
            gl::FUNC_REVERSE_SUBTRACT => weighted_d - weighted_s,
            _ => weighted_s + weighted_d,
        };
        *color = blended.clamped(0.0, 1.0);
    }
    colors
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
