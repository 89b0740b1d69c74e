//! The help: what mouse and keys do.

use crate::keys::{Action, BINDINGS, Keys, MODES};
use crate::theme;
use crate::ui::focus;
use egui::{Align2, Context, Frame, Margin, Stroke, vec2};
use luxel::navigation::Mode;
use winit::keyboard::NamedKey;

const MOUSE: [(&str, &str); 8] = [
    ("click", "select"),
    ("shift + click", "select more, or less"),
    ("ctrl + left drag", "select in a rectangle"),
    ("left drag", "turn"),
    ("shift + left, middle", "pan"),
    ("right drag", "zoom"),
    ("wheel", "zoom to the pointer"),
    ("double click", "turn about that point"),
];

/// The width of three columns, in points, and the room below which there are two, or one.
const WIDE: f32 = 960.0;
const NARROW: f32 = 860.0;
const NARROWEST: f32 = 620.0;

/// The distance that a key scrolls the help, in points.
pub(crate) fn help_scroll_step(key: NamedKey) -> Option<f32> {
    const LINE: f32 = 20.0;
    const PAGE: f32 = 240.0;
    const ALL: f32 = 1e5;
    Some(match key {
        NamedKey::ArrowDown => LINE,
        NamedKey::ArrowUp => -LINE,
        NamedKey::PageDown | NamedKey::Space => PAGE,
        NamedKey::PageUp => -PAGE,
        NamedKey::End => ALL,
        NamedKey::Home => -ALL,
        _ => return None,
    })
}

/// Shows the help, scrolled on by a distance in points.
pub(crate) fn help(context: &Context, mode: Mode, keys: &Keys, scroll: f32) {
    let theme = theme::of(context);
    let frame = Frame::new().fill(theme.panel).corner_radius(4).inner_margin(Margin::same(20));
    let frame = frame.stroke(Stroke::new(1.0, theme.line));
    let area = egui::Area::new("help".into())
        .sense(egui::Sense::hover())
        .anchor(Align2::CENTER_CENTER, vec2(0.0, -14.0));
    let listed: Vec<_> = BINDINGS.iter().filter(|binding| !binding.about.is_empty()).collect();
    let rows: Vec<_> = listed
        .iter()
        .map(|binding| (keys.of(binding.action()), binding.about.to_owned()))
        .collect();
    let mouse: Vec<_> = MOUSE.map(|(keys, what)| (keys.to_owned(), what.to_owned())).into();
    let modes: Vec<_> = MODES.map(|one| (keys.of(Action::Mode(one)), one.to_string())).into();
    let modes_title = format!("Ways to navigate ({}: the next)", keys.of(Action::NextMode));
    let motions = keys.motions(mode);
    let held = |ui: &mut egui::Ui| {
        ui.colored_label(theme.heading, format!("Held, in {mode}"));
        pairs(ui, &motions);
    };
    let hand = |ui: &mut egui::Ui| {
        table(ui, "Mouse", &mouse);
        ui.add_space(12.0);
        table(ui, &modes_title, &modes);
    };
    let room = (context.content_rect().size() - vec2(80.0, 108.0)).max(vec2(160.0, 48.0));
    area.order(egui::Order::Foreground).show(context, |ui| {
        frame.show(ui, |ui| {
            ui.set_width(WIDE.min(room.x));
            ui.set_max_height(room.y);
            let scrolled = focus::scrolled(ui).max_height(room.y);
            scrolled.show(ui, |ui| {
                if scroll != 0.0 {
                    ui.scroll_with_delta(vec2(0.0, -scroll));
                }
                if room.x < NARROWEST {
                    hand(ui);
                    ui.add_space(12.0);
                    table(ui, "Keys", &rows);
                    ui.add_space(12.0);
                    held(ui);
                    return;
                }
                if room.x < NARROW {
                    ui.columns(2, |columns| {
                        let [left, right] = columns else { return };
                        hand(left);
                        left.add_space(12.0);
                        held(left);
                        table(right, "Keys", &rows);
                    });
                    return;
                }
                let (first, second) = rows.split_at(rows.len().div_ceil(2));
                ui.columns(3, |columns| {
                    let [left, middle, right] = columns else { return };
                    hand(left);
                    table(middle, "Keys", first);
                    table(right, " ", second);
                    right.add_space(12.0);
                    held(right);
                });
            });
        });
    });
}

fn table(ui: &mut egui::Ui, title: &str, rows: &[(String, String)]) {
    ui.colored_label(theme::of(ui.ctx()).heading, title);
    // Rows aren't clickable and may be close.
    ui.spacing_mut().interact_size.y = 18.0;
    egui::Grid::new(title).num_columns(2).spacing([16.0, 2.0]).show(ui, |ui| {
        for (keys, what) in rows {
            ui.monospace(keys);
            ui.weak(what);
            ui.end_row();
        }
    });
}

/// Two keys with their motions in each row.
fn pairs(ui: &mut egui::Ui, motions: &[(String, &str)]) {
    ui.spacing_mut().interact_size.y = 18.0;
    egui::Grid::new("held").num_columns(4).spacing([12.0, 2.0]).show(ui, |ui| {
        for pair in motions.chunks(2) {
            for (key, what) in pair {
                ui.monospace(key);
                ui.weak(*what);
            }
            ui.end_row();
        }
    });
}
