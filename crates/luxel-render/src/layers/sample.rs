//! The numbers of what samples see.

use crate::context::ShadingContext;
use luxel_math::{LANES, Lanes, lanes_of};
use luxel_visibility::TriangleId;

/// The numbers of what each lane sees.
pub(crate) struct Triangles {
    pub(crate) seen: u32,
    pub(crate) objects: [u32; LANES],
    pub(crate) triangles: [u32; LANES],
}

/// Direct-mapped cache of object and triangle numbers by id: neighbouring blocks see the same triangles.
pub(crate) struct RecentTriangles {
    /// Id, object and triangle, indexed by the id's low bits.
    entries: Box<[[u32; 3]; Self::COUNT]>,
}

impl RecentTriangles {
    const COUNT: usize = 128;

    pub(crate) fn new() -> Self {
        Self { entries: Box::new([[TriangleId::NONE.0; 3]; Self::COUNT]) }
    }

    /// The object and triangle numbers of an id; `None` if the frame has no such triangle.
    #[inline(always)]
    fn numbers(&mut self, scene: &ShadingContext<'_>, id: u32) -> Option<[u32; 2]> {
        let entry = &mut self.entries[id as usize % Self::COUNT];
        if entry[0] != id {
            let of = scene.frame.triangle(TriangleId(id))?;
            let (object, triangle) = scene.placed.object_of(of.instance, of.triangle);
            *entry = [id, object as u32, triangle.unwrap_or(u32::MAX)];
        }
        let [_, object, triangle] = *entry;
        Some([object, triangle])
    }
}

impl Triangles {
    #[inline(always)]
    pub(crate) fn of<N: Lanes>(
        simd: N,
        scene: &ShadingContext<'_>,
        ids: &[u32; LANES],
        recent: &mut RecentTriangles,
    ) -> Self {
        let none = [u32::MAX; LANES];
        let mut found = Self { seen: 0, objects: none, triangles: none };
        let mut left = !simd.eq_mask(ids, TriangleId::NONE.0) & simd.all_lanes();
        while left != 0 {
            let id = ids[left.trailing_zeros() as usize & (LANES - 1)];
            let lanes = simd.eq_mask(ids, id) & left;
            left &= !lanes;
            let Some([object, triangle]) = recent.numbers(scene, id) else { continue };
            found.seen |= lanes;
            for lane in lanes_of(lanes) {
                found.objects[lane & (LANES - 1)] = object;
                found.triangles[lane & (LANES - 1)] = triangle;
            }
        }
        found
    }
}
