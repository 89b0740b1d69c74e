//! The source of normals.

use crate::values::finite;
use clap::{Args, ValueEnum};

/// The source of normals.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Shading")]
pub(crate) struct ShadingOptions {
    /// Source of vertex normals: file, or averages of the adjacent polygons: mean (unweighted),
    /// area, angle, area-angle [default: file, else area-angle]
    #[arg(long, value_name = "SOURCE", default_value = "file", hide_default_value = true)]
    #[arg(hide_possible_values = true)]
    pub(crate) normals: NormalsChoice,

    /// Edges sharper than this stay sharp when computing normals
    #[arg(long, value_name = "DEG", value_parser = crease, allow_hyphen_values = true)]
    pub(crate) crease: Option<f64>,
}

/// The source of vertex normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NormalsChoice {
    /// The file, if it has them.
    File,
    /// The unweighted average of the adjacent polygons.
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
        Err("it must be between 0 and 180 degrees".to_owned())
    }
}
