//! Overlays of a comparison: the divider between both sides, or the scale of their difference.

use crate::display::{Comparison, DisplaySettings};
use crate::number::{number, percent};
use crate::picture::{DIFFERENCE_SCALE, PictureDifference};
use crate::theme;
use crate::ui::{focus, names};
use egui::{Align2, Area, Color32, Context, FontId, Id, Order, Rect, Sense, Stroke, pos2, vec2};

/// Half the width of the divider's grab area, in points.
const HALF: f32 = 6.0;
/// The step of an arrow key, in points.
const STEP: f32 = 16.0;

/// The divider with the descriptions of both sides.
pub(crate) fn divider(context: &Context, comparison: &mut Comparison, display: &DisplaySettings) {
    let (all, free) = (context.content_rect(), context.available_rect());
    // The window may be narrower than the divider.
    let within = |x: f32| x.min(free.right() - HALF).max(free.left() + HALF);
    let x = within(all.left() + comparison.divider * all.width());
    let theme = theme::of(context);
    let area = Area::new(Id::new("divider")).fixed_pos(pos2(x - HALF, free.top()));
    let size = vec2(2.0 * HALF, free.height());
    let response = area
        .order(Order::Middle)
        .sense(Sense::hover())
        .constrain(false)
        .show(context, |ui| ui.allocate_exact_size(size, Sense::drag()).1)
        .inner
        .on_hover_cursor(egui::CursorIcon::ResizeHorizontal);
    let has_keyboard = response.has_focus();
    let by_keys = if has_keyboard { focus::arrows(context, response.id).x * STEP } else { 0.0 };
    let by_hand = if response.dragged() { response.drag_delta().x } else { 0.0 };
    if by_keys + by_hand != 0.0 {
        let to = within(x + by_keys + by_hand);
        comparison.divider = (to - all.left()) / all.width().max(1.0);
    }
    let painter = context.layer_painter(egui::LayerId::background());
    let is_lit = response.hovered() || response.dragged() || has_keyboard;
    let ink = if is_lit { theme.accent } else { theme.text };
    let ends = [pos2(x, free.top()), pos2(x, free.bottom())];
    painter.line_segment(ends, Stroke::new(3.5, theme.halo));
    painter.line_segment(ends, Stroke::new(1.5, ink));
    let grip = Rect::from_center_size(pos2(x, free.center().y), vec2(6.0, 28.0));
    painter.rect(grip, 3, theme.panel, Stroke::new(1.5, ink), egui::StrokeKind::Inside);
    let sides_shown = if comparison.is_right_active {
        [&comparison.other, display]
    } else {
        [display, &comparison.other]
    };
    let sides =
        [(sides_shown[0], Align2::RIGHT_TOP, -12.0), (sides_shown[1], Align2::LEFT_TOP, 12.0)];
    for (at, (display, align, aside)) in sides.into_iter().enumerate() {
        let is_set = (at == 1) == comparison.is_right_active;
        let color = if is_set { theme.heading } else { theme.text };
        let room = if at == 0 { x - free.left() } else { free.right() - x } - 24.0;
        let font = FontId::proportional(13.0);
        let text = names::shortened(&painter, &display.summary(), &font, room);
        let text = painter.layout_no_wrap(text, font, color);
        let rect = align.anchor_size(pos2(x + aside, free.top() + 12.0), text.size());
        painter.rect_filled(rect.expand2(vec2(6.0, 3.0)), 4, theme.panel.gamma_multiply(0.85));
        painter.galley(rect.min, text, color);
    }
}

/// The scale of differences, and their statistics.
pub(crate) fn difference_scale(context: &Context, difference: &PictureDifference) {
    let free = context.available_rect();
    let theme = theme::of(context);
    let painter = context.layer_painter(egui::LayerId::background());
    const CELL: egui::Vec2 = vec2(44.0, 12.0);
    let size = vec2(CELL.x * DIFFERENCE_SCALE.len() as f32, 56.0);
    let corner = pos2(free.left() + 16.0, free.bottom() - size.y - 16.0);
    let rect = Rect::from_min_size(corner, size);
    painter.rect_filled(rect.expand(10.0), 4, theme.panel.gamma_multiply(0.9));
    let text = |at, align, text: String, size: f32, color| {
        painter.text(at, align, text, FontId::proportional(size), color);
    };
    let summary = if difference.largest == 0 {
        "no pixel differs".to_owned()
    } else {
        let PictureDifference { largest, mean, share } = *difference;
        let (share, mean) = (percent(share), number(mean));
        format!("{share} of pixels differ, by {largest} at most, {mean} in the mean")
    };
    text(rect.left_top(), Align2::LEFT_TOP, summary, 13.0, theme.text);
    for (at, (_, name, [r, g, b])) in DIFFERENCE_SCALE.into_iter().enumerate() {
        let left = rect.left() + CELL.x * at as f32;
        let cell = Rect::from_min_size(pos2(left, rect.top() + 24.0), CELL);
        painter.rect_filled(cell, 0, Color32::from_rgb(r, g, b));
        let place = cell.center_bottom() + vec2(0.0, 4.0);
        text(place, Align2::CENTER_TOP, name.to_owned(), 11.0, theme.quiet);
    }
}
