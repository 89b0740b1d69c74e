//! The flags of a view of a scene.

use super::{
    ExecutionOptions, FrameOptions, LightOptions, MaterialOptions, ModeOptions, PictureOptions,
    ShadingOptions,
};
use clap::Args;

/// Everything that affects an image of a scene.
#[derive(Args, Clone, Debug)]
pub(crate) struct ViewOptions {
    #[command(flatten)]
    pub(crate) frame: FrameOptions,
    #[command(flatten)]
    pub(crate) light: LightOptions,
    #[command(flatten)]
    pub(crate) material: MaterialOptions,
    #[command(flatten)]
    pub(crate) shading: ShadingOptions,
    #[command(flatten)]
    pub(crate) mode: ModeOptions,
    #[command(flatten)]
    pub(crate) picture: PictureOptions,
    #[command(flatten)]
    pub(crate) execution: ExecutionOptions,
}
