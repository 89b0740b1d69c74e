//! Chooses the camera from flags and scene, by one rule for all commands.

use crate::failure::Failure;
use crate::options::FrameOptions;
pub(crate) use luxel::report::camera_to_json as to_json;
use luxel::scene::{Bounds, Camera, DMat4, DVec3, Lens, Scene, Size, fit_view};
use luxel::{CameraChoice, CameraError};

/// Chooses the camera: the matrix or the eye on the line, else the file's camera, else the model
/// fitted into the view.
///
/// # Errors
/// [`Failure`] if the flags contradict each other, or the scene has no camera of that name.
pub(crate) fn choose(options: &FrameOptions, scene: &Scene) -> Result<Camera, Failure> {
    of_flags(options).camera_of(scene, options.size).map_err(failure)
}

/// Whether the camera is fitted to the scene, rather than placed by the line or the file.
///
/// # Errors
/// [`Failure`] if the scene has no camera of the name on the line.
pub(crate) fn is_fitted(options: &FrameOptions, scene: &Scene) -> Result<bool, Failure> {
    of_flags(options).is_fitted(scene).map_err(failure)
}

/// A camera with this transform, and the clipping planes of the command line, else fitted ones.
///
/// # Errors
/// [`Failure::Usage`], if the planes contradict each other.
pub(crate) fn with_planes(
    options: &FrameOptions,
    bounds: &Bounds,
    view_from_world: DMat4,
    lens: Lens,
) -> Result<Camera, Failure> {
    of_flags(options).with_planes(bounds, view_from_world, lens).map_err(failure)
}

/// The point about which the camera turns.
pub(crate) fn pivot(options: &FrameOptions, scene: &Scene) -> DVec3 {
    of_flags(options).pivot(scene)
}

/// Cameras of a turntable: the chosen one rotated about its target, towards the
/// right, in `count` equal steps of a full turn.
///
/// # Errors
/// As [`choose`].
pub(crate) fn turntable(
    options: &FrameOptions,
    scene: &Scene,
    count: u32,
) -> Result<Vec<Camera>, Failure> {
    let chosen = choose(options, scene)?;
    if count == 1 {
        return Ok(vec![chosen]);
    }
    let bounds = scene.bounds();
    let up = options.up.unwrap_or(scene.up).normalize_or(DVec3::Y);
    let choice = of_flags(options);
    let pivot = choice.pivot(scene);
    let lens = chosen.projection.lens;
    let first = if is_fitted(options, scene)? {
        let distance = distance_from_all_sides(&choice, scene, options.size, lens);
        let [_, picture_up, back] = choice.viewpoint(scene).axes();
        Camera::look_at(pivot + back * distance, pivot, picture_up)
    } else {
        chosen.view_from_world
    };
    let turned = |number: u32| {
        let angle = std::f64::consts::TAU * f64::from(number) / f64::from(count);
        // Turning the eye to the right is turning the world to the left.
        let turn = DMat4::from_translation(pivot)
            * DMat4::from_axis_angle(up, -angle)
            * DMat4::from_translation(-pivot);
        with_planes(options, &bounds, first * turn, lens)
    };
    (0..count).map(turned).collect()
}

/// The distance from the centre at which the model fits the view from every side.
fn distance_from_all_sides(choice: &CameraChoice, scene: &Scene, size: Size, lens: Lens) -> f64 {
    /// Enough views that little exceeds the frame between two of them.
    const SIDES: u32 = 12;
    let pivot = choice.pivot(scene);
    let mut viewpoint = choice.viewpoint(scene);
    let mut distance: f64 = 0.0;
    for _ in 0..SIDES {
        let camera = fit_view(scene, &viewpoint, lens, size);
        distance = distance.max((pivot - camera.eye()).dot(camera.direction()));
        viewpoint.azimuth_radians += std::f64::consts::TAU / f64::from(SIDES);
    }
    distance
}

/// What the flags say of the camera.
fn of_flags(options: &FrameOptions) -> CameraChoice {
    let lens = if let Some([fx, fy, cx, cy]) = options.intrinsics {
        Some(Lens::Intrinsics { fx, fy, cx, cy })
    } else if let Some(height) = options.ortho {
        Some(Lens::Orthographic { height })
    } else {
        options.fov.map(|degrees| Lens::Perspective { fov_y_radians: degrees.to_radians() })
    };
    CameraChoice {
        eye: options.eye,
        target: options.target,
        up: options.up,
        view_from_world: options.view_matrix,
        camera: options.camera.clone(),
        azimuth_degrees: options.azimuth,
        elevation_degrees: options.elevation,
        lens,
        near: options.near,
        far: options.far,
    }
}

/// The failure, with the flags that cure it.
fn failure(error: CameraError) -> Failure {
    let usage = |message: &str| Failure::Usage(message.to_owned());
    match error {
        CameraError::TargetWithoutEye => usage("--target needs --eye"),
        CameraError::EyeAtTarget => {
            usage("eye and target are the same point: move --eye or --target")
        }
        CameraError::NoSuchCamera { ref known, .. } => {
            let remedy = if known.is_empty() {
                "the file has no camera: remove --camera".to_owned()
            } else {
                format!("use {}", known.join(", "))
            };
            Failure::work(error.to_string(), remedy)
        }
        CameraError::NearPlane => usage("--near must be above 0 for a perspective"),
        CameraError::FarPlane => usage("--far must be above 0 for a perspective"),
        CameraError::InfiniteFarPlane => usage("an orthographic camera needs a finite --far"),
        CameraError::PlanesOutOfOrder => usage("--near must be less than --far"),
        other => Failure::Usage(other.to_string()),
    }
}
