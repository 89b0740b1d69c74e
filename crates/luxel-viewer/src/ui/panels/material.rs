//! The materials of the selected objects: the constants of their reflection models.

use super::controls::{heading, one_of, row, slider_f32, slider_whole};
use crate::number::number;
use crate::session::{Session, materials_of_mesh};
use crate::ui::names;
use egui::{ComboBox, RichText, Ui};
use luxel::lighting::{Material, REFLECTION_MODELS, parameters};
use luxel::scene::{Restyle, SceneMaterial};
use std::collections::BTreeSet;

/// The most materials that are shown.
const MAX_SHOWN: usize = 8;

/// The materials of the selected objects; of the whole scene, if it has only one.
pub(super) fn materials(ui: &mut Ui, session: &mut Session) {
    heading(ui, "Material");
    let scene = &session.model.scene;
    let of_selected = session.selection.selected().iter().filter_map(|at| session.objects.get(*at));
    let mut shown: BTreeSet<usize> =
        of_selected.flat_map(|object| materials_of_mesh(scene, object.mesh.index())).collect();
    if shown.is_empty() && session.material_uses.iter().filter(|uses| **uses > 0).count() == 1 {
        shown.extend(session.material_uses.iter().position(|uses| *uses > 0));
    }
    if shown.is_empty() {
        ui.label(RichText::new("Select an object to change how it reflects light.").small().weak());
    }
    for material in shown.iter().copied().take(MAX_SHOWN) {
        ui.push_id(("material", material), |ui| material_controls(ui, session, material));
    }
    if shown.len() > MAX_SHOWN {
        let more = format!("and {} more: select less", shown.len() - MAX_SHOWN);
        ui.label(RichText::new(more).small().weak());
    }
}

fn material_controls(ui: &mut Ui, session: &mut Session, at: usize) {
    let material = session.material_overrides().material(&session.model.scene, at);
    let uses = session.material_uses.get(at).copied().unwrap_or_default();
    ui.horizontal(|ui| {
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if session.material_overrides().is_changed(at) && ui.small_button("as it was").clicked()
            {
                session.edit_materials(|overrides| overrides.reset(at));
            }
            if uses > 1 {
                ui.label(RichText::new(format!("on {uses} objects")).small().weak());
            }
            let rest = egui::vec2(ui.available_width(), ui.spacing().interact_size.y);
            let from_left = egui::Layout::left_to_right(egui::Align::Center);
            ui.allocate_ui_with_layout(rest, from_left, |ui| names::label(ui, &material.name));
        });
    });
    let mut change = Restyle::default();
    constants(ui, &material, &mut change);
    if change != Restyle::default() {
        session.edit_materials(|overrides| merge(overrides.edit(at), change));
    }
    ui.add_space(4.0);
}

/// Merges a change into an earlier edit.
fn merge(edit: &mut Restyle, change: Restyle) {
    macro_rules! take {
        ($($field:ident),*) => { $(if change.$field.is_some() { edit.$field = change.$field; })* };
    }
    // A new colour replaces a separate ambient colour, too.
    if change.color.is_some() {
        edit.ambient = None;
    }
    take!(color, emission, reflection, ambient, specular, opacity);
    edit.parameters.extend(change.parameters);
}

/// The constants that the reflection model uses; edits go into `change`.
fn constants(ui: &mut Ui, material: &SceneMaterial, change: &mut Restyle) {
    let constants = &material.constants;
    row(ui, "reflection", |ui| {
        let name = constants.reflection.name();
        let width = ui.available_width();
        let list = ComboBox::from_id_salt("reflection").selected_text(name);
        // High enough for all models.
        list.width(width).height(280.0).show_ui(ui, |ui| {
            for model in REFLECTION_MODELS {
                let is_worn = name == model.name;
                let label = ui.selectable_label(is_worn, model.name);
                if label.on_hover_text(model.help).clicked() && !is_worn {
                    change.reflection = Some(model.reflection.clone());
                }
            }
        });
    });
    let reflection = &constants.reflection;
    let note = material.base_color.as_ref().map(|_| "times a texture");
    surface_color(ui, "O_d", note, constants.diffuse, &mut change.color);
    for parameter in parameters().filter(|parameter| reflection.heeds(parameter)) {
        match parameter.name {
            "ka" => ambient_color(ui, constants, change),
            "ks" => {
                let note = material.specular.as_ref().map(|_| "times a texture");
                surface_color(ui, "O_s", note, constants.specular, &mut change.specular);
            }
            _ => {}
        }
        let range = f64::from(parameter.range[0])..=f64::from(parameter.slider_end);
        let mut value = constants.value(parameter);
        let mut set = None;
        if !parameter.is_whole {
            number_row(ui, parameter.symbol, value, range, &mut set);
        } else if row(ui, parameter.symbol, |ui| slider_whole(ui, &mut value, range)) {
            set = Some(value);
        }
        if let Some(value) = set {
            change.set_parameter(parameter, parameter.nearest(value));
        }
    }
    surface_color(ui, "emission", None, constants.emission, &mut change.emission);
    number_row(ui, "opacity", material.opacity, 0.0..=1.0, &mut change.opacity);
    change.opacity = change.opacity.map(|share| share.min(1.0));
}

/// O_a, that of O_d or its own.
fn ambient_color(ui: &mut Ui, constants: &Material, change: &mut Restyle) {
    let mut is_own = constants.ambient.is_some();
    row(ui, "O_a", |ui| {
        if one_of(ui, &mut is_own, &[(false, "as O_d"), (true, "its own")]) {
            let diffuse = constants.diffuse;
            // A colour without an ambient one is both.
            if is_own { change.ambient = Some(diffuse) } else { change.color = Some(diffuse) }
        }
    });
    if let Some(ambient) = constants.ambient {
        surface_color(ui, "", None, ambient, &mut change.ambient);
    }
}

fn number_row(
    ui: &mut Ui,
    name: &str,
    value: f32,
    range: std::ops::RangeInclusive<f64>,
    change: &mut Option<f32>,
) {
    let decimals = if *range.end() > 1.0 { 1 } else { 2 };
    row(ui, name, |ui| {
        let mut value = value;
        if slider_f32(ui, &mut value, range, decimals) {
            *change = Some(value);
        }
    });
}

fn surface_color(
    ui: &mut Ui,
    name: &str,
    note: Option<&str>,
    value: [f32; 3],
    change: &mut Option<[f32; 3]>,
) {
    row(ui, name, |ui| {
        let mut value = value;
        ui.spacing_mut().interact_size.x = 28.0;
        if ui.color_edit_button_rgb(&mut value).changed() {
            *change = Some(value.map(|part| part.max(0.0)));
        }
        let [r, g, b] = value;
        let numbers = [r, g, b].map(|part| number(f64::from(part)));
        let text = note.map_or_else(|| numbers.join("  "), str::to_owned);
        ui.label(RichText::new(text).monospace().size(11.0).weak());
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::lighting::{K_D, K_S};

    #[test]
    fn later_changes_win_and_a_colour_replaces_the_ambient_one() {
        let mut change = Restyle { ambient: Some([1.0; 3]), ..Restyle::default() };
        change.set_parameter(&K_D, 0.5);
        let mut later = Restyle::default();
        later.set_parameter(&K_D, 0.6);
        later.set_parameter(&K_S, 0.1);
        merge(&mut change, later);
        assert_eq!(
            (change.parameter(&K_D), change.parameter(&K_S), change.ambient),
            (Some(0.6), Some(0.1), Some([1.0; 3]))
        );
        merge(&mut change, Restyle { color: Some([0.2; 3]), ..Restyle::default() });
        assert_eq!((change.color, change.ambient), (Some([0.2; 3]), None));
    }
}
