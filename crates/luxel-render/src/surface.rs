//! The surface at sixteen samples: interpolated, textured, and handed to the lighting equation.

use crate::corners::Corners;
use crate::holes::transformed;
use crate::shade::Scene16;
use luxel_lighting::{Reflectance, Silent, SurfacePoint, Surroundings};
use luxel_math::{LANES, Rgb, Simd, Vec3, f32x16, prelude::*};
use luxel_scene::{AlphaMode, SceneMaterial, TextureUse};

/// What interpolation starts from, for sixteen samples.
pub(crate) struct Interpolated<S: Simd> {
    /// Barycentrics at the sample.
    pub(crate) weights: [f32x16<S>; 3],
    /// Barycentrics one pixel to the right and one below, in the triangle's plane: how textures
    /// learn what a pixel covers.
    pub(crate) weights_right: [f32x16<S>; 3],
    pub(crate) weights_below: [f32x16<S>; 3],
    /// Pixels from the nearest edge of the polygon.
    pub(crate) edge_distance: f32x16<S>,
    /// Each sample's material, by number.
    pub(crate) materials: [u32; LANES],
    /// The lanes that see a triangle.
    pub(crate) seen: u32,
}

/// Place, unit normal and direction to the eye of sixteen samples.
#[inline(always)]
pub(crate) fn point<S: Simd>(
    scene: &Scene16<'_>,
    interpolated: &Interpolated<S>,
    corners: &Corners,
) -> SurfacePoint<f32x16<S>> {
    let position = corners.position(&interpolated.weights);
    let normal = corners.normal(&interpolated.weights).normalized_or_zero();
    let view = match scene.spaces.first() {
        Some(space) if space.parallel => {
            Vec3::splat(position.x, (-scene.direction).as_vec3().to_array())
        }
        _ => (-position).normalized_or_zero(),
    };
    let along = Vec3::splat(position.x, scene.direction.as_vec3().to_array());
    SurfacePoint { position, normal, view, depth: position.dot(along) }
}

/// Samples a texture at the lanes whose bit is set. Compiled once a level, not into its callers.
#[inline(never)]
fn sample<S: Simd>(
    scene: &Scene16<'_>,
    used: &TextureUse,
    interpolated: &Interpolated<S>,
    corners: &Corners,
    lanes: u32,
) -> [f32x16<S>; 4] {
    interpolated.weights[0].simd.vectorize(
        #[inline(always)]
        || sample_lanes(scene, used, interpolated, corners, lanes),
    )
}

#[inline(always)]
fn sample_lanes<S: Simd>(
    scene: &Scene16<'_>,
    used: &TextureUse,
    interpolated: &Interpolated<S>,
    corners: &Corners,
    lanes: u32,
) -> [f32x16<S>; 4] {
    let set = usize::from(used.uv_set);
    let [u, v] = corners.uv(set, &interpolated.weights);
    let [right_u, right_v] = corners.uv(set, &interpolated.weights_right);
    let [below_u, below_v] = corners.uv(set, &interpolated.weights_below);
    let texture = &scene.scene.textures[used.texture.index()];
    let mut texels = [[0.0; LANES]; 4];
    for lane in (0..LANES).filter(|lane| lanes >> lane & 1 == 1) {
        let here = transformed(used, [u[lane], v[lane]]);
        let right = transformed(used, [right_u[lane], right_v[lane]]);
        let below = transformed(used, [below_u[lane], below_v[lane]]);
        let along_x = [right[0] - here[0], right[1] - here[1]];
        let along_y = [below[0] - here[0], below[1] - here[1]];
        let texel = texture.sample(here[0], here[1], along_x, along_y);
        for (channel, value) in texels.iter_mut().zip(texel) {
            channel[lane] = value;
        }
    }
    texels.map(|channel| f32x16::simd_from(u.simd, channel))
}

/// Samples a texture that a material may lack.
#[inline(always)]
fn texel<S: Simd>(
    scene: &Scene16<'_>,
    used: Option<TextureUse>,
    interpolated: &Interpolated<S>,
    corners: &Corners,
    lanes: u32,
) -> Option<[f32x16<S>; 4]> {
    match used {
        Some(used) => Some(sample(scene, &used, interpolated, corners, lanes)),
        None => None,
    }
}

/// A texel's value as a signed number: 0..1 becomes -1..1.
#[inline(always)]
fn signed<S: Simd>(value: f32x16<S>) -> f32x16<S> {
    value + value - value.one()
}

/// Multiplies a colour by a texture's, if there is one.
#[inline(always)]
fn tinted<S: Simd>(color: Rgb<f32x16<S>>, texel: Option<[f32x16<S>; 4]>) -> Rgb<f32x16<S>> {
    match texel {
        Some([r, g, b, _]) => color * Rgb::new(r, g, b),
        None => color,
    }
}

/// The unit normal after a normal map: n = x T + y B + z N with B = sign (N x T).
#[inline(always)]
fn mapped_normal<S: Simd>(
    scene: &Scene16<'_>,
    used: &TextureUse,
    interpolated: &Interpolated<S>,
    corners: &Corners,
    normal: Vec3<f32x16<S>>,
    lanes: u32,
) -> Vec3<f32x16<S>> {
    let [r, g, b, _] = sample(scene, used, interpolated, corners, lanes);
    let strength = r.constant(used.strength);
    let (tangent, sign) = corners.tangent(&interpolated.weights);
    let bitangent = normal.cross(tangent) * sign;
    let mapped =
        tangent * (signed(r) * strength) + bitangent * (signed(g) * strength) + normal * signed(b);
    let mapped = mapped.normalized_or_zero();
    let sound = r.zero().less(mapped.dot(mapped));
    mapped.select(sound, normal)
}

/// The normals that shading uses, normal maps included.
#[inline(always)]
pub(crate) fn shading_normals<S: Simd>(
    scene: &Scene16<'_>,
    interpolated: &Interpolated<S>,
    corners: &Corners,
    point: &SurfacePoint<f32x16<S>>,
) -> Vec3<f32x16<S>> {
    let mut normals = point.normal;
    for (number, material) in scene.scene.materials.iter().enumerate() {
        let Some(used) = material.normal.filter(|_| corners.has.tangents) else { continue };
        let mut lanes = 0;
        for (lane, other) in interpolated.materials.iter().enumerate() {
            lanes |= u32::from(*other as usize == number) << lane;
        }
        if lanes != 0 {
            let mapped = mapped_normal(scene, &used, interpolated, corners, point.normal, lanes);
            normals = mapped.select(crate::shade::mask(point.normal.x, lanes), normals);
        }
    }
    normals
}

/// Colour and alpha of the lanes that see one material.
#[inline(always)]
pub(crate) fn lit<S: Simd>(
    scene: &Scene16<'_>,
    interpolated: &Interpolated<S>,
    corners: &Corners,
    point: &SurfacePoint<f32x16<S>>,
    number: usize,
    lanes: u32,
) -> [f32x16<S>; 4] {
    let material: &SceneMaterial = &scene.scene.materials[number];
    let like = point.position.x;
    let constants = &material.constants;
    let mut reflectance = Reflectance::of(like, constants);
    let mut alpha = like.constant(material.opacity);

    let base = texel(scene, material.base_color, interpolated, corners, lanes);
    let mut base_tint = tinted(Rgb::splat(like, [1.0; 3]), base);
    if let Some([.., texel_alpha]) = base {
        alpha *= texel_alpha;
    }
    if corners.has.colors {
        let [r, g, b, color_alpha] = corners.color(&interpolated.weights);
        base_tint = base_tint * Rgb::new(r, g, b);
        alpha *= color_alpha;
    }
    if let Some([r, ..]) = texel(scene, material.opacity_map, interpolated, corners, lanes) {
        alpha *= r;
    }
    reflectance.diffuse = reflectance.diffuse * base_tint;
    reflectance.ambient = match (constants.ambient, material.ambient) {
        (None, _) => reflectance.diffuse,
        (Some(_), None) => reflectance.ambient * base_tint,
        (Some(_), used @ Some(_)) => {
            tinted(reflectance.ambient, texel(scene, used, interpolated, corners, lanes))
        }
    };
    reflectance.specular =
        tinted(reflectance.specular, texel(scene, material.specular, interpolated, corners, lanes));
    reflectance.emission =
        tinted(reflectance.emission, texel(scene, material.emission, interpolated, corners, lanes));
    if let Some([_, g, b, _]) =
        texel(scene, material.metallic_roughness, interpolated, corners, lanes)
    {
        reflectance.roughness *= g;
        reflectance.metallic *= b;
    }
    if let Some(used) = material.occlusion {
        let [r, ..] = sample(scene, &used, interpolated, corners, lanes);
        let strength = like.constant(used.strength);
        reflectance.occlusion = like.one() + strength * (r - like.one());
    }
    let mut point = *point;
    if let Some(used) = material.normal.filter(|_| corners.has.tangents) {
        point.normal = mapped_normal(scene, &used, interpolated, corners, point.normal, lanes);
    }
    let surroundings = Surroundings {
        lights: scene.lights,
        scene_ambient: scene.ambient,
        environment: scene.environments[number],
        fog: scene.fog,
    };
    let color = luxel_lighting::lit(&point, &reflectance, constants, &surroundings, &mut Silent);
    let alpha = match material.alpha_mode {
        AlphaMode::Blend => alpha.limited(0.0, 1.0),
        AlphaMode::Opaque | AlphaMode::Mask { .. } => like.one(),
    };
    [color.r, color.g, color.b, alpha]
}
