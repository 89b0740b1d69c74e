//! From flags to what the renderer takes: what to draw, and how.

use crate::failure::Failure;
use crate::options::{
    CullChoice, EncodingChoice, ExecutionOptions, FrameOptions, LightOptions, PictureOptions,
};
use crate::values::Surroundings;
use luxel::lighting::{Environment, Fog, FogLaw, PictureEncoding};
use luxel::render::{Cull, Edges, EnvironmentChoice, Execution, View};
use luxel::scene::{Camera, Scene, SceneLight};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// What a picture of the scene shows.
///
/// # Errors
/// [`Failure::Usage`], if two lights have one name.
pub(crate) fn view(
    frame: &FrameOptions,
    light: &LightOptions,
    picture: &PictureOptions,
    edges: Option<Edges>,
    camera: Camera,
    scene: &Scene,
) -> Result<View, Failure> {
    let (lights, ambient) = lights(light, scene)?;
    Ok(View {
        size: frame.size,
        camera,
        samples: frame.samples,
        cull: match frame.cull {
            CullChoice::Auto => Cull::Auto,
            CullChoice::None => Cull::None,
            CullChoice::Back => Cull::Back,
        },
        lights,
        ambient,
        environment: environment(light, scene),
        fog: light.fog.map(|fog| Fog {
            color: fog.color,
            law: FogLaw::DepthCue {
                near: fog.near as f32,
                far: fog.far as f32,
                front: fog.front,
                back: fog.back,
            },
        }),
        background: picture.background.unwrap_or_default(),
        encoding: match picture.encoding {
            EncodingChoice::Srgb => PictureEncoding::Srgb,
            EncodingChoice::None => PictureEncoding::None,
        },
        edges,
    })
}

/// The lights and the scene's ambient light: those of the line, else of the file, else the default
/// ones. `--ambient` alone takes no light away.
fn lights(options: &LightOptions, scene: &Scene) -> Result<(Vec<SceneLight>, [f32; 3]), Failure> {
    let ambient = options.ambient;
    if !options.lights.is_empty() {
        let named = options.lights.iter().enumerate();
        let lights: Vec<_> = named.map(|(place, light)| light.clone().named(place)).collect();
        for (place, light) in lights.iter().enumerate() {
            if lights[..place].iter().any(|other| other.name == light.name) {
                let message = format!("two lights are called `{}`: rename one", light.name);
                return Err(Failure::Usage(message));
            }
        }
        return Ok((lights, ambient.unwrap_or_default()));
    }
    let (lights, default_ambient) = luxel::lights_of(scene);
    Ok((lights, ambient.unwrap_or(default_ambient)))
}

fn environment(options: &LightOptions, scene: &Scene) -> EnvironmentChoice {
    let up = scene.up.as_vec3().to_array();
    match options.environment {
        None => luxel::environment_of(scene),
        Some(Surroundings::None) => EnvironmentChoice::Always(Environment::None),
        Some(Surroundings::Studio) => EnvironmentChoice::Always(Environment::Studio { up }),
        Some(Surroundings::Constant(color)) => {
            EnvironmentChoice::Always(Environment::Constant(color))
        }
    }
}

/// How the work is done.
pub(crate) fn execution(options: &ExecutionOptions) -> Execution {
    Execution { threads: options.threads.unwrap_or(0), simd: options.simd, clock }
}

fn clock() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed()
}
