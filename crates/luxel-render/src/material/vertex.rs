//! Light computed elsewhere than at pixels: at corners, at centroids, at the corners of pieces.

use super::attributes::{Attributes, Corner};
use super::surface::{SurfaceWitness, reflectance};
use crate::context::{AttributeMask, LitAt, ShadingContext};
use crate::subdivision::{PlaceLight, TexelLight};
use luxel_lighting::{Coefficients, Occlusion, Silent, reflected};
use luxel_math::{Lanes, Rgb, Vec3};
use luxel_view::Clamp;

/// The light that leaves a place, without the texture of its base colour; clamped if the view says so.
pub(crate) fn light_at<W: SurfaceWitness<f32>>(
    scene: &ShadingContext<'_>,
    corner: &Corner,
    has: AttributeMask,
    material: u32,
    witness: &mut W,
) -> [f32; 3] {
    let light = light_under(scene, corner, has, material, [1.0; 3], witness);
    clamped(scene, Rgb::splat(0.0, light)).lane(0)
}

/// The light that leaves a place under a texel of its base colour; not clamped.
pub(crate) fn light_under<W: SurfaceWitness<f32>>(
    scene: &ShadingContext<'_>,
    corner: &Corner,
    has: AttributeMask,
    material: u32,
    texel: [f32; 3],
    witness: &mut W,
) -> [f32; 3] {
    let place = Attributes::at(corner, has);
    lights_under(scene, &place, (material as usize, 1), Rgb::splat(0.0, texel), witness).lane(0)
}

/// The light that leaves places of one material under a texel of its base colour; not clamped.
#[inline(always)]
fn lights_under<N: Lanes, W: SurfaceWitness<N>>(
    scene: &ShadingContext<'_>,
    place: &Attributes<N>,
    (number, lanes): (usize, u32),
    texel: Rgb<N>,
    witness: &mut W,
) -> Rgb<N> {
    let point = scene.point_at_vertex(place.position, place.normal);
    let reflectance = reflectance(scene, place, number, lanes, texel);
    witness.surface(&point, &reflectance, point.depth.one());
    let constants = &scene.scene.materials[number].constants;
    let coefficients = Coefficients::new(&reflectance, constants);
    let lighting = scene.lighting(number);
    let reflection = &constants.reflection;
    reflected(&point, &coefficients, reflection, lighting, Occlusion::NONE, witness)
}

/// [`light_at`] at places of one material.
#[inline(always)]
pub(crate) fn lights_with<N: Lanes, W: SurfaceWitness<N>>(
    scene: &ShadingContext<'_>,
    place: &Attributes<N>,
    of: (usize, u32),
    witness: &mut W,
) -> Rgb<N> {
    let white = Rgb::splat(place.position.x, [1.0; 3]);
    clamped(scene, lights_under(scene, place, of, white, witness))
}

/// The light of a triangle between its corners, as its pieces interpolate it.
pub(crate) struct TriangleLight<'a> {
    pub(crate) scene: &'a ShadingContext<'a>,
    pub(crate) corners: &'a [Corner; 3],
    pub(crate) has: AttributeMask,
    pub(crate) material: u32,
}

impl TriangleLight<'_> {
    /// Whether the light is that under any texel.
    fn is_textured(&self) -> bool {
        self.scene.lit_at(self.material as usize) == LitAt::PiecesUnderTexels
    }

    /// The texels of the base colour that count.
    pub(crate) fn texels(&self) -> &'static [f32] {
        if self.is_textured() { TexelLight::TEXELS } else { TexelLight::WHITE }
    }
}

impl PlaceLight for TriangleLight<'_> {
    #[inline(always)]
    fn light<N: Lanes>(&self, place: [N; 3], lanes: u32) -> TexelLight<N> {
        let Self { scene, corners, has, material } = *self;
        let place = &Attributes::between(corners, &place, has);
        let of = (material as usize, lanes);
        let mut under = [place.light; 3];
        for (light, texel) in under.iter_mut().zip(self.texels()) {
            let texel = Rgb::splat(place.position.x, [*texel; 3]);
            *light = lights_under(scene, place, of, texel, &mut Silent);
        }
        if !self.is_textured() {
            let Rgb { r, g, b } = clamped(scene, under[0]);
            return TexelLight::untextured([r, g, b]);
        }
        let [black, gray, white] = under;
        TexelLight::through([
            [black.r, black.g, black.b],
            [gray.r, gray.g, gray.b],
            [white.r, white.g, white.b],
        ])
    }
}

/// [`light_at`] at a corner of each lane's triangle, of a material without textures and vertex colours.
/// Outlined: one copy per lane type.
#[inline(never)]
pub(crate) fn lights_at<N: Lanes>(
    scene: &ShadingContext<'_>,
    position: &Vec3<N>,
    normal: &Vec3<N>,
    material: usize,
) -> Rgb<N> {
    position.x.vectorized(
        #[inline(always)]
        || {
            let point = scene.point_at_vertex(*position, *normal);
            let Some(coefficients) = &scene.uniform[material] else {
                return Rgb::black(position.x);
            };
            let reflection = &scene.scene.materials[material].constants.reflection;
            let lighting = scene.lighting(material);
            let light =
                reflected(&point, coefficients, reflection, lighting, Occlusion::NONE, &mut Silent);
            clamped(scene, light)
        },
    )
}

/// An intensity as it is interpolated.
#[inline(always)]
fn clamped<N: Lanes>(scene: &ShadingContext<'_>, light: Rgb<N>) -> Rgb<N> {
    match scene.shading.clamp {
        Clamp::Vertex => Rgb::new(
            light.r.clamped(0.0, scene.white),
            light.g.clamped(0.0, scene.white),
            light.b.clamped(0.0, scene.white),
        ),
        Clamp::End => light,
    }
}
