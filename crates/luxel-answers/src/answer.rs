//! What is told of hits, as JSON and as text.

use crate::printable;
use luxel_pick::{Element, NearEdge, NearVertex, PickHit, PickView, Snapped, SnappedTo};
use serde_json::{Map, Value, json};
use std::fmt::Write;

/// What was found at a place.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The place, in pixels.
    pub at: [f64; 2],
    /// What is there, nearest first.
    pub hits: Vec<PickHit>,
    /// Where it snaps to, if that was asked.
    pub snapped: Option<Option<Snapped>>,
}

/// The answer as a JSON document.
#[must_use]
pub fn document(view: &PickView<'_>, answer: &Answer) -> Map<String, Value> {
    let mut document = Map::new();
    let hits = answer.hits.iter().map(|hit| hit_to_json(view, hit));
    document.insert("hits".into(), hits.collect::<Value>());
    document.insert("at".into(), json!(answer.at));
    if let Some(snapped) = &answer.snapped {
        let snapped = snapped.as_ref();
        document.insert(
            "snap".into(),
            snapped.map_or(Value::Null, |snapped| snapped_to_json(view, snapped)),
        );
    }
    document
}

fn hit_to_json(view: &PickView<'_>, hit: &PickHit) -> Value {
    let picker = view.picker();
    let scene = picker.scene();
    let path = scene.path(picker.objects()[hit.object].node);
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
    entry.insert("material".into(), json!(scene.materials[hit.material.index()].name));
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
    let picker = view.picker();
    let node = picker.objects()[snapped.object].node;
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
    entry["object"] = json!(picker.scene().nodes[node.index()].name);
    entry["triangle"] = json!(snapped.triangle);
    entry
}

/// Appends the answer as a line of JSON; `camera` is that of the view as JSON, written once for all.
pub fn append_json(view: &PickView<'_>, answer: &Answer, camera: &str, bytes: &mut Vec<u8>) {
    let document = Value::Object(document(view, answer)).to_string();
    // After the opening brace; there is always a hit list to follow.
    let rest = document.get(1..).unwrap_or_default();
    for part in ["{\"camera\":", camera, ",", rest, "\n"] {
        bytes.extend_from_slice(part.as_bytes());
    }
}

/// The answer for people: a line a hit.
#[must_use]
pub fn text(view: &PickView<'_>, answer: &Answer) -> String {
    let picker = view.picker();
    let mut text = String::new();
    for hit in &answer.hits {
        let path = picker.scene().path(picker.objects()[hit.object].node).join("/");
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
    if let Some(snapped) = &answer.snapped {
        text.push_str(&match snapped {
            Some(snapped) => snapped_text(snapped),
            None => "nothing to snap to\n".to_owned(),
        });
    }
    text
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
