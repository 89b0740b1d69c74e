//! The measurement in the picture: its points, the line between them and its length.

use crate::number::number;
use crate::projection::project_line;
use crate::session::{Measurement, Session};
use crate::theme;
use egui::{Align2, Context, FontId, Stroke, vec2};

/// Draws the measurement.
pub(crate) fn measurement(context: &Context, session: &Session) {
    let ends = match session.measurement {
        Measurement::None => return,
        Measurement::From(from) => [from; 2],
        Measurement::Between(ends) => ends,
    };
    let Some(ends) = project_line(&session.camera(), session.settings.size, ends) else { return };
    let scale = f64::from(context.pixels_per_point());
    let [from, to] = ends.map(|end| egui::pos2((end.x / scale) as f32, (end.y / scale) as f32));
    let painter = context.layer_painter(egui::LayerId::background());
    let theme = theme::of(context);
    painter.line_segment([from, to], Stroke::new(4.0, theme.halo));
    painter.line_segment([from, to], Stroke::new(1.5, theme.text));
    for end in [from, to] {
        painter.circle(end, 4.0, theme.text, Stroke::new(1.5, theme.halo));
    }
    let (text, color) = match session.measurement {
        Measurement::Between([from, to]) => (number(from.distance(to)), theme.text),
        _ => ("from here".to_owned(), theme.quiet),
    };
    let font = FontId::monospace(12.0);
    let text = painter.layout_no_wrap(text, font, color);
    // The label stands beside the line.
    let along = (to - from).normalized();
    let sideways =
        if along.length() > 0.0 { vec2(along.y.abs(), -along.x.abs()) } else { vec2(0.0, -1.0) };
    let half = text.size() * 0.5;
    let gap = 10.0 + half.x * sideways.x.abs() + half.y * sideways.y.abs();
    let centre = from + (to - from) * 0.5 + sideways * gap;
    let rect = Align2::CENTER_CENTER.anchor_size(centre, text.size());
    painter.rect_filled(rect.expand2(vec2(6.0, 3.0)), 4, theme.panel.gamma_multiply(0.9));
    painter.galley(rect.min, text, color);
}
