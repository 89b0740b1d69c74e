//! The corners of the triangles that sixteen samples see: what interpolation starts from.

use glam::{DMat3, DVec3};
use luxel_math::{LANES, Simd, Vec3, f32x16, prelude::*};
use luxel_scene::Mesh;
use luxel_visibility::{Frame, TriangleId, TriangleOf};

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
    /// Which of the optional ones any triangle has.
    pub(crate) has: Attributes,
}

/// What meshes carry beside positions and normals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Attributes {
    pub(crate) tangents: bool,
    pub(crate) uvs: [bool; 2],
    pub(crate) colors: bool,
}

/// An instance's transforms for shading.
pub(crate) struct InstanceSpace {
    /// From view space to world axes about the eye: a rotation.
    pub(crate) world_from_view: DMat3,
    /// For normals: the inverse transpose of the mesh's transform, up to a positive factor.
    pub(crate) normal_from_mesh: DMat3,
    /// For tangents.
    pub(crate) world_from_mesh: DMat3,
    /// -1 where the transform mirrors, else 1.
    pub(crate) handedness: f64,
    /// Whether the camera's rays are parallel.
    pub(crate) parallel: bool,
}

const ZERO: CornerValue = CornerValue([[0.0; LANES]; 3]);

impl Corners {
    pub(crate) fn new() -> Self {
        Self {
            uniform: false,
            position: [ZERO; 3],
            normal: [ZERO; 3],
            tangent: [ZERO; 4],
            uv: [[ZERO; 2]; 2],
            color: [ZERO; 4],
            has: Attributes::default(),
        }
    }

    /// Starts anew, for samples that all see one triangle (`uniform`) or don't.
    pub(crate) fn reset(&mut self, uniform: bool) {
        self.uniform = uniform;
        self.has = Attributes::default();
    }

    /// Takes the corners of one triangle for the lanes whose bit is set.
    pub(crate) fn set(
        &mut self,
        frame: &Frame<'_>,
        space: &InstanceSpace,
        of: TriangleOf,
        corners_in_view: [DVec3; 3],
        lanes: u32,
    ) {
        let mesh = frame.instances()[of.instance].mesh;
        let attributes = mesh.attribute_corners()[of.triangle as usize];
        let places = corners_in_view.map(|corner| space.world_from_view * corner);
        let normals = normals(mesh, space, attributes, places);
        let lanes = if self.uniform { 1 } else { lanes };
        for (corner, &attribute) in attributes.iter().enumerate() {
            let position = places[corner].as_vec3().to_array();
            put(&mut self.position, corner, lanes, position);
            put(&mut self.normal, corner, lanes, normals[corner]);
            let at = attribute as usize;
            for (set, uvs) in mesh.uvs.iter().enumerate() {
                if let Some(&uv) = uvs.get(at) {
                    self.has.uvs[set] = true;
                    put(&mut self.uv[set], corner, lanes, uv);
                }
            }
            if let Some(&[x, y, z, sign]) = mesh.tangents.get(at) {
                self.has.tangents = true;
                let tangent = space.world_from_mesh * DVec3::new(x.into(), y.into(), z.into());
                let [x, y, z] = tangent.normalize_or_zero().as_vec3().to_array();
                let sign = if space.handedness < 0.0 { -sign } else { sign };
                put(&mut self.tangent, corner, lanes, [x, y, z, sign]);
            }
            // Triangles without colours beside coloured ones are white.
            let color = mesh.colors.get(at).copied();
            self.has.colors |= color.is_some();
            put(&mut self.color, corner, lanes, color.unwrap_or([1.0; 4]));
        }
    }

    #[inline(always)]
    fn interpolate<S: Simd>(&self, value: &CornerValue, weights: &[f32x16<S>; 3]) -> f32x16<S> {
        let at = |corner: usize| &value.0[corner];
        let simd = weights[0].simd;
        let [a, b, c] = if self.uniform {
            [
                f32x16::splat(simd, at(0)[0]),
                f32x16::splat(simd, at(1)[0]),
                f32x16::splat(simd, at(2)[0]),
            ]
        } else {
            [
                f32x16::simd_from(simd, *at(0)),
                f32x16::simd_from(simd, *at(1)),
                f32x16::simd_from(simd, *at(2)),
            ]
        };
        a * weights[0] + b * weights[1] + c * weights[2]
    }

    #[inline(always)]
    fn interpolate3<S: Simd>(
        &self,
        values: &[CornerValue],
        weights: &[f32x16<S>; 3],
    ) -> Vec3<f32x16<S>> {
        Vec3::new(
            self.interpolate(&values[0], weights),
            self.interpolate(&values[1], weights),
            self.interpolate(&values[2], weights),
        )
    }

    /// The place, about the eye.
    #[inline(always)]
    pub(crate) fn position<S: Simd>(&self, weights: &[f32x16<S>; 3]) -> Vec3<f32x16<S>> {
        self.interpolate3(&self.position, weights)
    }

    /// The interpolated normal, not of unit length.
    #[inline(always)]
    pub(crate) fn normal<S: Simd>(&self, weights: &[f32x16<S>; 3]) -> Vec3<f32x16<S>> {
        self.interpolate3(&self.normal, weights)
    }

    /// The interpolated tangent and the bitangent's sign.
    #[inline(always)]
    pub(crate) fn tangent<S: Simd>(
        &self,
        weights: &[f32x16<S>; 3],
    ) -> (Vec3<f32x16<S>>, f32x16<S>) {
        (self.interpolate3(&self.tangent, weights), self.interpolate(&self.tangent[3], weights))
    }

    /// Texture coordinates.
    #[inline(always)]
    pub(crate) fn uv<S: Simd>(&self, set: usize, weights: &[f32x16<S>; 3]) -> [f32x16<S>; 2] {
        let [u, v] = &self.uv[set & 1];
        [self.interpolate(u, weights), self.interpolate(v, weights)]
    }

    /// Colour and alpha.
    #[inline(always)]
    pub(crate) fn color<S: Simd>(&self, weights: &[f32x16<S>; 3]) -> [f32x16<S>; 4] {
        [
            self.interpolate(&self.color[0], weights),
            self.interpolate(&self.color[1], weights),
            self.interpolate(&self.color[2], weights),
            self.interpolate(&self.color[3], weights),
        ]
    }
}

/// Writes a tuple of components at a corner of the lanes whose bit is set.
fn put<const N: usize>(values: &mut [CornerValue; N], corner: usize, lanes: u32, tuple: [f32; N]) {
    for (value, component) in values.iter_mut().zip(tuple) {
        for (lane, slot) in value.0[corner].iter_mut().enumerate() {
            if lanes >> lane & 1 == 1 {
                *slot = component;
            }
        }
    }
}

/// A triangle's unit vertex normals in world space, turned to the side that is seen.
///
/// Which side that is, the face's plane decides, pointed along the sum of the vertex normals (by
/// winding where that is 0), so that a file with reversed winding is not black.
fn normals(
    mesh: &Mesh,
    space: &InstanceSpace,
    attributes: [u32; 3],
    places: [DVec3; 3],
) -> [[f32; 3]; 3] {
    let [a, b, c] = places;
    let by_winding = (b - a).cross(c - a) * space.handedness;
    let normals = if mesh.normals.is_empty() {
        [by_winding.normalize_or_zero(); 3]
    } else {
        attributes.map(|attribute| {
            let [x, y, z] = mesh.normals[attribute as usize];
            let normal = space.normal_from_mesh * DVec3::new(x.into(), y.into(), z.into());
            normal.normalize_or_zero()
        })
    };
    let sum = normals[0] + normals[1] + normals[2];
    let outwards = if by_winding.dot(sum) < 0.0 { -by_winding } else { by_winding };
    let to_eye = if space.parallel { space.world_from_view.z_axis } else { -a };
    let from_behind = outwards.dot(to_eye) < 0.0;
    normals.map(|normal| (if from_behind { -normal } else { normal }).as_vec3().to_array())
}

/// The distinct triangles that the lanes see, each with its lanes; those that see nothing left out.
pub(crate) fn distinct(ids: &[u32; LANES]) -> impl Iterator<Item = (TriangleId, u32)> + '_ {
    let mut left: u32 = 0;
    for (lane, &id) in ids.iter().enumerate() {
        left |= u32::from(id != TriangleId::NONE.0) << lane;
    }
    std::iter::from_fn(move || {
        if left == 0 {
            return None;
        }
        let id = ids[left.trailing_zeros() as usize];
        let mut lanes = 0;
        for (lane, &other) in ids.iter().enumerate() {
            lanes |= u32::from(other == id) << lane;
        }
        left &= !lanes;
        Some((TriangleId(id), lanes))
    })
}
