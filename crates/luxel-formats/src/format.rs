//! File formats, and a scene that was read from one of them.

use crate::{ErrorKind, UnknownFormat, Warning};
use luxel_scene::Scene;
use std::str::FromStr;

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// glTF 2.0 as JSON.
    Gltf,
    /// glTF 2.0 in one binary file.
    Glb,
    /// Wavefront OBJ with MTL.
    Obj,
    /// Stereolithography, binary or ASCII.
    Stl,
    /// Stanford polygons, binary or ASCII.
    Ply,
    /// A luxel scene file: models, materials, lights, cameras.
    Toml,
}

/// A scene, with the warnings of its reader.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The content of the file.
    pub scene: Scene,
    /// Its format.
    pub format: Format,
    /// The parts left out or replaced.
    pub warnings: Vec<Warning>,
}

impl Format {
    /// The file name extension, which is also the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Gltf => "gltf",
            Self::Glb => "glb",
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::Ply => "ply",
            Self::Toml => "toml",
        }
    }

    /// Whether this build reads it, by its cargo features.
    #[must_use]
    pub const fn is_supported(self) -> bool {
        match self {
            Self::Gltf | Self::Glb => cfg!(feature = "gltf"),
            Self::Obj => cfg!(feature = "obj"),
            Self::Stl => cfg!(feature = "stl"),
            Self::Ply => cfg!(feature = "ply"),
            Self::Toml => cfg!(feature = "toml"),
        }
    }

    /// The error of a build without its reader.
    pub(crate) fn missing_feature(self) -> ErrorKind {
        let (what, feature) = match self {
            Self::Gltf | Self::Glb => ("glTF", "gltf"),
            Self::Obj => ("OBJ", "obj"),
            Self::Stl => ("STL", "stl"),
            Self::Ply => ("PLY", "ply"),
            Self::Toml => ("a scene file", "toml"),
        };
        crate::error::missing_feature(what, feature)
    }
}

impl FromStr for Format {
    type Err = UnknownFormat;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        [Self::Gltf, Self::Glb, Self::Obj, Self::Stl, Self::Ply, Self::Toml]
            .into_iter()
            .find(|format| format.name().eq_ignore_ascii_case(name))
            .ok_or_else(|| UnknownFormat { name: name.to_owned() })
    }
}
