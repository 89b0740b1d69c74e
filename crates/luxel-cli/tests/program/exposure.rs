//! `--exposure` and `--tone`: pictures, the notice and the warning on the standard error, the ledger.

use crate::program::{Folder, SQUARE_PLY, luxel};
use luxel::lighting::{Display, PictureEncoding, Tone};
use luxel::math::Rgb;
use serde_json::Value;

/// A white square that fills the middle half of the window and faces the light.
const SQUARE: &str = "square.ply --size 64x64 --eye .5,.5,5 --target .5,.5,0 --ortho 2 --samples 1 \
                      --color 1,.5,.25 --reflection lambert";
const BRIGHT: &str = "--light directional:dir=0,0,-1:diffuse=2000,2000,2000";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("square.ply", SQUARE_PLY);
    folder
}

/// Renders the square; what is said on the standard error.
fn rendered(folder: &Folder, flags: &str) -> String {
    let line = format!("render {SQUARE} {flags}");
    let run = folder.run(line.split_whitespace());
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    run.stderr
}

/// The report of a rendering.
fn report(folder: &Folder, flags: &str) -> Value {
    let line = format!("render {SQUARE} {flags} --json --quiet");
    folder.run(line.split_whitespace()).json()
}

/// The middle pixel of a PPM.
fn middle(bytes: &[u8]) -> [u8; 3] {
    let at = bytes.len() - 64 * 64 * 3 + 3 * (32 * 64 + 32);
    [bytes[at], bytes[at + 1], bytes[at + 2]]
}

fn expected(light: f32, ev: f32, tone: Tone) -> [u8; 3] {
    let color = Rgb::new(light, 0.5 * light, 0.25 * light);
    Display::new(ev, tone).shown(color).lane(0).map(|light| PictureEncoding::Srgb.byte(light))
}

#[test]
fn auto_exposes_for_light_in_lux_and_says_so() {
    let folder = folder();
    let said = rendered(&folder, &format!("{BRIGHT} --exposure auto -o a.ppm"));
    assert!(said.contains("exposure -11:") && said.contains("2000"), "{said}");
    assert_eq!(middle(&folder.read("a.ppm")), expected(2000.0, -11.0, Tone::None));
    // The number that it says draws the same picture.
    assert_eq!(rendered(&folder, &format!("{BRIGHT} --exposure -11 -o b.ppm")), "");
    assert!(folder.read("b.ppm") == folder.read("a.ppm"));
    let said = rendered(&folder, &format!("{BRIGHT} --exposure auto --quiet -o a.ppm"));
    assert_eq!(said, "");
    let report = report(&folder, &format!("{BRIGHT} --exposure auto --tone agx -o a.png"));
    assert_eq!(report["exposure"]["ev"], -11.0);
    assert_eq!(report["exposure"]["factor"], 1.0 / 2048.0);
    assert_eq!(report["tone"]["name"], "agx");
}

#[test]
fn auto_leaves_light_about_one_as_it_is_and_says_nothing() {
    let folder = folder();
    for light in ["--light directional:dir=0,0,-1", "", "--light point:pos=.5,.5,2"] {
        let said = rendered(&folder, &format!("{light} --exposure auto -o a.ppm"));
        assert_eq!(said, "", "{light}");
        rendered(&folder, &format!("{light} -o b.ppm"));
        assert!(folder.read("a.ppm") == folder.read("b.ppm"), "{light}");
    }
}

#[test]
fn a_lamp_is_metered_where_the_model_is() {
    let folder = folder();
    // 100 / 5^2 = 4 at the square's middle, about so much at the two triangles' own.
    let lamp = "--light point:pos=.5,.5,5:attenuation=0,0,1:diffuse=100,100,100";
    let said = rendered(&folder, &format!("{lamp} --exposure auto -o a.ppm"));
    assert!(said.contains("exposure -2:"), "{said}");
    let dim = "--light point:pos=.5,.5,5:attenuation=0,0,1:diffuse=.1,.1,.1";
    let said = rendered(&folder, &format!("{dim} --exposure auto -o a.ppm"));
    assert!(said.contains("exposure 8:"), "{said}");
    let behind = "--light spot:pos=.5,.5,5:dir=0,0,1:cutoff=20:diffuse=100,100,100";
    assert_eq!(rendered(&folder, &format!("{behind} --exposure auto -o a.ppm")), "");
}

#[test]
fn a_picture_that_is_burnt_out_names_the_flag() {
    let folder = folder();
    for background in ["", "--background white"] {
        let said = rendered(&folder, &format!("{BRIGHT} {background} -o a.png"));
        assert!(said.contains("warning") && said.contains("100 % "), "{said}");
        assert!(said.contains("--exposure auto, here -11,"), "{said}");
    }
    for fine in [
        "--light directional:dir=0,0,-1",
        "--background white",
        "--light directional:dir=0,0,-1 --background white --color 1,1,1",
    ] {
        assert_eq!(rendered(&folder, &format!("{fine} -o a.png")), "", "{fine}");
    }
    for kept in ["--exposure -11 -o a.png", "-o a.exr", "-o a.npy", "--layer diffuse -o a.exr"] {
        assert_eq!(rendered(&folder, &format!("{BRIGHT} {kept}")), "", "{kept}");
    }
    for other in ["--tone aces -o a.png", "-o a.svg", "--bits 16 -o a.png", "-o a.ppm"] {
        let said = rendered(&folder, &format!("{BRIGHT} {other}"));
        assert!(said.contains("burnt out"), "{other}: {said}");
    }
    let report = report(&folder, &format!("{BRIGHT} -o a.png"));
    assert!(report["warnings"][0].as_str().unwrap().contains("burnt out"), "{report}");
}

#[test]
fn tone_curves_map_pixels_and_leave_light_in_files_alone() {
    let folder = folder();
    for tone in Tone::ALL {
        let name = tone.name();
        let flags = format!("--light directional:dir=0,0,-1 --exposure 1.5 --tone {name}");
        for (file, bits) in [("a.ppm", "8"), ("b.ppm", "16")] {
            rendered(&folder, &format!("{flags} --quiet --bits {bits} -o {file}"));
        }
        assert_eq!(middle(&folder.read("a.ppm")), expected(1.0, 1.5, tone), "{name}");
        let sixteen = folder.read("b.ppm");
        let high = sixteen[sixteen.len() - 64 * 64 * 6 + 6 * (32 * 64 + 32)];
        assert!(high.abs_diff(expected(1.0, 1.5, tone)[0]) <= 1, "{name}: {high}");
        for file in ["x.exr", "x.npy"] {
            let said = rendered(&folder, &format!("{flags} -o {file}"));
            assert_eq!(said.contains("--tone leaves"), tone != Tone::None, "{said}");
            let exposed = folder.read(file);
            let plain = "--light directional:dir=0,0,-1 --exposure 1.5";
            assert_eq!(rendered(&folder, &format!("{plain} -o {file}")), "");
            assert!(folder.read(file) == exposed, "{name} changes {file}");
        }
    }
    rendered(&folder, "--light directional:dir=0,0,-1 --exposure -1 -o x.npy");
    let bytes = folder.read("x.npy");
    let at = bytes.len() - 64 * 64 * 16 + 16 * (32 * 64 + 32);
    let red = f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    assert_eq!(red, 0.5);
}

#[test]
fn no_exposure_and_no_curve_are_the_defaults() {
    for demo in ["teapot", "spheres", "cornell"] {
        let folder = Folder::new();
        let line = format!("render demo:{demo} --size 120x80 -o a.png");
        folder.run(line.split_whitespace()).done();
        let flags = "--exposure 0 --tone none -o b.png";
        let line = format!("render demo:{demo} --size 120x80 {flags}");
        folder.run(line.split_whitespace()).done();
        assert!(folder.read("a.png") == folder.read("b.png"), "{demo}");
    }
}

#[test]
fn the_ledger_goes_on_to_what_is_shown() {
    let folder = folder();
    let explain = |flags: &str| {
        let line = format!("explain {SQUARE} {BRIGHT} --at 32,32 {flags}");
        folder.run(line.split_whitespace()).text()
    };
    let exposed = "--exposure -10.5 --tone neutral";
    let told: Value = serde_json::from_str(&explain(&format!("{exposed} --json"))).unwrap();
    assert_eq!(told["exposure"]["ev"], -10.5);
    assert_eq!(told["tone"], serde_json::json!({ "name": "neutral" }));
    let color = [0, 1, 2].map(|at| told["samples"][0]["color"][at].as_f64().unwrap());
    assert_eq!(color, [2000.0, 1000.0, 500.0]);
    let [r, g, b] = color.map(|channel| channel as f32);
    let shown = Display::new(-10.5, Tone::Neutral).shown(Rgb::new(r, g, b)).lane(0);
    for at in 0..3 {
        assert_eq!(told["samples"][0]["display"][at].as_f64().unwrap() as f32, shown[at]);
        assert_eq!(told["linear"][at].as_f64().unwrap() as f32, shown[at]);
        assert_eq!(told["rgba8"][at], PictureEncoding::Srgb.byte(shown[at]));
    }
    let text = explain(exposed);
    assert!(text.contains("= as shown") && text.contains("the tone curve neutral"), "{text}");
    assert!(text.contains("2^-10.5 I = "), "{text}");
    let html = explain(&format!("{exposed} --html"));
    assert!(html.contains("as shown") && html.contains("2<sup>-10.5</sup>"));
    let latex = explain(&format!("{exposed} --latex"));
    assert!(latex.contains("T(2^{-10.5} I)"), "{latex}");
    // Without flags, nothing is said of them.
    let plain: Value = serde_json::from_str(&explain("--json")).unwrap();
    assert_eq!(plain["exposure"], serde_json::json!({ "ev": 0.0, "factor": 1.0 }));
    assert_eq!(plain["samples"][0]["display"], plain["samples"][0]["color"]);
    assert!(!explain("").contains("as shown"));
}

#[test]
fn scene_files_hold_exposure_and_tone() {
    let folder = folder();
    let scene = |settings: &str| {
        let text = format!(
            "format = \"luxel-scene\"\nversion = 1\n[[models]]\nsource = \"square.ply\"\n\
             [[lights]]\nkind = \"directional\"\ndir = [0, 0, -1]\ndiffuse = [2000, 2000, 2000]\n\
             [render]\n{settings}\n"
        );
        folder.write("a.toml", text);
        let flags = &SQUARE["square.ply".len()..];
        let line = format!("render a.toml {flags} -o a.ppm --quiet");
        folder.run(line.split_whitespace()).done();
        middle(&folder.read("a.ppm"))
    };
    assert_eq!(scene("exposure = -12\ntone = \"aces\""), expected(2000.0, -12.0, Tone::Aces));
    assert_eq!(scene("exposure = \"auto\""), expected(2000.0, -11.0, Tone::None));
    let line = "render a.toml --exposure -10.5 --quiet -o b.ppm";
    folder.run(line.split_whitespace()).done();
    folder
        .write("a.toml", "format = \"luxel-scene\"\nversion = 1\n[render]\nexposure = \"much\"\n");
    folder.run(["info", "a.toml"]).failed(1, "exposure: `much` is not a number");
}

#[test]
fn exposures_that_are_none_are_wrong_usage() {
    for wrong in ["nan", "inf", "65", "-65", "bright", ""] {
        luxel(&format!("render demo:teapot -o a.png --exposure={wrong}")).failed(2, "--exposure");
    }
    luxel("render demo:teapot -o a.png --tone filmic").failed(2, "--tone");
}
