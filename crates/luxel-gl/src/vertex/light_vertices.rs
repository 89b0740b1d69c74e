//! Vertices lit, sixteen at a time (OpenGL 1.5, section 2.13).
//!
//! Lighting is luxel's equation with the eye at the origin, in eye coordinates. A normal that nobody brings to unit
//! length scales what it reflects, as the specification's formula has it: |N| the diffuse and |N|^n the specular term.

use super::columns::color_lanes;
use super::light_setup::{LightSetup, SeparateSums, material};
use super::materials::Materials;
use super::view::VertexView;
use crate::enums as gl;
use crate::state::Attributes;
use crate::state::material::{ColorMaterial, SurfaceMaterial};
use luxel_lighting::{
    Coefficients, LightingEnvironment, Occlusion, Reflectance, Silent, SurfacePoint, lit_by,
};
use luxel_math::{LANES, Lanes, Vec3, elementary};

/// Lights, and what colours of vertices do to materials.
#[derive(Debug)]
pub(super) struct VertexLighting {
    setup: LightSetup,
    color_material: Option<ColorMaterial>,
}

/// Sixteen vertices in eye coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct LitPlace<N> {
    pub(super) eye: [N; 4],
    /// Of unit length.
    pub(super) normal: Vec3<N>,
    /// The length that it has by the specification; `None` for 1.
    pub(super) length: Option<N>,
}

/// The light of sixteen vertices on one side, and their alphas.
#[derive(Clone, Copy, Debug)]
pub(super) struct LitColors<N> {
    pub(super) sums: SeparateSums<N>,
    pub(super) alpha: N,
}

impl VertexLighting {
    pub(super) fn new(state: &Attributes) -> Self {
        let color_material = state.enables.has(gl::COLOR_MATERIAL).then_some(state.color_material);
        Self { setup: LightSetup::new(state), color_material }
    }

    /// How many sides are lit.
    pub(super) fn sides(&self) -> usize {
        1 + usize::from(self.setup.two_side)
    }

    /// Whether specular light is a colour of its own.
    pub(super) fn is_separate(&self) -> bool {
        self.setup.separate
    }

    /// The light of sixteen vertices, whose numbers are `at(lane)`, on a side.
    #[inline(always)]
    pub(super) fn lit<N: Lanes>(
        &self,
        place: &LitPlace<N>,
        side: usize,
        (vertices, materials): (&VertexView<'_>, &Materials),
        at: impl Fn(usize) -> usize,
    ) -> LitColors<N> {
        let simd = place.eye[0];
        let normal = if side == 0 { place.normal } else { -place.normal };
        let point = surface_point(place.eye, normal, self.setup.local_viewer);
        let of = |vertex: usize| self.surface(vertices, materials, side, vertex);
        let first = of(at(0));
        let mut material = material(&first);
        let mut reflectance = Reflectance::of(simd, &material);
        let mut alpha = simd.constant(first.diffuse[3]);
        let mut exponents = [first.shininess; LANES];
        if materials.vary() || (self.color_material.is_some() && vertices.color.varies()) {
            let mut surfaces = [first; LANES];
            for (lane, surface) in surfaces.iter_mut().enumerate().skip(1) {
                *surface = of(at(lane));
            }
            reflectance.ambient = color_lanes(simd, &surfaces.map(|side| side.ambient));
            reflectance.diffuse = color_lanes(simd, &surfaces.map(|side| side.diffuse));
            reflectance.specular = color_lanes(simd, &surfaces.map(|side| side.specular));
            reflectance.emission = color_lanes(simd, &surfaces.map(|side| side.emission));
            alpha = simd.each_lane(|lane| surfaces[lane].diffuse[3]);
            exponents = surfaces.map(|side| side.shininess);
        }
        // Vertices of one exponent are lit together: nearly always all of them.
        let mut left = simd.all_lanes();
        let mut sums = SeparateSums::new(simd);
        while left != 0 {
            material.shininess = exponents[left.trailing_zeros() as usize & (LANES - 1)];
            let mut together = left;
            for (lane, exponent) in exponents.iter().enumerate() {
                together &= !(u32::from(*exponent != material.shininess) << lane);
            }
            left &= !together;
            let lit = self.sums(&point, reflectance, &material, place.length);
            let mask = simd.mask_of(together);
            sums.primary = lit.primary.select(mask, sums.primary);
            sums.specular = lit.specular.select(mask, sums.specular);
        }
        LitColors { sums, alpha }
    }

    /// A vertex's material on a side: what was set, and what its colour drives.
    #[inline(always)]
    fn surface(
        &self,
        vertices: &VertexView<'_>,
        materials: &Materials,
        side: usize,
        vertex: usize,
    ) -> SurfaceMaterial {
        let mut sides = *materials.of(vertex);
        if let Some(color_material) = self.color_material {
            color_material.apply(vertices.color.of(vertex), &mut sides);
        }
        sides[side]
    }

    /// The light of vertices that reflect alike but for their colours.
    #[inline(always)]
    fn sums<N: Lanes>(
        &self,
        point: &SurfacePoint<N>,
        mut reflectance: Reflectance<N>,
        material: &luxel_lighting::Material,
        length: Option<N>,
    ) -> SeparateSums<N> {
        let simd = point.depth;
        if let Some(length) = length {
            reflectance.diffuse = reflectance.diffuse * length;
            let power = elementary::power(length, simd.constant(material.shininess));
            reflectance.specular = reflectance.specular * power;
        }
        let setup = &self.setup;
        let coefficients = Coefficients::new(&reflectance, material);
        let environment =
            LightingEnvironment::new(&setup.lights, setup.scene_ambient, &setup.environment, None);
        let reflection = &material.reflection;
        let mut sums = SeparateSums::new(simd);
        let of = (point, &coefficients, reflection, &environment);
        if setup.separate {
            lit_by(of.0, of.1, of.2, of.3, Occlusion::NONE, &mut sums);
        } else {
            sums.primary = lit_by(of.0, of.1, of.2, of.3, Occlusion::NONE, &mut Silent);
        }
        sums
    }
}

/// The point that is lit: the vertex by its w, and the direction to the eye, along z unless the viewer is local.
#[inline(always)]
fn surface_point<N: Lanes>(
    [x, y, z, w]: [N; 4],
    normal: Vec3<N>,
    local_viewer: bool,
) -> SurfacePoint<N> {
    let at_infinity = w.equal(w.zero());
    let scale = w.one() / w.one().select(at_infinity, w);
    let position = Vec3::new(x * scale, y * scale, z * scale);
    let view = if local_viewer {
        (-position).normalized_or_zero()
    } else {
        Vec3::splat(w, [0.0, 0.0, 1.0])
    };
    SurfacePoint { position, normal, view, depth: w.zero() }
}
