//! Starts navigation from flags, and reads logs.

use crate::camera;
use crate::failure::Failure;
use crate::model;
use crate::options::FrameOptions;
use luxel::navigation::{Log, Mode, Settings, State};
use luxel::scene::{Camera, Scene};
use std::ffi::OsStr;
use std::io::Read;
use std::path::Path;

/// The initial state of navigation: the camera of the flags, orbiting the target, else the
/// centre of the scene.
///
/// # Errors
/// As [`camera::choose`].
pub(crate) fn start(
    options: &FrameOptions,
    scene: &Scene,
    mode: Mode,
) -> Result<(State, Settings, Camera), Failure> {
    let camera = camera::choose(options, scene)?;
    let bounds = scene.bounds();
    let up = options.up.unwrap_or(scene.up);
    let settings = Settings::new(bounds, up, camera.projection.lens, options.size);
    let pivot = camera::pivot(options, scene);
    Ok((State::new(mode, &camera.view_from_world, pivot), settings, camera))
}

/// Reads a log; each entry with its line.
///
/// # Errors
/// [`Failure::Work`] with file and line, if it can't be read or isn't a log.
pub(crate) fn read_log(path: &OsStr, max_memory: u64) -> Result<(Log, Vec<usize>), Failure> {
    let (name, text) = if path == "-" {
        ("the standard input".into(), read_text(std::io::stdin().lock(), max_memory))
    } else {
        let file = model::open_regular(Path::new(path));
        (path.to_string_lossy(), file.and_then(|file| read_text(file, max_memory)))
    };
    let text = text.map_err(|error| {
        Failure::work(format!("{name}: {error}"), "docs/navigation.md describes the log format")
    })?;
    Log::with_lines(&text).map_err(|error| {
        let remedy = "correct the line; docs/navigation.md describes the log format";
        Failure::work(format!("{name}: {error}"), remedy)
    })
}

fn read_text(input: impl Read, most: u64) -> std::io::Result<String> {
    let mut text = String::new();
    let read = input.take(most.saturating_add(1)).read_to_string(&mut text)?;
    if read as u64 > most {
        return Err(std::io::Error::other(format!("more than {most} bytes; see --max-memory")));
    }
    Ok(text)
}
