//! A render job: a picture, or one of its layers as a picture.

use luxel::lighting::PictureEncoding;
use luxel::render::{Layer, LayerImage, LayerValues, RenderError, Renderer, View, layer_rgb8};

/// One picture to render.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RenderJob {
    pub(crate) view: View,
    /// The layer to show instead of the picture.
    pub(crate) layer: Option<Layer>,
}

/// The object of pixels that show none.
const NO_OBJECT: u32 = u32::MAX;

impl RenderJob {
    /// Renders it: red, green, blue, alpha.
    pub(crate) fn render(&self, renderer: &Renderer) -> Result<Vec<[u8; 4]>, RenderError> {
        let Some(layer) = &self.layer else {
            return Ok(renderer.rgba8(&self.view)?.pixels);
        };
        // A light that is off has no layer, and contributes nothing.
        let layers = match layer {
            Layer::Light(name) if !self.view.lights.iter().any(|light| light.name == *name) => {
                &[Layer::Object, Layer::Object]
            }
            layer => &[Layer::Object, layer.clone()],
        };
        let mut values = renderer.layers(&self.view, layers)?.into_iter();
        let (Some(LayerValues::U32(objects)), Some(values)) = (values.next(), values.next()) else {
            return Ok(Vec::new());
        };
        let colors = match (layers, values) {
            ([_, Layer::Object], _) if *layer != Layer::Object => vec![[0; 3]; objects.len()],
            (_, LayerValues::F32(values)) if is_radiance(layer) => {
                encoded(&values, self.view.encoding)
            }
            (_, values) => {
                layer_rgb8(&LayerImage { name: layer.name(), channels: layer.channels(), values })
            }
        };
        let pixel = |([r, g, b], object): ([u8; 3], u32)| {
            [r, g, b, if object == NO_OBJECT { 0 } else { 255 }]
        };
        Ok(colors.into_iter().zip(objects).map(pixel).collect())
    }
}

/// Whether a layer holds radiance, which is encoded as pictures are.
fn is_radiance(layer: &Layer) -> bool {
    layer.is_summed()
}

fn encoded(values: &[f32], encoding: PictureEncoding) -> Vec<[u8; 3]> {
    let pixel = |light: &[f32]| std::array::from_fn(|channel| encoding.byte(light[channel]));
    values.chunks_exact(3).map(pixel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::render::Execution;
    use luxel::scene::{Size, demos};

    const SIZE: Size = Size { width: 80, height: 60 };

    #[test]
    fn terms_of_light_add_up_to_the_picture_of_one_sample() {
        let scene = demos::demo("plane").unwrap();
        let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
        let mut view = luxel::default_view(&scene, SIZE);
        view.samples = 1;
        view.encoding = PictureEncoding::None;
        let drawn = |layer| RenderJob { view: view.clone(), layer }.render(&renderer).unwrap();
        let whole = drawn(None);
        let terms = [Layer::Ambient, Layer::Diffuse, Layer::Specular, Layer::Emission];
        let terms: Vec<_> = terms.map(|term| drawn(Some(term))).into();
        let mut covered = 0;
        for (at, pixel) in whole.iter().enumerate() {
            assert!(terms.iter().all(|term| term[at][3] == pixel[3]), "{at}");
            covered += usize::from(pixel[3] > 0);
            for channel in 0..3 {
                let sum: i32 = terms.iter().map(|term| i32::from(term[at][channel])).sum();
                // Each term is rounded.
                assert!((sum.min(255) - i32::from(pixel[channel])).abs() <= 2, "{at}: {sum}");
            }
        }
        assert!(covered > 500, "{covered}");
    }

    #[test]
    fn a_light_that_is_off_leaves_the_objects_black() {
        let scene = demos::demo("plane").unwrap();
        let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
        let mut view = luxel::default_view(&scene, SIZE);
        let name = view.lights[0].name.clone();
        let layer = Some(Layer::Light(name));
        let on = RenderJob { view: view.clone(), layer: layer.clone() }.render(&renderer).unwrap();
        view.lights.remove(0);
        let off = RenderJob { view, layer }.render(&renderer).unwrap();
        assert!(on.iter().any(|pixel| pixel[0] > 50));
        assert!(off.iter().all(|[r, g, b, _]| r + g + b == 0));
        assert!(off.iter().zip(&on).all(|(a, b)| a[3] == b[3]));
    }
}
