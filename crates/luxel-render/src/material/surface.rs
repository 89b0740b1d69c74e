//! Interpolated attributes become light: textures make a reflectance of the material, and the lighting
//! equation does the rest.

use super::attributes::Attributes;
use crate::context::{AttributeMask, LitAt, ShadingContext, needs};
use luxel_lighting::{Coefficients, Occlusion, Reflectance, Silent, SurfacePoint, Witness, lit_by};
use luxel_math::{Lanes, Rgb, Vec3};
use luxel_scene::{AlphaMode, SceneMaterial, TextureUse};

/// Hears what is seen, and the terms of its light.
pub(crate) trait SurfaceWitness<N>: Witness<N> {
    /// Whether it hears what surfaces reflect; otherwise that needn't be worked out anew where it is
    /// known.
    const HEARS_SURFACES: bool = true;

    /// The point that is lit, what its surface reflects there, and its alpha.
    #[inline(always)]
    fn surface(&mut self, point: &SurfacePoint<N>, reflectance: &Reflectance<N>, alpha: N) {
        let _ = (point, reflectance, alpha);
    }

    /// The point that is seen, the texture of its base colour, and its light, where that was
    /// computed elsewhere.
    #[inline(always)]
    fn elsewhere(&mut self, point: &SurfacePoint<N>, tint: Rgb<N>, sum: Rgb<N>) {
        let _ = (point, tint, sum);
    }
}

impl<N> SurfaceWitness<N> for Silent {
    const HEARS_SURFACES: bool = false;
}

/// Samples the first `C` channels of a texture at the lanes whose bit is set.
///
/// All four are sampled where a copy for each number of channels isn't [worth its
/// code](Lanes::IS_SPECIALIZED).
#[inline(always)]
fn sample<N: Lanes, const C: usize>(
    scene: &ShadingContext<'_>,
    used: &TextureUse,
    varying: &Attributes<N>,
    lanes: u32,
) -> [N; C] {
    if N::IS_SPECIALIZED {
        return sample_channels(scene, used, varying, lanes);
    }
    let channels: [N; 4] = sample_channels(scene, used, varying, lanes);
    let mut first = [channels[0]; C];
    first.copy_from_slice(&channels[..C]);
    first
}

/// Outlined: one copy per lane type and number of channels.
#[inline(never)]
fn sample_channels<N: Lanes, const C: usize>(
    scene: &ShadingContext<'_>,
    used: &TextureUse,
    varying: &Attributes<N>,
    lanes: u32,
) -> [N; C] {
    varying.position.x.vectorized(
        #[inline(always)]
        || sample_lanes(scene, used, varying, lanes),
    )
}

#[inline(always)]
fn sample_lanes<N: Lanes, const C: usize>(
    scene: &ShadingContext<'_>,
    used: &TextureUse,
    varying: &Attributes<N>,
    lanes: u32,
) -> [N; C] {
    let [here, right, down] = varying.uv[usize::from(used.uv_set & 1)];
    let texture = &scene.scene.textures[used.texture.index()];
    let [right, down] = [used.transformed_step(right), used.transformed_step(down)];
    texture.sample(used.transformed(here), right, down, lanes)
}

/// Samples a texture that a material may lack.
#[inline(always)]
fn texel<N: Lanes, const C: usize>(
    scene: &ShadingContext<'_>,
    used: Option<&TextureUse>,
    varying: &Attributes<N>,
    lanes: u32,
) -> Option<[N; C]> {
    match used {
        Some(used) => Some(sample(scene, used, varying, lanes)),
        None => None,
    }
}

/// Multiplies a colour by a texture's, if there is one.
#[inline(always)]
fn tinted<N: Lanes>(color: Rgb<N>, texel: Option<[N; 3]>) -> Rgb<N> {
    match texel {
        Some([r, g, b]) => color * Rgb::new(r, g, b),
        None => color,
    }
}

/// The unit normal after a normal map: n = x T + y B + z N with B = sign (N x T).
#[inline(always)]
fn mapped_normal<N: Lanes>(
    scene: &ShadingContext<'_>,
    used: &TextureUse,
    varying: &Attributes<N>,
    normal: Vec3<N>,
    lanes: u32,
) -> Vec3<N> {
    let [r, g, b] = sample(scene, used, varying, lanes);
    let [x, y, z, sign] = varying.tangent;
    luxel_scene::mapped_normal(normal, (Vec3::new(x, y, z), sign), [r, g, b], used.strength)
}

/// The normal that shading uses at the lanes that see one material, normal map included.
#[inline(always)]
pub(crate) fn shading_normal<N: Lanes>(
    scene: &ShadingContext<'_>,
    varying: &Attributes<N>,
    normal: Vec3<N>,
    number: usize,
    lanes: u32,
) -> Vec3<N> {
    match scene.scene.materials[number]
        .normal
        .as_deref()
        .filter(|_| varying.has.has(AttributeMask::TANGENTS))
    {
        Some(used) => mapped_normal(scene, used, varying, normal, lanes),
        None => normal,
    }
}

/// The texture of the base colour at the lanes that see one material; white where it has none.
pub(crate) fn base_texel<N: Lanes>(
    scene: &ShadingContext<'_>,
    varying: &Attributes<N>,
    number: usize,
    lanes: u32,
) -> Rgb<N> {
    let white = Rgb::splat(varying.position.x, [1.0; 3]);
    tinted(white, texel(scene, scene.scene.materials[number].base_color.as_deref(), varying, lanes))
}

/// The texture of the base colour, and alpha, at the lanes that see one material.
#[inline(always)]
fn base<N: Lanes, const NEEDS: u8>(
    scene: &ShadingContext<'_>,
    varying: &Attributes<N>,
    number: usize,
    lanes: u32,
) -> (Rgb<N>, N) {
    let material: &SceneMaterial = &scene.scene.materials[number];
    let simd = varying.position.x;
    let white = Rgb::splat(simd, [1.0; 3]);
    if NEEDS != needs::ALL {
        let is_blended = material.alpha_mode == AlphaMode::Blend;
        let alpha = if is_blended { Lanes::clamped(material.opacity, 0.0, 1.0) } else { 1.0 };
        return (white, simd.constant(alpha));
    }
    if material.alpha_mode != AlphaMode::Blend {
        let base = texel(scene, material.base_color.as_deref(), varying, lanes);
        return (tinted(white, base), simd.one());
    }
    let mut alpha = simd.constant(material.opacity);
    let mut tint = white;
    if let Some([r, g, b, texel_alpha]) =
        texel(scene, material.base_color.as_deref(), varying, lanes)
    {
        tint = tint * Rgb::new(r, g, b);
        alpha = alpha * texel_alpha;
    }
    if varying.has.has(AttributeMask::COLORS) && material.vertex_colors {
        let [.., color_alpha] = varying.color;
        alpha = alpha * color_alpha;
    }
    if let Some([r]) = texel(scene, material.opacity_map.as_deref(), varying, lanes) {
        alpha = alpha * r;
    }
    (tint, alpha.clamped(0.0, 1.0))
}

/// What the surface reflects at the lanes that see one material, its base colour times `tint` and
/// the colours of the corners.
#[inline(always)]
pub(crate) fn reflectance<N: Lanes>(
    scene: &ShadingContext<'_>,
    varying: &Attributes<N>,
    number: usize,
    lanes: u32,
    tint: Rgb<N>,
) -> Reflectance<N> {
    let material: &SceneMaterial = &scene.scene.materials[number];
    let simd = varying.position.x;
    let constants = &material.constants;
    let mut reflectance = Reflectance::of(simd, constants);
    let mut base_tint = tint;
    if varying.has.has(AttributeMask::COLORS) && material.vertex_colors {
        let [r, g, b, _] = varying.color;
        base_tint = base_tint * Rgb::new(r, g, b);
    }
    reflectance.diffuse = reflectance.diffuse * base_tint;
    reflectance.ambient = match (constants.ambient, material.ambient.as_deref()) {
        (None, _) => reflectance.diffuse,
        (Some(_), None) => reflectance.ambient * base_tint,
        (Some(_), used @ Some(_)) => {
            tinted(reflectance.ambient, texel(scene, used, varying, lanes))
        }
    };
    reflectance.specular =
        tinted(reflectance.specular, texel(scene, material.specular.as_deref(), varying, lanes));
    reflectance.emission =
        tinted(reflectance.emission, texel(scene, material.emission.as_deref(), varying, lanes));
    if let Some([_, g, b]) = texel(scene, material.metallic_roughness.as_deref(), varying, lanes) {
        reflectance.roughness = reflectance.roughness * g;
        reflectance.metallic = reflectance.metallic * b;
    }
    if let Some(used) = material.occlusion.as_deref() {
        let [r] = sample(scene, used, varying, lanes);
        let strength = simd.constant(used.strength);
        reflectance.occlusion = simd.one() + strength * (r - simd.one());
    }
    reflectance
}

/// Colour and alpha of the lanes that see one material, lit at the pixel, with the
/// [`shading_normal`].
#[inline(always)]
pub(crate) fn lit<N: Lanes, W: SurfaceWitness<N>, const NEEDS: u8>(
    scene: &ShadingContext<'_>,
    varying: &Attributes<N>,
    point: &SurfacePoint<N>,
    (number, lanes): (usize, u32),
    occlusion: Occlusion<'_>,
    witness: &mut W,
) -> [N; 4] {
    let material: &SceneMaterial = &scene.scene.materials[number];
    let (tint, alpha) = base::<N, NEEDS>(scene, varying, number, lanes);
    let constants = &material.constants;
    let colored = varying.has.has(AttributeMask::COLORS) && material.vertex_colors;
    let lighting = scene.lighting(number);
    let reflection = &constants.reflection;
    let color = match &scene.uniform[number] {
        Some(uniform) if NEEDS != needs::ALL || (!W::HEARS_SURFACES && !colored) => {
            lit_by(point, uniform, reflection, lighting, occlusion, witness)
        }
        // Materials with textures always count as having extras.
        None if NEEDS != needs::ALL => Rgb::black(alpha),
        _ => {
            let reflectance = reflectance(scene, varying, number, lanes, tint);
            witness.surface(point, &reflectance, alpha);
            let coefficients = Coefficients::new(&reflectance, constants);
            lit_by(point, &coefficients, reflection, lighting, occlusion, witness)
        }
    };
    [color.r, color.g, color.b, alpha]
}

/// Colour and alpha of the lanes that see one material, whose light was computed elsewhere: the
/// texture of the base colour times the light, unless it is the light under that texel, and fog.
#[inline(always)]
pub(crate) fn lit_elsewhere<N: Lanes, W: SurfaceWitness<N>, const NEEDS: u8>(
    scene: &ShadingContext<'_>,
    varying: &Attributes<N>,
    point: &SurfacePoint<N>,
    number: usize,
    lanes: u32,
    witness: &mut W,
) -> [N; 4] {
    let (tint, alpha) = base::<N, NEEDS>(scene, varying, number, lanes);
    let is_colored = NEEDS == needs::ALL && scene.lit_at(number) == LitAt::PiecesUnderTexels;
    let sum = if is_colored { varying.light } else { varying.light * tint };
    witness.elsewhere(point, tint, sum);
    let color = match scene.fog {
        Some(fog) => fog.veiled(sum, point.depth, witness),
        None => sum,
    };
    witness.color(color);
    [color.r, color.g, color.b, alpha]
}
