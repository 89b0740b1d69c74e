//! What lies under one pixel: the picture of that pixel alone; and which objects a whole picture shows.

use luxel::pick::VisibleIds;
use luxel::render::{
    At, ExplainedSample, ExplainedSurface, Explanation, Layer, LayerValues, Renderer, Seen, Unseen,
    View,
};
use luxel::scene::{Camera, DMat4, DVec3, Lens, Projection, Size};

/// The camera whose only pixel is one of another camera's: no matter how large a window is, asking
/// about one place of it costs one pixel.
pub(crate) fn pixel_camera(camera: &Camera, size: Size, [x, y]: [u32; 2]) -> Camera {
    let (width, height) = (f64::from(size.width), f64::from(size.height));
    let (left, top) = (f64::from(x), f64::from(y));
    let Projection { lens, near, far } = camera.projection;
    let mut view_from_world = camera.view_from_world;
    let lens = match lens {
        Lens::Perspective { .. } => {
            let focal = height * 0.5 * camera.projection.clip_from_view(size).y_axis.y;
            Lens::Intrinsics {
                fx: focal,
                fy: focal,
                cx: width * 0.5 - left,
                cy: height * 0.5 - top,
            }
        }
        Lens::Intrinsics { fx, fy, cx, cy } => {
            Lens::Intrinsics { fx, fy, cx: cx - left, cy: cy - top }
        }
        Lens::Orthographic { height: extent } => {
            let pixel = extent / height;
            let right = (left + 0.5 - width * 0.5) * pixel;
            let down = (top + 0.5 - height * 0.5) * pixel;
            view_from_world =
                DMat4::from_translation(DVec3::new(-right, down, 0.0)) * view_from_world;
            Lens::Orthographic { height: pixel }
        }
    };
    Camera { view_from_world, projection: Projection { lens, near, far } }
}

/// What lies under a pixel's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Under {
    /// The point of the world.
    pub(crate) point: DVec3,
    /// The object, by its place in the renderer's list.
    pub(crate) object: usize,
}

/// What lies under a pixel's centre, if something is there.
pub(crate) fn under(renderer: &Renderer, view: &View, pixel: [u32; 2]) -> Option<Under> {
    let camera = pixel_camera(&view.camera, view.size, pixel);
    let view = View { camera, size: Size { width: 1, height: 1 }, ..view.clone() };
    let layers = renderer.layers(&view, &[Layer::Position, Layer::Z, Layer::Object]).ok()?;
    match layers.as_slice() {
        [LayerValues::F32(position), LayerValues::F32(z), LayerValues::U32(object)]
            if z.first()?.is_finite() =>
        {
            let [x, y, z] = position.first_chunk()?;
            let point = DVec3::new(f64::from(*x), f64::from(*y), f64::from(*z));
            Some(Under { point, object: *object.first()? as usize })
        }
        _ => None,
    }
}

/// What each pixel of a view shows, by the fill rule of its picture. `numbers` are those of the
/// renderer's objects in the whole scene.
pub(crate) fn seen(renderer: &Renderer, view: &View, numbers: &[usize]) -> Option<VisibleIds> {
    let layers = renderer.layers(view, &[Layer::Object, Layer::Triangle]).ok()?;
    let mut layers = layers.into_iter();
    let (Some(LayerValues::U32(mut objects)), Some(LayerValues::U32(triangles))) =
        (layers.next(), layers.next())
    else {
        return None;
    };
    for object in &mut objects {
        if let Some(number) = numbers.get(*object as usize) {
            *object = *number as u32;
        }
    }
    VisibleIds::new(view.size, objects, triangles)
}

/// Why a pixel has its colour, and what it doesn't show.
#[derive(Clone, Debug)]
pub(crate) struct Explained {
    pub(crate) explanation: Explanation,
    /// Its objects are those of the whole scene.
    pub(crate) unseen: Unseen,
}

impl Explained {
    /// The sample that has most of the pixel, by its place.
    pub(crate) fn heaviest(&self) -> Option<(usize, &ExplainedSample)> {
        let samples = self.explanation.samples.iter().enumerate();
        samples.max_by(|(_, a), (_, b)| a.weight.total_cmp(&b.weight))
    }

    /// The nearest surface of that sample.
    pub(crate) fn surface(&self) -> Option<&ExplainedSurface> {
        self.heaviest()?.1.seen.iter().find_map(Seen::surface)
    }
}

/// Why a pixel has its colour; `None`, if it can't be told. `numbers` are those of the renderer's
/// objects in the whole scene.
pub(crate) fn explained(
    renderer: &Renderer,
    view: &View,
    pixel: [u32; 2],
    numbers: &[usize],
) -> Option<Explained> {
    let explanation = renderer.explain(view, At::Pixel(pixel)).ok()?;
    let mut unseen = Unseen::new(renderer, view, &explanation).ok()?;
    let whole = |object: &mut usize| *object = numbers.get(*object).copied().unwrap_or(*object);
    for hidden in &mut unseen.entries {
        let surfaces = hidden.culled.iter_mut().chain(&mut hidden.behind);
        surfaces.for_each(|surface| whole(&mut surface.object));
    }
    if let Some(nearest) = &mut unseen.nearest {
        whole(&mut nearest.object);
    }
    Some(Explained { explanation, unseen })
}

/// The distance along the view of what each pixel of a view shows; infinite where nothing is.
pub(crate) fn depths(renderer: &Renderer, view: &View) -> Option<Vec<f32>> {
    match renderer.layers(view, &[Layer::Z]).ok()?.pop()? {
        LayerValues::F32(z) => Some(z),
        LayerValues::U32(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::render::Execution;

    #[test]
    fn a_pixel_alone_tells_what_it_tells_in_the_whole_picture() {
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
            let seen = seen(&renderer, &view, &all).unwrap();
            let [LayerValues::F32(positions), LayerValues::F32(z)] = layers.as_slice() else {
                panic!("other layers")
            };
            let mut hits = 0;
            for (x, y) in (3..96).step_by(13).flat_map(|x| (2..54).step_by(7).map(move |y| (x, y)))
            {
                let at = (y * 96 + x) as usize;
                let found = under(&renderer, &view, [x, y]);
                let object = seen.at(x, y).map(|(object, _)| object);
                assert_eq!(found.map(|found| found.object), object, "{lens:?} {x} {y}");
                assert_eq!(found.is_some(), z[at].is_finite(), "{lens:?} {x} {y}");
                if let Some(Under { point: found, .. }) = found {
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
