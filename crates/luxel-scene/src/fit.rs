//! A camera for a scene that brings none: the whole model in view, and clipping planes around it.

use crate::extremes::{Along, Extremes, Place, Slope};
use crate::{Bounds, Camera, Lens, Projection, Scene, Size};
use glam::{DMat4, DQuat, DVec3};

/// How much of the window the silhouette may take, across and down.
const FILLED: f64 = 0.8;

/// The near plane is at least the far plane's distance divided by this, so that depth keeps
/// precision.
const MOST_FAR_BY_NEAR: f64 = 10_000.0;

/// By how much of the scene's depth, and of its distance, the planes stand off its bounds: what
/// lies on the bounds must not be clipped by rounding.
const PLANE_MARGIN: f64 = 1e-3;

/// The eye keeps this part of the scene's radius away from the nearest point. Fitted views of
/// solid things are several times as far; this is for lines seen end on.
const LEAST_DISTANCE: f64 = 0.1;

/// Maximum iterations of centring the view; each about squares the error.
const ROUNDS_OF_CENTRING: usize = 8;

/// Right, left, top and bottom of the picture: axis and sign.
const SIDES: [(usize, f64); 4] = [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)];

/// A step of centring this small, in parts of the scene's radius, is the last one: less than a
/// hundredth of a pixel, and the next would be its square.
const NEARLY_CENTRED: f64 = 1e-6;

/// From which side a model is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewpoint {
    /// The axis that azimuth turns about; any length but 0.
    pub up: DVec3,
    /// From the front towards the right.
    pub azimuth_radians: f64,
    /// From the horizon upwards.
    pub elevation_radians: f64,
}

impl Viewpoint {
    /// Right, up and front of a scene with this up direction.
    #[must_use]
    pub fn frame(up: DVec3) -> [DVec3; 3] {
        Self { up, azimuth_radians: 0.0, elevation_radians: 0.0 }.axes()
    }

    /// The directions right, up and back (towards the eye) of the picture, in world space.
    ///
    /// With +Y up, the front is where +Z points and the right where +X does. Any other axis takes
    /// that frame along on the shortest way from +Y: with +Z up, the front is -Y and the right
    /// still +X; with +X up they are +Z and -Y. For -Y the front stays +Z.
    #[must_use]
    pub fn axes(&self) -> [DVec3; 3] {
        let up = self.up.try_normalize().unwrap_or(DVec3::Y);
        // The shortest way to the opposite is not one but many.
        let world_from_standard = if up.y < -1.0 + 1e-12 {
            DQuat::from_xyzw(0.0, 0.0, 1.0, 0.0)
        } else {
            DQuat::from_rotation_arc(DVec3::Y, up)
        };
        let (sin_azimuth, cos_azimuth) = libm::sincos(self.azimuth_radians);
        let (sin_elevation, cos_elevation) = libm::sincos(self.elevation_radians);
        let back =
            DVec3::new(sin_azimuth * cos_elevation, sin_elevation, cos_azimuth * cos_elevation);
        let right = DVec3::new(cos_azimuth, 0.0, -sin_azimuth);
        [right, back.cross(right), back].map(|axis| {
            // Exact for the six axes of the world, whatever the rotation's rounding.
            let axis = world_from_standard * axis;
            axis.normalize_or(DVec3::Z)
        })
    }
}

/// The camera that sees a scene from a side as a whole: the silhouette of everything drawn (its
/// points, not its box) lies in the middle of the window and fills 80 % of it, across or
/// down, whichever is filled first.
///
/// For perspectives the eye is as near as possible. With the picture's axes as coordinates and
/// slopes l, r of the sides to fill, a point at (x, z) is inside for an eye at (e, h) if l (h - z)
/// <= x - e <= r (h - z); for all points that is h (r - l) >= max(x + r z) - min(x + l z), and
/// likewise up and down. The direction that isn't filled is then centred. Orthographic lenses keep
/// their height; a height of 0 becomes the one that fits. Near and far are those of [`fit_planes`].
/// A scene without anything to see is looked at from the side all the same.
#[must_use]
pub fn fit_view(scene: &Scene, viewpoint: &Viewpoint, lens: Lens, size: Size) -> Camera {
    fit_along(scene, viewpoint.axes(), lens, size)
}

/// As [`fit_view`], along any axes: the directions right, up and back of the picture, in world
/// space.
#[must_use]
pub fn fit_along(scene: &Scene, axes: [DVec3; 3], lens: Lens, size: Size) -> Camera {
    let picture_from_world = picture_from_world(axes);
    let objects = scene.objects();
    let in_world = scene.bounds_of(&objects);
    let points = scene.extremes(&objects, &|world_from_mesh| picture_from_world * *world_from_mesh);
    fit(&points, &in_world, &picture_from_world, lens, size)
}

/// As [`fit_along`], for the corners of a box.
#[must_use]
pub fn fit_box(bounds: &Bounds, axes: [DVec3; 3], lens: Lens, size: Size) -> Camera {
    let picture_from_world = picture_from_world(axes);
    let corners = if bounds.is_empty() { Vec::new() } else { Vec::from(bounds.corners()) };
    let corners = corners.into_iter().map(|corner| picture_from_world.transform_point3(corner));
    fit(&Extremes::of_points(corners.collect()), bounds, &picture_from_world, lens, size)
}

/// From world space to a picture's axes: right, up and back become x, y and z.
fn picture_from_world([right, up, back]: [DVec3; 3]) -> DMat4 {
    let world_from_picture = DMat4::from_cols(
        right.extend(0.0),
        up.extend(0.0),
        back.extend(0.0),
        DVec3::ZERO.extend(1.0),
    );
    world_from_picture.transpose()
}

/// The camera that fits points into the window; its planes enclose `in_world`.
fn fit(
    points: &Extremes<'_>,
    in_world: &Bounds,
    picture_from_world: &DMat4,
    lens: Lens,
    size: Size,
) -> Camera {
    let mut places = [None; 6];
    let bounds = points.bounds(&mut places);
    let (eye, lens) = if bounds.is_empty() || !is_measurable(&bounds) {
        (DVec3::Z, lens)
    } else if let Lens::Orthographic { height } = lens {
        let height = if height > 0.0 { height } else { fitting_height(&bounds, size) };
        let centre = bounds.centre();
        let distance = bounds.radius().max(height);
        (centre.with_z(bounds.max.z + distance), Lens::Orthographic { height })
    } else {
        // Where x and y are highest and lowest, the view's sides find their points soon.
        let [right, left, top, bottom, ..] = places;
        let places = [right, left, top, bottom];
        (fitted_eye(points, &bounds, &Slopes::of(lens, size), places), lens)
    };
    let translation = DMat4::from_translation(-eye);
    let view_from_world = translation * *picture_from_world;
    let (near, far) = fit_planes(in_world, &view_from_world);
    Camera { view_from_world, projection: Projection { lens, near, far } }
}

/// The near and far planes for a scene: its bounds, slightly widened, seen along the viewing axis;
/// near is at least far / 10000, and nothing behind the eye is in.
///
/// The rule is one for all lenses, for cameras inside of the scene, too. Where there is nothing in
/// front of the eye, the planes are sound all the same.
#[must_use]
pub fn fit_planes(bounds: &Bounds, view_from_world: &DMat4) -> (f64, f64) {
    let depths = bounds.corners().map(|corner| -view_from_world.transform_point3(corner).z);
    let nearest = depths.iter().copied().fold(f64::INFINITY, f64::min);
    let farthest = depths.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let depth = farthest - nearest;
    if bounds.is_empty() || !is_measurable(bounds) || !depth.is_finite() {
        return (1.0 / MOST_FAR_BY_NEAR, 1.0);
    }
    let margin = PLANE_MARGIN * (depth + nearest.abs().max(farthest.abs()));
    let mut far = farthest + margin;
    if far <= 0.0 || !far.is_normal() {
        far = if depth > 0.0 { depth } else { 1.0 };
    }
    ((nearest - margin).max(far / MOST_FAR_BY_NEAR), far)
}

/// Whether squares of coordinates are numbers.
fn is_measurable(bounds: &Bounds) -> bool {
    bounds.min.abs().max(bounds.max.abs()).max_element() < 1e150
}

/// The height of the picture, in world units, in which bounds fill their part.
fn fitting_height(bounds: &Bounds, size: Size) -> f64 {
    let extent = bounds.max - bounds.min;
    let height_by_width = f64::from(size.height.max(1)) / f64::from(size.width.max(1));
    let height = extent.y.max(extent.x * height_by_width) / FILLED;
    if height > 0.0 { height } else { size_of_a_point(bounds) }
}

/// How large the surroundings of something without extent are: in proportion to where it is, so
/// that adding the one to the other makes a difference.
fn size_of_a_point(bounds: &Bounds) -> f64 {
    let extent = bounds.radius();
    if extent > 0.0 { extent } else { (bounds.max.abs().max_element() * 1e-3).max(1.0) }
}

/// The slopes, sideways and upwards over forwards, of the sides of the part of the window to fill.
#[derive(Clone, Copy, Debug)]
struct Slopes {
    /// Left, then bottom.
    low: [f64; 2],
    /// Right, then top.
    high: [f64; 2],
}

impl Slopes {
    fn of(lens: Lens, size: Size) -> Self {
        let (width, height) = (f64::from(size.width.max(1)), f64::from(size.height.max(1)));
        let (low, high) = match lens {
            Lens::Perspective { fov_y_radians } => {
                let up = libm::tan(fov_y_radians * 0.5);
                ([-up * width / height, -up], [up * width / height, up])
            }
            Lens::Intrinsics { fx, fy, cx, cy } => {
                ([-cx / fx, (cy - height) / fy], [(width - cx) / fx, cy / fy])
            }
            Lens::Orthographic { .. } => ([-1.0; 2], [1.0; 2]),
        };
        let filled = |axis: usize, sign: f64| {
            (low[axis] + high[axis] + sign * FILLED * (high[axis] - low[axis])) * 0.5
        };
        Self { low: [filled(0, -1.0), filled(1, -1.0)], high: [filled(0, 1.0), filled(1, 1.0)] }
    }
}

/// The eye's place, in the picture's axes, from which all points lie within the slopes.
fn fitted_eye(
    points: &Extremes<'_>,
    bounds: &Bounds,
    slopes: &Slopes,
    mut places: [Option<Place>; 4],
) -> DVec3 {
    // For each direction: max(x + r z) and max(-(x + l z)).
    let support = [0, 1, 2, 3].map(|side| {
        let (axis, sign) = SIDES[side];
        let slope = if sign > 0.0 { slopes.high[axis] } else { slopes.low[axis] };
        points.highest(Along { axis, slope, sign }, &mut places[side]).0
    });
    let mut height = bounds.max.z + LEAST_DISTANCE * size_of_a_point(bounds);
    let mut eye = [0.0; 2];
    for axis in 0..2 {
        let opening = slopes.high[axis] - slopes.low[axis];
        let needed = (support[2 * axis] + support[2 * axis + 1]) / opening;
        if needed.is_finite() {
            height = height.max(needed);
        }
    }
    for axis in 0..2 {
        // The middle of the allowed range: exact where the direction is filled, a start elsewhere.
        let least = support[2 * axis] - slopes.high[axis] * height;
        let most = -support[2 * axis + 1] - slopes.low[axis] * height;
        eye[axis] = (least + most) * 0.5;
    }
    for _ in 0..ROUNDS_OF_CENTRING {
        let place = DVec3::new(eye[0], eye[1], height);
        let centred = centred(points, slopes, place, height - bounds.max.z, &mut places);
        let moved = (0..2).map(|axis| (centred[axis] - eye[axis]).abs()).fold(0.0, f64::max);
        if !moved.is_finite() {
            break;
        }
        eye = centred;
        if moved <= NEARLY_CENTRED * size_of_a_point(bounds) {
            break;
        }
    }
    DVec3::new(eye[0], eye[1], height)
}

/// Where the eye must move, sideways and upwards, so that the points that are outermost now come
/// to lie symmetrically: (x_1 - e) / d_1 + (x_2 - e) / d_2 = l + r, solved for e.
fn centred(
    points: &Extremes<'_>,
    slopes: &Slopes,
    eye: DVec3,
    nearest: f64,
    places: &mut [Option<Place>; 4],
) -> [f64; 2] {
    // Each slope with the distance of the point it belongs to; of equal ones, the farthest.
    let outermost = [0, 1, 2, 3].map(|side| {
        let (axis, sign) = SIDES[side];
        points.highest(Slope { axis, sign, eye, nearest }, &mut places[side])
    });
    [0, 1].map(|axis| {
        let [(high, high_distance), (low, low_distance)] =
            [outermost[2 * axis], outermost[2 * axis + 1]];
        let off = high - low - (slopes.low[axis] + slopes.high[axis]);
        eye[axis] + off / (1.0 / high_distance + 1.0 / low_distance)
    })
}

#[cfg(test)]
mod tests;
#[cfg(test)]
mod walk;
