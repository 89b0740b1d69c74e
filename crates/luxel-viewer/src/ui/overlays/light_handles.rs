//! Handles of lights in the picture: positions, targets of spot lights, and directions as points on a
//! sphere around the picture's centre.

use crate::session::Session;
use crate::theme::{self, Theme};
use crate::ui::{focus, names};
use egui::{
    Align2, Area, Color32, Context, FontId, Id, Order, Painter, Pos2, Rgba, Sense, Stroke, vec2,
};
use luxel::light_editing::{DirectionSphere, HandleKind, HandleView, LightHandle};
use luxel::scene::{DVec2, SceneLight};

/// Half a handle's side, in points.
const HALF: f32 = 9.0;
/// The step of an arrow key, in points.
const STEP: f32 = 8.0;
/// The most that a light's name takes, in points.
const NAME_WIDTH: f32 = 160.0;
/// The relative change of a handle's distance for each point dragged upwards with Shift.
const DEPTH_RATE: f64 = 0.006;

/// The handle being dragged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grab {
    light: usize,
    is_target: bool,
    /// Where it is in the picture, in pixels, and whether the drag began on the near side of the sphere.
    place: DVec2,
    is_near: bool,
}

/// Draws the handles of all lights that are on, and moves lights as their handles are dragged.
pub(crate) fn light_handles(
    context: &Context,
    session: &mut Session,
    chosen: &mut Option<usize>,
    grab: &mut Option<Grab>,
) {
    let camera = session.camera();
    let size = session.settings.size;
    let free = context.available_rect();
    let scale = f64::from(context.pixels_per_point());
    let painter = context.layer_painter(egui::LayerId::background()).with_clip_rect(free);
    let pixels = |place: Pos2| DVec2::new(f64::from(place.x), f64::from(place.y)) * scale;
    let points = |place: DVec2| Pos2::new((place.x / scale) as f32, (place.y / scale) as f32);
    let sides = pixels(free.size().to_pos2());
    let sphere = DirectionSphere::within(pixels(free.center()), sides.x, sides.y);
    let outline = (points(sphere.centre), (sphere.radius / scale) as f32);
    let view = HandleView { camera: &camera, size, pivot: session.state.pivot(), sphere };
    for at in 0..session.display().view().lights.len() {
        let spaces = session.light_spaces();
        let Some((light, true)) = session.display().light(at) else { continue };
        let pose = spaces.world_pose(light);
        let mut moved = None;
        let anchor = view.place(HandleKind::Position(pose.position)).map(points);
        for handle in view.handles(light.light.kind, pose) {
            let is_target = matches!(handle.kind, HandleKind::Target(_));
            let place = points(handle.place);
            if !free.shrink(HALF).contains(place) {
                continue;
            }
            let id = Id::new(("handle", at, is_target));
            let area = Area::new(id)
                .fixed_pos(place - vec2(HALF, HALF))
                .order(Order::Middle)
                .sense(Sense::hover());
            let response = area
                .constrain(false)
                .show(context, |ui| ui.allocate_exact_size(vec2(2.0, 2.0) * HALF, Sense::drag()).1)
                .inner
                .on_hover_cursor(egui::CursorIcon::Grab);
            let is_held = grab.is_some_and(|grab| (grab.light, grab.is_target) == (at, is_target));
            let has_keyboard = response.has_focus();
            let is_lit = response.hovered() || is_held || has_keyboard || *chosen == Some(at);
            show(context, &painter, (light, is_lit), &handle, outline, place, anchor);
            if has_keyboard {
                painter.circle_stroke(
                    place,
                    HALF + 4.0,
                    Stroke::new(1.0, theme::of(context).accent),
                );
            }
            let (start, is_near) = (handle.place, handle.is_near());
            let started = Grab { light: at, is_target, place: start, is_near };
            let moves_depth = context.input(|input| input.modifiers.shift);
            let mut move_by = |grab: &mut Grab, delta: egui::Vec2| {
                if delta == egui::Vec2::ZERO {
                    return;
                }
                let is_deep = moves_depth && !matches!(handle.kind, HandleKind::Direction(_));
                moved = if is_deep {
                    Some(view.moved_away(handle.kind, -f64::from(delta.y) * DEPTH_RATE, pose))
                } else {
                    grab.place += pixels(delta.to_pos2());
                    view.moved(handle.kind, grab.place, grab.is_near, pose).or(moved)
                };
            };
            if has_keyboard {
                *chosen = Some(at);
                let delta = focus::arrows(context, response.id) * STEP;
                move_by(&mut { started }, delta);
            }
            if response.drag_started() {
                *chosen = Some(at);
                *grab = Some(started);
            }
            if let Some(grab) = grab.as_mut().filter(|_| is_held || response.drag_started()) {
                move_by(grab, response.drag_delta());
            }
            if response.drag_stopped() {
                *grab = None;
            }
        }
        if let Some(pose) = moved {
            session.set_light_pose(at, pose);
        }
    }
    if grab.is_some() && !context.input(|input| input.pointer.any_down()) {
        *grab = None;
    }
}

/// A light's colour, scaled to full brightness.
fn hue(light: &SceneLight) -> Color32 {
    let [r, g, b] = light.light.diffuse;
    let most = r.max(g).max(b);
    if most > 0.0 {
        Color32::from(Rgba::from_rgb((r / most).max(0.0), (g / most).max(0.0), (b / most).max(0.0)))
    } else {
        Color32::GRAY
    }
}

fn show(
    context: &Context,
    painter: &Painter,
    (light, is_lit): (&SceneLight, bool),
    handle: &LightHandle,
    (centre, radius): (Pos2, f32),
    at: Pos2,
    anchor: Option<Pos2>,
) {
    let theme = theme::of(context);
    let ink = if is_lit { theme.accent } else { theme.quiet };
    match handle.kind {
        HandleKind::Direction(_) => {
            if is_lit {
                painter.circle_stroke(centre, radius, Stroke::new(1.0, theme.line));
            }
            arrow(painter, theme, (at, at + (centre - at) * 0.6), ink);
            knob(painter, theme, at, handle.is_near().then(|| hue(light)), ink);
        }
        HandleKind::Position(_) => {
            for ray in 0..8 {
                let way = egui::Vec2::angled(std::f32::consts::TAU * ray as f32 / 8.0);
                let line = [at + way * (HALF - 1.0), at + way * (HALF + 4.0)];
                painter.line_segment(line, Stroke::new(3.0, theme.halo));
                painter.line_segment(line, Stroke::new(1.5, ink));
            }
            knob(painter, theme, at, Some(hue(light)), ink);
        }
        HandleKind::Target(_) => {
            if let Some(from) = anchor {
                arrow(painter, theme, (from, at), ink);
            }
            painter.circle(at, 4.0, theme.panel, Stroke::new(1.5, ink));
            return;
        }
    }
    // The names of all lights would overlap.
    if !is_lit {
        return;
    }
    let font = FontId::proportional(11.0);
    let name = names::shortened(painter, &light.name, &font, NAME_WIDTH);
    let text = painter.layout_no_wrap(name, font, ink);
    let aside = vec2(HALF + 10.0, 0.0);
    let mut rect = Align2::LEFT_CENTER.anchor_size(at + aside, text.size());
    if rect.right() > painter.clip_rect().right() {
        rect = Align2::RIGHT_CENTER.anchor_size(at - aside, text.size());
    }
    painter.rect_filled(rect.expand2(vec2(4.0, 2.0)), 4, theme.panel.gamma_multiply(0.8));
    painter.galley(rect.min, text, ink);
}

/// A dot in a light's colour; hollow without one.
fn knob(painter: &Painter, theme: &Theme, at: Pos2, fill: Option<Color32>, ink: Color32) {
    painter.circle_filled(at, 7.5, theme.halo);
    painter.circle(at, 6.0, fill.unwrap_or(theme.panel), Stroke::new(1.5, ink));
}

/// An arrow.
fn arrow(painter: &Painter, theme: &Theme, (from, to): (Pos2, Pos2), ink: Color32) {
    let way = to - from;
    if way.length() < 2.0 * HALF {
        return;
    }
    let along = way.normalized();
    let (from, aside) = (from + along * 8.0, along.rot90());
    let head = [to - along * 8.0 + aside * 4.0, to, to - along * 8.0 - aside * 4.0];
    for (width, color) in [(3.5, theme.halo), (1.5, ink)] {
        painter.line_segment([from, to], Stroke::new(width, color));
        painter.line(head.to_vec(), Stroke::new(width, color));
    }
}
