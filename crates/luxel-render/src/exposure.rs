//! The exposure that suits a scene's own light, and the warning of pictures without one.

use crate::frame::{Picture, RenderError, Renderer, ambient, placed_lights};
use luxel_lighting::{Display, Environment, PlacedLight, Reflection, Tone};
use luxel_math::elementary;
use luxel_scene::{Camera, Lens, Object, Projection, Scene, Size, bodies};
use luxel_view::{EnvironmentChoice, View};

/// Light within a stop of 1 needs no exposure.
const WITHIN_STOPS: f32 = 1.0;
/// Exposures are rounded to a tenth of a stop, so that they are short to write.
const STEPS: f32 = 10.0;
/// How many places of the surface are metered at most.
const MOST_PLACES: u64 = 1024;

/// What [`auto_exposure`] metered and chose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AutoExposure {
    /// The exposure in stops, in tenths; 0 where the light needs none.
    pub ev: f32,
    /// The light that arrives at the model: 1 makes a white surface that faces it white.
    pub light: f32,
}

/// The exposure that makes a view's light about 1, by a rule that looks at lights and geometry, never at
/// pixels, and not at the view's own exposure:
///
/// 1. The light at a place is the sum of what arrives of each light, attenuated, as if the place faced it,
///    and of the ambient light, in their strongest channels.
/// 2. Directional lights are the same everywhere. Where others shine, up to 1024 triangles are metered at
///    their middles, evenly through the scene, and the median of those that a light reaches counts.
/// 3. Where the environment is stronger than all lights together, it counts instead.
/// 4. Light from 1/2 to 2 is left as it is. Other light is brought to 1: EV = -log2(light), in tenths.
///
/// ```
/// use luxel_render::{View, auto_exposure};
/// use luxel_scene::{DVec3, Lens, SceneLight, Size, Viewpoint, demos, fit_view};
///
/// let scene = demos::demo("teapot").unwrap();
/// let size = Size { width: 64, height: 48 };
/// let viewpoint = Viewpoint { up: scene.up, azimuth_radians: 0.5, elevation_radians: 0.3 };
/// let camera = fit_view(&scene, &viewpoint, Lens::Perspective { fov_y_radians: 0.8 }, size);
/// let view = View::new(size, camera);
/// assert_eq!(auto_exposure(&scene, &view).ev, 0.0);
/// let sun = SceneLight::directional(DVec3::NEG_Y, [2048.0; 3]);
/// let view = view.with_lights(vec![sun]).with_ambient([0.0; 3]);
/// assert_eq!(auto_exposure(&scene, &view).ev, -11.0);
/// ```
#[must_use]
pub fn auto_exposure(scene: &Scene, view: &View) -> AutoExposure {
    let strongest = |color: [f32; 3]| color.into_iter().fold(0.0, f32::max);
    let lights = placed_lights(view, scene);
    let everywhere = strongest(ambient(view));
    let has_place = |light: &PlacedLight| light.light().kind.has_place();
    let arriving = |place: [f32; 3]| lights.iter().map(|light| light.arriving(place)).sum::<f32>();
    let of_lights = if lights.iter().any(has_place) {
        let places = places(scene, view.camera.eye().to_array());
        let reached = places.into_iter().map(arriving).filter(|light| *light > 0.0);
        median(reached.collect())
    } else {
        arriving([0.0; 3])
    };
    let light = (everywhere + of_lights).max(strongest(environment(scene, view)));
    let light = if light.is_finite() { light } else { f32::MAX };
    let stops = elementary::log2(light.max(f32::MIN_POSITIVE));
    let is_needed = light > 0.0 && stops.abs() > WITHIN_STOPS;
    let ev = if is_needed { (-stops * STEPS).round() / STEPS } else { 0.0 };
    AutoExposure { ev: ev.clamp(-Display::MAX_EV, Display::MAX_EV), light }
}

/// The middle one in order of size; 0 of none.
fn median(mut values: Vec<f32>) -> f32 {
    values.sort_unstable_by(f32::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or_default()
}

/// The mean light of the environment that the scene reflects.
fn environment(scene: &Scene, view: &View) -> [f32; 3] {
    let is_microfacet = |reflection: &Reflection| matches!(reflection, Reflection::Microfacet);
    let environment = match &view.environment {
        EnvironmentChoice::Always(environment) => environment.clone(),
        EnvironmentChoice::StudioForMicrofacets => {
            let up = view.up.unwrap_or(scene.up).as_vec3().to_array();
            let mut reflections = scene.materials.iter().map(|of| &of.constants.reflection);
            match reflections.any(is_microfacet) {
                true => Environment::Studio { up },
                false => Environment::None,
            }
        }
    };
    environment.mean()
}

/// Middles of triangles, relative to the eye: each so many of all objects' triangles, in their order. Of
/// scenes without triangles, the middles of the objects' bounds.
fn places(scene: &Scene, eye: [f64; 3]) -> Vec<[f32; 3]> {
    let objects = scene.objects();
    // Objects that share a mesh have its triangles together.
    let objects: Vec<&Object> = bodies(&objects).map(|body| &objects[body.start]).collect();
    let about_eye = |place: luxel_scene::DVec3| (place - luxel_scene::DVec3::from(eye)).as_vec3();
    let count = |object: &&Object| scene.meshes[object.mesh.index()].triangles.len() as u64;
    let all: u64 = objects.iter().map(count).sum();
    if all == 0 {
        let middle = |object: &&Object| {
            let bounds = scene.meshes.bounds_of(object.mesh, &object.world_from_mesh.matrix());
            (!bounds.is_empty()).then(|| about_eye(bounds.centre()).to_array())
        };
        return objects.iter().filter_map(middle).collect();
    }
    let wanted = all.min(MOST_PLACES);
    let mut places = Vec::with_capacity(wanted as usize);
    let (mut next, mut before) = (0_u64, 0_u64);
    for object in &objects {
        let mesh = &scene.meshes[object.mesh.index()];
        let after = before + count(object);
        while next < wanted {
            let number = (2 * next + 1) * all / (2 * wanted);
            if number >= after {
                break;
            }
            let corners = mesh.triangles[(number - before) as usize];
            let corner = |at: u32| {
                luxel_scene::DVec3::from(mesh.positions[at as usize].map(f64::from)) / 3.0
            };
            let middle = corner(corners[0]) + corner(corners[1]) + corner(corners[2]);
            let world = object.world_from_mesh.matrix().transform_point3(mesh.origin + middle);
            places.push(about_eye(world).to_array());
            next += 1;
        }
        before = after;
    }
    places
}

/// Width and height of the picture in which burnt-out pixels are counted.
const COUNTED: u32 = 160;
/// A stop beyond white, as the mean of the channels.
const BURNT: f32 = 2.0;
/// The same behind a tone curve, which ends at 1.
const BURNT_BY_CURVE: f32 = 0.97;

/// The share of covered pixels with a channel at its end from which on a picture may be burnt out.
const SUSPICIOUS: f32 = 0.05;

impl Picture<[u8; 4]> {
    /// Whether so many bytes are at their end that [`Renderer::burnt_out`] is worth its time: of the covered
    /// pixels more than a twentieth have a channel of 255.
    #[must_use]
    pub fn may_be_burnt_out(&self) -> bool {
        let (mut covered, mut full) = (0_u32, 0_u32);
        for &pixel in &self.pixels {
            // Alpha is highest. A byte of x is 0 if (x - 0x01010101) & !x has a bit of 0x80808080 (Mycroft 1987).
            let pixel = u32::from_le_bytes(pixel);
            let rest = !pixel | 0xff00_0000;
            let is_covered = pixel >> 24 != 0;
            let is_full = rest.wrapping_sub(0x0101_0101) & !rest & 0x8080_8080 != 0;
            covered += u32::from(is_covered);
            full += u32::from(is_covered & is_full);
        }
        full as f32 > SUSPICIOUS * covered as f32
    }
}

impl Renderer {
    /// The share of the model's pixels that are burnt out: more than a stop brighter than white, or at the
    /// end of the tone curve. A small picture of one sample a pixel is drawn to count them.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub fn burnt_out(&self, view: &View) -> Result<f32, RenderError> {
        let view = small(view)
            .with_samples(1)
            .with_background([0.0; 4])
            .with_environment_background(false)
            .with_ground(false)
            .with_edges(None);
        let limit = if view.tone == Tone::None { BURNT } else { BURNT_BY_CURVE };
        let (mut seen, mut burnt) = (0_u32, 0_u32);
        for [r, g, b, alpha] in self.linear(&view)?.pixels {
            seen += u32::from(alpha > 0.0);
            burnt += u32::from(alpha > 0.0 && (r + g + b) * (1.0 / 3.0) > limit);
        }
        Ok(burnt as f32 / seen.max(1) as f32)
    }
}

/// The same view in few pixels.
fn small(view: &View) -> View {
    let Size { width, height } = view.size;
    let scale = (f64::from(COUNTED) / f64::from(width.max(height))).min(1.0);
    let side = |side: u32| ((f64::from(side) * scale).round() as u32).max(1);
    let size = Size { width: side(width), height: side(height) };
    let lens = match view.camera.projection.lens {
        Lens::Intrinsics { fx, fy, cx, cy } => {
            let x = f64::from(size.width) / f64::from(width.max(1));
            let y = f64::from(size.height) / f64::from(height.max(1));
            Lens::Intrinsics { fx: fx * x, fy: fy * y, cx: cx * x, cy: cy * y }
        }
        lens => lens,
    };
    let projection = Projection { lens, ..view.camera.projection };
    view.clone().with_size(size).with_camera(Camera { projection, ..view.camera })
}
