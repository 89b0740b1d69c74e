//! The ground under a model: nothing of it is seen but the light that the model keeps from it.

use crate::shadow::{Floor, OcclusionLanes, Receivers, Shadows};
use glam::{DMat3, DVec3};
use luxel_lighting::{
    Coefficients, Fog, LightingEnvironment, Material, Occlusion, PictureEncoding, Reflection,
    Silent, SurfacePoint, Uniform, Witness, encode_srgb, reflected,
};
use luxel_math::prelude::*;
use luxel_math::{LANES, Rgb, Vec3, lanes_of};
use luxel_rays::{LIFT, PlaceLanes, SurfacePlace};
use luxel_scene::{Bounds, Camera};

/// The farthest that the ground is looked at, in radii of the scene's bounding sphere.
const FARTHEST: f64 = 1024.0;

/// The part of each channel in luminance (ITU-R BT.709).
const LUMINANCE: [f32; 3] = [0.2126, 0.7152, 0.0722];

/// A white, matt plane under the model. It darkens what lies behind it by the part of its light that the
/// model keeps from it, and is transparent where that is none:
///
/// ```text
/// darkness = s (1 - Y(I) / Y(I_0))
/// ```
///
/// I is the lighting equation of the plane with V and openness, I_0 without, Y the luminance and s the
/// factor of the fog.
pub(crate) struct Ground<'a> {
    pub(crate) floor: Floor,
    /// V of all lights, and openness.
    pub(crate) shadows: Shadows<'a>,
    pub(crate) lighting: LightingEnvironment<'a>,
    pub(crate) fog: Option<&'a Fog>,
    /// The model's.
    pub(crate) bounds: Bounds,
    /// How the picture's bytes will stand for light.
    pub(crate) encoding: PictureEncoding,
    world_from_view: DMat3,
    coefficients: Coefficients<Uniform>,
}

/// What samples see of the ground.
pub(crate) struct SeenGround<N: Lanes> {
    pub(crate) places: PlaceLanes<N::F64>,
    pub(crate) point: SurfacePoint<N>,
    /// The lanes that see it.
    pub(crate) lanes: u32,
    /// I_0
    pub(crate) unoccluded: Rgb<N>,
    /// I
    pub(crate) light: Rgb<N>,
    /// s
    pub(crate) fog: N,
    pub(crate) darkness: N,
}

impl<'a> Ground<'a> {
    /// The ground on which a model with these bounds stands.
    pub(crate) fn new(
        floor: Floor,
        shadows: Shadows<'a>,
        (lighting, fog): (LightingEnvironment<'a>, Option<&'a Fog>),
        bounds: Bounds,
        (camera, encoding): (&Camera, PictureEncoding),
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
            bounds,
            encoding,
            world_from_view: DMat3::from_mat4(camera.view_from_world).transpose(),
            coefficients: Coefficients::uniform(&white),
        }
    }

    /// What some of sixteen samples at positions of the window, in pixels, see of the ground: nothing beside
    /// it and from below.
    #[inline(always)]
    pub(crate) fn seen<N: Lanes, W: Witness<N>>(
        &self,
        simd: N,
        lanes: u32,
        position: &dyn Fn(usize) -> [f64; 2],
        found: &mut OcclusionLanes,
        witness: &mut W,
    ) -> SeenGround<N> {
        let Self { floor, shadows, fog, .. } = self;
        let mut rows = Rows::default();
        for lane in lanes_of(lanes) {
            if let Some((place, depth)) = self.place(position(lane)) {
                rows.put(lane, place, shadows, depth, self.is_near(place));
            }
        }
        let [x, y, z] = &rows.about_eye;
        let place = Vec3::new(simd.load(x, 0), simd.load(y, 0), simd.load(z, 0));
        let [x, y, z] = &rows.towards_eye;
        let view = Vec3::new(simd.load(x, 0), simd.load(y, 0), simd.load(z, 0));
        let point = SurfacePoint {
            position: place,
            normal: Vec3::splat(simd, floor.up.as_vec3().to_array()),
            view: view.normalized_or_zero(),
            depth: simd.load(&rows.depth, 0),
        };
        let wide = simd.to_f64();
        let [x, y, z] = &rows.position;
        let position_lanes = [wide.load(x), wide.load(y), wide.load(z)];
        let DVec3 { x, y, z } = floor.up;
        let normal = [wide.constant(x), wide.constant(y), wide.constant(z)];
        let DVec3 { x, y, z } = floor.up * (LIFT * self.bounds.radius());
        let lift = [wide.constant(x), wide.constant(y), wide.constant(z)];
        let places = PlaceLanes { position: position_lanes, normal, lift };
        let receivers = Receivers {
            places,
            point: &point,
            smooth: point.normal,
            is_mapped: false,
            placed: rows.lanes,
            near: rows.near,
            position,
            curved: None,
        };
        shadows.cast_from(&receivers, (0, 1), found);
        shadows.trace_pending(simd, 1, found);
        let unoccluded = self.light(&point, Occlusion::NONE, &mut Silent);
        let light = self.light(&point, found.occlusion(0), witness);
        let (all, arriving) = (luminance(unoccluded), luminance(light));
        let is_lit = simd.zero().less(all);
        let kept = (simd.one() - arriving / all.select(is_lit, simd.one())).clamped(0.0, 1.0);
        let fog = match fog {
            Some(fog) => fog.factor(point.depth),
            None => simd.one(),
        };
        let darkness = (kept * fog).masked(is_lit);
        SeenGround { places, point, lanes: rows.lanes, unoccluded, light, fog, darkness }
    }

    /// The light of the plane.
    ///
    /// Outlined: one copy per lane type, with and without what keeps light away.
    #[inline(never)]
    fn light<N: Lanes, W: Witness<N>>(
        &self,
        point: &SurfacePoint<N>,
        occlusion: Occlusion<'_>,
        witness: &mut W,
    ) -> Rgb<N> {
        let Self { coefficients, lighting, .. } = self;
        point.depth.vectorized(
            #[inline(always)]
            || reflected(point, coefficients, &Reflection::Lambert, lighting, occlusion, witness),
        )
    }

    /// The place that a position of the window shows from above, and its distance from the eye along the
    /// viewing axis.
    fn place(&self, [x, y]: [f64; 2]) -> Option<(DVec3, f64)> {
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
        let place = origin + direction * t;
        let place = place - *up * (up.dot(place) - level);
        let is_near = (place - bounds.centre()).length() <= FARTHEST * bounds.radius();
        is_near.then_some((place, t * ahead))
    }

    /// Whether anything lies within the radius of openness.
    fn is_near(&self, place: DVec3) -> bool {
        let Bounds { min, max } = self.bounds;
        let away = (min - place).max(place - max).max(DVec3::ZERO).length();
        self.shadows.openness.is_some_and(|rule| away <= rule.radius)
    }

    /// How much the ground covers of what lies behind it, of which `alpha` is opaque: its darkness, as far as
    /// that is mixed in linear light here. What is transparent will be mixed with a page elsewhere, in
    /// the bytes of sRGB: there 1 - encode(1 - darkness) gives what the darkness gives here.
    pub(crate) fn alpha(&self, darkness: f32, alpha: f32) -> f32 {
        match self.encoding {
            PictureEncoding::None => darkness,
            PictureEncoding::Srgb => {
                let elsewhere = (1.0 - encode_srgb(f64::from(1.0 - darkness))) as f32;
                darkness * alpha + elsewhere * (1.0 - alpha)
            }
        }
    }

    /// The ground over what lies behind it: straight colours and alphas.
    pub(crate) fn over(&self, darkness: f32, [r, g, b, alpha]: [f32; 4]) -> [f32; 4] {
        let own = self.alpha(darkness, alpha);
        let behind = alpha * (1.0 - own);
        let covered = own + behind;
        if covered <= 0.0 {
            return [0.0; 4];
        }
        // The ground itself is black.
        let share = behind / covered;
        [r * share, g * share, b * share, covered]
    }
}

#[inline(always)]
fn luminance<N: Lanes>(color: Rgb<N>) -> N {
    let simd = color.r;
    color.r * simd.constant(LUMINANCE[0])
        + color.g * simd.constant(LUMINANCE[1])
        + color.b * simd.constant(LUMINANCE[2])
}

/// Places of samples on the ground, lane by lane.
#[derive(Default)]
struct Rows {
    /// The lanes that have one, and those with anything within the radius of openness.
    lanes: u32,
    near: u32,
    position: [[f64; LANES]; 3],
    about_eye: [[f32; LANES]; 3],
    towards_eye: [[f32; LANES]; 3],
    depth: [f32; LANES],
}

impl Rows {
    fn put(&mut self, lane: usize, place: DVec3, shadows: &Shadows<'_>, depth: f64, is_near: bool) {
        let about_eye = (place - shadows.eye).as_vec3();
        let towards_eye = shadows.towards_eye.unwrap_or(shadows.eye - place).as_vec3();
        for axis in 0..3 {
            self.position[axis][lane] = place[axis];
            self.about_eye[axis][lane] = about_eye[axis];
            self.towards_eye[axis][lane] = towards_eye[axis];
        }
        self.depth[lane] = depth as f32;
        self.lanes |= 1 << lane;
        self.near |= u32::from(is_near) << lane;
    }
}

impl SeenGround<f32> {
    /// The place that rays leave.
    pub(crate) fn place(&self) -> SurfacePlace {
        self.places.place()
    }
}
