//! Where triangles are lit elsewhere than at pixels, one triangle a lane: their corners, or whole polygons.

use crate::context::{AttributeMask, ShadingContext};
use crate::material::{Attributes, Corner};
use crate::setup::{CornerReader, ReadCorners};
use crate::shade::lit_triangle::LitTriangle;
use crate::shade::whole_lanes::{WholeLanes, vector};
use luxel_math::{LANES, Lanes, SplitLanes, lanes_of};
use luxel_visibility::TriangleId;

/// Three numbers of each lane, number by number.
type Columns = [[f32; LANES]; 3];

/// The places of up to sixteen triangles, three of each or one.
pub(super) struct Places {
    reader: CornerReader,
    materials: [u32; LANES],
    columns: [PlaceColumns; 3],
    /// Which attributes any of the triangles has, beside positions and normals.
    has: AttributeMask,
}

/// What light depends on at one place of each lane's triangle.
#[derive(Clone, Copy)]
struct PlaceColumns {
    position: Columns,
    normal: Columns,
    uv: [[[f32; LANES]; 2]; 2],
    color: [[f32; LANES]; 4],
}

impl Places {
    pub(super) fn new() -> Self {
        Self {
            reader: CornerReader::new(),
            materials: [0; LANES],
            columns: [PlaceColumns::NOTHING; 3],
            has: AttributeMask::NONE,
        }
    }

    /// The number of the material of the lowest of these lanes, and all of them that have it.
    #[inline(always)]
    pub(super) fn material_of_first<N: Lanes>(&self, simd: N, lanes: u32) -> (usize, u32) {
        let number = self.materials[lanes.trailing_zeros() as usize & (LANES - 1)];
        (number as usize, simd.eq_mask(&self.materials, number) & lanes)
    }

    /// What light depends on, from lane `first` on.
    #[inline(always)]
    pub(super) fn attributes<N: Lanes>(
        &self,
        simd: N,
        place: usize,
        first: usize,
    ) -> Attributes<N> {
        let columns = &self.columns[place];
        let mut attributes = Attributes {
            position: vector(simd, &columns.position, first),
            normal: vector(simd, &columns.normal, first),
            has: self.has,
            ..Attributes::nothing(simd)
        };
        if self.has.any() {
            for (footprint, [u, v]) in attributes.uv.iter_mut().zip(&columns.uv) {
                footprint[0] = [simd.load(u, first), simd.load(v, first)];
            }
            for (channel, column) in attributes.color.iter_mut().zip(&columns.color) {
                *channel = simd.load(column, first);
            }
        }
        attributes
    }

    /// Puts the corners of lanes' triangles, or their whole polygons.
    #[inline(always)]
    pub(super) fn put<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        of: (&[u32; LANES], u32),
        are_whole: bool,
    ) {
        if self.has.any() {
            self.columns.fill(PlaceColumns::NOTHING);
            self.has = AttributeMask::NONE;
        }
        if are_whole {
            self.put_wholes(scene, of);
        } else {
            self.put_corners(simd, scene, of);
        }
    }

    #[inline(always)]
    fn put_corners<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        (ids, lanes): (&[u32; LANES], u32),
    ) {
        let Self { reader, materials, columns, has } = self;
        let mut left = lanes;
        while left != 0 {
            let of = reader.read(
                simd,
                scene,
                (ids, left),
                materials,
                |lane, _, mesh, corners, reads| {
                    *has = has.or(reads);
                    for (into, attribute) in columns.iter_mut().zip(corners) {
                        let attribute = attribute as usize;
                        for set in 0..2 {
                            if reads.has(AttributeMask::UVS[set]) {
                                put_lane(&mut into.uv[set], lane, mesh.uvs[set][attribute]);
                            }
                        }
                        if reads.has(AttributeMask::COLORS) {
                            put_lane(&mut into.color, lane, mesh.colors[attribute]);
                        }
                    }
                },
            );
            left &= !of.lanes;
            simd.in_parts(&mut Corners { scene, of, into: columns });
        }
    }

    fn put_wholes(&mut self, scene: &ShadingContext<'_>, (ids, lanes): (&[u32; LANES], u32)) {
        let mut wholes = WholeLanes::new(scene);
        let of_places = wholes.put(ids, lanes);
        let into = &mut self.columns[0];
        for lane in lanes_of(lanes) {
            let lane = lane & (LANES - 1);
            self.materials[lane] = wholes.materials[lane];
            if of_places >> lane & 1 == 1 {
                let [position, normal] = wholes.place(lane);
                put_lane(&mut into.position, lane, position);
                put_lane(&mut into.normal, lane, normal);
                continue;
            }
            let id = TriangleId(ids[lane]);
            let Some(of) = scene.frame.triangle(id) else { continue };
            let triangle = LitTriangle::new(scene, id, of);
            self.materials[lane] = triangle.material;
            self.has = self.has.or(triangle.has);
            into.put(lane, &triangle.whole(scene));
        }
    }
}

impl PlaceColumns {
    /// White, and 0 for all else.
    const NOTHING: Self = Self {
        position: [[0.0; LANES]; 3],
        normal: [[0.0; LANES]; 3],
        uv: [[[0.0; LANES]; 2]; 2],
        color: [[1.0; LANES]; 4],
    };

    fn put(&mut self, lane: usize, corner: &Corner) {
        put_lane(&mut self.position, lane, corner.position);
        put_lane(&mut self.normal, lane, corner.normal);
        for (set, uv) in self.uv.iter_mut().zip(corner.uv) {
            put_lane(set, lane, uv);
        }
        put_lane(&mut self.color, lane, corner.color);
    }
}

/// Puts the numbers of one lane.
#[inline(always)]
fn put_lane<const C: usize>(columns: &mut [[f32; LANES]; C], lane: usize, values: [f32; C]) {
    for (column, value) in columns.iter_mut().zip(values) {
        column[lane & (LANES - 1)] = value;
    }
}

/// Corners of triangles of one instance, on their way to their columns.
struct Corners<'a> {
    scene: &'a ShadingContext<'a>,
    of: ReadCorners<'a>,
    into: &'a mut [PlaceColumns; 3],
}

impl SplitLanes for Corners<'_> {
    #[inline(always)]
    fn part<N: Lanes>(&mut self, simd: N, first: usize) {
        let lanes = self.of.lanes >> first & simd.all_lanes();
        if lanes == 0 {
            return;
        }
        let space = self.scene.space(self.of.instance);
        let (placed, in_mesh) = self.of.placed(simd, self.scene, first);
        let corners = placed.positions(space).into_iter().zip(placed.normals(space, in_mesh));
        let mask = simd.mask_of(lanes);
        for (into, (position, normal)) in self.into.iter_mut().zip(corners) {
            for (columns, of) in [(&mut into.position, position), (&mut into.normal, normal)] {
                for (column, values) in columns.iter_mut().zip([of.x, of.y, of.z]) {
                    let mut all = simd.load(column, first);
                    values.put(mask, &mut all);
                    all.store(column, first);
                }
            }
        }
    }
}
