//! Polygons that are lit as wholes, one a lane.

use super::whole_place::WholePlaces;
use crate::context::{AttributeMask, ShadingContext};
use crate::material::lights_at;
use luxel_math::{LANES, Lanes, SplitLanes, Vec3, lanes_of};
use luxel_scene::Mesh;
use luxel_visibility::TriangleId;

/// Polygons that are lit together: their places, their materials, and their light.
pub(super) struct WholeLanes<'a> {
    scene: &'a ShadingContext<'a>,
    /// Where they are lit: positions and normals.
    places: [[[f32; LANES]; 3]; 2],
    pub(super) materials: [u32; LANES],
    /// Those that are lit now: of one material.
    pub(super) lanes: u32,
    pub(super) light: [[f32; LANES]; 3],
}

impl<'a> WholeLanes<'a> {
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
            let own = match &places {
                Some(own) if own.instance == cluster.instance() => own,
                _ => &*places.insert(WholePlaces::of(self.scene, cluster.instance())),
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
        }
        put
    }

    /// A lane's position and normal.
    pub(super) fn place(&self, lane: usize) -> [[f32; 3]; 2] {
        self.places.map(|columns| columns.map(|column| column[lane & (LANES - 1)]))
    }

    /// Those of the lanes that have the material of the first.
    pub(super) fn take(&mut self, lanes: u32) {
        let material = self.material_of_first(lanes);
        let of_material = lanes_of(lanes).filter(|lane| self.materials[*lane] == material);
        self.lanes = of_material.fold(0, |lanes, lane| lanes | 1 << lane);
    }

    /// The number of the material of the lowest of these lanes.
    fn material_of_first(&self, lanes: u32) -> u32 {
        self.materials[lanes.trailing_zeros() as usize & (LANES - 1)]
    }
}

impl SplitLanes for WholeLanes<'_> {
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

/// A part's material, by number; whether it is without textures and vertex colours.
fn material_of(scene: &ShadingContext<'_>, mesh: &Mesh, part: usize) -> (u32, bool) {
    let number = mesh.parts[part].material.0;
    let is_colored = AttributeMask::of_mesh(mesh).has(AttributeMask::COLORS)
        && scene.scene.materials[number as usize].vertex_colors;
    (number, scene.uniform[number as usize].is_some() && !is_colored)
}
