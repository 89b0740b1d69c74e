//! How light falls off: with distance, from the axis of a cone, in fog.

use super::point::{arriving, lamp, let_through};
use crate::GalleryError;
use crate::chapter::{Chapter, Figure};
use crate::shot::Studio;
use crate::svg::{Anchor, Axes, Ink, Svg};
use luxel::lighting::{Attenuation, Cone, Fog, FogLaw, Light, LightKind};
use std::f64::consts::PI;

/// A curve with its label, placed at a value of x and shifted by so many pixels.
struct Curve {
    name: String,
    label: (f64, [f64; 2], Anchor),
    of: Box<dyn Fn(f64) -> f64>,
}

fn curve(
    name: impl Into<String>,
    label: (f64, [f64; 2], Anchor),
    of: impl Fn(f64) -> f64 + 'static,
) -> Curve {
    Curve { name: name.into(), label, of: Box::new(of) }
}

pub(crate) fn chapter(_: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("falloff", "How light falls off");
    chapter.text(
        "The power of a lamp spreads over spheres of area 4 &pi; r<sup>2</sup>: at twice the \
         distance a quarter arrives. The other laws are those of fixed-function graphics and of \
         glTF: the light's <code>attenuation</code>, its cone and the fog, on a white matte \
         surface that faces the light.",
    );
    let mut figures = vec![spreading(&mut chapter)];
    let at = |light: Light| move |distance: f64| arriving(&light, distance, 0.0)[0];
    // A lamp of power 1 sends 1 / (4 pi) into each direction.
    let power = Light {
        attenuation: Attenuation::INVERSE_SQUARE,
        ..Light::new(LightKind::Point, [(0.25 / PI) as f32; 3])
    };
    figures.push(plot(
        &mut chapter,
        "falloff-sphere",
        "The light of a lamp of power 1: 1/(4 &pi; r<sup>2</sup>). It is unbounded near the lamp.",
        "Plot: a curve that falls steeply from the left and flattens.",
        Scale {
            x: [0.25, 3.0],
            y: [0.0, 0.5],
            x_ticks: &[(0.5, "0.5"), (1.0, "1"), (2.0, "2"), (3.0, "3")],
            y_ticks: &[(0.0, "0"), (0.25, "0.25"), (0.5, "0.5")],
            names: ["distance r", "light that arrives"],
        },
        vec![curve("1/(4 π r²)", (0.62, [10.0, 0.0], Anchor::Start), move |distance| {
            arriving(&power, distance, 0.0)[2]
        })],
    ));
    let law = |coefficients: [f32; 3]| at(lamp(Attenuation::new(coefficients)));
    let cut = Attenuation { limit: 1.0, ..Attenuation::INVERSE_SQUARE };
    let ending = Attenuation { range: Some(3.0), ..Attenuation::NONE };
    let laws = vec![
        curve("1/d²", (0.88, [8.0, 0.0], Anchor::Start), law([0.0, 0.0, 1.0])),
        curve("1/(1 + d²)", (1.25, [-6.0, 16.0], Anchor::End), law([1.0, 0.0, 1.0])),
        curve("1/(1 + d)", (3.15, [0.0, -8.0], Anchor::Start), law([1.0, 1.0, 0.0])),
        curve("cut at 1", (0.06, [0.0, -8.0], Anchor::Start), at(lamp(cut))),
        curve("1, range 3", (2.45, [8.0, 0.0], Anchor::Start), at(lamp(ending))),
    ];
    figures.push(plot(
        &mut chapter,
        "falloff-attenuation",
        "1/(c1 + c2 d + c3 d<sup>2</sup>) for some coefficients, as OpenGL has it; cut at 1, as Foley \
         has it; and glTF's window, which ends a light at its range.",
        "Plot: five curves over the distance, from steep to constant.",
        Scale {
            x: [0.0, 4.0],
            y: [0.0, 1.6],
            x_ticks: &[(0.0, "0"), (1.0, "1"), (2.0, "2"), (3.0, "3"), (4.0, "4")],
            y_ticks: &[(0.0, "0"), (0.5, "0.5"), (1.0, "1"), (1.5, "1.5")],
            names: ["distance d", "attenuation"],
        },
        laws,
    ));
    let cone = |cone: Cone| {
        let light = Light::new(LightKind::Spot(cone), [1.0; 3]);
        move |angle: f64| arriving(&light, 1.0, angle)[1]
    };
    let cosine = |degrees: f64| libm::cos(degrees.to_radians()) as f32;
    let spot = |exponent: f32| Cone::Exponent { cos_cutoff: cosine(40.0), exponent };
    let smooth = Cone::Smooth { cos_inner: cosine(10.0), cos_outer: cosine(50.0) };
    figures.push(plot(
        &mut chapter,
        "falloff-cone",
        "Spot lights over the angle from their axis: a cutoff of 40 degrees with exponents, as in \
         OpenGL 1.x, and glTF's soft cone from 10 to 50 degrees.",
        "Plot: three curves that end abruptly at 40 degrees, and one that runs out softly at 50.",
        Scale {
            x: [0.0, 60.0],
            y: [0.0, 1.1],
            x_ticks: &[(0.0, "0°"), (20.0, "20°"), (40.0, "40°"), (60.0, "60°")],
            y_ticks: &[(0.0, "0"), (0.5, "0.5"), (1.0, "1")],
            names: ["angle from the axis", "brightness"],
        },
        vec![
            curve("exponent 0", (33.0, [0.0, -7.0], Anchor::Middle), cone(spot(0.0))),
            curve("4", (36.0, [5.0, -6.0], Anchor::Start), cone(spot(4.0))),
            curve("30", (17.0, [-6.0, 12.0], Anchor::End), cone(spot(30.0))),
            curve("glTF", (44.0, [6.0, -6.0], Anchor::Start), cone(smooth)),
        ],
    ));
    let fog = |law: FogLaw| {
        let fog = Fog { color: [1.0; 3], law };
        move |distance: f64| let_through(&fog, distance)
    };
    figures.push(plot(
        &mut chapter,
        "falloff-fog",
        "Depth cueing from s_f = 1 at z = 2 to s_b = 0.2 at z = 8, and fog of density 0.25: the part \
         s of the light that is let through.",
        "Plot: a bent straight line, an exponential and a bell-shaped curve over the distance.",
        Scale {
            x: [0.0, 10.0],
            y: [0.0, 1.1],
            x_ticks: &[(0.0, "0"), (2.0, "2"), (5.0, "5"), (8.0, "8"), (10.0, "10")],
            y_ticks: &[(0.0, "0"), (0.5, "0.5"), (1.0, "1")],
            names: ["distance z along the view", "s"],
        },
        vec![
            curve(
                "depth cue",
                (5.6, [8.0, -6.0], Anchor::Start),
                fog(FogLaw::DepthCue { near: 2.0, far: 8.0, front: 1.0, back: 0.2 }),
            ),
            curve(
                "exp",
                (1.2, [-6.0, 14.0], Anchor::End),
                fog(FogLaw::Exponential { density: 0.25 }),
            ),
            curve(
                "exp²",
                (3.0, [9.0, 0.0], Anchor::Start),
                fog(FogLaw::ExponentialSquared { density: 0.25 }),
            ),
        ],
    ));
    chapter.figures(figures);
    Ok(chapter)
}

struct Scale<'a> {
    x: [f64; 2],
    y: [f64; 2],
    x_ticks: &'a [(f64, &'a str)],
    y_ticks: &'a [(f64, &'a str)],
    names: [&'a str; 2],
}

/// Points of a curve.
const POINTS: i32 = 320;

fn plot(
    chapter: &mut Chapter,
    name: &str,
    caption: &str,
    alt: &str,
    scale: Scale<'_>,
    curves: Vec<Curve>,
) -> Figure {
    let mut svg = Svg::new(320, 240);
    let axes = Axes { frame: [48.0, 34.0, 304.0, 192.0], x: scale.x, y: scale.y };
    axes.draw(&mut svg, scale.x_ticks, scale.y_ticks, scale.names);
    let [from, to] = scale.x;
    for (curve, ink) in curves.iter().zip(Ink::SERIES) {
        // From the point where the curve enters the plot.
        let values = (0..=POINTS).map(|step| {
            let x = from + (to - from) * f64::from(step) / f64::from(POINTS);
            [x, (curve.of)(x)]
        });
        let mut run: Vec<[f64; 2]> = Vec::new();
        for value in values {
            if value[1] <= scale.y[1] * 1.001 && !(value[0] == 0.0 && value[1] == 0.0) {
                run.push(value);
            } else {
                run.clear();
            }
        }
        axes.curve(&mut svg, ink, 2.0, &run);
    }
    for (curve, ink) in curves.iter().zip(Ink::SERIES) {
        let (x, [right, down], anchor) = curve.label;
        let [left, top] = axes.at(x, (curve.of)(x));
        svg.text(ink, anchor, [left + right, top + down], &curve.name);
    }
    let size = svg.size;
    chapter.file(&format!("{name}.svg"), svg.finish(name), size, alt, caption)
}

/// A lamp and spheres around it, pieces of which grow as the square of the distance.
fn spreading(chapter: &mut Chapter) -> Figure {
    let mut svg = Svg::new(320, 240);
    let lamp_at = [30.0, 128.0];
    let half_angle = 20.0_f64.to_radians();
    let (sin, cos) = libm::sincos(half_angle);
    let unit = 84.0;
    let far = 3.0 * unit;
    for side in [-1.0, 1.0] {
        let end = [lamp_at[0] + far * cos, lamp_at[1] + side * far * sin];
        svg.line(Ink::Amber, 1.0, &[lamp_at, end]);
    }
    let power = Light {
        attenuation: Attenuation::INVERSE_SQUARE,
        ..Light::new(LightKind::Point, [(0.25 / PI) as f32; 3])
    };
    let unit_light = arriving(&power, 1.0, 0.0)[2];
    for distance in [1.0, 2.0, 3.0] {
        let arc: Vec<_> = (-20..=20)
            .map(|step| {
                let (sin, cos) = libm::sincos(half_angle * f64::from(step) / 20.0);
                [lamp_at[0] + unit * distance * cos, lamp_at[1] + unit * distance * sin]
            })
            .collect();
        svg.line(Ink::Blue, 3.0, &arc);
        let [x, y] = arc[0];
        svg.text(Ink::Quiet, Anchor::Middle, [x - 4.0, y - 9.0], &format!("r = {distance}"));
        let [x, y] = arc[arc.len() - 1];
        let arrives = arriving(&power, distance, 0.0)[2];
        let share = format!("1/{:.0}", unit_light / arrives);
        svg.text(Ink::Blue, Anchor::Middle, [x - 4.0, y + 19.0], &share);
    }
    svg.dot(Ink::Amber, 7.0, lamp_at);
    let size = svg.size;
    let bytes = svg.finish("The power of a lamp spreads over spheres");
    let alt = "A lamp and three arcs at distances 1, 2 and 3 within one cone; they get 1, 1/4 and 1/9 \
               of the light.";
    let caption = "The same power on areas that grow with r<sup>2</sup>.";
    chapter.file("falloff-spheres.svg", bytes, size, alt, caption)
}
