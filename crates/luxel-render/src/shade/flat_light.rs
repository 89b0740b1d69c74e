//! Flat shading: the one light of a polygon. Triangles of materials without textures and vertex colours are lit one a
//! lane.

use super::lit_triangle::{LitTriangle, entry_of};
use super::whole_place::WholePlaces;
use crate::context::{AttributeMask, ShadingContext};
use crate::material::{light_at, lights_at};
use luxel_lighting::Silent;
use luxel_math::{LANES, Lanes, Rgb, SplitLanes, Vec3, lanes_of};
use luxel_scene::Mesh;
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
            let mut wholes = Wholes::new(scene);
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
    fn keep(&mut self, ids: &[u32; LANES], wholes: &Wholes<'_>) {
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

/// A part's material, by number; whether it is without textures and vertex colours.
fn material_of(scene: &ShadingContext<'_>, mesh: &Mesh, part: usize) -> (u32, bool) {
    let number = mesh.parts[part].material.0;
    let is_colored = AttributeMask::of_mesh(mesh).has(AttributeMask::COLORS)
        && scene.scene.materials[number as usize].vertex_colors;
    (number, scene.uniform[number as usize].is_some() && !is_colored)
}

/// The light that leaves a triangle's polygon, clamped if the view says so.
#[cold]
#[inline(never)]
fn alone(scene: &ShadingContext<'_>, id: TriangleId, of: TriangleOf) -> FlatLight {
    let seen = LitTriangle::new(scene, id, of);
    let light = light_at(scene, &seen.whole(scene), seen.has, seen.material, &mut Silent);
    FlatLight { id, light, material: seen.material }
}

/// Polygons that are lit together, one a lane.
pub(super) struct Wholes<'a> {
    scene: &'a ShadingContext<'a>,
    /// Where they are lit: positions and normals.
    places: [[[f32; LANES]; 3]; 2],
    pub(super) materials: [u32; LANES],
    /// Those that are lit now: of one material.
    lanes: u32,
    light: [[f32; LANES]; 3],
}

impl<'a> Wholes<'a> {
    pub(super) fn new(scene: &'a ShadingContext<'a>) -> Self {
        let (places, light) = ([[[0.0; LANES]; 3]; 2], [[0.0; LANES]; 3]);
        Self { scene, places, materials: [0; LANES], lanes: 0, light }
    }

    /// Puts the places of lanes' polygons; returns the lanes whose materials have neither textures nor vertex colours.
    pub(super) fn put(&mut self, ids: &[u32; LANES], lanes: u32) -> u32 {
        let mut put = 0;
        let mut places: Option<WholePlaces<'a>> = None;
        for lane in lanes_of(lanes) {
            let id = TriangleId(ids[lane]);
            let cluster = self.scene.frame.cluster(id);
            let own = match places.take() {
                Some(own) if own.instance == cluster.instance() => own,
                _ => WholePlaces::of(self.scene, cluster.instance()),
            };
            let (material, is_uniform) = material_of(self.scene, own.mesh, cluster.part());
            if is_uniform {
                let place = own.place_seen(&cluster, id);
                for (columns, vector) in self.places.iter_mut().zip(place) {
                    for (column, value) in columns.iter_mut().zip(vector) {
                        column[lane] = value;
                    }
                }
                self.materials[lane] = material;
                put |= 1 << lane;
            }
            places = Some(own);
        }
        put
    }

    /// A lane's position and normal.
    pub(super) fn place(&self, lane: usize) -> [[f32; 3]; 2] {
        self.places.map(|columns| columns.map(|column| column[lane & (LANES - 1)]))
    }

    /// Those of the lanes that have the material of the first.
    fn take(&mut self, lanes: u32) {
        let material = self.material_of_first(lanes);
        let of_material = lanes_of(lanes).filter(|lane| self.materials[*lane] == material);
        self.lanes = of_material.fold(0, |lanes, lane| lanes | 1 << lane);
    }

    /// The number of the material of the lowest of these lanes.
    fn material_of_first(&self, lanes: u32) -> u32 {
        self.materials[lanes.trailing_zeros() as usize & (LANES - 1)]
    }
}

impl SplitLanes for Wholes<'_> {
    #[inline(always)]
    fn part<N: Lanes>(&mut self, simd: N, first: usize) {
        if self.lanes >> first & simd.all_lanes() == 0 {
            return;
        }
        let [position, normal] = &self.places;
        let position = vector(simd, position, first);
        let normal = vector(simd, normal, first);
        let material = self.material_of_first(self.lanes) as usize;
        let light = lights_at(self.scene, &position, &normal, material);
        light.r.store(&mut self.light[0], first);
        light.g.store(&mut self.light[1], first);
        light.b.store(&mut self.light[2], first);
    }
}

#[inline(always)]
pub(super) fn vector<N: Lanes>(simd: N, [x, y, z]: &[[f32; LANES]; 3], first: usize) -> Vec3<N> {
    Vec3::new(simd.load(x, first), simd.load(y, first), simd.load(z, first))
}
