//! The choice of a view's camera, by one rule for all programs.

use crate::default_view::{
    DEFAULT_AZIMUTH_DEGREES, DEFAULT_ELEVATION_DEGREES, DEFAULT_FOV_DEGREES, view_from_world_of,
};
use luxel_scene::{
    Bounds, Camera, DMat4, DVec3, Lens, Projection, Scene, SceneCamera, Size, Viewpoint,
    fit_planes, fit_view,
};

/// What decides the camera: its place, else a camera of the file, else the model fitted into the view.
///
/// ```
/// # use luxel::{CameraChoice, scene::{DVec3, Size, demos}};
/// let scene = demos::demo("teapot").unwrap();
/// let choice = CameraChoice { eye: Some(DVec3::new(0.0, 1.0, 8.0)), ..CameraChoice::default() };
/// let camera = choice.camera_of(&scene, Size { width: 640, height: 360 })?;
/// assert!(camera.eye().abs_diff_eq(DVec3::new(0.0, 1.0, 8.0), 1e-12));
/// # Ok::<(), luxel::CameraError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CameraChoice {
    /// The eye's place.
    pub eye: Option<DVec3>,
    /// What the eye looks at; `None`: the centre of the scene's bounds. Needs `eye`.
    pub target: Option<DVec3>,
    /// What is up, of any length but 0; `None`: as in the scene.
    pub up: Option<DVec3>,
    /// From world to camera space: rotation and translation, instead of `eye`.
    pub view_from_world: Option<DMat4>,
    /// A camera of the file by its name; `None`: its first.
    pub camera: Option<String>,
    /// The angle about up from which the model is fitted into the view, from the front to the right.
    pub azimuth_degrees: Option<f64>,
    /// The angle above the horizon from which the model is fitted into the view.
    pub elevation_degrees: Option<f64>,
    /// The lens; `None`: that of the file's camera, else 45 degrees from bottom to top.
    pub lens: Option<Lens>,
    /// The distance of the near plane; `None`: fitted to the scene.
    pub near: Option<f64>,
    /// The distance of the far plane, possibly infinite; `None`: fitted to the scene.
    pub far: Option<f64>,
}

/// Why there is no such camera.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CameraError {
    /// A target without an eye.
    #[error("the target needs an eye")]
    TargetWithoutEye,
    /// Eye and target are equal.
    #[error("eye and target are the same point")]
    EyeAtTarget,
    /// The file has no camera of this name.
    #[error("there is no camera `{name}`")]
    NoSuchCamera {
        /// The name.
        name: String,
        /// The names of the file's cameras.
        known: Vec<String>,
    },
    /// The near plane of a perspective is not before the eye.
    #[error("the near plane of a perspective must be above 0")]
    NearPlane,
    /// The far plane of a perspective is not before the eye.
    #[error("the far plane of a perspective must be above 0")]
    FarPlane,
    /// An orthographic camera without a far plane.
    #[error("an orthographic camera needs a finite far plane")]
    InfiniteFarPlane,
    /// Near and far planes in the wrong order.
    #[error("the near plane must be nearer than the far plane")]
    PlanesOutOfOrder,
}

impl CameraChoice {
    /// The camera of a scene for pictures of a size.
    ///
    /// # Errors
    /// [`CameraError`] if the fields contradict each other, or the scene has no camera of that name.
    pub fn camera_of(&self, scene: &Scene, size: Size) -> Result<Camera, CameraError> {
        if self.target.is_some() && self.eye.is_none() {
            return Err(CameraError::TargetWithoutEye);
        }
        let of_file = self.file_camera(scene)?;
        let lens = self.lens_with(of_file);
        if !self.is_placed() && of_file.is_none() {
            let camera = fit_view(scene, &self.viewpoint(scene), lens, size);
            if self.near.is_none() && self.far.is_none() {
                // Its planes are fitted by the same rule; this avoids another pass over a large scene.
                return Ok(camera);
            }
            return self.with_planes(&scene.bounds(), camera.view_from_world, lens);
        }
        let bounds = scene.bounds();
        let view_from_world = if let Some(matrix) = self.view_from_world {
            matrix
        } else if let Some(eye) = self.eye {
            let target = self.target.unwrap_or_else(|| middle(&bounds));
            if eye == target {
                return Err(CameraError::EyeAtTarget);
            }
            Camera::look_at(eye, target, self.up.unwrap_or(scene.up))
        } else {
            of_file.map_or(DMat4::IDENTITY, |camera| view_from_world_of(camera, scene))
        };
        self.with_planes(&bounds, view_from_world, lens)
    }

    /// Whether the camera is fitted to the scene, rather than placed by a field or by the file.
    ///
    /// # Errors
    /// [`CameraError::NoSuchCamera`].
    pub fn is_fitted(&self, scene: &Scene) -> Result<bool, CameraError> {
        Ok(!self.is_placed() && self.file_camera(scene)?.is_none())
    }

    /// A camera with this transform, and the clipping planes of the fields, else fitted ones.
    ///
    /// # Errors
    /// [`CameraError`], if the planes contradict each other.
    pub fn with_planes(
        &self,
        bounds: &Bounds,
        view_from_world: DMat4,
        lens: Lens,
    ) -> Result<Camera, CameraError> {
        let (near, far) = self.planes(bounds, &view_from_world, lens)?;
        Ok(Camera { view_from_world, projection: Projection { lens, near, far } })
    }

    /// The point about which the camera turns: the target, else the centre of the scene's bounds.
    #[must_use]
    pub fn pivot(&self, scene: &Scene) -> DVec3 {
        self.target.unwrap_or_else(|| middle(&scene.bounds()))
    }

    /// The direction from which a model without a camera is looked at.
    #[must_use]
    pub fn viewpoint(&self, scene: &Scene) -> Viewpoint {
        let azimuth = self.azimuth_degrees.unwrap_or(DEFAULT_AZIMUTH_DEGREES);
        let elevation = self.elevation_degrees.unwrap_or(DEFAULT_ELEVATION_DEGREES);
        Viewpoint {
            up: self.up.unwrap_or(scene.up),
            azimuth_radians: azimuth.to_radians(),
            elevation_radians: elevation.to_radians(),
        }
    }

    /// Whether a field places the camera.
    fn is_placed(&self) -> bool {
        self.view_from_world.is_some() || self.eye.is_some()
    }

    /// The camera of the file, if no field replaces it.
    fn file_camera<'a>(&self, scene: &'a Scene) -> Result<Option<&'a SceneCamera>, CameraError> {
        if let Some(name) = &self.camera {
            let found = scene.cameras.iter().find(|camera| camera.name == *name);
            return found.map(Some).ok_or_else(|| CameraError::NoSuchCamera {
                name: name.clone(),
                known: scene.cameras.iter().map(|camera| camera.name.clone()).collect(),
            });
        }
        let is_elsewhere =
            self.is_placed() || self.azimuth_degrees.is_some() || self.elevation_degrees.is_some();
        Ok(if is_elsewhere { None } else { scene.cameras.first() })
    }

    fn lens_with(&self, of_file: Option<&SceneCamera>) -> Lens {
        let usual = Lens::Perspective { fov_y_radians: DEFAULT_FOV_DEGREES.to_radians() };
        self.lens.or(of_file.map(|camera| camera.lens)).unwrap_or(usual)
    }

    /// The clipping planes: those of the fields, else fitted to the scene's bounds.
    fn planes(
        &self,
        bounds: &Bounds,
        view_from_world: &DMat4,
        lens: Lens,
    ) -> Result<(f64, f64), CameraError> {
        let orthographic = matches!(lens, Lens::Orthographic { .. });
        if !orthographic && self.near.is_some_and(|near| near <= 0.0) {
            return Err(CameraError::NearPlane);
        }
        if !orthographic && self.far.is_some_and(|far| far <= 0.0) {
            return Err(CameraError::FarPlane);
        }
        if orthographic && self.far.is_some_and(f64::is_infinite) {
            return Err(CameraError::InfiniteFarPlane);
        }
        if let (Some(near), Some(far)) = (self.near, self.far)
            && near >= far
        {
            return Err(CameraError::PlanesOutOfOrder);
        }
        let (fitted_near, fitted_far) = fit_planes(bounds, view_from_world);
        Ok(match (self.near, self.far) {
            (Some(near), Some(far)) => (near, far),
            (Some(near), None) if near >= fitted_far => (near, near + near.abs().max(1.0)),
            (Some(near), None) => (near, fitted_far),
            (None, Some(far)) if far <= fitted_near && orthographic => {
                (far - far.abs().max(1.0), far)
            }
            (None, Some(far)) if far <= fitted_near => (far / 10_000.0, far),
            (None, Some(far)) => (fitted_near, far),
            (None, None) => (fitted_near, fitted_far),
        })
    }
}

fn middle(bounds: &Bounds) -> DVec3 {
    if bounds.is_empty() { DVec3::ZERO } else { bounds.centre() }
}
