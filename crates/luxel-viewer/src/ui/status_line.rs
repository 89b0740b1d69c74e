//! The status line below the picture.

use super::overlays::PendingModel;
use crate::keys::{Action, Keys};
use crate::number::{count, number, percent};
use crate::session::Session;
use crate::theme;
use crate::ui::names;
use egui::{Context, Frame, Margin, TextStyle};

/// The line's height, in points.
pub(super) const HEIGHT: f32 = 28.0;
/// The largest share of the line that the file's name takes.
const NAME_SHARE: f32 = 0.4;
/// The most that an object's name takes, in points.
const OBJECT_WIDTH: f32 = 200.0;

/// The contents of the status line.
#[derive(Clone, Debug, Default)]
pub(crate) struct Status {
    pub(crate) name: String,
    pub(crate) triangles: u64,
    /// Milliseconds of the last frame, and its width as a fraction of the window's.
    pub(crate) frame_time: Option<(f64, f64)>,
    pub(crate) note: Option<String>,
    /// The model being loaded.
    pub(crate) loading: Option<PendingModel>,
    /// Whether the user chose the model on display.
    pub(crate) is_chosen: bool,
    /// The file's number and the count of files.
    pub(crate) position: Option<[usize; 2]>,
}

/// Shows the status line.
pub(super) fn status_line(
    context: &Context,
    status: &Status,
    session: Option<&Session>,
    (keys, space): (&Keys, &str),
) {
    let frame = Frame::new().fill(theme::of(context).panel).inner_margin(Margin::symmetric(12, 4));
    let panel = egui::TopBottomPanel::bottom("status").frame(frame).show_separator_line(false);
    panel.exact_height(HEIGHT).show(context, |ui| {
        let from_right = egui::Layout::right_to_left(egui::Align::Center);
        ui.with_layout(from_right, |ui| {
            let hints =
                [(Action::Explain, space), (Action::Panels, "panels"), (Action::Help, "help")];
            let hints = hints.map(|(action, effect)| (keys.first_of(action), effect));
            let hints = hints.iter().filter(|(key, _)| !key.is_empty());
            let hints: Vec<_> = hints.map(|(key, effect)| format!("{key} {effect}")).collect();
            ui.weak(hints.join("    "));
            let mut parts = Vec::new();
            if let Some([number, count]) = status.position {
                parts.push(format!("{number} of {count}"));
            }
            match (&status.note, session) {
                (Some(note), _) => parts.push(note.clone()),
                (None, Some(session)) if status.loading.is_none() => {
                    parts.push(match session.selection.hovered {
                        Some(object) => hovered_object(ui, session, object),
                        None => format!("{} triangles", count(status.triangles)),
                    });
                    let (selected, hidden) =
                        (session.selection.selected(), session.selection.hidden());
                    for (marked, what) in [(selected, "selected"), (hidden, "hidden")] {
                        if !marked.is_empty() {
                            parts.push(format!("{} {what}", marked.len()));
                        }
                    }
                    if let Some((milliseconds, scale)) = status.frame_time {
                        let resolution = if scale < 0.99 {
                            format!(" at {}", percent(scale))
                        } else {
                            String::new()
                        };
                        let milliseconds = number(milliseconds.round());
                        parts.push(format!("{milliseconds} ms{resolution}"));
                    }
                    parts.push(session.state.mode().to_string());
                }
                (None, _) => {
                    let pending = status.loading.as_ref().map(|pending| &pending.name);
                    let other = pending.filter(|name| **name != status.name);
                    let other = other.map(|name| format!("{name} ")).unwrap_or_default();
                    if pending.is_some() {
                        parts.push(format!("{other}is being read"));
                    }
                }
            }
            // The rest of the line, truncated.
            let rest = ui.available_size();
            let from_left = egui::Layout::left_to_right(egui::Align::Center);
            ui.allocate_ui_with_layout(rest, from_left, |ui| {
                ui.scope(|ui| {
                    ui.set_max_width(rest.x * NAME_SHARE);
                    names::label(ui, &status.name);
                });
                let text = egui::RichText::new(parts.join("   ")).weak();
                ui.add(egui::Label::new(text).truncate());
            });
        });
    });
}

/// The hovered object's name and triangle count.
fn hovered_object(ui: &egui::Ui, session: &Session, object: usize) -> String {
    let Some(one) = session.objects.get(object) else { return String::new() };
    let scene = &session.model.scene;
    let font = TextStyle::Body.resolve(ui.style());
    let name = &scene.nodes[one.node.index()].name;
    let name = names::shortened(ui.painter(), name, &font, OBJECT_WIDTH);
    let triangles = scene.meshes[one.mesh.index()].triangles.len() as u64;
    format!("{name}, {} triangles", count(triangles))
}
