//! Texture environments (OpenGL 1.5, section 3.8.13, tables 3.22 to 3.25), in lanes.

use super::stages::Stage;
use crate::enums as gl;
use crate::limits::TEXTURE_UNITS;
use crate::texture::BaseFormat;
use luxel_math::Lanes;

/// The colour after a stage, within 0 and 1, from its own texel, those of all units, the fragment's colour and the
/// colour before.
#[inline(always)]
pub(super) fn combined<N: Lanes>(
    stage: &Stage,
    texel: [N; 4],
    texel_of: impl Fn(usize) -> [N; 4],
    primary: [N; 4],
    previous: [N; 4],
) -> [N; 4] {
    let mut color = if stage.environment.mode == gl::COMBINE {
        by_functions(stage, texel, texel_of, primary, previous)
    } else {
        by_mode(stage, texel, previous)
    };
    for value in &mut color {
        *value = value.clamped(0.0, 1.0);
    }
    color
}

/// The five modes of tables 3.22 and 3.23.
#[inline(always)]
fn by_mode<N: Lanes>(stage: &Stage, texel: [N; 4], before: [N; 4]) -> [N; 4] {
    let (alpha_before, alpha) = (before[3], texel[3]);
    let base = stage.texture.base;
    let has_color = base != BaseFormat::Alpha;
    let has_alpha = !matches!(base, BaseFormat::Luminance | BaseFormat::Rgb);
    let constant = stage.environment.color;
    let mut color = before;
    if has_alpha {
        color[3] = alpha_before * alpha;
    }
    let is_intensity = base == BaseFormat::Intensity;
    match stage.environment.mode {
        gl::REPLACE => {
            for channel in 0..3 {
                if has_color {
                    color[channel] = texel[channel];
                }
            }
            color[3] = if has_alpha { alpha } else { alpha_before };
        }
        gl::DECAL => {
            // Defined for RGB and RGBA alone; others are left as they are.
            for channel in 0..3 {
                color[channel] = match base {
                    BaseFormat::Rgb => texel[channel],
                    BaseFormat::Rgba => mix(before[channel], texel[channel], alpha),
                    _ => before[channel],
                };
            }
            color[3] = alpha_before;
        }
        gl::BLEND => {
            for channel in 0..3 {
                if has_color {
                    let to = alpha.constant(constant[channel]);
                    color[channel] = mix(before[channel], to, texel[channel]);
                }
            }
            if is_intensity {
                color[3] = mix(alpha_before, alpha.constant(constant[3]), alpha);
            }
        }
        gl::ADD => {
            for channel in 0..3 {
                if has_color {
                    color[channel] = before[channel] + texel[channel];
                }
            }
            if is_intensity {
                color[3] = alpha_before + alpha;
            }
        }
        _ => {
            for channel in 0..3 {
                if has_color {
                    color[channel] = before[channel] * texel[channel];
                }
            }
        }
    }
    color
}

/// (1 - by) from + by to
#[inline(always)]
fn mix<N: Lanes>(from: N, to: N, by: N) -> N {
    from * (by.one() - by) + to * by
}

/// `GL_COMBINE`: functions of three arguments for colours and for alphas.
#[inline(always)]
fn by_functions<N: Lanes>(
    stage: &Stage,
    texel: [N; 4],
    texel_of: impl Fn(usize) -> [N; 4],
    primary: [N; 4],
    previous: [N; 4],
) -> [N; 4] {
    let simd = primary[0];
    let environment = &stage.environment;
    let [of_color, of_alpha] = environment.combine;
    let mut arguments = [[[simd.zero(); 4]; 3]; 2];
    for (of, arguments) in arguments.iter_mut().enumerate() {
        for (number, argument) in arguments.iter_mut().enumerate() {
            let source = match environment.sources[of][number] {
                gl::PREVIOUS => previous,
                gl::PRIMARY_COLOR => primary,
                gl::CONSTANT => {
                    let [r, g, b, a] = environment.color;
                    [simd.constant(r), simd.constant(g), simd.constant(b), simd.constant(a)]
                }
                gl::TEXTURE => texel,
                name => texel_of(name.wrapping_sub(gl::TEXTURE0) as usize % TEXTURE_UNITS),
            };
            *argument = operand(environment.operands[of][number], source);
        }
    }
    let [colors, alphas] = &arguments;
    let [color_scale, alpha_scale] = environment.scales;
    let mut color = [simd.zero(); 4];
    for (channel, value) in color[..3].iter_mut().enumerate() {
        *value = function(of_color, colors, channel) * simd.constant(color_scale);
    }
    color[3] = if of_color == gl::DOT3_RGBA {
        color[0]
    } else {
        function(of_alpha, alphas, 3) * simd.constant(alpha_scale)
    };
    color
}

/// An argument as its operand makes it.
#[inline(always)]
fn operand<N: Lanes>(name: u32, source: [N; 4]) -> [N; 4] {
    let mut argument = match name {
        gl::SRC_COLOR | gl::ONE_MINUS_SRC_COLOR => source,
        _ => [source[3]; 4],
    };
    if matches!(name, gl::ONE_MINUS_SRC_COLOR | gl::ONE_MINUS_SRC_ALPHA) {
        for value in &mut argument {
            *value = value.one() - *value;
        }
    }
    argument
}

/// A function of table 3.24 in a channel.
#[inline(always)]
fn function<N: Lanes>(name: u32, arguments: &[[N; 4]; 3], channel: usize) -> N {
    let [a, b, c] = [arguments[0][channel], arguments[1][channel], arguments[2][channel]];
    let half = a.constant(0.5);
    match name {
        gl::REPLACE => a,
        gl::MODULATE => a * b,
        gl::ADD => a + b,
        gl::ADD_SIGNED => a + b - half,
        gl::INTERPOLATE => a * c + b * (a.one() - c),
        gl::SUBTRACT => a - b,
        // 4 ((a_r - 1/2)(b_r - 1/2) + ...), the same in all channels.
        _ => {
            let [first, second, _] = arguments;
            let mut sum = a.zero();
            for channel in 0..3 {
                sum = sum + (first[channel] - half) * (second[channel] - half);
            }
            a.constant(4.0) * sum
        }
    }
}
