//! The lighting equation.

use crate::coefficients::broadcast;
use crate::light::bounded;
use crate::reflection::{Incidence, Surface};
use crate::{
    Broadcast, Coefficients, Environment, Fog, LightKind, LightTerms, Material, Occlusion,
    PlacedLight, Reflectance, Reflection, SurfacePoint, Terms, Witness,
};
use luxel_math::{Lanes, Rgb};

/// The lights on a surface, and the fog between it and the eye: the same for all points of a
/// material.
#[derive(Clone, Copy, Debug)]
pub struct LightingEnvironment<'a> {
    lights: &'a [PlacedLight],
    /// I_a of the scene, within bounds.
    scene_ambient: [f32; 3],
    /// `None` where it is dark: kernels ask for it often.
    environment: Option<&'a Environment>,
    fog: Option<&'a Fog>,
}

impl<'a> LightingEnvironment<'a> {
    /// Directional, point and spot lights (ambient ones are passed over: their sum is
    /// `scene_ambient`, I_a), the environment, and the fog, if any.
    ///
    /// I_a is clamped to 1e10, so that no later product overflows; NaN becomes 0.
    #[must_use]
    pub fn new(
        lights: &'a [PlacedLight],
        scene_ambient: [f32; 3],
        environment: &'a Environment,
        fog: Option<&'a Fog>,
    ) -> Self {
        let environment = Some(environment).filter(|environment| !environment.is_none());
        Self { lights, scene_ambient: bounded(scene_ambient), environment, fog }
    }

    /// Its lights, as they were given.
    #[must_use]
    pub fn lights(&self) -> &'a [PlacedLight] {
        self.lights
    }

    /// I_a of the scene, within bounds.
    #[must_use]
    pub fn scene_ambient(&self) -> [f32; 3] {
        self.scene_ambient
    }

    /// The environment, if there is one.
    #[must_use]
    pub fn environment(&self) -> Option<&'a Environment> {
        self.environment
    }

    /// The fog, if any.
    #[must_use]
    pub fn fog(&self) -> Option<&'a Fog> {
        self.fog
    }
}

/// The light that a surface point sends to the eye, fog included, not clamped, always finite.
///
/// With f = attenuation x spot, and V the part of a light that nothing keeps away, the light is,
/// summed from left to right:
///
/// ```text
/// I = O_e + I_a k_a O_a
///   + for each light: V f (I_a,i k_a O_a + I_d,i k_d O_d max(N.L, 0) + I_s,i k_s O_s max(c, 0)^n)
///   + environment
/// I' = s I + (1 - s) I_dc
/// ```
///
/// (Foley et al., *Computer Graphics: Principles and Practice*, 1990, section 16.1, with the
/// ambient intensity of each light and its cone from OpenGL 1.x.) This is the equation for Phong's
/// and Blinn's highlights; the other kinds of [`Reflection`] replace the diffuse and the specular
/// term. A light at the surface itself adds nothing. Here V is 1. The environment's term is what is
/// mirrored of it and, of a map, the diffuse reflection of its irradiance.
#[inline(always)]
pub fn lit<N: Lanes, W: Witness<N>>(
    point: &SurfacePoint<N>,
    reflectance: &Reflectance<N>,
    material: &Material,
    lighting: &LightingEnvironment<'_>,
    witness: &mut W,
) -> Rgb<N> {
    let coefficients = Coefficients::new(reflectance, material);
    lit_by(point, &coefficients, &material.reflection, lighting, Occlusion::NONE, witness)
}

/// [`lit`], for a surface with known coefficients, and light of which something is kept away.
#[inline(always)]
pub fn lit_by<N: Lanes, K: Broadcast<N>, W: Witness<N>>(
    point: &SurfacePoint<N>,
    coefficients: &Coefficients<K>,
    reflection: &Reflection,
    lighting: &LightingEnvironment<'_>,
    occlusion: Occlusion<'_>,
    witness: &mut W,
) -> Rgb<N> {
    let sum = reflected(point, coefficients, reflection, lighting, occlusion, witness);
    let color = match lighting.fog {
        Some(fog) => fog.veiled(sum, point.depth, witness),
        None => sum,
    };
    witness.color(color);
    color
}

/// The light that leaves a surface point towards the eye, before any fog: [`lit_by`] without its
/// last line.
#[inline(always)]
pub fn reflected<N: Lanes, K: Broadcast<N>, W: Witness<N>>(
    point: &SurfacePoint<N>,
    coefficients: &Coefficients<K>,
    reflection: &Reflection,
    lighting: &LightingEnvironment<'_>,
    occlusion: Occlusion<'_>,
    witness: &mut W,
) -> Rgb<N> {
    let simd = point.depth;
    let surface = Surface::new(point, coefficients, reflection);
    let emission = broadcast(coefficients.emitted, simd);
    let mut ambient_share = surface.ambient(reflection, lighting.environment.is_some());
    if let Some(openness) = occlusion.openness {
        let openness = simd.load(openness, 0);
        ambient_share = ambient_share * openness;
        witness.openness(openness);
    }
    let scene_ambient = ambient_share * Rgb::splat(simd, lighting.scene_ambient);

    let mut sum = emission + scene_ambient;
    for (index, placed) in lighting.lights.iter().enumerate() {
        let light = placed.light();
        if light.kind == LightKind::Ambient {
            continue;
        }
        let mut sample = placed.sample(point.position);
        if let Some(visibility) = occlusion.visibility.and_then(|of_lights| of_lights.get(index)) {
            sample.visibility = Some(simd.load(visibility, 0));
        }
        let n_dot_l = point.normal.dot(sample.to_light);
        let incidence = Incidence { to_light: sample.to_light, n_dot_l };
        let part = surface.reflected(reflection, &incidence, witness);

        // Of most lights there is none, and 0 changes no sum.
        let mut ambient = Rgb::black(simd);
        if placed.has_ambient() {
            ambient = sample.attenuated(ambient_share * Rgb::splat(simd, light.ambient));
            sum = sum + ambient;
        }
        let diffuse = sample.attenuated(part.diffuse * Rgb::splat(simd, light.diffuse));
        let specular = sample.attenuated(part.specular * Rgb::splat(simd, light.specular));
        sum = sum + diffuse;
        sum = sum + specular;
        witness.light(
            index,
            &LightTerms {
                to_light: sample.to_light,
                distance: sample.distance,
                attenuation: sample.attenuation,
                spot: sample.spot,
                visibility: sample.visibility,
                n_dot_l,
                specular_cosine: part.specular_cosine,
                ambient,
                diffuse,
                specular,
            },
        );
    }
    // Adding black would change no bit: the sum begins with an emission that is never -0.
    let mut environment = Rgb::black(simd);
    if let Some(around) = lighting.environment
        && !matches!(reflection, Reflection::Unlit)
    {
        // A copy, because a witness needs its arguments in memory, and only here.
        let surface = Surface::new(point, coefficients, reflection);
        environment = surface.mirrored(reflection, around, witness);
        if let Some(openness) = occlusion.openness {
            environment = environment * simd.load(openness, 0);
        }
        if let Environment::Map(map) = around {
            let mut diffuse = surface.diffused(reflection, map, witness);
            if let Some(openness) = occlusion.openness {
                diffuse = diffuse * simd.load(openness, 0);
            }
            witness.environment_diffuse(diffuse);
            environment = environment + diffuse;
        }
        sum = sum + environment;
    }
    let sum = finite(sum);
    witness.terms(&Terms { emission, scene_ambient, environment, sum });
    sum
}

impl Fog {
    /// I' = s I + (1 - s) I_dc at the distance `depth` along the viewing axis.
    #[inline(always)]
    pub fn veiled<N: Lanes, W: Witness<N>>(
        &self,
        color: Rgb<N>,
        depth: N,
        witness: &mut W,
    ) -> Rgb<N> {
        let factor = self.factor(depth);
        let fog_color = self.color_like(depth);
        witness.fog(factor, fog_color);
        finite(color * factor + fog_color * (factor.one() - factor))
    }
}

/// No infinity, whatever the sums of many huge terms.
#[inline(always)]
fn finite<N: Lanes>(color: Rgb<N>) -> Rgb<N> {
    Rgb::new(
        color.r.clamped(-f32::MAX, f32::MAX),
        color.g.clamped(-f32::MAX, f32::MAX),
        color.b.clamped(-f32::MAX, f32::MAX),
    )
}
