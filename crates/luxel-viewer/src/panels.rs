//! The panels at the sides: the scene's tree, light, and how it is looked at.

use crate::explain;
use crate::keys::MODES;
use crate::session::Session;
use crate::theme::{ACCENT, PANEL, QUIET};
use crate::ui::{Ui, Wish};
use egui::{Context, Frame, Margin, RichText, ScrollArea, Slider};
use luxel::lighting::LightKind;
use luxel::navigation::Number;
use luxel::render::Edges;
use luxel::scene::{Bounds, DVec3, Lens, Object, Placement, Scene, SceneLight};

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

/// What is in the scene, with names and counts; a click brings it into view.
pub(crate) fn tree(ui: &mut Ui, context: &Context, session: &Session, wishes: &mut Vec<Wish>) {
    let panel = egui::SidePanel::left("tree").frame(frame()).show_separator_line(false);
    panel.resizable(false).exact_width(240.0).show(context, |panel| {
        let field = egui::TextEdit::singleline(&mut ui.search).hint_text("search");
        panel.add(field.desired_width(f32::INFINITY));
        panel.add_space(4.0);
        let scene = &session.model.scene;
        let objects = scene.objects();
        let wanted = ui.search.to_lowercase();
        let found: Vec<_> = objects
            .iter()
            .filter(|object| path(scene, object).to_lowercase().contains(&wanted))
            .collect();
        let noun = if objects.len() == 1 { "object" } else { "objects" };
        let of = if found.len() == objects.len() {
            format!("{} {noun}", objects.len())
        } else {
            format!("{} of {} {noun}", found.len(), objects.len())
        };
        panel.label(RichText::new(of).small().color(QUIET));
        let height = panel.spacing().interact_size.y;
        let area = ScrollArea::vertical().auto_shrink([false, false]);
        area.show_rows(panel, height, found.len(), |panel, rows| {
            for object in &found[rows] {
                let name = scene.nodes[object.node.index()].name.clone();
                let triangles = scene.meshes[object.mesh.index()].triangles.len();
                panel.horizontal(|panel| {
                    let count = RichText::new(triangles.to_string()).small().color(QUIET);
                    let label = panel.add(egui::Button::new(name).frame(false).truncate());
                    panel.label(count);
                    if label.on_hover_text(path(scene, object)).clicked() {
                        wishes.push(Wish::Fit(Some(bounds(scene, object))));
                    }
                });
            }
        });
    });
}

fn path(scene: &Scene, object: &Object) -> String {
    scene.path(object.node).join(" / ")
}

/// An object's bounds in world space.
fn bounds(scene: &Scene, object: &Object) -> Bounds {
    let mesh = &scene.meshes[object.mesh.index()];
    let mut bounds = Bounds::EMPTY;
    for &[x, y, z] in &mesh.positions {
        let point = mesh.origin + DVec3::new(f64::from(x), f64::from(y), f64::from(z));
        bounds.include(object.world_from_mesh.transform_point3(point));
    }
    bounds
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
