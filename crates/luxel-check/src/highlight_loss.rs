//! Highlights between vertices, which per-vertex lighting misses.

use luxel_lighting::{
    Environment, Light, LightKind, LightingEnvironment, PictureEncoding, PlacedLight, Reflectance,
    Silent, SurfacePoint, lit,
};
use luxel_math::Vec3;
use luxel_scene::{DVec3, SceneMaterial};

/// The cosine above which normals are too close to hide a visible highlight: the widest lobe falls by one
/// percent.
const LEAST_TURN_COSINE: f64 = 0.999;

/// The largest loss of a triangle, in 8-bit steps: the difference at its centre between the equation at
/// the interpolated normal and the average of the equation at the corners, clamped as in Gouraud shading,
/// with light and eye straight above the centre.
///
/// That is the worst case for a highlight: the farthest from all three corners.
pub(crate) fn loss(normals: &[DVec3; 3], material: &SceneMaterial) -> f32 {
    let [a, b, c] = *normals;
    if a.dot(b).min(b.dot(c)).min(c.dot(a)) > LEAST_TURN_COSINE {
        return 0.0;
    }
    let middle = (a + b + c).normalize_or_zero();
    if middle == DVec3::ZERO {
        return 0.0;
    }
    let towards = middle.as_vec3().to_array();
    let light = Light::new(LightKind::Directional, [1.0; 3]);
    let lights = [PlacedLight::new(light, [0.0; 3], towards.map(|component| -component))];
    let environment = LightingEnvironment::new(&lights, [0.0; 3], &Environment::None, None);
    let constants = &material.constants;
    let reflectance = Reflectance::of(0.0_f32, constants);
    let vector = |[x, y, z]: [f32; 3]| Vec3::new(x, y, z);
    let at = |normal: DVec3| {
        let point = SurfacePoint {
            position: vector(towards.map(|component| -component)),
            normal: vector(normal.as_vec3().to_array()),
            view: vector(towards),
            depth: 1.0,
        };
        let color = lit(&point, &reflectance, constants, &environment, &mut Silent);
        [color.r, color.g, color.b].map(|component| component.clamp(0.0, 1.0))
    };
    let corners = [a, b, c].map(at);
    let whole = at(middle);
    let step = |value: f32| f32::from(PictureEncoding::Srgb.byte(value));
    let loss = |channel: usize| {
        let mean = (corners[0][channel] + corners[1][channel] + corners[2][channel]) / 3.0;
        (step(whole[channel]) - step(mean)).abs()
    };
    loss(0).max(loss(1)).max(loss(2))
}
