//! Queries of one pixel, rendered as a one-pixel view; visible objects and depths of whole views.

use crate::projection::WindowPart;
use luxel::pick::VisibleIds;
use luxel::render::{
    At, ExplainedSample, ExplainedSurface, Explanation, Layer, LayerValues, Renderer, Seen, Unseen,
    View,
};
use luxel::scene::{Camera, DVec3, Size};

/// The camera that sees only one pixel of another camera: a query costs one pixel, however large the
/// window is.
fn pixel_camera(camera: &Camera, size: Size, [left, top]: [u32; 2]) -> Camera {
    let pixel = WindowPart { left, top, size: Size { width: 1, height: 1 } };
    pixel.camera(camera, size)
}

/// The surface point at a pixel's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PixelHit {
    /// The point in world space.
    pub(crate) point: DVec3,
    /// The object's index in the renderer's list.
    pub(crate) object: usize,
}

/// The surface point at a pixel's centre; `None` on the background.
pub(crate) fn hit_at_pixel(renderer: &Renderer, view: &View, pixel: [u32; 2]) -> Option<PixelHit> {
    let camera = pixel_camera(&view.camera, view.size, pixel);
    let view = view.clone().with_camera(camera).with_size(Size { width: 1, height: 1 });
    let layers = renderer.layers(&view, &[Layer::Position, Layer::Z, Layer::Object]).ok()?;
    match layers.as_slice() {
        [LayerValues::F32(position), LayerValues::F32(z), LayerValues::U32(object)]
            if z.first()?.is_finite() =>
        {
            let [x, y, z] = position.first_chunk()?;
            let point = DVec3::new(f64::from(*x), f64::from(*y), f64::from(*z));
            Some(PixelHit { point, object: *object.first()? as usize })
        }
        _ => None,
    }
}

/// The object and triangle of each pixel of a view. `object_ids` maps the renderer's objects to those
/// of the whole scene.
pub(super) fn visible_ids(
    renderer: &Renderer,
    view: &View,
    object_ids: &[usize],
) -> Option<VisibleIds> {
    let layers = renderer.layers(view, &[Layer::Object, Layer::Triangle]).ok()?;
    let mut layers = layers.into_iter();
    let (Some(LayerValues::U32(mut objects)), Some(LayerValues::U32(triangles))) =
        (layers.next(), layers.next())
    else {
        return None;
    };
    for object in &mut objects {
        if let Some(id) = object_ids.get(*object as usize) {
            *object = *id as u32;
        }
    }
    VisibleIds::new(view.size, objects, triangles)
}

/// The lighting of a pixel, and the surfaces hidden at it.
#[derive(Clone, Debug)]
pub(crate) struct ExplainedPixel {
    pub(crate) explanation: Explanation,
    /// Objects are those of the whole scene.
    pub(crate) unseen: Unseen,
}

impl ExplainedPixel {
    /// The sample of the largest weight, and its index.
    pub(crate) fn dominant_sample(&self) -> Option<(usize, &ExplainedSample)> {
        let samples = self.explanation.samples.iter().enumerate();
        samples.max_by(|(_, a), (_, b)| a.weight.total_cmp(&b.weight))
    }

    /// The nearest surface of that sample.
    pub(crate) fn surface(&self) -> Option<&ExplainedSurface> {
        self.dominant_sample()?.1.seen.iter().find_map(Seen::surface)
    }
}

/// Explains a pixel; `None` if the view can't be rendered. `object_ids` maps the renderer's objects to
/// those of the whole scene.
pub(super) fn explain_pixel(
    renderer: &Renderer,
    view: &View,
    pixel: [u32; 2],
    object_ids: &[usize],
) -> Option<ExplainedPixel> {
    let explanation = renderer.explain(view, At::Pixel(pixel)).ok()?;
    let mut unseen = Unseen::new(renderer, view, &explanation).ok()?;
    let whole = |object: &mut usize| *object = object_ids.get(*object).copied().unwrap_or(*object);
    for hidden in &mut unseen.entries {
        let surfaces = hidden.culled.iter_mut().chain(&mut hidden.behind);
        surfaces.for_each(|surface| whole(&mut surface.object));
    }
    if let Some(nearest) = &mut unseen.nearest {
        whole(&mut nearest.object);
    }
    Some(ExplainedPixel { explanation, unseen })
}

/// The distance along the view at each pixel; infinite on the background.
pub(crate) fn render_depths(renderer: &Renderer, view: &View) -> Option<Vec<f32>> {
    match renderer.layers(view, &[Layer::Z]).ok()?.pop()? {
        LayerValues::F32(z) => Some(z),
        LayerValues::U32(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::render::Execution;
    use luxel::scene::{Lens, Projection};

    #[test]
    fn a_one_pixel_view_agrees_with_the_whole_picture() {
        let scene = luxel::scene::demos::demo("teapot").unwrap();
        let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
        let size = Size { width: 96, height: 54 };
        let mut view = luxel::default_view(&scene, size);
        let planes = (view.camera.projection.near, view.camera.projection.far);
        for lens in [
            view.camera.projection.lens,
            Lens::Orthographic { height: 6.0 },
            Lens::Intrinsics { fx: 70.0, fy: 60.0, cx: 40.0, cy: 30.0 },
        ] {
            view.camera.projection = Projection { lens, near: planes.0, far: planes.1 };
            let layers = renderer.layers(&view, &[Layer::Position, Layer::Z]).unwrap();
            let all: Vec<_> = (0..renderer.objects().len()).collect();
            let visible = visible_ids(&renderer, &view, &all).unwrap();
            let [LayerValues::F32(positions), LayerValues::F32(z)] = layers.as_slice() else {
                panic!("other layers")
            };
            let mut hits = 0;
            for (x, y) in (3..96).step_by(13).flat_map(|x| (2..54).step_by(7).map(move |y| (x, y)))
            {
                let at = (y * 96 + x) as usize;
                let found = hit_at_pixel(&renderer, &view, [x, y]);
                let object = visible.at(x, y).map(|(object, _)| object);
                assert_eq!(found.map(|found| found.object), object, "{lens:?} {x} {y}");
                assert_eq!(found.is_some(), z[at].is_finite(), "{lens:?} {x} {y}");
                if let Some(PixelHit { point: found, .. }) = found {
                    hits += 1;
                    let expected: [f32; 3] = positions[3 * at..][..3].try_into().unwrap();
                    let expected = DVec3::from_array(expected.map(f64::from));
                    assert!(found.abs_diff_eq(expected, 1e-3), "{lens:?}: {found} {expected}");
                }
            }
            assert!(hits > 5, "{lens:?}: the teapot is not there");
        }
    }
}
