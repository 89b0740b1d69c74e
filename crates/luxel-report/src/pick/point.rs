//! The answer to a pick at one point of the window.

use super::camera::camera_to_json;
use super::path::path_of;
use crate::words::printable;
use luxel_pick::{Element, NearEdge, NearVertex, PickHit, PickView, Snapped, SnappedTo};
use serde_json::{Map, Value, json};
use std::fmt::Write;

/// The hits at a point of the window, for output as text or JSON.
///
/// Positions and normals are in world space, `distance` is that from the eye, `depth` is window
/// depth (0 near, 1 far), barycentrics weight the triangle's first, second and third corner.
#[derive(Clone, Copy)]
pub struct PickReport<'a> {
    view: &'a PickView<'a>,
    at: [f64; 2],
    hits: &'a [PickHit],
    snapped: Option<Option<&'a Snapped>>,
}

impl<'a> PickReport<'a> {
    /// The hits of a view at a point, nearest first. The point is in pixels from the upper left
    /// corner of the window, y down.
    #[must_use]
    pub fn new(view: &'a PickView<'a>, at: [f64; 2], hits: &'a [PickHit]) -> Self {
        Self { view, at, hits, snapped: None }
    }

    /// Adds the snapped feature; `None` if there is none nearby.
    #[must_use]
    pub fn with_snap(self, snapped: Option<&'a Snapped>) -> Self {
        Self { snapped: Some(snapped), ..self }
    }

    /// The answer for people: a line a hit.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        for hit in self.hits {
            let path = path_of(self.view, hit.object).join("/");
            let path = printable(&path);
            let (kind, number) = match hit.element {
                Element::Triangle(number) => ("triangle", number),
                Element::Point(number) => ("point", number),
                Element::Line(number) => ("line", number),
            };
            let [x, y, z] = hit.position.to_array();
            // Writing into a string can't fail.
            let _ = writeln!(
                text,
                "{path}: {kind} {number} at {x:.6} {y:.6} {z:.6}, {:.6} from the eye, depth {:.6}",
                hit.distance, hit.depth
            );
        }
        if text.is_empty() {
            text.push_str("nothing\n");
        }
        if let Some(snapped) = &self.snapped {
            text.push_str(&match snapped {
                Some(snapped) => snapped_text(snapped),
                None => "nothing to snap to\n".to_owned(),
            });
        }
        text
    }

    /// The answer as a JSON document, with the camera of the view; its `Display` writes one line.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let mut document = self.document();
        document.insert("camera".into(), camera_to_json(self.view.camera(), self.view.size()));
        Value::Object(document)
    }

    /// Appends the answer as a line of JSON, for many answers of one view: `camera` is its camera
    /// as JSON ([`camera_to_json`]), written once for all.
    pub fn append_json_line(&self, camera: &str, out: &mut Vec<u8>) {
        let document = Value::Object(self.document()).to_string();
        // Without its opening brace; there is always a list of hits.
        let rest = document.get(1..).unwrap_or_default();
        for part in ["{\"camera\":", camera, ",", rest, "\n"] {
            out.extend_from_slice(part.as_bytes());
        }
    }

    /// The document without the camera.
    fn document(&self) -> Map<String, Value> {
        let mut document = Map::new();
        let hits = self.hits.iter().map(|hit| hit_to_json(self.view, hit));
        document.insert("hits".into(), hits.collect::<Value>());
        document.insert("at".into(), json!(self.at));
        if let Some(snapped) = self.snapped {
            let snapped = snapped.map(|snapped| snapped_to_json(self.view, snapped));
            document.insert("snap".into(), snapped.unwrap_or_default());
        }
        document
    }
}

fn hit_to_json(view: &PickView<'_>, hit: &PickHit) -> Value {
    let path = path_of(view, hit.object);
    let material = view.picker().scene().materials.get(hit.material.index());
    let mut entry = Map::new();
    entry.insert("index".into(), json!(hit.object));
    entry.insert("object".into(), json!(path.last()));
    entry.insert("path".into(), json!(path));
    let (kind, number) = match hit.element {
        Element::Triangle(number) => ("triangle", number),
        Element::Point(number) => ("point", number),
        Element::Line(number) => ("line", number),
    };
    entry.insert("triangle".into(), Value::Null);
    entry.insert(kind.into(), json!(number));
    entry.insert("barycentric".into(), json!(hit.barycentric));
    entry.insert("position".into(), json!(hit.position.to_array()));
    entry.insert("normal".into(), json!(hit.normal));
    entry.insert("geometric_normal".into(), json!(hit.geometric_normal));
    entry.insert("uv".into(), json!(hit.uv));
    entry.insert("color".into(), json!(hit.color));
    entry.insert("distance".into(), json!(hit.distance));
    entry.insert("depth".into(), json!(hit.depth));
    entry.insert("material".into(), json!(material.map(|material| material.name.as_str())));
    if let Some(polygon) = view.polygon_of(hit) {
        entry.insert("polygon".into(), json!(polygon.number));
        entry.insert("vertex".into(), polygon.vertex.map_or(Value::Null, vertex_to_json));
        entry.insert("edge".into(), polygon.edge.map_or(Value::Null, edge_to_json));
    }
    Value::Object(entry)
}

fn vertex_to_json(vertex: NearVertex) -> Value {
    json!({
        "index": vertex.index,
        "position": vertex.position.to_array(),
        "window": vertex.window,
        "pixels": vertex.pixels,
    })
}

fn edge_to_json(edge: NearEdge) -> Value {
    json!({
        "vertices": edge.vertices,
        "position": edge.position.to_array(),
        "window": edge.window,
        "pixels": edge.pixels,
    })
}

fn snapped_to_json(view: &PickView<'_>, snapped: &Snapped) -> Value {
    let (kind, mut entry) = match snapped.to {
        SnappedTo::Vertex(vertex) => ("vertex", vertex_to_json(vertex)),
        SnappedTo::Edge(edge) => ("edge", edge_to_json(edge)),
        SnappedTo::Face { position, window, pixels } => {
            let position = position.to_array();
            ("face", json!({ "position": position, "window": window, "pixels": pixels }))
        }
    };
    entry["kind"] = json!(kind);
    entry["object_index"] = json!(snapped.object);
    entry["object"] = json!(path_of(view, snapped.object).last());
    entry["triangle"] = json!(snapped.triangle);
    entry
}

fn snapped_text(snapped: &Snapped) -> String {
    let (kind, position, pixels) = match snapped.to {
        SnappedTo::Vertex(vertex) => {
            (format!("vertex {}", vertex.index), vertex.position, vertex.pixels)
        }
        SnappedTo::Edge(edge) => {
            let [from, to] = edge.vertices;
            (format!("edge {from}-{to}"), edge.position, edge.pixels)
        }
        SnappedTo::Face { position, pixels, .. } => ("face".to_owned(), position, pixels),
    };
    let [x, y, z] = position.to_array();
    format!("snaps to {kind} at {x:.6} {y:.6} {z:.6}, {pixels:.2} pixels away\n")
}
