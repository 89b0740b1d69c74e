//! The sentences that all formats share.

use super::hint::Hint;
use super::report::Report;
use crate::words::{color, model_name, number};
use luxel_lighting::{PictureEncoding, encode_srgb};
use luxel_render::{
    ExplainedSample, ExplainedSurface, NEAREST_WITHIN, Seen, ShadingMode, SurfaceBelow,
};
use luxel_scene::Scene;

/// Most surfaces behind the visible one that are listed.
const MOST_BEHIND: usize = 5;

/// How many of the samples an entry is about.
pub(crate) fn share(entry: &ExplainedSample) -> String {
    if entry.weight == 1.0 {
        return "the pixel".to_owned();
    }
    let count = entry.covers.len() as f32;
    let all = (count / entry.weight).round();
    format!("{count} of {all} samples: it")
}

/// An object's path.
fn path_of(object: usize, scene: &Scene) -> Option<String> {
    let objects = scene.objects();
    objects.get(object).map(|object| scene.path(object.node).join(" / "))
}

/// The part of an object: `triangle 12 of `.
pub(crate) fn part_of(triangle: Option<u32>) -> String {
    match triangle {
        Some(triangle) => format!("triangle {triangle} of "),
        None => "a point or line of ".to_owned(),
    }
}

/// The path of a surface's object.
pub(crate) fn surface_path(surface: &ExplainedSurface, scene: &Scene) -> String {
    path_of(surface.object, scene).unwrap_or_else(|| surface.name.clone())
}

fn below(surface: &SurfaceBelow, scene: &Scene) -> String {
    let path = path_of(surface.object, scene).unwrap_or_default();
    format!("{}{path}, {} away", part_of(surface.triangle), number(surface.z as f32))
}

/// The surfaces that the samples of an entry don't show, sentence by sentence: a label and the
/// rest.
pub(crate) fn why_not_seen(index: usize, report: &Report<'_>) -> Vec<(&'static str, String)> {
    let mut sentences = Vec::new();
    let Some(hidden) = report.unseen.and_then(|unseen| unseen.entries.get(index)) else {
        return sentences;
    };
    for back in &hidden.culled {
        let why = (report.hint_text)(Hint::of_culling(report.view.cull));
        let text =
            format!("{}, would be seen here, but shows its back: {why}", below(back, report.scene));
        sentences.push(("not drawn", text));
    }
    let behind = &hidden.behind;
    if !behind.is_empty() {
        let mut listed: Vec<_> =
            behind.iter().take(MOST_BEHIND).map(|surface| below(surface, report.scene)).collect();
        if behind.len() > MOST_BEHIND {
            listed.push(format!("and {} more", behind.len() - MOST_BEHIND));
        }
        sentences.push(("hidden", listed.join("; ")));
    }
    sentences
}

/// The objects next to an uncovered pixel.
pub(crate) fn nearest(report: &Report<'_>) -> Option<String> {
    let surface = |seen: &Seen| seen.surface().is_some();
    if report.explanation.samples.iter().any(|entry| entry.seen.iter().any(surface)) {
        return None;
    }
    Some(match report.unseen?.nearest {
        Some(nearest) => {
            let path = path_of(nearest.object, report.scene).unwrap_or_default();
            let [x, y] = nearest.pixel;
            format!(
                "nothing covers the pixel; the nearest thing is {path}, {:.1} pixels away at ({x}, {y})",
                nearest.distance
            )
        }
        None => format!(
            "nothing covers the pixel, and nothing lies within {} pixels of it",
            NEAREST_WITHIN
        ),
    })
}

/// The name of a point at which interpolated light was evaluated: `corner 2 of 3`.
pub(crate) fn point_name(at: usize, count: usize, report: &Report<'_>) -> String {
    match report.view.shading.mode {
        ShadingMode::Flat => "the polygon's centroid".to_owned(),
        ShadingMode::Subdivided { .. } => format!("corner {} of {count} of a piece", at + 1),
        ShadingMode::Gouraud | ShadingMode::Phong => format!("corner {} of {count}", at + 1),
    }
}

/// A channel's value times 255 on its way to a byte.
pub(crate) fn encoded(value: f32, encoding: PictureEncoding) -> f64 {
    let unit = f64::from(value).clamp(0.0, 1.0);
    255.0
        * match encoding {
            PictureEncoding::Srgb => encode_srgb(unit),
            PictureEncoding::None => unit,
        }
}

/// The material of a surface.
pub(crate) fn material(surface: &ExplainedSurface) -> String {
    let material = &surface.material;
    let mut text =
        if material.name.is_empty() { String::new() } else { format!("{}, ", material.name) };
    text += &model_name(&material.constants.reflection);
    text += &format!("   O_d = {}", color(material.reflectance.diffuse.lane(0)));
    text
}
