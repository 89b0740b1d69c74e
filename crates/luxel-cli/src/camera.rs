//! Chooses the camera from flags and scene, by one rule for all commands.

use crate::failure::Failure;
use crate::options::FrameOptions;
pub(crate) use luxel::report::camera_to_json as to_json;
use luxel::scene::{
    Bounds, Camera, DMat4, DVec3, Lens, Projection, Scene, SceneCamera, Viewpoint, fit_planes,
    fit_view,
};

/// Chooses the camera: the matrix or the eye on the line, else the file's camera, else the model
/// fitted into the view.
///
/// # Errors
/// [`Failure`] if the flags contradict each other, or the scene has no camera of that name.
pub(crate) fn choose(options: &FrameOptions, scene: &Scene) -> Result<Camera, Failure> {
    if options.target.is_some() && options.eye.is_none() {
        return Err(Failure::Usage("--target needs --eye".to_owned()));
    }
    let up = options.up.unwrap_or(scene.up);
    let of_file = file_camera(options, scene)?;
    let lens = lens(options, of_file);
    if !is_placed(options) && of_file.is_none() {
        let camera = fit_view(scene, &viewpoint(options, up), lens, options.size);
        if options.near.is_none() && options.far.is_none() {
            // Its planes are fitted by the same rule; this avoids another pass over a large scene.
            return Ok(camera);
        }
        return with_planes(options, &scene.bounds(), camera.view_from_world, lens);
    }
    let bounds = scene.bounds();
    let view_from_world = if let Some(matrix) = options.view_matrix {
        matrix
    } else if let Some(eye) = options.eye {
        let target = options.target.unwrap_or_else(|| middle(&bounds));
        if eye == target {
            let message = "eye and target are the same point: move --eye or --target";
            return Err(Failure::Usage(message.to_owned()));
        }
        Camera::look_at(eye, target, up)
    } else {
        of_file.map_or(DMat4::IDENTITY, |camera| luxel::view_from_world_of(camera, scene))
    };
    with_planes(options, &bounds, view_from_world, lens)
}

/// Whether the camera is fitted to the scene, rather than placed by the line or the file.
///
/// # Errors
/// [`Failure`] if the scene has no camera of the name on the line.
pub(crate) fn is_fitted(options: &FrameOptions, scene: &Scene) -> Result<bool, Failure> {
    Ok(!is_placed(options) && file_camera(options, scene)?.is_none())
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
    let (near, far) = planes(options, bounds, &view_from_world, lens)?;
    Ok(Camera { view_from_world, projection: Projection { lens, near, far } })
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
    let pivot = options.target.unwrap_or_else(|| middle(&bounds));
    let lens = chosen.projection.lens;
    let first = if is_fitted(options, scene)? {
        let distance = distance_from_all_sides(options, scene, pivot, lens);
        let [_, picture_up, back] = viewpoint(options, up).axes();
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
fn distance_from_all_sides(options: &FrameOptions, scene: &Scene, pivot: DVec3, lens: Lens) -> f64 {
    /// Enough views that little exceeds the frame between two of them.
    const SIDES: u32 = 12;
    let mut viewpoint = viewpoint(options, options.up.unwrap_or(scene.up));
    let mut distance: f64 = 0.0;
    for _ in 0..SIDES {
        let camera = fit_view(scene, &viewpoint, lens, options.size);
        distance = distance.max((pivot - camera.eye()).dot(camera.direction()));
        viewpoint.azimuth_radians += std::f64::consts::TAU / f64::from(SIDES);
    }
    distance
}

/// Whether the flags place the camera.
fn is_placed(options: &FrameOptions) -> bool {
    options.view_matrix.is_some() || options.eye.is_some()
}

/// The default view direction of a model without a camera.
fn viewpoint(options: &FrameOptions, up: DVec3) -> Viewpoint {
    Viewpoint {
        up,
        azimuth_radians: options.azimuth.unwrap_or(luxel::DEFAULT_AZIMUTH_DEGREES).to_radians(),
        elevation_radians: options
            .elevation
            .unwrap_or(luxel::DEFAULT_ELEVATION_DEGREES)
            .to_radians(),
    }
}

/// The camera of the file, if no flag replaces it.
fn file_camera<'a>(
    options: &FrameOptions,
    scene: &'a Scene,
) -> Result<Option<&'a SceneCamera>, Failure> {
    if let Some(name) = &options.camera {
        let found = scene.cameras.iter().find(|camera| camera.name == *name);
        return found.map(Some).ok_or_else(|| {
            let names: Vec<_> = scene.cameras.iter().map(|camera| camera.name.as_str()).collect();
            let remedy = if names.is_empty() {
                "the file has no camera: remove --camera".to_owned()
            } else {
                format!("use {}", names.join(", "))
            };
            Failure::work(format!("there is no camera `{name}`"), remedy)
        });
    }
    let is_elsewhere =
        is_placed(options) || options.azimuth.is_some() || options.elevation.is_some();
    Ok(if is_elsewhere { None } else { scene.cameras.first() })
}

fn lens(options: &FrameOptions, of_file: Option<&SceneCamera>) -> Lens {
    if let Some([fx, fy, cx, cy]) = options.intrinsics {
        Lens::Intrinsics { fx, fy, cx, cy }
    } else if let Some(height) = options.ortho {
        Lens::Orthographic { height }
    } else if let Some(degrees) = options.fov {
        Lens::Perspective { fov_y_radians: degrees.to_radians() }
    } else {
        of_file.map_or(
            Lens::Perspective { fov_y_radians: luxel::DEFAULT_FOV_DEGREES.to_radians() },
            |camera| camera.lens,
        )
    }
}

fn middle(bounds: &Bounds) -> DVec3 {
    if bounds.is_empty() { DVec3::ZERO } else { bounds.centre() }
}

/// The clipping planes: those on the line, else fitted to the scene's bounds.
fn planes(
    options: &FrameOptions,
    bounds: &Bounds,
    view_from_world: &DMat4,
    lens: Lens,
) -> Result<(f64, f64), Failure> {
    let orthographic = matches!(lens, Lens::Orthographic { .. });
    let usage = |message: &str| Err(Failure::Usage(message.to_owned()));
    if !orthographic && options.near.is_some_and(|near| near <= 0.0) {
        return usage("--near must be above 0 for a perspective");
    }
    if !orthographic && options.far.is_some_and(|far| far <= 0.0) {
        return usage("--far must be above 0 for a perspective");
    }
    if orthographic && options.far.is_some_and(f64::is_infinite) {
        return usage("an orthographic camera needs a finite --far");
    }
    if let (Some(near), Some(far)) = (options.near, options.far)
        && near >= far
    {
        return usage("--near must be less than --far");
    }
    let (fitted_near, fitted_far) = fit_planes(bounds, view_from_world);
    Ok(match (options.near, options.far) {
        (Some(near), Some(far)) => (near, far),
        (Some(near), None) if near >= fitted_far => (near, near + near.abs().max(1.0)),
        (Some(near), None) => (near, fitted_far),
        (None, Some(far)) if far <= fitted_near && orthographic => (far - far.abs().max(1.0), far),
        (None, Some(far)) if far <= fitted_near => (far / 10_000.0, far),
        (None, Some(far)) => (fitted_near, far),
        (None, None) => (fitted_near, fitted_far),
    })
}
