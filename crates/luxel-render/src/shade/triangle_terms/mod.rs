//! Terms of light at the corners of triangles, or of whole polygons: lit one triangle a lane, and kept for the blocks
//! that see them.
//!
//! A triangle is lit once for two rows of blocks, together with fifteen others. The wanted terms of each of its places
//! lie together; a block gathers those of its lanes' triangles, and mixes them by its lanes' barycentrics.

mod columns;
mod places;
mod rows;

use super::lit_triangle::LitTriangle;
use super::place_terms::{PlaceTerms, TermMix};
use crate::context::ShadingContext;
pub(crate) use columns::WantedTerms;
use columns::{Lit, TermColumns, TermLayout};
use luxel_math::{LANES, Lanes, Rgb, lanes_of};
use luxel_view::{Clamp, Interpolation, ShadingMode};
use luxel_visibility::TriangleId;
use places::Places;
use rows::TermRows;

/// Triangles that are kept, a power of two: twice as many as two rows of blocks can see.
const KEPT: usize = 1024;
/// Entries of the table from ids to triangles: enough that two of these seldom want the same.
const TABLE: usize = 4096;

/// The terms of the triangles that a thread has seen last.
pub(crate) struct TriangleTerms {
    layout: TermLayout,
    /// By the low bits of an id: which of the others it may be.
    table: Vec<u16>,
    ids: Vec<u32>,
    /// The one that is overwritten next.
    next: usize,
    /// The terms of each.
    rows: TermRows,
    /// Triangles that are kept and to be lit.
    pending: [u32; LANES],
    count: usize,
    lit: LitTogether,
    /// What the lanes of the last block gathered, and the triangles that they see.
    gathered: [TermColumns; 3],
    gathered_ids: [u32; LANES],
}

/// Triangles that are lit together, one a lane.
struct LitTogether {
    at: Places,
    terms: [TermColumns; 3],
}

/// Where triangles are kept.
struct Kept {
    /// Those that are.
    lanes: u32,
    at: [usize; LANES],
}

/// The ids of a block that sees nothing.
const NOTHING_SEEN: [u32; LANES] = [TriangleId::NONE.0; LANES];

impl TriangleTerms {
    pub(crate) fn new() -> Self {
        Self {
            layout: TermLayout::default(),
            table: Vec::new(),
            ids: Vec::new(),
            next: 0,
            rows: TermRows::new(),
            pending: NOTHING_SEEN,
            count: 0,
            lit: LitTogether { at: Places::new(), terms: Default::default() },
            gathered: Default::default(),
            gathered_ids: NOTHING_SEEN,
        }
    }

    /// Whether a scene's samples mix terms of the corners of their triangles by barycentrics, or have those of a whole
    /// polygon, and no shadow falls on them.
    #[inline(always)]
    pub(crate) fn are_mixed(scene: &ShadingContext<'_>) -> bool {
        scene.shadows.is_none()
            && scene.shading.interpolation == Interpolation::Perspective
            && matches!(scene.shading.mode, ShadingMode::Flat | ShadingMode::Gouraud)
    }

    /// Forgets all triangles, and keeps the wanted terms of those to come.
    pub(crate) fn begin_frame(&mut self, scene: &ShadingContext<'_>, wanted: WantedTerms) {
        let is_clamped = scene.shading.clamp == Clamp::Vertex;
        self.layout = TermLayout::new(wanted, is_clamped, scene.lights.len());
        let places = if scene.shading.mode == ShadingMode::Flat { 1 } else { 3 };
        self.table.clear();
        self.table.resize(TABLE, 0);
        self.ids.clear();
        self.ids.resize(KEPT, TriangleId::NONE.0);
        self.rows.begin_frame(KEPT, places, self.layout.rows());
        self.count = 0;
        self.gathered_ids = NOTHING_SEEN;
        for columns in self.lit.terms.iter_mut().chain(&mut self.gathered) {
            columns.resize(&self.layout);
        }
    }

    /// Lights the triangles that these lanes of blocks see.
    ///
    /// Outlined: one copy per lane type.
    #[inline(never)]
    pub(crate) fn look_ahead<'i, N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        blocks: impl Iterator<Item = &'i [u32; LANES]>,
    ) {
        simd.vectorized(
            #[inline(always)]
            || {
                for ids in blocks {
                    let seen = !simd.eq_mask(ids, TriangleId::NONE.0);
                    self.require(simd, scene, ids, simd.run_starts(ids) & seen);
                }
                self.light(simd, scene);
            },
        );
    }

    /// Keeps the triangles of lanes, and lights them once they are sixteen.
    #[inline(always)]
    fn require<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        ids: &[u32; LANES],
        lanes: u32,
    ) {
        for lane in lanes_of(lanes & simd.all_lanes()) {
            let id = ids[lane & (LANES - 1)];
            if self.has(id) {
                continue;
            }
            let kept = self.next;
            self.next = (kept + 1) % KEPT;
            self.ids[kept] = id;
            self.table[id as usize % TABLE] = kept as u16;
            self.pending[self.count & (LANES - 1)] = id;
            self.count += 1;
            if self.count == LANES {
                self.light(simd, scene);
            }
        }
    }

    /// Where a triangle is kept, if it is.
    #[inline(always)]
    fn place(&self, id: u32) -> usize {
        usize::from(self.table[id as usize % TABLE]) % KEPT
    }

    #[inline(always)]
    fn has(&self, id: u32) -> bool {
        self.ids[self.place(id)] == id
    }

    /// Lights what is pending.
    ///
    /// Outlined: one copy per lane type.
    #[inline(never)]
    fn light<N: Lanes>(&mut self, simd: N, scene: &ShadingContext<'_>) {
        if self.count == 0 {
            return;
        }
        simd.vectorized(
            #[inline(always)]
            || {
                // A triangle whose entry of the table another one took is not kept.
                let Kept { lanes, at: kept } =
                    self.kept(&self.pending, u32::MAX >> (u32::BITS as usize - self.count));
                let Self { layout, rows, pending, lit, .. } = self;
                let LitTogether { at, terms } = lit;
                let terms = &mut terms[..rows.places()];
                if !N::IS_SPECIALIZED {
                    light_one_by_one(scene, (pending, lanes), layout, terms);
                    rows.put(simd, (&kept, lanes), terms);
                    return;
                }
                at.put(simd, scene, (pending, lanes), terms.len() == 1);
                let mut left = lanes;
                while left != 0 {
                    let (material, of_material) = at.material_of_first(simd, left);
                    left &= !of_material;
                    let of = (material, of_material);
                    simd.in_parts(&mut Lit { scene, of, at, layout, terms });
                    // Before the next material's terms overwrite these.
                    rows.put(simd, (&kept, of_material), terms);
                }
            },
        );
        self.count = 0;
    }

    /// Gives the terms that reach the lanes of a block, under a texture, to `put`: by their barycentrics.
    ///
    /// Outlined: one copy per lane type.
    #[inline(never)]
    pub(crate) fn mix<N: Lanes>(
        &mut self,
        scene: &ShadingContext<'_>,
        (ids, seen): (&[u32; LANES], u32),
        barycentric: &[N; 3],
        texture: Rgb<N>,
        mut put: impl FnMut(u32, &TermMix<'_, N, (&TermLayout, &TermColumns)>),
    ) {
        texture.r.vectorized(
            #[inline(always)]
            || {
                let simd = texture.r.zero();
                let mut left = seen;
                while left != 0 {
                    let mut lanes = left;
                    if self.gathered_ids != *ids {
                        let mut kept = self.kept(ids, left);
                        if kept.lanes != left {
                            // Two triangles with the same entry of the table are lit one after the other.
                            self.require(simd, scene, ids, left & !kept.lanes);
                            self.light(simd, scene);
                            kept = self.kept(ids, left);
                        }
                        lanes = kept.lanes;
                        let gathered = &mut self.gathered[..self.rows.places()];
                        self.rows.gather(simd, &kept.at, gathered);
                        let is_whole = lanes == seen;
                        self.gathered_ids = if is_whole { *ids } else { NOTHING_SEEN };
                    }
                    left &= !lanes;
                    let [first, second, third] = &self.gathered;
                    let of = |columns| (&self.layout, columns);
                    let [u, v, w] = *barycentric;
                    let whole = [(simd.one(), of(first))];
                    let corners = [(u, of(first)), (v, of(second)), (w, of(third))];
                    let places = if self.rows.places() == 1 { &whole[..] } else { &corners };
                    put(lanes, &TermMix { places, texture });
                }
            },
        );
    }

    /// Where the triangles of lanes are kept.
    #[inline(always)]
    fn kept(&self, ids: &[u32; LANES], lanes: u32) -> Kept {
        let mut kept = Kept { lanes: 0, at: [0; LANES] };
        for lane in lanes_of(lanes) {
            let lane = lane & (LANES - 1);
            let at = self.place(ids[lane]);
            kept.at[lane] = at;
            kept.lanes |= u32::from(self.ids[at] == ids[lane]) << lane;
        }
        kept
    }
}

/// Lights triangles where a copy of the equation for lanes isn't [worth its code](Lanes::IS_SPECIALIZED).
fn light_one_by_one(
    scene: &ShadingContext<'_>,
    (ids, lanes): (&[u32; LANES], u32),
    layout: &TermLayout,
    terms: &mut [TermColumns],
) {
    for lane in lanes_of(lanes) {
        let id = TriangleId(ids[lane]);
        let Some(of) = scene.frame.triangle(id) else { continue };
        let triangle = LitTriangle::new(scene, id, of);
        let of = (triangle.has, triangle.material);
        let whole = (terms.len() == 1).then(|| triangle.whole(scene));
        let places = whole.as_ref().map_or(&triangle.corners[..], std::slice::from_ref);
        for (place, terms) in places.iter().zip(&mut *terms) {
            terms.put_lane(layout, lane, &PlaceTerms::of(scene, place, of, None));
        }
    }
}
