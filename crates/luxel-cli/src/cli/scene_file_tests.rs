//! Scene files and the flags of the program.

use super::Cli;
use crate::scene_file::flags::{ELSEWHERE, ON_THE_LINE};
use crate::scene_file::{check, flags_for};
use clap::{Arg, Command, CommandFactory};
use luxel::formats::{Limits, Setting, scene_settings};

fn render() -> Command {
    let mut program = Cli::command();
    program.build();
    program.find_subcommand("render").unwrap().clone()
}

fn settings_of(text: &str) -> Vec<Setting> {
    let file = format!("format = \"luxel-scene\"\nversion = 1\n[render]\n{text}");
    scene_settings(file.as_bytes(), &Limits::default()).unwrap()
}

/// The arguments that a scene file adds to `luxel render` with these words.
#[track_caller]
fn added(file: &str, line: &str) -> Vec<String> {
    let command = render();
    let words = ["render", "-o", "x.png"].into_iter().chain(line.split_whitespace());
    let given = command.clone().try_get_matches_from(words).unwrap();
    let settings = settings_of(file);
    check(&settings, &command).unwrap();
    let flags = settings.iter().flat_map(|setting| flags_for(setting, &command, &given));
    flags.map(|flag| flag.into_string().unwrap()).collect()
}

#[track_caller]
fn refused(file: &str) -> String {
    check(&settings_of(file), &render()).unwrap_err().to_string()
}

#[test]
fn settings_are_flags() {
    assert_eq!(added("size = \"64x48\"\nfov = 30", ""), ["--size=64x48", "--fov=30"]);
    assert_eq!(added("eye = [1, -0.5, 1e-7]", ""), ["--eye=1,-0.5,1e-7"]);
    assert_eq!(added("wireframe = true\nedges = false", ""), ["--wireframe"]);
    assert_eq!(added("layer = [\"normal\", \"z\"]", ""), ["--layer=normal", "--layer=z"]);
    assert_eq!(added("far = inf", ""), ["--far=inf"]);
}

#[test]
fn the_command_line_overrides_the_file() {
    assert_eq!(added("fov = 30\nsamples = 8", "--fov 40"), ["--samples=8"]);
    assert_eq!(added("layer = \"z\"", "--layer depth"), [""; 0]);
}

#[test]
fn settings_that_conflict_with_the_command_line_are_dropped() {
    assert_eq!(added("ortho = 3", "--fov 40"), [""; 0]);
    assert_eq!(added("fov = 40", "--ortho 3"), [""; 0]);
    assert_eq!(added("eye = [1, 2, 3]\ntarget = [0, 0, 0]", "--azimuth 10"), [""; 0]);
    assert_eq!(added("azimuth = 10\nelevation = 5", "--eye 1,2,3"), [""; 0]);
    assert_eq!(added("wireframe = true", "--edges"), [""; 0]);
}

#[test]
fn invalid_settings_are_errors_with_line_and_column() {
    for (file, expected) in [
        ("fov = 200", ":4:7: fov: it must be between 0 and 180 degrees"),
        ("fovv = 20", ":4:1: `fovv` is unknown here: did you mean `fov`?"),
        ("samples = 4\nsize = [1, 2, 3]", ":5:8: size: use WIDTHxHEIGHT"),
        ("normals = \"flat\"", ":4:11: normals: use file, mean"),
        ("wireframe = 1", ":4:13: wireframe: use true or false"),
        ("fov = true", ":4:7: fov: expected a number or a string, found a boolean"),
        ("fov = 20\northo = 1", "exclude each other"),
        ("output = \"x.png\"", ":4:1: `output` is for the command line"),
        ("fog = \"near=1:far=2\"", ":4:1: `fog` is not a setting: write [fog]"),
        ("far = nan", "finite"),
    ] {
        let message = refused(file);
        assert!(message.contains(expected), "{file}: {message}");
    }
}

#[test]
fn the_tables_of_refused_settings_name_existing_flags() {
    let mut program = Cli::command();
    program.build();
    let render = program.find_subcommand("render").unwrap();
    let flags: Vec<_> = render.get_arguments().filter_map(Arg::get_long).collect();
    for name in ELSEWHERE.iter().map(|(name, _)| *name).chain(ON_THE_LINE) {
        // Commands have no version of their own.
        assert!(flags.contains(&name) || name == "version", "{name}");
    }
}
