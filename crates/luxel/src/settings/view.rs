//! The view, and the changes of the scene, that settings describe.

use super::{GivenMap, SettingError, Settings};
use crate::default_view::{environment_of, lights_of};
use luxel_formats::values::{self, Exposure, OcclusionRadius};
use luxel_lighting::{Environment, PictureEncoding, Tone};
use luxel_render::auto_exposure;
use luxel_scene::{
    Background, Camera, DEFAULT_CREASE_DEGREES, NormalOptions, NormalSource, Restyle, Scene,
    SceneLight, Size, Viewpoint,
};
use luxel_view::{
    AmbientOcclusion, Clamp, Cull, DEFAULT_LIGHT_RAYS, DEFAULT_SAMPLES, Edges, EnvironmentChoice,
    Interpolation, NormalLength, Shading, ShadingMode, View,
};
use std::sync::Arc;

impl Settings {
    /// The view of a scene. What isn't set is as `luxel render` has it.
    ///
    /// # Errors
    /// [`SettingError`] for a value that isn't possible, and for an environment that is a file.
    pub fn view(&self, scene: &Scene) -> Result<View, SettingError> {
        let size = self.size()?;
        let camera = self.camera()?.camera_of(scene, size)?;
        self.view_from(scene, camera, size)
    }

    /// The view of a scene from a camera, whatever the settings say of cameras and sizes.
    ///
    /// # Errors
    /// As [`Settings::view`].
    pub fn view_from(
        &self,
        scene: &Scene,
        camera: Camera,
        size: Size,
    ) -> Result<View, SettingError> {
        let (mut lights, mut ambient) = self.lights(scene)?;
        if let Some(scale) = self.parsed("light-scale", values::non_negative_f32)? {
            lights.iter_mut().for_each(|light| light.light.scale(scale));
            ambient = ambient.map(|channel| channel * scale);
        }
        let background: Option<Background> = self.parsed("background", values::background)?;
        let encoding = self.parsed("encoding", |text| match text {
            "srgb" => Ok(PictureEncoding::Srgb),
            "none" => Ok(PictureEncoding::None),
            _ => Err("use srgb or none"),
        })?;
        let mut view = View::new(size, camera)
            .with_samples(self.parsed("samples", values::samples)?.unwrap_or(DEFAULT_SAMPLES))
            .with_cull(self.choice("cull", &[Cull::Auto, Cull::None, Cull::Back], cull_name)?)
            .with_lights(lights)
            .with_ambient(ambient)
            .with_environment(self.environment(scene)?)
            .with_environment_background(self.switch("environment-background")?)
            .with_fog(self.parsed("fog", values::fog)?.or(scene.fog))
            .with_background(background.or(scene.background).unwrap_or_default())
            .with_tone(self.choice("tone", &Tone::ALL, Tone::name)?)
            .with_encoding(encoding.unwrap_or_default())
            .with_shadows(self.switch("shadows")?)
            .with_ground(self.switch("ground")?)
            .with_up(self.parsed("up", values::up)?)
            .with_light_rays(self.parsed("light-rays", values::rays)?.unwrap_or(DEFAULT_LIGHT_RAYS))
            .with_ambient_occlusion(self.ambient_occlusion()?)
            .with_edges(self.edges()?)
            .with_shading(self.shading()?);
        match self.parsed("exposure", values::exposure)? {
            Some(Exposure::Ev(ev)) => view.exposure = ev,
            Some(Exposure::Auto) => view.exposure = auto_exposure(scene, &view).ev,
            None => {}
        }
        Ok(view)
    }

    /// Applies the settings of materials and normals, and computes what normals and tangents are missing.
    ///
    /// # Errors
    /// [`SettingError`] for a value that isn't possible.
    pub fn apply_to(&self, scene: &mut Scene) -> Result<(), SettingError> {
        let restyle = self.restyle()?;
        for material in &mut scene.materials {
            restyle.apply(material);
        }
        scene.compute_normals(&self.normals()?);
        scene.compute_tangents();
        Ok(())
    }

    /// The changes of all materials.
    ///
    /// # Errors
    /// [`SettingError`] for a value that isn't possible.
    pub fn restyle(&self) -> Result<Restyle, SettingError> {
        let mut restyle = Restyle {
            color: self.parsed("color", values::reflectance)?,
            emission: self.parsed("emission", values::reflectance)?,
            reflection: self.parsed("reflection", values::reflection)?,
            ..Restyle::default()
        };
        for parameter in luxel_lighting::parameters() {
            if let Some(value) =
                self.parsed(parameter.name, |text| values::parameter(parameter, text))?
            {
                restyle.set_parameter(parameter, value);
            }
        }
        Ok(restyle)
    }

    /// Where normals come from.
    ///
    /// # Errors
    /// [`SettingError`] for a value that isn't possible.
    pub fn normals(&self) -> Result<NormalOptions, SettingError> {
        let source = self.parsed("normals", |text| match text {
            "file" => Ok(NormalSource::File),
            "mean" => Ok(NormalSource::Mean),
            "area" => Ok(NormalSource::Area),
            "angle" => Ok(NormalSource::Angle),
            "area-angle" => Ok(NormalSource::AreaAngle),
            _ => Err("use file, mean, area, angle or area-angle"),
        })?;
        let crease = self.parsed("crease", |text| match values::finite(text)? {
            degrees if (0.0..=180.0).contains(&degrees) => Ok(degrees),
            _ => Err("it must be between 0 and 180 degrees".to_owned()),
        })?;
        Ok(NormalOptions {
            source: source.unwrap_or(NormalSource::File),
            crease_radians: crease.unwrap_or(DEFAULT_CREASE_DEGREES).to_radians(),
        })
    }

    fn edges(&self) -> Result<Option<Edges>, SettingError> {
        match (self.switch("wireframe")?, self.switch("edges")?) {
            (false, false) => Ok(None),
            (true, false) => Ok(Some(Edges::WIREFRAME)),
            (false, true) => Ok(Some(Edges::OVER_FACES)),
            (true, true) => Err(SettingError::new("edges", "it excludes `wireframe`")),
        }
    }

    fn ambient_occlusion(&self) -> Result<Option<AmbientOcclusion>, SettingError> {
        let rays = self.parsed("ao-rays", values::rays)?.unwrap_or(AmbientOcclusion::RAYS);
        let radius = self.parsed("ao", |text| match text {
            "false" => Ok(None),
            "" | "true" => Ok(Some(OcclusionRadius(None))),
            text => values::occlusion_radius(text).map(Some),
        })?;
        Ok(radius.flatten().map(|OcclusionRadius(radius)| AmbientOcclusion { radius, rays }))
    }

    fn shading(&self) -> Result<Shading, SettingError> {
        let mut mode = self.choice("shading", &ShadingMode::ALL, ShadingMode::name)?;
        if let Some(given) = self.parsed("tolerance", values::positive)? {
            let ShadingMode::Subdivided { tolerance } = &mut mode else {
                return Err(SettingError::new("tolerance", "it is for subdivided shading"));
            };
            *tolerance = given as f32;
        }
        Ok(Shading {
            mode,
            interpolation: self.choice(
                "interpolation",
                &Interpolation::ALL,
                Interpolation::name,
            )?,
            clamp: self.choice("clamp", &Clamp::ALL, Clamp::name)?,
            normal_length: self.choice("normal-length", &NormalLength::ALL, NormalLength::name)?,
        })
    }

    /// The lights and the scene's ambient light: given ones, else the file's, else the default ones.
    fn lights(&self, scene: &Scene) -> Result<(Vec<SceneLight>, [f32; 3]), SettingError> {
        let ambient = self.parsed("ambient", values::color)?.or(scene.ambient);
        let Some(given) = &self.lights else {
            let (lights, default_ambient) = lights_of(scene);
            return Ok((lights, ambient.unwrap_or(default_ambient)));
        };
        let mut lights: Vec<SceneLight> = Vec::new();
        for (place, text) in given.iter().enumerate() {
            let light = values::light(text)
                .map_err(|message| SettingError::new("light", format!("{text}: {message}")))?
                .named(place);
            if lights.iter().any(|other| other.name == light.name) {
                let message = format!("two lights have the name `{}`", light.name);
                return Err(SettingError::new("light", message));
            }
            lights.push(light);
        }
        Ok((lights, ambient.unwrap_or_default()))
    }

    /// The environment: a given one, else the file's, else the default one.
    fn environment(&self, scene: &Scene) -> Result<EnvironmentChoice, SettingError> {
        let up = self.parsed("up", values::up)?;
        let frame = up.unwrap_or(scene.up);
        let choice = match self.parsed("environment", values::surroundings)? {
            Some(surroundings) => match (surroundings.environment(frame), &self.map) {
                (Ok(choice), _) => choice,
                (Err(_), Some(GivenMap(map))) => {
                    EnvironmentChoice::of_map(Arc::clone(map), Viewpoint::frame(frame), 0.0)
                }
                (Err(path), None) => {
                    let message = format!("{} is a file: open it before", path.display());
                    return Err(SettingError::new("environment", message));
                }
            },
            None => match up {
                Some(up) => environment_of(scene).in_frame(Viewpoint::frame(up)),
                None => environment_of(scene),
            },
        };
        let rotation = self.parsed("environment-rotation", values::finite)?;
        Ok(match (choice.map(), rotation) {
            (Some(map), Some(degrees)) => {
                EnvironmentChoice::Always(Environment::Map(map.turned(degrees)))
            }
            _ => choice,
        })
    }
}

fn cull_name(cull: Cull) -> &'static str {
    match cull {
        Cull::Auto => "auto",
        Cull::None => "none",
        Cull::Back => "back",
    }
}
