//! `none`, `studio`, `microfacet`, `R,G,B`: what mirrors and metals see.

use super::vector::reflectance;
use luxel_lighting::Environment;
use luxel_scene::{DVec3, EnvironmentChoice};

/// What mirrors and metals see.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surroundings {
    /// Nothing.
    None,
    /// An analytic gradient: bright above, dark below.
    Studio,
    /// That gradient for microfacet materials, nothing for others.
    Microfacet,
    /// The same light from everywhere.
    Constant([f32; 3]),
}

impl Surroundings {
    /// The environment, where `up` is up.
    #[must_use]
    pub fn environment(self, up: DVec3) -> EnvironmentChoice {
        EnvironmentChoice::Always(match self {
            Self::None => Environment::None,
            Self::Studio => Environment::Studio { up: up.as_vec3().to_array() },
            Self::Microfacet => return EnvironmentChoice::StudioForMicrofacets,
            Self::Constant(color) => Environment::Constant(color),
        })
    }
}

/// An environment.
///
/// # Errors
/// Anything but `none`, `studio`, `microfacet` or a colour without negative components.
pub fn surroundings(text: &str) -> Result<Surroundings, String> {
    match text {
        "none" => Ok(Surroundings::None),
        "studio" => Ok(Surroundings::Studio),
        "microfacet" => Ok(Surroundings::Microfacet),
        _ => reflectance(text)
            .map(Surroundings::Constant)
            .map_err(|message| format!("use none, studio, microfacet or R,G,B: {message}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_colours_are_environments() {
        assert_eq!(surroundings("none"), Ok(Surroundings::None));
        assert_eq!(surroundings("studio"), Ok(Surroundings::Studio));
        assert_eq!(surroundings("microfacet"), Ok(Surroundings::Microfacet));
        assert_eq!(surroundings("1,.5,3"), Ok(Surroundings::Constant([1.0, 0.5, 3.0])));
        assert!(surroundings("hdri").is_err() && surroundings("-1,0,0").is_err());
    }
}
