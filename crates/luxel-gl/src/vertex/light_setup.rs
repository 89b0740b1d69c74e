//! GL's lights and materials as those of luxel's lighting equation (OpenGL 1.5, section 2.13.1).

use crate::enums as gl;
use crate::limits::LIGHTS;
use crate::state::Attributes;
use crate::state::light::LightSource;
use crate::state::material::SurfaceMaterial;
use crate::state::matrices::sin_cos_degrees;
use luxel_lighting::{
    Attenuation, Cone, Environment, Light, LightKind, LightTerms, Material, PlacedLight,
    Reflection, Terms, Witness,
};
use luxel_math::{Lanes, Rgb, Vec3};

/// The enabled lights in eye coordinates.
#[derive(Debug)]
pub(crate) struct LightSetup {
    pub(crate) lights: Vec<PlacedLight>,
    pub(crate) scene_ambient: [f32; 3],
    pub(crate) environment: Environment,
    pub(crate) local_viewer: bool,
    pub(crate) two_side: bool,
    /// Whether specular light is summed apart.
    pub(crate) separate: bool,
}

fn rgb([r, g, b, _]: [f32; 4]) -> [f32; 3] {
    [r, g, b]
}

impl LightSetup {
    pub(crate) fn new(state: &Attributes) -> Self {
        let enabled = (0..LIGHTS).filter(|&number| state.enables.light(number));
        let model = &state.lights.model;
        Self {
            lights: enabled.map(|number| placed(&state.lights.sources[number])).collect(),
            scene_ambient: rgb(model.ambient),
            environment: Environment::None,
            local_viewer: model.local_viewer,
            two_side: model.two_side,
            separate: model.color_control == gl::SEPARATE_SPECULAR_COLOR,
        }
    }
}

/// A light where it stands. One at infinity (w = 0) has a cone, too, whose factor is the same everywhere: it goes into
/// the intensities. A cutoff of 180 degrees means no cone.
fn placed(source: &LightSource) -> PlacedLight {
    let [x, y, z, w] = source.position;
    let has_cone = source.spot_cutoff != 180.0;
    let cone = Cone::Exponent {
        cos_cutoff: sin_cos_degrees(f64::from(source.spot_cutoff)).1 as f32,
        exponent: source.spot_exponent,
    };
    let directional = w == 0.0;
    let kind = match (directional, has_cone) {
        (true, _) => LightKind::Directional,
        (false, false) => LightKind::Point,
        (false, true) => LightKind::Spot(cone),
    };
    let mut light = Light::new(kind, rgb(source.diffuse));
    light.ambient = rgb(source.ambient);
    light.specular = rgb(source.specular);
    light.attenuation = Attenuation::new(source.attenuation);
    if !directional {
        return PlacedLight::new(light, [x / w, y / w, z / w], source.spot_direction);
    }
    let travels = [-x, -y, -z];
    if has_cone {
        let unit = |[x, y, z]: [f32; 3]| Vec3::new(x, y, z).normalized_or_zero();
        light.scale(cone.brightness(unit(travels).dot(unit(source.spot_direction))));
    }
    PlacedLight::new(light, [0.0; 3], travels)
}

/// A side's material, without its alpha.
pub(crate) fn material(side: &SurfaceMaterial) -> Material {
    Material {
        reflection: Reflection::BlinnPhong,
        ambient: Some(rgb(side.ambient)),
        diffuse: rgb(side.diffuse),
        specular: rgb(side.specular),
        emission: rgb(side.emission),
        k_a: 1.0,
        k_d: 1.0,
        k_s: 1.0,
        shininess: side.shininess,
        ..Material::default()
    }
}

/// Keeps specular light apart from the rest (`GL_SEPARATE_SPECULAR_COLOR`).
#[derive(Clone, Copy, Debug)]
pub(crate) struct SeparateSums<N> {
    pub(crate) primary: Rgb<N>,
    pub(crate) specular: Rgb<N>,
}

impl<N: Lanes> SeparateSums<N> {
    /// Nothing yet; `simd` selects the lane type.
    #[inline(always)]
    pub(crate) fn new(simd: N) -> Self {
        Self { primary: Rgb::black(simd), specular: Rgb::black(simd) }
    }
}

impl<N: Lanes> Witness<N> for SeparateSums<N> {
    #[inline(always)]
    fn light(&mut self, _: usize, terms: &LightTerms<N>) {
        self.primary = self.primary + terms.ambient + terms.diffuse;
        self.specular = self.specular + terms.specular;
    }

    #[inline(always)]
    fn terms(&mut self, terms: &Terms<N>) {
        self.primary = self.primary + terms.emission + terms.scene_ambient;
    }
}
