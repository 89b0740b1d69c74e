//! Flat shading: the one light of a polygon. Triangles of materials without textures and vertex colours are lit one a
//! lane.

use super::colors::{by_material, finished};
use super::lit_triangle::{LitTriangle, entry_of};
use super::points::point_heard;
use super::whole_lanes::WholeLanes;
use super::witness::BlockWitness;
use crate::context::{ShadingContext, needs};
use crate::interpolate::{Batch, Fragments, put_material};
use crate::material::{light_at, lit_elsewhere};
use luxel_lighting::Silent;
use luxel_math::{LANES, Lanes, Rgb, lanes_of};
use luxel_visibility::{TriangleId, TriangleOf};

/// Shades batches of flat shading that need no more than the light of their polygons.
///
/// Outlined: one copy per lane type.
#[inline(never)]
pub(super) fn shade_flat<N: Lanes, W: BlockWitness<N>>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    lights: &mut FlatLights,
    witness: &mut W,
    seen: u32,
) -> [N; 4] {
    simd.vectorized(
        #[inline(always)]
        || {
            let simd = simd.zero();
            let mut materials = [0; LANES];
            let mut found = Fragments::nothing(simd);
            let of = (&batch.ids, seen);
            found.attributes.light = lights.of_lanes(simd, scene, of, &mut materials);
            let point = point_heard::<N, W>(simd, scene, batch, &found);
            witness.fragments(scene, &found, &materials, &point, seen);
            let result = by_material(
                simd,
                scene,
                (&materials, seen),
                #[inline(always)]
                |(number, lanes)| {
                    witness.lanes(lanes);
                    let (attributes, number) = (&found.attributes, number as usize);
                    lit_elsewhere::<N, W, { needs::PLACES }>(
                        scene, attributes, &point, number, lanes, witness,
                    )
                },
            );
            finished(simd, scene, batch, seen, result)
        },
    )
}

/// The lights of the triangles that a thread has seen last, by their ids.
pub(crate) struct FlatLights {
    /// Empty before the first is seen.
    entries: Vec<FlatLight>,
}

/// The light of one triangle.
#[derive(Clone, Copy)]
struct FlatLight {
    id: TriangleId,
    light: [f32; 3],
    /// The number of its material.
    material: u32,
}

impl FlatLight {
    /// Of nothing: black.
    const NONE: Self = Self { id: TriangleId::NONE, light: [0.0; 3], material: 0 };
}

/// The most runs of lanes that see one triangle whose lights are spread triangle by triangle; those of more are spread
/// lane by lane.
///
/// With 1, 3 and 5, a frame of 1 020 triangles in 1920x1080 takes 43.5, 42.2 and 42.0 million instructions, 100 000 in
/// 640x480 53.9, 53.9 and 53.8, CesiumMilkTruck with four samples in 640x480 81.2, 80.5 and 80.3 (AVX2, one thread,
/// `benches/rivals/instructions`).
const FEW: u32 = 5;

/// Entries of the cache: 20 KiB, most of a core's first-level cache.
const ENTRIES: usize = 1024;

impl FlatLights {
    pub(crate) fn new() -> Self {
        Self { entries: Vec::new() }
    }

    /// Forgets the triangles of another frame.
    pub(crate) fn begin_frame(&mut self) {
        self.entries.clear();
    }

    /// The light of the triangles that lanes see, with the numbers of their materials. Other lanes than those of `seen`
    /// hold anything.
    #[inline(always)]
    pub(super) fn of_lanes<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        (ids, seen): (&[u32; LANES], u32),
        materials: &mut [u32; LANES],
    ) -> Rgb<N> {
        let begins = simd.run_starts(ids) & seen;
        let missing = self.missing(ids, begins);
        if missing != 0 {
            self.light_missing(simd.zero(), scene, ids, missing);
        }
        if begins.count_ones() > FEW {
            let mut lights = [[0.0; LANES]; 3];
            self.get_all(scene, (ids, seen), &mut lights, materials);
            let [r, g, b] = &lights;
            return Rgb::new(simd.load(r, 0), simd.load(g, 0), simd.load(b, 0));
        }
        let mut lights = Rgb::black(simd);
        let mut left = seen;
        while left != 0 {
            let id = ids[left.trailing_zeros() as usize & (LANES - 1)];
            let lanes = left & simd.eq_mask(ids, id);
            let FlatLight { light, material, .. } = self.get(scene, TriangleId(id));
            let light = Rgb::splat(simd, light);
            if lanes == simd.all_lanes() {
                *materials = [material; LANES];
                return light;
            }
            light.put(simd.mask_of(lanes), &mut lights);
            put_material(materials, lanes, material);
            left &= !lanes;
        }
        lights
    }

    /// Lights the triangles of lanes, those of materials with textures or vertex colours aside.
    ///
    /// Outlined: one copy per lane type.
    #[inline(never)]
    fn light_missing<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        ids: &[u32; LANES],
        missing: u32,
    ) {
        let mut wholes = WholeLanes::new(scene);
        let mut left = wholes.put(ids, missing);
        while left != 0 {
            wholes.take(left);
            simd.vectorized(
                #[inline(always)]
                || simd.in_parts(&mut wholes),
            );
            left &= !wholes.lanes;
            self.keep(ids, &wholes);
        }
    }

    /// Those of the lanes whose triangles aren't there.
    #[inline]
    fn missing(&mut self, ids: &[u32; LANES], lanes: u32) -> u32 {
        if self.entries.is_empty() {
            self.entries.resize(ENTRIES, FlatLight::NONE);
        }
        lanes_of(lanes).fold(0, |missing, lane| {
            let id = TriangleId(ids[lane & (LANES - 1)]);
            let is_missing = self.entries[entry_of(id, ENTRIES)].id != id;
            missing | u32::from(is_missing) << lane
        })
    }

    /// Keeps lights. Two triangles seldom want the same entry: one of them is missing then.
    fn keep(&mut self, ids: &[u32; LANES], wholes: &WholeLanes<'_>) {
        for lane in lanes_of(wholes.lanes) {
            let lane = lane & (LANES - 1);
            let id = TriangleId(ids[lane]);
            let light = wholes.light.map(|channel| channel[lane]);
            let material = wholes.materials[lane];
            self.entries[entry_of(id, ENTRIES)] = FlatLight { id, light, material };
        }
    }

    /// The lights of lanes, channel by channel, and the numbers of materials.
    #[inline(never)]
    fn get_all(
        &mut self,
        scene: &ShadingContext<'_>,
        (ids, lanes): (&[u32; LANES], u32),
        lights: &mut [[f32; LANES]; 3],
        materials: &mut [u32; LANES],
    ) {
        for lane in lanes_of(lanes) {
            let lane = lane & (LANES - 1);
            let FlatLight { light, material, .. } = self.get(scene, TriangleId(ids[lane]));
            materials[lane] = material;
            for (channel, value) in lights.iter_mut().zip(light) {
                channel[lane] = value;
            }
        }
    }

    /// The light of an id's triangle.
    #[inline]
    fn get(&mut self, scene: &ShadingContext<'_>, id: TriangleId) -> FlatLight {
        let entry = &mut self.entries[entry_of(id, ENTRIES)];
        if entry.id != id {
            let Some(of) = scene.frame.triangle(id) else { return FlatLight::NONE };
            *entry = alone(scene, id, of);
        }
        *entry
    }
}

/// The light that leaves a triangle's polygon, clamped if the view says so.
#[cold]
#[inline(never)]
fn alone(scene: &ShadingContext<'_>, id: TriangleId, of: TriangleOf) -> FlatLight {
    let seen = LitTriangle::new(scene, id, of);
    let light = light_at(scene, &seen.whole(scene), seen.has, seen.material, &mut Silent);
    FlatLight { id, light, material: seen.material }
}
