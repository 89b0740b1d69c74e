//! Lights of `KHR_lights_punctual`.
//!
//! The extension gives illuminance in lux and intensity in candela; a white Lambert surface then
//! sends (1/pi) E N.L to the eye. Luxel's equation has no factor pi: a white surface that faces a
//! unit light gives 1. So intensities are divided by pi here, once.

use super::buffers::malformed;
use crate::Error;
use luxel_gltf::Light as FileLight;
use luxel_lighting::{Attenuation, Cone, Light, LightKind};

/// The light, at its node's origin and shining along the node's -Z.
pub(crate) fn convert(light: &FileLight, index: u32) -> Result<Light, Error> {
    let pointer = format!("/extensions/KHR_lights_punctual/lights/{index}");
    let kind = match light.kind.as_str() {
        "directional" => LightKind::Directional,
        "point" => LightKind::Point,
        "spot" => LightKind::Spot(cone(light, &pointer)?),
        other => {
            let message =
                format!("`{other}` is not a kind of light: use directional, point or spot");
            return Err(malformed(format!("{pointer}/type"), message));
        }
    };
    let intensity = light.intensity.unwrap_or(1.0) / std::f32::consts::PI;
    let color = light.color.unwrap_or([1.0; 3]).map(|channel| channel * intensity);
    if !color.iter().all(|&channel| channel.is_finite() && channel >= 0.0) {
        let message = "colour and intensity must be finite and not negative";
        return Err(malformed(pointer, message));
    }
    let attenuation = if kind.has_place() {
        // A range that isn't positive means unlimited.
        let range = light.range.filter(|&range| range > 0.0 && range.is_finite());
        Attenuation { range, ..Attenuation::INVERSE_SQUARE }
    } else {
        Attenuation::NONE
    };
    Ok(Light { attenuation, ..Light::new(kind, color) })
}

fn cone(light: &FileLight, pointer: &str) -> Result<Cone, Error> {
    let spot = light.spot.as_ref();
    let inner = spot.and_then(|spot| spot.inner_cone_angle).unwrap_or(0.0);
    let outer = spot.and_then(|spot| spot.outer_cone_angle).unwrap_or(std::f64::consts::FRAC_PI_4);
    let fits = inner >= 0.0 && inner <= outer && outer <= std::f64::consts::FRAC_PI_2 + 1e-6;
    if !fits {
        let message = format!("the cone from {inner} to {outer} isn't within 0 to pi/2");
        return Err(malformed(format!("{pointer}/spot"), message));
    }
    let cos_outer = libm::cos(outer) as f32;
    Ok(Cone::smooth(libm::cos(inner) as f32, cos_outer))
}
