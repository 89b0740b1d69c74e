//! Controls of the panels: headings, labelled rows, sliders, colours, vectors.

use crate::theme;
use crate::ui::symbols;
use egui::{Align, DragValue, Layout, RichText, Slider, TextStyle, Ui, vec2};
use luxel::scene::DVec3;
use std::ops::RangeInclusive;

/// The width of row labels.
const LABEL_WIDTH: f32 = 60.0;

pub(super) fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(8.0);
    ui.label(RichText::new(text).color(theme::of(ui.ctx()).heading));
}

/// A row: a label and controls.
pub(super) fn row<R>(ui: &mut Ui, name: &str, add: impl FnOnce(&mut Ui) -> R) -> R {
    ui.horizontal(|ui| {
        let size = vec2(LABEL_WIDTH, ui.spacing().interact_size.y);
        ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_width(LABEL_WIDTH);
            let font = TextStyle::Small.resolve(ui.style());
            let color = ui.visuals().weak_text_color();
            let label = ui.label(symbols::layout(name, &font, color));
            symbols::explained(label, name);
        });
        add(ui)
    })
    .inner
}

/// What the value beside a slider takes.
const VALUE_WIDTH: f32 = 64.0;

/// Divides the rest of the row between a slider and its value.
fn make_room(ui: &mut Ui) {
    let spacing = ui.spacing_mut();
    spacing.interact_size.x = VALUE_WIDTH - spacing.item_spacing.x;
    let width = ui.available_width() - VALUE_WIDTH;
    ui.spacing_mut().slider_width = width.max(40.0);
}

/// A slider over the rest of the row, followed by its value.
pub(super) fn slider(
    ui: &mut Ui,
    value: &mut f64,
    range: RangeInclusive<f64>,
    decimals: usize,
) -> bool {
    make_room(ui);
    let clamping = egui::SliderClamping::Never;
    ui.add(Slider::new(value, range).clamping(clamping).max_decimals(decimals)).changed()
}

/// As [`slider`], in single precision; never below 0.
pub(super) fn slider_f32(
    ui: &mut Ui,
    value: &mut f32,
    range: RangeInclusive<f64>,
    decimals: usize,
) -> bool {
    let mut wide = f64::from(*value);
    let changed = slider(ui, &mut wide, range, decimals);
    if changed {
        *value = wide.max(0.0) as f32;
    }
    changed
}

/// As [`slider`], for whole numbers.
pub(super) fn slider_whole(ui: &mut Ui, value: &mut f32, range: RangeInclusive<f64>) -> bool {
    let mut wide = f64::from(*value);
    make_room(ui);
    let clamping = egui::SliderClamping::Never;
    let changed = ui.add(Slider::new(&mut wide, range).clamping(clamping).integer()).changed();
    if changed {
        *value = wide as f32;
    }
    changed
}

/// A linear colour of any intensity: hue and strength.
pub(super) fn intensity(ui: &mut Ui, name: &str, color: &mut [f32; 3]) -> bool {
    row(ui, name, |ui| {
        let most = color.iter().copied().fold(0.0, f32::max);
        let mut hue = if most > 0.0 { color.map(|part| part / most) } else { [1.0; 3] };
        let mut strength = most;
        ui.spacing_mut().interact_size.x = 28.0;
        let edited = ui.color_edit_button_rgb(&mut hue).changed();
        let slid = slider_f32(ui, &mut strength, 0.0..=2.0, 2);
        if edited || slid {
            *color = hue.map(|part| part * strength);
        }
        edited || slid
    })
}

/// A vector's components.
pub(super) fn vector(ui: &mut Ui, name: &str, vector: &mut DVec3, speed: f64) -> bool {
    row(ui, name, |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.spacing_mut().button_padding.x = 4.0;
        let width = (ui.available_width() - 8.0) / 3.0;
        let mut changed = false;
        for part in [&mut vector.x, &mut vector.y, &mut vector.z] {
            let value = DragValue::new(part).speed(speed).max_decimals(2);
            let size = vec2(width, ui.spacing().interact_size.y);
            changed |= ui.add_sized(size, value).changed();
        }
        changed
    })
}

/// A choice between alternatives, side by side.
pub(super) fn one_of<T: PartialEq + Clone>(
    ui: &mut Ui,
    value: &mut T,
    choices: &[(T, &str)],
) -> bool {
    ui.spacing_mut().item_spacing.x = 4.0;
    ui.spacing_mut().button_padding.x = 6.0;
    let mut changed = false;
    for (mode, name) in choices {
        let font = TextStyle::Button.resolve(ui.style());
        let shown = symbols::layout(name, &font, theme::of(ui.ctx()).text);
        let button = ui.selectable_value(value, mode.clone(), shown);
        changed |= button.changed();
        symbols::explained(button, name);
    }
    changed
}
