//! The panel that says why the pixel under the pointer has its colour, and the vectors at its point.

use crate::session::Session;
use crate::theme::{self, Theme};
use egui::{Align2, Color32, Context, FontId, RichText, Stroke, pos2, vec2};
use luxel::render::{ExplainedLight, ExplainedSurface, Explanation, Seen, Unlit};
use luxel::scene::DVec3;

/// A term of the sum: its name, its colour in the bar, its value.
type Term = (&'static str, Color32, [f32; 3]);

/// The ledger of a pixel.
pub(crate) fn ledger(ui: &mut egui::Ui, explanation: Option<&Explanation>) {
    let Some(explanation) = explanation else {
        ui.label(RichText::new("Point at something.").weak());
        return;
    };
    let [r, g, b, _] = explanation.rgba8;
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(24.0, 24.0), egui::Sense::hover());
        ui.painter().rect_filled(rect, 4, Color32::from_rgb(r, g, b));
        let [x, y] = explanation.pixel;
        ui.monospace(format!("{r:3} {g:3} {b:3}"));
        ui.label(RichText::new(format!("pixel {x}, {y}")).small().weak());
    });
    let heaviest = explanation.samples.iter().max_by(|a, b| a.weight.total_cmp(&b.weight));
    let surface = heaviest.and_then(|sample| {
        sample.seen.iter().find_map(|seen| match seen {
            Seen::Surface(surface) => Some((sample.weight, surface)),
            Seen::Background { .. } => None,
        })
    });
    let Some((weight, surface)) = surface else {
        ui.label(RichText::new("nothing is here").weak());
        return;
    };
    let what = match surface.triangle {
        Some(triangle) => format!("{}, triangle {triangle}", surface.name),
        None => surface.name.clone(),
    };
    ui.label(what);
    if weight < 1.0 {
        let share = format!("{:.0} % of the pixel's samples", weight * 100.0);
        ui.label(RichText::new(share).small().weak());
    }
    ui.add_space(8.0);
    let theme = theme::of(ui.ctx());
    let terms = terms(surface, theme);
    bar(ui, &terms);
    ui.add_space(4.0);
    for (name, color, value) in &terms {
        if *value != [0.0; 3] {
            row(ui, name, *color, *value);
        }
    }
    row(ui, "sum", theme.accent, surface.sum);
    for light in &surface.lights {
        ui.add_space(8.0);
        one_light(ui, light);
    }
}

fn terms(surface: &ExplainedSurface, theme: &Theme) -> [Term; 5] {
    let sum =
        |of: fn(&ExplainedLight) -> [f32; 3]| {
            surface.lights.iter().map(of).fold([0.0; 3], |all, one| {
                std::array::from_fn(|channel| all[channel] + one[channel])
            })
        };
    let of_lights = sum(|light| light.terms.ambient.lane(0));
    let ambient = std::array::from_fn(|at| surface.scene_ambient[at] + of_lights[at]);
    [
        ("ambient", theme.terms[0], ambient),
        ("diffuse", theme.terms[1], sum(|light| light.terms.diffuse.lane(0))),
        ("specular", theme.terms[2], sum(|light| light.terms.specular.lane(0))),
        ("emission", theme.terms[3], surface.emission),
        ("environment", theme.terms[4], surface.environment),
    ]
}

fn luminance([r, g, b]: [f32; 3]) -> f32 {
    // ITU-R BT.709.
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// The terms as parts of a bar, by their luminance.
fn bar(ui: &mut egui::Ui, terms: &[Term]) {
    let width = ui.available_width();
    let (rect, _) = ui.allocate_exact_size(vec2(width, 12.0), egui::Sense::hover());
    ui.painter().rect_filled(rect, 2, theme::of(ui.ctx()).line);
    let all: f32 = terms.iter().map(|(_, _, value)| luminance(*value).max(0.0)).sum();
    let mut left = rect.left();
    for (_, color, value) in terms {
        let part = if all > 0.0 { luminance(*value).max(0.0) / all * width } else { 0.0 };
        let part = egui::Rect::from_min_size(pos2(left, rect.top()), vec2(part, rect.height()));
        ui.painter().rect_filled(part, 0, *color);
        left = part.right();
    }
}

fn row(ui: &mut egui::Ui, name: &str, color: Color32, value: [f32; 3]) {
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(8.0, 8.0), egui::Sense::hover());
        ui.painter().rect_filled(rect, 2, color);
        ui.label(name);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let [r, g, b] = value;
            ui.monospace(format!("{r:.3} {g:.3} {b:.3}"));
        });
    });
}

fn one_light(ui: &mut egui::Ui, light: &ExplainedLight) {
    let (terms, theme) = (&light.terms, theme::of(ui.ctx()));
    ui.label(RichText::new(&light.name).color(theme.heading));
    let mut factors = vec![format!("N.L {:.3}", terms.n_dot_l)];
    if let Some(cosine) = terms.specular_cosine {
        factors.push(format!("cos {cosine:.3}"));
    }
    if let Some(distance) = terms.distance {
        factors.push(format!("d {distance:.3}"));
        factors.push(format!("att {:.3}", terms.attenuation));
    }
    ui.label(RichText::new(factors.join("   ")).monospace().size(11.0).weak());
    let why = match light.unlit() {
        None => {
            row(ui, "diffuse", theme.terms[1], terms.diffuse.lane(0));
            row(ui, "specular", theme.terms[2], terms.specular.lane(0));
            return;
        }
        Some(Unlit::Behind) => "adds nothing: it stands behind the surface",
        Some(Unlit::OutsideCone { .. }) => "adds nothing: outside of its cone",
        Some(Unlit::OutOfRange { .. }) => "adds nothing: out of its range",
        Some(Unlit::AtTheSurface) => "adds nothing: it is at the surface itself",
        Some(Unlit::Dark) => "adds nothing: it is dark",
        Some(_) => "adds nothing: the surface absorbs it",
    };
    ui.label(RichText::new(why).small().weak());
}

/// N, V and the L of each light that adds something, drawn at the point in the picture.
pub(crate) fn vectors(context: &Context, session: &Session, explanation: &Explanation) {
    let surface =
        explanation.samples.iter().flat_map(|sample| &sample.seen).find_map(|seen| match seen {
            Seen::Surface(surface) => Some(surface),
            Seen::Background { .. } => None,
        });
    let Some(surface) = surface else { return };
    /// Points of the window for a vector across the view.
    const LENGTH: f64 = 72.0;
    let layer = egui::LayerId::background();
    let painter = context.layer_painter(layer);
    let theme = theme::of(context);
    let scale = f64::from(context.pixels_per_point());
    let [x, y] = explanation.pixel.map(|side| (f64::from(side) + 0.5) / scale);
    let from = pos2(x as f32, y as f32);
    let rotation = session.state.view_from_world();
    let arrow = |name: &str, color: Color32, [x, y, z]: [f32; 3]| {
        let vector = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
        let in_view = rotation.transform_vector3(vector) * LENGTH;
        // The window's y points down.
        let to = from + vec2(in_view.x as f32, -in_view.y as f32);
        let halo = Stroke::new(4.0, theme.halo);
        painter.line_segment([from, to], halo);
        painter.line_segment([from, to], Stroke::new(2.0, color));
        painter.circle_filled(to, 3.0, color);
        let place = to + (to - from).normalized() * 10.0;
        painter.text(place, Align2::CENTER_CENTER, name, FontId::proportional(13.0), color);
    };
    arrow("V", theme.vectors[2], surface.view);
    for light in surface.lights.iter().filter(|light| light.unlit().is_none()) {
        arrow("L", theme.vectors[1], light.terms.to_light.lane(0));
    }
    arrow("N", theme.vectors[0], surface.normal);
    painter.circle(from, 4.0, theme.halo, Stroke::new(1.5, theme.accent));
}
