//! The ground under a model: nothing of it is seen but the light that the model keeps from it.

use crate::shadow::{Floor, Shadows};
use glam::{DMat3, DVec3};
use luxel_lighting::{
    Coefficients, Fog, LightingEnvironment, Material, Occlusion, Reflection, Silent, SurfacePoint,
    Uniform, Witness, reflected,
};
use luxel_math::{LANES, Rgb, Vec3};
use luxel_rays::{LIFT, SurfacePlace};
use luxel_scene::{Bounds, Camera};

/// The farthest that the ground is looked at, in radii of the scene's bounding sphere.
const FARTHEST: f64 = 1024.0;

/// The part of each channel in luminance (ITU-R BT.709).
const LUMINANCE: [f32; 3] = [0.2126, 0.7152, 0.0722];

/// A white, matt plane under the model. It darkens what lies behind it by the part of its light that the
/// model keeps from it, and is transparent where that is none:
///
/// ```text
/// darkness = 1 - Y(I) / Y(I_0)
/// ```
///
/// I is the lighting equation of the plane with V and openness, I_0 without, and Y the luminance.
pub(crate) struct Ground<'a> {
    floor: Floor,
    /// V of all lights, and openness.
    pub(crate) shadows: Shadows<'a>,
    lighting: LightingEnvironment<'a>,
    fog: Option<&'a Fog>,
    coefficients: Coefficients<Uniform>,
    world_from_view: DMat3,
    bounds: Bounds,
}

/// What one sample sees of the ground.
pub(crate) struct GroundSample {
    pub(crate) place: SurfacePlace,
    pub(crate) point: SurfacePoint<f32>,
    /// V of each light, in the first lane.
    visibility: Vec<[f32; LANES]>,
    openness: [f32; LANES],
    /// I_0
    pub(crate) unoccluded: Rgb<f32>,
    /// I
    pub(crate) light: Rgb<f32>,
    /// s of the fog.
    pub(crate) fog: f32,
    /// How much of what lies behind is hidden by black.
    pub(crate) darkness: f32,
}

impl<'a> Ground<'a> {
    /// The ground on which a model with these bounds stands.
    pub(crate) fn new(
        floor: Floor,
        shadows: Shadows<'a>,
        lighting: LightingEnvironment<'a>,
        fog: Option<&'a Fog>,
        camera: &Camera,
        bounds: Bounds,
    ) -> Self {
        let white = Material {
            reflection: Reflection::Lambert,
            ambient: None,
            diffuse: [1.0; 3],
            k_a: 1.0,
            k_d: 1.0,
            ..Material::default()
        };
        Self {
            floor,
            shadows,
            lighting,
            fog,
            coefficients: Coefficients::uniform(&white),
            world_from_view: DMat3::from_mat4(camera.view_from_world).transpose(),
            bounds,
        }
    }

    /// What is seen of the ground at a position of the window, in pixels; `None` beside it, from below, and
    /// where nothing keeps any light away.
    pub(crate) fn sample(&self, position: [f64; 2]) -> Option<GroundSample> {
        let seen = self.occluded(position)?;
        let is_dark = seen.openness[0] < 1.0 || seen.visibility.iter().any(|of| of[0] < 1.0);
        is_dark.then(|| self.lit(seen))
    }

    /// The same where the light is not kept away, too, with its terms written down.
    pub(crate) fn explained<W: Witness<f32>>(
        &self,
        position: [f64; 2],
        witness: &mut W,
    ) -> Option<GroundSample> {
        let seen = self.lit(self.occluded(position)?);
        let _ = self.light(&seen.point, seen.occlusion(), witness);
        Some(seen)
    }

    /// The place at a position of the window, and what keeps light from it; yet without light.
    fn occluded(&self, position: [f64; 2]) -> Option<GroundSample> {
        let Self { floor: Floor { up, level }, shadows, bounds, .. } = self;
        let (place, depth) = self.place(position)?;
        let about_eye = (place.position - shadows.eye).as_vec3().to_array();
        let vector = |[x, y, z]: [f32; 3]| Vec3::new(x, y, z);
        let normal = up.as_vec3().to_array();
        let towards_eye = shadows.towards_eye.unwrap_or(shadows.eye - place.position);
        let point = SurfacePoint {
            position: vector(about_eye),
            normal: vector(normal),
            view: vector(towards_eye.as_vec3().to_array()).normalized_or_zero(),
            depth: depth as f32,
        };
        let visibility = shadows.lights.iter().enumerate().map(|(number, light)| {
            let faces = point.normal.dot(light.to_light(point.position)) > 0.0;
            let visible = || shadows.visibility(number, &place, normal, position);
            [if faces { visible() } else { 1.0 }; LANES]
        });
        let away = (bounds.min - place.position).max(place.position - bounds.max).max(DVec3::ZERO);
        let openness = match shadows.openness {
            Some(rule) if away.length() <= rule.radius => {
                shadows.openness(rule, &place, normal, position)
            }
            _ => 1.0,
        };
        debug_assert!((up.dot(place.position) - level).abs() <= 1e-6 * (1.0 + level.abs()));
        Some(GroundSample {
            place,
            point,
            visibility: visibility.collect(),
            openness: [openness; LANES],
            unoccluded: Rgb::black(0.0),
            light: Rgb::black(0.0),
            fog: 1.0,
            darkness: 0.0,
        })
    }

    /// The place that a position of the window shows, and its distance from the eye along the viewing axis.
    fn place(&self, [x, y]: [f64; 2]) -> Option<(SurfacePlace, f64)> {
        let Self { floor: Floor { up, level }, shadows, bounds, .. } = self;
        let (origin, direction) = shadows.frame.rays().ray(x, y);
        let ahead = -direction.z;
        let origin = shadows.eye + self.world_from_view * origin;
        let direction = self.world_from_view * direction;
        let (height, fall) = (up.dot(origin) - level, -up.dot(direction));
        if height <= 0.0 || fall <= 0.0 {
            return None;
        }
        let t = height / fall;
        let position = origin + direction * t;
        let position = position - *up * (up.dot(position) - level);
        let radius = bounds.radius();
        let is_near = (position - bounds.centre()).length() <= FARTHEST * radius;
        let place = SurfacePlace { position, normal: *up, lift: *up * (LIFT * radius) };
        is_near.then_some((place, t * ahead))
    }

    /// With the light of the place.
    fn lit(&self, seen: GroundSample) -> GroundSample {
        let unoccluded = self.light(&seen.point, Occlusion::NONE, &mut Silent);
        let light = self.light(&seen.point, seen.occlusion(), &mut Silent);
        let (all, arriving) = (luminance(unoccluded), luminance(light));
        let kept = if all > 0.0 { (1.0 - arriving / all).clamp(0.0, 1.0) } else { 0.0 };
        let fog = self.fog.map_or(1.0, |fog| fog.factor(seen.point.depth));
        GroundSample { unoccluded, light, fog, darkness: kept * fog, ..seen }
    }

    fn light<W: Witness<f32>>(
        &self,
        point: &SurfacePoint<f32>,
        occlusion: Occlusion<'_>,
        witness: &mut W,
    ) -> Rgb<f32> {
        let Self { coefficients, lighting, .. } = self;
        reflected(point, coefficients, &Reflection::Lambert, lighting, occlusion, witness)
    }
}

fn luminance(color: Rgb<f32>) -> f32 {
    let [r, g, b] = color.lane(0);
    r * LUMINANCE[0] + g * LUMINANCE[1] + b * LUMINANCE[2]
}

impl GroundSample {
    fn occlusion(&self) -> Occlusion<'_> {
        Occlusion { visibility: Some(&self.visibility), openness: Some(&self.openness) }
    }

    /// The openness of the place.
    pub(crate) fn openness(&self) -> f32 {
        self.openness[0]
    }

    /// The ground over what lies behind it: straight colours and alphas.
    pub(crate) fn over(&self, [r, g, b, alpha]: [f32; 4]) -> [f32; 4] {
        let behind = alpha * (1.0 - self.darkness);
        let covered = self.darkness + behind;
        if covered <= 0.0 {
            return [0.0; 4];
        }
        // The ground itself is black.
        let share = behind / covered;
        [r * share, g * share, b * share, covered]
    }
}
