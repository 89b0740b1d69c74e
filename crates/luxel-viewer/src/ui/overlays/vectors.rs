//! The vectors of the lighting equation at the explained point: N, V, L and the highlight's.

use crate::number::degrees;
use crate::session::Session;
use crate::theme::{self, Theme};
use egui::{Color32, Context, FontId, Stroke, pos2, vec2};
use luxel::render::{Explanation, Seen};
use luxel::report::{LedgerVector, VectorKind, ledger_vectors};
use luxel::scene::DVec3;

/// Draws N, V and the L of each light that contributes, at the explained point.
pub(crate) fn vectors(context: &Context, session: &Session, explanation: &Explanation) {
    let surface =
        explanation.samples.iter().flat_map(|sample| &sample.seen).find_map(|seen| match seen {
            Seen::Surface(surface) => Some(surface),
            Seen::Background { .. } => None,
        });
    let Some(surface) = surface else { return };
    /// The length of a vector parallel to the picture, in points.
    const LENGTH: f64 = 72.0;
    let layer = egui::LayerId::background();
    let painter = context.layer_painter(layer);
    let theme = theme::of(context);
    let scale = f64::from(context.pixels_per_point());
    let [x, y] = explanation.pixel.map(|side| (f64::from(side) + 0.5) / scale);
    let from = pos2(x as f32, y as f32);
    let rotation = session.state.view_from_world();
    // Labels are drawn last, over all lines.
    let mut tips: Vec<(String, Color32, egui::Pos2)> = Vec::new();
    let mut arrow = |name: &str, color: Color32, [x, y, z]: [f32; 3]| {
        let vector = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
        let in_view = rotation.transform_vector3(vector) * LENGTH;
        // The window's y points down.
        let to = from + vec2(in_view.x as f32, -in_view.y as f32);
        let halo = Stroke::new(4.0, theme.halo);
        painter.line_segment([from, to], halo);
        painter.line_segment([from, to], Stroke::new(2.0, color));
        painter.circle_filled(to, 3.0, color);
        tips.push((name.to_owned(), color, to));
    };
    let angle = |cosine: f32| degrees(libm::acos(f64::from(cosine.clamp(-1.0, 1.0))).to_degrees());
    for LedgerVector { kind, name, vector, cosine, .. } in ledger_vectors(surface) {
        let color = match kind {
            VectorKind::Normal => theme.vectors[0],
            VectorKind::ToLight => theme.vectors[1],
            VectorKind::View => theme.vectors[2],
            VectorKind::Highlight => theme.vectors[3],
        };
        match cosine {
            Some(cosine) => arrow(&format!("{name} {}", angle(cosine)), color, vector),
            None => arrow(name, color, vector),
        }
    }
    painter.circle(from, 4.0, theme.halo, Stroke::new(1.5, theme.accent));
    labels(&painter, theme, from, tips);
}

/// Labels the vectors from a point, beyond their tips, shifted up or down to avoid overlaps.
fn labels(
    painter: &egui::Painter,
    theme: &Theme,
    from: egui::Pos2,
    tips: Vec<(String, Color32, egui::Pos2)>,
) {
    let mut taken: Vec<egui::Rect> = Vec::new();
    for (name, color, to) in tips {
        let text = painter.layout_no_wrap(name, FontId::proportional(13.0), color);
        let way = (to - from).normalized();
        let places = [0.0, 18.0, -18.0, 36.0, -36.0].map(|aside| {
            let away = vec2(way.x * (8.0 + text.size().x / 2.0), way.y * 14.0);
            egui::Rect::from_center_size(to + away + vec2(0.0, aside), text.size())
                .expand2(vec2(4.0, 1.0))
        });
        let is_free = |place: &&egui::Rect| taken.iter().all(|other| !other.intersects(**place));
        let place = *places.iter().find(is_free).unwrap_or(&places[0]);
        painter.rect_filled(place, 4, theme.panel.gamma_multiply(0.85));
        painter.galley(place.shrink2(vec2(4.0, 1.0)).min, text, color);
        taken.push(place);
    }
}
