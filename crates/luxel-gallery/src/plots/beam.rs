//! Why a slanting beam lights less: its cross-section.

use super::point::sent;
use crate::GalleryError;
use crate::chapter::Chapter;
use crate::shot::Studio;
use crate::svg::{Anchor, Axes, Ink, Svg};
use luxel::lighting::{Material, Reflection};

/// The angles of the light in the drawings, in degrees from the normal.
const ANGLES: [f64; 4] = [0.0, 30.0, 60.0, 75.0];

/// A white matte surface.
fn white() -> Material {
    Material { reflection: Reflection::Lambert, diffuse: [1.0; 3], ..Material::default() }
}

pub(crate) fn chapter(_: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("beam", "Lambert's law: the cross-section of a beam");
    chapter.text(
        "A beam of a given width carries a given power. At perpendicular incidence it lights a \
         patch as wide as itself; at an angle &theta; the patch is 1/cos &theta; as wide, and \
         each part of it receives cos &theta; = N.L as much. The numbers come from luxel's \
         equation, for a white matte surface.",
    );
    let mut svg = Svg::new(660, 190);
    for (place, angle) in ANGLES.into_iter().enumerate() {
        beam(&mut svg, 86.0 + 160.0 * place as f64, angle);
    }
    let size = svg.size;
    let alt = "Four diagrams: beams of one width at 0, 30, 60 and 75 degrees, lighting wider and wider \
               patches ever more weakly.";
    let bytes = svg.finish("The cross-section of a beam");
    let caption = "One beam at four angles: the patch that it lights, and the intensity there.";
    let beams = chapter.file("beam.svg", bytes, size, alt, caption);
    chapter.figures(vec![beams]);

    let mut svg = Svg::new(420, 240);
    let axes = Axes { frame: [48.0, 34.0, 400.0, 192.0], x: [0.0, 180.0], y: [0.0, 1.0] };
    let x_ticks = [(0.0, "0°"), (45.0, "45°"), (90.0, "90°"), (135.0, "135°"), (180.0, "180°")];
    let y_ticks = [(0.0, "0"), (0.5, "0.5"), (1.0, "1")];
    let names = ["angle of the light to the normal", "I"];
    axes.draw(&mut svg, &x_ticks, &y_ticks, names);
    let lambert = white();
    let curve: Vec<_> =
        (0..=180).map(f64::from).map(|angle| [angle, sent(&lambert, -angle, 20.0)]).collect();
    axes.curve(&mut svg, Ink::Blue, 2.0, &curve);
    for angle in ANGLES {
        svg.dot(Ink::Amber, 3.5, axes.at(angle, sent(&lambert, -angle, 20.0)));
    }
    let [x, y] = axes.at(64.0, 0.5);
    svg.text(Ink::Blue, Anchor::Start, [x + 6.0, y], "k_d O_d max(N.L, 0)");
    let [x, y] = axes.at(135.0, 0.0);
    svg.note(Ink::Quiet, Anchor::Middle, [x, y - 8.0], "light from behind");
    let size = svg.size;
    let alt = "Plot: a cosine that falls from 1 at 0 degrees to 0 at 90 and stays there.";
    let bytes = svg.finish("Lambert's law over the angle of the light");
    let caption = "The same over all angles; from 90 degrees on the light is behind the surface.";
    let plot = chapter.file("beam-cosine.svg", bytes, size, alt, caption);
    chapter.figures(vec![plot]);
    Ok(chapter)
}

fn beam(svg: &mut Svg, middle: f64, angle: f64) {
    const FLOOR: f64 = 142.0;
    const HALF: f64 = 17.0;
    let (sin, cos) = libm::sincos(angle.to_radians());
    let half_patch = HALF / cos;
    // Slanting beams are cut short, or they would reach into their neighbours.
    let reach = (58.0 / sin.max(0.05)).min(104.0);
    let source = |aside: f64| {
        let foot = [middle + aside, FLOOR];
        [foot[0] - sin * reach, foot[1] - cos * reach]
    };
    let corners = [
        [middle - half_patch, FLOOR],
        source(-half_patch),
        source(half_patch),
        [middle + half_patch, FLOOR],
    ];
    svg.area(Ink::Amber, 0.18, &corners);
    for aside in [-half_patch, 0.0, half_patch] {
        svg.arrow(Ink::Amber, 1.2, source(aside), [middle + aside, FLOOR - 1.0]);
    }
    svg.line(Ink::Quiet, 1.5, &[[middle - 72.0, FLOOR], [middle + 72.0, FLOOR]]);
    svg.line(Ink::Blue, 4.0, &[[middle - half_patch, FLOOR], [middle + half_patch, FLOOR]]);
    svg.dashed(Ink::Line, 1.0, &[[middle, FLOOR], [middle, 34.0]]);
    svg.text(Ink::Text, Anchor::Middle, [middle, 18.0], &format!("θ = {angle:.0}°"));
    let intensity = sent(&white(), -angle, 0.0);
    svg.note(Ink::Blue, Anchor::Middle, [middle, 163.0], &format!("width {:.2}", 1.0 / cos));
    svg.note(Ink::Text, Anchor::Middle, [middle, 180.0], &format!("I = {intensity:.3}"));
}
