//! The tree of objects.

use super::{MARGINS, PanelState, TREE_WIDTH, frame};
use crate::number::count;
use crate::selection::SelectMode;
use crate::session::Session;
use crate::theme;
use crate::ui::{UiCommand, focus, names};
use egui::{Context, Margin, RichText};
use luxel::scene::Object;

/// The objects with name, triangle count and visibility: a click selects, a double click fits into
/// view.
pub(crate) fn tree(
    state: &mut PanelState,
    context: &Context,
    session: &mut Session,
    commands: &mut Vec<UiCommand>,
) {
    // In a narrow window the panel opens beside the icons.
    let panel = if state.is_narrow {
        egui::SidePanel::right("tree")
    } else {
        egui::SidePanel::left("tree")
    };
    let panel = panel.frame(frame(context)).show_separator_line(false);
    let width = state.width(TREE_WIDTH, context.content_rect().width());
    panel.resizable(false).exact_width(width).show(context, |panel| {
        let content = (width - MARGINS).max(0.0);
        let field = egui::TextEdit::singleline(&mut state.search)
            .hint_text(RichText::new("search").color(theme::of(context).quiet))
            .margin(Margin::symmetric(8, 5));
        let field = panel.add(field.desired_width((content - 16.0).max(0.0)));
        if std::mem::take(&mut state.wants_focus) {
            field.request_focus();
        }
        panel.add_space(4.0);
        let searched = state.search.to_lowercase();
        let count = session.objects.len();
        let found: Vec<_> = (0..count)
            .filter(|object| {
                searched.is_empty() || session.path(*object).to_lowercase().contains(&searched)
            })
            .collect();
        let noun = if count == 1 { "object" } else { "objects" };
        let mut of = if found.len() == count {
            format!("{count} {noun}")
        } else {
            format!("{} of {count} {noun}", found.len())
        };
        if !session.selection.hidden().is_empty() {
            of.push_str(&format!(", {} hidden", session.selection.hidden().len()));
        }
        // The row has the same height with and without the button.
        let row = egui::vec2(content, panel.spacing().interact_size.y);
        let from_left = egui::Layout::left_to_right(egui::Align::Center);
        panel.allocate_ui_with_layout(row, from_left, |panel| {
            panel.label(RichText::new(of).small().weak());
            if !session.selection.hidden().is_empty() {
                panel.with_layout(egui::Layout::right_to_left(egui::Align::Center), |panel| {
                    if panel.small_button("show all").clicked() {
                        session.selection.show_all();
                    }
                });
            }
        });
        let height = panel.spacing().interact_size.y;
        let step = height + panel.spacing().item_spacing.y;
        let mut area = focus::scrolled(panel).auto_shrink([false, false]);
        // Scrolls to the object selected in the picture.
        let selected = session.selection.selected().first().copied();
        let visible = &mut state.visible_rows;
        if state.scrolled_to != selected {
            state.scrolled_to = selected;
            let row = selected.and_then(|one| found.iter().position(|object| *object == one));
            let top = row.map(|row| row as f32 * step);
            if let Some(top) = top.filter(|top| *top < visible.start || top + height > visible.end)
            {
                area = area.vertical_scroll_offset((top - 2.0 * step).max(0.0));
            }
        }
        let output = area.show_viewport(panel, |panel, viewport| {
            panel.set_max_width(content);
            panel.set_height((step * found.len() as f32 - panel.spacing().item_spacing.y).max(0.0));
            // One more row at each end, so that keyboard focus can move on to it.
            let first = ((viewport.min.y / step).floor() as usize).saturating_sub(1);
            let rows =
                first.min(found.len())..found.len().min((viewport.max.y / step) as usize + 2);
            let all = panel.max_rect();
            let [top, bottom] = [rows.start, rows.end].map(|row| all.top() + row as f32 * step);
            let rect = egui::Rect::from_x_y_ranges(all.x_range(), top..=bottom);
            panel.scope_builder(egui::UiBuilder::new().max_rect(rect), |panel| {
                for object in &found[rows] {
                    object_row(panel, session, *object, commands);
                }
            });
            focus::follow(panel);
        });
        let top = output.state.offset.y;
        *visible = top..top + output.inner_rect.height();
    });
}

fn object_row(
    ui: &mut egui::Ui,
    session: &mut Session,
    object: usize,
    commands: &mut Vec<UiCommand>,
) {
    let Object { node, mesh, .. } = session.objects[object];
    let name = session.model.scene.nodes[node.index()].name.clone();
    let triangles = session.model.scene.meshes[mesh.index()].triangles.len();
    let is_hidden = session.selection.hidden().contains(&object);
    let is_selected = session.selection.selected().contains(&object);
    let theme = theme::of(ui.ctx());
    let color = if is_hidden {
        theme.quiet
    } else if is_selected {
        theme.heading
    } else {
        theme.text
    };
    // The id doesn't depend on the scroll position.
    let id = egui::Id::new(("object", object));
    ui.scope_builder(egui::UiBuilder::new().id(id), |ui| {
        let row = egui::vec2(ui.available_width(), ui.spacing().interact_size.y);
        let from_right = egui::Layout::right_to_left(egui::Align::Center);
        ui.allocate_ui_with_layout(row, from_right, |ui| {
            if eye(ui, is_hidden).clicked() {
                session.selection.toggle_shown(object);
            }
            ui.label(RichText::new(count(triangles as u64)).small().weak());
            let rest = ui.available_size();
            ui.allocate_ui_with_layout(
                rest,
                egui::Layout::left_to_right(egui::Align::Center),
                |ui| {
                    let width = ui.available_width();
                    let label = names::button(ui, is_selected, &name, Some(color), width);
                    let path = session.path(object);
                    let label = if path == name { label } else { label.on_hover_text(path) };
                    if label.double_clicked() {
                        commands.push(UiCommand::Fit(Some(session.bounds(object))));
                    } else if label.clicked() {
                        let keys = ui.input(|input| input.modifiers);
                        let mode = if keys.ctrl || keys.shift {
                            SelectMode::Toggle
                        } else {
                            SelectMode::Replace
                        };
                        session.selection.select([object], mode);
                    }
                },
            );
        });
    });
}

/// An eye that shows and toggles visibility.
fn eye(ui: &mut egui::Ui, is_hidden: bool) -> egui::Response {
    let (rect, response) = ui.allocate_exact_size(egui::vec2(20.0, 20.0), egui::Sense::click());
    let theme = theme::of(ui.ctx());
    let color = if response.hovered() || response.has_focus() {
        theme.accent
    } else if is_hidden {
        theme.quiet
    } else {
        theme.text
    };
    focus::ring(ui, &response, rect);
    let (centre, stroke) = (rect.center(), egui::Stroke::new(1.25, color));
    // A lid from the left corner to the right one, of a height in points.
    let lid = |height: f32| {
        let point = |step: i32| {
            let along = step as f32 / 4.0;
            centre + egui::vec2(along * 7.0, height * (1.0 - along * along))
        };
        egui::Shape::line((-4..=4).map(point).collect(), stroke)
    };
    let painter = ui.painter();
    painter.add(lid(4.0));
    if !is_hidden {
        painter.add(lid(-4.0));
        painter.circle_filled(centre, 2.0, color);
    }
    response.on_hover_text(if is_hidden { "show" } else { "hide" })
}
