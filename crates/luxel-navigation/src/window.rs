//! Conversion between window and camera space.

use glam::{DVec2, DVec3};
use luxel_scene::{Lens, Size};

/// Converts from the window's axes, y down, to the camera's, y up. The only place where y is flipped.
pub(crate) fn upwards(in_window: DVec2) -> DVec2 {
    DVec2::new(in_window.x, -in_window.y)
}

/// The camera-space point at `depth` in front of the eye that projects to `at` in the window.
pub(crate) fn point_at(lens: Lens, size: Size, at: DVec2, depth: f64) -> DVec3 {
    let middle = DVec2::new(f64::from(size.width), f64::from(size.height)) * 0.5;
    let across = match lens {
        Lens::Perspective { .. } | Lens::Orthographic { .. } => {
            upwards(at - middle) * (height_at(lens, size, depth) / (middle.y * 2.0))
        }
        Lens::Intrinsics { fx, fy, cx, cy } => {
            upwards(at - DVec2::new(cx, cy)) * depth / DVec2::new(fx, fy)
        }
    };
    across.extend(-depth)
}

/// The world-space height of the view at a depth.
pub(crate) fn height_at(lens: Lens, size: Size, depth: f64) -> f64 {
    match lens {
        Lens::Perspective { fov_y_radians } => 2.0 * libm::tan(fov_y_radians * 0.5) * depth,
        Lens::Orthographic { height } => height,
        Lens::Intrinsics { fy, .. } => f64::from(size.height) / fy * depth,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_scene::Projection;

    #[test]
    fn points_project_back_to_their_window_position() {
        let size = Size { width: 640, height: 400 };
        for lens in [
            Lens::Perspective { fov_y_radians: 0.7 },
            Lens::Orthographic { height: 3.0 },
            Lens::Intrinsics { fx: 500.0, fy: 450.0, cx: 300.0, cy: 220.0 },
        ] {
            let at = DVec2::new(123.25, 77.5);
            let point = point_at(lens, size, at, 2.5);
            let clip_from_view = Projection { lens, near: 0.1, far: 10.0 }.clip_from_view(size);
            let clip = clip_from_view * point.extend(1.0);
            let x = (clip.x / clip.w + 1.0) * 320.0;
            let y = (1.0 - clip.y / clip.w) * 200.0;
            assert!((x - at.x).abs() < 1e-10 && (y - at.y).abs() < 1e-10, "{lens:?}: {x} {y}");
        }
    }
}
