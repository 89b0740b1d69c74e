//! The light of a surface, summed by kind of term.

use crate::equation::TermKind;
use luxel_render::{ExplainedLight, ExplainedSurface};

/// The terms of all lights together, by kind, before fog: ambient, diffuse, specular, emission and environment.
#[must_use]
pub fn term_sums(surface: &ExplainedSurface) -> [(TermKind, [f32; 3]); 5] {
    let sum =
        |of: fn(&ExplainedLight) -> [f32; 3]| {
            surface.lights.iter().map(of).fold([0.0; 3], |all, one| {
                std::array::from_fn(|channel| all[channel] + one[channel])
            })
        };
    let of_lights = sum(|light| light.terms.ambient.lane(0));
    let ambient = std::array::from_fn(|at| surface.scene_ambient[at] + of_lights[at]);
    [
        (TermKind::Ambient, ambient),
        (TermKind::Diffuse, sum(|light| light.terms.diffuse.lane(0))),
        (TermKind::Specular, sum(|light| light.terms.specular.lane(0))),
        (TermKind::Emission, surface.emission),
        (TermKind::Environment, surface.environment),
    ]
}

/// The relative luminance of linear light (ITU-R BT.709), by which terms are compared.
#[must_use]
pub fn luminance([r, g, b]: [f32; 3]) -> f32 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}
