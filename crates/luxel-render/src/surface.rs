//! The surface at sixteen samples: interpolated, textured, and handed to the lighting equation.

use crate::gathered::{Gathered, Met, OfInstance, loaded};
use crate::shade::Scene16;
use crate::triangles::Attributes;
use crate::varying::{Varying, Weights, lanes_of, merge};
use crate::view::NormalLength;
use luxel_lighting::{Coefficients, Reflectance, Silent, SurfacePoint, Witness, lit_by};
use luxel_math::{LANES, Number, Rgb, Vec3};
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

/// What sixteen samples see.
pub(crate) struct Interpolated<N> {
    /// Barycentrics at the sample.
    pub(crate) weights: [N; 3],
    /// What the surface is there.
    pub(crate) varying: Varying<N>,
    /// Pixels from the nearest edge of the polygon.
    pub(crate) edge_distance: N,
    /// Each sample's material, by number.
    pub(crate) materials: [u32; LANES],
    /// The lanes that see a triangle.
    pub(crate) seen: u32,
}

impl<N: Number> Interpolated<N> {
    /// Where nothing is seen; `like` tells only the kind of number.
    #[inline(always)]
    pub(crate) fn nothing(like: N) -> Self {
        Self {
            weights: [like.zero(); 3],
            varying: Varying::nothing(like),
            edge_distance: like.constant(f32::MAX),
            materials: [u32::MAX; LANES],
            seen: 0,
        }
    }

    /// Takes what was gathered of the triangles of one instance.
    #[inline(always)]
    pub(crate) fn take(&mut self, gathered: &Gathered, of: OfInstance) {
        let like = self.edge_distance;
        let mask = like.mask_of(of.lanes);
        for lane in lanes_of(of.lanes) {
            self.materials[lane & (LANES - 1)] = gathered.materials[lane & (LANES - 1)];
        }
        self.seen |= of.lanes;
        let Met { weights, position, normal, .. } = &gathered.met;
        let here = loaded(like, &weights.here, 0);
        merge(&mut self.weights, here, mask);
        let [x, y, z] = loaded(like, position, 0);
        let [across, up, towards] = loaded(like, normal, 0);
        self.varying.take_places(Vec3::new(x, y, z), Vec3::new(across, up, towards), mask);
        if of.has != Attributes::default() {
            let (right, below) = (loaded(like, &weights.right, 0), loaded(like, &weights.below, 0));
            let weights = Weights { here, right, below };
            self.varying.take_gathered(&gathered.extras, &weights, of.has, mask);
        }
    }

    /// Takes the material of some lanes, before they count as seen.
    #[inline(always)]
    pub(crate) fn put_material(&mut self, lanes: u32, material: u32) {
        if self.seen == 0 {
            self.materials = [material; LANES];
            return;
        }
        for (lane, of) in self.materials.iter_mut().enumerate() {
            if lanes >> lane & 1 == 1 {
                *of = material;
            }
        }
    }
}

/// Place, normal and direction to the eye of sixteen samples.
#[inline(always)]
pub(crate) fn point<N: Number>(
    scene: &Scene16<'_>,
    position: Vec3<N>,
    normal: Vec3<N>,
) -> SurfacePoint<N> {
    let normal = match scene.shading.normal_length {
        NormalLength::Unit => normal.normalized_or_zero(),
        NormalLength::Interpolated => normal,
    };
    let view = match scene.spaces.first() {
        Some(space) if space.parallel => {
            Vec3::splat(position.x, (-scene.direction).as_vec3().to_array())
        }
        _ => (-position).normalized_or_zero(),
    };
    SurfacePoint { position, normal, view, depth: depth(scene, position) }
}

/// The distance from the eye along the viewing axis.
#[inline(always)]
pub(crate) fn depth<N: Number>(scene: &Scene16<'_>, position: Vec3<N>) -> N {
    position.dot(Vec3::splat(position.x, scene.direction.as_vec3().to_array()))
}

/// Samples the first `C` channels of a texture at the lanes whose bit is set. Compiled once a level, not
/// into its callers.
#[inline(never)]
fn sample<N: Number, const C: usize>(
    scene: &Scene16<'_>,
    used: &TextureUse,
    varying: &Varying<N>,
    lanes: u32,
) -> [N; C] {
    varying.position.x.vectorized(
        #[inline(always)]
        || sample_lanes(scene, used, varying, lanes),
    )
}

#[inline(always)]
fn sample_lanes<N: Number, const C: usize>(
    scene: &Scene16<'_>,
    used: &TextureUse,
    varying: &Varying<N>,
    lanes: u32,
) -> [N; C] {
    let [here, right, below] = varying.uv(usize::from(used.uv_set & 1));
    let texture = &scene.scene.textures[used.texture.index()];
    let [here, right, below] =
        [used.transformed(here), used.transformed(right), used.transformed(below)];
    let along_x = [right[0] - here[0], right[1] - here[1]];
    let along_y = [below[0] - here[0], below[1] - here[1]];
    texture.sample(here, along_x, along_y, lanes)
}

/// Samples a texture that a material may lack.
#[inline(always)]
fn texel<N: Number, const C: usize>(
    scene: &Scene16<'_>,
    used: Option<TextureUse>,
    varying: &Varying<N>,
    lanes: u32,
) -> Option<[N; C]> {
    match used {
        Some(used) => Some(sample(scene, &used, varying, lanes)),
        None => None,
    }
}

/// Multiplies a colour by a texture's, if there is one.
#[inline(always)]
fn tinted<N: Number>(color: Rgb<N>, texel: Option<[N; 3]>) -> Rgb<N> {
    match texel {
        Some([r, g, b]) => color * Rgb::new(r, g, b),
        None => color,
    }
}

/// The unit normal after a normal map: n = x T + y B + z N with B = sign (N x T).
#[inline(always)]
fn mapped_normal<N: Number>(
    scene: &Scene16<'_>,
    used: &TextureUse,
    varying: &Varying<N>,
    normal: Vec3<N>,
    lanes: u32,
) -> Vec3<N> {
    let [r, g, b] = sample(scene, used, varying, lanes);
    let [x, y, z, sign] = varying.tangent();
    luxel_scene::mapped_normal(normal, (Vec3::new(x, y, z), sign), [r, g, b], used.strength)
}

/// The normals that shading uses, normal maps included.
#[inline(always)]
pub(crate) fn shading_normals<N: Number>(
    scene: &Scene16<'_>,
    interpolated: &Interpolated<N>,
    point: &SurfacePoint<N>,
) -> Vec3<N> {
    let varying = &interpolated.varying;
    let mut normals = point.normal;
    for (number, material) in scene.scene.materials.iter().enumerate() {
        let Some(used) = material.normal.filter(|_| varying.has.tangents) else { continue };
        let mut lanes = 0;
        for (lane, other) in interpolated.materials.iter().enumerate() {
            let seen = interpolated.seen >> lane & 1 == 1;
            lanes |= u32::from(seen && *other as usize == number) << lane;
        }
        if lanes != 0 {
            let mapped = mapped_normal(scene, &used, varying, point.normal, lanes);
            normals = mapped.select(point.normal.x.mask_of(lanes), normals);
        }
    }
    normals
}

/// The texture of the base colour, and alpha, at the lanes that see one material.
#[inline(always)]
fn base<N: Number>(
    scene: &Scene16<'_>,
    varying: &Varying<N>,
    number: usize,
    lanes: u32,
) -> (Rgb<N>, N) {
    let material: &SceneMaterial = &scene.scene.materials[number];
    let like = varying.position.x;
    let white = Rgb::splat(like, [1.0; 3]);
    if material.alpha_mode != AlphaMode::Blend {
        let base = texel(scene, material.base_color, varying, lanes);
        return (tinted(white, base), like.one());
    }
    let mut alpha = like.constant(material.opacity);
    let mut tint = white;
    if let Some([r, g, b, texel_alpha]) = texel(scene, material.base_color, varying, lanes) {
        tint = tint * Rgb::new(r, g, b);
        alpha = alpha * texel_alpha;
    }
    if varying.has.colors && material.vertex_colors {
        let [.., color_alpha] = varying.color();
        alpha = alpha * color_alpha;
    }
    if let Some([r]) = texel(scene, material.opacity_map, varying, lanes) {
        alpha = alpha * r;
    }
    (tint, alpha.limited(0.0, 1.0))
}

/// What the surface reflects at the lanes that see one material, its base colour times `tint` and
/// the colours of the corners.
#[inline(always)]
pub(crate) fn reflectance<N: Number>(
    scene: &Scene16<'_>,
    varying: &Varying<N>,
    number: usize,
    lanes: u32,
    tint: Rgb<N>,
) -> Reflectance<N> {
    let material: &SceneMaterial = &scene.scene.materials[number];
    let like = varying.position.x;
    let constants = &material.constants;
    let mut reflectance = Reflectance::of(like, constants);
    let mut base_tint = tint;
    if varying.has.colors && material.vertex_colors {
        let [r, g, b, _] = varying.color();
        base_tint = base_tint * Rgb::new(r, g, b);
    }
    reflectance.diffuse = reflectance.diffuse * base_tint;
    reflectance.ambient = match (constants.ambient, material.ambient) {
        (None, _) => reflectance.diffuse,
        (Some(_), None) => reflectance.ambient * base_tint,
        (Some(_), used @ Some(_)) => {
            tinted(reflectance.ambient, texel(scene, used, varying, lanes))
        }
    };
    reflectance.specular =
        tinted(reflectance.specular, texel(scene, material.specular, varying, lanes));
    reflectance.emission =
        tinted(reflectance.emission, texel(scene, material.emission, varying, lanes));
    if let Some([_, g, b]) = texel(scene, material.metallic_roughness, varying, lanes) {
        reflectance.roughness = reflectance.roughness * g;
        reflectance.metallic = reflectance.metallic * b;
    }
    if let Some(used) = material.occlusion {
        let [r] = sample(scene, &used, varying, lanes);
        let strength = like.constant(used.strength);
        reflectance.occlusion = like.one() + strength * (r - like.one());
    }
    reflectance
}

/// Colour and alpha of the lanes that see one material, lit at the pixel.
#[inline(always)]
pub(crate) fn lit<N: Number, W: SurfaceWitness<N>>(
    scene: &Scene16<'_>,
    varying: &Varying<N>,
    point: &SurfacePoint<N>,
    number: usize,
    lanes: u32,
    witness: &mut W,
) -> [N; 4] {
    let material: &SceneMaterial = &scene.scene.materials[number];
    let (tint, alpha) = base(scene, varying, number, lanes);
    let mut point = *point;
    if let Some(used) = material.normal.filter(|_| varying.has.tangents) {
        point.normal = mapped_normal(scene, &used, varying, point.normal, lanes);
    }
    let constants = &material.constants;
    let colored = varying.has.colors && material.vertex_colors;
    let surroundings = scene.surroundings(number);
    let reflection = &constants.reflection;
    let color = match &scene.uniform[number] {
        Some(uniform) if !W::HEARS_SURFACES && !colored => {
            lit_by(&point, uniform, reflection, &surroundings, witness)
        }
        _ => {
            let reflectance = reflectance(scene, varying, number, lanes, tint);
            witness.surface(&point, &reflectance, alpha);
            let coefficients = Coefficients::new(&reflectance, constants);
            lit_by(&point, &coefficients, reflection, &surroundings, witness)
        }
    };
    [color.r, color.g, color.b, alpha]
}

/// Colour and alpha of the lanes that see one material, whose light was computed elsewhere: the
/// texture of the base colour times the light, and fog.
#[inline(always)]
pub(crate) fn lit_elsewhere<N: Number, W: SurfaceWitness<N>>(
    scene: &Scene16<'_>,
    varying: &Varying<N>,
    point: &SurfacePoint<N>,
    number: usize,
    lanes: u32,
    witness: &mut W,
) -> [N; 4] {
    let (tint, alpha) = base(scene, varying, number, lanes);
    let sum = varying.light() * tint;
    witness.elsewhere(point, tint, sum);
    let color = match scene.fog {
        Some(fog) => fog.veiled(sum, point.depth, witness),
        None => sum,
    };
    witness.color(color);
    [color.r, color.g, color.b, alpha]
}

/// The light that leaves a place on a surface, without the texture of its base colour.
pub(crate) fn lit_at_corner<W: SurfaceWitness<f32>>(
    scene: &Scene16<'_>,
    place: &Varying<f32>,
    number: usize,
    witness: &mut W,
) -> [f32; 3] {
    let point = point(scene, place.position, place.normal);
    let white = Rgb::splat(0.0, [1.0; 3]);
    let reflectance = reflectance(scene, place, number, 1, white);
    witness.surface(&point, &reflectance, 1.0);
    let constants = &scene.scene.materials[number].constants;
    let coefficients = Coefficients::new(&reflectance, constants);
    let surroundings = scene.surroundings(number);
    let reflection = &constants.reflection;
    luxel_lighting::reflected(&point, &coefficients, reflection, &surroundings, witness).lane(0)
}
