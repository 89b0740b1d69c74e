//! The light that a surface point at the origin, facing up, sends to the eye.

use luxel::lighting::{
    Attenuation, Environment, Fog, Ledger, Light, LightKind, LightingEnvironment, Material,
    PlacedLight, Reflectance, SurfacePoint, lit,
};
use luxel::math::Vec3;

/// A position in a plane through the normal: the angle to the normal in degrees,
/// towards the right.
fn direction(degrees: f64) -> [f32; 3] {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    [sin as f32, cos as f32, 0.0]
}

/// The light (of intensity 1) that a point sends to an eye.
pub(crate) fn sent(material: &Material, light_degrees: f64, eye_degrees: f64) -> f64 {
    let towards = direction(light_degrees).map(|part| -part);
    let light = PlacedLight::new(Light::new(LightKind::Directional, [1.0; 3]), [0.0; 3], towards);
    ledger(material, &[light], &Environment::None, eye_degrees, 1.0, None).color[1].into()
}

/// The environment that a point reflects.
pub(crate) fn mirrored(material: &Material, environment: &Environment, eye_degrees: f64) -> f64 {
    ledger(material, &[], environment, eye_degrees, 1.0, None).environment[1].into()
}

/// The incident light from straight above a point, at a distance: the factors of attenuation and of
/// the cone, and the light that a white matte surface there sends.
pub(crate) fn arriving(light: &Light, distance: f64, axis_degrees: f64) -> [f64; 3] {
    let eye = [0.0, 1.0, 0.0];
    // The point is one unit below the eye; the light is above the point.
    let position = [0.0, distance as f32 - eye[1], 0.0];
    let down = direction(axis_degrees).map(|part| -part);
    let placed = PlacedLight::new(light.clone(), position, down);
    let white = Material {
        reflection: luxel::lighting::Reflection::Lambert,
        diffuse: [1.0; 3],
        ..Material::default()
    };
    let ledger = ledger(&white, &[placed], &Environment::None, 0.0, 1.0, None);
    let [attenuation, spot] =
        ledger.lights.first().map_or([0.0; 2], |light| [light.terms.attenuation, light.terms.spot]);
    [attenuation, spot, ledger.color[1]].map(f64::from)
}

/// s, the part of the light that fog lets through.
pub(crate) fn let_through(fog: &Fog, distance: f64) -> f64 {
    let ledger =
        ledger(&Material::default(), &[], &Environment::None, 0.0, distance as f32, Some(fog));
    ledger.fog.map_or(1.0, |(factor, _)| factor.into())
}

/// A point light of intensity 1.
pub(crate) fn lamp(attenuation: Attenuation) -> Light {
    Light { attenuation, ..Light::new(LightKind::Point, [1.0; 3]) }
}

/// Runs the equation with every term written down.
fn ledger(
    material: &Material,
    lights: &[PlacedLight],
    environment: &Environment,
    eye_degrees: f64,
    depth: f32,
    fog: Option<&Fog>,
) -> Ledger {
    let vector = |[x, y, z]: [f32; 3]| Vec3::new(x, y, z);
    let view = direction(eye_degrees);
    let point = SurfacePoint {
        position: vector(view.map(|part| -part)),
        normal: Vec3::new(0.0, 1.0, 0.0),
        view: vector(view),
        depth,
    };
    let surroundings = LightingEnvironment::new(lights, [0.0; 3], environment, fog);
    let reflectance = Reflectance::of(0.0_f32, material);
    let mut ledger = Ledger::default();
    lit(&point, &reflectance, material, &surroundings, &mut ledger);
    ledger
}
