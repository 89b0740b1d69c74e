//! What is under a pixel, and why it has its colour.

use crate::error::exception;
use crate::view::ModelView;
use luxel::pick::{Inclusion, PickHit, PickView, Picker, Region};
use luxel::render::{At, Unseen};
use luxel::report::{PickReport, RegionReport, Report};
use std::collections::BTreeMap;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl ModelView {
    /// The object under a point of the picture, by its name; nothing where the background is.
    ///
    /// # Errors
    /// An exception if a mesh has too many triangles for rays.
    pub fn pick(&mut self, x: f64, y: f64) -> Result<Option<String>, JsError> {
        let hit = self.hit_at([x, y])?;
        let scene = self.renderer.scene();
        let object = hit.and_then(|hit| scene.objects().into_iter().nth(hit.object));
        Ok(object.map(|object| scene.nodes[object.node.index()].name.clone()))
    }

    /// What is under a point of the picture, as `luxel pick --at X,Y --json` prints it; with `through` all of it,
    /// nearest first.
    ///
    /// # Errors
    /// An exception if a mesh has too many triangles for rays.
    pub fn pick_json(&mut self, x: f64, y: f64, through: bool) -> Result<String, JsError> {
        let at = [x, y];
        let first = if through { None } else { self.hit_at(at)? };
        let hidden = self.hidden.clone();
        self.with_picks(|picks| {
            let mut hits = match through {
                true => picks.through(at),
                false => first.into_iter().collect(),
            };
            hits.retain(|hit| !hidden.contains(&(hit.object as u32)));
            PickReport::new(picks, at, &hits).to_json().to_string()
        })
    }

    /// The objects in a rectangle of the picture, as `luxel pick --rect X,Y,W,H --json` prints them; with `visible`
    /// only those that are seen there.
    ///
    /// # Errors
    /// An exception for an empty rectangle, and if a mesh has too many triangles for rays.
    pub fn pick_rect(
        &mut self,
        x: f64,
        y: f64,
        w: f64,
        h: f64,
        visible: bool,
    ) -> Result<String, JsError> {
        let region = Region::rectangle(x, y, w, h).map_err(exception)?;
        self.with_picks(|picks| {
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

    /// Why a pixel has its colour: the text of `luxel explain`.
    ///
    /// # Errors
    /// An exception for a place outside of the picture.
    pub fn explain(&self, x: u32, y: u32) -> Result<String, JsError> {
        self.report(x, y, |report| report.to_text())
    }

    /// The same as JSON, as `luxel explain --json` prints it.
    ///
    /// # Errors
    /// An exception for a place outside of the picture.
    pub fn explain_json(&self, x: u32, y: u32) -> Result<String, JsError> {
        self.report(x, y, |report| report.to_json().to_string())
    }

    /// The same as LaTeX, as `luxel explain --latex` prints it.
    ///
    /// # Errors
    /// An exception for a place outside of the picture.
    pub fn explain_latex(&self, x: u32, y: u32) -> Result<String, JsError> {
        self.report(x, y, |report| report.to_latex())
    }
}

impl ModelView {
    fn report(
        &self,
        x: u32,
        y: u32,
        text: impl Fn(&Report<'_>) -> String,
    ) -> Result<String, JsError> {
        let explanation =
            self.renderer.explain(&self.view, At::Pixel([x, y])).map_err(exception)?;
        let unseen = Unseen::new(&self.renderer, &self.view, &explanation).map_err(exception)?;
        let report = Report::new(&explanation, self.renderer.scene(), &self.view);
        Ok(text(&report.with_unseen(&unseen)))
    }

    /// What is visible at a point of the picture.
    pub(crate) fn hit_at(&mut self, at: [f64; 2]) -> Result<Option<PickHit>, JsError> {
        if self.hidden.is_empty() {
            return self.with_picks(|picks| picks.at(at));
        }
        let hits = self.with_picks(|picks| picks.through(at))?;
        Ok(hits.into_iter().find(|hit| !self.hidden.contains(&(hit.object as u32))))
    }

    /// Works with what picks see of the view.
    pub(crate) fn with_picks<T>(
        &mut self,
        work: impl FnOnce(&PickView<'_>) -> T,
    ) -> Result<T, JsError> {
        if self.picker.is_none() {
            let scene = Arc::clone(self.renderer.scene());
            self.picker = Some(Picker::new(scene).map_err(exception)?);
        }
        let Some(picker) = &self.picker else { return Err(exception("no picker")) };
        let view = &self.view;
        let picks = PickView::new(picker, view.camera, view.size, view.cull).map_err(exception)?;
        Ok(work(&picks))
    }
}
