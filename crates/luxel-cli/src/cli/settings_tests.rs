//! The flags of `luxel render` and the settings of the library have the same names and meanings.

use super::{Cli, Command};
use crate::commands::render::PictureSettings;
use crate::scene_file::flags::ON_THE_LINE;
use crate::{camera, surface, view};
use clap::{Arg, CommandFactory, Parser};
use luxel::render::View;
use luxel::scene::{Scene, demos};
use luxel::{SETTINGS, Settings};
use std::collections::BTreeSet;

/// Flags of what is made of a picture, besides those of output and execution.
const NO_SETTINGS: [&str; 3] = ["bits", "layer", "turntable"];

#[test]
fn every_flag_that_describes_a_picture_is_a_setting() {
    let mut cli = Cli::command();
    cli.build();
    let render = cli.find_subcommand("render").unwrap();
    let flags: BTreeSet<&str> = render
        .get_arguments()
        .filter_map(Arg::get_long)
        .filter(|flag| !ON_THE_LINE.contains(flag) && !NO_SETTINGS.contains(flag))
        .collect();
    let parameters = luxel::lighting::parameters();
    let settings: BTreeSet<&str> =
        SETTINGS.into_iter().chain(parameters.map(|one| one.name)).collect();
    assert_eq!(settings, flags);
}

/// The view, and the scene with the line's surfaces.
fn of_line(line: PictureSettings, mut scene: Scene) -> (View, Scene) {
    let PictureSettings { view: options, edges, .. } = line;
    surface::apply_material(&options.material, &mut scene);
    surface::apply_normals(&options.shading, &mut scene);
    let camera = camera::choose(&options.frame, &scene).unwrap();
    let (view, _) = view::next_view(&options, edges, camera, &scene, &mut None).unwrap();
    (view, scene)
}

#[test]
fn settings_give_the_view_of_the_line() {
    let lines: [&[(&str, &str)]; 6] = [
        &[],
        &[("size", "320x200"), ("azimuth", "75"), ("elevation", "-10"), ("samples", "16")],
        &[
            ("eye", "3,4,9"),
            ("target", "0,1,0"),
            ("up", "Z"),
            ("fov", "30"),
            ("near", ".1"),
            ("far", "infinity"),
        ],
        &[
            ("light", "point:pos=3,4,5:attenuation=1,.1,0"),
            ("light", "spot:pos=3,4,5:dir=-1,-1,-1:cutoff=20"),
            ("ambient", ".1,.2,.3"),
            ("light-scale", "2"),
            ("shadows", ""),
            ("light-rays", "4"),
            ("ao", "infinity"),
            ("ao-rays", "8"),
            ("ground", ""),
        ],
        &[
            ("fog", "near=1:far=9:front=1:back=.5:color=white"),
            ("background", "tomato"),
            ("exposure", "auto"),
            ("tone", "agx"),
            ("encoding", "none"),
            ("environment", "studio"),
            ("environment-background", ""),
        ],
        &[
            ("ortho", "7"),
            ("cull", "back"),
            ("shading", "subdivided"),
            ("tolerance", "2"),
            ("clamp", "end"),
            ("interpolation", "screen"),
            ("wireframe", ""),
            ("color", "#336699"),
            ("reflection", "oren-nayar"),
            ("ks", "0.5"),
            ("normals", "area"),
            ("crease", "80"),
        ],
    ];
    for line in lines {
        let scene = demos::demo("teapot").unwrap();
        let words = line.iter().map(|(name, value)| match *value {
            "" => format!("--{name}"),
            value => format!("--{name}={value}"),
        });
        let words = ["luxel", "render", "demo:teapot", "-o", "x.png"]
            .map(str::to_owned)
            .into_iter()
            .chain(words);
        let Command::Render(render) = Cli::parse_from(words).command else { panic!("{line:?}") };
        let (expected, by_line) = of_line(render.into_settings(), scene.clone());
        let settings = Settings::new(line.iter().copied()).unwrap();
        let mut by_settings = scene;
        settings.apply_to(&mut by_settings).unwrap();
        assert_eq!(by_settings.materials, by_line.materials, "{line:?}");
        assert!(by_settings.meshes.iter().eq(by_line.meshes.iter()), "{line:?}");
        assert_eq!(settings.view(&by_settings).unwrap(), expected, "{line:?}");
    }
}
