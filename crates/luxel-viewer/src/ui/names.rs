//! Names in less room than they need: shortened in the middle, so that they keep their end, with the
//! whole name as tooltip.

use egui::{Button, Color32, FontId, Painter, Response, RichText, TextStyle, Ui};

/// A text, shortened in the middle to a width.
pub(crate) fn shortened(painter: &Painter, text: &str, font: &FontId, width: f32) -> String {
    let fits = |text: &str| {
        let galley = painter.layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE);
        galley.size().x <= width
    };
    if fits(text) {
        return text.to_owned();
    }
    let letters: Vec<char> = text.chars().collect();
    // Twice as much of the end, which tells files and numbered parts apart.
    let kept = |count: usize| -> String {
        let (begin, end) = letters.split_at(count / 3);
        let end = &end[end.len() - (count - count / 3)..];
        begin.iter().chain([&'\u{2026}']).chain(end).collect()
    };
    let (mut fitting, mut too_long) = (0, letters.len());
    while too_long - fitting > 1 {
        let middle = fitting.midpoint(too_long);
        if fits(&kept(middle)) { fitting = middle } else { too_long = middle }
    }
    kept(fitting)
}

/// A label in the rest of the row.
pub(crate) fn label(ui: &mut Ui, text: &str) -> Response {
    let font = TextStyle::Body.resolve(ui.style());
    let shown = shortened(ui.painter(), text, &font, ui.available_width());
    let is_whole = shown == text;
    let label = ui.label(shown);
    if is_whole { label } else { label.on_hover_text(text) }
}

/// A button that shows whether it is selected, at most of a width.
pub(crate) fn button(
    ui: &mut Ui,
    is_selected: bool,
    text: &str,
    color: Option<Color32>,
    width: f32,
) -> Response {
    let font = TextStyle::Button.resolve(ui.style());
    let room = width - 2.0 * ui.spacing().button_padding.x;
    let shown = shortened(ui.painter(), text, &font, room);
    let is_whole = shown == text;
    let mut shown = RichText::new(shown);
    if let Some(color) = color {
        shown = shown.color(color);
    }
    let button = ui.add(Button::selectable(is_selected, shown));
    if is_whole { button } else { button.on_hover_text(text) }
}
