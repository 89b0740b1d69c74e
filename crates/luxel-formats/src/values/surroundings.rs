//! `none`, `studio`, `microfacet`, a colour: the environment that mirrors and metals reflect.

use super::color::reflectance;
use luxel_lighting::Environment;
use luxel_scene::{DVec3, EnvironmentChoice, NamedEnvironment};

/// The environment that mirrors and metals reflect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surroundings {
    /// An environment with a name.
    Named(NamedEnvironment),
    /// Uniform light from all directions.
    Constant([f32; 3]),
}

impl Surroundings {
    /// The environment in a scene with this up direction.
    #[must_use]
    pub fn environment(self, up: DVec3) -> EnvironmentChoice {
        match self {
            Self::Named(environment) => environment.choice(up),
            Self::Constant(color) => EnvironmentChoice::Always(Environment::Constant(color)),
        }
    }
}

/// Parses an environment.
///
/// # Errors
/// Anything but a name or a colour without negative components.
pub fn surroundings(text: &str) -> Result<Surroundings, String> {
    if let Some(environment) = NamedEnvironment::by_name(text) {
        return Ok(Surroundings::Named(environment));
    }
    let names = NamedEnvironment::NAMES.join(", ");
    reflectance(text)
        .map(Surroundings::Constant)
        .map_err(|message| format!("use {names}, or a colour: {message}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_colours_are_environments() {
        for environment in NamedEnvironment::ALL {
            assert_eq!(surroundings(environment.name()), Ok(Surroundings::Named(environment)));
        }
        assert_eq!(surroundings("1,.5,3"), Ok(Surroundings::Constant([1.0, 0.5, 3.0])));
        assert!(surroundings("hdri").is_err() && surroundings("-1,0,0").is_err());
    }
}
