//! Icons for buttons: objects, light, explanation, view.

use super::focus;
use crate::theme;
use egui::{Color32, Painter, Rect, Response, Sense, Stroke, Ui, pos2, vec2};

/// An icon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Icon {
    /// The tree of objects.
    Objects,
    /// Lights and materials.
    Light,
    /// The explanation of a pixel.
    Explain,
    /// The display settings.
    View,
}

/// The side of a button, in points.
pub(crate) const SIDE: f32 = 32.0;

/// A button with an icon, and its name as tooltip.
pub(crate) fn button(ui: &mut Ui, icon: Icon, name: &str, is_on: bool) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(SIDE, SIDE), Sense::click());
    response.widget_info(|| {
        egui::WidgetInfo::selected(egui::WidgetType::SelectableLabel, true, is_on, name)
    });
    let theme = theme::of(ui.ctx());
    if is_on {
        ui.painter().rect_filled(rect, 4, theme.accent.gamma_multiply(0.28));
    } else if response.hovered() {
        ui.painter().rect_filled(rect, 4, theme.line);
    }
    focus::ring(ui, &response, rect);
    draw(ui.painter(), icon, rect.shrink(8.0), theme.text);
    response.on_hover_text(name)
}

/// Draws an icon into a square.
fn draw(painter: &Painter, icon: Icon, rect: Rect, color: Color32) {
    let stroke = Stroke::new(1.4, color);
    // Fractions of the square's sides.
    let at = |x: f32, y: f32| rect.min + rect.size() * vec2(x, y);
    let line = |ends: [[f32; 2]; 2]| {
        painter.line_segment(ends.map(|[x, y]| at(x, y)), stroke);
    };
    match icon {
        Icon::Objects => {
            // A trunk with three branches.
            line([[0.1, 0.0], [0.1, 0.85]]);
            for y in [0.15, 0.5, 0.85] {
                line([[0.1, y], [0.32, y]]);
                line([[0.45, y], [1.0, y]]);
            }
        }
        Icon::Light => {
            painter.circle_stroke(rect.center(), rect.width() * 0.22, stroke);
            for step in 0..8 {
                let angle = std::f64::consts::FRAC_PI_4 * f64::from(step);
                let way = vec2(libm::cos(angle) as f32, libm::sin(angle) as f32) * rect.width();
                painter
                    .line_segment([rect.center() + way * 0.36, rect.center() + way * 0.5], stroke);
            }
        }
        Icon::Explain => {
            // A sum: three bars of different lengths over a line.
            for (y, to) in [(0.08, 0.9), (0.36, 0.6), (0.64, 0.75)] {
                line([[0.05, y], [to, y]]);
            }
            line([[0.0, 0.92], [1.0, 0.92]]);
        }
        Icon::View => {
            for (y, knob) in [(0.2, 0.7), (0.5, 0.3), (0.8, 0.6)] {
                line([[0.0, y], [1.0, y]]);
                let place = pos2(at(knob, y).x, at(knob, y).y);
                painter.circle_filled(place, 2.4, color);
            }
        }
    }
}
