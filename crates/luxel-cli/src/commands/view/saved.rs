//! The window's view as a scene file, which `luxel render` draws with the same bytes.

use crate::options::{NormalsChoice, ShadingOptions};
use clap::ValueEnum;
use luxel::formats::{SceneModels, SceneText, SettingValue, SurfaceChange};
use luxel::lighting::{Light, PictureEncoding, Tone};
use luxel::render::{Cull, Shading, ShadingMode, View};
use luxel::scene::{DVec3, Placement, Restyle, SceneCamera, SceneLight};
use luxel::view::{AmbientOcclusion, DEFAULT_LIGHT_RAYS};
use luxel_viewer::ShownScene;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// The path and text of a scene file for the window's view of a file.
pub(super) fn saved(
    file: &OsStr,
    shown: &ShownScene<'_>,
    restyle: Restyle,
    shading: &ShadingOptions,
) -> Result<(PathBuf, String), String> {
    let name = file.to_str().ok_or("the file name is not valid UTF-8, which scene files need")?;
    if name == "-" {
        return Err("a model from the standard input has no file name to save under".to_owned());
    }
    let path = Path::new(name);
    let is_scene = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("toml"));
    let bytes;
    // Paths in the scene file begin with the model's node.
    let (models, root, stem) = if let Some(demo) = name.strip_prefix("demo:") {
        (SceneModels::One(name), vec![demo.to_owned()], PathBuf::from(demo))
    } else {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let beside = path.with_file_name(&stem);
        if is_scene {
            bytes = std::fs::read(path).map_err(|error| format!("{name}: {error}"))?;
            (SceneModels::AsIn(&bytes), Vec::new(), beside)
        } else {
            let last = path.file_name().and_then(OsStr::to_str).unwrap_or(name);
            (SceneModels::One(last), vec![stem], beside)
        }
    };
    // The scene file will be in the model's folder.
    let environment_file = shown.view.environment.map().map(|map| {
        let name = Path::new(map.map().name());
        let below = path.parent().and_then(|folder| name.strip_prefix(folder).ok());
        below.unwrap_or(name).to_string_lossy().into_owned()
    });
    let text = SceneText {
        environment_file: environment_file.as_deref(),
        ..text(models, &root, shown, restyle, shading)
    };
    let text = text.write();
    let text = text.map_err(|error| format!("{name}{}: {}", error.place, error.kind))?;
    let numbered = (1_u32..).map(|number| {
        let mut numbered = stem.clone().into_os_string();
        numbered.push(format!("-{number}.toml"));
        PathBuf::from(numbered)
    });
    let free = numbered.into_iter().find(|path| !path.exists());
    Ok((free.ok_or("all names for the scene file are taken")?, text))
}

fn text<'a>(
    models: SceneModels<'a>,
    root: &[String],
    shown: &ShownScene<'_>,
    restyle: Restyle,
    shading: &ShadingOptions,
) -> SceneText<'a> {
    let ShownScene { scene, view, planes, .. } = shown;
    let below = |path: Vec<String>| root.iter().cloned().chain(path).collect::<Vec<_>>();
    let own = shown
        .changes
        .iter()
        .cloned()
        .map(|change| SurfaceChange { object: change.object.map(below), ..change });
    // Changes to all surfaces by flags come first.
    let is_any = restyle != Restyle::default();
    let of_flags = is_any.then_some(SurfaceChange { object: None, surface: None, restyle });
    let node_of = |light: &SceneLight| match light.placement {
        Placement::Node(node) => below(scene.path(node).into_iter().map(str::to_owned).collect()),
        Placement::World | Placement::Camera => Vec::new(),
    };
    let mut lights: Vec<_> =
        view.lights.iter().map(|light| (light.clone(), node_of(light))).collect();
    if lights.is_empty() {
        // Without a light, the model's would apply.
        lights.push((dark(), Vec::new()));
    }
    let camera = SceneCamera {
        name: "window".to_owned(),
        node: None,
        view_from_node: view.camera.view_from_world,
        lens: view.camera.projection.lens,
        planes: None,
    };
    SceneText {
        models,
        changes: of_flags.into_iter().chain(own).collect(),
        up: view.up.unwrap_or(scene.up),
        ambient: view.ambient,
        environment: Some(view.environment.clone()),
        environment_file: None,
        background: view.background,
        fog: view.fog,
        lights,
        cameras: vec![camera],
        settings: settings(view, *planes, shading),
    }
}

/// A light without effect.
pub(super) fn dark() -> SceneLight {
    SceneLight {
        name: "none".to_owned(),
        light: Light::ambient([0.0; 3]),
        placement: Placement::World,
        position: DVec3::ZERO,
        direction: DVec3::NEG_Z,
    }
}

/// The flags of shading and interpolation: those that differ
/// from the defaults, or all.
pub(super) fn shading_flags(view: &View, is_all: bool) -> Vec<(&'static str, String)> {
    let Shading { mode, interpolation, clamp, normal_length } = view.shading;
    let by_default = Shading::default();
    let mut flags = Vec::new();
    let mut flag = |is_given: bool, name, value: &str| {
        if is_given || is_all {
            flags.push((name, value.to_owned()));
        }
    };
    flag(mode != by_default.mode, "shading", mode.name());
    flag(interpolation != by_default.interpolation, "interpolation", interpolation.name());
    flag(clamp != by_default.clamp, "clamp", clamp.name());
    flag(normal_length != by_default.normal_length, "normal-length", normal_length.name());
    if let ShadingMode::Subdivided { tolerance } = mode {
        flags.push(("tolerance", tolerance.to_string()));
    }
    flags
}

/// The flags of shadows, openness and the ground, with their values.
pub(super) fn occlusion_flags(view: &View) -> Vec<(&'static str, Option<String>)> {
    let mut flags = Vec::new();
    if view.shadows {
        flags.push(("shadows", None));
    }
    if view.ground {
        flags.push(("ground", None));
    }
    if view.light_rays != DEFAULT_LIGHT_RAYS {
        flags.push(("light-rays", Some(view.light_rays.to_string())));
    }
    if let Some(AmbientOcclusion { radius, rays }) = view.ambient_occlusion {
        let radius = radius.map_or_else(|| "auto".to_owned(), |radius| radius.to_string());
        flags.extend([("ao", Some(radius)), ("ao-rays", Some(rays.to_string()))]);
    }
    flags
}

/// The flags of exposure and tone curve: those that differ from the defaults, or all.
pub(super) fn display_flags(view: &View, is_all: bool) -> Vec<(&'static str, String)> {
    let display = view.display();
    let mut flags = Vec::new();
    if is_all || display.ev() != 0.0 {
        flags.push(("exposure", display.ev().to_string()));
    }
    if is_all || display.tone() != Tone::None {
        flags.push(("tone", display.tone().name().to_owned()));
    }
    flags
}

/// The flags of `luxel render` that differ from the defaults.
fn settings(
    view: &View,
    [near, far]: [Option<f64>; 2],
    shading: &ShadingOptions,
) -> Vec<(String, SettingValue)> {
    let one = |text: String| SettingValue::One(text);
    let word = |text: &str| SettingValue::One(text.to_owned());
    let mut settings = vec![
        ("size", one(format!("{}x{}", view.size.width, view.size.height))),
        ("samples", one(view.samples.to_string())),
    ];
    match view.cull {
        Cull::Auto => {}
        Cull::None => settings.push(("cull", word("none"))),
        Cull::Back => settings.push(("cull", word("back"))),
    }
    let shaded = shading_flags(view, false).into_iter();
    let displayed = display_flags(view, false).into_iter();
    settings.extend(shaded.chain(displayed).map(|(name, value)| (name, SettingValue::One(value))));
    if view.environment_background {
        settings.push(("environment-background", SettingValue::Switch(true)));
    }
    settings.extend(
        occlusion_flags(view).into_iter().map(|(name, value)| {
            (name, value.map_or(SettingValue::Switch(true), SettingValue::One))
        }),
    );
    if view.encoding == PictureEncoding::None {
        settings.push(("encoding", word("none")));
    }
    if let Some(edges) = view.edges {
        let name = if edges.wireframe { "wireframe" } else { "edges" };
        settings.push((name, SettingValue::Switch(true)));
    }
    for (name, plane) in [("near", near), ("far", far)] {
        if let Some(plane) = plane {
            let text = if plane.is_infinite() { "infinity".to_owned() } else { plane.to_string() };
            settings.push((name, one(text)));
        }
    }
    if shading.normals != NormalsChoice::File
        && let Some(choice) = shading.normals.to_possible_value()
    {
        settings.push(("normals", word(choice.get_name())));
    }
    if let Some(crease) = shading.crease {
        settings.push(("crease", one(crease.to_string())));
    }
    settings.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}
