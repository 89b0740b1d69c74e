//! The ledger of a pixel for a page: its terms as lines, and its vectors as they lie in the picture.

use crate::error::exception;
use crate::view::ModelView;
use luxel::render::{At, ExplainedSurface, Explanation, Seen, Unseen};
use luxel::report::{
    LedgerFactor, LedgerLine, LedgerVector, Report, TermKind, VectorKind, ledger_lines,
    ledger_vectors, number, term_sums,
};
use luxel::scene::DVec3;
use serde_json::{Value, json};
use wasm_bindgen::JsError;

pub(super) fn ledger(view: &ModelView, at: [u32; 2]) -> Result<String, JsError> {
    let explanation = view.renderer.explain(&view.view, At::Pixel(at)).map_err(exception)?;
    let unseen = Unseen::new(&view.renderer, &view.view, &explanation).map_err(exception)?;
    let report = Report::new(&explanation, view.renderer.scene(), &view.view);
    let hints = report.with_unseen(&unseen).hints();
    Ok(json!({
        "pixel": explanation.pixel,
        "rgba8": explanation.rgba8,
        "samples": explanation.samples.iter().map(|sample| {
            let seen = sample.seen.iter().map(|seen| surface_or_background(view, seen, &explanation));
            json!({ "weight": sample.weight, "layers": seen.collect::<Value>() })
        }).collect::<Value>(),
        "hints": hints.into_iter().map(|hint| hint.text()).collect::<Value>(),
    })
    .to_string())
}

fn surface_or_background(view: &ModelView, seen: &Seen, explanation: &Explanation) -> Value {
    let surface = match seen {
        Seen::Background { color, alpha, ground } => {
            let what = if ground.is_some() { "ground" } else { "background" };
            return json!({ "what": what, "color": color, "alpha": alpha });
        }
        Seen::Surface(surface) => surface,
    };
    let scene = view.renderer.scene();
    let object = view.renderer.objects().get(surface.object);
    let path = object.map(|object| scene.path(object.node)).unwrap_or_default();
    let vectors = ledger_vectors(surface);
    json!({
        "what": "surface",
        "object": surface.name,
        "path": path,
        "triangle": surface.triangle,
        "barycentric": surface.barycentric,
        "position": surface.position,
        "material": surface.material.name,
        "alpha": surface.alpha,
        "terms": terms(surface),
        "sum": surface.sum,
        "lines": ledger_lines(surface, &explanation.display).iter().filter_map(line).collect::<Value>(),
        "vectors": vectors.iter().map(|vector| vector_in(view, vector)).collect::<Value>(),
    })
}

/// A vector as it lies in the picture: x to the right, y down, in parts of its length.
fn vector_in(view: &ModelView, of: &LedgerVector) -> Value {
    let LedgerVector { kind, name, vector, cosine, light } = of;
    let vector = DVec3::from_array(vector.map(f64::from));
    let in_view = view.view.camera.view_from_world.transform_vector3(vector);
    let kind = match kind {
        VectorKind::Normal => "normal",
        VectorKind::View => "view",
        VectorKind::ToLight => "light",
        VectorKind::Highlight => "highlight",
    };
    json!({
        "kind": kind,
        "name": name,
        "light": light,
        "cosine": cosine,
        "vector": vector.to_array(),
        "picture": [in_view.x, -in_view.y],
    })
}

/// The terms that reach the eye, summed by kind.
fn terms(surface: &ExplainedSurface) -> Value {
    let clear = surface.fog.map_or(1.0, |(factor, _)| factor);
    let fog = surface.fog.map(|(factor, color)| color.map(|channel| channel * (1.0 - factor)));
    let seen = |(kind, value): (TermKind, [f32; 3])| (kind, value.map(|channel| channel * clear));
    let all =
        term_sums(surface).map(seen).into_iter().chain([(TermKind::Fog, fog.unwrap_or_default())]);
    Value::Object(all.map(|(kind, value)| (kind.name().to_owned(), json!(value))).collect())
}

fn line(line: &LedgerLine) -> Option<Value> {
    let factor = |factor: &LedgerFactor| json!({ "symbol": factor.symbol, "meaning": factor.meaning, "number": factor.number });
    let color = |value: &[f32; 3]| value.map(number);
    Some(match line {
        LedgerLine::Heading { name, facts } => {
            json!({ "what": "heading", "name": name, "facts": facts })
        }
        LedgerLine::Term { kind, name, factors, value, is_part } => json!({
            "what": "term",
            "kind": kind.name(),
            "name": name,
            "factors": factors.iter().map(factor).collect::<Value>(),
            "value": color(value),
            "is_part": is_part,
        }),
        LedgerLine::Note(text) => json!({ "what": "note", "text": text }),
        LedgerLine::Sum { kind, name, value, note } => json!({
            "what": "sum",
            "kind": kind.name(),
            "name": name,
            "value": color(value),
            "note": note,
        }),
        _ => return None,
    })
}
