//! A layer with its name, ready to be written.

use crate::LayerValues;

/// A layer of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct LayerImage {
    /// Its name, which decides how its channels are called in an EXR file and scaled in a PNG one.
    pub name: String,
    /// Values a pixel, 1 to 3.
    pub channels: usize,
    /// The values, row by row from the top.
    pub values: LayerValues,
}

impl LayerImage {
    /// What its channels are called in an EXR file, where names of layers and channels are parted by
    /// a point.
    ///
    /// `Z`, `depth`, `object` and the like stand alone; normals are `N.X`, `N.Y`, `N.Z`, positions
    /// `P.X` and so on, texture coordinates `uv.U` and `uv.V`, barycentrics `barycentric.A`,
    /// `barycentric.B` and `barycentric.C`, colours `diffuse.R` and so on.
    pub(crate) fn channel_names(&self) -> Vec<String> {
        let name = self.name.as_str();
        if self.channels == 1 {
            return vec![if name == "z" { "Z".to_owned() } else { name.to_owned() }];
        }
        let (group, letters) = match name {
            "normal" => ("N", "XYZ"),
            "position" => ("P", "XYZ"),
            "barycentric" => (name, "ABC"),
            "uv" => (name, "UVW"),
            _ => (name, "RGBA"),
        };
        letters.chars().take(self.channels).map(|letter| format!("{group}.{letter}")).collect()
    }
}
