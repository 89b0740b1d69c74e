//! The `luxel render` command line that reproduces the window's view.

use super::{Cli, Command};
use crate::commands::view::line::line;
use clap::{CommandFactory, Parser};
use luxel::lighting::Environment;
use luxel::render::{Edges, EnvironmentChoice, ShadingMode};
use luxel::scene::{DMat4, DVec3, Lens, Projection, Size, demos};
use luxel_viewer::ShownView;
use std::ffi::{OsStr, OsString};

#[test]
fn the_command_line_keeps_only_flags_that_affect_the_image() {
    let scene = demos::demo("plane").unwrap();
    let size = Size { width: 641, height: 333 };
    let mut view = luxel::default_view(&scene, size);
    let turned = DMat4::from_rotation_y(0.1) * DMat4::from_translation(DVec3::new(0.1, 2.0, -9.0));
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
    let line = line(&Cli::command(), &words, OsStr::new("it's b.glb"), &as_read);
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
fn edited_light_and_shading_replace_those_of_the_command_line() {
    let scene = demos::demo("plane").unwrap();
    let mut view = luxel::default_view(&scene, Size { width: 64, height: 48 });
    view.shading.mode = ShadingMode::Subdivided { tolerance: 2.5 };
    view.environment = EnvironmentChoice::Always(Environment::Constant([0.1, 0.2, 0.3]));
    let words = "luxel view --light point:pos=0,0,0 --ambient 1,1,1 --environment studio \
                 --shading flat --light-scale 3";
    let words: Vec<OsString> = words.split_whitespace().map(OsString::from).collect();
    let draw = |seen: &ShownView<'_>| line(&Cli::command(), &words, OsStr::new("demo:plane"), seen);
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
    // They replace a scene file's shading and exposure, too.
    view.shading.mode = ShadingMode::Phong;
    view.exposure = -11.1;
    let seen = ShownView { view: &view, lights: None, is_environment_changed: false };
    assert!(draw(&seen).contains(" --exposure=-11.1 ") && !draw(&seen).contains("--tone"));
    view.exposure = 0.0;
    let seen = ShownView { view: &view, lights: None, is_environment_changed: false };
    assert!(line(&Cli::command(), &[], OsStr::new("a.toml"), &seen).contains(" --shading=phong "));
    let of_scene = line(&Cli::command(), &[], OsStr::new("a.toml"), &seen);
    assert!(of_scene.contains(" --exposure=0 --tone=none "), "{of_scene}");
    assert!(!draw(&seen).contains("exposure"));
    assert!(!draw(&seen).contains("phong") && draw(&seen).contains("point:pos=0,0,0"));
}
