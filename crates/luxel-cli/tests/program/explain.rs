//! The ledger as the program prints it: the text alone must give the pixel again, and agree with
//! the equation computed anew in f64.

use crate::program::{Folder, luxel};
use serde_json::Value;
use std::collections::BTreeSet;

pub(crate) type Rgb = [f32; 3];

fn number(value: &Value) -> f32 {
    value.as_f64().unwrap() as f32
}

pub(crate) fn rgb(value: &Value) -> Rgb {
    [0, 1, 2].map(|channel| number(&value[channel]))
}

fn plus(a: Rgb, b: Rgb) -> Rgb {
    [0, 1, 2].map(|channel| a[channel] + b[channel])
}

/// ((emission + scene_ambient) + each light's three terms) + environment, from left to right.
fn sum_of_terms(entry: &Value) -> Rgb {
    let mut sum = plus(rgb(&entry["emission"]), rgb(&entry["scene_ambient"]));
    for light in entry["lights"].as_array().unwrap() {
        for term in ["ambient", "diffuse", "specular"] {
            sum = plus(sum, rgb(&light[term]));
        }
    }
    plus(sum, rgb(&entry["environment"]))
}

/// How to interpret a run.
#[derive(Clone, Copy)]
struct Reading {
    clamped_at_vertices: bool,
    /// The weights of corners are those used, not products of them.
    exact: bool,
}

/// Checks one surface's sum and colour; returns its colour and alpha.
fn surface(entry: &Value, reading: Reading) -> (Rgb, f32) {
    let alpha = number(&entry["alpha"]);
    let color = rgb(&entry["color"]);
    if entry["object"].is_null() {
        return (color, alpha);
    }
    let sum = rgb(&entry["sum"]);
    if let Some(places) = entry["evaluated_at"].as_array() {
        let mut mixed: Option<Rgb> = None;
        let mut lights: Vec<(Rgb, f32)> = Vec::new();
        for place in places {
            assert_eq!(sum_of_terms(place), rgb(&place["sum"]));
            let mut light = rgb(&place["sum"]);
            if reading.clamped_at_vertices {
                light = light.map(|channel| channel.clamp(0.0, 1.0));
            }
            assert_eq!(light, rgb(&place["light"]));
            let weight = number(&place["weight"]);
            lights.push((light, weight));
            let part = if places.len() == 1 { light } else { light.map(|c| c * weight) };
            mixed = Some(mixed.map_or(part, |mixed| plus(mixed, part)));
        }
        let texture = rgb(&entry["texture"]);
        let mixed = mixed.unwrap();
        let made: Rgb = [0, 1, 2].map(|channel| mixed[channel] * texture[channel]);
        // Interpolated over a triangle: the first corner's light plus the differences of the
        // others.
        let between: Option<Rgb> = match lights[..] {
            [(first, _), (second, b1), (third, b2)] => Some([0, 1, 2].map(|at| {
                let mixed =
                    first[at] + (second[at] - first[at]) * b1 + (third[at] - first[at]) * b2;
                mixed * texture[at]
            })),
            _ => None,
        };
        if reading.exact {
            assert!(made == sum || between == Some(sum), "{made:?}, {between:?}: {entry}");
        }
        // The terms add up, too, up to rounding.
        let terms = sum_of_terms(entry);
        for channel in 0..3 {
            let off =
                (terms[channel] - sum[channel]).abs().max((made[channel] - sum[channel]).abs());
            assert!(off <= 2e-5 * sum[channel].abs().max(1.0), "{entry}");
        }
    } else {
        assert_eq!(sum_of_terms(entry), sum);
    }
    let fog = &entry["fog"];
    let foggy = if fog.is_null() {
        sum
    } else {
        let factor = number(&fog["factor"]);
        let fog = rgb(&fog["color"]);
        [0, 1, 2].map(|channel| sum[channel] * factor + fog[channel] * (1.0 - factor))
    };
    assert_eq!(foggy, color);
    (color, alpha)
}

/// round(255 encode(clamp(v, 0, 1))) by the definition of IEC 61966-2-1.
fn byte(value: f32) -> u64 {
    let value = f64::from(value).clamp(0.0, 1.0);
    let encoded = if value <= 0.003_130_8 {
        12.92 * value
    } else {
        1.055 * libm::pow(value, 1.0 / 2.4) - 0.055
    };
    (encoded * 255.0).round_ties_even() as u64
}

/// Recomputes the pixel from the document alone.
fn made_again(document: &Value, reading: Reading) -> [u64; 4] {
    let entries = document["samples"].as_array().unwrap();
    let layered = entries.iter().any(|entry| entry["layers"].is_array());
    let count: usize = entries.iter().map(|entry| entry["covers"].as_array().unwrap().len()).sum();
    let share = 1.0 / count as f32;
    let mut sum = [0.0_f32; 4];
    if layered {
        for sample in 0..count as u64 {
            let covers = |entry: &&Value| {
                entry["covers"].as_array().unwrap().iter().any(|at| at.as_u64() == Some(sample))
            };
            let entry = entries.iter().find(covers).unwrap();
            let alone = [entry.clone()];
            let seen = entry["layers"].as_array().map_or(&alone[..], Vec::as_slice);
            let (mut light, mut through) = ([0.0_f32; 3], 1.0_f32);
            for layer in seen {
                let (color, alpha) = surface(layer, reading);
                for channel in 0..3 {
                    light[channel] += through * alpha * color[channel];
                }
                through *= 1.0 - alpha;
            }
            for channel in 0..3 {
                sum[channel] += light[channel] * share;
            }
            sum[3] += (1.0 - through) * share;
        }
    } else {
        for entry in entries {
            let (color, alpha) = surface(entry, reading);
            let weight = number(&entry["weight"]);
            assert_eq!(weight, entry["covers"].as_array().unwrap().len() as f32 * share);
            let weight = weight * alpha;
            for channel in 0..3 {
                sum[channel] += color[channel] * weight;
            }
            sum[3] += weight;
        }
    }
    let divisor = if sum[3] > 0.0 { sum[3] } else { 1.0 };
    let [r, g, b] = [0, 1, 2].map(|channel| byte(sum[channel] / divisor));
    [r, g, b, (f64::from(sum[3]).clamp(0.0, 1.0) * 255.0).round_ties_even() as u64]
}

/// Numbers without a pattern: a multiplier and an increment of Knuth's MMIX.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, limit: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % limit
    }

    /// Between two numbers, with three digits.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        ((low + (high - low) * self.below(10_000) as f64 / 10_000.0) * 1000.0).round() / 1000.0
    }

    pub(crate) fn three(&mut self, low: f64, high: f64) -> String {
        let [a, b, c] = [0; 3].map(|_| self.between(low, high));
        format!("{a},{b},{c}")
    }
}

/// Two sheets of glass before a wall, all of them slanting.
const GLASS_OBJ: &str = "\
mtllib glass.mtl
v -1 -1 0
v 1 -1 0.3
v 1 1 0
v -1 1 -0.3
v -1 -1 1
v 1 -1 0.7
v 0.9 1 0.6
v -1 0.8 1.1
v -2 -2 -2
v 2 -2 -2
v 0 2.5 -2
usemtl blue
f 1 2 3 4
usemtl red
f 5 6 7 8
usemtl wall
f 9 10 11
";
const GLASS_MTL: &str = "\
newmtl blue
Kd 0.2 0.3 0.9
Ks 0.5 0.5 0.5
Ns 40
d 0.35
newmtl red
Kd 0.9 0.2 0.1
d 0.6
newmtl wall
Kd 0.5 0.6 0.4
";

/// Runs the program on a model and pixel with flags; the document and the pixel that `render`
/// writes.
fn explained(folder: &Folder, model: &str, flags: &str, [x, y]: [u64; 2]) -> (Value, [u64; 4]) {
    let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let line = format!("render {model} --size 40x30 -o picture.png {flags}");
    folder.run(words(&line)).done();
    let picture = folder.read("picture.png");
    let mut reader = png::Decoder::new(std::io::Cursor::new(&picture)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    let first = ((y * 40 + x) * 4) as usize;
    let drawn = [0, 1, 2, 3].map(|channel| u64::from(pixels[first + channel]));
    let line = format!("explain {model} --size 40x30 --at {x},{y} --json {flags}");
    (folder.run(words(&line)).json(), drawn)
}

fn check(folder: &Folder, model: &str, flags: &str, pixel: [u64; 2]) -> Value {
    let (document, drawn) = explained(folder, model, flags, pixel);
    let told = [0, 1, 2, 3].map(|channel| document["rgba8"][channel].as_u64().unwrap());
    assert_eq!(told, drawn, "{model} {flags} {pixel:?}");
    let reading = Reading {
        clamped_at_vertices: !flags.contains("--clamp end"),
        exact: !flags.contains("--interpolation"),
    };
    assert_eq!(made_again(&document, reading), drawn, "{model} {flags} {pixel:?}");
    document
}

#[test]
fn the_terms_of_the_document_add_up_to_the_pixel() {
    let folder = Folder::new();
    folder.write("glass.obj", GLASS_OBJ);
    folder.write("glass.mtl", GLASS_MTL);
    let shadings = [
        "",
        "--shading gouraud",
        "--shading flat",
        "--shading subdivided --tolerance 3",
        "--shading gouraud --clamp end",
        "--shading gouraud --interpolation scanline",
        "--shading phong --interpolation screen",
    ];
    let reflections = [
        "unlit",
        "lambert",
        "oren-nayar",
        "phong",
        "blinn-phong",
        "microfacet",
        "mirror",
        "retro",
        "mixed:lambert=.6,phong=.3,mirror=.1",
    ];
    let fogs = ["", "--fog near=1:far=9:front=1:back=.2:color=.5,.6,.9"];
    let lights = [
        "",
        "--light point:pos=1,2,3:diffuse=3,2,1:attenuation=.5,.1,.05 --light spot:pos=0,3,1:dir=0,-1,-.3:cutoff=40:exponent=3:in=camera --ambient .1,.1,.2 --environment studio",
    ];
    let mut random = Random(7);
    let models = ["demo:teapot", "demo:spheres", "demo:cornell", "demo:plane", "glass.obj"];
    let mut surfaces = 0;
    let mut used = BTreeSet::new();
    for round in 0..126 {
        let model = models[round % models.len()];
        let reflection = match round % 4 {
            0 => String::new(),
            _ => {
                format!("--reflection {}", reflections[(round * 5 + round / 9) % reflections.len()])
            }
        };
        let flags = format!(
            "--samples {} {} {reflection} {} {}",
            [1, 2, 4, 8, 16][(round / 2) % 5],
            shadings[round % shadings.len()],
            fogs[round / 3 % 2],
            lights[round / 5 % 2],
        );
        let pixel = [8 + random.below(24), 5 + random.below(20)];
        let document = check(&folder, model, &flags, pixel);
        if !document["samples"][0]["object"].is_null() {
            surfaces += 1;
            used.extend(flags.split_whitespace().map(str::to_owned));
            used.insert(model.to_owned());
        }
    }
    let all = shadings.iter().flat_map(|flags| flags.split_whitespace()).chain(models);
    for flag in all.chain(reflections).chain(["--fog", "--light", "1", "2", "4", "8", "16"]) {
        assert!(used.contains(flag), "{flag} is among what was tried on a surface");
    }
    check(&folder, "demo:blob", "--samples 16", [20, 15]);
    assert!(surfaces > 50, "most pixels show something: {surfaces}");
}

#[test]
fn transparent_surfaces_are_listed_nearest_first() {
    let folder = Folder::new();
    folder.write("glass.obj", GLASS_OBJ);
    folder.write("glass.mtl", GLASS_MTL);
    let document = check(&folder, "glass.obj", "--eye 0,0,6 --target 0,0,0 --samples 4", [20, 15]);
    let layers = document["samples"][0]["layers"].as_array().unwrap();
    let names: Vec<_> =
        layers.iter().map(|layer| layer["material"]["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["red", "blue", "wall"]);
    assert!((number(&layers[0]["alpha"]) - 0.6).abs() < 1e-6);
    assert_eq!(number(&layers[2]["alpha"]), 1.0);
}

#[test]
fn a_position_outside_the_image_is_wrong_usage() {
    luxel("explain --size 20x10 --at 20,3").failed(2, "outside of the picture");
    luxel("explain --size 20x10 --at 20.0,3").failed(2, "outside of the picture");
    luxel("explain --size 20x10 --at 19.999,9.999").done();
    luxel("explain --at 3").failed(2, "two numbers");
    luxel("explain --size 20x10 --at 3,-1").failed(2, "pixel");
    luxel("explain --tolerance 3 --at 3,3").failed(2, "--shading subdivided");
    luxel("render -o x.png --layer light:moon").failed(1, "`moon`");
}

#[test]
fn text_lists_every_light_and_why_one_adds_nothing() {
    let text = luxel(
        "explain --size 64x36 --at 30,18 --light directional:dir=0,0,1:name=behind --light \
         spot:pos=0,9,0:dir=0,1,0:cutoff=10:name=up --light point:pos=3,5,9:name=lamp",
    )
    .text();
    for expected in
        ["behind (directional)", "stands behind the surface", "lamp (point)", "N.H", "up (spot)"]
    {
        assert!(text.contains(expected), "`{expected}` is not in:\n{text}");
    }
    assert!(!text.contains('\x1b'), "no colours but on a terminal");
}
