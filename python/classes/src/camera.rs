//! Cameras: fitted to a scene, or placed in the world.

use crate::arrays::{matrix, vector};
use crate::errors::{argument, error};
use luxel::scene::{
    Camera, DMat4, DVec3, DVec4, Lens, Projection, Scene, Size, Viewpoint, fit_planes, fit_view,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

// Signatures show numbers, not names.
const _: () = assert!(luxel::DEFAULT_AZIMUTH_DEGREES == 30.0);
const _: () = assert!(luxel::DEFAULT_ELEVATION_DEGREES == 20.0);

/// Where a camera is.
#[derive(Clone, Debug)]
enum Pose {
    /// So that the whole model is seen from a direction, in degrees.
    Fitted { azimuth: f64, elevation: f64 },
    /// At an eye, looking to a target; up defaults to the scene's.
    LookAt { eye: DVec3, target: DVec3, up: Option<DVec3> },
    /// From world to view coordinates.
    Placed(DMat4),
}

/// A camera: where it is, its lens and its clipping planes.
#[pyclass(name = "Camera", module = "luxel", frozen)]
#[derive(Clone, Debug)]
pub(crate) struct PyCamera {
    pose: Pose,
    lens: Lens,
    near: Option<f64>,
    far: Option<f64>,
}

/// The lens of a camera's keyword arguments.
fn lens(
    fov_y: Option<f64>,
    height: Option<f64>,
    intrinsics: Option<&Bound<'_, PyAny>>,
) -> PyResult<Lens> {
    match (fov_y, height, intrinsics) {
        (None, None, Some(numbers)) => {
            let [fx, fy, cx, cy] = match vector::<4>("intrinsics", numbers) {
                Ok(numbers) => numbers,
                Err(_) => of_matrix(numbers)?,
            };
            if fx > 0.0 && fy > 0.0 {
                Ok(Lens::Intrinsics { fx, fy, cx, cy })
            } else {
                Err(argument("intrinsics", "focal lengths must be above 0"))
            }
        }
        (None, Some(height), None) => match height > 0.0 && height.is_finite() {
            true => Ok(Lens::Orthographic { height }),
            false => Err(argument("height", "it must be above 0")),
        },
        (fov_y, None, None) => {
            let fov_y = fov_y.unwrap_or(luxel::DEFAULT_FOV_DEGREES);
            match fov_y > 0.0 && fov_y < 180.0 {
                true => Ok(Lens::Perspective { fov_y_radians: fov_y.to_radians() }),
                false => Err(argument("fov_y", "it must be between 0 and 180 degrees")),
            }
        }
        _ => Err(PyTypeError::new_err("fov_y, height and intrinsics exclude each other")),
    }
}

/// fx, fy, cx, cy of a 3x3 matrix without skew.
fn of_matrix(matrix: &Bound<'_, PyAny>) -> PyResult<[f64; 4]> {
    let expected = "expected fx, fy, cx, cy or a 3x3 matrix [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]";
    let rows = crate::arrays::rows::<3>("intrinsics", matrix)
        .map_err(|_| argument("intrinsics", expected))?;
    match rows[..] {
        [[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]] => Ok([fx, fy, cx, cy]),
        _ => Err(argument("intrinsics", expected)),
    }
}

/// Clipping planes of keyword arguments.
fn check_planes(near: Option<f64>, far: Option<f64>) -> PyResult<()> {
    if near.is_some_and(|near| !(near > 0.0 && near.is_finite())) {
        return Err(argument("near", "it must be above 0"));
    }
    if far.is_some_and(|far| far.is_nan() || far <= near.unwrap_or(0.0)) {
        return Err(argument("far", "it must be beyond near"));
    }
    Ok(())
}

#[pymethods]
impl PyCamera {
    /// A camera that sees the whole model from a direction, as the command line does by default.
    #[staticmethod]
    #[pyo3(signature = (azimuth=30.0, elevation=20.0, *, fov_y=None, height=None, intrinsics=None, near=None, far=None))]
    fn fit(
        azimuth: f64,
        elevation: f64,
        fov_y: Option<f64>,
        height: Option<f64>,
        intrinsics: Option<&Bound<'_, PyAny>>,
        near: Option<f64>,
        far: Option<f64>,
    ) -> PyResult<Self> {
        check_planes(near, far)?;
        if !azimuth.is_finite() || !elevation.is_finite() {
            return Err(argument("azimuth, elevation", "expected finite numbers, in degrees"));
        }
        let pose = Pose::Fitted { azimuth, elevation };
        Ok(Self { pose, lens: lens(fov_y, height, intrinsics)?, near, far })
    }

    /// A camera at `eye` that looks to `target`.
    #[staticmethod]
    #[pyo3(signature = (eye, target, up=None, *, fov_y=None, height=None, intrinsics=None, near=None, far=None))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments")]
    fn look_at(
        eye: &Bound<'_, PyAny>,
        target: &Bound<'_, PyAny>,
        up: Option<&Bound<'_, PyAny>>,
        fov_y: Option<f64>,
        height: Option<f64>,
        intrinsics: Option<&Bound<'_, PyAny>>,
        near: Option<f64>,
        far: Option<f64>,
    ) -> PyResult<Self> {
        check_planes(near, far)?;
        let eye = DVec3::from_array(vector("eye", eye)?);
        let target = DVec3::from_array(vector("target", target)?);
        if eye == target {
            return Err(argument("eye", "it is the same point as the target"));
        }
        let up = up.map(|up| vector("up", up)).transpose()?.map(DVec3::from_array);
        if up == Some(DVec3::ZERO) {
            return Err(argument("up", "it has no direction"));
        }
        let pose = Pose::LookAt { eye, target, up };
        Ok(Self { pose, lens: lens(fov_y, height, intrinsics)?, near, far })
    }

    /// A camera by its 4x4 pose, from camera to world coordinates. `convention` says where its axes
    /// point: `opengl` (x right, y up, z back, as pyrender and trimesh have it) or `opencv` (x right, y down,
    /// z ahead).
    #[staticmethod]
    #[pyo3(signature = (pose, convention="opengl", *, fov_y=None, height=None, intrinsics=None, near=None, far=None))]
    fn from_pose(
        pose: &Bound<'_, PyAny>,
        convention: &str,
        fov_y: Option<f64>,
        height: Option<f64>,
        intrinsics: Option<&Bound<'_, PyAny>>,
        near: Option<f64>,
        far: Option<f64>,
    ) -> PyResult<Self> {
        check_planes(near, far)?;
        let pose = DMat4::from_cols_array_2d(&matrix("pose", pose)?);
        let flipped = DMat4::from_diagonal(DVec4::new(1.0, -1.0, -1.0, 1.0));
        let world_from_camera = match convention {
            "opengl" => pose,
            "opencv" => pose * flipped,
            other => {
                let expected = format!("`{other}` is neither `opengl` nor `opencv`");
                return Err(argument("convention", expected));
            }
        };
        let view_from_world = rigid_inverse(&world_from_camera)?;
        Ok(Self {
            pose: Pose::Placed(view_from_world),
            lens: lens(fov_y, height, intrinsics)?,
            near,
            far,
        })
    }

    fn __repr__(&self) -> String {
        let lens = match self.lens {
            Lens::Perspective { fov_y_radians } => format!("fov_y={}", fov_y_radians.to_degrees()),
            Lens::Orthographic { height } => format!("height={height}"),
            Lens::Intrinsics { fx, fy, cx, cy } => format!("intrinsics=({fx}, {fy}, {cx}, {cy})"),
        };
        match &self.pose {
            Pose::Fitted { azimuth, elevation } => {
                format!("Camera.fit({azimuth}, {elevation}, {lens})")
            }
            Pose::LookAt { eye, target, .. } => {
                format!("Camera.look_at({:?}, {:?}, {lens})", eye.to_array(), target.to_array())
            }
            Pose::Placed(_) => format!("Camera.from_pose(..., {lens})"),
        }
    }
}

/// The inverse of a rotation and translation.
fn rigid_inverse(pose: &DMat4) -> PyResult<DMat4> {
    let columns = pose.inverse().to_cols_array().map(|number| number.to_string()).join(",");
    // The rule of the command line: orthonormal to 1e-4.
    luxel::formats::values::view_matrix(&columns)
        .map_err(|_| argument("pose", "expected a rotation and a translation, without scale"))
}

impl PyCamera {
    /// The camera in a scene, for a picture of this size.
    ///
    /// # Errors
    /// `luxel.Error` if the clipping planes contradict each other.
    pub(crate) fn placed(&self, scene: &Scene, size: Size) -> PyResult<Camera> {
        let Self { pose, lens, near, far } = self;
        let view_from_world = match pose {
            Pose::Fitted { azimuth, elevation } => {
                let viewpoint = Viewpoint {
                    up: scene.up,
                    azimuth_radians: azimuth.to_radians(),
                    elevation_radians: elevation.to_radians(),
                };
                let camera = fit_view(scene, &viewpoint, *lens, size);
                if near.is_none() && far.is_none() {
                    return Ok(camera);
                }
                camera.view_from_world
            }
            Pose::LookAt { eye, target, up } => {
                Camera::look_at(*eye, *target, up.unwrap_or(scene.up))
            }
            Pose::Placed(view_from_world) => *view_from_world,
        };
        let (near, far) = match (*near, *far) {
            (Some(near), Some(far)) => (near, far),
            (near, far) => {
                let (nearest, farthest) = fit_planes(&scene.bounds(), &view_from_world);
                (near.unwrap_or(nearest), far.unwrap_or(farthest))
            }
        };
        if near >= far {
            return Err(error(format!("the near plane ({near}) lies beyond the far one ({far})")));
        }
        Ok(Camera { view_from_world, projection: Projection { lens: *lens, near, far } })
    }
}

/// A camera argument: a [`PyCamera`], the name of one of the file's, a 4x4 pose, or nothing.
///
/// # Errors
/// `TypeError` or `ValueError` for anything else.
pub(crate) fn camera_of(
    value: Option<&Bound<'_, PyAny>>,
    scene: &Scene,
    size: Size,
) -> PyResult<Camera> {
    let Some(value) = value else { return Ok(luxel::default_camera(scene, size)) };
    if let Ok(camera) = value.cast::<PyCamera>() {
        return camera.get().placed(scene, size);
    }
    if let Ok(name) = value.extract::<String>() {
        let Some(camera) = scene.cameras.iter().find(|camera| camera.name == name) else {
            let names: Vec<_> = scene.cameras.iter().map(|camera| camera.name.as_str()).collect();
            let there = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
            return Err(argument(
                "camera",
                format!("there is no camera `{name}`; the file has {there}"),
            ));
        };
        let view_from_world = luxel::view_from_world_of(camera, scene);
        let (near, far) = fit_planes(&scene.bounds(), &view_from_world);
        return Ok(Camera {
            view_from_world,
            projection: Projection { lens: camera.lens, near, far },
        });
    }
    let lens = lens(None, None, None)?;
    let pose = DMat4::from_cols_array_2d(&matrix("camera", value).map_err(|_| {
        PyTypeError::new_err("camera: expected a luxel.Camera, the name of a camera, or a 4x4 pose")
    })?);
    let pose = Pose::Placed(rigid_inverse(&pose)?);
    PyCamera { pose, lens, near: None, far: None }.placed(scene, size)
}
