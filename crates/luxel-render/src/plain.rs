//! Blocks of the plainest kind, which most pictures are made of: surfaces that have places and normals
//! and nothing else, of materials without textures, lit at their pixels or at their corners. The same
//! formulas as for any block ([`shade`]), without room for what isn't there.

use crate::gathered::{Wanted, loaded};
use crate::ready::ReadyTriangle;
use crate::shade::{Batch, Kept, Scene16, put_lane, shade};
use crate::surface;
use crate::varying::lanes_of;
use crate::view::{Interpolation, Shading, ShadingMode};
use luxel_lighting::{Coefficients, Silent, Uniform};
use luxel_math::{LANES, Mask, Number, Piecewise, Rgb, Vec3};
use luxel_scene::{AlphaMode, Scene, SceneMaterial};
use luxel_visibility::{LinearForms, TriangleId};

/// What each material reflects that is the same at all its points, but for vertex colours; `None`
/// where textures change it.
pub(crate) fn uniform(materials: &[SceneMaterial]) -> Vec<Option<Coefficients<Uniform>>> {
    let of = |material: &SceneMaterial| {
        let SceneMaterial { base_color, ambient, specular, emission, .. } = material;
        let SceneMaterial { metallic_roughness, occlusion, .. } = material;
        let textures = [base_color, ambient, specular, emission, metallic_roughness, occlusion];
        let has_none = textures.into_iter().all(Option::is_none);
        has_none.then(|| Coefficients::uniform(&material.constants))
    };
    materials.iter().map(of).collect()
}

/// Whether all blocks of a picture are plain.
pub(crate) fn is_plain(
    scene: &Scene,
    uniform: &[Option<Coefficients<Uniform>>],
    shading: Shading,
) -> bool {
    let has_colors = scene.meshes.iter().any(|mesh| !mesh.colors.is_empty());
    let materials = scene.materials.iter().zip(uniform);
    matches!(shading.mode, ShadingMode::Phong | ShadingMode::Gouraud)
        && shading.interpolation == Interpolation::Perspective
        && materials.into_iter().all(|(material, uniform)| {
            uniform.is_some()
                && material.normal.is_none()
                && material.opacity_map.is_none()
                && material.alpha_mode != AlphaMode::Blend
                && !(material.vertex_colors && has_colors)
        })
}

/// What sixteen samples see, if all of it is of one material.
#[derive(Clone, Copy)]
struct Seen<N> {
    /// About the eye, along the world's axes.
    position: Vec3<N>,
    /// What came from the corners: the normal in world space, turned to the side that is seen, not
    /// of unit length; or red, green and blue of the light, where that is computed at corners.
    carried: Vec3<N>,
    /// The lanes that see a triangle.
    lanes: u32,
    material: u32,
}

impl<N: Number> Seen<N> {
    #[inline(always)]
    fn of_components([x, y, z, u, v, w]: [N; 6], lanes: u32, material: u32) -> Self {
        Self { position: Vec3::new(x, y, z), carried: Vec3::new(u, v, w), lanes, material }
    }
}

/// The colour (straight) and alpha of the samples; the background's where nothing is seen.
///
/// What [`shade`] gives, for scenes that [are plain](is_plain). Compiled once a kind of number, not
/// into its callers.
#[inline(never)]
pub(crate) fn shade_plain<N: Number>(
    like: N,
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
) -> [N; 4] {
    like.vectorized(
        #[inline(always)]
        || {
            let all = like.all_lanes() & !like.lanes_equal(&batch.ids, TriangleId::NONE.0);
            let mut seen = None;
            if all != 0 {
                seen = few(like, scene, batch, kept, all);
                if seen.is_none() {
                    seen = many(like, scene, batch, kept, all);
                }
            }
            match seen {
                Some(seen) => lit(scene, &seen),
                None => shade(like, scene, batch, kept, &mut Silent),
            }
        },
    )
}

/// Looks at triangles that are ready, or are made so; `None` if the block sees too many for that, or
/// several materials.
#[inline(always)]
fn few<N: Number>(
    like: N,
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
    all: u32,
) -> Option<Seen<N>> {
    let Kept { ready, gathered, .. } = kept;
    let begins = like.lanes_that_begin(&batch.ids) & all;
    if begins.count_ones() <= FEW {
        return one_by_one(like, scene, batch, kept, all);
    }
    let rows = ready.rows(like, scene, gathered, &batch.ids, [all, begins])?;
    let material = rows.material?;
    let mut meeting =
        Meeting { scene, batch, rows: &rows.triangles, lanes: all, met: [[0.0; LANES]; 6] };
    like.piecewise(&mut meeting);
    let mut met = [like; 6];
    for (number, met) in met.iter_mut().zip(&meeting.met) {
        *number = like.load(met, 0);
    }
    Some(Seen::of_components(met, all, material))
}

/// Up to so many triangles a block are met one by one, each at all lanes: with more it takes less to
/// give each lane its own.
const FEW: u32 = 3;

#[inline(always)]
fn one_by_one<N: Number>(
    like: N,
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
    all: u32,
) -> Option<Seen<N>> {
    let Kept { ready, gathered, .. } = kept;
    let samples = batch.places(like);
    let id = batch.ids[all.trailing_zeros() as usize & (LANES - 1)];
    let lanes = like.lanes_equal(&batch.ids, id);
    let (triangle, material) = ready.one(like, scene, gathered, id)?;
    // What the first triangle gives to lanes of others is overwritten, and nobody asks for the rest.
    let mut met = met(like, triangle, scene, batch, samples, lanes);
    let mut left = all & !lanes;
    while left != 0 {
        let id = batch.ids[left.trailing_zeros() as usize & (LANES - 1)];
        let lanes = like.lanes_equal(&batch.ids, id);
        left &= !lanes;
        let (triangle, other) = ready.one(like, scene, gathered, id)?;
        if other != material {
            return None;
        }
        let mask = like.mask_of(lanes);
        let next = self::met(like, triangle, scene, batch, samples, lanes);
        for (met, next) in met.iter_mut().zip(next) {
            *met = next.select(mask, *met);
        }
    }
    Some(Seen::of_components(met, all, material))
}

/// Where the samples' rays meet one triangle, and what its corners carry there.
#[inline(always)]
fn met<N: Number>(
    like: N,
    triangle: &ReadyTriangle,
    scene: &Scene16<'_>,
    batch: &Batch,
    samples: [N::Wide; 2],
    lanes: u32,
) -> [N; 6] {
    let forms = LinearForms::everywhere(samples[0], &triangle.forms);
    let [u, v, w] = told(&forms, scene, batch, samples, 0, lanes);
    let [a, b, c] = &triangle.corners;
    let mut met = [like; 6];
    for component in 0..6 {
        met[component] = like.constant(a[component]) * u
            + like.constant(b[component]) * v
            + like.constant(c[component]) * w;
    }
    met
}

/// The barycentrics of samples from lane `first` on.
#[inline(always)]
fn told<N: Number>(
    forms: &LinearForms<N::Wide>,
    scene: &Scene16<'_>,
    batch: &Batch,
    [x, y]: [N::Wide; 2],
    first: usize,
    lanes: u32,
) -> [N; 3] {
    let (mut weights, outside) = forms.told(x, y);
    for lane in lanes_of(outside.bits() & lanes) {
        let id = TriangleId(batch.ids[(first + lane) & (LANES - 1)]);
        let Some(triangle) = scene.frame.triangle(id) else { continue };
        let [x, y] = batch.position(first + lane);
        let forms = scene.frame.forms(triangle);
        put_lane(&mut weights, lane, forms.nearest_on_edges(scene.frame.rays(), x, y));
    }
    weights
}

/// Rays on their way to triangles that are ready, one for each lane.
struct Meeting<'a> {
    scene: &'a Scene16<'a>,
    batch: &'a Batch,
    rows: &'a [&'a ReadyTriangle; LANES],
    lanes: u32,
    /// Position, and what corners carry beside it.
    met: [[f32; LANES]; 6],
}

impl Piecewise for Meeting<'_> {
    #[inline(always)]
    fn piece<N: Number>(&mut self, like: N, first: usize) {
        let Self { scene, batch, rows, .. } = *self;
        let samples = batch.places_from(like, first);
        let forms = LinearForms::unpacked(
            samples[0],
            #[inline(always)]
            |lane| &rows[(first + lane) & (LANES - 1)].forms,
        );
        let weights: [N; 3] = told(&forms, scene, batch, samples, first, self.lanes >> first);
        let mut sum = [like.zero(); 6];
        for corner in 0..3 {
            let columns = like.columns(
                #[inline(always)]
                |lane| &rows[(first + lane) & (LANES - 1)].corners[corner],
            );
            for component in 0..6 {
                let part = columns[component] * weights[corner];
                sum[component] = if corner == 0 { part } else { sum[component] + part };
            }
        }
        for (met, sum) in self.met.iter_mut().zip(sum) {
            sum.store(met, first);
        }
    }
}

/// Looks at sixteen triangles at once.
#[inline(always)]
fn many<N: Number>(
    like: N,
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
    lanes: u32,
) -> Option<Seen<N>> {
    let gathered = &mut kept.gathered;
    let wanted = match scene.shading.mode {
        ShadingMode::Gouraud => Wanted::Lights,
        _ => Wanted::Normals,
    };
    let mut left = lanes;
    while left != 0 {
        // Nearly always all.
        left &= !gathered.meet(like, scene, batch, left, wanted)?.lanes;
    }
    let material = gathered.materials[lanes.trailing_zeros() as usize & (LANES - 1)];
    if like.lanes_equal(&gathered.materials, material) & lanes != lanes {
        return None;
    }
    let [x, y, z] = loaded(like, &gathered.met.position, 0);
    let carried = if wanted == Wanted::Lights { &gathered.met.light } else { &gathered.met.normal };
    let [first, second, third] = loaded(like, carried, 0);
    let (position, carried) = (Vec3::new(x, y, z), Vec3::new(first, second, third));
    Some(Seen { position, carried, lanes, material })
}

#[inline(always)]
fn lit<N: Number>(scene: &Scene16<'_>, seen: &Seen<N>) -> [N; 4] {
    let like = seen.position.x;
    let color = match scene.shading.mode {
        ShadingMode::Gouraud => {
            let Vec3 { x: r, y: g, z: b } = seen.carried;
            let light = Rgb::new(r, g, b);
            match scene.fog {
                Some(fog) => fog.veiled(light, surface::depth(scene, seen.position), &mut Silent),
                None => light,
            }
        }
        _ => lit_at_pixels(scene, seen),
    };
    let lit = [color.r, color.g, color.b, like.one()];
    if seen.lanes == like.all_lanes() {
        return lit;
    }
    let mask = like.mask_of(seen.lanes);
    let mut result = lit;
    for (channel, background) in result.iter_mut().zip(scene.background) {
        *channel = channel.select(mask, like.constant(background));
    }
    result
}

#[inline(always)]
fn lit_at_pixels<N: Number>(scene: &Scene16<'_>, seen: &Seen<N>) -> Rgb<N> {
    let number = seen.material as usize;
    let point = surface::point(scene, seen.position, seen.carried);
    let reflection = &scene.scene.materials[number].constants.reflection;
    let Some(coefficients) = &scene.uniform[number] else { return Rgb::black(seen.position.x) };
    let surroundings = scene.surroundings(number);
    luxel_lighting::lit_by(&point, coefficients, reflection, &surroundings, &mut Silent)
}
