//! The view tab: comparison, shading, layers, exposure, guides, camera, navigation.

use super::controls::{heading, one_of, row, slider};
use crate::display::{is_of_light, layer_name};
use crate::keys::{Action, Guide, Keys, MODES};
use crate::session::Session;
use crate::theme;
use crate::ui::{UiCommand, names, symbols};
use egui::{RichText, Ui};
use luxel::lighting::{Display, Tone};
use luxel::navigation::Number;
use luxel::render::{Clamp, Edges, Interpolation, Layer, ShadingMode};
use luxel::scene::Lens;

pub(super) fn view(ui: &mut Ui, session: &mut Session, keys: &Keys, commands: &mut Vec<UiCommand>) {
    comparison(ui, session, keys);
    shading(ui, session, keys);
    layers(ui, session, keys);
    exposure(ui, session);
    guides(ui, session, keys);
    camera(ui, session, keys, commands);
    navigation(ui, session, keys, commands);
}

/// A heading with the keys of its action.
fn heading_with(ui: &mut Ui, text: &str, keys: String) {
    ui.add_space(8.0);
    ui.horizontal(|ui| {
        ui.label(RichText::new(text).color(theme::of(ui.ctx()).heading));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(RichText::new(keys).small().weak());
        });
    });
}

fn comparison(ui: &mut Ui, session: &mut Session, keys: &Keys) {
    heading_with(ui, "Compare", keys.of(Action::Compare));
    let (is_compared, is_difference, is_right) =
        session.comparison().map_or((false, false, true), |comparison| {
            (true, comparison.is_difference, comparison.is_right_active)
        });
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        if ui.selectable_label(is_compared && !is_difference, "side by side").clicked() {
            if is_difference { session.toggle_difference() } else { session.toggle_comparison() }
        }
        if ui.selectable_label(is_difference, "difference").clicked() {
            session.toggle_difference();
        }
    });
    if is_compared {
        row(ui, "set here", |ui| {
            let mut side = is_right;
            if one_of(ui, &mut side, &[(false, "left"), (true, "right")]) {
                session.set_active_side(side);
            }
        });
        if let Some((comparison, _)) =
            session.comparison_mut().filter(|(comparison, _)| !comparison.is_difference)
        {
            row(ui, "line at, %", |ui| {
                let mut percent = f64::from(comparison.divider) * 100.0;
                if slider(ui, &mut percent, 5.0..=95.0, 0) {
                    comparison.divider = (percent.clamp(5.0, 95.0) / 100.0) as f32;
                }
            });
        }
    }
}

fn shading(ui: &mut Ui, session: &mut Session, keys: &Keys) {
    heading_with(ui, "Shading", keys.of(Action::NextShading));
    let mut shading = session.display().view().shading;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        ui.spacing_mut().button_padding.x = 5.0;
        for mode in ShadingMode::ALL {
            let name = mode.name();
            if ui.selectable_label(shading.mode.name() == name, name).clicked() {
                shading.mode = mode;
            }
        }
    });
    row(ui, "between", |ui| {
        let ways = [
            (Interpolation::Perspective, "space"),
            (Interpolation::Screen, "screen"),
            (Interpolation::Scanline, "scanline"),
        ];
        one_of(ui, &mut shading.interpolation, &ways);
    });
    match &mut shading.mode {
        ShadingMode::Phong => {}
        ShadingMode::Subdivided { tolerance } => row(ui, "tolerance", |ui| {
            let mut steps = f64::from(*tolerance);
            if slider(ui, &mut steps, 0.25..=16.0, 2) {
                *tolerance = steps.max(0.25) as f32;
            }
        }),
        _ => row(ui, "clamped", |ui| {
            one_of(
                ui,
                &mut shading.clamp,
                &[(Clamp::Vertex, "at corners"), (Clamp::End, "at the end")],
            );
        }),
    }
    session.change_display(|display| display.view_mut().shading = shading);
}

fn layers(ui: &mut Ui, session: &mut Session, keys: &Keys) {
    heading_with(ui, "Shown", keys.of(Action::StepLayer(true)));
    let all = session.display().layers();
    let mut chosen = session.display().layer.clone();
    let mut wrapped = |ui: &mut Ui, wanted: &dyn Fn(&Option<Layer>) -> bool| {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            ui.spacing_mut().button_padding.x = 5.0;
            for layer in all.iter().filter(|layer| wanted(layer)) {
                let name = layer.as_ref().map_or_else(|| "picture".to_owned(), layer_name);
                let (is_chosen, width) = (chosen == *layer, ui.max_rect().width());
                let button = names::button(ui, is_chosen, &name, None, width);
                let is_symbol = *layer == Some(Layer::NDotL);
                let button = if is_symbol { symbols::explained(button, &name) } else { button };
                if button.clicked() {
                    chosen.clone_from(layer);
                }
            }
        });
    };
    wrapped(ui, &|layer| layer.as_ref().is_none_or(is_of_light));
    ui.add_space(4.0);
    wrapped(ui, &|layer| layer.as_ref().is_some_and(|layer| !is_of_light(layer)));
    session.change_display(|display| display.layer = chosen);
}

/// The exposure and the tone curve of surfaces.
fn exposure(ui: &mut Ui, session: &mut Session) {
    heading(ui, "Exposure");
    let display = session.display();
    let (mut stops, mut tone) = (f64::from(display.view().exposure), display.view().tone);
    let is_auto = display.is_auto_exposed;
    row(ui, "stops", |ui| {
        let auto = ui.selectable_label(is_auto, "auto");
        if auto.on_hover_text("for the lights as they are now").clicked() {
            session.expose_automatically();
        } else if slider(ui, &mut stops, -16.0..=16.0, 1) {
            let most = f64::from(Display::MAX_EV);
            session.change_display(|display| {
                display.view_mut().exposure = stops.clamp(-most, most) as f32;
                display.is_auto_exposed = false;
            });
        }
    });
    row(ui, "tone", |ui| one_of(ui, &mut tone, &Tone::ALL.map(|tone| (tone, tone.name()))));
    session.change_display(|display| display.view_mut().tone = tone);
}

fn guides(ui: &mut Ui, session: &mut Session, keys: &Keys) {
    heading_with(ui, "Beside it", keys.of(Action::ToggleGuide(Guide::Grid)));
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let mut guides = session.guides;
        for (one, name) in [
            (&mut guides.grid, "grid"),
            (&mut guides.axes, "axes"),
            (&mut guides.boxes, "boxes"),
            (&mut guides.normals, "normals"),
        ] {
            if ui.selectable_label(*one, name).clicked() {
                *one = !*one;
            }
        }
        if guides != session.guides {
            session.guides = guides;
            session.changed();
        }
    });
    let (mut edges, mut samples) =
        (session.display().view().edges, session.display().view().samples);
    row(ui, "edges", |ui| {
        one_of(
            ui,
            &mut edges,
            &[
                (None, "none"),
                (Some(Edges::OVER_FACES), "on faces"),
                (Some(Edges::WIREFRAME), "alone"),
            ],
        );
    });
    row(ui, "samples", |ui| {
        one_of(ui, &mut samples, &[(1, "1"), (2, "2"), (4, "4"), (8, "8"), (16, "16")]);
    });
    session.change_display(|display| {
        (display.view_mut().edges, display.view_mut().samples) = (edges, samples);
    });
}

fn camera(ui: &mut Ui, session: &Session, keys: &Keys, commands: &mut Vec<UiCommand>) {
    heading_with(ui, "Camera and files", keys.first_of(Action::Open));
    ui.horizontal(|ui| {
        let mut is_parallel = matches!(session.settings.lens, Lens::Orthographic { .. });
        if one_of(ui, &mut is_parallel, &[(false, "perspective"), (true, "parallel")]) {
            commands.push(UiCommand::ToggleLens);
        }
        if ui.button("fit all").clicked() {
            commands.push(UiCommand::Fit(None));
        }
    });
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let open = ui.button("open");
        if open.on_hover_text("a model, by its name").clicked() {
            commands.push(UiCommand::OpenDialog);
        }
        let line = ui.button("copy its line");
        if line.on_hover_text("`luxel render ...`, into the clipboard").clicked() {
            commands.push(UiCommand::CopyCommand);
        }
        let save = ui.button("save as a scene file");
        if save.on_hover_text("a TOML beside the model; `luxel render` draws it").clicked() {
            commands.push(UiCommand::SaveScene);
        }
    });
}

fn navigation(ui: &mut Ui, session: &mut Session, keys: &Keys, commands: &mut Vec<UiCommand>) {
    heading_with(ui, "Navigation", keys.of(Action::NextMode));
    let mode = session.state.mode();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        ui.spacing_mut().button_padding.x = 5.0;
        for one in MODES {
            let key = keys.of(Action::Mode(one));
            let label = ui.selectable_label(mode == one, one.to_string());
            if label.on_hover_text(key).clicked() {
                commands.push(UiCommand::Mode(one));
            }
        }
    });
    for (number, name, most) in
        [(Number::Inertia, "inertia, s", 1.0), (Number::Transition, "ways, s", 0.5)]
    {
        row(ui, name, |ui| {
            let mut value = session.settings.number(number);
            if slider(ui, &mut value, 0.0..=most, 2) {
                session.set_number(number, value.max(0.0));
            }
        });
    }
}
