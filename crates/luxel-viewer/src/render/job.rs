//! A render job: a picture, or one of its layers as a picture.

use luxel::lighting::PictureEncoding;
use luxel::render::{
    Layer, LayerImage, LayerValues, Picture, RenderError, Renderer, View, layer_rgb8,
};
use std::sync::atomic::{AtomicBool, Ordering};

/// One picture to render.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RenderJob {
    pub(crate) view: View,
    /// The layer to show instead of the picture.
    pub(crate) layer: Option<Layer>,
}

/// The object of pixels that show none.
const NO_OBJECT: u32 = u32::MAX;

/// The rays of a sample to an extended light, and those of openness, while something moves.
const MOVING_RAYS: u32 = 2;
/// The same in the first picture at rest.
const FIRST_RAYS: u32 = 4;
/// How many tiles each thread draws between two looks at whether the picture is still wanted.
const TILES_AT_ONCE: usize = 4;

impl RenderJob {
    /// The same job while something moves: one sample, few rays. Both only add noise: the picture is as
    /// bright as the one at rest.
    pub(crate) fn while_moving(mut self) -> Self {
        self.limit(MOVING_RAYS);
        self
    }

    /// The same job as the first picture at rest.
    pub(crate) fn first(mut self) -> Self {
        self.limit(FIRST_RAYS);
        self
    }

    fn limit(&mut self, rays: u32) {
        let view = &mut self.view;
        view.samples = 1;
        // The ground has openness without `ambient_occlusion`, too.
        if view.ground {
            view.ambient_occlusion.get_or_insert_default();
        }
        view.light_rays = view.light_rays.min(rays);
        if let Some(occlusion) = &mut view.ambient_occlusion {
            occlusion.rays = occlusion.rays.min(rays);
        }
    }

    /// Whether its light takes rays, which take time.
    pub(crate) fn traces_rays(&self) -> bool {
        self.view.shadows || self.view.ground || self.view.ambient_occlusion.is_some()
    }

    /// Renders it: red, green, blue, alpha; `None` if it was interrupted.
    pub(crate) fn render(
        &self,
        renderer: &Renderer,
        is_interrupted: &AtomicBool,
    ) -> Result<Option<Vec<[u8; 4]>>, RenderError> {
        if self.layer.is_some() {
            return self.render_layer(renderer).map(Some);
        }
        let mut picture = Picture::default();
        let threads = renderer.threads();
        let is_whole = renderer.with_tiles(&self.view, |tiles| {
            let [across, down] = tiles.count();
            let parts = if self.traces_rays() {
                (across * down).div_ceil(TILES_AT_ONCE * threads)
            } else {
                1
            };
            (0..parts).all(|part| {
                let is_wanted = part == 0 || !is_interrupted.load(Ordering::Relaxed);
                if is_wanted {
                    tiles.rgba8_into(|tile| tile % parts == part, &mut picture);
                }
                is_wanted
            })
        })?;
        Ok(is_whole.then_some(picture.pixels))
    }

    fn render_layer(&self, renderer: &Renderer) -> Result<Vec<[u8; 4]>, RenderError> {
        let Some(layer) = &self.layer else { return Ok(Vec::new()) };
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

    fn all_of(job: &RenderJob, renderer: &Renderer) -> Vec<[u8; 4]> {
        job.render(renderer, &AtomicBool::new(false)).unwrap().unwrap()
    }

    #[test]
    fn occlusion_while_moving_is_noisier_and_no_brighter_than_at_rest() {
        let scene = demos::demo("plane").unwrap();
        let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
        let view = luxel::default_view(&scene, SIZE)
            .with_encoding(PictureEncoding::None)
            .with_background([1.0; 4])
            .with_ground(true)
            .with_ambient_occlusion(Some(luxel::view::AmbientOcclusion::default()));
        let job = RenderJob { view, layer: None };
        let mean = |job: &RenderJob| {
            let pixels = all_of(job, &renderer);
            let sum: u64 = pixels
                .iter()
                .map(|[r, g, b, _]| [r, g, b].map(|c| u64::from(*c)).iter().sum::<u64>())
                .sum();
            sum as f64 / pixels.len() as f64 / 3.0
        };
        let rest = mean(&job);
        let dark = 0.01 * rest;
        for coarse in [job.clone().while_moving(), job.clone().first()] {
            assert!((mean(&coarse) - rest).abs() < dark, "{} is not {rest}", mean(&coarse));
        }
    }

    #[test]
    fn an_interrupted_picture_is_none_and_a_whole_one_is_the_renderers() {
        let scene = demos::demo("plane").unwrap();
        let execution = Execution { threads: 1, ..Execution::default() };
        let renderer = Renderer::new(scene.clone(), &execution).unwrap();
        let size = Size { width: 500, height: 300 };
        let view = luxel::default_view(&scene, size).with_shadows(true).with_ground(true);
        let job = RenderJob { view: view.clone(), layer: None };
        assert_eq!(job.render(&renderer, &AtomicBool::new(true)).unwrap(), None);
        assert_eq!(all_of(&job, &renderer), renderer.rgba8(&view).unwrap().pixels);
    }

    #[test]
    fn terms_of_light_add_up_to_the_picture_of_one_sample() {
        let scene = demos::demo("plane").unwrap();
        let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
        let mut view = luxel::default_view(&scene, SIZE);
        view.samples = 1;
        view.encoding = PictureEncoding::None;
        let drawn = |layer| all_of(&RenderJob { view: view.clone(), layer }, &renderer);
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
        let on = all_of(&RenderJob { view: view.clone(), layer: layer.clone() }, &renderer);
        view.lights.remove(0);
        let off = all_of(&RenderJob { view, layer }, &renderer);
        assert!(on.iter().any(|pixel| pixel[0] > 50));
        assert!(off.iter().all(|[r, g, b, _]| r + g + b == 0));
        assert!(off.iter().zip(&on).all(|(a, b)| a[3] == b[3]));
    }
}
