//! The state of fragments of one draw, all of it: equal state is one pipeline.

use super::framebuffer::Uses;
use super::samples::Multisample;
use crate::enums as gl;
use crate::fragment::TextureStages;
use crate::state::Attributes;
use crate::state::fragment::FogState;
use crate::texture::BaseFormat;
use luxel_lighting::{Fog, FogLaw};

/// How fragments are tested and written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Pipeline {
    /// Pixels that may be drawn to: left, bottom, right and top, the last two beyond.
    pub(crate) region: [i32; 4],
    /// Comparison, and whether depths are written; `None` without test.
    pub(crate) depth: Option<(u32, bool)>,
    pub(crate) stencil: Option<StencilTest>,
    /// The bits of a colour that are written.
    pub(crate) color_bits: u32,
    /// Of polygons: 32 rows of 32 bits, the first pixel's highest.
    pub(crate) polygon_stipple: Option<[u32; 32]>,
    /// Of lines: how many fragments a bit stands for, and the bits.
    pub(crate) line_stipple: Option<(u32, u16)>,
    pub(crate) textures: Option<TextureStages>,
    pub(crate) fog: Option<Fog>,
    /// Comparison and reference.
    pub(crate) alpha_test: Option<(u32, f32)>,
    pub(crate) blend: Option<Blend>,
    pub(crate) logic_op: Option<u32>,
    /// `None` with one sample, and where all of a pixel's samples are alike.
    pub(crate) multisample: Option<Multisample>,
}

/// The stencil test; values have 8 bits.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StencilTest {
    pub(crate) func: u32,
    pub(crate) reference: u32,
    pub(crate) value_mask: u32,
    pub(crate) write_mask: u32,
    /// What happens where the test fails, where depth fails, where both pass.
    pub(crate) operations: [u32; 3],
}

/// Blending.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Blend {
    /// Of colours, then of alphas.
    pub(crate) equations: [u32; 2],
    /// Factors of the source's and destination's colours, then of their alphas.
    pub(crate) factors: [u32; 4],
    pub(crate) constant: [f32; 4],
}

/// What a framebuffer has beside red, green and blue.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Buffers {
    /// The components of colours.
    pub(crate) color: BaseFormat,
    pub(crate) depth: bool,
    pub(crate) stencil: bool,
    /// Whether a pixel has several samples.
    pub(crate) samples: bool,
}

impl Pipeline {
    pub(crate) fn new(
        state: &Attributes,
        buffers: Buffers,
        region: [i32; 4],
        color_bits: u32,
        textures: Option<TextureStages>,
    ) -> Self {
        let has = |name: u32| state.enables.has(name);
        let color = &state.color;
        let stencil = &state.stencil;
        let logic_op =
            (has(gl::COLOR_LOGIC_OP) && color.logic_op != gl::COPY).then_some(color.logic_op);
        let blend = Blend {
            equations: color.blend_equations,
            factors: color.blend.map(|factor| in_format(factor, buffers.color)),
            constant: color.blend_color,
        };
        let color_bits = if color.draw_buffer == gl::NONE { 0 } else { color_bits };
        Self {
            region,
            depth: (has(gl::DEPTH_TEST) && buffers.depth)
                .then_some((state.depth.func, state.depth.mask)),
            stencil: (has(gl::STENCIL_TEST) && buffers.stencil).then(|| StencilTest {
                func: stencil.func,
                reference: stencil.reference.clamp(0, 255) as u32,
                value_mask: stencil.value_mask & 255,
                write_mask: stencil.write_mask & 255,
                operations: [stencil.fail, stencil.depth_fail, stencil.pass],
            }),
            color_bits,
            polygon_stipple: has(gl::POLYGON_STIPPLE).then_some(state.polygons.stipple),
            line_stipple: has(gl::LINE_STIPPLE)
                .then_some((state.lines.factor as u32, state.lines.pattern)),
            textures,
            fog: has(gl::FOG).then(|| fog(&state.fog)),
            alpha_test: (has(gl::ALPHA_TEST) && color.alpha_func != gl::ALWAYS)
                .then_some((color.alpha_func, color.alpha_reference)),
            // A logical operation takes the place of blending (section 4.1.10).
            blend: (has(gl::BLEND) && !has(gl::COLOR_LOGIC_OP) && !blend.replaces())
                .then_some(blend),
            logic_op,
            multisample: (buffers.samples && has(gl::MULTISAMPLE)).then(|| Multisample {
                alpha_to_coverage: has(gl::SAMPLE_ALPHA_TO_COVERAGE),
                alpha_to_one: has(gl::SAMPLE_ALPHA_TO_ONE),
                coverage: has(gl::SAMPLE_COVERAGE).then_some(state.sample_coverage.0),
            }),
        }
    }

    /// The planes that fragments are tested by or written to.
    #[inline(always)]
    pub(super) fn uses(&self) -> Uses {
        Uses {
            color: self.color_bits != 0,
            depth: self.depth.is_some(),
            stencil: self.stencil.is_some(),
        }
    }

    /// Whether colours that are there, or alphas that come, decide what is written.
    pub(crate) fn is_mixing(&self) -> bool {
        let partial = self.color_bits != 0 && self.color_bits != u32::MAX;
        let mixes = self.blend.is_some() || self.logic_op.is_some() || partial;
        let by_alpha = self.multisample.as_ref().is_some_and(Multisample::needs_colors);
        self.alpha_test.is_some() || by_alpha || self.color_bits != 0 && mixes
    }
}

/// A factor by the alphas that colours of a format have: those of intensities are their red, those that aren't there 1.
fn in_format(factor: u32, format: BaseFormat) -> u32 {
    match (factor, format) {
        (_, BaseFormat::Alpha | BaseFormat::LuminanceAlpha | BaseFormat::Rgba) => factor,
        (gl::DST_ALPHA, BaseFormat::Intensity) => gl::DST_COLOR,
        (gl::ONE_MINUS_DST_ALPHA, BaseFormat::Intensity) => gl::ONE_MINUS_DST_COLOR,
        (gl::DST_ALPHA, _) => gl::ONE,
        (gl::ONE_MINUS_DST_ALPHA | gl::SRC_ALPHA_SATURATE, _) => gl::ZERO,
        _ => factor,
    }
}

impl Blend {
    /// Whether the source takes the place of what is there.
    fn replaces(&self) -> bool {
        self.equations == [gl::FUNC_ADD; 2]
            && self.factors == [gl::ONE, gl::ZERO, gl::ONE, gl::ZERO]
    }
}

/// GL's fog as luxel's (section 3.10). Linear fog that ends before it starts is that of the opposite way.
fn fog(state: &FogState) -> Fog {
    let [r, g, b, _] = state.color;
    let law = match state.mode {
        gl::EXP => FogLaw::Exponential { density: state.density },
        gl::EXP2 => FogLaw::ExponentialSquared { density: state.density },
        _ if state.end < state.start => {
            FogLaw::DepthCue { near: state.end, far: state.start, front: 0.0, back: 1.0 }
        }
        _ => FogLaw::DepthCue { near: state.start, far: state.end, front: 1.0, back: 0.0 },
    };
    Fog { color: [r, g, b], law }
}
