//! Everything that `glPushAttrib` can save (OpenGL 1.5, section 6.1.13).

use super::current::Current;
use super::enables::Enables;
use super::evaluator::Grids;
use super::fragment::{ColorBuffer, Depth, FogState, PixelBox, Stencil};
use super::light::Lights;
use super::material::{ColorMaterial, SurfaceMaterial};
use super::pixel::PixelMode;
use super::polygon::{Lines, Points, Polygons};
use super::texture_unit::TextureState;
use super::window::{ClipControl, Viewport, WindowTransform};
use crate::enums as gl;
use crate::limits::CLIP_PLANES;

/// The server's state but for matrix stacks and objects.
#[derive(Clone, Debug, Default)]
pub(crate) struct Attributes {
    pub(crate) current: Current,
    pub(crate) enables: Enables,
    pub(crate) lights: Lights,
    /// Front and back.
    pub(crate) materials: [SurfaceMaterial; 2],
    pub(crate) color_material: ColorMaterial,
    pub(crate) transform: Transform,
    pub(crate) viewport: Viewport,
    pub(crate) points: Points,
    pub(crate) lines: Lines,
    pub(crate) polygons: Polygons,
    pub(crate) fog: FogState,
    pub(crate) scissor: PixelBox,
    pub(crate) stencil: Stencil,
    pub(crate) depth: Depth,
    pub(crate) color: ColorBuffer,
    pub(crate) clear_accum: [f32; 4],
    pub(crate) read_buffer: ReadBuffer,
    pub(crate) sample_coverage: SampleCoverage,
    pub(crate) pixel: PixelMode,
    pub(crate) hints: Hints,
    pub(crate) list_base: u32,
    pub(crate) active_texture: usize,
    pub(crate) texture: TextureState,
    pub(crate) grids: Grids,
}

/// Of `GL_TRANSFORM_BIT`.
#[derive(Clone, Debug)]
pub(crate) struct Transform {
    pub(crate) matrix_mode: u32,
    /// The user's planes in eye coordinates.
    pub(crate) planes: [[f64; 4]; CLIP_PLANES],
    pub(crate) clip: ClipControl,
}

/// `glReadBuffer`
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReadBuffer(pub(crate) u32);

/// `glSampleCoverage`: the part of the samples, and whether it is the other part.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SampleCoverage(pub(crate) (f32, bool));

/// The hints.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hints(pub(crate) [u32; 7]);

impl Hints {
    /// Targets, in the order of the values.
    pub(crate) const TARGETS: [u32; 7] = [
        gl::PERSPECTIVE_CORRECTION_HINT,
        gl::POINT_SMOOTH_HINT,
        gl::LINE_SMOOTH_HINT,
        gl::POLYGON_SMOOTH_HINT,
        gl::FOG_HINT,
        gl::GENERATE_MIPMAP_HINT,
        gl::TEXTURE_COMPRESSION_HINT,
    ];
}

impl Default for Transform {
    fn default() -> Self {
        let planes = [[0.0; 4]; CLIP_PLANES];
        Self { matrix_mode: gl::MODELVIEW, planes, clip: ClipControl::default() }
    }
}

impl Default for ReadBuffer {
    fn default() -> Self {
        Self(gl::FRONT)
    }
}

impl Default for SampleCoverage {
    fn default() -> Self {
        Self((1.0, false))
    }
}

impl Default for Hints {
    fn default() -> Self {
        Self([gl::DONT_CARE; 7])
    }
}

impl Attributes {
    /// From clip coordinates to the window.
    pub(crate) fn window_transform(&self) -> WindowTransform {
        WindowTransform { viewport: self.viewport, clip: self.transform.clip }
    }

    /// Takes over from `saved` the groups of a mask (table 6.4 and the tables of its section).
    pub(crate) fn restore(&mut self, saved: &Self, mask: u32) {
        let has = |group: u32| mask & group != 0;
        self.enables.restore(&saved.enables, mask);
        if has(gl::CURRENT_BIT) {
            self.current = saved.current.clone();
        }
        if has(gl::LIGHTING_BIT) {
            self.lights = saved.lights.clone();
            self.materials = saved.materials;
            self.color_material = saved.color_material;
        }
        if has(gl::TRANSFORM_BIT) {
            self.transform = saved.transform.clone();
        }
        if has(gl::VIEWPORT_BIT) {
            self.viewport = saved.viewport;
        }
        if has(gl::POINT_BIT) {
            self.points = saved.points.clone();
        }
        if has(gl::LINE_BIT) {
            self.lines = saved.lines.clone();
        }
        if has(gl::POLYGON_BIT) {
            self.polygons = Polygons { stipple: self.polygons.stipple, ..saved.polygons };
        }
        if has(gl::POLYGON_STIPPLE_BIT) {
            self.polygons.stipple = saved.polygons.stipple;
        }
        if has(gl::FOG_BIT) {
            self.fog = saved.fog.clone();
        }
        if has(gl::SCISSOR_BIT) {
            self.scissor = saved.scissor;
        }
        if has(gl::STENCIL_BUFFER_BIT) {
            self.stencil = saved.stencil.clone();
        }
        if has(gl::DEPTH_BUFFER_BIT) {
            self.depth = saved.depth.clone();
        }
        if has(gl::COLOR_BUFFER_BIT) {
            self.color = saved.color.clone();
        }
        if has(gl::MULTISAMPLE_BIT) {
            self.sample_coverage = saved.sample_coverage;
        }
        if has(gl::ACCUM_BUFFER_BIT) {
            self.clear_accum = saved.clear_accum;
        }
        if has(gl::PIXEL_MODE_BIT) {
            self.read_buffer = saved.read_buffer;
            self.pixel = saved.pixel.clone();
        }
        if has(gl::HINT_BIT) {
            self.hints = saved.hints;
        }
        if has(gl::LIST_BIT) {
            self.list_base = saved.list_base;
        }
        if has(gl::EVAL_BIT) {
            self.grids = saved.grids;
        }
        if has(gl::TEXTURE_BIT) {
            self.active_texture = saved.active_texture;
            self.texture.restore(&saved.texture);
        }
    }
}
