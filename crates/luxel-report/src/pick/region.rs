//! The answer to a pick in a rectangle or polygon of the window.

use super::camera::camera_to_json;
use super::path::path_of;
use crate::words::printable;
use luxel_pick::{PickView, SliverHit};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The objects in a region of the window, to be written as text or JSON. `z_min` and `z_max` are window
/// depths (0 near, 1 far).
#[derive(Clone, Copy)]
pub struct RegionReport<'a> {
    view: &'a PickView<'a>,
    hits: &'a [SliverHit],
    pixels: Option<&'a BTreeMap<usize, u64>>,
}

impl<'a> RegionReport<'a> {
    /// The objects that a region of a view holds.
    #[must_use]
    pub fn new(view: &'a PickView<'a>, hits: &'a [SliverHit]) -> Self {
        Self { view, hits, pixels: None }
    }

    /// Adds how many pixels of the region show each object, by its index.
    #[must_use]
    pub fn with_pixels(self, pixels: &'a BTreeMap<usize, u64>) -> Self {
        Self { pixels: Some(pixels), ..self }
    }

    fn pixels_of(&self, hit: &SliverHit) -> Option<u64> {
        self.pixels.and_then(|pixels| pixels.get(&hit.object).copied())
    }

    /// The answer as a JSON document, with the camera of the view; its `Display` writes one line.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let hit = |hit: &SliverHit| {
            let path = path_of(self.view, hit.object);
            let mut entry = json!({
                "index": hit.object,
                "object": path.last(),
                "path": path,
                "names": path,
                "z_min": hit.z_min,
                "z_max": hit.z_max,
                "triangles": hit.triangles,
            });
            if hit.strokes > 0 {
                entry["points_and_lines"] = json!(hit.strokes);
            }
            if let Some(pixels) = self.pixels_of(hit) {
                entry["pixels"] = json!(pixels);
            }
            entry
        };
        json!({
            "hits": self.hits.iter().map(hit).collect::<Value>(),
            "camera": camera_to_json(self.view.camera(), self.view.size()),
        })
    }

    /// The answer for people: a line an object.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        for hit in self.hits {
            let path = path_of(self.view, hit.object).join("/");
            let path = printable(&path);
            // Writing into a string can't fail.
            let _ = write!(
                text,
                "{path}: depth {:.6} to {:.6}, {} triangles",
                hit.z_min, hit.z_max, hit.triangles
            );
            if hit.strokes > 0 {
                let _ = write!(text, ", {} points and lines", hit.strokes);
            }
            if let Some(pixels) = self.pixels_of(hit) {
                let _ = write!(text, ", {pixels} pixels");
            }
            text.push('\n');
        }
        if text.is_empty() { "nothing\n".to_owned() } else { text }
    }
}
