//! The options that commands share, each defined once.
//!
//! The command line, the completions and the manual page derive from these structs.

mod execution;
mod frame;
mod input;
mod light;
mod material;
mod mode;
mod parameter;
mod picture;
mod shading;
mod view;

pub(crate) use execution::ExecutionOptions;
pub(crate) use frame::FrameOptions;
pub(crate) use input::InputOptions;
pub(crate) use light::LightOptions;
pub(crate) use material::MaterialOptions;
pub(crate) use mode::ModeOptions;
pub(crate) use picture::{EncodingChoice, PictureOptions};
pub(crate) use shading::{NormalsChoice, ShadingOptions};
pub(crate) use view::ViewOptions;
