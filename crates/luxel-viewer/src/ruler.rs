//! The distance between two points: which they are, and how it is shown.

use crate::places::in_window;
use crate::session::Session;
use crate::theme;
use egui::{Align2, Context, FontId, Stroke, vec2};
use luxel::scene::DVec3;

/// Points of the world that were chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Ruler {
    /// None.
    #[default]
    Away,
    /// Where to measure from.
    From(DVec3),
    /// Both.
    Between([DVec3; 2]),
}

impl Ruler {
    /// With one more point; a third begins anew, and what is no point puts the ruler away.
    pub(crate) fn with(self, point: Option<DVec3>) -> Self {
        match (self, point) {
            (_, None) => Self::Away,
            (Self::From(from), Some(to)) => Self::Between([from, to]),
            (_, Some(from)) => Self::From(from),
        }
    }

    /// What is measured, along the line and along the axes, in the model's unit.
    pub(crate) fn told(self) -> String {
        match self {
            Self::Away => "nothing is measured".to_owned(),
            Self::From(_) => "r again: to where it is measured".to_owned(),
            Self::Between([from, to]) => {
                let [x, y, z] = (to - from).to_array().map(number);
                format!("distance {} (x {x}, y {y}, z {z})", number(from.distance(to)))
            }
        }
    }
}

/// A length as exactly as points of pictures are known: to four digits.
pub(crate) fn number(length: f64) -> String {
    if length == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{length:.3e}");
    let exponent = text.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    match exponent {
        Some(exponent @ -3..=5) => format!("{length:.*}", (3 - exponent).max(0) as usize),
        _ => text,
    }
}

/// Draws the points, the line between them and its length.
pub(crate) fn draw(context: &Context, session: &Session) {
    let ends = match session.ruler {
        Ruler::Away => return,
        Ruler::From(from) => [from; 2],
        Ruler::Between(ends) => ends,
    };
    let Some(ends) = in_window(&session.camera(), session.settings.size, ends) else { return };
    let scale = f64::from(context.pixels_per_point());
    let [from, to] = ends.map(|end| egui::pos2((end.x / scale) as f32, (end.y / scale) as f32));
    let painter = context.layer_painter(egui::LayerId::background());
    let theme = theme::of(context);
    painter.line_segment([from, to], Stroke::new(4.0, theme.halo));
    painter.line_segment([from, to], Stroke::new(1.5, theme.text));
    for end in [from, to] {
        painter.circle(end, 4.0, theme.text, Stroke::new(1.5, theme.halo));
    }
    let (text, color) = match session.ruler {
        Ruler::Between([from, to]) => (number(from.distance(to)), theme.text),
        _ => ("from here".to_owned(), theme.quiet),
    };
    let font = FontId::monospace(12.0);
    let text = painter.layout_no_wrap(text, font, color);
    // Beside the line, so that it covers none of it.
    let along = (to - from).normalized();
    let aside =
        if along.length() > 0.0 { vec2(along.y.abs(), -along.x.abs()) } else { vec2(0.0, -1.0) };
    let half = text.size() * 0.5;
    let gap = 10.0 + half.x * aside.x.abs() + half.y * aside.y.abs();
    let centre = from + (to - from) * 0.5 + aside * gap;
    let rect = Align2::CENTER_CENTER.anchor_size(centre, text.size());
    painter.rect_filled(rect.expand2(vec2(6.0, 3.0)), 4, theme.panel.gamma_multiply(0.9));
    painter.galley(rect.min, text, color);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_points_are_measured_a_third_begins_anew_nothing_ends() {
        let [a, b] = [DVec3::new(1.0, 0.0, 0.0), DVec3::new(1.0, 3.0, -4.0)];
        let from = Ruler::default().with(Some(a));
        let both = from.with(Some(b));
        assert_eq!((from, both), (Ruler::From(a), Ruler::Between([a, b])));
        assert_eq!(both.told(), "distance 5.000 (x 0, y 3.000, z -4.000)");
        assert_eq!(both.with(Some(b)), Ruler::From(b));
        assert_eq!(from.with(None), Ruler::Away);
        assert_eq!(both.with(None), Ruler::Away);
    }

    #[test]
    fn lengths_have_four_digits_whatever_the_model_s_unit() {
        for (length, text) in [
            (0.0, "0"),
            (0.012_346, "0.01235"),
            (1.0, "1.000"),
            (-98.7654, "-98.77"),
            (4321.2, "4321"),
            (123_456.7, "123457"),
            (2.5e-7, "2.500e-7"),
            (1.5e9, "1.500e9"),
        ] {
            assert_eq!(number(length), text);
        }
    }
}
