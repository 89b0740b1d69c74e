//! Each term of the ledger against the equation in f64, with the values of the command line.

use crate::explain::Random;
use crate::program::{Folder, luxel};
use serde_json::Value;

type V = [f64; 3];

fn v(value: &Value) -> V {
    [0, 1, 2].map(|axis| value[axis].as_f64().unwrap())
}

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: V) -> V {
    let length = dot(a, a).sqrt();
    a.map(|side| side / length)
}

fn parsed(text: &str) -> V {
    let numbers: Vec<f64> = text.split(',').map(|number| number.parse().unwrap()).collect();
    [numbers[0], numbers[1], numbers[2]]
}

/// Equal to 2e-4 relative, or 2e-5 absolute.
#[track_caller]
pub(crate) fn close(what: &str, told: f64, expected: f64) {
    let off = (told - expected).abs();
    assert!(off <= 2e-5 || off <= 2e-4 * expected.abs(), "{what}: {told}, not {expected}");
}

/// A light of the command line.
struct LampOnTheLine {
    kind: &'static str,
    place: V,
    direction: V,
    ambient: V,
    diffuse: V,
    specular: V,
    attenuation: V,
    cutoff: f64,
    exponent: f64,
    in_camera: bool,
}

impl LampOnTheLine {
    fn random(random: &mut Random) -> (Self, String) {
        let kind = ["directional", "point", "spot"][random.below(3) as usize];
        let in_camera = random.below(3) == 0;
        let [place, direction] = [random.three(-3.0, 3.0), random.three(-1.0, 1.0)];
        let [ambient, diffuse, specular] =
            [random.three(0.0, 0.3), random.three(0.0, 2.0), random.three(0.0, 2.0)];
        let attenuation = random.three(0.1, 0.6);
        let (cutoff, exponent) = (random.between(20.0, 89.0), random.between(0.0, 6.0));
        let mut spec = format!(":ambient={ambient}:diffuse={diffuse}:specular={specular}");
        if kind != "directional" {
            spec += &format!(":pos={place}:attenuation={attenuation}");
        }
        if kind != "point" {
            spec += &format!(":dir={direction}");
        }
        if kind == "spot" {
            spec += &format!(":cutoff={cutoff}:exponent={exponent}");
        }
        if in_camera {
            spec += ":in=camera";
        }
        let light = Self {
            kind,
            place: parsed(&place),
            direction: parsed(&direction),
            ambient: parsed(&ambient),
            diffuse: parsed(&diffuse),
            specular: parsed(&specular),
            attenuation: parsed(&attenuation),
            cutoff,
            exponent,
            in_camera,
        };
        (light, format!("--light {kind}{spec}"))
    }
}

/// The surface of the command line.
struct Optics {
    k_d: f64,
    k_s: f64,
    o_d: V,
    shininess: f64,
    roughness: f64,
    metallic: f64,
}

/// The factors of I_d and I_s, and the cosine of the highlight, of a model by its name.
fn reflected(model: &str, optics: &Optics, n: V, l: V, v: V) -> (V, V, Option<f64>) {
    if let Some(parts) = model.strip_prefix("mixed:") {
        let mut sum = ([0.0; 3], [0.0; 3]);
        for part in parts.split(',') {
            let (name, weight) = part.split_once('=').unwrap();
            let weight: f64 = weight.parse().unwrap();
            let (diffuse, specular, _) = reflected(name, optics, n, l, v);
            for channel in 0..3 {
                sum.0[channel] += weight * diffuse[channel];
                sum.1[channel] += weight * specular[channel];
            }
        }
        return (sum.0, sum.1, None);
    }
    let (n_l, n_v) = (dot(n, l), dot(n, v));
    let h = unit([0, 1, 2].map(|axis| l[axis] + v[axis]));
    let lit = n_l.max(0.0);
    let lambert = optics.o_d.map(|channel| optics.k_d * channel * lit);
    let lobe = |cosine: f64| {
        let power = libm::pow(cosine.max(0.0), optics.shininess);
        ([if n_l > 0.0 { optics.k_s * power } else { 0.0 }; 3], Some(cosine))
    };
    match model {
        "unlit" => ([0.0; 3], [0.0; 3], None),
        "lambert" => (lambert, [0.0; 3], None),
        "phong" => {
            let (specular, cosine) = lobe(2.0 * n_l * n_v - dot(l, v));
            (lambert, specular, cosine)
        }
        "blinn-phong" => {
            let (specular, cosine) = lobe(dot(n, h));
            (lambert, specular, cosine)
        }
        "retro" => {
            let (specular, cosine) = lobe(dot(v, l));
            (lambert, specular, cosine)
        }
        // Oren and Nayar 1994, by the angles.
        "oren-nayar" => {
            let variance = optics.roughness * optics.roughness;
            let a = 1.0 - 0.5 * variance / (variance + 0.33);
            let b = 0.45 * variance / (variance + 0.09);
            let (theta_i, theta_r) = (libm::acos(lit.min(1.0)), libm::acos(n_v.clamp(0.0, 1.0)));
            let (alpha, beta) = (theta_i.max(theta_r), theta_i.min(theta_r));
            let flat = |a: V, cosine: f64| [0, 1, 2].map(|axis| a[axis] - cosine * n[axis]);
            let (l_flat, v_flat) = (flat(l, n_l), flat(v, n_v));
            let lengths = (dot(l_flat, l_flat) * dot(v_flat, v_flat)).sqrt();
            let azimuth = if lengths > 0.0 { dot(l_flat, v_flat) / lengths } else { 0.0 };
            let slant = a + b * azimuth.max(0.0) * libm::sin(alpha) * libm::tan(beta);
            (lambert.map(|channel| channel * slant), [0.0; 3], None)
        }
        // glTF 2.0, appendix B, times pi.
        "microfacet" => {
            let n_h = dot(n, h);
            if n_l <= 0.0 {
                return ([0.0; 3], [0.0; 3], Some(n_h));
            }
            let n_v = n_v.max(1e-4);
            let alpha = (optics.roughness * optics.roughness).max(0.002);
            let square = alpha * alpha;
            let bell = n_h * n_h * (square - 1.0) + 1.0;
            let d = if n_h > 0.0 { square / (bell * bell) } else { 0.0 };
            let root = |cosine: f64| (cosine * cosine * (1.0 - square) + square).sqrt();
            let visibility = 0.5 / (n_l * root(n_v) + n_v * root(n_l));
            let mut terms = ([0.0; 3], [0.0; 3]);
            for channel in 0..3 {
                let metallic = optics.metallic;
                let f0 = 0.04 * (1.0 - metallic) + metallic * optics.o_d[channel];
                let fresnel = f0 + (1.0 - f0) * libm::pow(1.0 - dot(v, h), 5.0);
                terms.0[channel] = (1.0 - fresnel) * (1.0 - metallic) * lambert[channel];
                terms.1[channel] = optics.k_s * fresnel * d * visibility * n_l;
            }
            (terms.0, terms.1, Some(n_h))
        }
        other => panic!("no model {other}"),
    }
}

const MODELS: [&str; 9] = [
    "phong",
    "blinn-phong",
    "lambert",
    "retro",
    "oren-nayar",
    "unlit",
    "microfacet",
    "mixed:lambert=.3,phong=.4,oren-nayar=.2",
    "mixed:microfacet=.6,retro=.25,blinn-phong=.15",
];

#[test]
fn every_term_equals_the_equation_in_double_precision() {
    let mut random = Random(99);
    let models = [("demo:teapot", "0,1.2,0"), ("demo:plane", "0,0.5,0"), ("demo:spheres", "0,0,0")];
    let mut compared = 0;
    let folder = Folder::new();
    for round in 0..216 {
        let (model, target) = models[round % models.len()];
        let (eye, reflection) = (random.three(2.0, 6.0), MODELS[(round / 3) % MODELS.len()]);
        let (roughness, metallic) = (random.between(0.15, 1.0), random.between(0.0, 1.0));
        // Flags and scene files are two ways to say the same.
        let (material, flags) = match round % 2 {
            0 => (
                format!("[material]\nroughness = {roughness}\nmetallic = {metallic}\n"),
                String::new(),
            ),
            _ => (String::new(), format!("--roughness {roughness} --metallic {metallic}")),
        };
        let scene = format!(
            "format = \"luxel-scene\"\nversion = 1\n[[models]]\nsource = \"{model}\"\n{material}"
        );
        folder.write("scene.toml", scene);
        let lights: Vec<_> =
            (0..=random.below(3)).map(|_| LampOnTheLine::random(&mut random)).collect();
        let (color, emission, ambient) =
            (random.three(0.1, 1.0), random.three(0.0, 0.2), random.three(0.0, 0.5));
        let [ka, kd, ks] = [0; 3].map(|_| random.between(0.1, 1.0));
        let shininess = random.between(1.0, 60.0);
        let mut line = format!(
            "explain scene.toml --json --size 64x64 --samples 1 --eye {eye} --target {target} --color {color} --ka {ka} \
             --kd {kd} --ks {ks} --shininess {shininess} --emission {emission} --ambient {ambient} \
             --reflection {reflection} {flags} --environment none --at {},{}",
            16 + random.below(32),
            16 + random.below(32),
        );
        for (_, flag) in &lights {
            line += " ";
            line += flag;
        }
        let document = folder.run(line.split_whitespace()).json();
        let entry = &document["samples"][0];
        if entry["object"].is_null() {
            continue;
        }
        let info =
            luxel(&format!("info {model} --json --size 64x64 --eye {eye} --target {target}"));
        let view_matrix: Vec<f64> = info.json()["camera"]["view_from_world"]
            .as_array()
            .unwrap()
            .iter()
            .map(|number| number.as_f64().unwrap())
            .collect();
        let eye = parsed(&eye);
        // The transpose of the rotation takes directions back.
        let to_world = |a: V| {
            [0, 1, 2].map(|axis| (0..3).map(|row| view_matrix[axis * 4 + row] * a[row]).sum())
        };
        let (place, n) = (v(&entry["position"]), v(&entry["normal"]));
        let to_eye = unit([0, 1, 2].map(|axis| eye[axis] - place[axis]));
        for axis in 0..3 {
            close("view", v(&entry["view"])[axis], to_eye[axis]);
        }
        let (o_d, unlit) = (parsed(&color), reflection == "unlit");
        let mut sum = [0.0; 3];
        for channel in 0..3 {
            let own = if unlit { kd * o_d[channel] } else { parsed(&emission)[channel] };
            let scene = if unlit { 0.0 } else { parsed(&ambient)[channel] * ka * o_d[channel] };
            close("emission", v(&entry["emission"])[channel], own);
            close("scene_ambient", v(&entry["scene_ambient"])[channel], scene);
            sum[channel] += own + scene;
        }
        let told = entry["lights"].as_array().unwrap();
        assert_eq!(told.len(), lights.len());
        for (told, (light, _)) in told.iter().zip(&lights) {
            let placed = |a: V| if light.in_camera { to_world(a) } else { a };
            let direction = unit(placed(light.direction));
            let mut stands: V = placed(light.place);
            if light.in_camera {
                stands = [0, 1, 2].map(|axis| stands[axis] + eye[axis]);
            }
            let way: V = [0, 1, 2].map(|axis| stands[axis] - place[axis]);
            let directional = light.kind == "directional";
            let l = if directional { direction.map(|side| -side) } else { unit(way) };
            let d = dot(way, way).sqrt();
            let [c1, c2, c3] = light.attenuation;
            let attenuation = if directional { 1.0 } else { 1.0 / (c1 + c2 * d + c3 * d * d) };
            let cos = -dot(l, direction);
            let inside = cos >= libm::cos(light.cutoff.to_radians());
            let spot = match light.kind {
                "spot" if !inside => 0.0,
                "spot" => libm::pow(cos.max(0.0), light.exponent),
                _ => 1.0,
            };
            if light.kind == "spot" && (cos - libm::cos(light.cutoff.to_radians())).abs() < 1e-5 {
                continue;
            }
            let n_dot_l = dot(n, l);
            let optics = Optics { k_d: kd, k_s: ks, o_d, shininess, roughness, metallic };
            let (diffuse, specular, cosine) = reflected(reflection, &optics, n, l, to_eye);
            for axis in 0..3 {
                close("to_light", v(&told["to_light"])[axis], l[axis]);
            }
            assert_eq!(told["distance"].is_null(), directional);
            if !directional {
                close("distance", told["distance"].as_f64().unwrap(), d);
            }
            close("attenuation", told["attenuation"].as_f64().unwrap(), attenuation);
            close("spot", told["spot"].as_f64().unwrap(), spot);
            close("n_dot_l", told["n_dot_l"].as_f64().unwrap(), n_dot_l);
            assert_eq!(told["specular_cosine"].as_f64().is_some(), cosine.is_some());
            if let Some(cosine) = cosine {
                close("specular_cosine", told["specular_cosine"].as_f64().unwrap(), cosine);
            }
            let f = attenuation * spot;
            for channel in 0..3 {
                let dark = if unlit { 0.0 } else { 1.0 };
                let terms = [
                    ("ambient", dark * f * light.ambient[channel] * ka * o_d[channel]),
                    ("diffuse", f * light.diffuse[channel] * diffuse[channel]),
                    ("specular", f * light.specular[channel] * specular[channel]),
                ];
                for (name, expected) in terms {
                    close(&format!("{reflection} {name}"), v(&told[name])[channel], expected);
                    sum[channel] += expected;
                }
            }
            compared += 1;
        }
        for channel in 0..3 {
            close("sum", v(&entry["sum"])[channel], sum[channel]);
        }
    }
    assert!(compared > 200, "{compared}");
}
