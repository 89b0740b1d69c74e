//! The light tab: switching, editing, adding and deleting lights; the environment.

use super::controls::{heading, intensity, one_of, row, slider, slider_f32, vector};
use crate::session::Session;
use crate::theme;
use crate::ui::{focus, names, symbols};
use egui::{RichText, TextStyle, Ui};
use luxel::formats::values::{cos_cutoff, cutoff_degrees};
use luxel::lighting::{
    CUTOFF, Cone, EXPONENT, Environment, INNER, LIGHT_KINDS, LightKind, OrientedMap,
};
use luxel::render::EnvironmentChoice;
use luxel::scene::{NamedEnvironment, Placement, SceneLight};
use std::path::Path;

/// All lights; the chosen one with its settings.
pub(super) fn lights(ui: &mut Ui, session: &mut Session, chosen: &mut Option<usize>) {
    let count = session.display().view().lights.len();
    *chosen = chosen.filter(|at| *at < count);
    heading(ui, "Lights");
    let mut deleted = None;
    for at in 0..count {
        ui.push_id(("light", at), |ui| {
            if light_row(ui, session, at, chosen) {
                deleted = Some(at);
            }
            if *chosen == Some(at) {
                settings(ui, session, at);
                ui.add_space(4.0);
            }
        });
    }
    if let Some(deleted) = deleted {
        session.change_display(|display| display.remove(deleted));
        *chosen = None;
    }
    row(ui, "add", |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.spacing_mut().button_padding.x = 6.0;
        for kind in LIGHT_KINDS.iter().filter(|kind| kind.kind != LightKind::Ambient) {
            if ui.button(kind.name).clicked() {
                *chosen = Some(session.add_light(kind));
            }
        }
    });
    let mut ambient = session.display().view().ambient;
    if intensity(ui, "scene I_a", &mut ambient) {
        session.change_display(|display| display.view_mut().ambient = ambient);
    }
    occlusion(ui, session);
}

/// What keeps light away.
fn occlusion(ui: &mut Ui, session: &mut Session) {
    let view = session.display().view();
    let (mut shadows, mut ground, before) = (view.shadows, view.ground, view.ambient_occlusion);
    let mut is_occluded = before.is_some();
    let clicked = row(ui, "with", |ui| {
        let shadows = ui
            .checkbox(&mut shadows, "shadows")
            .on_hover_text("surfaces keep lights from what lies behind them");
        let occlusion = ui
            .checkbox(&mut is_occluded, "occlusion")
            .on_hover_text("less ambient light where something is near");
        shadows.clicked() || occlusion.clicked()
    });
    let clicked = clicked
        | row(ui, "below", |ui| {
            let ground = ui.checkbox(&mut ground, "ground");
            ground.on_hover_text("a ground that shows the model's shadow alone").clicked()
        });
    if clicked {
        session.change_display(|display| {
            let view = display.view_mut();
            view.shadows = shadows;
            view.ground = ground;
            view.ambient_occlusion = is_occluded.then(|| before.unwrap_or_default());
        });
    }
}

/// The environment that mirrors and metals reflect.
pub(super) fn environment(ui: &mut Ui, session: &mut Session) {
    heading(ui, "Environment");
    let up = session.model.scene.up;
    let before = session.display().view().environment.clone();
    // A picture that was loaded can be had back.
    let loaded = session.model.view.environment.map().or(before.map()).cloned();
    let is_map = before.map().is_some();
    let mut named = before.named();
    let mut mode = before;
    let mut kinds = NamedEnvironment::ALL.map(|one| (Some(one), one.name())).to_vec();
    if !is_map {
        kinds.push((None, "colour"));
    }
    if ui.horizontal(|ui| one_of(ui, &mut named, &kinds)).inner {
        mode = named.map_or(EnvironmentChoice::Always(Environment::Constant([0.5; 3])), |named| {
            named.choice(up)
        });
    }
    if let EnvironmentChoice::Always(Environment::Constant(color)) = &mut mode {
        intensity(ui, "all around", color);
    }
    if let Some(map) = loaded {
        mode = picture(ui, &map, mode);
    }
    let about = match (named, mode.map()) {
        (_, Some(_)) => "light all around, on matt surfaces, too",
        (Some(named), None) => named.help(),
        (None, None) => "uniform light from all directions",
    };
    ui.label(RichText::new(about).small().weak());
    let mut is_seen = session.display().view().environment_background;
    ui.checkbox(&mut is_seen, "as the background");
    session.change_display(|display| {
        let view = display.view_mut();
        view.environment = mode;
        view.environment_background = is_seen;
    });
}

/// A picture of the environment: its file, whether it is on, and how far it is turned.
fn picture(ui: &mut Ui, loaded: &OrientedMap, mode: EnvironmentChoice) -> EnvironmentChoice {
    let shown = mode.map().cloned();
    let path = Path::new(loaded.map().name());
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mut is_on = shown.is_some();
    if ui.checkbox(&mut is_on, name).on_hover_text(loaded.map().name()).changed() {
        return match is_on {
            true => EnvironmentChoice::Always(Environment::Map(loaded.clone())),
            false => EnvironmentChoice::Always(Environment::None),
        };
    }
    let Some(shown) = shown else { return mode };
    let mut degrees = shown.rotation_degrees();
    let slider = egui::Slider::new(&mut degrees, -180.0..=180.0).text("rotation").suffix("°");
    if ui.add(slider).changed() {
        return EnvironmentChoice::Always(Environment::Map(shown.turned(degrees)));
    }
    mode
}

/// A light's name. Typing renames the light whenever the text is an unused name.
fn name(ui: &mut Ui, session: &mut Session, at: usize) {
    let Some((light, _)) = session.display().light(at) else { return };
    let name = light.name.clone();
    let id = ui.id().with("name");
    let mut typed = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_else(|| name.clone());
    let field = row(ui, "name", |ui| {
        ui.add(egui::TextEdit::singleline(&mut typed).desired_width(f32::INFINITY))
    });
    if field.changed() && typed != name {
        session.change_display(|display| display.rename(at, &typed));
    }
    // A text that isn't an unused name stays while the field has focus.
    let is_typed = field.has_focus();
    ui.data_mut(
        |data| {
            if is_typed { data.insert_temp(id, typed) } else { data.remove::<String>(id) }
        },
    );
}

/// A light's row; true if it is to be deleted.
fn light_row(ui: &mut Ui, session: &mut Session, at: usize, chosen: &mut Option<usize>) -> bool {
    let Some((light, mut is_on)) = session.display().light(at) else { return false };
    let (name, kind) = (light.name.clone(), light.light.kind.name());
    let mut is_deleted = false;
    ui.horizontal(|ui| {
        // An unchecked box shows only its outline.
        let outline = egui::Stroke::new(1.0, theme::of(ui.ctx()).quiet);
        let before = std::mem::replace(&mut ui.visuals_mut().widgets.inactive.bg_stroke, outline);
        let switch = ui.checkbox(&mut is_on, "").on_hover_text("on or off");
        ui.visuals_mut().widgets.inactive.bg_stroke = before;
        if switch.changed() {
            session.change_display(|display| display.set_enabled(at, is_on));
        }
        let rest = egui::Layout::right_to_left(egui::Align::Center);
        ui.with_layout(rest, |ui| {
            is_deleted = cross(ui).clicked();
            ui.label(RichText::new(kind).small().weak());
            let rest = egui::vec2(ui.available_width(), ui.spacing().interact_size.y);
            ui.allocate_ui_with_layout(
                rest,
                egui::Layout::left_to_right(egui::Align::Center),
                |ui| {
                    let is_chosen = *chosen == Some(at);
                    let width = ui.available_width();
                    if names::button(ui, is_chosen, &name, None, width).clicked() {
                        *chosen = (!is_chosen).then_some(at);
                    }
                },
            );
        });
    });
    is_deleted
}

/// A button with a cross, to delete.
fn cross(ui: &mut Ui) -> egui::Response {
    let (rect, response) = ui.allocate_exact_size(egui::vec2(16.0, 20.0), egui::Sense::click());
    let theme = theme::of(ui.ctx());
    let is_lit = response.hovered() || response.has_focus();
    let color = if is_lit { theme.accent } else { theme.quiet };
    focus::ring(ui, &response, rect);
    for way in [egui::vec2(3.5, 3.5), egui::vec2(3.5, -3.5)] {
        let line = [rect.center() - way, rect.center() + way];
        ui.painter().line_segment(line, egui::Stroke::new(1.25, color));
    }
    response.on_hover_text("delete")
}

fn settings(ui: &mut Ui, session: &mut Session, at: usize) {
    name(ui, session, at);
    let Some((light, _)) = session.display().light(at) else { return };
    let mut light = light.clone();
    let mut changed = false;
    if light.light.kind == LightKind::Ambient {
        changed |= intensity(ui, "I_a", &mut light.light.ambient);
    } else {
        changed |= colors(ui, &mut light);
        changed |= place(ui, session, &mut light);
    }
    if changed {
        session.change_display(|display| display.view_mut().lights[at] = light);
    }
}

/// The light's intensities I_d, I_s, I_a.
fn colors(ui: &mut Ui, light: &mut SceneLight) -> bool {
    let is_one_color = light.light.diffuse == light.light.specular;
    let mut changed = intensity(ui, "I_d", &mut light.light.diffuse);
    if is_one_color {
        light.light.specular = light.light.diffuse;
        row(ui, "I_s", |ui| {
            let font = TextStyle::Body.resolve(ui.style());
            let same = symbols::layout("as I_d", &font, theme::of(ui.ctx()).text);
            if ui.small_button(same).on_hover_text("click to set it apart").clicked() {
                light.light.specular = light.light.diffuse.map(|part| part * 0.5);
                changed = true;
            }
        });
    } else {
        changed |= intensity(ui, "I_s", &mut light.light.specular);
    }
    changed | intensity(ui, "I_a", &mut light.light.ambient)
}

/// The light's pose, attenuation and cone.
fn place(ui: &mut Ui, session: &Session, light: &mut SceneLight) -> bool {
    let mut changed = false;
    let mut placement = light.placement;
    row(ui, "placed in", |ui| match placement {
        Placement::Node(_) => {
            ui.label(RichText::new("its node").small().weak());
        }
        _ => {
            changed = one_of(
                ui,
                &mut placement,
                &[(Placement::World, "world"), (Placement::Camera, "camera")],
            );
        }
    });
    session.light_spaces().change_placement(light, placement);
    let kind = light.light.kind.description();
    if kind.has_direction {
        let mut direction = light.direction;
        if vector(ui, "direction", &mut direction, 0.01) && direction.length_squared() > 1e-12 {
            light.direction = direction;
            changed = true;
        }
    }
    if !kind.has_position {
        return changed;
    }
    let bounds = session.settings.bounds;
    let speed = if bounds.is_empty() { 0.01 } else { (bounds.max - bounds.min).length() / 400.0 };
    changed |= vector(ui, "position", &mut light.position, speed);
    changed |= attenuation(ui, light);
    if let LightKind::Spot(cone) = &mut light.light.kind {
        changed |= self::cone(ui, cone);
    }
    changed
}

/// The attenuation coefficients c1, c2, c3; never all 0.
fn attenuation(ui: &mut Ui, light: &mut SceneLight) -> bool {
    let mut coefficients = light.light.attenuation.coefficients;
    let changed = row(ui, "c_1 c_2 c_3", |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.spacing_mut().button_padding.x = 4.0;
        let width = (ui.available_width() - 8.0) / 3.0;
        let mut changed = false;
        for part in &mut coefficients {
            let value = egui::DragValue::new(part).range(0.0..=1e6).speed(0.01).max_decimals(3);
            changed |=
                ui.add_sized(egui::vec2(width, ui.spacing().interact_size.y), value).changed();
        }
        changed
    });
    let is_valid = coefficients != [0.0; 3];
    if changed && is_valid {
        light.light.attenuation.coefficients = coefficients;
    }
    changed && is_valid
}

fn cone(ui: &mut Ui, cone: &mut Cone) -> bool {
    let mut changed = false;
    let mut angle = |ui: &mut Ui, name: &str, cosine: &mut f32, most: f64| {
        let mut degrees = cutoff_degrees(*cosine);
        row(ui, name, |ui| {
            if slider(ui, &mut degrees, 1.0..=most, 1)
                && let Some(other) = cos_cutoff(degrees.clamp(1.0, most))
            {
                *cosine = other;
                changed = true;
            }
        });
    };
    match cone {
        Cone::Exponent { cos_cutoff, exponent } => {
            angle(ui, CUTOFF.name, cos_cutoff, 90.0);
            row(ui, EXPONENT.name, |ui| changed |= slider_f32(ui, exponent, 0.0..=64.0, 1));
        }
        Cone::Smooth { cos_inner, cos_outer } => {
            angle(ui, CUTOFF.name, cos_outer, 90.0);
            let most = cutoff_degrees(*cos_outer).max(1.0);
            angle(ui, INNER.name, cos_inner, most);
            // The inner angle stays within the outer one.
            *cone = Cone::smooth(*cos_inner, *cos_outer);
        }
    }
    changed
}
