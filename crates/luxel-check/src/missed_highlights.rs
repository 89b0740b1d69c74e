//! Highlights lost to per-vertex lighting, and drift of screen-space interpolation, measured by rendering
//! the view with per-pixel shading and perspective interpolation.

use crate::finding::{Finding, Kind};
use crate::report::{Report, Setup, Spot, place};
use crate::severity::largest_difference;
use luxel_render::{Interpolation, Layer, LayerValues, Renderer, Shading, ShadingMode, View};
use luxel_scene::Scene;
use std::collections::BTreeSet;

/// Whether a mode lights vertices, and so may miss highlights between them.
pub(crate) const fn lights_vertices(mode: ShadingMode) -> bool {
    matches!(mode, ShadingMode::Gouraud | ShadingMode::Subdivided { .. })
}

/// Adds the highlights that the view loses, and measures severities.
pub(crate) fn measure(report: &mut Report, scene: &Scene, setup: &Setup) {
    let is_of_shading = |kind| matches!(kind, Kind::MissedHighlight | Kind::ScreenDrift);
    let shading = setup.view.shading;
    let may_miss = lights_vertices(shading.mode);
    if !may_miss && !report.findings.iter().any(|finding| is_of_shading(finding.kind)) {
        return;
    }
    let mut drawn = scene.clone();
    drawn.compute_normals(&setup.normals);
    drawn.compute_tangents();
    let Ok(renderer) = Renderer::new(drawn, &setup.execution) else { return };
    // One sample, so that a pixel shows a single triangle.
    let view = setup.view.clone().with_samples(1).with_edges(None);
    let draw = |shading: Shading| {
        renderer.rgba8(&view.clone().with_shading(shading)).ok().map(|picture| picture.pixels)
    };
    let Some(before) = draw(shading) else { return };
    if may_miss && let Some(after) = draw(Shading { mode: ShadingMode::Phong, ..shading }) {
        let missed = triangles_with_loss(&renderer, &view, &before, &after);
        add(report, scene, &missed);
        let of_highlights = |finding: &&mut Finding| finding.kind == Kind::MissedHighlight;
        if let Some(finding) = report.findings.iter_mut().find(of_highlights) {
            finding.severity = Some(largest_difference(&before, &after));
        }
    }
    let of_drift = |finding: &&mut Finding| finding.kind == Kind::ScreenDrift;
    if let Some(finding) = report.findings.iter_mut().find(of_drift) {
        let after = draw(Shading { interpolation: Interpolation::Perspective, ..shading });
        finding.severity = after.map(|after| largest_difference(&before, &after));
    }
}

/// The triangles, by object and index, of pixels that lost light.
fn triangles_with_loss(
    renderer: &Renderer,
    view: &View,
    before: &[[u8; 4]],
    after: &[[u8; 4]],
) -> BTreeSet<(u32, u32)> {
    let Ok(layers) = renderer.layers(view, &[Layer::Object, Layer::Triangle]) else {
        return BTreeSet::new();
    };
    let [LayerValues::U32(objects), LayerValues::U32(triangles)] = &layers[..] else {
        return BTreeSet::new();
    };
    let lacks = |(before, after): (&[u8; 4], &[u8; 4])| {
        let channels = before.iter().zip(after).take(3);
        let lost = channels.map(|(before, after)| after.saturating_sub(*before)).max();
        f32::from(lost.unwrap_or(0)) >= Setup::LEAST_HIGHLIGHT
    };
    let owners = objects.iter().zip(triangles);
    let pixels = before.iter().zip(after).zip(owners);
    // Points and lines have no triangles, the background has no object either.
    let of_triangles = |&(_, (_, &triangle)): &(_, (&u32, &u32))| triangle != u32::MAX;
    pixels
        .filter(|(colors, _)| lacks(*colors))
        .filter(of_triangles)
        .map(|(_, (&object, &triangle))| (object, triangle))
        .collect()
}

/// Reports triangles that have not been reported yet.
fn add(report: &mut Report, scene: &Scene, missed: &BTreeSet<(u32, u32)>) {
    let kind = Kind::MissedHighlight;
    let reported: BTreeSet<(u32, u32)> = report
        .spots
        .iter()
        .filter_map(|&(of, object, spot)| match spot {
            Spot::Triangle(triangle) if of == kind => Some((object, triangle)),
            _ => None,
        })
        .collect();
    let objects = scene.objects();
    let new: Vec<_> = missed.difference(&reported).copied().collect();
    if new.is_empty() {
        return;
    }
    let at = report.findings.iter().position(|finding| finding.kind >= kind);
    let at = at.unwrap_or(report.findings.len());
    if report.findings.get(at).is_none_or(|finding| finding.kind != kind) {
        let none = Finding { kind, count: 0, severity: None, pixels: None, places: Vec::new() };
        report.findings.insert(at, none);
    }
    let finding = &mut report.findings[at];
    for (number, triangle) in new {
        let Some(object) = objects.get(number as usize) else { continue };
        let spot = Spot::Triangle(triangle);
        finding.count += 1;
        if finding.places.len() < Setup::MOST_PLACES {
            let mesh = &scene.mesh_of(object);
            finding.places.push(place(number, object, mesh, spot));
        }
        report.spots.push((kind, number, spot));
    }
}
