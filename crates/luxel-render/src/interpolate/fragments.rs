//! Barycentrics and attributes of sixteen samples.
//!
//! Lanes meet triangles in two ways: one triangle in all lanes, its numbers broadcast from the record;
//! or one a lane, the records' rows transposed in registers. Which one, the block decides by how many
//! triangles it sees; what is computed is one function over either [`Source`], so that the way changes
//! no bit.
//!
//! Why two and not one: a block of one triangle needs 22 broadcasts, which the processor reads for
//! nothing beside the arithmetic; transposing sixteen records takes some 200 shuffles. A broadcast way
//! through n triangles costs n times the arithmetic instead, so from [`FEW`] on rows are cheaper.

use crate::context::{AttributeMask, ShadingContext, needs};
use crate::interpolate::Batch;
use crate::material::{Attributes, Footprint};
use crate::setup::{
    COLOR, LIGHT, LIGHT_ROW, NORMAL, POSITION, POSITION_ROW, Prepared, SetupCache, SetupColumns,
    TANGENT, TriangleSetup, UVS, VectorAt, VertexExtras,
};
use luxel_math::{LANES, Lanes, Mask, Rgb, Vec3, lanes_of};
use luxel_visibility::{TileForms, TriangleId, interpolate, interpolate_step};

/// Up to so many triangles a block are met one by one, each in all lanes; with more, one a lane.
///
/// With 1, 2, 3, 5 and 8, a frame of 1 020 triangles in 1920x1080 takes 64.9, 63.2, 62.4, 61.9 and 61.9
/// million instructions, CesiumMilkTruck with four samples in 640x480 102.9, 100.5, 99.2, 98.1 and 97.6,
/// and 100 000 triangles in 640x480 38.3, 38.3, 38.3, 38.2 and 39.3 (AVX2, one thread,
/// `benches/rivals/instructions`).
const FEW: u32 = 5;

/// With more triangles to sixteen samples than this, few of them are seen by the next block, too: they are
/// prepared a lane each and not kept.
///
/// With 5, 7, 9, 12 and 16, a frame of 100 000 triangles in 640x480 takes 41.6, 39.3, 38.3, 37.9 and 37.9
/// million instructions, and one of a million 75.4, 75.4, 75.4, 76.0 and 90.7 (as above).
pub(crate) const SHARED: u32 = 9;

/// Which attributes a pass needs beside those that materials read.
#[derive(Clone, Copy)]
pub(crate) struct Wanted {
    pub(crate) position: bool,
    pub(crate) normal: bool,
    pub(crate) light: bool,
}

/// What sixteen samples see.
#[derive(Clone, Copy)]
pub(crate) struct Fragments<N> {
    /// Barycentrics.
    pub(crate) weights: [N; 3],
    /// What the surface is there.
    pub(crate) attributes: Attributes<N>,
}

/// Where the numbers of triangles come from.
trait Source<N> {
    /// A number of [`TriangleSetup`].
    fn number(&self, index: usize) -> N;
    /// A number of [`VertexExtras`].
    fn extra(&self, index: usize) -> N;
}

/// One triangle in all lanes.
struct Broadcast<'t, N> {
    simd: N,
    setup: &'t TriangleSetup,
    extras: &'t VertexExtras,
}

impl<N: Lanes> Source<N> for Broadcast<'_, N> {
    #[inline(always)]
    fn number(&self, index: usize) -> N {
        self.simd.constant(self.setup.rows[index / 8][index % 8])
    }

    #[inline(always)]
    fn extra(&self, index: usize) -> N {
        self.simd.constant(self.extras.rows[index / 8][index % 8])
    }
}

/// One triangle a lane, prepared side by side.
struct Columns<'t, N> {
    simd: N,
    numbers: &'t SetupColumns,
}

impl<N: Lanes> Source<N> for Columns<'_, N> {
    #[inline(always)]
    fn number(&self, index: usize) -> N {
        self.simd.load(&self.numbers[index], 0)
    }

    #[inline(always)]
    fn extra(&self, _: usize) -> N {
        self.simd.zero()
    }
}

/// One triangle a lane, from records.
struct Transposed<N> {
    numbers: [[N; 8]; 5],
    extras: [[N; 8]; 5],
}

impl<N: Lanes> Transposed<N> {
    /// The rows that lanes need. Written out row by row: an array that a loop fills would be memory.
    #[inline(always)]
    fn new<const NEEDS: u8>(
        simd: N,
        cache: &SetupCache,
        ids: &[u32; LANES],
        setups: &[&TriangleSetup; LANES],
        of: Of,
    ) -> Self {
        let zeros = [simd.zero(); 8];
        let numbers = [
            setup_row(simd, setups, 0),
            setup_row(simd, setups, 1),
            setup_row(simd, setups, 2),
            if of.wanted.position { setup_row(simd, setups, POSITION_ROW) } else { zeros },
            if of.wanted.light { setup_row(simd, setups, LIGHT_ROW) } else { zeros },
        ];
        if NEEDS != needs::ALL || !of.has.any() {
            return Self { numbers, extras: [zeros; 5] };
        }
        let first = ids[of.lanes.trailing_zeros() as usize & (LANES - 1)];
        let mut rows = [cache.get(first).extras; LANES];
        for lane in lanes_of(of.lanes) {
            rows[lane] = cache.get(ids[lane]).extras;
        }
        let extras = [
            extra_row(simd, &rows, 0),
            extra_row(simd, &rows, 1),
            extra_row(simd, &rows, 2),
            extra_row(simd, &rows, 3),
            extra_row(simd, &rows, 4),
        ];
        Self { numbers, extras }
    }
}

#[inline(always)]
fn setup_row<N: Lanes>(simd: N, setups: &[&TriangleSetup; LANES], row: usize) -> [N; 8] {
    simd.load_transposed(
        #[inline(always)]
        |lane| &setups[lane & (LANES - 1)].rows[row],
    )
}

#[inline(always)]
fn extra_row<N: Lanes>(simd: N, extras: &[&VertexExtras; LANES], row: usize) -> [N; 8] {
    simd.load_transposed(
        #[inline(always)]
        |lane| &extras[lane & (LANES - 1)].rows[row],
    )
}

impl<N: Lanes> Source<N> for Transposed<N> {
    #[inline(always)]
    fn number(&self, index: usize) -> N {
        self.numbers[index / 8][index % 8]
    }

    #[inline(always)]
    fn extra(&self, index: usize) -> N {
        self.extras[index / 8][index % 8]
    }
}

/// Lanes and what they take of their triangles.
#[derive(Clone, Copy)]
struct Of {
    lanes: u32,
    wanted: Wanted,
    /// The attributes beside positions and normals.
    has: AttributeMask,
}

impl<N: Lanes> Fragments<N> {
    #[inline(always)]
    pub(crate) fn nothing(simd: N) -> Self {
        Self { weights: [simd.zero(); 3], attributes: Attributes::nothing(simd) }
    }

    /// Interpolates what the samples of `seen` lanes see, whose triangles `cache` may lack yet. Other lanes
    /// hold anything. `materials` gets each sample's material, by number: apart from the fragments, as
    /// an index that is known only at run time would keep all of them in memory. The first sample's is
    /// returned, and of one triangle is all that [`needs::NORMALS`] writes. `NEEDS` says which attributes
    /// count.
    #[inline(always)]
    pub(crate) fn interpolate<const NEEDS: u8>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        batch: &Batch,
        cache: &mut SetupCache,
        (seen, wanted): (u32, Wanted),
        materials: &mut [u32; LANES],
    ) -> u32 {
        let ids = &batch.ids;
        let first = seen.trailing_zeros() as usize & (LANES - 1);
        let id = ids[first];
        if batch.is_single || simd.eq_mask(ids, id) & seen == seen {
            // One triangle, the most frequent case, apart from the loop: what a loop carries from triangle to
            // triangle is memory.
            cache.require_one(simd, scene, id);
            let Prepared { setup, extras, material, reads } = cache.get(id);
            let source = Broadcast { simd, setup, extras };
            let of = Of { lanes: seen, wanted, has: reads };
            self.take::<NEEDS, true>(simd, &source, scene, batch, of);
            if NEEDS != needs::NORMALS {
                *materials = [material; LANES];
            }
            return material;
        }
        let begins = simd.run_starts(ids) & seen;
        let mut left = seen;
        if NEEDS != needs::ALL && begins.count_ones() > SHARED && !cache.has_all(ids, begins) {
            while left != 0
                && let Some((lanes, columns)) =
                    cache.prepare_columns(simd, scene, ids, left, materials)
            {
                let source = Columns { simd, numbers: columns };
                let of = Of { lanes, wanted, has: AttributeMask::NONE };
                self.take::<NEEDS, false>(simd, &source, scene, batch, of);
                left &= !lanes;
            }
        }
        while left != 0 {
            cache.require(simd, scene, ids, begins & left);
            if (begins & left).count_ones() <= FEW {
                let id = ids[left.trailing_zeros() as usize & (LANES - 1)];
                let lanes = simd.eq_mask(ids, id) & left;
                cache.require_one(simd, scene, id);
                let Prepared { setup, extras, material, reads } = cache.get(id);
                let source = Broadcast { simd, setup, extras };
                let of = Of { lanes, wanted, has: reads };
                self.take::<NEEDS, false>(simd, &source, scene, batch, of);
                put_material(materials, lanes, material);
                left &= !lanes;
            } else {
                let mut of = Of { lanes: 0, wanted, has: AttributeMask::NONE };
                // Other lanes hold one of the triangles, too.
                let id = ids[left.trailing_zeros() as usize & (LANES - 1)];
                let mut setups = [cache.get(id).setup; LANES];
                for lane in lanes_of(left) {
                    let lane = lane & (LANES - 1);
                    if let Some(prepared) = cache.find(ids[lane]) {
                        of.lanes |= 1 << lane;
                        of.has = of.has.or(prepared.reads);
                        materials[lane] = prepared.material;
                        setups[lane] = prepared.setup;
                    }
                }
                let source = Transposed::new::<NEEDS>(simd, cache, ids, &setups, of);
                self.take::<NEEDS, false>(simd, &source, scene, batch, of);
                left &= !of.lanes;
            }
        }
        materials[first]
    }

    /// Takes what lanes see of the triangles of a source.
    ///
    /// Written field by field into what is there: handed over by value, all 40 vectors would be copied
    /// through memory, two thousand bytes a block.
    #[inline(always)]
    fn take<const NEEDS: u8, const WHOLE: bool>(
        &mut self,
        simd: N,
        source: &impl Source<N>,
        scene: &ShadingContext<'_>,
        batch: &Batch,
        of: Of,
    ) {
        let (x, y) = (simd.load(&batch.x, 0), simd.load(&batch.y, 0));
        let Of { lanes, wanted, has } = of;
        let forms = TileForms::from_numbers(
            #[inline(always)]
            |index| source.number(index),
        );
        let at_sample = forms.at(x, y);
        let mut weights = at_sample.weights;
        // Bits cost more than the question whether there are any, and there seldom are.
        let any_inexact = at_sample.inexact.any();
        let inexact = if any_inexact { at_sample.inexact.bits() & lanes } else { 0 };
        if inexact != 0 {
            weights = exact_weights(scene, batch, inexact, weights);
        }
        let mask = x.mask_of(lanes);
        merge::<3, WHOLE, N>(&mut self.weights, weights, mask);
        let own = &mut self.attributes;
        if wanted.normal {
            let normal = vector(source, NORMAL, &weights);
            if WHOLE {
                own.normal = normal;
            } else {
                normal.put(mask, &mut own.normal);
            }
        }
        if wanted.position {
            let position = vector(source, POSITION, &weights);
            if WHOLE {
                own.position = position;
            } else {
                position.put(mask, &mut own.position);
            }
        }
        if wanted.light {
            let Vec3 { x: r, y: g, z: b } = vector(source, LIGHT, &weights);
            let light = Rgb::new(r, g, b);
            if WHOLE {
                own.light = light;
            } else {
                light.put(mask, &mut own.light);
            }
        }
        if NEEDS != needs::ALL {
            return;
        }
        own.has = own.has.or(has);
        if has.has(AttributeMask::UVS[0].or(AttributeMask::UVS[1])) {
            let [mut right, mut down] = forms.steps(x, y);
            if inexact != 0 {
                [right, down] = exact_steps(scene, batch, inexact, [right, down]);
            }
            for set in 0..2 {
                let [here, to_right, to_below]: &mut Footprint<N> = &mut own.uv[set];
                let [u, v] = [UVS[set], UVS[set] + 3];
                let place = [extra(source, u, &weights), extra(source, v, &weights)];
                merge::<2, WHOLE, N>(here, place, mask);
                let step = [extra_step(source, u, &right), extra_step(source, v, &right)];
                merge::<2, WHOLE, N>(to_right, step, mask);
                let step = [extra_step(source, u, &down), extra_step(source, v, &down)];
                merge::<2, WHOLE, N>(to_below, step, mask);
            }
        }
        if has.has(AttributeMask::TANGENTS) {
            for component in 0..4 {
                let value = extra(source, TANGENT + 3 * component, &weights);
                merge_one::<WHOLE, N>(&mut own.tangent[component], value, mask);
            }
        }
        if has.has(AttributeMask::COLORS) {
            for component in 0..4 {
                let value = extra(source, COLOR + 3 * component, &weights);
                merge_one::<WHOLE, N>(&mut own.color[component], value, mask);
            }
        }
    }
}

/// Writes the material of lanes.
#[inline(always)]
pub(crate) fn put_material(materials: &mut [u32; LANES], lanes: u32, material: u32) {
    for (lane, own) in materials.iter_mut().enumerate() {
        if lanes >> lane & 1 == 1 {
            *own = material;
        }
    }
}

/// A vector between the corners.
#[inline(always)]
fn vector<N: Lanes>(source: &impl Source<N>, at: VectorAt, weights: &[N; 3]) -> Vec3<N> {
    let [x0, y0, z0, x1, y1, z1, x2, y2, z2] = at;
    Vec3::new(
        component(source, [x0, x1, x2], weights),
        component(source, [y0, y1, y2], weights),
        component(source, [z0, z1, z2], weights),
    )
}

#[inline(always)]
fn component<N: Lanes>(
    source: &impl Source<N>,
    [first, second, third]: [usize; 3],
    weights: &[N; 3],
) -> N {
    let differences = [source.number(second), source.number(third)];
    interpolate(source.number(first), differences, weights)
}

/// A component of another attribute, between the corners.
#[inline(always)]
fn extra<N: Lanes>(source: &impl Source<N>, first: usize, weights: &[N; 3]) -> N {
    let differences = [source.extra(first + 1), source.extra(first + 2)];
    interpolate(source.extra(first), differences, weights)
}

/// How a component of another attribute changes over a step.
#[inline(always)]
fn extra_step<N: Lanes>(source: &impl Source<N>, first: usize, step: &[N; 2]) -> N {
    interpolate_step([source.extra(first + 1), source.extra(first + 2)], step)
}

/// The barycentrics of lanes whose triangles f32 can't tell.
#[cold]
#[inline(never)]
fn exact_weights<N: Lanes>(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    lanes: u32,
    mut weights: [N; 3],
) -> [N; 3] {
    for lane in lanes_of(lanes) {
        let Some(of) = scene.frame.triangle(TriangleId(batch.ids[lane])) else { continue };
        let exact = scene.frame.forms(of).exact_barycentric(scene.frame.rays(), batch.steps(lane));
        put_lane(&mut weights, lane, exact);
    }
    weights
}

/// How they change over a pixel to the right, and down.
#[cold]
#[inline(never)]
fn exact_steps<N: Lanes>(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    lanes: u32,
    [mut right, mut down]: [[N; 2]; 2],
) -> [[N; 2]; 2] {
    for lane in lanes_of(lanes) {
        let Some(of) = scene.frame.triangle(TriangleId(batch.ids[lane])) else { continue };
        let [own_right, own_down] = scene.frame.forms(of).exact_steps(batch.steps(lane));
        put_lane(&mut right, lane, own_right);
        put_lane(&mut down, lane, own_down);
    }
    [right, down]
}

fn put_lane<N: Lanes, const C: usize>(values: &mut [N; C], lane: usize, new: [f32; C]) {
    for (value, new) in values.iter_mut().zip(new) {
        *value = value.with_lane(lane, new);
    }
}

/// Takes new values: in all lanes, or where the mask is true.
#[inline(always)]
fn merge<const C: usize, const WHOLE: bool, N: Lanes>(
    values: &mut [N; C],
    new: [N; C],
    mask: N::Mask,
) {
    for component in 0..C {
        merge_one::<WHOLE, N>(&mut values[component], new[component], mask);
    }
}

#[inline(always)]
fn merge_one<const WHOLE: bool, N: Lanes>(value: &mut N, new: N, mask: N::Mask) {
    if WHOLE {
        *value = new;
    } else {
        new.put(mask, value);
    }
}
