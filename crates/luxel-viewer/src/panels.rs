//! The panels at the sides: the scene's tree, light, and how it is looked at.

mod controls;
mod light;
mod material;
mod view;

use crate::explain;
use crate::focus;
use crate::icons::{self, Icon};
use crate::marks::Choice;
use crate::session::Session;
use crate::theme;
use crate::ui::{Ui, Wish};
use egui::{Context, Frame, Margin, RichText};
use luxel::scene::Object;

/// What the panel at the right shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tab {
    #[default]
    Light,
    Explain,
    View,
}

/// A panel, where there is room for one at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// The tree of objects.
    Tree,
    /// The tabs.
    Settings,
}

/// The panels' widths, in points, and what of a narrow picture stays free.
const TREE: f32 = 240.0;
const SETTINGS: f32 = 288.0;
const FREE: f32 = 64.0;

/// A panel's width, where the window has that much.
fn width(context: &Context, width: f32) -> f32 {
    width.min((context.available_rect().width() - FREE).max(FREE))
}

/// The panels as icons, at the right end of a narrow window.
pub(crate) fn folded(ui: &mut Ui, context: &Context) {
    let frame = Frame::new().fill(theme::of(context).panel).inner_margin(Margin::same(4));
    let panel = egui::SidePanel::right("folded").frame(frame).show_separator_line(false);
    panel.resizable(false).exact_width(icons::SIDE + 8.0).show(context, |panel| {
        panel.spacing_mut().item_spacing.y = 4.0;
        let all = [
            (Icon::Objects, "objects", None),
            (Icon::Light, "light", Some(Tab::Light)),
            (Icon::Explain, "explain", Some(Tab::Explain)),
            (Icon::View, "view", Some(Tab::View)),
        ];
        for (icon, name, tab) in all {
            let side = if tab.is_some() { Side::Settings } else { Side::Tree };
            let is_on = ui.unfolded == Some(side) && tab.is_none_or(|tab| tab == ui.tab);
            let button = icons::button(panel, icon, name, is_on);
            if icon == Icon::Objects && ui.unfolded.is_none() && std::mem::take(&mut ui.wants_focus)
            {
                button.request_focus();
            }
            if button.clicked() {
                ui.unfolded = (!is_on).then_some(side);
                ui.tab = tab.unwrap_or(ui.tab);
            }
        }
    });
}

fn frame(context: &Context) -> Frame {
    Frame::new().fill(theme::of(context).panel).inner_margin(Margin::same(12))
}

/// The tree's place: at the left, or beside the icons.
fn side(ui: &Ui, name: &'static str) -> egui::SidePanel {
    if ui.is_narrow { egui::SidePanel::right(name) } else { egui::SidePanel::left(name) }
}

/// What is in the scene, with names, counts and eyes: a click selects, a double click brings into view.
pub(crate) fn tree(ui: &mut Ui, context: &Context, session: &mut Session, wishes: &mut Vec<Wish>) {
    let panel = side(ui, "tree").frame(frame(context)).show_separator_line(false);
    panel.resizable(false).exact_width(width(context, TREE)).show(context, |panel| {
        let field = egui::TextEdit::singleline(&mut ui.search)
            .hint_text(RichText::new("search").color(theme::of(context).quiet))
            .margin(Margin::symmetric(8, 5));
        let field = panel.add(field.desired_width(f32::INFINITY));
        if std::mem::take(&mut ui.wants_focus) {
            field.request_focus();
        }
        panel.add_space(4.0);
        let wanted = ui.search.to_lowercase();
        let count = session.objects.len();
        let found: Vec<_> = (0..count)
            .filter(|object| {
                wanted.is_empty() || session.path(*object).to_lowercase().contains(&wanted)
            })
            .collect();
        let noun = if count == 1 { "object" } else { "objects" };
        let mut of = if found.len() == count {
            format!("{count} {noun}")
        } else {
            format!("{} of {count} {noun}", found.len())
        };
        if !session.marks.hidden().is_empty() {
            of.push_str(&format!(", {} hidden", session.marks.hidden().len()));
        }
        // As high with the button as without it.
        let row = egui::vec2(panel.available_width(), panel.spacing().interact_size.y);
        let from_left = egui::Layout::left_to_right(egui::Align::Center);
        panel.allocate_ui_with_layout(row, from_left, |panel| {
            panel.label(RichText::new(of).small().weak());
            if !session.marks.hidden().is_empty() {
                panel.with_layout(egui::Layout::right_to_left(egui::Align::Center), |panel| {
                    if panel.small_button("show all").clicked() {
                        session.marks.show_all();
                    }
                });
            }
        });
        let height = panel.spacing().interact_size.y;
        let step = height + panel.spacing().item_spacing.y;
        let mut area = focus::scrolled(panel).auto_shrink([false, false]);
        // What is selected in the picture comes into view.
        let selected = session.marks.selected().first().copied();
        let (last, seen) = &mut ui.found;
        if *last != selected {
            *last = selected;
            let row = selected.and_then(|one| found.iter().position(|object| *object == one));
            let top = row.map(|row| row as f32 * step);
            if let Some(top) = top.filter(|top| *top < seen.start || top + height > seen.end) {
                area = area.vertical_scroll_offset((top - 2.0 * step).max(0.0));
            }
        }
        let output = area.show_viewport(panel, |panel, viewport| {
            panel.set_height((step * found.len() as f32 - panel.spacing().item_spacing.y).max(0.0));
            // One row more at each end: the keyboard goes on to it, and it comes into view.
            let first = ((viewport.min.y / step).floor() as usize).saturating_sub(1);
            let rows =
                first.min(found.len())..found.len().min((viewport.max.y / step) as usize + 2);
            let all = panel.max_rect();
            let [top, bottom] = [rows.start, rows.end].map(|row| all.top() + row as f32 * step);
            let rect = egui::Rect::from_x_y_ranges(all.x_range(), top..=bottom);
            panel.scope_builder(egui::UiBuilder::new().max_rect(rect), |panel| {
                for object in &found[rows] {
                    one_object(panel, session, *object, wishes);
                }
            });
            focus::follow(panel);
        });
        let top = output.state.offset.y;
        *seen = top..top + output.inner_rect.height();
    });
}

fn one_object(ui: &mut egui::Ui, session: &mut Session, object: usize, wishes: &mut Vec<Wish>) {
    let Object { node, mesh, .. } = session.objects[object];
    let name = &session.model.scene.nodes[node.index()].name;
    let triangles = session.model.scene.meshes[mesh.index()].triangles.len();
    let is_hidden = session.marks.hidden().contains(&object);
    let is_selected = session.marks.selected().contains(&object);
    let theme = theme::of(ui.ctx());
    let color = if is_hidden {
        theme.quiet
    } else if is_selected {
        theme.heading
    } else {
        theme.text
    };
    let name = RichText::new(name).color(color);
    // The same wherever it has been scrolled to.
    let id = egui::Id::new(("object", object));
    ui.scope_builder(egui::UiBuilder::new().id(id), |ui| {
        let row = egui::vec2(ui.available_width(), ui.spacing().interact_size.y);
        let from_right = egui::Layout::right_to_left(egui::Align::Center);
        ui.allocate_ui_with_layout(row, from_right, |ui| {
            if eye(ui, is_hidden).clicked() {
                session.marks.toggle_shown(object);
            }
            ui.label(RichText::new(triangles.to_string()).small().weak());
            let rest = ui.available_size();
            ui.allocate_ui_with_layout(
                rest,
                egui::Layout::left_to_right(egui::Align::Center),
                |ui| {
                    let label = egui::Button::selectable(is_selected, name).truncate();
                    let label = ui.add(label).on_hover_text(session.path(object));
                    if label.double_clicked() {
                        wishes.push(Wish::Fit(Some(session.bounds(object))));
                    } else if label.clicked() {
                        let keys = ui.input(|input| input.modifiers);
                        let choice =
                            if keys.ctrl || keys.shift { Choice::Toggle } else { Choice::Replace };
                        session.marks.select([object], choice);
                    }
                },
            );
        });
    });
}

/// An eye, open or shut.
fn eye(ui: &mut egui::Ui, is_shut: bool) -> egui::Response {
    let (rect, response) = ui.allocate_exact_size(egui::vec2(20.0, 20.0), egui::Sense::click());
    let theme = theme::of(ui.ctx());
    let color = if response.hovered() || response.has_focus() {
        theme.accent
    } else if is_shut {
        theme.quiet
    } else {
        theme.text
    };
    focus::ring(ui, &response, rect);
    let (centre, stroke) = (rect.center(), egui::Stroke::new(1.25, color));
    // A lid from the left corner to the right one, so many points high.
    let lid = |height: f32| {
        let point = |step: i32| {
            let along = step as f32 / 4.0;
            centre + egui::vec2(along * 7.0, height * (1.0 - along * along))
        };
        egui::Shape::line((-4..=4).map(point).collect(), stroke)
    };
    let painter = ui.painter();
    painter.add(lid(4.0));
    if !is_shut {
        painter.add(lid(-4.0));
        painter.circle_filled(centre, 2.0, color);
    }
    response.on_hover_text(if is_shut { "show" } else { "hide" })
}

/// Light, and how the scene is looked at.
pub(crate) fn settings(
    ui: &mut Ui,
    context: &Context,
    session: &mut Session,
    wishes: &mut Vec<Wish>,
) {
    let panel = egui::SidePanel::right("settings").frame(frame(context)).show_separator_line(false);
    panel.resizable(false).exact_width(width(context, SETTINGS)).show(context, |panel| {
        panel.horizontal(|panel| {
            let first = panel.selectable_value(&mut ui.tab, Tab::Light, "Light");
            if std::mem::take(&mut ui.wants_focus) {
                first.request_focus();
            }
            panel.selectable_value(&mut ui.tab, Tab::Explain, "Explain");
            panel.selectable_value(&mut ui.tab, Tab::View, "View");
        });
        panel.add_space(8.0);
        let area = focus::scrolled(panel).auto_shrink([false, false]);
        area.show(panel, |panel| {
            match ui.tab {
                Tab::Light => {
                    light::lights(panel, session, &mut ui.chosen);
                    light::environment(panel, session);
                    material::materials(panel, session);
                }
                Tab::Explain => {
                    let equation = ui.equation.as_deref();
                    explain::ledger(panel, session, ui.explanation.as_deref(), equation);
                }
                Tab::View => view::view(panel, session, &ui.keys, wishes),
            }
            focus::follow(panel);
        });
    });
}
