//! The findings as JSON.

use crate::finding::{Finding, Kind, Place};
use crate::report::Report;
use luxel_scene::Scene;
use serde_json::{Value, json};

impl Report {
    /// The list of findings of a scene: `kind`, `count`, `severity` and `pixels` where known, `places`, `cure`
    /// in the words of `cure`, and the `color` of marks as in CSS.
    #[must_use]
    pub fn to_json(&self, scene: &Scene, cure: impl Fn(Kind) -> String) -> Value {
        let objects = scene.objects();
        let place = |place: &Place| {
            let node = objects[place.object as usize].node;
            json!({
                "index": place.object,
                "object": scene.nodes[node.index()].name.as_str(),
                "path": scene.path(node),
                "triangle": place.triangle,
                "position": place.position.to_array(),
            })
        };
        let finding = |finding: &Finding| {
            let [r, g, b] = finding.kind.rgb8();
            let mut entry = json!({
                "kind": finding.kind.name(),
                "count": finding.count,
                "severity": finding.severity,
                "places": finding.places.iter().map(place).collect::<Value>(),
                "cure": cure(finding.kind),
                "color": format!("#{r:02x}{g:02x}{b:02x}"),
            });
            if let Some(pixels) = finding.pixels {
                entry["pixels"] = json!(pixels);
            }
            entry
        };
        self.findings.iter().map(finding).collect()
    }
}
