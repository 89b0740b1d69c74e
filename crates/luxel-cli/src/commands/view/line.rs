//! The line of `luxel render` that draws what a window shows.

use super::saved::{dark, shading_flags};
use crate::cli::Cli;
use clap::CommandFactory;
use clap::parser::ValueSource;
use luxel::formats::values::{degrees, light_text};
use luxel::lighting::Environment;
use luxel::render::EnvironmentChoice;
use luxel::scene::{Camera, Lens};
use luxel_viewer::ShownView;
use std::ffi::{OsStr, OsString};
use std::path::Path;

/// Flags for which the window has values of its own.
const OF_THE_WINDOW: [&str; 18] = [
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
];
/// Flags that are the window's where its light is not the file's.
const OF_LIGHT: [&str; 3] = ["light", "ambient", "light-scale"];

/// The line that draws what is seen of a file as `luxel view` with these words shows it: its flags, but
/// for camera, size, samples, edges and shading, and for light as far as that was changed.
pub(super) fn line(words: &[OsString], file: &OsStr, seen: &ShownView<'_>) -> String {
    let view = seen.view;
    let mut line = vec!["luxel".to_owned(), "render".to_owned(), quoted(&file.to_string_lossy())];
    let is_of_window = |flag: &str| {
        OF_THE_WINDOW.contains(&flag)
            || (seen.lights.is_some() && OF_LIGHT.contains(&flag))
            || (seen.is_environment_changed && flag == "environment")
    };
    line.extend(given(words, &is_of_window).iter().map(|word| quoted(word)));
    line.extend(light(seen));
    line.push(format!("--size={}x{}", view.size.width, view.size.height));
    line.push(format!("--samples={}", view.samples));
    match view.edges {
        None => {}
        Some(edges) => line.push(if edges.wireframe { "--wireframe" } else { "--edges" }.into()),
    }
    // A scene file may say otherwise than the program does by default.
    let is_scene = Path::new(file).extension().is_some_and(|end| end.eq_ignore_ascii_case("toml"));
    let shaded = shading_flags(view, is_scene).into_iter();
    line.extend(shaded.map(|(name, value)| format!("--{name}={value}")));
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

/// The flags of light, as far as it was changed.
fn light(seen: &ShownView<'_>) -> Vec<String> {
    let mut flags = Vec::new();
    if let Some(lights) = &seen.lights {
        // Without any, the file's would count.
        let none = if lights.is_empty() { vec![dark()] } else { Vec::new() };
        let texts = lights.iter().chain(&none).filter_map(light_text);
        flags.extend(texts.map(|text| quoted(&format!("--light={text}"))));
        let [r, g, b] = seen.view.ambient;
        flags.push(format!("--ambient={r},{g},{b}"));
    }
    if seen.is_environment_changed {
        let what = match seen.view.environment {
            EnvironmentChoice::StudioForMicrofacets => "microfacet".to_owned(),
            EnvironmentChoice::Always(Environment::None) => "none".to_owned(),
            EnvironmentChoice::Always(Environment::Studio { .. }) => "studio".to_owned(),
            EnvironmentChoice::Always(Environment::Constant([r, g, b])) => format!("{r},{g},{b}"),
        };
        flags.push(format!("--environment={what}"));
    }
    flags
}

/// The flags among the words that `render` takes too, but for those of the window.
fn given(words: &[OsString], is_of_window: &impl Fn(&str) -> bool) -> Vec<String> {
    let program = Cli::command();
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

/// A word as shells read it.
fn quoted(word: &str) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "-_=./:,+@%".contains(letter);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Command;
    use clap::Parser;
    use luxel::render::{Edges, ShadingMode};
    use luxel::scene::{DMat4, DVec3, Projection, Size, demos};

    #[test]
    fn the_line_draws_the_view_with_the_flags_that_are_the_picture_s() {
        let scene = demos::demo("plane").unwrap();
        let size = Size { width: 641, height: 333 };
        let mut view = luxel::default_view(&scene, size);
        let turned =
            DMat4::from_rotation_y(0.1) * DMat4::from_translation(DVec3::new(0.1, 2.0, -9.0));
        view.camera.view_from_world = turned;
        let lens = Lens::Perspective { fov_y_radians: 0.7 };
        view.camera.projection = Projection { lens, ..view.camera.projection };
        view.edges = Some(Edges::WIREFRAME);
        view.samples = 8;
        let words = "luxel view a.glb b.glb --mode flying --eye 1,2,3 --ks 0.5 --light \
                     directional:dir=0,-1,0 --light ambient:color=.1,.1,.1 --size 9x9";
        let words = words.split_whitespace();
        let words: Vec<OsString> = words.map(OsString::from).collect();
        let as_read = ShownView { view: &view, lights: None, is_environment_changed: false };
        let line = line(&words, OsStr::new("it's b.glb"), &as_read);
        assert!(line.starts_with("luxel render 'it'\\''s b.glb' "), "{line}");
        assert!(line.contains(" --wireframe ") && line.contains(" --ks=0.5"), "{line}");
        assert_eq!(line.matches("--light=").count(), 2, "{line}");
        for gone in ["--mode", "--eye", "9x9"] {
            assert!(!line.contains(gone), "{line}");
        }
        let words = line.replace("'it'\\''s b.glb'", "b.glb");
        let words = words.split(' ').chain(["-o", "b.png"]);
        let Command::Render(render) = Cli::parse_from(words).command else { panic!("{line}") };
        let read = render.frame();
        assert_eq!((read.size, read.samples, read.view_matrix), (size, 8, Some(turned)));
        assert_eq!(read.fov.map(f64::to_radians), Some(0.7));
    }

    #[test]
    fn light_and_shading_that_were_changed_take_the_place_of_those_of_the_line() {
        let scene = demos::demo("plane").unwrap();
        let mut view = luxel::default_view(&scene, Size { width: 64, height: 48 });
        view.shading.mode = ShadingMode::Subdivided { tolerance: 2.5 };
        view.environment = EnvironmentChoice::Always(Environment::Constant([0.1, 0.2, 0.3]));
        let words = "luxel view --light point:pos=0,0,0 --ambient 1,1,1 --environment studio \
                     --shading flat --light-scale 3";
        let words: Vec<OsString> = words.split_whitespace().map(OsString::from).collect();
        let draw = |seen: &ShownView<'_>| line(&words, OsStr::new("demo:plane"), seen);
        let lights = Some(view.lights.clone());
        let lit = draw(&ShownView { view: &view, lights, is_environment_changed: true });
        let gone = ["pos=0,0,0", "=1,1,1", "studio", "flat", "scale"];
        assert!(gone.iter().all(|gone| !lit.contains(gone)), "{lit}");
        assert_eq!(lit.matches("--light=").count(), view.lights.len(), "{lit}");
        assert!(lit.contains(" --shading=subdivided --tolerance=2.5 "), "{lit}");
        assert!(lit.contains(" --environment=0.1,0.2,0.3 "), "{lit}");
        let words = lit.split(' ').chain(["-o", "b.png"]);
        assert!(Cli::try_parse_from(words).is_ok(), "{lit}");
        let dark =
            draw(&ShownView { view: &view, lights: Some(vec![]), is_environment_changed: false });
        assert!(dark.contains("--light=ambient:color=0,0,0"), "{dark}");
        // A scene file's own shading gives way, too.
        view.shading.mode = ShadingMode::Phong;
        let seen = ShownView { view: &view, lights: None, is_environment_changed: false };
        assert!(line(&[], OsStr::new("a.toml"), &seen).contains(" --shading=phong "));
        assert!(!draw(&seen).contains("phong") && draw(&seen).contains("point:pos=0,0,0"));
    }
}
