//! The camera that the flags and the scene ask for, by one rule for all commands.

use crate::failure::Failure;
use crate::options::FrameOptions;
use luxel::scene::{
    Bounds, Camera, DMat4, DVec3, Lens, Projection, Scene, SceneCamera, Size, Viewpoint,
    fit_planes, fit_view,
};
use serde_json::{Value, json};

/// The angle of view from bottom to top where nothing says otherwise.
const DEFAULT_FOV_DEGREES: f64 = 45.0;
const DEFAULT_AZIMUTH_DEGREES: f64 = 30.0;
const DEFAULT_ELEVATION_DEGREES: f64 = 20.0;

/// Chooses the camera: the matrix or the eye on the line, else the file's camera, else the model
/// fitted into the view.
///
/// # Errors
/// [`Failure`], if the flags contradict each other or the scene has no camera of that name.
pub(crate) fn choose(options: &FrameOptions, scene: &Scene) -> Result<Camera, Failure> {
    let bounds = scene.bounds();
    let up = options.up.unwrap_or(scene.up);
    let of_file = file_camera(options, scene)?;
    let lens = lens(options, of_file);
    let view_from_world = if let Some(matrix) = options.view_matrix {
        matrix
    } else if let Some(eye) = options.eye {
        let target = options.target.unwrap_or_else(|| middle(&bounds));
        if eye == target {
            let message = "the eye stands at its target: move --eye or --target";
            return Err(Failure::Usage(message.to_owned()));
        }
        Camera::look_at(eye, target, up)
    } else if let Some(camera) = of_file {
        view_of(camera, scene)
    } else {
        fit_view(scene, &viewpoint(options, up), lens, options.size).view_from_world
    };
    let (near, far) = planes(options, &bounds, &view_from_world, lens)?;
    Ok(Camera { view_from_world, projection: Projection { lens, near, far } })
}

/// Cameras for pictures from all around: the chosen one turned about what it looks at, towards the
/// right, once around in `count` equal steps.
///
/// # Errors
/// As [`choose`].
pub(crate) fn turntable(
    options: &FrameOptions,
    scene: &Scene,
    count: u32,
) -> Result<Vec<Camera>, Failure> {
    let first = choose(options, scene)?;
    let bounds = scene.bounds();
    let pivot = options.target.unwrap_or_else(|| middle(&bounds));
    let up = options.up.unwrap_or(scene.up).normalize_or(DVec3::Y);
    let turned = |number: u32| {
        let angle = std::f64::consts::TAU * f64::from(number) / f64::from(count);
        // Turning the eye to the right is turning the world to the left.
        let turn = DMat4::from_translation(pivot)
            * DMat4::from_axis_angle(up, -angle)
            * DMat4::from_translation(-pivot);
        let view_from_world = first.view_from_world * turn;
        let lens = first.projection.lens;
        let (near, far) = planes(options, &bounds, &view_from_world, lens)?;
        Ok(Camera { view_from_world, projection: Projection { lens, near, far } })
    };
    std::iter::once(Ok(first)).chain((1..count).map(turned)).collect()
}

/// From which side a model is looked at that brings no camera.
fn viewpoint(options: &FrameOptions, up: DVec3) -> Viewpoint {
    Viewpoint {
        up,
        azimuth_radians: options.azimuth.unwrap_or(DEFAULT_AZIMUTH_DEGREES).to_radians(),
        elevation_radians: options.elevation.unwrap_or(DEFAULT_ELEVATION_DEGREES).to_radians(),
    }
}

/// The camera of the file that the flags leave in charge.
fn file_camera<'a>(
    options: &FrameOptions,
    scene: &'a Scene,
) -> Result<Option<&'a SceneCamera>, Failure> {
    if let Some(name) = &options.camera {
        let found = scene.cameras.iter().find(|camera| camera.name == *name);
        return found.map(Some).ok_or_else(|| {
            let names: Vec<_> = scene.cameras.iter().map(|camera| camera.name.as_str()).collect();
            let remedy = if names.is_empty() {
                "the file has no camera: leave --camera out".to_owned()
            } else {
                format!("use {}", names.join(", "))
            };
            Failure::work(format!("there is no camera `{name}`"), remedy)
        });
    }
    let placed = options.view_matrix.is_some()
        || options.eye.is_some()
        || options.azimuth.is_some()
        || options.elevation.is_some();
    Ok(if placed { None } else { scene.cameras.first() })
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
            Lens::Perspective { fov_y_radians: DEFAULT_FOV_DEGREES.to_radians() },
            |camera| camera.lens,
        )
    }
}

/// From world space to a camera of the file; scale on its nodes doesn't reach it.
fn view_of(camera: &SceneCamera, scene: &Scene) -> DMat4 {
    let world_from_camera = camera
        .node
        .and_then(|node| scene.world_from_nodes().get(node.index()).copied())
        .unwrap_or(DMat4::IDENTITY);
    let eye = world_from_camera.w_axis.truncate();
    let back = world_from_camera.z_axis.truncate().normalize_or(DVec3::Z);
    Camera::look_at(eye, eye - back, world_from_camera.y_axis.truncate())
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
        return usage("parallel rays need a finite --far");
    }
    if let (Some(near), Some(far)) = (options.near, options.far)
        && near >= far
    {
        return usage("--near must lie before --far");
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

/// What `--json` says about a camera: its matrices, column by column.
pub(crate) fn to_json(camera: &Camera, size: Size) -> Value {
    json!({
        "view_from_world": camera.view_from_world.to_cols_array(),
        "clip_from_view": camera.projection.clip_from_view(size).to_cols_array(),
    })
}
