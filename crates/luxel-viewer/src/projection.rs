//! Projection from world space to window pixels, from the upper left, and back; parts of the window.

use luxel::pick::{Viewport, place_in_picture, project};
use luxel::scene::{Camera, DMat4, DVec2, DVec3, Lens, Projection, Size};

/// A part of a window, in pixels from its upper left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct WindowPart {
    pub(crate) left: u32,
    pub(crate) top: u32,
    pub(crate) size: Size,
}

impl WindowPart {
    /// All of a window.
    pub(crate) fn whole(size: Size) -> Self {
        Self { left: 0, top: 0, size }
    }

    /// The lens of a camera that sees only this part of a window. Orthographic ones see it from the
    /// offset of [`shift`](Self::shift).
    pub(crate) fn lens(self, lens: Lens, window: Size) -> Lens {
        let (width, height) = (f64::from(window.width), f64::from(window.height));
        let (left, top) = (f64::from(self.left), f64::from(self.top));
        match lens {
            Lens::Perspective { .. } => {
                let projection = Projection { lens, near: 1.0, far: 2.0 };
                let focal = height * 0.5 * projection.clip_from_view(window).y_axis.y;
                let (cx, cy) = (width * 0.5 - left, height * 0.5 - top);
                Lens::Intrinsics { fx: focal, fy: focal, cx, cy }
            }
            Lens::Intrinsics { fx, fy, cx, cy } => {
                Lens::Intrinsics { fx, fy, cx: cx - left, cy: cy - top }
            }
            Lens::Orthographic { height: extent } => {
                Lens::Orthographic { height: extent / height * f64::from(self.size.height) }
            }
        }
    }

    /// How far the middle of this part lies from the window's, to the right and up, in the world units
    /// of an orthographic window of a height; nothing for other lenses.
    pub(crate) fn shift(self, lens: Lens, window: Size) -> DVec3 {
        let Lens::Orthographic { height } = lens else { return DVec3::ZERO };
        let pixel = height / f64::from(window.height);
        let middle = |start: u32, side: u32, of: u32| {
            (f64::from(start) + f64::from(side) * 0.5 - f64::from(of) * 0.5) * pixel
        };
        let right = middle(self.left, self.size.width, window.width);
        let down = middle(self.top, self.size.height, window.height);
        DVec3::new(right, -down, 0.0)
    }

    /// The camera that sees only this part of another camera's window.
    pub(crate) fn camera(self, camera: &Camera, window: Size) -> Camera {
        let Projection { lens, near, far } = camera.projection;
        let shift = DMat4::from_translation(-self.shift(lens, window));
        let view_from_world = match lens {
            Lens::Orthographic { .. } => shift * camera.view_from_world,
            _ => camera.view_from_world,
        };
        Camera {
            view_from_world,
            projection: Projection { lens: self.lens(lens, window), near, far },
        }
    }
}

/// Projects a line segment to window pixels, clipped at the near plane; `None` if nothing is left.
pub(crate) fn project_line(camera: &Camera, size: Size, ends: [DVec3; 2]) -> Option<[DVec2; 2]> {
    let [a, b] = ends.map(|end| camera.view_from_world.transform_point3(end));
    // The camera looks along -z.
    let front = -camera.projection.near;
    let cut = |end: DVec3, other: DVec3| {
        let is_behind = end.z > front;
        if is_behind { end + (other - end) * ((front - end.z) / (other.z - end.z)) } else { end }
    };
    if a.z > front && b.z > front {
        return None;
    }
    let clip_from_view = camera.projection.clip_from_view(size);
    let place = |end| {
        let place = project(end, &DMat4::IDENTITY, &clip_from_view, Viewport::of(size))?;
        let (x, y) = (place.x, f64::from(size.height) - place.y);
        // Far outside, coordinates would overflow the painter's fixed point.
        (x.abs() < MAX_COORDINATE && y.abs() < MAX_COORDINATE).then_some(DVec2::new(x, y))
    };
    Some([place(cut(a, b))?, place(cut(b, a))?])
}

/// The largest coordinate, in pixels from the window's corner.
const MAX_COORDINATE: f64 = 5e4;

/// Projects a point to window pixels and depth, 0 near to 1 far; `None` behind the camera or far
/// outside the window.
pub(crate) fn project_point(camera: &Camera, size: Size, point: DVec3) -> Option<DVec3> {
    place_in_picture(camera, size, point)
        .filter(|place| place.x.abs() < MAX_COORDINATE && place.y.abs() < MAX_COORDINATE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::pick::point_in_picture;

    const SIZE: Size = Size { width: 200, height: 100 };

    fn camera(lens: Lens) -> Camera {
        let projection = Projection { lens, near: 1.0, far: 100.0 };
        Camera { view_from_world: DMat4::IDENTITY, projection }
    }

    #[test]
    fn a_point_is_drawn_where_the_picture_shows_it() {
        // 100 pixels are 20 units; y points up in the world, down in the window.
        let parallel = camera(Lens::Orthographic { height: 20.0 });
        let ends = [DVec3::new(2.0, 4.0, -5.0), DVec3::new(-10.0, -10.0, -50.0)];
        let [a, b] = project_line(&parallel, SIZE, ends).unwrap();
        assert!(a.abs_diff_eq(DVec2::new(110.0, 30.0), 1e-9), "{a}");
        assert!(b.abs_diff_eq(DVec2::new(50.0, 100.0), 1e-9), "{b}");
    }

    #[test]
    fn a_line_past_the_eye_is_cut_at_the_near_plane() {
        let lens = Lens::Perspective { fov_y_radians: std::f64::consts::FRAC_PI_2 };
        let ends = [DVec3::new(0.5, 0.0, -3.0), DVec3::new(0.5, 0.0, 7.0)];
        let [a, b] = project_line(&camera(lens), SIZE, ends).unwrap();
        // x / -z times half the height, from the middle.
        assert!(a.abs_diff_eq(DVec2::new(100.0 + 50.0 / 6.0, 50.0), 1e-9), "{a}");
        assert!(b.abs_diff_eq(DVec2::new(125.0, 50.0), 1e-9), "{b}");
        assert_eq!(project_line(&camera(lens), SIZE, [ends[1]; 2]), None);
    }

    #[test]
    fn a_point_of_the_window_is_found_again_in_the_world() {
        let point = DVec3::new(1.5, -2.0, -30.0);
        for lens in [Lens::Orthographic { height: 20.0 }, Lens::Perspective { fov_y_radians: 0.9 }]
        {
            let place = project_point(&camera(lens), SIZE, point).unwrap();
            let back = point_in_picture(&camera(lens), SIZE, place).unwrap();
            assert!(back.abs_diff_eq(point, 1e-6), "{lens:?}: {back}");
        }
        let lens = Lens::Perspective { fov_y_radians: 0.9 };
        assert_eq!(project_point(&camera(lens), SIZE, DVec3::Z), None);
    }
}
