//! The distance between two points: which they are, and how it is shown.

use crate::session::Session;
use crate::theme::{PANEL, QUIET, TEXT};
use egui::{Align2, Color32, Context, FontId, Stroke, vec2};
use luxel::pick::{Viewport, project};
use luxel::scene::{Camera, DMat4, DVec2, DVec3, Size};

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
fn number(length: f64) -> String {
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

/// A line of the world in the window, pixels from the upper left; what lies before the near plane is
/// cut off, and there may be nothing left.
fn in_window(camera: &Camera, size: Size, ends: [DVec3; 2]) -> Option<[DVec2; 2]> {
    let [a, b] = ends.map(|end| camera.view_from_world.transform_point3(end));
    // The camera looks along -z.
    let front = -camera.projection.near;
    let cut = |end: DVec3, other: DVec3| {
        let is_behind = end.z > front;
        if is_behind { end + (other - end) * ((front - end.z) / (other.z - end.z)) } else { end }
    };
    if a.z > front && b.z > front {
        return None;
    }
    let clip_from_view = camera.projection.clip_from_view(size);
    let place = |end| {
        let place = project(end, &DMat4::IDENTITY, &clip_from_view, Viewport::of(size))?;
        let (x, y) = (place.x, f64::from(size.height) - place.y);
        // Far outside, coordinates would not fit into the pixels' steps.
        (x.abs() < FARTHEST && y.abs() < FARTHEST).then_some(DVec2::new(x, y))
    };
    Some([place(cut(a, b))?, place(cut(b, a))?])
}

/// Pixels from the window's corner.
const FARTHEST: f64 = 5e4;

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
    let halo = Color32::from_black_alpha(140);
    painter.line_segment([from, to], Stroke::new(4.0, halo));
    painter.line_segment([from, to], Stroke::new(1.5, TEXT));
    for end in [from, to] {
        painter.circle(end, 4.0, TEXT, Stroke::new(1.5, halo));
    }
    let (text, color) = match session.ruler {
        Ruler::Between([from, to]) => (number(from.distance(to)), TEXT),
        _ => ("from here".to_owned(), QUIET),
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
    painter.rect_filled(rect.expand2(vec2(6.0, 3.0)), 4, PANEL.gamma_multiply(0.9));
    painter.galley(rect.min, text, color);
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::scene::{Lens, Projection};

    const SIZE: Size = Size { width: 200, height: 100 };

    fn camera(lens: Lens) -> Camera {
        let projection = Projection { lens, near: 1.0, far: 100.0 };
        Camera { view_from_world: DMat4::IDENTITY, projection }
    }

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

    #[test]
    fn a_point_is_drawn_where_the_picture_shows_it() {
        // 100 pixels are 20 units; y points up in the world, down in the window.
        let parallel = camera(Lens::Orthographic { height: 20.0 });
        let ends = [DVec3::new(2.0, 4.0, -5.0), DVec3::new(-10.0, -10.0, -50.0)];
        let [a, b] = in_window(&parallel, SIZE, ends).unwrap();
        assert!(a.abs_diff_eq(DVec2::new(110.0, 30.0), 1e-9), "{a}");
        assert!(b.abs_diff_eq(DVec2::new(50.0, 100.0), 1e-9), "{b}");
    }

    #[test]
    fn a_line_past_the_eye_is_cut_at_the_near_plane() {
        let lens = Lens::Perspective { fov_y_radians: std::f64::consts::FRAC_PI_2 };
        let ends = [DVec3::new(0.5, 0.0, -3.0), DVec3::new(0.5, 0.0, 7.0)];
        let [a, b] = in_window(&camera(lens), SIZE, ends).unwrap();
        // x / -z times half the height, from the middle.
        assert!(a.abs_diff_eq(DVec2::new(100.0 + 50.0 / 6.0, 50.0), 1e-9), "{a}");
        assert!(b.abs_diff_eq(DVec2::new(125.0, 50.0), 1e-9), "{b}");
        assert_eq!(in_window(&camera(lens), SIZE, [ends[1]; 2]), None);
    }
}
