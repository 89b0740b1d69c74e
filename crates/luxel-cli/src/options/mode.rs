//! Shading mode and interpolation.

use crate::failure::Failure;
use crate::values::{choice, positive};
use clap::Args;
use luxel::render::{Clamp, Interpolation, NormalLength, Shading, ShadingMode};

/// Shading mode and interpolation.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Shading")]
pub(crate) struct ModeOptions {
    #[arg(
        long,
        value_name = "MODE",
        default_value = ShadingMode::default().name(),
        hide_possible_values = true,
        value_parser = choice(&ShadingMode::ALL, ShadingMode::name, ShadingMode::help),
        help = format!("Where lighting is computed: {}", modes()),
    )]
    pub(crate) shading: ShadingMode,

    /// Tolerance of subdivided shading against phong, or of .svg colours against pixels, in
    /// 8-bit steps; it can't hold where light jumps, as at edges of cones, and at N.L = 0 in the
    /// highlight of phong reflection [default: 1; for .svg 2]
    #[arg(long, value_name = "T", value_parser = positive, allow_hyphen_values = true)]
    pub(crate) tolerance: Option<f64>,

    /// Where vertex intensities are clamped to 0..1: at the vertex, or at the end
    #[arg(long, value_name = "WHERE", default_value = Clamp::default().name())]
    #[arg(value_parser = choice(&Clamp::ALL, Clamp::name, Clamp::help), hide_possible_values = true)]
    pub(crate) clamp: Clamp,

    /// Interpolation of vertex values: perspective, screen (linear in the image),
    /// scanline (along edges and rows of polygons)
    #[arg(
        long,
        value_name = "HOW",
        default_value = Interpolation::default().name(),
        hide_possible_values = true,
        value_parser = choice(&Interpolation::ALL, Interpolation::name, Interpolation::help),
    )]
    pub(crate) interpolation: Interpolation,

    /// Length of the normals in phong shading: unit, or interpolated (not normalized,
    /// to show the resulting error)
    #[arg(
        long,
        value_name = "LENGTH",
        default_value = NormalLength::default().name(),
        hide_possible_values = true,
        value_parser = choice(&NormalLength::ALL, NormalLength::name, NormalLength::help),
    )]
    pub(crate) normal_length: NormalLength,
}

impl ModeOptions {
    /// The renderer's settings.
    ///
    /// # Errors
    /// [`Failure::Usage`] for a tolerance in a mode without one.
    pub(crate) fn shading(&self) -> Result<Shading, Failure> {
        let mode = match self.shading {
            ShadingMode::Subdivided { tolerance } => {
                let tolerance = self.tolerance.map_or(tolerance, |tolerance| tolerance as f32);
                ShadingMode::Subdivided { tolerance }
            }
            _ if self.tolerance.is_some() => {
                return Err(Failure::Usage("--tolerance is for --shading subdivided".to_owned()));
            }
            mode => mode,
        };
        let Self { interpolation, clamp, normal_length, .. } = *self;
        Ok(Shading { mode, interpolation, clamp, normal_length })
    }
}

/// `flat (at polygons' centroids), gouraud (at corners), ...`
fn modes() -> String {
    let mode = |mode: ShadingMode| format!("{} ({})", mode.name(), mode.help());
    ShadingMode::ALL.map(mode).join(", ")
}
