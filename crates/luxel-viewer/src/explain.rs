//! The panel that says why the pixel under the pointer has its colour, and the vectors at its point.

use crate::probe::Explained;
use crate::ruler::number;
use crate::session::Session;
use crate::theme::{self, Theme};
use egui::{Align2, Color32, Context, FontId, RichText, Stroke, pos2, vec2};
use luxel::render::{
    Cull, ExplainedLight, ExplainedSurface, Explanation, Hidden, NEAREST_WITHIN, Seen,
    SurfaceBelow, Unlit, Unseen,
};
use luxel::scene::DVec3;

/// A term of the sum: its name, its colour in the bar, its value.
type Term = (&'static str, Color32, [f32; 3]);

/// The ledger of a pixel.
pub(crate) fn ledger(ui: &mut egui::Ui, session: &Session, explained: Option<&Explained>) {
    let Some(Explained { explanation, unseen }) = explained else {
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
    let heaviest =
        (0..).zip(&explanation.samples).max_by(|(_, a), (_, b)| a.weight.total_cmp(&b.weight));
    let hidden = heaviest.and_then(|(at, _): (usize, _)| unseen.entries.get(at));
    let surface = heaviest
        .and_then(|(_, sample)| Some((sample.weight, sample.seen.iter().find_map(Seen::surface)?)));
    let Some((weight, surface)) = surface else {
        ui.label(RichText::new("nothing covers this pixel").weak());
        note(ui, &nearest(unseen, session));
        not_seen(ui, session, hidden);
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
    let seen = heaviest.map_or(&[][..], |(_, sample)| sample.seen.as_slice());
    if seen.len() > 1 {
        ui.add_space(8.0);
        ui.label(RichText::new("Seen through it").color(theme.heading));
        for below in &seen[1..] {
            note(
                ui,
                &match below {
                    Seen::Surface(below) => format!("{}, alpha {:.2}", below.name, below.alpha),
                    Seen::Background { .. } => "the background".to_owned(),
                },
            );
        }
    }
    not_seen(ui, session, hidden);
}

/// A quiet sentence, as long as it is.
fn note(ui: &mut egui::Ui, text: &str) {
    ui.add(egui::Label::new(RichText::new(text).small().weak()).wrap());
}

/// Surfaces behind what is seen that are told of one by one.
const MOST_BEHIND: usize = 5;

/// What lies here and is not seen, and why.
fn not_seen(ui: &mut egui::Ui, session: &Session, hidden: Option<&Hidden>) {
    let Some(hidden) = hidden.filter(|hidden| **hidden != Hidden::default()) else { return };
    let what = |surface: &SurfaceBelow| {
        let part = surface.triangle.map_or_else(String::new, |number| format!(" {number}"));
        format!("{}{part}, {} away", name_of(session, surface.object), number(surface.z))
    };
    ui.add_space(8.0);
    ui.label(RichText::new("Here, but not seen").color(theme::of(ui.ctx()).heading));
    let of_flag = session.look().view().cull == Cull::Back;
    for back in &hidden.culled {
        let why = if of_flag { "back faces are left out" } else { "its material has one side" };
        note(ui, &format!("{}: shows its back, and {why}", what(back)));
    }
    for behind in hidden.behind.iter().take(MOST_BEHIND) {
        note(ui, &format!("{}: behind what is seen", what(behind)));
    }
    if let more @ 1.. = hidden.behind.len().saturating_sub(MOST_BEHIND) {
        note(ui, &format!("and {more} more behind"));
    }
}

/// What lies next to a pixel that nothing covers.
fn nearest(unseen: &Unseen, session: &Session) -> String {
    match unseen.nearest {
        Some(nearest) => {
            let [x, y] = nearest.pixel;
            let name = name_of(session, nearest.object);
            format!("nearest is {name}, {:.1} pixels away at {x}, {y}", nearest.distance)
        }
        None => format!("and nothing lies within {NEAREST_WITHIN} pixels of it"),
    }
}

fn name_of(session: &Session, object: usize) -> String {
    let node = session.objects.get(object).map(|object| object.node.index());
    let node = node.and_then(|node| session.model.scene.nodes.get(node));
    node.map(|node| node.name.clone()).unwrap_or_default()
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
    let degrees = |cosine: f32| libm::acos(f64::from(cosine.clamp(-1.0, 1.0))).to_degrees();
    let why = match light.unlit() {
        None => {
            row(ui, "diffuse", theme.terms[1], terms.diffuse.lane(0));
            row(ui, "specular", theme.terms[2], terms.specular.lane(0));
            return;
        }
        Some(Unlit::Behind) => "it stands behind the surface: N.L is not above 0".to_owned(),
        Some(Unlit::OutsideCone { cos_angle, cos_cutoff }) => format!(
            "the surface is {:.1}\u{b0} off its axis, its cone ends at {:.1}\u{b0}",
            degrees(cos_angle),
            degrees(cos_cutoff)
        ),
        Some(Unlit::OutOfRange { distance, range }) => format!(
            "it is {} away, its light ends at {}",
            number(f64::from(distance)),
            number(f64::from(range))
        ),
        Some(Unlit::AtTheSurface) => "it is at the surface itself".to_owned(),
        Some(Unlit::Dark) => "its I_d and I_s are 0".to_owned(),
        Some(_) => "the surface absorbs all of its colour".to_owned(),
    };
    note(ui, &format!("adds nothing: {why}"));
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
        // Names of highlights stand below their tips: these lie between the others.
        let aside = if name.starts_with(['R', 'H']) { vec2(0.0, 12.0) } else { vec2(0.0, 0.0) };
        let place = to + (to - from).normalized() * 10.0 + aside;
        painter.text(place, Align2::CENTER_CENTER, name, FontId::proportional(13.0), color);
    };
    let angle = |cosine: f32| libm::acos(f64::from(cosine.clamp(-1.0, 1.0))).to_degrees();
    arrow("V", theme.vectors[2], surface.view);
    let lit = || surface.lights.iter().filter(|light| light.unlit().is_none());
    for light in lit() {
        let name = format!("L {:.0}\u{b0}", angle(light.terms.n_dot_l));
        arrow(&name, theme.vectors[1], light.terms.to_light.lane(0));
    }
    // Of the light with the strongest highlight alone: one for each would hide the rest.
    let highlight = |light: &&ExplainedLight| luminance(light.terms.specular.lane(0));
    let strongest = lit().max_by(|a, b| highlight(a).total_cmp(&highlight(b)));
    if let Some(light) = strongest.filter(|light| highlight(light) > 0.0)
        && let Some(cosine) = light.terms.specular_cosine
        && let Some((name, vector)) =
            light.highlight(&surface.material.constants.reflection, surface.normal, surface.view)
    {
        arrow(&format!("{name} {:.0}\u{b0}", angle(cosine)), theme.vectors[3], vector);
    }
    arrow("N", theme.vectors[0], surface.normal);
    painter.circle(from, 4.0, theme.halo, Stroke::new(1.5, theme.accent));
}
