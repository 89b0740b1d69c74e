//! The `luxel render` command line that reproduces the window's view.

use super::saved::{dark, display_flags, occlusion_flags, shading_flags};
use clap::Command;
use clap::parser::ValueSource;
use luxel::formats::values::{degrees, light_text};
use luxel::lighting::Environment;
use luxel::render::EnvironmentChoice;
use luxel::scene::{Camera, Lens};
use luxel_viewer::ShownView;
use std::ffi::{OsStr, OsString};
use std::path::Path;

/// Flags that the window overrides.
const OF_THE_WINDOW: [&str; 25] = [
    "size",
    "samples",
    "eye",
    "target",
    "up",
    "fov",
    "ortho",
    "view-matrix",
    "intrinsics",
    "camera",
    "azimuth",
    "elevation",
    "output",
    "shading",
    "tolerance",
    "interpolation",
    "clamp",
    "normal-length",
    "exposure",
    "tone",
    "shadows",
    "ground",
    "light-rays",
    "ao",
    "ao-rays",
];
/// Flags that the window overrides if its light differs from the file's.
const OF_LIGHT: [&str; 3] = ["light", "ambient", "light-scale"];

/// The command line that reproduces the view of a file in `luxel view` with these words: its flags,
/// except for camera, size, samples, edges and shading, and for edited light.
pub(crate) fn line(
    program: &Command,
    words: &[OsString],
    file: &OsStr,
    seen: &ShownView<'_>,
) -> String {
    let view = seen.view;
    let mut line = vec!["luxel".to_owned(), "render".to_owned(), quoted(&file.to_string_lossy())];
    let is_of_window = |flag: &str| {
        OF_THE_WINDOW.contains(&flag)
            || (seen.lights.is_some() && OF_LIGHT.contains(&flag))
            || (seen.is_environment_changed && flag.starts_with("environment"))
            || flag == "environment-background"
    };
    line.extend(given(program, words, &is_of_window).iter().map(|word| quoted(word)));
    line.extend(light(seen));
    line.push(format!("--size={}x{}", view.size.width, view.size.height));
    line.push(format!("--samples={}", view.samples));
    match view.edges {
        None => {}
        Some(edges) => line.push(if edges.wireframe { "--wireframe" } else { "--edges" }.into()),
    }
    // A scene file may override the defaults.
    let is_scene = Path::new(file).extension().is_some_and(|end| end.eq_ignore_ascii_case("toml"));
    let shaded = shading_flags(view, is_scene).into_iter();
    let displayed = display_flags(view, is_scene).into_iter();
    line.extend(shaded.chain(displayed).map(|(name, value)| format!("--{name}={value}")));
    line.extend(occlusion_flags(view).into_iter().map(|(name, value)| match value {
        Some(value) => format!("--{name}={value}"),
        None => format!("--{name}"),
    }));
    let Camera { view_from_world, projection } = &view.camera;
    line.push(match projection.lens {
        Lens::Perspective { fov_y_radians } => format!("--fov={}", degrees(fov_y_radians)),
        Lens::Orthographic { height } => format!("--ortho={height}"),
        Lens::Intrinsics { fx, fy, cx, cy } => format!("--intrinsics={fx},{fy},{cx},{cy}"),
    });
    let numbers = view_from_world.to_cols_array().map(|number| number.to_string());
    line.push(format!("--view-matrix={}", numbers.join(",")));
    line.join(" ")
}

/// The flags of edited light.
fn light(seen: &ShownView<'_>) -> Vec<String> {
    let mut flags = Vec::new();
    if let Some(lights) = &seen.lights {
        // Without a light, the file's would apply.
        let none = if lights.is_empty() { vec![dark()] } else { Vec::new() };
        let texts = lights.iter().chain(&none).filter_map(light_text);
        flags.extend(texts.map(|text| quoted(&format!("--light={text}"))));
        let [r, g, b] = seen.view.ambient;
        flags.push(format!("--ambient={r},{g},{b}"));
    }
    if seen.is_environment_changed {
        let environment = &seen.view.environment;
        if let Some(named) = environment.named() {
            flags.push(format!("--environment={}", named.name()));
        } else if let EnvironmentChoice::Always(Environment::Constant([r, g, b])) = environment {
            flags.push(format!("--environment={r},{g},{b}"));
        } else if let Some(map) = environment.map() {
            flags.push(quoted(&format!("--environment={}", map.map().name())));
            flags.push(format!("--environment-rotation={}", map.rotation_degrees()));
        }
    }
    if seen.view.environment_background {
        flags.push("--environment-background".to_owned());
    }
    flags
}

/// The flags among the words that `render` accepts, too, except for those of the window.
fn given(
    program: &Command,
    words: &[OsString],
    is_of_window: &impl Fn(&str) -> bool,
) -> Vec<String> {
    let matches = program.clone().try_get_matches_from(words).ok();
    let (Some(view), Some(render), Some(matches)) =
        (program.find_subcommand("view"), program.find_subcommand("render"), matches)
    else {
        return Vec::new();
    };
    let Some(("view", matches)) = matches.subcommand() else { return Vec::new() };
    let mut flags = Vec::new();
    for flag in view.get_arguments() {
        let (Some(long), id) = (flag.get_long(), flag.get_id().as_str()) else { continue };
        let is_known = render.get_arguments().any(|other| other.get_long() == Some(long));
        let is_given = matches.value_source(id) == Some(ValueSource::CommandLine);
        if !is_known || !is_given || is_of_window(long) {
            continue;
        }
        if !flag.get_action().takes_values() {
            flags.push(format!("--{long}"));
            continue;
        }
        let values = matches.get_raw(id).into_iter().flatten();
        flags.extend(values.map(|value| format!("--{long}={}", value.to_string_lossy())));
    }
    flags
}

/// Quotes a word for a shell.
fn quoted(word: &str) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "-_=./:,+@%".contains(letter);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}
