//! Cameras (glTF 2.0 specification, section 3.10).

use super::buffers::malformed;
use crate::Error;
use luxel_gltf::Camera;
use luxel_scene::Lens;

/// The projection, and the near and far plane. The aspect ratio comes from the image size, so the
/// file's is ignored, and so is an orthographic camera's width.
pub(crate) fn convert(camera: &Camera, index: u32) -> Result<(Lens, (f64, f64)), Error> {
    let pointer = |part: &str| format!("/cameras/{index}{part}");
    let missing = |part: &str| malformed(pointer(""), format!("`{part}` is missing"));
    match camera.kind.as_str() {
        "perspective" => {
            let part = camera.perspective.as_ref().ok_or_else(|| missing("perspective"))?;
            let far = part.zfar.unwrap_or(f64::INFINITY);
            let fits = part.yfov > 0.0
                && part.yfov < std::f64::consts::PI
                && part.znear > 0.0
                && part.znear < far;
            if !fits {
                let message = "a perspective camera needs 0 < yfov < pi and 0 < znear < zfar";
                return Err(malformed(pointer("/perspective"), message));
            }
            Ok((Lens::Perspective { fov_y_radians: part.yfov }, (part.znear, far)))
        }
        "orthographic" => {
            let part = camera.orthographic.as_ref().ok_or_else(|| missing("orthographic"))?;
            // A negative magnification flips the image; the exporters that write one don't intend
            // it.
            let height = 2.0 * part.ymag.abs();
            if !(height > 0.0 && height.is_finite() && part.znear < part.zfar) {
                let message = "an orthographic camera needs ymag != 0 and znear < zfar";
                return Err(malformed(pointer("/orthographic"), message));
            }
            Ok((Lens::Orthographic { height }, (part.znear, part.zfar)))
        }
        other => {
            let message =
                format!("`{other}` is not a kind of camera: use perspective or orthographic");
            Err(malformed(pointer("/type"), message))
        }
    }
}
