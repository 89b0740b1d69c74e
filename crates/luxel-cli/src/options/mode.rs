//! Where light is computed, and how it gets to the pixels between.

use crate::failure::Failure;
use crate::values::positive;
use clap::{Args, ValueEnum};
use luxel::render::{Clamp, Interpolation, NormalLength, Shading, ShadingMode};

/// Where light is computed, and how it gets to the pixels between.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Shading")]
pub(crate) struct ModeOptions {
    /// Where light is computed: flat (at polygons' centroids), gouraud (at corners), phong (at
    /// pixels), subdivided (at corners of ever smaller triangles)
    #[arg(long, value_name = "MODE", default_value = "phong", hide_possible_values = true)]
    pub(crate) shading: ModeChoice,

    /// How far subdivided shading may be from phong, or the colours of an .svg from the picture's, in
    /// 8-bit steps [default: 1; for .svg 2]
    #[arg(long, value_name = "T", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) tolerance: Option<f64>,

    /// Where the intensities of corners are brought into 0..1: at the vertex, or at the end
    #[arg(long, value_name = "WHERE", default_value = "vertex", hide_possible_values = true)]
    pub(crate) clamp: ClampChoice,

    /// How corners' values get to the pixels between: perspective, screen (linear in the window),
    /// scanline (along edges and rows of polygons)
    #[arg(long, value_name = "HOW", default_value = "perspective", hide_possible_values = true)]
    pub(crate) interpolation: InterpolationChoice,

    /// The length of the normals that phong lights pixels with: unit, or interpolated (as it is
    /// between corners, to see what that spoils)
    #[arg(long, value_name = "LENGTH", default_value = "unit", hide_possible_values = true)]
    pub(crate) normal_length: NormalLengthChoice,
}

/// Where light is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ModeChoice {
    /// Once a polygon.
    Flat,
    /// At corners.
    Gouraud,
    /// At pixels.
    Phong,
    /// At corners of ever smaller triangles.
    Subdivided,
}

/// Where intensities are clamped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ClampChoice {
    /// At the corners.
    Vertex,
    /// Where colours become bytes.
    End,
}

/// How values are interpolated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum InterpolationChoice {
    /// Linearly in space.
    Perspective,
    /// Linearly in the window.
    Screen,
    /// Along edges and rows of polygons.
    Scanline,
}

/// The length of interpolated normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NormalLengthChoice {
    /// 1.
    Unit,
    /// As it is between corners.
    Interpolated,
}

/// The tolerance of subdivided shading where none is given, in 8-bit steps.
const DEFAULT_TOLERANCE: f64 = 1.0;

impl ModeOptions {
    /// What the renderer takes.
    ///
    /// # Errors
    /// [`Failure::Usage`], if there is a tolerance for a mode that has none.
    pub(crate) fn shading(&self) -> Result<Shading, Failure> {
        let tolerance = self.tolerance.unwrap_or(DEFAULT_TOLERANCE) as f32;
        let mode = match self.shading {
            ModeChoice::Flat => ShadingMode::Flat,
            ModeChoice::Gouraud => ShadingMode::Gouraud,
            ModeChoice::Phong => ShadingMode::Phong,
            ModeChoice::Subdivided => ShadingMode::Subdivided { tolerance },
        };
        if self.tolerance.is_some() && self.shading != ModeChoice::Subdivided {
            return Err(Failure::Usage("--tolerance is for --shading subdivided".to_owned()));
        }
        Ok(Shading {
            mode,
            interpolation: match self.interpolation {
                InterpolationChoice::Perspective => Interpolation::Perspective,
                InterpolationChoice::Screen => Interpolation::Screen,
                InterpolationChoice::Scanline => Interpolation::Scanline,
            },
            clamp: match self.clamp {
                ClampChoice::Vertex => Clamp::Vertex,
                ClampChoice::End => Clamp::End,
            },
            normal_length: match self.normal_length {
                NormalLengthChoice::Unit => NormalLength::Unit,
                NormalLengthChoice::Interpolated => NormalLength::Interpolated,
            },
        })
    }
}
