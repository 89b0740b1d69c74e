//! Where clipped corners lie in the window, which way polygons turn, and what offsets do to depths.

use crate::depth::DepthKind;
use crate::primitive::{ClipCorner, plane_distances};
use crate::vertex::{Processed, WindowScale, codes};
use luxel_math::{F64Lanes, SUBPIXELS};
use luxel_visibility::{GUARD_BAND, Triangle, WindowVertex};

/// A plane of the clip volume or of the user.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Plane {
    /// One of the six of the clip volume, in clip coordinates.
    Volume([f64; 4]),
    /// A side of the guard band: like a plane of the volume, but vertices in the band stay.
    Guard([f64; 4]),
    /// Distances of the three corners from a plane of the user.
    User([f64; 3]),
}

impl Plane {
    pub(crate) fn distance(&self, corner: &ClipCorner) -> f64 {
        match self {
            Self::Volume(plane) => plane_distances(plane, corner),
            Self::Guard(plane) => {
                let distance = plane_distances(plane, corner);
                if corner.held { distance.max(0.0) } else { distance }
            }
            Self::User(distances) => {
                let [a, b, c] = distances;
                let [u, v, t] = corner.weights;
                a * u + b * v + c * t
            }
        }
    }
}

/// Twice the area of a triangle in the window, positive where it runs counter-clockwise.
pub(super) fn area([a, b, c]: [WindowVertex; 3]) -> f64 {
    let d = |p: i32, q: i32| f64::from(p) - f64::from(q);
    spanned_area([d(b.x, a.x), d(b.y, a.y)], [d(c.x, a.x), d(c.y, a.y)])
}

/// Twice the area of a triangle by the ways from its first corner to the others: ab x ac.
#[inline(always)]
pub(super) fn spanned_area<N: F64Lanes>([ab_x, ab_y]: [N; 2], [ac_x, ac_y]: [N; 2]) -> N {
    ab_x * ac_y - ac_x * ab_y
}

/// The area of a polygon in the window, doubled: positive where it runs counter-clockwise. Of one that reaches behind the
/// eye, and of vertices without places in the window, only the sign means something.
pub(crate) fn polygon_area(vertices: &Processed, scale: &WindowScale, corners: &[u32]) -> f64 {
    let held = |corner: &u32| vertices.codes[*corner as usize] & codes::NOT_HELD == 0;
    let fans = corners[1..].windows(2);
    if !vertices.window.is_empty() && corners.iter().all(held) {
        let place = |corner: u32| vertices.window[corner as usize];
        return fans.map(|pair| area([place(corners[0]), place(pair[0]), place(pair[1])])).sum();
    }
    // The volume that homogeneous coordinates span has its sign (Olano and Greer 1997).
    let [half_x, half_y] = scale.half.map(f64::from);
    let place = |corner: u32| {
        let [x, y, _, w] = vertices.clip[corner as usize].map(f64::from);
        glam::DVec3::new(x * half_x, y * half_y, w)
    };
    fans.map(|pair| place(corners[0]).dot(place(pair[0]).cross(place(pair[1])))).sum()
}

/// Clip coordinates in the window; `None` in the plane of the eye.
pub(crate) fn window_of(scale: &WindowScale, [x, y, z, w]: [f64; 4]) -> Option<WindowVertex> {
    if w.is_nan() || w <= 0.0 {
        return None;
    }
    let place = |value: f64, axis: usize| {
        let limit = f64::from(GUARD_BAND);
        let about_centre = (value * f64::from(scale.half[axis]) / w).clamp(-limit, limit);
        (about_centre + f64::from(scale.centre[axis])).round_ties_even() as i32
    };
    // Rounding must not carry a point past the planes that clip.
    let unit = (z / w).clamp(f64::from(scale.nearest), 1.0);
    let depth = unit * f64::from(scale.depth[0]) + f64::from(scale.depth[1]);
    Some(WindowVertex { x: place(x, 0), y: place(y, 1), z: depth as f32 })
}

/// max(|dz/dx|, |dz/dy|) a pixel.
pub(super) fn slope_of(triangle: &Triangle) -> f32 {
    let plane = &triangle.depth;
    plane.dz_dx.abs().max(plane.dz_dy.abs()) * SUBPIXELS as f32
}

/// `glPolygonOffset`: o = m factor + r units for factor, units and slope m, where r is the resolution of depths beside the
/// largest one (section 3.5.5).
pub(super) fn depth_offset(of: Option<[f32; 3]>, depths: DepthKind, largest: f32) -> f32 {
    let resolution = |units: f32| units * depths.resolution(largest);
    let by = of.map_or(0.0, |[factor, units, slope]| factor * slope + resolution(units));
    if by.is_finite() { by } else { 0.0 }
}
