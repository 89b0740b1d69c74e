//! The warning of a picture that is burnt out, with the flag that helps.

use luxel::lighting::Tone;
use luxel::render::{RenderError, Renderer, View, auto_exposure};

/// The share of the model from which on it is worth a warning.
const SHARE: f32 = 0.1;

/// The warning, if much of the model is burnt out.
pub(crate) fn warning(renderer: &Renderer, view: &View) -> Result<Option<String>, RenderError> {
    let share = renderer.burnt_out(view)?;
    if share < SHARE {
        return Ok(None);
    }
    let percent = (share * 100.0).round();
    let ev = auto_exposure(renderer.scene(), view).ev;
    let remedy = if ev != 0.0 && ev < view.exposure {
        format!("--exposure auto, here {ev}, brings it back")
    } else if view.tone == Tone::None {
        "a lower --exposure or --tone neutral brings it back".to_owned()
    } else {
        "a lower --exposure brings it back".to_owned()
    };
    let beyond = if view.tone == Tone::None { "more than a stop beyond white" } else { "white" };
    Ok(Some(format!("{percent} % of what is seen of the model is burnt out, {beyond}: {remedy}")))
}
