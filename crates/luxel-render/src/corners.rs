//! The corners of the triangles that sixteen samples see: what interpolation starts from.

use crate::triangles::{Attributes, Corner};
use crate::view::ShadingMode;
use luxel_math::{LANES, Number, Rgb, Vec3};

/// One value at each of three corners, for sixteen samples.
#[derive(Clone, Copy)]
pub(crate) struct CornerValue([[f32; LANES]; 3]);

/// The triangles of sixteen samples.
///
/// Where all samples see one triangle, as in the middle of large ones, only lane 0 of the values is
/// written and all lanes read that.
pub(crate) struct Corners {
    uniform: bool,
    /// Corner positions about the eye, along the world's axes.
    position: [CornerValue; 3],
    /// Unit normals in world space, turned to the side that is seen.
    normal: [CornerValue; 3],
    /// Unit tangents in world space with the bitangent's sign.
    tangent: [CornerValue; 4],
    /// Two sets of texture coordinates.
    uv: [[CornerValue; 2]; 2],
    /// Colours with alpha.
    color: [CornerValue; 4],
    /// Light that was computed at the corners.
    light: [CornerValue; 3],
    /// Light of each lane that was computed elsewhere and is not to be interpolated here.
    lane_light: [[f32; LANES]; 3],
    /// Whether `light` is written.
    lights: bool,
    /// Which of the optional ones any triangle of the scene has: those are written for every
    /// triangle, as nothing may be left from another.
    written: Attributes,
    /// Which of them any triangle of these sixteen has.
    pub(crate) has: Attributes,
}

const ZERO: CornerValue = CornerValue([[0.0; LANES]; 3]);

impl Corners {
    /// For the triangles of a scene with these attributes; `lights` tells whether their corners
    /// bring light.
    pub(crate) fn new(written: Attributes, lights: bool) -> Self {
        Self {
            uniform: false,
            written,
            position: [ZERO; 3],
            normal: [ZERO; 3],
            tangent: [ZERO; 4],
            uv: [[ZERO; 2]; 2],
            color: [ZERO; 4],
            light: [ZERO; 3],
            lane_light: [[0.0; LANES]; 3],
            lights,
            has: Attributes::default(),
        }
    }

    /// Starts anew, for samples that all see one triangle (`uniform`) or don't.
    pub(crate) fn reset(&mut self, uniform: bool) {
        self.uniform = uniform;
        self.has = Attributes::default();
    }

    /// Takes the corners of one triangle, with what its mesh has, for the lanes whose bit is set.
    pub(crate) fn set(&mut self, corners: &[Corner; 3], has: Attributes, lanes: u32) {
        let lanes = if self.uniform { 1 } else { lanes };
        self.has.tangents |= has.tangents;
        self.has.colors |= has.colors;
        self.has.uvs[0] |= has.uvs[0];
        self.has.uvs[1] |= has.uvs[1];
        for (corner, values) in corners.iter().enumerate() {
            put(&mut self.position, corner, lanes, values.position);
            put(&mut self.normal, corner, lanes, values.normal);
            for set in (0..2).filter(|&set| self.written.uvs[set]) {
                put(&mut self.uv[set], corner, lanes, values.uv[set]);
            }
            if self.written.tangents {
                put(&mut self.tangent, corner, lanes, values.tangent);
            }
            if self.written.colors {
                put(&mut self.color, corner, lanes, values.color);
            }
            if self.lights {
                put(&mut self.light, corner, lanes, values.light);
            }
        }
    }

    /// Takes the light of a lane that was computed elsewhere.
    pub(crate) fn set_light(&mut self, lane: usize, light: [f32; 3]) {
        for (channel, value) in self.lane_light.iter_mut().zip(light) {
            channel[lane & (LANES - 1)] = value;
        }
    }

    #[inline(always)]
    fn interpolate<N: Number>(&self, value: &CornerValue, weights: &[N; 3]) -> N {
        let at = |corner: usize| &value.0[corner];
        let like = weights[0];
        let [a, b, c] = if self.uniform {
            [like.constant(at(0)[0]), like.constant(at(1)[0]), like.constant(at(2)[0])]
        } else {
            [like.of_lanes(at(0)), like.of_lanes(at(1)), like.of_lanes(at(2))]
        };
        a * weights[0] + b * weights[1] + c * weights[2]
    }

    #[inline(always)]
    fn interpolate3<N: Number>(&self, values: &[CornerValue], weights: &[N; 3]) -> Vec3<N> {
        Vec3::new(
            self.interpolate(&values[0], weights),
            self.interpolate(&values[1], weights),
            self.interpolate(&values[2], weights),
        )
    }

    /// The place, about the eye.
    #[inline(always)]
    pub(crate) fn position<N: Number>(&self, weights: &[N; 3]) -> Vec3<N> {
        self.interpolate3(&self.position, weights)
    }

    /// The interpolated normal, not of unit length.
    #[inline(always)]
    pub(crate) fn normal<N: Number>(&self, weights: &[N; 3]) -> Vec3<N> {
        self.interpolate3(&self.normal, weights)
    }

    /// The interpolated tangent and the bitangent's sign.
    #[inline(always)]
    pub(crate) fn tangent<N: Number>(&self, weights: &[N; 3]) -> (Vec3<N>, N) {
        (self.interpolate3(&self.tangent, weights), self.interpolate(&self.tangent[3], weights))
    }

    /// The light that was computed at the corners, or for whole pieces.
    #[inline(always)]
    pub(crate) fn light<N: Number>(&self, mode: ShadingMode, weights: &[N; 3]) -> Rgb<N> {
        let like = weights[0];
        if mode == ShadingMode::Gouraud {
            let Vec3 { x, y, z } = self.interpolate3(&self.light, weights);
            return Rgb::new(x, y, z);
        }
        let [r, g, b] = &self.lane_light;
        Rgb::new(like.of_lanes(r), like.of_lanes(g), like.of_lanes(b))
    }

    /// Texture coordinates.
    #[inline(always)]
    pub(crate) fn uv<N: Number>(&self, set: usize, weights: &[N; 3]) -> [N; 2] {
        let [u, v] = &self.uv[set & 1];
        [self.interpolate(u, weights), self.interpolate(v, weights)]
    }

    /// Colour and alpha.
    #[inline(always)]
    pub(crate) fn color<N: Number>(&self, weights: &[N; 3]) -> [N; 4] {
        [
            self.interpolate(&self.color[0], weights),
            self.interpolate(&self.color[1], weights),
            self.interpolate(&self.color[2], weights),
            self.interpolate(&self.color[3], weights),
        ]
    }
}

/// Writes a tuple of components at a corner of the lanes whose bit is set.
#[inline(always)]
fn put<const N: usize>(values: &mut [CornerValue; N], corner: usize, lanes: u32, tuple: [f32; N]) {
    for lane in lanes_of(lanes) {
        for component in 0..N {
            values[component].0[corner][lane & (LANES - 1)] = tuple[component];
        }
    }
}

/// The numbers of the bits set.
#[inline(always)]
pub(crate) fn lanes_of(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}
