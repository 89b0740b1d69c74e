//! The line of `luxel render` that draws what a window shows.

use crate::cli::Cli;
use clap::CommandFactory;
use clap::parser::ValueSource;
use luxel::formats::values::degrees;
use luxel::render::View;
use luxel::scene::{Camera, Lens};
use std::ffi::{OsStr, OsString};

/// Flags for which the window has values of its own.
const OF_THE_WINDOW: [&str; 13] = [
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
];

/// The line that draws a view of a file as `luxel view` with these words shows it: its flags, but for
/// camera, size, samples and edges, which are the view's.
pub(super) fn line(words: &[OsString], file: &OsStr, view: &View) -> String {
    let mut line = vec!["luxel".to_owned(), "render".to_owned(), quoted(&file.to_string_lossy())];
    line.extend(given(words).iter().map(|word| quoted(word)));
    line.push(format!("--size={}x{}", view.size.width, view.size.height));
    line.push(format!("--samples={}", view.samples));
    match view.edges {
        None => {}
        Some(edges) => line.push(if edges.wireframe { "--wireframe" } else { "--edges" }.into()),
    }
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

/// The flags among the words that `render` takes too.
fn given(words: &[OsString]) -> Vec<String> {
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
        if !is_known || !is_given || OF_THE_WINDOW.contains(&long) {
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
    use luxel::render::Edges;
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
        let line = line(&words, OsStr::new("it's b.glb"), &view);
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
}
