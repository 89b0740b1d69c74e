//! The panel that says why the pixel under the pointer has its colour, and the vectors at its point.

use crate::ledger::{self, term_color, value_row};
use crate::probe::Explained;
use crate::ruler::number;
use crate::session::Session;
use crate::theme::{self, Theme};
use egui::{Color32, Context, FontId, RichText, Stroke, pos2, vec2};
use luxel::render::{
    ExplainedLight, ExplainedSurface, Explanation, Hidden, NEAREST_WITHIN, Seen, SurfaceBelow,
    Unseen,
};
use luxel::report::{Hint, LedgerLine, TermKind};
use luxel::scene::DVec3;

/// A term of the sum: its name, what it is, its value.
type Term = (&'static str, TermKind, [f32; 3]);

/// The ledger of a pixel: its terms as parts of a bar, and the equation with its numbers below.
pub(crate) fn ledger(
    ui: &mut egui::Ui,
    session: &Session,
    explained: Option<&Explained>,
    equation: Option<&[LedgerLine]>,
) {
    let Some(explained) = explained else {
        ui.label(RichText::new("Point at something.").weak());
        return;
    };
    let Explained { explanation, unseen } = explained;
    let [r, g, b, _] = explanation.rgba8;
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(24.0, 24.0), egui::Sense::hover());
        ui.painter().rect_filled(rect, 4, Color32::from_rgb(r, g, b));
        let [x, y] = explanation.pixel;
        ui.monospace(format!("{r:3} {g:3} {b:3}"));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(RichText::new(format!("pixel {x}, {y}")).small().weak());
        });
    });
    let heaviest = explained.heaviest();
    let hidden = heaviest.and_then(|(at, _)| unseen.entries.get(at));
    let surface = explained.surface();
    let (Some((_, sample)), Some(surface)) = (heaviest, surface) else {
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
    if sample.weight < 1.0 {
        let share = format!("{:.0} % of the pixel's samples", sample.weight * 100.0);
        ui.label(RichText::new(share).small().weak());
    }
    ui.add_space(8.0);
    let theme = theme::of(ui.ctx());
    let terms = terms(surface);
    bar(ui, &terms);
    ui.add_space(4.0);
    ui.spacing_mut().item_spacing.y = 2.0;
    for (name, kind, value) in &terms {
        if *value != [0.0; 3] {
            value_row(ui, Some(term_color(*kind, theme)), name, *value);
        }
    }
    value_row(ui, Some(theme.accent), "sum", surface.sum);
    ui.spacing_mut().item_spacing.y = 4.0;
    if let Some(lines) = equation {
        ui.add_space(8.0);
        ui.label(RichText::new("The equation here").color(theme.heading));
        ledger::equation(ui, lines);
    }
    if sample.seen.len() > 1 {
        ui.add_space(8.0);
        ui.label(RichText::new("Seen through it").color(theme.heading));
        for below in &sample.seen[1..] {
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
    let why = match Hint::of_culling(session.look().view().cull) {
        Hint::ViewCullsBackFaces => "back faces are left out",
        _ => "its material has one side",
    };
    for back in &hidden.culled {
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

fn terms(surface: &ExplainedSurface) -> [Term; 5] {
    let sum =
        |of: fn(&ExplainedLight) -> [f32; 3]| {
            surface.lights.iter().map(of).fold([0.0; 3], |all, one| {
                std::array::from_fn(|channel| all[channel] + one[channel])
            })
        };
    let of_lights = sum(|light| light.terms.ambient.lane(0));
    let ambient = std::array::from_fn(|at| surface.scene_ambient[at] + of_lights[at]);
    [
        ("ambient", TermKind::Ambient, ambient),
        ("diffuse", TermKind::Diffuse, sum(|light| light.terms.diffuse.lane(0))),
        ("specular", TermKind::Specular, sum(|light| light.terms.specular.lane(0))),
        ("emission", TermKind::Emission, surface.emission),
        ("environment", TermKind::Environment, surface.environment),
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
    let theme = theme::of(ui.ctx());
    ui.painter().rect_filled(rect, 2, theme.line);
    let all: f32 = terms.iter().map(|(_, _, value)| luminance(*value).max(0.0)).sum();
    let mut left = rect.left();
    for (_, kind, value) in terms {
        let part = if all > 0.0 { luminance(*value).max(0.0) / all * width } else { 0.0 };
        let part = egui::Rect::from_min_size(pos2(left, rect.top()), vec2(part, rect.height()));
        ui.painter().rect_filled(part, 0, term_color(*kind, theme));
        left = part.right();
    }
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
    // Names come at last, so that no line runs over them.
    let mut tips: Vec<(String, Color32, egui::Pos2)> = Vec::new();
    let mut arrow = |name: &str, color: Color32, [x, y, z]: [f32; 3]| {
        let vector = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
        let in_view = rotation.transform_vector3(vector) * LENGTH;
        // The window's y points down.
        let to = from + vec2(in_view.x as f32, -in_view.y as f32);
        let halo = Stroke::new(4.0, theme.halo);
        painter.line_segment([from, to], halo);
        painter.line_segment([from, to], Stroke::new(2.0, color));
        painter.circle_filled(to, 3.0, color);
        tips.push((name.to_owned(), color, to));
    };
    let angle = |cosine: f32| libm::acos(f64::from(cosine.clamp(-1.0, 1.0))).to_degrees();
    let dot = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f32>();
    let n_dot_v = dot(surface.normal, surface.view);
    arrow(&format!("V {:.0}\u{b0}", angle(n_dot_v)), theme.vectors[2], surface.view);
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
    names(&painter, theme, from, tips);
}

/// The names of vectors from a point, each beyond its tip, or above or below that, where no other name is.
fn names(
    painter: &egui::Painter,
    theme: &Theme,
    from: egui::Pos2,
    tips: Vec<(String, Color32, egui::Pos2)>,
) {
    let mut taken: Vec<egui::Rect> = Vec::new();
    for (name, color, to) in tips {
        let text = painter.layout_no_wrap(name, FontId::proportional(13.0), color);
        let way = (to - from).normalized();
        let places = [0.0, 18.0, -18.0, 36.0, -36.0].map(|aside| {
            let away = vec2(way.x * (8.0 + text.size().x / 2.0), way.y * 14.0);
            egui::Rect::from_center_size(to + away + vec2(0.0, aside), text.size())
                .expand2(vec2(4.0, 1.0))
        });
        let is_free = |place: &&egui::Rect| taken.iter().all(|other| !other.intersects(**place));
        let place = *places.iter().find(is_free).unwrap_or(&places[0]);
        painter.rect_filled(place, 4, theme.panel.gamma_multiply(0.85));
        painter.galley(place.shrink2(vec2(4.0, 1.0)).min, text, color);
        taken.push(place);
    }
}
