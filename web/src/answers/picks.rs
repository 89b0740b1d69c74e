//! What is under a point, or in a rectangle.

use crate::error::exception;
use crate::view::ModelView;
use luxel::pick::{Inclusion, PickHit, PickView, Picker, Region};
use luxel::report::{PickReport, RegionReport};
use std::collections::BTreeMap;
use std::sync::Arc;
use wasm_bindgen::JsError;

/// What is visible at a point of the picture.
pub(super) fn hit_at(view: &mut ModelView, at: [f64; 2]) -> Result<Option<PickHit>, JsError> {
    if view.hidden.is_empty() {
        return with_picks(view, |picks| picks.at(at));
    }
    let hits = with_picks(view, |picks| picks.through(at))?;
    Ok(hits.into_iter().find(|hit| !view.hidden.contains(&(hit.object as u32))))
}

/// The name of the object at a point.
pub(super) fn pick(view: &mut ModelView, at: [f64; 2]) -> Result<Option<String>, JsError> {
    let hit = hit_at(view, at)?;
    let scene = view.renderer.scene();
    let object = hit.and_then(|hit| scene.objects().into_iter().nth(hit.object));
    Ok(object.map(|object| scene.nodes[object.node.index()].name.to_string()))
}

pub(super) fn pick_json(
    view: &mut ModelView,
    at: [f64; 2],
    through: bool,
) -> Result<String, JsError> {
    let first = if through { None } else { hit_at(view, at)? };
    let hidden = view.hidden.clone();
    with_picks(view, |picks| {
        let mut hits = match through {
            true => picks.through(at),
            false => first.into_iter().collect(),
        };
        hits.retain(|hit| !hidden.contains(&(hit.object as u32)));
        PickReport::new(picks, at, &hits).to_json().to_string()
    })
}

pub(super) fn pick_rect(
    view: &mut ModelView,
    [x, y, w, h]: [f64; 4],
    visible: bool,
) -> Result<String, JsError> {
    let region = Region::rectangle(x, y, w, h).map_err(exception)?;
    with_picks(view, |picks| {
        let mut hits = picks.sliver(&region, Inclusion::Touching);
        let pixels: Option<BTreeMap<usize, u64>> = visible.then(|| {
            let seen = picks.visible_in(&region);
            seen.into_iter().map(|seen| (seen.object, seen.pixels)).collect()
        });
        if let Some(pixels) = &pixels {
            hits.retain(|hit| pixels.contains_key(&hit.object));
            return RegionReport::new(picks, &hits).with_pixels(pixels).to_json().to_string();
        }
        RegionReport::new(picks, &hits).to_json().to_string()
    })
}

/// Works with what picks see of the view.
fn with_picks<T>(
    view: &mut ModelView,
    work: impl FnOnce(&PickView<'_>) -> T,
) -> Result<T, JsError> {
    if view.picker.is_none() {
        let scene = Arc::clone(view.renderer.scene());
        view.picker = Some(Picker::new(scene).map_err(exception)?);
    }
    let Some(picker) = &view.picker else { return Err(exception("no picker")) };
    let seen = &view.view;
    let picks = PickView::new(picker, seen.camera, seen.size, seen.cull).map_err(exception)?;
    Ok(work(&picks))
}
