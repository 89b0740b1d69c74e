//! The names of settings.

use luxel_lighting::parameters;

/// The setting that may be there several times.
pub(super) const LIGHT: &str = "light";

/// The names of all settings but those of reflection parameters: `ka`, `ks`, `shininess` and others that
/// [`luxel_lighting::parameters`] describes.
pub const SETTINGS: [&str; 43] = [
    "size",
    "eye",
    "target",
    "up",
    "fov",
    "ortho",
    "near",
    "far",
    "view-matrix",
    "intrinsics",
    "camera",
    "azimuth",
    "elevation",
    "samples",
    "cull",
    LIGHT,
    "ambient",
    "light-scale",
    "environment",
    "environment-rotation",
    "environment-background",
    "shadows",
    "light-rays",
    "ao",
    "ao-rays",
    "ground",
    "fog",
    "color",
    "emission",
    "reflection",
    "normals",
    "crease",
    "shading",
    "tolerance",
    "clamp",
    "interpolation",
    "normal-length",
    "background",
    "exposure",
    "tone",
    "encoding",
    "wireframe",
    "edges",
];

/// All names.
pub(super) fn all() -> impl Iterator<Item = &'static str> {
    SETTINGS.into_iter().chain(parameters().map(|parameter| parameter.name))
}

/// The name of a setting, if it is one.
pub(super) fn known(name: &str) -> Option<&'static str> {
    all().find(|known| *known == name)
}
