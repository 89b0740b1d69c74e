//! The flags of frame and camera, shared by all commands with a view.

use crate::values::{
    far_plane, finite, fov, intrinsics, point, positive, samples, size, up, view_matrix,
};
use clap::{Args, ValueEnum};
use luxel::render::Cull;
use luxel::scene::{DMat4, DVec3, Size};

/// Size, camera, samples.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Frame and camera")]
pub(crate) struct FrameOptions {
    /// Width and height in pixels, at most 16384 each
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = size)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) size: Size,

    /// Position of the eye
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["camera", "azimuth", "elevation", "view_matrix"])]
    pub(crate) eye: Option<DVec3>,

    /// Point that the eye looks at [default: the centre of the scene's bounds]
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["camera", "azimuth", "elevation", "view_matrix"])]
    pub(crate) target: Option<DVec3>,

    /// Up direction, and axis of azimuth and elevation: a vector, X, Y or Z [default: Y; Z for
    /// STL]
    #[arg(long, value_name = "AXIS", value_parser = up, allow_hyphen_values = true)]
    pub(crate) up: Option<DVec3>,

    /// Vertical field of view in degrees [default: the file camera's, else 45]
    #[arg(long, value_name = "DEG", value_parser = fov, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["ortho", "intrinsics"])]
    pub(crate) fov: Option<f64>,

    /// Orthographic projection: visible height in world units
    #[arg(long, value_name = "HEIGHT", value_parser = positive, allow_hyphen_values = true)]
    #[arg(conflicts_with = "intrinsics")]
    pub(crate) ortho: Option<f64>,

    /// Distance of the near plane [default: fitted to the scene]
    #[arg(long, value_name = "D", value_parser = finite, allow_hyphen_values = true)]
    pub(crate) near: Option<f64>,

    /// Distance of the far plane, or `infinity` [default: fitted to the scene]
    #[arg(long, value_name = "D", value_parser = far_plane, allow_hyphen_values = true)]
    pub(crate) far: Option<f64>,

    /// View matrix, from world to camera space: 16 numbers, column by column
    #[arg(long, value_name = "M00,...", value_parser = view_matrix, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["camera", "azimuth", "elevation"])]
    pub(crate) view_matrix: Option<DMat4>,

    /// Calibrated camera: focal lengths and principal point, in pixels
    #[arg(long, value_name = "FX,FY,CX,CY", value_parser = intrinsics, allow_hyphen_values = true)]
    pub(crate) intrinsics: Option<[f64; 4]>,

    /// Camera of the file, by name [default: its first]
    #[arg(long, value_name = "NAME", conflicts_with_all = ["azimuth", "elevation"])]
    pub(crate) camera: Option<String>,

    /// Fit the model into the view from this angle about up, from the front towards the right
    /// [default: 30]
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    pub(crate) azimuth: Option<f64>,

    /// Fit the model into the view from this angle above the horizon [default: 20]
    #[arg(long, value_name = "DEG", value_parser = elevation, allow_hyphen_values = true)]
    pub(crate) elevation: Option<f64>,

    /// Samples per pixel: 1, 2, 4, 8 or 16
    #[arg(long, value_name = "N", default_value = "4", value_parser = samples)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) samples: u32,

    /// Faces to cull: auto (by material), none, back
    #[arg(long, value_name = "SIDES", default_value = "auto", hide_possible_values = true)]
    pub(crate) cull: CullChoice,
}

/// The faces to cull.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CullChoice {
    /// As the material specifies.
    Auto,
    /// None.
    None,
    /// Back faces.
    Back,
}

impl From<CullChoice> for Cull {
    fn from(choice: CullChoice) -> Self {
        match choice {
            CullChoice::Auto => Self::Auto,
            CullChoice::None => Self::None,
            CullChoice::Back => Self::Back,
        }
    }
}

/// Degrees above the horizon, from straight below to straight above.
fn elevation(text: &str) -> Result<f64, String> {
    let degrees = finite(text)?;
    if degrees.abs() <= 90.0 {
        Ok(degrees)
    } else {
        Err("it must be between -90 and 90 degrees".to_owned())
    }
}
