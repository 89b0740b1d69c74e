//! What can be chosen: reflection models with their parameters, shading modes, tone curves.

use crate::model::Model;
use luxel::lighting::{Parameter, REFLECTION_MODELS, ReflectionModel, Tone};
use luxel::render::ShadingMode;
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Model {
    /// The choices of settings, as JSON: `reflections`, `shadings`, `tones`, each with its name and help.
    pub fn vocabulary() -> String {
        let choice = |name: &str, help: &str| json!({ "name": name, "help": help });
        json!({
            "reflections": REFLECTION_MODELS.iter().copied().map(reflection).collect::<Value>(),
            "shadings": ShadingMode::ALL.map(|mode| choice(mode.name(), mode.help())),
            "tones": Tone::ALL.map(|tone| choice(tone.name(), tone.help())),
        })
        .to_string()
    }
}

/// A reflection model with its parameters.
fn reflection(model: &ReflectionModel) -> Value {
    let own = model.own.iter().map(|own| &own.parameter);
    let all = model.parameters.iter().copied().chain(own);
    json!({
        "name": model.name,
        "help": model.help,
        "formula": model.formula,
        "source": model.source,
        "parameters": all.map(parameter).collect::<Value>(),
    })
}

fn parameter(parameter: &Parameter) -> Value {
    let Parameter { name, symbol, help, is_whole, slider_end, default, .. } = parameter;
    json!({
        "name": name,
        "symbol": symbol,
        "help": help,
        "is_whole": is_whole,
        "slider_end": slider_end,
        "default": default,
    })
}
