//! Flat shading: the one light of a polygon. Triangles of materials without textures and vertex colours are lit one a
//! lane.

use super::lit_triangle::{LitTriangle, entry_of};
use super::whole_lanes::WholeLanes;
use crate::context::ShadingContext;
use crate::material::light_at;
use luxel_lighting::Silent;
use luxel_math::{LANES, Lanes, Rgb, lanes_of};
use luxel_visibility::{TriangleId, TriangleOf};

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

    /// The light of each lane's triangle, black for [`TriangleId::NONE`], with the numbers of materials.
    ///
    /// Outlined: one copy per lane type.
    #[inline(never)]
    pub(crate) fn of_lanes<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        (ids, seen): (&[u32; LANES], u32),
        materials: &mut [u32; LANES],
    ) -> Rgb<N> {
        let missing = self.missing(ids, seen);
        if missing != 0 {
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
        let mut lights = [[0.0; LANES]; 3];
        self.get_all(scene, (ids, seen), &mut lights, materials);
        let [r, g, b] = &lights;
        Rgb::new(simd.load(r, 0), simd.load(g, 0), simd.load(b, 0))
    }

    /// The lanes whose triangles aren't there, of each run of lanes that see one triangle the first.
    fn missing(&mut self, ids: &[u32; LANES], lanes: u32) -> u32 {
        if self.entries.is_empty() {
            self.entries.resize(ENTRIES, FlatLight::NONE);
        }
        let mut before = TriangleId::NONE;
        lanes_of(lanes).fold(0, |missing, lane| {
            let id = TriangleId(ids[lane & (LANES - 1)]);
            let is_missing = id != before && self.entries[entry_of(id, ENTRIES)].id != id;
            before = id;
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
