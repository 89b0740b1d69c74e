//! Which passes layers take: all of them one, but for terms of light where surfaces blend.

use crate::frame::{NEVER, Picture, RenderError, Renderer};
use luxel_view::{Layer, LayerValues, View};
use luxel_visibility::CoveragePolicy;
use std::sync::atomic::AtomicBool;

impl Renderer {
    /// Layers of a view in the given order, all from one pass.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub fn layers(&self, view: &View, layers: &[Layer]) -> Result<Vec<LayerValues>, RenderError> {
        let mut values = Vec::new();
        self.layer_pass(&NEVER, view, layers, None, &mut values)?;
        Ok(values)
    }

    /// The picture of [`Renderer::rgba8_into`] and layers of the same view. With one sample a pixel and
    /// nothing that blends, both come from one visibility; else layers take a pass of their own.
    /// `values` may hold layers of an earlier picture, whose memory is used again.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub fn rgba8_with_layers(
        &self,
        view: &View,
        layers: &[Layer],
        picture: &mut Picture<[u8; 4]>,
        values: &mut Vec<LayerValues>,
    ) -> Result<(), RenderError> {
        self.rgba8_with_layers_until(&NEVER, view, layers, picture, values)
    }

    /// [`Renderer::rgba8_with_layers`], which stops early once another thread sets `stop`: tiles in progress are
    /// finished, and the contents of `picture` and `values` are unspecified.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible, or [`RenderError::Stopped`].
    pub fn rgba8_with_layers_until(
        &self,
        stop: &AtomicBool,
        view: &View,
        layers: &[Layer],
        picture: &mut Picture<[u8; 4]>,
        values: &mut Vec<LayerValues>,
    ) -> Result<(), RenderError> {
        if layers.is_empty() {
            values.clear();
            return self.rgba8_until(stop, view, picture);
        }
        let blends = self.has_blended_materials();
        let start = self.now();
        if view.samples == 1 && !blends && view.edges.is_none() {
            self.layer_pass(stop, view, layers, Some(picture), values)?;
        } else {
            self.rgba8_until(stop, view, picture)?;
            self.layer_pass(stop, view, layers, None, values)?;
        }
        picture.stages.frame = self.now() - start;
        Ok(())
    }

    fn layer_pass(
        &self,
        stop: &AtomicBool,
        view: &View,
        layers: &[Layer],
        picture: Option<&mut Picture<[u8; 4]>>,
        values: &mut Vec<LayerValues>,
    ) -> Result<(), RenderError> {
        if self.has_blended_materials() && layers.iter().any(Layer::is_summed) {
            return self.layers_apart(stop, view, layers, values);
        }
        self.one_pass(stop, view, layers, picture, values, CoveragePolicy::NEAREST)
    }

    /// Terms of light from all layers of blended surfaces; all else from the nearest ones.
    fn layers_apart(
        &self,
        stop: &AtomicBool,
        view: &View,
        layers: &[Layer],
        values: &mut Vec<LayerValues>,
    ) -> Result<(), RenderError> {
        let (terms, others): (Vec<_>, Vec<_>) = layers.iter().cloned().partition(Layer::is_summed);
        let (mut of_terms, mut of_others) = (Vec::new(), Vec::new());
        self.one_pass(stop, view, &terms, None, &mut of_terms, CoveragePolicy::DRAWN)?;
        if !others.is_empty() {
            self.one_pass(stop, view, &others, None, &mut of_others, CoveragePolicy::NEAREST)?;
        }
        let (mut of_terms, mut of_others) = (of_terms.into_iter(), of_others.into_iter());
        let next = |layer: &Layer| {
            if layer.is_summed() { of_terms.next() } else { of_others.next() }
        };
        *values = layers.iter().filter_map(next).collect();
        Ok(())
    }
}
