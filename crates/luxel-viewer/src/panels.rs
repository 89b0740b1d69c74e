//! The panels at the sides: the scene's tree, light, and how it is looked at.

use crate::explain;
use crate::keys::MODES;
use crate::marks::Choice;
use crate::session::Session;
use crate::theme::{ACCENT, PANEL, QUIET, TEXT};
use crate::ui::{Ui, Wish};
use egui::{Context, Frame, Margin, RichText, ScrollArea, Slider};
use luxel::lighting::LightKind;
use luxel::navigation::Number;
use luxel::render::Edges;
use luxel::scene::{DVec3, Lens, Object, Placement, SceneLight};

/// What the panel at the right shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tab {
    #[default]
    Light,
    Explain,
    View,
}

fn frame() -> Frame {
    Frame::new().fill(PANEL).inner_margin(Margin::same(12))
}

/// What is in the scene, with names, counts and eyes: a click selects, a double click brings into view.
pub(crate) fn tree(ui: &mut Ui, context: &Context, session: &mut Session, wishes: &mut Vec<Wish>) {
    let panel = egui::SidePanel::left("tree").frame(frame()).show_separator_line(false);
    panel.resizable(false).exact_width(240.0).show(context, |panel| {
        let field = egui::TextEdit::singleline(&mut ui.search).hint_text("search");
        panel.add(field.desired_width(f32::INFINITY));
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
            panel.label(RichText::new(of).small().color(QUIET));
            if !session.marks.hidden().is_empty() {
                panel.with_layout(egui::Layout::right_to_left(egui::Align::Center), |panel| {
                    if panel.small_button("show all").clicked() {
                        session.marks.show_all();
                    }
                });
            }
        });
        let height = panel.spacing().interact_size.y;
        let area = ScrollArea::vertical().auto_shrink([false, false]);
        area.show_rows(panel, height, found.len(), |panel, rows| {
            for object in &found[rows] {
                one_object(panel, session, *object, wishes);
            }
        });
    });
}

fn one_object(ui: &mut egui::Ui, session: &mut Session, object: usize, wishes: &mut Vec<Wish>) {
    let Object { node, mesh, .. } = session.objects[object];
    let name = &session.model.scene.nodes[node.index()].name;
    let triangles = session.model.scene.meshes[mesh.index()].triangles.len();
    let is_hidden = session.marks.hidden().contains(&object);
    let is_selected = session.marks.selected().contains(&object);
    let color = if is_hidden {
        QUIET
    } else if is_selected {
        ACCENT
    } else {
        TEXT
    };
    let name = RichText::new(name).color(color);
    ui.push_id(object, |ui| {
        let row = egui::vec2(ui.available_width(), ui.spacing().interact_size.y);
        let from_right = egui::Layout::right_to_left(egui::Align::Center);
        ui.allocate_ui_with_layout(row, from_right, |ui| {
            if eye(ui, is_hidden).clicked() {
                session.marks.toggle_shown(object);
            }
            ui.label(RichText::new(triangles.to_string()).small().color(QUIET));
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
    let color = if response.hovered() {
        ACCENT
    } else if is_shut {
        QUIET
    } else {
        TEXT
    };
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
    let panel = egui::SidePanel::right("settings").frame(frame()).show_separator_line(false);
    panel.resizable(false).exact_width(272.0).show(context, |panel| {
        panel.horizontal(|panel| {
            panel.selectable_value(&mut ui.tab, Tab::Light, "Light");
            panel.selectable_value(&mut ui.tab, Tab::Explain, "Explain");
            panel.selectable_value(&mut ui.tab, Tab::View, "View");
        });
        panel.add_space(8.0);
        let area = ScrollArea::vertical().auto_shrink([false, false]);
        area.show(panel, |panel| match ui.tab {
            Tab::Light => light(panel, session),
            Tab::Explain => explain::ledger(panel, ui.explanation.as_deref()),
            Tab::View => view(panel, session, wishes),
        });
    });
}

fn heading(ui: &mut egui::Ui, text: &str) {
    ui.add_space(4.0);
    ui.label(RichText::new(text).color(ACCENT));
}

fn light(ui: &mut egui::Ui, session: &mut Session) {
    let view = &mut session.model.view;
    let before = (view.ambient, view.lights.clone(), session.dark.clone());
    heading(ui, "Ambient light");
    color(ui, "I_a", &mut view.ambient);
    for (light, is_dark) in view.lights.iter_mut().zip(&mut session.dark) {
        ui.add_space(8.0);
        ui.push_id(light.name.clone(), |ui| one_light(ui, light, is_dark));
    }
    let view = &session.model.view;
    if before.0 != view.ambient || before.1 != view.lights || before.2 != session.dark {
        session.changed();
    }
}

fn one_light(ui: &mut egui::Ui, light: &mut SceneLight, is_dark: &mut bool) {
    let kind = match light.light.kind {
        LightKind::Directional => "directional",
        LightKind::Point => "point",
        LightKind::Spot(_) => "spot",
        LightKind::Ambient => "ambient",
    };
    ui.horizontal(|ui| {
        let mut is_on = !*is_dark;
        ui.checkbox(&mut is_on, RichText::new(&light.name).color(ACCENT));
        *is_dark = !is_on;
        ui.label(RichText::new(kind).small().color(QUIET));
    });
    if light.light.kind == LightKind::Ambient {
        color(ui, "I_a", &mut light.light.ambient);
        return;
    }
    let is_one_color = light.light.diffuse == light.light.specular;
    color(ui, "I_d", &mut light.light.diffuse);
    if is_one_color {
        light.light.specular = light.light.diffuse;
    } else {
        color(ui, "I_s", &mut light.light.specular);
    }
    if light.light.kind == LightKind::Directional {
        let mut direction = light.direction;
        vector(ui, "direction", &mut direction);
        if direction.length_squared() > 1e-12 {
            light.direction = direction;
        }
    } else {
        vector(ui, "position", &mut light.position);
    }
    ui.horizontal(|ui| {
        ui.label(RichText::new("placed in").small().color(QUIET));
        if !matches!(light.placement, Placement::Node(_)) {
            ui.selectable_value(&mut light.placement, Placement::World, "world");
            ui.selectable_value(&mut light.placement, Placement::Camera, "camera");
        }
    });
}

/// A linear colour: what it looks like, and its strength.
fn color(ui: &mut egui::Ui, name: &str, color: &mut [f32; 3]) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).monospace().color(QUIET));
        let most = color.iter().copied().fold(0.0, f32::max);
        let mut hue = if most > 0.0 { color.map(|part| part / most) } else { [1.0; 3] };
        let mut strength = most;
        let edited = ui.color_edit_button_rgb(&mut hue).changed();
        let slid = ui.add(Slider::new(&mut strength, 0.0..=3.0).max_decimals(2)).changed();
        if edited || slid {
            *color = hue.map(|part| part * strength);
        }
    });
}

fn vector(ui: &mut egui::Ui, name: &str, vector: &mut DVec3) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).small().color(QUIET));
        for part in [&mut vector.x, &mut vector.y, &mut vector.z] {
            ui.add(egui::DragValue::new(part).speed(0.01).max_decimals(2));
        }
    });
}

fn view(ui: &mut egui::Ui, session: &mut Session, wishes: &mut Vec<Wish>) {
    heading(ui, "Navigation");
    let mode = session.state.mode();
    for (one, key) in MODES {
        ui.horizontal(|ui| {
            if ui.selectable_label(mode == one, one.to_string()).clicked() {
                wishes.push(Wish::Mode(one));
            }
            ui.label(RichText::new(key).small().color(QUIET));
        });
    }
    for (number, name, most) in
        [(Number::Inertia, "inertia, s", 1.0), (Number::Transition, "ways, s", 0.5)]
    {
        ui.horizontal(|ui| {
            let mut value = session.settings.number(number);
            if ui.add(Slider::new(&mut value, 0.0..=most).max_decimals(2)).changed() {
                session.set_number(number, value);
            }
            ui.label(name);
        });
    }
    heading(ui, "Camera");
    ui.horizontal(|ui| {
        let is_parallel = matches!(session.settings.lens, Lens::Orthographic { .. });
        for (parallel, name) in [(false, "perspective"), (true, "parallel")] {
            if ui.selectable_label(is_parallel == parallel, name).clicked()
                && is_parallel != parallel
            {
                wishes.push(Wish::Lens);
            }
        }
    });
    if ui.button("fit all").clicked() {
        wishes.push(Wish::Fit(None));
    }
    let line = ui.button("print as `luxel render`");
    if line.on_hover_text("Ctrl c: the line that draws this view goes to the terminal").clicked() {
        wishes.push(Wish::Line);
    }
    let view = &mut session.model.view;
    let before = (view.edges, view.samples);
    heading(ui, "Edges");
    ui.horizontal(|ui| {
        for (edges, name) in [
            (None, "none"),
            (Some(Edges::OVER_FACES), "over faces"),
            (Some(Edges::WIREFRAME), "wireframe"),
        ] {
            ui.selectable_value(&mut view.edges, edges, name);
        }
    });
    heading(ui, "Samples a pixel, at rest");
    ui.horizontal(|ui| {
        for samples in [1, 2, 4, 8, 16] {
            ui.selectable_value(&mut view.samples, samples, samples.to_string());
        }
    });
    if before != (view.edges, view.samples) {
        session.changed();
    }
}
