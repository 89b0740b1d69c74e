//! Rectangles and polygons of the window.

use super::AskedOptions;
use crate::camera;
use crate::failure::Failure;
use crate::output;
use luxel::pick::{PickView, Region, SliverHit};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;

impl AskedOptions {
    /// Answers for a part of the window.
    pub(super) fn region(&self, view: &PickView<'_>) -> Result<(), Failure> {
        let region = match (&self.place.rect, &self.place.lasso) {
            (Some(rect), _) => Region::rectangle(rect.x, rect.y, rect.width, rect.height),
            (None, corners) => Region::polygon(corners.as_deref().unwrap_or_default()),
        };
        let region = region.map_err(|error| Failure::Usage(error.to_string()))?;
        let mut hits = view.sliver(&region, self.inclusion());
        let pixels: Option<BTreeMap<usize, u64>> = self.visible.then(|| {
            let seen = view.visible_in(&region);
            seen.into_iter().map(|seen| (seen.object, seen.pixels)).collect()
        });
        if let Some(pixels) = &pixels {
            hits.retain(|hit| pixels.contains_key(&hit.object));
        }
        let told = Told { view, hits: &hits, pixels: pixels.as_ref() };
        if self.json { output::print_json(&told.document()) } else { output::print(&told.text()) }
    }
}

struct Told<'a> {
    view: &'a PickView<'a>,
    hits: &'a [SliverHit],
    /// How many each object owns, if that was asked.
    pixels: Option<&'a BTreeMap<usize, u64>>,
}

impl Told<'_> {
    fn pixels_of(&self, hit: &SliverHit) -> Option<u64> {
        self.pixels.and_then(|pixels| pixels.get(&hit.object).copied())
    }

    fn path(&self, hit: &SliverHit) -> Vec<&str> {
        let picker = self.view.picker();
        picker.scene().path(picker.objects()[hit.object].node)
    }

    fn document(&self) -> Value {
        let hit = |hit: &SliverHit| {
            let path = self.path(hit);
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
            "camera": camera::to_json(self.view.camera(), self.view.size()),
        })
    }

    fn text(&self) -> String {
        let mut text = String::new();
        for hit in self.hits {
            let path = self.path(hit).join("/");
            let path = crate::console::printable(&path);
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
