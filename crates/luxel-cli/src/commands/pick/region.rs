//! Rectangles and polygons in the image.

use super::QueryOptions;
use crate::failure::Failure;
use crate::output;
use luxel::pick::{PickView, Region};
use luxel::report::RegionReport;
use std::collections::BTreeMap;

impl QueryOptions {
    /// Picks a region.
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
        let mut report = RegionReport::new(view, &hits);
        if let Some(pixels) = &pixels {
            report = report.with_pixels(pixels);
        }
        if self.json {
            output::print_json(&report.to_json())
        } else {
            output::print(&report.to_text())
        }
    }
}
