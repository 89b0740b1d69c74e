//! `none`, `studio`, `microfacet`, a colour, a picture: the environment.

use super::color::reflectance;
use crate::environment::is_environment;
use luxel_lighting::Environment;
use luxel_scene::{DVec3, EnvironmentChoice, NamedEnvironment};
use std::path::{Path, PathBuf};

/// The environment that surfaces reflect.
#[derive(Clone, Debug, PartialEq)]
pub enum Surroundings {
    /// An environment with a name.
    Named(NamedEnvironment),
    /// Uniform light from all directions.
    Constant([f32; 3]),
    /// A picture, which [`open_environment`](crate::open_environment) reads.
    File(PathBuf),
}

impl Surroundings {
    /// The environment in a scene with this up direction; `Err` with the path of a picture.
    ///
    /// # Errors
    /// The path of a picture that is to be read.
    pub fn environment(&self, up: DVec3) -> Result<EnvironmentChoice, &Path> {
        match self {
            Self::Named(environment) => Ok(environment.choice(up)),
            Self::Constant(color) => Ok(EnvironmentChoice::Always(Environment::Constant(*color))),
            Self::File(path) => Err(path),
        }
    }
}

/// Parses an environment.
///
/// # Errors
/// Anything but a name, a colour without negative components or the name of a picture.
pub fn surroundings(text: &str) -> Result<Surroundings, String> {
    if let Some(environment) = NamedEnvironment::by_name(text) {
        return Ok(Surroundings::Named(environment));
    }
    if is_environment(Path::new(text)) {
        return Ok(Surroundings::File(text.into()));
    }
    let names = NamedEnvironment::NAMES.join(", ");
    reflectance(text)
        .map(Surroundings::Constant)
        .map_err(|message| format!("use {names}, or a colour, or a file .hdr or .exr: {message}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_colours_and_pictures_are_environments() {
        for environment in NamedEnvironment::ALL {
            assert_eq!(surroundings(environment.name()), Ok(Surroundings::Named(environment)));
        }
        assert_eq!(surroundings("1,.5,3"), Ok(Surroundings::Constant([1.0, 0.5, 3.0])));
        assert_eq!(surroundings("a/b.HDR"), Ok(Surroundings::File("a/b.HDR".into())));
        assert!(surroundings("hdri").is_err() && surroundings("-1,0,0").is_err());
    }
}
