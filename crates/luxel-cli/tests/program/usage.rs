//! Wrong usage exits with status 2 and a message about valid values; unusual valid values work.

use crate::program::{Folder, SQUARE_PLY, luxel};

/// Flags with invalid values, and a part of the message.
const WRONG: [(&str, &str); 66] = [
    ("--size 0x10", "1 to 16384"),
    ("--size 10x0", "1 to 16384"),
    ("--size 16385x1", "1 to 16384"),
    ("--size 100000x100000", "1 to 16384"),
    ("--size -1x-1", "whole number"),
    ("--size 10", "WIDTHxHEIGHT"),
    ("--size axb", "whole number"),
    ("--size 1.5x2", "whole number"),
    ("--eye 1,2", "3 numbers"),
    ("--eye 1,2,3,4", "3 numbers"),
    ("--eye a,b,c", "is not a number"),
    ("--eye nan,0,0", "finite"),
    ("--eye 0,-inf,0", "finite"),
    ("--eye 0,1e999,0", "finite"),
    ("--eye", "value"),
    ("--target 0,0,0", "--eye"),
    ("--eye 1,2,3 --target 1,2,3", "eye and target are the same point"),
    ("--eye 1,2,3 --target 0,nan,0", "finite"),
    ("--eye 1,2,3 --camera c", "cannot be used with"),
    ("--eye 1,2,3 --azimuth 3", "cannot be used with"),
    ("--up 0,0,0", "length 0"),
    ("--up W", "X, Y or Z"),
    ("--fov 0", "between 0 and 180"),
    ("--fov 180", "between 0 and 180"),
    ("--fov -45", "between 0 and 180"),
    ("--fov nan", "finite"),
    ("--fov 45 --ortho 3", "cannot be used with"),
    ("--ortho 0", "above 0"),
    ("--ortho -1", "above 0"),
    ("--ortho infinity", "finite"),
    ("--ortho 1 --far infinity", "finite --far"),
    ("--near 0", "above 0"),
    ("--near -1", "above 0"),
    ("--near infinity", "finite"),
    ("--near nan", "finite"),
    ("--far 0", "above 0"),
    ("--far -infinity", "finite"),
    ("--far nan", "finite"),
    ("--near 5 --far 5", "less than --far"),
    ("--near 6 --far 5", "less than --far"),
    ("--view-matrix 1,2,3", "16 numbers"),
    ("--view-matrix 2,0,0,0,0,2,0,0,0,0,2,0,0,0,0,1", "rotation"),
    ("--view-matrix 1,0,0,1,0,1,0,1,0,0,1,1,0,0,0,1", "last row"),
    ("--view-matrix 1,0,0,0,0,1,0,0,0,0,1,0,0,0,-5,1 --eye 1,2,3", "cannot be used with"),
    ("--intrinsics 0,1,2,3", "above 0"),
    ("--intrinsics 100,100,10", "4 numbers"),
    ("--intrinsics 100,100,10,10 --fov 45", "cannot be used with"),
    ("--azimuth inf", "finite"),
    ("--elevation 91", "-90 and 90"),
    ("--samples 0", "1, 2, 4, 8 or 16"),
    ("--samples 3", "1, 2, 4, 8 or 16"),
    ("--samples 32", "1, 2, 4, 8 or 16"),
    ("--samples -4", "1, 2, 4, 8 or 16"),
    ("--cull front", "front"),
    ("--threads 0", "1 to 1024"),
    ("--threads -1", "1 to 1024"),
    ("--threads 1.5", "1 to 1024"),
    ("--threads 99999999999999999999", "1 to 1024"),
    ("--simd mmx", "not a SIMD level"),
    ("--simd simd128", "this machine"),
    ("--max-memory 0", "amount of memory"),
    ("--max-memory -1G", "amount of memory"),
    ("--max-memory lots", "amount of memory"),
    ("--format docx", "not a format"),
    ("--quiet --verbose", "cannot be used with"),
    ("--nonsense", "--nonsense"),
];

/// The same for flags of `render` only.
const WRONG_FOR_RENDER: [(&str, &str); 46] = [
    ("-o a.gif", "not an image format"),
    ("-o a", "needs an extension"),
    ("-o", "value"),
    ("-o a.png --output-format gif", "not an image format"),
    ("-o - --json", "standard output"),
    ("-o a.png --bits 12", "8 or 16"),
    ("-o a.exr --bits 16", "--bits"),
    ("-o a.png --layer nosuch", "not a layer"),
    ("-o a.png --layer depth --layer object", "EXR"),
    ("-o a.npy --layer depth --layer object", "EXR"),
    ("-o a.png --wireframe --edges", "cannot be used with"),
    ("-o a_{m}.png --turntable 4", "{n}"),
    ("-o {n}{n}.png --turntable 4", "{n}"),
    ("-o {n:0}.png --turntable 4", "digits"),
    ("-o {n}.png --turntable 0", "--turntable"),
    ("-o {n}.png --turntable -3", "--turntable"),
    ("-o - --turntable 3", "need numbered files"),
    ("-o a.png --light sun", "not a kind of light"),
    ("-o a.png --light directional", "dir=X,Y,Z"),
    ("-o a.png --light directional:dir=0,0,0", "length 0"),
    ("-o a.png --light directional:dir=nan,0,0", "finite"),
    ("-o a.png --light point", "pos=X,Y,Z"),
    ("-o a.png --light point:pos=1,2,3:attenuation=0,0,0", "all 0"),
    ("-o a.png --light point:pos=1,2,3:in=moon", "world or camera"),
    ("-o a.png --light spot:pos=1,2,3:dir=1,0,0:cutoff=91", "0 to 90"),
    ("-o a.png --light spot:pos=1,2,3:dir=1,0,0:exponent=-1", "below 0"),
    ("-o a.png --light ambient", "color=COLOR"),
    ("-o a.png --light ambient:color=1,1", "3 numbers"),
    (
        "-o a.png --light point:pos=1,2,3:name=a --light point:pos=1,2,3:name=a",
        "two lights have the name `a`",
    ),
    ("-o a.png --ambient 1", "3 numbers"),
    ("-o a.png --ambient nan,0,0", "finite"),
    ("-o a.png --environment hdri", "none, studio, microfacet, or a colour"),
    ("-o a.png --fog near=1", "far=Z"),
    ("-o a.png --fog near=2:far=1", "less than far"),
    ("-o a.png --fog near=1:far=2:front=3", "0 to 1"),
    ("-o a.png --color 1,2", "3 numbers"),
    ("-o a.png --color -1,0,0", "below 0"),
    ("-o a.png --ks -1", "below 0"),
    ("-o a.png --shininess inf", "finite"),
    ("-o a.png --roughness 2", "0 to 1"),
    ("-o a.png --reflection plastic", "is not a reflection model"),
    ("-o a.png --normals guess", "guess"),
    ("-o a.png --crease 181", "between 0 and 180"),
    ("-o a.png --background 1", "3"),
    ("-o a.png --background 0,0,0,2", "between 0 and 1"),
    ("-o a.png --encoding gamma", "gamma"),
];

#[test]
fn a_flag_for_an_environment_that_is_not_there_is_a_warning() {
    let folder = Folder::new();
    let small = "demo:cornell --size 32x24";
    for (flags, said) in [
        ("--environment none --environment-background", "--environment-background shows nothing"),
        // The scene has lights, and therefore no environment.
        ("--environment-background", "--environment-background shows nothing"),
        ("--environment studio --environment-rotation 90", "--environment-rotation turns nothing"),
    ] {
        for line in [
            format!("render {small} {flags} -o x.png --json"),
            format!("explain {small} {flags} --at 0,0"),
        ] {
            let run = folder.run(line.split_whitespace());
            assert_eq!(run.status, Some(0), "{line}: {}", run.stderr);
            let warning = format!("luxel: warning: {said}");
            assert!(run.stderr.starts_with(&warning), "{line}: {}", run.stderr);
            let in_json = String::from_utf8_lossy(&run.stdout).contains(said);
            assert_eq!(in_json, line.starts_with("render"), "{line}");
        }
    }
    let line = format!("render {small} --environment .5,.5,1 --environment-background -o x.png");
    folder.run(line.split_whitespace()).done();
}

#[test]
fn invalid_values_are_wrong_usage_for_info_and_render() {
    for (flags, expected) in WRONG {
        luxel(&format!("info demo:cornell {flags}")).failed(2, expected);
        luxel(&format!("render demo:cornell -o a.png {flags}")).failed(2, expected);
    }
    for (flags, expected) in WRONG_FOR_RENDER {
        luxel(&format!("render demo:cornell {flags}")).failed(2, expected);
    }
}

#[test]
fn incomplete_and_unknown_commands_are_wrong_usage() {
    luxel("render demo:cornell").failed(2, "--output");
    luxel("info a.ply b.ply").failed(2, "b.ply");
    luxel("completions tcsh").failed(2, "tcsh");
}

#[test]
fn a_command_that_is_misspelt_or_left_out_is_suggested() {
    luxel("help rendr").failed(2, "did you mean `luxel help render`?");
    luxel("help render").done();
    luxel("rendr a.glb -o a.png").failed(2, "did you mean `luxel render`?");
    luxel("-q chekc a.glb").failed(2, "did you mean `luxel check`?");
    luxel("a.glb -o a.png").failed(2, "did you mean `luxel render a.glb -o a.png`?");
    luxel("a.glb --at 3,4 --through")
        .failed(2, "did you mean `luxel pick a.glb --at 3,4 --through`?");
    // Other words are models to view, and so is a file of a command's name, nearly.
    luxel("nothing-like-it").failed(1, "nothing-like-it");
    let folder = Folder::new();
    folder.write("rendr", "");
    folder.run(["rendr"]).failed(1, "window");
}

#[test]
fn usage_shows_that_a_model_is_enough() {
    assert!(luxel("--help").text().contains("luxel [MODEL]"));
}

#[test]
fn the_standard_input_shows_its_format_by_its_first_bytes() {
    let folder = Folder::new();
    folder.run_with_input(["info", "-"], b"hello").failed(1, "--format");
    let info = folder.run_with_input(["info", "-", "--json"], SQUARE_PLY.as_bytes()).json();
    assert_eq!(info["format"], "ply");
    let run =
        folder.run_with_input(["info", "-", "--format", "ply", "--json"], SQUARE_PLY.as_bytes());
    let info = run.json();
    assert_eq!(info["format"], "ply");
    assert_eq!(info["triangles"], 2);
}

#[test]
fn unusual_valid_values_are_accepted() {
    for flags in [
        "--eye -1,.5,1e1 --target -.5,-0,1e-7 --up -z",
        "--near .5 --far infinity",
        "--ortho 3 --near -10 --far 10",
        "--fov 179.9",
        "--up 0,0,-1e-300",
        "--view-matrix 1,0,0,0,0,1,0,0,0,0,1,0,0,0,-5,1",
        "--intrinsics 500,500,-20,1000",
        "--azimuth -370 --elevation -90",
        "--size 1x16384",
        "--samples 16 --cull back --threads 3 --simd auto --max-memory 1.5GiB",
        "--size 3x3 --size 4x4",
    ] {
        luxel(&format!("info demo:cornell --json {flags}")).json();
    }
}

#[test]
fn help_and_version_go_to_the_standard_output() {
    assert!(luxel("--version").text().starts_with("luxel "));
    assert!(luxel("--help").text().contains("render"));
    assert!(luxel("render --help").text().contains("--turntable"));
    assert!(luxel("help info").text().contains("--json"));
}

#[test]
fn completions_and_manual_name_every_command_and_flag() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = luxel(&format!("completions {shell}")).text();
        assert!(script.contains("turntable") && script.contains("demos"), "{shell}");
    }
    let manual = luxel("man").text();
    assert!(manual.contains(".TH luxel 1"));
    for word in ["LUXEL RENDER", "LUXEL INFO", "view\\-matrix", "max\\-memory", "EXIT STATUS"] {
        assert!(manual.contains(word), "{word}");
    }
}

#[test]
fn every_listed_demo_opens() {
    let list = luxel("demos").text();
    let names: Vec<_> = list.lines().filter_map(|line| line.split_whitespace().next()).collect();
    for name in ["demo:teapot", "demo:spheres", "demo:cornell", "demo:plane"] {
        assert!(names.contains(&name), "{list}");
    }
    let json = luxel("demos --json").json();
    assert_eq!(json.as_array().unwrap().len(), names.len());
    for name in names {
        assert!(luxel(&format!("info {name} --json")).json()["triangles"].as_u64().unwrap() > 0);
    }
    luxel("info demo:nosuch").failed(1, "no such scene");
}

#[cfg(unix)]
#[test]
fn a_closed_standard_output_is_not_an_error() {
    use std::process::{Command, Stdio};
    // The manual exceeds the buffer of a pipe.
    let mut child = Command::new(env!("CARGO_BIN_EXE_luxel"))
        .args(["completions", "zsh"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn verbose_times_are_named_once_and_say_what_is_summed_over_threads() {
    let folder = Folder::new();
    let run = folder.run("render demo:plane --size 64x48 -o a.png -v".split(' '));
    for (words, count) in [("read", 3), ("summed over threads", 2), ("bins", 1), ("total", 1)] {
        // "threads" has a "read" in it.
        assert_eq!(run.stderr.matches(words).count(), count, "{words}: {}", run.stderr);
    }
}
