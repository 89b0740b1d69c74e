//! What all pages say in the same words.

use super::Told;
use super::equation::{LitPlace, color, number};
use luxel::lighting::{Light, LightKind, PictureEncoding, encode_srgb};
use luxel::render::{
    Cull, ExplainedSample, ExplainedSurface, NEAREST_WITHIN, Seen, ShadingMode, SurfaceBelow,
};
use luxel::scene::Scene;

/// Surfaces behind what is seen that are told of one by one.
pub(super) const MOST_BEHIND: usize = 5;

/// How many of the samples an entry is about.
pub(super) fn share(entry: &ExplainedSample) -> String {
    if entry.weight == 1.0 {
        return "the pixel".to_owned();
    }
    let count = entry.covers.len() as f32;
    let all = (count / entry.weight).round();
    format!("{count} of {all} samples: it")
}

/// The kind as `--light` names it.
pub(super) fn kind_name(light: &Light) -> &'static str {
    match light.kind {
        LightKind::Ambient => "ambient",
        LightKind::Directional => "directional",
        LightKind::Point => "point",
        LightKind::Spot(_) => "spot",
    }
}

/// An object's path.
pub(super) fn path_of(object: usize, scene: &Scene) -> Option<String> {
    let objects = scene.objects();
    objects.get(object).map(|object| scene.path(object.node).join(" / "))
}

/// What of an object it is: `triangle 12 of `.
pub(super) fn part_of(triangle: Option<u32>) -> String {
    match triangle {
        Some(triangle) => format!("triangle {triangle} of "),
        None => "a point or line of ".to_owned(),
    }
}

/// The path of a surface's object.
pub(super) fn surface_path(surface: &ExplainedSurface, scene: &Scene) -> String {
    path_of(surface.object, scene).unwrap_or_else(|| surface.name.clone())
}

fn below(surface: &SurfaceBelow, scene: &Scene) -> String {
    let path = path_of(surface.object, scene).unwrap_or_default();
    format!("{}{path}, {} away", part_of(surface.triangle), number(surface.z as f32))
}

/// What isn't seen at an entry's samples, sentence by sentence: a label and the rest.
pub(super) fn why_not_seen(place: usize, told: &Told<'_>) -> Vec<(&'static str, String)> {
    let mut sentences = Vec::new();
    let Some(hidden) = told.unseen.entries.get(place) else { return sentences };
    for back in &hidden.culled {
        let why = match told.view.cull {
            Cull::Back => "--cull back leaves such faces out",
            Cull::Auto | Cull::None => "its material shows one side only",
        };
        let text =
            format!("{}, would be seen here, but shows its back: {why}", below(back, told.scene));
        sentences.push(("not drawn", text));
    }
    let behind = &hidden.behind;
    if !behind.is_empty() {
        let mut told_of: Vec<_> =
            behind.iter().take(MOST_BEHIND).map(|surface| below(surface, told.scene)).collect();
        if behind.len() > MOST_BEHIND {
            told_of.push(format!("and {} more", behind.len() - MOST_BEHIND));
        }
        sentences.push(("hidden", told_of.join("; ")));
    }
    sentences
}

/// What lies next to a pixel that nothing covers.
pub(super) fn nearest(told: &Told<'_>) -> Option<String> {
    let surface = |seen: &Seen| seen.surface().is_some();
    if told.explanation.samples.iter().any(|entry| entry.seen.iter().any(surface)) {
        return None;
    }
    Some(match told.unseen.nearest {
        Some(nearest) => {
            let path = path_of(nearest.object, told.scene).unwrap_or_default();
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

/// Where light was computed that is interpolated to a sample: `corner 2 of 3`.
pub(super) fn place_name(at: usize, count: usize, told: &Told<'_>) -> String {
    match told.view.shading.mode {
        ShadingMode::Flat => "the polygon's centroid".to_owned(),
        ShadingMode::Subdivided { .. } => format!("corner {} of {count} of a piece", at + 1),
        ShadingMode::Gouraud | ShadingMode::Phong => format!("corner {} of {count}", at + 1),
    }
}

/// How interpolated light comes from the places where it was computed.
pub(super) struct Mixture {
    /// What is added: weights and light. Nothing where light was computed at the sample.
    pub(super) parts: Vec<(f32, [f32; 3])>,
    /// What the sum is multiplied by, if it is.
    pub(super) texture: Option<[f32; 3]>,
}

impl Mixture {
    /// Of a surface and its places.
    pub(super) fn of(surface: &ExplainedSurface, places: &[LitPlace<'_>]) -> Self {
        let texture = surface.texture;
        Self {
            parts: places.iter().filter_map(|place| place.share).collect(),
            texture: (texture != [1.0; 3]).then_some(texture),
        }
    }
}

/// A channel's value times 255 on its way to a byte.
pub(super) fn encoded(value: f32, encoding: PictureEncoding) -> f64 {
    let unit = f64::from(value).clamp(0.0, 1.0);
    255.0
        * match encoding {
            PictureEncoding::Srgb => encode_srgb(unit),
            PictureEncoding::None => unit,
        }
}

/// What a surface is made of.
pub(super) fn material(surface: &ExplainedSurface) -> String {
    let material = &surface.material;
    let mut text =
        if material.name.is_empty() { String::new() } else { format!("{}, ", material.name) };
    text += &super::equation::model_name(&material.constants.reflection);
    text += &format!("   O_d = {}", color(material.reflectance.diffuse.lane(0)));
    text
}

/// With a capital letter.
pub(super) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// A unit vector's coordinate, without the sign of what rounds to 0.
pub(super) fn coordinate(value: f32) -> String {
    let text = format!("{value:.3}");
    if text == "-0.000" { "0.000".to_owned() } else { text }
}
