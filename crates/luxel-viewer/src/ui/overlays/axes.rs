//! The world's axes in a corner of the picture, with a button for each standard view.

use crate::session::Session;
use crate::theme::{self, AXES};
use crate::ui::UiCommand;
use egui::{Align2, Color32, Context, FontId, Pos2, Rect, Response, Sense, Stroke, pos2, vec2};
use luxel::navigation::{Knob, StandardView, hit, knobs};
use luxel::scene::DVec2;

/// The axes' length, their knobs' radius, and their square's side.
const AXIS: f32 = 34.0;
const KNOB: f32 = 9.0;
const CORNER: f32 = 96.0;

/// In the order of keyboard focus.
const FOCUS_ORDER: [StandardView; 6] = [
    StandardView::Front,
    StandardView::Right,
    StandardView::Top,
    StandardView::Back,
    StandardView::Left,
    StandardView::Bottom,
];

pub(crate) fn axes(context: &Context, session: &Session, commands: &mut Vec<UiCommand>) {
    let free = context.available_rect();
    let area = egui::Area::new("axes".into()).sense(Sense::hover());
    let area = area.fixed_pos(free.right_top() + vec2(-CORNER - 8.0, 8.0));
    area.show(context, |ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(CORNER, CORNER), Sense::hover());
        let centre = rect.center();
        let view = session.state.view_from_world();
        let middle = DVec2::new(f64::from(centre.x), f64::from(centre.y));
        let knobs = knobs(&view, session.settings.up, middle, f64::from(AXIS));
        let under = |place: Pos2| {
            hit(&knobs, DVec2::new(f64::from(place.x), f64::from(place.y)), f64::from(KNOB))
        };
        let mut marked = None;
        for wanted in FOCUS_ORDER {
            let Some(knob) = knobs.iter().find(|knob| knob.view == wanted) else { continue };
            let side = vec2(2.0, 2.0) * KNOB;
            let rect = Rect::from_center_size(place(knob), side);
            let response = ui.interact(rect, ui.id().with(wanted.to_string()), Sense::click());
            let response = response.on_hover_text(wanted.to_string());
            // Of overlapping knobs, the nearest is under the pointer.
            let pointed = |response: &Response| match response.interact_pointer_pos() {
                Some(place) => under(place),
                None => Some(*knob),
            };
            if response.clicked()
                && let Some(knob) = pointed(&response)
            {
                commands.push(UiCommand::View(knob.view));
            }
            if response.has_focus() {
                marked = Some(wanted);
            } else if let Some(knob) = response.hover_pos().and_then(under) {
                marked = marked.or(Some(knob.view));
            }
        }
        let (painter, theme) = (ui.painter(), theme::of(ui.ctx()));
        for knob in &knobs {
            let at = place(knob);
            let along = knob.axis.abs();
            let axis = [along.x, along.y, along.z];
            let Some(axis) = axis.iter().position(|&part| part > 0.5) else { continue };
            let is_positive = knob.axis.max_element() > 0.5;
            let fading = 0.55 + 0.45 * (knob.towards as f32 * 0.5 + 0.5);
            let color = AXES[axis].gamma_multiply(fading);
            if is_positive {
                painter.line_segment([centre, at], Stroke::new(2.0, color));
                painter.circle_filled(at, KNOB, color);
                let name = ["x", "y", "z"][axis];
                let font = FontId::proportional(11.0);
                painter.text(at, Align2::CENTER_CENTER, name, font, Color32::BLACK);
            } else {
                painter.circle(at, KNOB - 2.0, theme.panel, Stroke::new(1.5, color));
            }
            if marked == Some(knob.view) {
                painter.circle_stroke(at, KNOB + 2.0, Stroke::new(1.5, theme.accent));
            }
        }
    });
}

fn place(knob: &Knob) -> Pos2 {
    pos2(knob.at.x as f32, knob.at.y as f32)
}
