//! Lobes of reflection over the angle of the eye.

use super::point::{mirrored, sent};
use crate::GalleryError;
use crate::chapter::{Chapter, Figure};
use crate::shot::Studio;
use crate::svg::{Anchor, Ink, Svg};
use luxel::lighting::{Environment, Material, Reflection};

/// The direction of the light: degrees from the normal, to the left.
const LIGHT: f64 = -45.0;

/// A curve of a plot.
struct Lobe {
    name: String,
    values: Vec<[f64; 2]>,
}

/// The reflection over all angles of the eye.
fn lobe(name: impl Into<String>, of: impl Fn(f64) -> f64) -> Lobe {
    let degrees = (-180..=180).map(|step| f64::from(step) * 0.5);
    Lobe { name: name.into(), values: degrees.map(|angle| [angle, of(angle)]).collect() }
}

fn material(reflection: Reflection) -> Material {
    Material { reflection, diffuse: [1.0; 3], k_d: 0.4, k_s: 0.6, ..Material::default() }
}

pub(crate) fn chapter(_: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("lobes", "Lobes of reflection");
    chapter.text(
        "A light of intensity 1 falls from the left at 45 degrees on a point of a surface. How far a \
         curve is from the point, in the direction of the eye, is how much light goes there. All \
         values are those of the equation that draws the pictures.",
    );
    let glossy = |reflection: Reflection, shininess: f32| {
        let material = Material { shininess, ..material(reflection) };
        move |eye: f64| sent(&material, LIGHT, eye)
    };
    let matte = |eye: f64| {
        let lambert = Material { k_d: 1.0, ..material(Reflection::Lambert) };
        sent(&lambert, LIGHT, eye)
    };
    let family = |reflection: Reflection| -> Vec<Lobe> {
        let lobe = |n: f32| lobe(format!("n = {n}"), glossy(reflection.clone(), n));
        [2.0, 8.0, 32.0, 128.0].map(lobe).into_iter().collect()
    };
    let mut figures = vec![
        drawn(
            &mut chapter,
            "lambert",
            "Lambert: a matte surface sends the same to every eye.",
            "A half circle around the point.",
            1.0,
            vec![lobe("", matte)],
        ),
        drawn(
            &mut chapter,
            "phong",
            "Phong: k_s (R.V)<sup>n</sup> about the direction of mirroring, on k_d = 0.4 of matte: \
             the larger n, the narrower.",
            "A half circle with a lobe to the upper right, narrower the larger n is.",
            1.0,
            family(Reflection::Phong),
        ),
        drawn(
            &mut chapter,
            "blinn-phong",
            "Blinn-Phong: (N.H)<sup>n</sup>. H turns half as fast as R, so the same n is wider, and at \
             flat angles the lobe is not as round as Phong's.",
            "A half circle with a lobe to the upper right, wider than Phong's for the same n.",
            1.0,
            family(Reflection::BlinnPhong),
        ),
    ];
    let rough = [0.0, 0.3, 0.6, 1.0].map(|sigma| {
        let material = Material { k_d: 1.0, roughness: sigma, ..material(Reflection::OrenNayar) };
        lobe(format!("σ = {sigma}"), move |eye| sent(&material, LIGHT, eye))
    });
    figures.push(drawn(
        &mut chapter,
        "oren-nayar",
        "Oren-Nayar: rough matte surfaces send more back to where the light is from. σ = 0 is Lambert.",
        "A half circle that with growing roughness shrinks on the right and bulges to the left.",
        1.0,
        rough.into_iter().collect(),
    ));
    let facets = [0.5, 0.6, 0.7, 0.85].map(|roughness| {
        let metal =
            Material { k_s: 1.0, metallic: 1.0, roughness, ..material(Reflection::Microfacet) };
        lobe(format!("r = {roughness}"), move |eye| sent(&metal, LIGHT, eye))
    });
    figures.push(drawn(
        &mut chapter,
        "microfacet",
        "Microfacets (GGX), a white metal of roughness r: the lobe leans beyond the direction of \
         mirroring, the more the rougher.",
        "Lobes to the upper right, thick and leaning outwards for rough surfaces.",
        6.0,
        facets.into_iter().collect(),
    ));
    let retro = Material { shininess: 24.0, ..material(Reflection::Retro) };
    figures.push(drawn(
        &mut chapter,
        "retro",
        "Retro-reflection: k_s (V.L)<sup>n</sup>, n = 24, back to where the light is from.",
        "A half circle with a lobe to the upper left, towards the light.",
        1.0,
        vec![lobe("", move |eye| sent(&retro, LIGHT, eye))],
    ));
    let parts =
        vec![(Reflection::Lambert, 0.6), (Reflection::Phong, 0.5), (Reflection::Retro, 0.4)];
    let mixed = Material { shininess: 24.0, ..material(Reflection::mixed(parts)) };
    figures.push(drawn(
        &mut chapter,
        "mixed",
        "Mixed: 0.6 Lambert + 0.5 Phong + 0.4 retro, a weighted sum of models.",
        "A half circle with two lobes, one to the upper right and one to the upper left.",
        1.0,
        vec![lobe("", move |eye| sent(&mixed, LIGHT, eye))],
    ));
    let mirror = Material { k_s: 1.0, ..material(Reflection::Mirror) };
    let studio = Environment::Studio { up: [0.0, 1.0, 0.0] };
    figures.push(drawn(
        &mut chapter,
        "mirror",
        "An ideal mirror has no lobe: a point of light shows in single directions only. What it sends \
         is what stands in the direction of mirroring, here luxel's studio, bright above.",
        "A curve that is largest straight up and small at the sides.",
        1.25,
        vec![lobe("", move |eye| mirrored(&mirror, &studio, eye))],
    ));
    chapter.figures(figures);
    Ok(chapter)
}

const WIDTH: u32 = 320;
const HEIGHT: u32 = 216;
const POINT: [f64; 2] = [160.0, 186.0];
/// Pixels from the point to the largest value.
const REACH: f64 = 138.0;

/// A place at an angle to the normal and a distance from the point.
fn polar(degrees: f64, distance: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    [POINT[0] + distance * sin, POINT[1] - distance * cos]
}

fn drawn(
    chapter: &mut Chapter,
    name: &str,
    caption: &str,
    alt: &str,
    largest: f64,
    lobes: Vec<Lobe>,
) -> Figure {
    let mut svg = Svg::new(WIDTH, HEIGHT);
    for part in [0.5, 1.0] {
        let ring: Vec<_> =
            (-90..=90).step_by(3).map(|angle| polar(f64::from(angle), REACH * part)).collect();
        svg.line(Ink::Line, 1.0, &ring);
        let value = format!("{}", largest * part);
        svg.note(Ink::Quiet, Anchor::Middle, [POINT[0] + REACH * part, POINT[1] + 16.0], &value);
    }
    svg.line(Ink::Line, 1.0, &[POINT, polar(0.0, REACH)]);
    svg.line(Ink::Quiet, 1.5, &[[10.0, POINT[1]], [310.0, POINT[1]]]);
    if name != "mirror" {
        svg.dashed(Ink::Line, 1.0, &[POINT, polar(-LIGHT, REACH)]);
        svg.arrow(Ink::Amber, 1.5, polar(LIGHT, REACH + 22.0), polar(LIGHT, REACH - 28.0));
        let [x, y] = polar(LIGHT, REACH + 22.0);
        svg.text(Ink::Amber, Anchor::End, [x - 5.0, y + 4.0], "L");
        let [x, y] = polar(-LIGHT, REACH);
        svg.note(Ink::Quiet, Anchor::Start, [x + 4.0, y - 2.0], "R");
    }
    let [x, y] = polar(0.0, REACH);
    svg.note(Ink::Quiet, Anchor::Middle, [x, y - 6.0], "N");
    let inks = [Ink::Blue, Ink::Teal, Ink::Violet, Ink::Pink];
    for (lobe, ink) in lobes.iter().zip(inks) {
        let at =
            |[angle, value]: [f64; 2]| polar(angle, value.min(largest * 1.1) / largest * REACH);
        let points: Vec<_> = lobe.values.iter().map(|&value| at(value)).collect();
        svg.line(ink, 2.0, &points);
    }
    for (place, (lobe, ink)) in lobes.iter().zip(inks).enumerate() {
        svg.text(ink, Anchor::End, [312.0, 20.0 + 16.0 * place as f64], &lobe.name);
    }
    let size = svg.size;
    let title = format!("Lobes of reflection: {name}");
    let alt = format!("Polar plot. {alt}");
    let file = format!("lobes-{name}.svg");
    chapter.file(&file, svg.finish(&title), size, &alt, caption)
}
