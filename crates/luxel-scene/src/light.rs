//! Lights in their places.

use crate::NodeId;
use glam::DVec3;
use luxel_lighting::{Cone, Light, LightKind};

/// The coordinates in which a light is placed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Placement {
    /// World space: the light stays with the scene.
    #[default]
    World,
    /// Camera space: the light moves with the eye.
    Camera,
    /// A node's space: the light moves with the node.
    Node(NodeId),
}

/// A light in its place.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SceneLight {
    /// Its name.
    pub name: String,
    /// Kind, intensities and attenuation.
    pub light: Light,
    /// The coordinates of `position` and `direction`.
    pub placement: Placement,
    /// The position (point and spot lights).
    pub position: DVec3,
    /// The direction in which its light travels, of any length but 0 (directional and spot lights).
    pub direction: DVec3,
}

impl SceneLight {
    /// A directional light of one colour, shining along `direction` (any length but 0) in world
    /// space.
    #[must_use]
    pub fn directional(direction: DVec3, color: [f32; 3]) -> Self {
        Self { direction, ..Self::of(LightKind::Directional, color) }
    }

    /// A point light of one colour at `position` in world space, unattenuated: see
    /// [`Light::attenuation`] of its `light`.
    #[must_use]
    pub fn point(position: DVec3, color: [f32; 3]) -> Self {
        Self { position, ..Self::of(LightKind::Point, color) }
    }

    /// A spot light of one colour at `position`, shining along `direction` in world space: even
    /// within `cutoff_radians` of its axis, nothing beyond.
    #[must_use]
    pub fn spot(position: DVec3, direction: DVec3, cutoff_radians: f64, color: [f32; 3]) -> Self {
        let cos_cutoff = libm::cos(cutoff_radians) as f32;
        let kind = LightKind::Spot(Cone::Exponent { cos_cutoff, exponent: 0.0 });
        Self { position, direction, ..Self::of(kind, color) }
    }

    /// An ambient light: I_a of the whole scene.
    #[must_use]
    pub fn ambient(color: [f32; 3]) -> Self {
        Self { light: Light::ambient(color), ..Self::of(LightKind::Ambient, color) }
    }

    /// The same light by another name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// The same light in other coordinates: on the camera for example.
    #[must_use]
    pub fn placed(self, placement: Placement) -> Self {
        Self { placement, ..self }
    }

    fn of(kind: LightKind, color: [f32; 3]) -> Self {
        Self {
            name: kind.name().to_owned(),
            light: Light::new(kind, color),
            placement: Placement::World,
            position: DVec3::ZERO,
            direction: DVec3::NEG_Z,
        }
    }
}

/// The default I_a: no part of a model is entirely black.
pub const DEFAULT_AMBIENT: [f32; 3] = [0.115, 0.12, 0.13];

/// The default lights, besides [`DEFAULT_AMBIENT`]: a soft white key from the upper
/// left of the camera, and a weak cool fill from its right, about 1 : 0.25.
///
/// In the default view, 30 degrees to the right and 20 degrees up, the light on a face that looks up is to
/// that on one that looks ahead as 1.6 : 1, and to that on the right side as 3 : 1.
///
/// The brightest spot of the default material is at 0.9 of white: 0.6 (1 + 0.12) and 0.2 of
/// highlight.
#[must_use]
pub fn default_lights() -> Vec<SceneLight> {
    let light = |name: &str, color, direction| {
        SceneLight::directional(direction, color).named(name).placed(Placement::Camera)
    };
    vec![
        light("key", [1.0, 0.975, 0.94], DVec3::new(0.45, -0.68, -0.66)),
        light("fill", [0.22, 0.245, 0.28], DVec3::new(-0.9, -0.3, -0.45)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_lighting::{
        Environment, LightingEnvironment, Material, PlacedLight, Reflectance, Silent, SurfacePoint,
        lit,
    };

    /// A ball of the default material, seen from straight ahead and from far.
    #[test]
    fn the_default_lights_burn_nothing_out_and_leave_nothing_black() {
        let lights: Vec<_> = default_lights()
            .into_iter()
            .map(|light| {
                PlacedLight::new(light.light, [0.0; 3], light.direction.as_vec3().to_array())
            })
            .collect();
        let surroundings =
            LightingEnvironment::new(&lights, DEFAULT_AMBIENT, &Environment::None, None);
        let material = Material::default();
        let (mut least, mut largest) = (f32::INFINITY, 0.0_f32);
        for row in -50..=50_i16 {
            for column in -50..=50_i16 {
                let (x, y) = (f32::from(column) / 50.0, f32::from(row) / 50.0);
                if x * x + y * y > 1.0 {
                    continue;
                }
                let normal = luxel_math::Vec3::new(x, y, (1.0 - x * x - y * y).sqrt());
                let view = luxel_math::Vec3::new(0.0, 0.0, 1.0);
                let position = luxel_math::Vec3::new(x, y, -100.0);
                let point = SurfacePoint { position, normal, view, depth: 100.0 };
                let reflectance = Reflectance::of(0.0, &material);
                let color = lit(&point, &reflectance, &material, &surroundings, &mut Silent);
                for component in color.lane(0) {
                    least = least.min(component);
                    largest = largest.max(component);
                }
            }
        }
        assert!(least > 0.04, "{least}");
        assert!(largest > 0.75 && largest < 1.0, "{largest}");
    }
}
