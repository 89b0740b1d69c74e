//! Handles of lights in the picture: positions, targets of spot lights, and directions as points on a
//! sphere around the picture's centre.

use crate::projection::{project_point, unproject_point};
use crate::session::Session;
use crate::theme::{self, Theme};
use crate::ui::{focus, names};
use egui::{
    Align2, Area, Color32, Context, FontId, Id, Order, Painter, Pos2, Rgba, Sense, Stroke, vec2,
};
use luxel::scene::{Camera, DVec2, DVec3, SceneLight, Size};

/// Half a handle's side, in points.
const HALF: f32 = 9.0;
/// The direction sphere's radius, as a fraction of the free picture's shorter side.
const SPHERE_RADIUS: f32 = 0.3;
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
    /// On the sphere: the pointer in radii from its centre, and whether the drag began on the near side.
    on_sphere: (DVec2, bool),
}

/// What a handle shows and moves.
enum Handle {
    /// A light's position.
    Position(DVec3),
    /// The point that a spot light aims at.
    Target(DVec3),
    /// The direction that a directional light comes from, in view space.
    Direction(DVec3),
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
    let sphere = DirectionSphere {
        centre: free.center(),
        radius: free.width().min(free.height()) * SPHERE_RADIUS,
    };
    let target = session.state.pivot();
    for at in 0..session.display().view().lights.len() {
        let spaces = session.light_spaces();
        let Some((light, true)) = session.display().light(at) else { continue };
        let (position, direction) = spaces.world_pose(light);
        let mut moved = None;
        let anchor = window_position(&Handle::Position(position), &sphere, &camera, size, scale);
        for handle in handles(light, &camera, (position, direction), target) {
            let is_target = matches!(handle, Handle::Target(_));
            let Some(place) = window_position(&handle, &sphere, &camera, size, scale) else {
                continue;
            };
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
            show(context, &painter, (light, is_lit), &handle, &sphere, place, anchor);
            if has_keyboard {
                painter.circle_stroke(
                    place,
                    HALF + 4.0,
                    Stroke::new(1.0, theme::of(context).accent),
                );
            }
            let offset = sphere.offset(place);
            let is_near = matches!(handle, Handle::Direction(towards) if towards.z >= 0.0);
            let started = Grab { light: at, is_target, on_sphere: (offset, is_near) };
            let moves_depth = context.input(|input| input.modifiers.shift);
            let mut move_by = |grab: &mut Grab, delta: egui::Vec2| {
                let view = (&camera, size, scale);
                let to = drag(&handle, grab, delta, moves_depth, &sphere, view);
                let to = to.filter(|_| delta != egui::Vec2::ZERO);
                moved =
                    to.map(|to| dragged_pose(&handle, to, position, direction, &camera)).or(moved);
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
        if let Some((position, direction)) = moved {
            session.set_light_pose(at, position, direction);
        }
    }
    if grab.is_some() && !context.input(|input| input.pointer.any_down()) {
        *grab = None;
    }
}

fn handles(
    light: &SceneLight,
    camera: &Camera,
    (position, direction): (DVec3, DVec3),
    target: DVec3,
) -> Vec<Handle> {
    let kind = light.light.kind.description();
    match (kind.has_position, kind.has_direction) {
        (false, false) => Vec::new(),
        (false, true) => {
            vec![Handle::Direction(camera.view_from_world.transform_vector3(-direction))]
        }
        (true, false) => vec![Handle::Position(position)],
        (true, true) => {
            // The target is as far away as the pivot.
            let reach = position.distance(target);
            let aim = position + direction * if reach > 0.0 { reach } else { 1.0 };
            vec![Handle::Target(aim), Handle::Position(position)]
        }
    }
}

/// The sphere on which directions are shown, in points.
struct DirectionSphere {
    centre: Pos2,
    radius: f32,
}

impl DirectionSphere {
    /// A point in radii from the centre, y upwards.
    fn offset(&self, place: Pos2) -> DVec2 {
        let offset = (place - self.centre) / self.radius;
        DVec2::new(f64::from(offset.x), f64::from(-offset.y))
    }

    fn point(&self, offset: DVec2) -> Pos2 {
        self.centre + vec2(offset.x as f32, -offset.y as f32) * self.radius
    }
}

fn window_position(
    handle: &Handle,
    sphere: &DirectionSphere,
    camera: &Camera,
    size: Size,
    scale: f64,
) -> Option<Pos2> {
    match handle {
        Handle::Direction(towards) => Some(sphere.point(towards.truncate())),
        Handle::Position(point) | Handle::Target(point) => {
            let place = project_point(camera, size, *point)? / scale;
            Some(Pos2::new(place.x as f32, place.y as f32))
        }
    }
}

/// The point that a handle is dragged to: in world space, or a direction in view space.
fn drag(
    handle: &Handle,
    grab: &mut Grab,
    delta: egui::Vec2,
    moves_depth: bool,
    sphere: &DirectionSphere,
    (camera, size, scale): (&Camera, Size, f64),
) -> Option<DVec3> {
    match handle {
        Handle::Direction(_) => {
            let (at, is_near) = &mut grab.on_sphere;
            *at += sphere.offset(sphere.centre + delta);
            Some(on_sphere(*at, *is_near))
        }
        Handle::Position(point) | Handle::Target(point) if moves_depth => {
            let eye = camera.eye();
            let steps = -f64::from(delta.y) * DEPTH_RATE;
            if camera.projection.is_orthographic() {
                let depth = -camera.view_from_world.transform_point3(*point).z;
                let step = steps * depth.abs().max(1e-3);
                return Some(*point + camera.direction() * step);
            }
            Some(eye + (*point - eye) * (1.0 + steps).max(0.1))
        }
        Handle::Position(point) | Handle::Target(point) => {
            let mut place = project_point(camera, size, *point)?;
            place.x += f64::from(delta.x) * scale;
            place.y += f64::from(delta.y) * scale;
            unproject_point(camera, size, place)
        }
    }
}

/// The light's position and direction after a drag.
fn dragged_pose(
    handle: &Handle,
    to: DVec3,
    position: DVec3,
    direction: DVec3,
    camera: &Camera,
) -> (DVec3, DVec3) {
    match handle {
        Handle::Position(_) => (to, direction),
        Handle::Target(_) => (position, (to - position).normalize_or(direction)),
        Handle::Direction(_) => (position, -camera.view_from_world.inverse().transform_vector3(to)),
    }
}

/// The direction, in view space, of a point on the sphere seen from the front, at `offset` radii from its
/// centre, y upwards. Within the outline it lies on the near side if `is_near`, else on the far side;
/// beyond the outline it continues on the other side.
fn on_sphere(offset: DVec2, is_near: bool) -> DVec3 {
    let radius = offset.length().min(2.0);
    let (within, is_near) =
        if radius <= 1.0 { (radius, is_near) } else { (2.0 - radius, !is_near) };
    let aside = offset.normalize_or_zero() * within;
    let depth = (1.0 - within * within).max(0.0).sqrt();
    aside.extend(if is_near { depth } else { -depth })
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
    handle: &Handle,
    sphere: &DirectionSphere,
    at: Pos2,
    anchor: Option<Pos2>,
) {
    let theme = theme::of(context);
    let ink = if is_lit { theme.accent } else { theme.quiet };
    match handle {
        Handle::Direction(towards) => {
            if is_lit {
                painter.circle_stroke(sphere.centre, sphere.radius, Stroke::new(1.0, theme.line));
            }
            arrow(painter, theme, (at, at + (sphere.centre - at) * 0.6), ink);
            let is_near = towards.z >= 0.0;
            knob(painter, theme, at, if is_near { Some(hue(light)) } else { None }, ink);
        }
        Handle::Position(_) => {
            for ray in 0..8 {
                let way = egui::Vec2::angled(std::f32::consts::TAU * ray as f32 / 8.0);
                let line = [at + way * (HALF - 1.0), at + way * (HALF + 4.0)];
                painter.line_segment(line, Stroke::new(3.0, theme.halo));
                painter.line_segment(line, Stroke::new(1.5, ink));
            }
            knob(painter, theme, at, Some(hue(light)), ink);
        }
        Handle::Target(_) => {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_far_side_is_reached_over_the_outline_without_a_jump() {
        let at = |reach: f64| on_sphere(DVec2::new(0.6, 0.8) * reach, true);
        for step in 0..=200 {
            let reach = f64::from(step) / 100.0;
            assert!((at(reach).length() - 1.0).abs() < 1e-12, "{reach}");
            assert_eq!(at(reach).z >= 0.0, reach <= 1.0, "{reach}");
        }
        assert!(at(0.9999).distance(at(1.0001)) < 0.05);
        assert!(at(2.0).abs_diff_eq(DVec3::NEG_Z, 1e-12) && at(9.0) == at(2.0));
        // A handle on the far side follows the pointer, and crosses the outline to the near side.
        let far = on_sphere(DVec2::new(0.5, 0.0), false);
        assert!(far.abs_diff_eq(DVec3::new(0.5, 0.0, -(0.75_f64.sqrt())), 1e-12));
        assert!(on_sphere(DVec2::new(1.5, 0.0), false).z > 0.0);
    }

    #[test]
    fn a_position_handle_follows_the_pointer_at_its_depth() {
        use luxel::scene::{Lens, Projection};
        let view_from_world = Camera::look_at(DVec3::new(0.0, 2.0, 9.0), DVec3::ZERO, DVec3::Y);
        let size = Size { width: 800, height: 600 };
        for lens in [Lens::Perspective { fov_y_radians: 0.8 }, Lens::Orthographic { height: 6.0 }] {
            let projection = Projection { lens, near: 0.1, far: 50.0 };
            let camera = Camera { view_from_world, projection };
            let from = DVec3::new(1.0, 0.5, -1.0);
            let mut grab = Grab { light: 0, is_target: false, on_sphere: (DVec2::ZERO, true) };
            let sphere = DirectionSphere { centre: Pos2::ZERO, radius: 1.0 };
            let mut moved = |moves_depth, delta| {
                let view = (&camera, size, 2.0);
                drag(&Handle::Position(from), &mut grab, delta, moves_depth, &sphere, view).unwrap()
            };
            let to = moved(false, vec2(30.0, -20.0));
            let places = [from, to].map(|point| project_point(&camera, size, point).unwrap());
            let way = (places[1] - places[0]).truncate();
            assert!(way.abs_diff_eq(DVec2::new(60.0, -40.0), 1e-6), "{lens:?}: {way}");
            let depth = |point| -view_from_world.transform_point3(point).z;
            assert!((depth(to) - depth(from)).abs() < 1e-6, "{lens:?}");
            // Upwards with Shift: away from the eye, at the same point of the picture.
            let deeper = moved(true, vec2(0.0, -20.0));
            let place = project_point(&camera, size, deeper).unwrap();
            assert!(place.truncate().abs_diff_eq(places[0].truncate(), 1e-6), "{lens:?}");
            assert!(depth(deeper) > depth(from) + 0.1, "{lens:?}");
        }
    }
}
