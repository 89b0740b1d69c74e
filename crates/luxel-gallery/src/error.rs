//! Why a gallery can't be made.

use luxel::render::RenderError;

/// The reason why the gallery can't be built.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum GalleryError {
    /// The renderer can't draw.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// A picture can't be encoded.
    #[error("a picture can't be encoded: {0}")]
    Png(#[from] png::EncodingError),
    /// Rays can't be followed.
    #[error("rays can't be followed: {0}")]
    Rays(String),
}
