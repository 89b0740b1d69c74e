//! Scene files give the same bytes as flags.

use crate::program::{Folder, SQUARE_PLY};
use std::path::Path;

const HEADER: &str = "format = \"luxel-scene\"\nversion = 1\n";

/// Renders a scene file, and its model with flags, and compares the bytes.
#[track_caller]
fn assert_equal(scene: &str, flags: &str) {
    let folder = Folder::new();
    folder.write("square.ply", SQUARE_PLY);
    folder.write("scene.toml", format!("{HEADER}{scene}"));
    let draw = |line: &str| folder.run(line.split_whitespace()).done().stdout;
    let by_file = draw("render scene.toml -o -");
    let by_flags = draw(&format!("render -o - {flags}"));
    assert!(by_file == by_flags, "{scene}\n{flags}");
    assert!(by_file != draw("render -o -"), "nothing is shown by a picture like any other");
}

#[test]
fn a_scene_file_and_the_same_flags_give_equal_bytes() {
    assert_equal(
        "ambient = [0.05, 0.06, 0.07]\nbackground = [0.1, 0.2, 0.3, 0.5]\n\
         environment = \"studio\"\n\
         [[models]]\nsource = \"demo:teapot\"\n\
         [material]\ncolor = [0.3, 0.6, 0.9]\nka = 0.9\nkd = 0.8\nks = 0.7\nshininess = 12.5\n\
         emission = [0.01, 0, 0.02]\nreflection = \"mixed:phong=.8,mirror=.2\"\n\
         [[lights]]\nkind = \"directional\"\ndir = [-1, -2, -3]\ndiffuse = [1.2, 1, 0.9]\n\
         [[lights]]\nkind = \"point\"\npos = [3, 4, 5]\nattenuation = [1, 0, 0.01]\n\
         [[lights]]\nkind = \"spot\"\npos = [0, 5, 5]\ndir = [0, -1, -1]\ncutoff = 30\n\
         exponent = 4\nin = \"camera\"\n\
         [fog]\nnear = 6\nfar = 14\nfront = 0.9\nback = 0.2\ncolor = [0.2, 0.3, 0.4]\n\
         [render]\nsize = \"160x120\"\nsamples = 8\neye = [5, 4.25, 7]\ntarget = [0.1, 1.2, 0]\n\
         fov = 37.5\nnear = 1\nfar = 20\ncull = \"back\"\nnormals = \"mean\"\ncrease = 60\n",
        "demo:teapot --ambient .05,.06,.07 --background .1,.2,.3,.5 --environment studio \
         --color .3,.6,.9 --ka .9 --kd .8 --ks .7 --shininess 12.5 --emission .01,0,.02 \
         --reflection mixed:phong=.8,mirror=.2 \
         --light directional:dir=-1,-2,-3:diffuse=1.2,1,.9 \
         --light point:pos=3,4,5:attenuation=1,0,.01 \
         --light spot:pos=0,5,5:dir=0,-1,-1:cutoff=30:exponent=4:in=camera \
         --fog near=6:far=14:front=.9:back=.2:color=.2,.3,.4 \
         --size 160x120 --samples 8 --eye 5,4.25,7 --target .1,1.2,0 --fov 37.5 --near 1 --far 20 \
         --cull back --normals mean --crease 60",
    );
}

#[test]
fn lights_and_fog_of_a_scene_file_equal_those_of_the_flags() {
    assert_equal(
        "[[models]]\nsource = \"demo:plane\"\n\
         [[lights]]\nkind = \"point\"\npos = [1, 3, 2]\nattenuation = [0, 0, 0.3]\nlimit = 0.4\n\
         range = 6\n\
         [[lights]]\nkind = \"spot\"\npos = [0, 5, 1]\ndir = [0, -1, 0]\ncutoff = 35\ninner = 12\n\
         [fog]\nlaw = \"exp2\"\ndensity = 0.08\ncolor = [0.5, 0.6, 0.7]\n\
         [render]\nsize = \"160x120\"\n",
        "demo:plane --size 160x120 --light point:pos=1,3,2:attenuation=0,0,.3:limit=.4:range=6 \
         --light spot:pos=0,5,1:dir=0,-1,0:cutoff=35:inner=12 \
         --fog law=exp2:density=.08:color=.5,.6,.7",
    );
}

#[test]
fn a_camera_of_a_scene_file_equals_the_same_flags() {
    assert_equal(
        "[[models]]\nsource = \"demo:teapot\"\n[render]\nsize = \"160x120\"\n\
         [[cameras]]\nname = \"c\"\neye = [3.3, 2.7, 6.1]\ntarget = [0.2, 0.9, 0.1]\nfov = 33\n",
        "demo:teapot --size 160x120 --eye 3.3,2.7,6.1 --target .2,.9,.1 --fov 33",
    );
    assert_equal(
        "up = \"Z\"\n[[models]]\nsource = \"square.ply\"\n\
         [render]\nsize = [\"160x120\"]\northo = 3\nazimuth = 80\nelevation = 5\nedges = true\n",
        "square.ply --up Z --size 160x120 --ortho 3 --azimuth 80 --elevation 5 --edges",
    );
}

#[test]
fn a_scene_file_with_one_model_renders_like_the_model() {
    for name in ["cornell", "spheres", "plane"] {
        let scene = format!("[[models]]\nsource = \"demo:{name}\"\n[render]\nsize = \"160x90\"\n");
        assert_equal(&scene, &format!("demo:{name} --size 160x90"));
    }
}

#[test]
fn flags_override_the_file() {
    let folder = Folder::new();
    folder.write(
        "scene.toml",
        format!(
            "{HEADER}ambient = [1, 0, 0]\n[[models]]\nsource = \"demo:teapot\"\n\
             [material]\nks = 1\n[[lights]]\nkind = \"directional\"\ndir = [1, 0, 0]\n\
             [render]\nsize = \"64x48\"\northo = 9\nsamples = 16\neye = [9, 9, 9]\n\
             target = [0, 1, 0]\n"
        ),
    );
    let draw = |line: &str| folder.run(line.split_whitespace()).done().stdout;
    let line = "--size 90x60 --fov 40 --azimuth 10 --samples 2 --ambient 0,.2,0 --ks 0 \
                --light directional:dir=0,-1,-1";
    assert_eq!(
        draw(&format!("render scene.toml -o - {line}")),
        draw(&format!("render demo:teapot -o - {line}"))
    );
    let quiet = draw("-q render --fov 40 --size 64x48 -o - -- scene.toml");
    assert!(!quiet.is_empty(), "the model may come last, and flags before the command");
}

#[test]
fn the_standard_input_may_be_a_scene_file() {
    let folder = Folder::new();
    let text = format!(
        "{HEADER}[[models]]\nsource = \"demo:teapot\"\n[render]\nsize = \"64x48\"\nsamples = 2\n"
    );
    let expected = "render demo:teapot --size 64x48 --samples 2 -o -";
    let expected = folder.run(expected.split_whitespace()).done().stdout;
    for line in ["render - --format toml -o -", "render - -o -"] {
        let drawn = folder.run_with_input(line.split_whitespace(), text.as_bytes()).done().stdout;
        assert!(drawn == expected, "{line}");
    }
}

#[test]
fn info_summarizes_a_scene_file_with_its_settings() {
    let folder = Folder::new();
    folder.write("square.ply", SQUARE_PLY);
    folder.write(
        "scene.toml",
        format!(
            "{HEADER}[[models]]\nsource = \"square.ply\"\ntranslate = [0, 0, 2]\n\
             [[lights]]\nname = \"lamp\"\nkind = \"point\"\npos = [0, 1, 0]\nnode = \"square\"\n\
             [[cameras]]\nname = \"front\"\neye = [0, 0, 9]\ntarget = [0, 0, 0]\n\
             [[cameras]]\nname = \"side\"\neye = [9, 0, 0]\ntarget = [0, 0, 0]\n\
             [render]\ncamera = \"side\"\nsize = \"200x100\"\nshadows = false\n"
        )
        .replace("shadows = false\n", ""),
    );
    let info = folder.run(["info", "scene.toml", "--json"]).json();
    assert_eq!(info["format"], "toml");
    assert_eq!(info["triangles"], 2);
    assert_eq!(info["objects"][0]["path"], serde_json::json!(["square", "square"]));
    assert_eq!(info["bounds"]["min"][2], 2.0);
    assert_eq!(info["lights"][0]["name"], "lamp");
    assert_eq!(info["lights"][0]["path"], serde_json::json!(["square"]));
    let eye = folder.run(["info", "scene.toml"]).text();
    assert!(eye.contains("eye        9 0 "), "{eye}");
    let of_line = folder.run(["info", "scene.toml", "--camera", "front"]).text();
    assert!(of_line.contains("eye        0 0 9\n"), "{of_line}");
}

#[test]
fn errors_in_a_scene_file_have_their_place() {
    let folder = Folder::new();
    folder.write("square.ply", SQUARE_PLY);
    for (scene, expected) in [
        ("[render]\nfov = 200\n", "scene.toml:4:7: fov: it must be between 0 and 180"),
        ("[render]\nfoo = 1\n", "scene.toml:4:1: `foo` is unknown here"),
        ("[render]\nthreads = 1\n", "scene.toml:4:1: `threads` is for the command line"),
        ("[render]\nlight = \"x\"\n", "scene.toml:4:1: `light` is not a setting: write [[lights]]"),
        ("[render]\nfov = 20\northo = 2\n", "exclude each other"),
        ("[[models]]\nsurce = \"x\"\n", "scene.toml:4:1: `surce` is unknown here: did you mean"),
        ("[[models]]\nsource = \"no.obj\"\n", "scene.toml:4:10: no.obj: "),
        ("x = [\n", "scene.toml:"),
    ] {
        folder.write("scene.toml", format!("{HEADER}{scene}"));
        for command in ["render scene.toml -o x.png", "info scene.toml"] {
            folder.run(command.split_whitespace()).failed(1, expected);
        }
    }
    folder.write("scene.toml", HEADER);
    folder.run(["render", "scene.toml", "-o", "x.png"]).failed(1, "nothing to draw");
    folder.run(["render", "missing.toml", "-o", "x.png"]).failed(1, "missing.toml");
    assert_eq!(folder.files(), ["scene.toml", "square.ply"]);
}

#[test]
fn a_scene_file_cannot_raise_its_own_limits() {
    let folder = Folder::new();
    folder.write(
        "scene.toml",
        format!("{HEADER}[[models]]\nsource = \"demo:blob\"\n[render]\nmax-memory = \"8G\"\n"),
    );
    let run = folder.run(["render", "scene.toml", "-o", "x.png", "--max-memory", "9M"]);
    run.failed(1, "`max-memory` is for the command line");
}

#[test]
fn the_examples_are_drawn() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut drawn = 0;
    for entry in std::fs::read_dir(examples).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "toml") {
            continue;
        }
        let folder = Folder::new();
        let picture = ["-o", "x.ppm", "--size", "96x60"];
        let line = ["render".as_ref(), path.as_os_str()];
        let line = line.into_iter().chain(picture.iter().map(AsRef::as_ref));
        folder.run(line).done();
        let pixels = folder.read("x.ppm").split_off(15);
        let first = &pixels[..3];
        assert!(pixels.chunks(3).filter(|pixel| *pixel != first).count() > 800, "{path:?}");
        drawn += 1;
    }
    assert!(drawn >= 2);
}
