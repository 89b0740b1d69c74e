//! Shading: where normals come from.

use crate::values::finite;
use clap::{Args, ValueEnum};

/// Where normals come from.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Shading")]
pub(crate) struct ShadingOptions {
    /// Vertex normals: file, or averages of the abutting polygons: mean (plain), area, angle,
    /// area-angle [default: file, and area-angle where it has none]
    #[arg(long, value_name = "SOURCE", default_value = "file", hide_default_value = true)]
    #[arg(hide_possible_values = true)]
    pub(crate) normals: NormalsChoice,

    /// Edges sharper than this stay sharp where normals are computed
    #[arg(long, value_name = "DEG", value_parser = crease, allow_hyphen_values = true)]
    pub(crate) crease: Option<f64>,
}

/// Where vertex normals come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NormalsChoice {
    /// The file, where it has them.
    File,
    /// The plain average of the abutting polygons.
    Mean,
    /// Weighted by area.
    Area,
    /// Weighted by the angle at the vertex.
    Angle,
    /// Weighted by both.
    AreaAngle,
}

/// An angle between faces, 0 to 180 degrees.
fn crease(text: &str) -> Result<f64, String> {
    let degrees = finite(text)?;
    if (0.0..=180.0).contains(&degrees) {
        Ok(degrees)
    } else {
        Err("it must lie between 0 and 180 degrees".to_owned())
    }
}
