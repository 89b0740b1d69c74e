//! The rays to lights that something stands in the way of, drawn over the picture: from the pixel to what
//! keeps the light away, and dashed from there on.

use super::escape::escaped;
use crate::pixel::report::Report;
use luxel_lighting::LightKind;
use luxel_pick::{Viewport, project};
use luxel_render::{ExplainedLight, Seen};
use luxel_scene::{DVec3, DVec4, Size};
use std::fmt::Write;

/// How far the dashed part of a ray to a light far away goes on, as a part of the way to what is in its way.
const BEYOND: f64 = 1.0;

/// The lights of the first surface or ground that the samples see.
fn lights<'a>(report: &Report<'a>) -> &'a [ExplainedLight] {
    let seen = report.explanation.samples.iter().flat_map(|entry| entry.seen.first());
    let lights = |seen: &'a Seen| -> &'a [ExplainedLight] {
        match seen {
            Seen::Surface(surface) => &surface.lights,
            Seen::Background { ground: Some(ground), .. } => &ground.lights,
            Seen::Background { ground: None, .. } => &[],
        }
    };
    seen.map(lights).find(|lights| !lights.is_empty()).unwrap_or_default()
}

/// The drawing, as a layer over the picture; empty if nothing is in any light's way.
pub(super) fn blocked(report: &Report<'_>) -> String {
    let Size { width, height } = report.view.size;
    let rays: String = lights(report).iter().filter_map(|light| ray(light, report)).collect();
    if rays.is_empty() {
        return rays;
    }
    format!(
        "<svg class=\"rays\" viewBox=\"0 0 {width} {height}\" aria-hidden=\"true\">{rays}</svg>"
    )
}

/// One light's ray; `None` if nothing is in its way, or the way there is not before the eye.
fn ray(light: &ExplainedLight, report: &Report<'_>) -> Option<String> {
    let shadow = light.shadow.as_ref()?;
    let nearest = shadow.blocked_by.first()?;
    let [origin, direction] = shadow.ray?.map(DVec3::from_array);
    let hit = origin + direction * nearest.distance;
    let end = match light.light.kind {
        LightKind::Directional => hit + direction * (BEYOND * nearest.distance),
        _ => DVec3::from_array(light.position),
    };
    let [from, hit] = [window(origin, report)?, window(hit, report)?];
    let mut text = format!(
        "<g><title>{}: {} is in its way</title>{}",
        escaped(&light.name),
        escaped(&nearest.name),
        line("", from, hit),
    );
    if let Some(end) = window(end, report) {
        text += &line(" stroke-dasharray=\"6 7\"", hit, end);
    }
    let [x, y] = hit;
    let reach = f64::from(report.view.size.width) * 0.008;
    for side in [reach, -reach] {
        text += &line("", [x - reach, y - side], [x + reach, y + side]);
    }
    text.push_str("</g>");
    Some(text)
}

fn line(dashes: &str, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> String {
    let mut text = String::new();
    // A light rim below, so that the line is seen on any picture.
    for class in ["rim", "ray"] {
        let _ = write!(
            text,
            "<line class=\"{class}\"{dashes} x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\"/>"
        );
    }
    text
}

/// The pixel, from the upper left, that shows a place; `None` if that is not before the eye.
fn window(place: DVec3, report: &Report<'_>) -> Option<[f64; 2]> {
    let (camera, size) = (&report.view.camera, report.view.size);
    let clip_from_view = camera.projection.clip_from_view(size);
    let DVec4 { w, .. } = clip_from_view * (camera.view_from_world * place.extend(1.0));
    if w <= 0.0 {
        return None;
    }
    let DVec3 { x, y, .. } =
        project(place, &camera.view_from_world, &clip_from_view, Viewport::of(size))?;
    (x.is_finite() && y.is_finite()).then_some([x, f64::from(size.height) - y])
}
