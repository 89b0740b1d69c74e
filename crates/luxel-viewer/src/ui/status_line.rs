//! The status line below the picture.

use super::overlays::PendingModel;
use crate::keys::{Action, Keys};
use crate::session::Session;
use crate::theme;
use egui::{Context, Frame, Margin};

/// The largest share of the line that the file's name takes.
const NAME_SHARE: f32 = 0.4;
/// The most characters of an object's name.
const MAX_NAME_LENGTH: usize = 28;

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
    keys: &Keys,
) {
    let frame = Frame::new().fill(theme::of(context).panel).inner_margin(Margin::symmetric(12, 4));
    let panel = egui::TopBottomPanel::bottom("status").frame(frame).show_separator_line(false);
    panel.exact_height(28.0).show(context, |ui| {
        let from_right = egui::Layout::right_to_left(egui::Align::Center);
        ui.with_layout(from_right, |ui| {
            let (panels, help) = (keys.first_of(Action::Panels), keys.first_of(Action::Help));
            ui.weak(format!("{panels} panels    {help} help"));
            let mut parts = Vec::new();
            if let Some([number, count]) = status.position {
                parts.push(format!("{number} of {count}"));
            }
            match (&status.note, session) {
                (Some(note), _) => parts.push(note.clone()),
                (None, Some(session)) if status.loading.is_none() => {
                    parts.push(match session.selection.hovered {
                        Some(object) => hovered_object(session, object),
                        None => format!("{} triangles", grouped(status.triangles)),
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
                            format!(" at {:.0} %", scale * 100.0)
                        } else {
                            String::new()
                        };
                        parts.push(format!("{milliseconds:.0} ms{resolution}"));
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
                    ui.add(egui::Label::new(&status.name).truncate());
                });
                let text = egui::RichText::new(parts.join("   ")).weak();
                ui.add(egui::Label::new(text).truncate());
            });
        });
    });
}

/// The hovered object's name and triangle count.
fn hovered_object(session: &Session, object: usize) -> String {
    let Some(one) = session.objects.get(object) else { return String::new() };
    let scene = &session.model.scene;
    let name = &scene.nodes[one.node.index()].name;
    let triangles = scene.meshes[one.mesh.index()].triangles.len() as u64;
    let short: String = name.chars().take(MAX_NAME_LENGTH).collect();
    let dots = if short.len() < name.len() { "..." } else { "" };
    format!("{short}{dots}, {} triangles", grouped(triangles))
}

/// A number with spaces between thousands.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}
