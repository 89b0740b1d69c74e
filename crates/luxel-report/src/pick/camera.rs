//! A camera as JSON.

use luxel_scene::{Camera, Size};
use serde_json::{Value, json};

/// A camera as JSON: `view_from_world` and `clip_from_view`, 4x4 matrices for column vectors, column by
/// column.
#[must_use]
pub fn camera_to_json(camera: &Camera, size: Size) -> Value {
    json!({
        "view_from_world": camera.view_from_world.to_cols_array(),
        "clip_from_view": camera.projection.clip_from_view(size).to_cols_array(),
    })
}
