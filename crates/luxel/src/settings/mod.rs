//! Settings of views as texts, by the names and with the values of the program's flags.

mod names;
mod view;

use crate::{CameraChoice, CameraError};
use luxel_formats::values::{self, Surroundings, nearest};
use luxel_lighting::EnvironmentMap;
use luxel_scene::{Lens, Size};
pub use names::SETTINGS;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::path::PathBuf;
use std::sync::Arc;

/// Settings of a view: what a line of flags, the address of a page or a form says.
///
/// A name is that of a flag of `luxel render`, without dashes in front; a value is its text. A setting that
/// stands alone on the line has the text `""`, as `("shadows", "")`. `light` may be there several times; of
/// other names the last one counts.
///
/// ```
/// use luxel::{Settings, scene::demos};
///
/// let scene = demos::demo("teapot").unwrap();
/// let settings = Settings::new([
///     ("size", "640x360"),
///     ("azimuth", "60"),
///     ("light", "point:pos=3,4,5:diffuse=1,.9,.8"),
///     ("shadows", ""),
/// ])?;
/// let view = settings.view(&scene)?;
/// assert_eq!((view.size.width, view.lights.len(), view.shadows), (640, 1, true));
///
/// let error = Settings::new([("azimut", "60")]).unwrap_err();
/// assert_eq!(error.to_string(), "`azimut`: there is no such setting; did you mean `azimuth`?");
/// # Ok::<(), luxel::SettingError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    values: BTreeMap<&'static str, String>,
    lights: Option<Vec<String>>,
    map: Option<GivenMap>,
}

/// A map for the setting `environment`, where that is a file: equal only to itself.
#[derive(Clone, Debug)]
struct GivenMap(Arc<EnvironmentMap>);

impl PartialEq for GivenMap {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for GivenMap {}

/// A setting that isn't possible.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{name}`: {reason}")]
pub struct SettingError {
    /// Its name, as it was given.
    pub name: String,
    /// What is wrong.
    pub reason: String,
}

impl SettingError {
    fn new(name: &str, reason: impl Display) -> Self {
        Self { name: name.to_owned(), reason: reason.to_string() }
    }
}

impl From<CameraError> for SettingError {
    fn from(error: CameraError) -> Self {
        let name = match error {
            CameraError::TargetWithoutEye => "target",
            CameraError::EyeAtTarget => "eye",
            CameraError::NoSuchCamera { .. } => "camera",
            CameraError::NearPlane | CameraError::PlanesOutOfOrder => "near",
            CameraError::FarPlane | CameraError::InfiniteFarPlane => "far",
        };
        Self::new(name, error)
    }
}

impl Settings {
    /// Settings of names and texts.
    ///
    /// # Errors
    /// [`SettingError`] for an unknown name.
    pub fn new<N: AsRef<str>, V: Into<String>>(
        settings: impl IntoIterator<Item = (N, V)>,
    ) -> Result<Self, SettingError> {
        let mut all = Self::default();
        for (name, value) in settings {
            all.set(name.as_ref(), value)?;
        }
        Ok(all)
    }

    /// Sets one; a light is added to those before it.
    ///
    /// # Errors
    /// [`SettingError`] for an unknown name.
    pub fn set(&mut self, name: &str, value: impl Into<String>) -> Result<(), SettingError> {
        let Some(known) = names::known(name) else {
            let near = nearest(name, names::all());
            let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
            return Err(SettingError::new(name, format!("there is no such setting{near}")));
        };
        if known == names::LIGHT {
            self.lights.get_or_insert_default().push(value.into());
        } else {
            self.values.insert(known, value.into());
        }
        Ok(())
    }

    /// Leaves the scene's own lights out: those that are set are all, also if none is.
    pub fn replace_lights(&mut self) {
        self.lights.get_or_insert_default();
    }

    /// The file of the setting `environment`, if that is one: for [`Settings::set_environment_map`].
    ///
    /// # Errors
    /// [`SettingError`] for a value that isn't possible.
    pub fn environment_file(&self) -> Result<Option<PathBuf>, SettingError> {
        Ok(match self.parsed("environment", values::surroundings)? {
            Some(Surroundings::File(path)) => Some(path),
            _ => None,
        })
    }

    /// Gives the map that the file of the setting `environment` holds. Views open no files.
    pub fn set_environment_map(&mut self, map: Arc<EnvironmentMap>) {
        self.map = Some(GivenMap(map));
    }

    /// The text of a setting that is there.
    fn text(&self, name: &str) -> Option<&str> {
        debug_assert!(names::known(name).is_some(), "{name}");
        self.values.get(name).map(String::as_str)
    }

    /// The value of a setting that is there.
    fn parsed<T, E: Display>(
        &self,
        name: &'static str,
        parse: impl FnOnce(&str) -> Result<T, E>,
    ) -> Result<Option<T>, SettingError> {
        let parsed = self.text(name).map(parse).transpose();
        parsed.map_err(|message| SettingError::new(name, message))
    }

    /// Whether a switch is on: `""` and `true` turn it on, `false` off.
    fn switch(&self, name: &'static str) -> Result<bool, SettingError> {
        let on = self.parsed(name, |text| match text {
            "" | "true" => Ok(true),
            "false" => Ok(false),
            _ => Err("use true or false"),
        })?;
        Ok(on.unwrap_or(false))
    }

    /// One of several values by its name.
    fn choice<T: Copy + Default>(
        &self,
        name: &'static str,
        all: &[T],
        name_of: impl Fn(T) -> &'static str,
    ) -> Result<T, SettingError> {
        let found = self.parsed(name, |text| {
            let found = all.iter().copied().find(|one| name_of(*one) == text);
            found.ok_or_else(|| {
                let names: Vec<_> = all.iter().map(|one| name_of(*one)).collect();
                format!("use {}", names.join(", "))
            })
        })?;
        Ok(found.unwrap_or_default())
    }

    /// The picture's size; 1280x720 if none is given.
    ///
    /// # Errors
    /// [`SettingError`] for anything but sides from 1 to 16384.
    pub fn size(&self) -> Result<Size, SettingError> {
        let size = self.parsed("size", values::size)?;
        Ok(size.unwrap_or(Size { width: 1280, height: 720 }))
    }

    /// What decides the camera.
    ///
    /// # Errors
    /// [`SettingError`] for a value that isn't possible.
    pub fn camera(&self) -> Result<CameraChoice, SettingError> {
        let fov = self.parsed("fov", values::fov)?;
        let fov = fov.map(|degrees| Lens::Perspective { fov_y_radians: degrees.to_radians() });
        let ortho = self.parsed("ortho", values::positive)?;
        let ortho = ortho.map(|height| Lens::Orthographic { height });
        let intrinsics = self.parsed("intrinsics", values::intrinsics)?;
        let intrinsics = intrinsics.map(|[fx, fy, cx, cy]| Lens::Intrinsics { fx, fy, cx, cy });
        let elevation = |text: &str| match values::finite(text) {
            Ok(degrees) if degrees.abs() > 90.0 => {
                Err("it must be between -90 and 90 degrees".to_owned())
            }
            degrees => degrees,
        };
        Ok(CameraChoice {
            eye: self.parsed("eye", values::point)?,
            target: self.parsed("target", values::point)?,
            up: self.parsed("up", values::up)?,
            view_from_world: self.parsed("view-matrix", values::view_matrix)?,
            camera: self.text("camera").map(str::to_owned),
            azimuth_degrees: self.parsed("azimuth", values::finite)?,
            elevation_degrees: self.parsed("elevation", elevation)?,
            lens: intrinsics.or(ortho).or(fov),
            near: self.parsed("near", values::finite)?,
            far: self.parsed("far", values::far_plane)?,
        })
    }
}
