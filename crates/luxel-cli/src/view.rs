//! Builds the renderer's view and execution options from flags.

use crate::console::Console;
use crate::failure::Failure;
use crate::flag_words::warning_text;
use crate::options::{EncodingChoice, ExecutionOptions, LightOptions, ViewOptions};
use crate::values::Exposure;
use luxel::formats::{Limits, LoadedEnvironment, open_environment};
use luxel::lighting::{Environment, EnvironmentMap, PictureEncoding};
use luxel::render::{
    AutoExposure, Edges, EnvironmentChoice, Execution, Layer, View, auto_exposure,
};
use luxel::scene::{Camera, Scene, SceneLight, Viewpoint};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant, SystemTime};

/// The view of a scene; without an exposure, if that is left to the scene's light: see [`expose`].
///
/// # Errors
/// [`Failure::Usage`] if two lights share a name, or shading flags conflict.
pub(crate) fn view(
    options: &ViewOptions,
    edges: Option<Edges>,
    camera: Camera,
    scene: &Scene,
) -> Result<View, Failure> {
    let ViewOptions { frame, light, mode, picture, .. } = options;
    let (mut lights, mut ambient) = lights(light, scene)?;
    if let Some(scale) = light.light_scale {
        lights.iter_mut().for_each(|light| light.light.scale(scale));
        ambient = ambient.map(|channel| channel * scale);
    }
    Ok(View::new(frame.size, camera)
        .with_samples(frame.samples)
        .with_cull(frame.cull.into())
        .with_lights(lights)
        .with_ambient(ambient)
        .with_environment(environment(options, scene)?)
        .with_environment_background(light.environment_background)
        .with_fog(light.fog.or(scene.fog))
        .with_background(picture.background.or(scene.background).unwrap_or_default())
        .with_exposure(match picture.exposure {
            Some(Exposure::Ev(ev)) => ev,
            Some(Exposure::Auto) | None => 0.0,
        })
        .with_tone(picture.tone)
        .with_encoding(match picture.encoding {
            EncodingChoice::Srgb => PictureEncoding::Srgb,
            EncodingChoice::None => PictureEncoding::None,
        })
        .with_edges(edges)
        .with_shadows(light.shadows)
        .with_ground(light.ground)
        .with_up(frame.up)
        .with_light_rays(light.light_rays)
        .with_ambient_occlusion(light.ambient_occlusion())
        .with_shading(mode.shading()?))
}

/// The next view of several, exposed as the first one: `exposure` keeps it. Also what to say of the first
/// one's exposure.
///
/// # Errors
/// As [`view`].
pub(crate) fn next_view(
    options: &ViewOptions,
    edges: Option<Edges>,
    camera: Camera,
    scene: &Scene,
    exposure: &mut Option<f32>,
) -> Result<(View, Option<String>), Failure> {
    let mut view = view(options, edges, camera, scene)?;
    let said = match exposure {
        Some(first) => {
            view.exposure = *first;
            None
        }
        None => expose(&mut view, options, scene),
    };
    *exposure = Some(view.exposure);
    Ok((view, said))
}

/// What to say of flags that change nothing in a view, since it has no such environment.
pub(crate) fn idle_flags(view: &View, options: &LightOptions) -> Vec<String> {
    let is_none = matches!(view.environment, EnvironmentChoice::Always(Environment::None));
    let background = (options.environment_background && is_none).then_some(
        "--environment-background shows nothing: there is no environment; give one with --environment",
    );
    let is_map = view.environment.map().is_some();
    let rotation = (options.environment_rotation.is_some() && !is_map).then_some(
        "--environment-rotation turns nothing: only an environment from a file turns; give one with \
         --environment",
    );
    background.into_iter().chain(rotation).map(str::to_owned).collect()
}

/// What to say of layers that are 1 everywhere, since the view doesn't ask for what they show.
pub(crate) fn idle_layers(view: &View, layers: &[Layer]) -> Vec<String> {
    // A light that isn't there is an error.
    let has_light = |name: &String| view.lights.iter().any(|light| light.name == *name);
    let flag = |layer: &Layer| match layer {
        Layer::Openness if view.ambient_occlusion.is_none() => Some("--ao"),
        Layer::Shadow(name) if !view.shadows && has_light(name) => Some("--shadows"),
        _ => None,
    };
    let idle = |layer: &Layer| {
        flag(layer).map(|flag| {
            format!("the layer {} is 1 everywhere: it shows what {flag} computes", layer.name())
        })
    };
    layers.iter().filter_map(idle).collect()
}

/// Exposes a view for the scene's own light, if the flags ask for it; what to say, if that does something.
pub(crate) fn expose(view: &mut View, options: &ViewOptions, scene: &Scene) -> Option<String> {
    if options.picture.exposure != Some(Exposure::Auto) {
        return None;
    }
    let AutoExposure { ev, light } = auto_exposure(scene, view);
    view.exposure = ev;
    let light = luxel::report::number(light);
    (ev != 0.0).then(|| {
        format!(
            "exposure {ev}: the light on the model is {light} times what makes white surfaces white"
        )
    })
}

/// The lights and the scene's ambient light: from the command line, else the file, else the default
/// ones. Ambient light alone replaces no other light.
fn lights(options: &LightOptions, scene: &Scene) -> Result<(Vec<SceneLight>, [f32; 3]), Failure> {
    let ambient = options.ambient.or(scene.ambient);
    if !options.lights.is_empty() {
        let named = options.lights.iter().enumerate();
        let lights: Vec<_> = named.map(|(place, light)| light.clone().named(place)).collect();
        for (place, light) in lights.iter().enumerate() {
            if lights[..place].iter().any(|other| other.name == light.name) {
                let message = format!("two lights have the name `{}`: rename one", light.name);
                return Err(Failure::Usage(message));
            }
        }
        return Ok((lights, ambient.unwrap_or_default()));
    }
    let (lights, default_ambient) = luxel::lights_of(scene);
    Ok((lights, ambient.unwrap_or(default_ambient)))
}

/// The environment: from the command line, else the file, else the default one.
fn environment(options: &ViewOptions, scene: &Scene) -> Result<EnvironmentChoice, Failure> {
    let ViewOptions { frame, light, execution, .. } = options;
    let rotation = light.environment_rotation;
    let up = frame.up.unwrap_or(scene.up);
    let choice = match (&light.environment, frame.up) {
        (None, None) => luxel::environment_of(scene),
        (None, Some(up)) => luxel::environment_of(scene).in_frame(Viewpoint::frame(up)),
        (Some(surroundings), _) => match surroundings.environment(up) {
            Ok(choice) => choice,
            Err(path) => {
                let map = opened_environment(path, execution.max_memory)?;
                EnvironmentChoice::of_map(map, Viewpoint::frame(up), 0.0)
            }
        },
    };
    Ok(match (choice.map(), rotation) {
        (Some(map), Some(degrees)) => {
            EnvironmentChoice::Always(Environment::Map(map.turned(degrees)))
        }
        _ => choice,
    })
}

/// The environment of `--environment FILE`, kept for further views and models.
fn opened_environment(path: &Path, max_memory: u64) -> Result<Arc<EnvironmentMap>, Failure> {
    /// A file and when it was changed.
    type Version = (PathBuf, Option<SystemTime>);
    static OPENED: Mutex<Option<(Version, Arc<EnvironmentMap>)>> = Mutex::new(None);
    let changed = std::fs::metadata(path).and_then(|metadata| metadata.modified()).ok();
    let version = (path.to_owned(), changed);
    let mut opened = OPENED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, map)) = opened.as_ref().filter(|(known, _)| *known == version) {
        return Ok(Arc::clone(map));
    }
    let limits = Limits { max_memory, ..Limits::default() };
    let LoadedEnvironment { map, warnings } = open_environment(path, &limits)?;
    let console = Console::current();
    for warning in &warnings {
        console.warn(&format!("{}: {}", path.display(), warning_text(warning)));
    }
    let map = Arc::new(map);
    *opened = Some((version, Arc::clone(&map)));
    Ok(map)
}

/// The execution options.
pub(crate) fn execution(options: &ExecutionOptions) -> Execution {
    Execution {
        threads: options.threads.unwrap_or(0),
        simd: options.simd,
        clock,
        one_frame: false,
        max_memory: options.max_memory,
    }
}

fn clock() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed()
}
