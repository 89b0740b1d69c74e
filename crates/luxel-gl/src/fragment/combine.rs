//! Texture environments (OpenGL 1.5, section 3.8.13, tables 3.22 to 3.25), in lanes.

use super::stages::Stage;
use crate::enums as gl;
use crate::limits::TEXTURE_UNITS;
use crate::texture::BaseFormat;
use luxel_math::Lanes;

/// The colour after a stage, within 0 and 1, from the texels of all units, the fragment's own colour and the colour
/// before.
#[inline(always)]
pub(super) fn combined<N: Lanes>(
    stage: &Stage,
    texels: &[[N; 4]; TEXTURE_UNITS],
    primary: [N; 4],
    previous: [N; 4],
) -> [N; 4] {
    let color = if stage.environment.mode == gl::COMBINE {
        by_functions(stage, texels, primary, previous)
    } else {
        by_mode(stage, texels[stage.unit], previous)
    };
    color.map(
        #[inline(always)]
        |value| value.clamped(0.0, 1.0),
    )
}

/// The five modes of tables 3.22 and 3.23.
#[inline(always)]
fn by_mode<N: Lanes>(stage: &Stage, texel: [N; 4], before: [N; 4]) -> [N; 4] {
    let [.., alpha_before] = before;
    let [.., alpha] = texel;
    let base = stage.texture.base;
    let one = alpha.one();
    let has_color = base != BaseFormat::Alpha;
    let has_alpha = !matches!(base, BaseFormat::Luminance | BaseFormat::Rgb);
    let constant = stage.environment.color;
    let product = if has_alpha { alpha_before * alpha } else { alpha_before };
    let mix = |from: N, to: N, by: N| from * (one - by) + to * by;
    let mut color = before;
    match stage.environment.mode {
        gl::REPLACE => {
            each(&mut color, has_color, |channel| texel[channel]);
            color[3] = if has_alpha { alpha } else { alpha_before };
        }
        gl::DECAL => {
            // Defined for RGB and RGBA alone; others are left as they are.
            if base == BaseFormat::Rgb {
                each(&mut color, has_color, |channel| texel[channel]);
            } else if base == BaseFormat::Rgba {
                each(&mut color, has_color, |channel| mix(before[channel], texel[channel], alpha));
            }
        }
        gl::BLEND => {
            each(&mut color, has_color, |channel| {
                mix(before[channel], alpha.constant(constant[channel]), texel[channel])
            });
            color[3] = if base == BaseFormat::Intensity {
                mix(alpha_before, alpha.constant(constant[3]), alpha)
            } else {
                product
            };
        }
        gl::ADD => {
            each(&mut color, has_color, |channel| before[channel] + texel[channel]);
            color[3] = if base == BaseFormat::Intensity { alpha_before + alpha } else { product };
        }
        _ => {
            each(&mut color, has_color, |channel| before[channel] * texel[channel]);
            color[3] = product;
        }
    }
    color
}

/// Sets red, green and blue where a texture has them.
#[inline(always)]
fn each<N: Lanes>(color: &mut [N; 4], has_color: bool, of: impl Fn(usize) -> N) {
    if has_color {
        for (channel, value) in color[..3].iter_mut().enumerate() {
            *value = of(channel);
        }
    }
}

/// `GL_COMBINE`: functions of three arguments for colours and for alphas.
#[inline(always)]
fn by_functions<N: Lanes>(
    stage: &Stage,
    texels: &[[N; 4]; TEXTURE_UNITS],
    primary: [N; 4],
    previous: [N; 4],
) -> [N; 4] {
    let simd = primary[0];
    let environment = &stage.environment;
    let source = |of: usize, argument: usize| -> [N; 4] {
        match environment.sources[of][argument] {
            gl::PREVIOUS => previous,
            gl::PRIMARY_COLOR => primary,
            gl::CONSTANT => environment.color.map(|value| simd.constant(value)),
            name => {
                let unit = name.wrapping_sub(gl::TEXTURE0) as usize;
                texels[if unit < TEXTURE_UNITS { unit } else { stage.unit }]
            }
        }
    };
    // The value of an argument in a channel, as its operand makes it.
    let argument = |of: usize, number: usize, channel: usize| {
        let color = source(of, number);
        match environment.operands[of][number] {
            gl::SRC_COLOR => color[channel],
            gl::ONE_MINUS_SRC_COLOR => simd.one() - color[channel],
            gl::ONE_MINUS_SRC_ALPHA => simd.one() - color[3],
            _ => color[3],
        }
    };
    let half = simd.constant(0.5);
    let function = |of: usize, channel: usize| {
        let [a, b, c] = [0, 1, 2].map(|number| argument(of, number, channel));
        match environment.combine[of] {
            gl::REPLACE => a,
            gl::MODULATE => a * b,
            gl::ADD => a + b,
            gl::ADD_SIGNED => a + b - half,
            gl::INTERPOLATE => a * c + b * (simd.one() - c),
            gl::SUBTRACT => a - b,
            // 4 ((a_r - 1/2)(b_r - 1/2) + ...), the same in all channels.
            _ => {
                let term =
                    |channel| (argument(0, 0, channel) - half) * (argument(0, 1, channel) - half);
                simd.constant(4.0) * (term(0) + term(1) + term(2))
            }
        }
    };
    let [color_scale, alpha_scale] = environment.scales.map(|scale| simd.constant(scale));
    let alpha = if environment.combine[0] == gl::DOT3_RGBA {
        function(0, 0) * color_scale
    } else {
        function(1, 3) * alpha_scale
    };
    [
        function(0, 0) * color_scale,
        function(0, 1) * color_scale,
        function(0, 2) * color_scale,
        alpha,
    ]
}
