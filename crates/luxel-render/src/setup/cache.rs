//! The prepared triangles of one tile: one cache a thread.

use crate::context::{AttributeMask, ShadingContext};
use crate::material::{Corner, light_at};
use crate::setup::corners::CornerReader;
use crate::setup::prepare::{Preparation, SetupColumns, Target};
use crate::setup::{COLOR, LIGHT, NORMAL, PLACES, POSITION, ROWS, TANGENT, UVS, VectorAt};
use crate::setup::{TriangleSetup, VertexExtras};
use luxel_lighting::Silent;
use luxel_math::{LANES, Lanes, lanes_of};
use luxel_view::ShadingMode;
use luxel_visibility::TriangleId;

/// A place for what nobody asked for: the last, which no triangle gets.
const SPARE: usize = PLACES - 1;
/// Places of the table from ids to triangles: enough that two of these seldom want the same.
const TABLE: usize = 4096;
/// The first pixel of no tile.
const NO_TILE: [i32; 2] = [i32::MIN; 2];
/// How many can be requested before they have to be prepared.
const PENDING: usize = 4 * LANES;

/// The triangles that a thread has prepared last, all within one tile.
pub(crate) struct SetupCache {
    /// The first pixel of the tile.
    tile: [i32; 2],
    /// By the low bits of an id: which of the others it may be.
    table: Box<[u16; TABLE]>,
    ids: [u32; PLACES],
    materials: [u32; PLACES],
    reads: [AttributeMask; PLACES],
    setups: Vec<TriangleSetup>,
    /// Empty until the first triangle with other attributes is seen.
    extras: Vec<VertexExtras>,
    /// The place that is overwritten next.
    next: usize,
    pending: Pending,
    reader: CornerReader,
    /// The triangles of a block of which each sample sees another one.
    columns: Box<SetupColumns>,
}

/// Triangles that have a place, and are to be prepared for it.
struct Pending {
    ids: [u32; PENDING],
    places: [usize; PENDING],
    count: usize,
}

/// A prepared triangle.
#[derive(Clone, Copy)]
pub(crate) struct Prepared<'c> {
    pub(crate) setup: &'c TriangleSetup,
    pub(crate) extras: &'c VertexExtras,
    /// The number of its material.
    pub(crate) material: u32,
    /// The attributes that shading reads of it.
    pub(crate) reads: AttributeMask,
}

impl SetupCache {
    pub(crate) fn new() -> Self {
        Self {
            tile: NO_TILE,
            table: Box::new([0; TABLE]),
            ids: [TriangleId::NONE.0; PLACES],
            materials: [0; PLACES],
            reads: [AttributeMask::NONE; PLACES],
            setups: Vec::new(),
            extras: Vec::new(),
            next: 0,
            pending: Pending { ids: [TriangleId::NONE.0; PENDING], places: [0; PENDING], count: 0 },
            reader: CornerReader::new(),
            columns: Box::new([[0.0; LANES]; 8 * ROWS]),
        }
    }

    /// Forgets the triangles of another frame.
    pub(crate) fn begin_frame(&mut self) {
        self.tile = NO_TILE;
    }

    /// Forgets the triangles of another tile.
    #[inline(always)]
    pub(crate) fn begin_tile(&mut self, tile: [i32; 2]) {
        if self.tile != tile {
            self.tile = tile;
            self.ids.fill(TriangleId::NONE.0);
            self.pending.count = 0;
        }
    }

    /// Prepares the triangles of these lanes, up to sixteen. Seldom two of them want the same place of
    /// the table: then at least one of them is there afterwards.
    #[inline(always)]
    pub(crate) fn require<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        ids: &[u32; LANES],
        lanes: u32,
    ) {
        if !self.has_all(ids, lanes) {
            self.request(ids, lanes);
            self.prepare(simd, scene);
        }
    }

    /// Prepares one triangle, if it isn't there yet.
    #[inline(always)]
    pub(crate) fn require_one<N: Lanes>(&mut self, simd: N, scene: &ShadingContext<'_>, id: u32) {
        if !self.has(id) {
            self.request(&[id; LANES], 1);
            self.prepare(simd, scene);
        }
    }

    /// Requests what these lanes see and isn't there, to be prepared together with more.
    #[inline(always)]
    pub(crate) fn look_ahead<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        ids: &[u32; LANES],
        lanes: u32,
    ) {
        self.request(ids, lanes);
        if self.pending.count > PENDING - LANES {
            self.prepare(simd, scene);
        }
    }

    /// Prepares what the lowest of these lanes sees and all others that see the same instance, side by side
    /// and not to be kept; `None` if shading reads more of them than positions, normals and light. Their
    /// materials are in `materials`.
    #[inline(always)]
    pub(crate) fn prepare_columns<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        ids: &[u32; LANES],
        lanes: u32,
        materials: &mut [u32; LANES],
    ) -> Option<(u32, &SetupColumns)> {
        if scene.has_extras || scene.shading.mode == ShadingMode::Gouraud {
            return None;
        }
        let lanes = self.prepare_columns_now(simd, scene, ids, lanes, materials);
        Some((lanes, &self.columns))
    }

    /// Outlined: one copy per lane type.
    #[inline(never)]
    fn prepare_columns_now<N: Lanes>(
        &mut self,
        simd: N,
        scene: &ShadingContext<'_>,
        ids: &[u32; LANES],
        lanes: u32,
        materials: &mut [u32; LANES],
    ) -> u32 {
        let Self { reader, tile, columns, .. } = self;
        simd.vectorized(
            #[inline(always)]
            || {
                let of = reader.read(simd, scene, (ids, lanes), materials, |_, _, _, _, _| {});
                let (tile, into) = (*tile, Target::Columns(columns));
                let lanes = of.lanes;
                simd.in_parts(&mut Preparation { scene, tile, of, lit_as: None, into });
                lanes
            },
        )
    }

    /// Whether the triangles of these lanes are prepared.
    #[inline(always)]
    pub(crate) fn has_all(&self, ids: &[u32; LANES], lanes: u32) -> bool {
        lanes_of(lanes).all(|lane| self.has(ids[lane & (LANES - 1)]))
    }

    /// Whether a triangle is prepared.
    #[inline(always)]
    pub(crate) fn has(&self, id: u32) -> bool {
        self.ids[self.place(id)] == id
    }

    /// The number of the material of a prepared triangle.
    #[inline(always)]
    pub(crate) fn material(&self, id: u32) -> u32 {
        self.materials[self.place(id)]
    }

    /// The attributes that shading reads of a prepared triangle.
    #[inline(always)]
    pub(crate) fn reads(&self, id: u32) -> AttributeMask {
        self.reads[self.place(id)]
    }

    /// A triangle, if it is prepared.
    #[inline(always)]
    pub(crate) fn find(&self, id: u32) -> Option<Prepared<'_>> {
        self.has(id).then(
            #[inline(always)]
            || self.get(id),
        )
    }

    /// A prepared triangle.
    #[inline(always)]
    pub(crate) fn get(&self, id: u32) -> Prepared<'_> {
        let place = self.place(id);
        let setup = self.setups.get(place).unwrap_or(&TriangleSetup::NOTHING);
        let extras = self.extras.get(place).unwrap_or(&VertexExtras::NOTHING);
        Prepared { setup, extras, material: self.materials[place], reads: self.reads[place] }
    }

    #[inline(always)]
    fn place(&self, id: u32) -> usize {
        usize::from(self.table[id as usize % TABLE]) % PLACES
    }

    #[inline(always)]
    fn request(&mut self, ids: &[u32; LANES], lanes: u32) {
        for lane in lanes_of(lanes) {
            let id = ids[lane & (LANES - 1)];
            if !self.has(id) && id != TriangleId::NONE.0 {
                let place = self.next;
                self.next = (place + 1) % SPARE;
                self.ids[place] = id;
                self.table[id as usize % TABLE] = place as u16;
                let Pending { ids, places, count } = &mut self.pending;
                ids[*count % PENDING] = id;
                places[*count % PENDING] = place;
                *count += 1;
            }
        }
    }

    /// Prepares what was requested.
    #[inline(always)]
    pub(crate) fn prepare<N: Lanes>(&mut self, simd: N, scene: &ShadingContext<'_>) {
        if self.pending.count > 0 {
            self.prepare_now(simd, scene);
        }
    }

    /// Outlined: one copy per lane type.
    #[inline(never)]
    fn prepare_now<N: Lanes>(&mut self, simd: N, scene: &ShadingContext<'_>) {
        simd.vectorized(
            #[inline(always)]
            || self.prepare_lanes(simd, scene),
        );
    }

    #[inline(always)]
    fn prepare_lanes<N: Lanes>(&mut self, simd: N, scene: &ShadingContext<'_>) {
        if self.setups.is_empty() {
            self.setups.resize(PLACES, TriangleSetup::NOTHING);
        }
        let Self { pending, setups, extras, materials, reads, reader, tile, .. } = self;
        let Ok(setups) = <&mut [_; PLACES]>::try_from(setups.as_mut_slice()) else { return };
        let sixteens = pending.ids.as_chunks::<LANES>().0.iter();
        let sixteens = sixteens.zip(pending.places.as_chunks::<LANES>().0);
        for (first, (ids, places)) in (0..pending.count).step_by(LANES).zip(sixteens) {
            let mut left = u32::MAX >> (32 - LANES.min(pending.count - first));
            while left != 0 {
                let mut of_lanes = [0; LANES];
                let mut of = reader.read(
                    simd,
                    scene,
                    (ids, left),
                    &mut of_lanes,
                    |lane, space, mesh, corners, reads| {
                        if extras.is_empty() {
                            extras.resize(PLACES, VertexExtras::NOTHING);
                        }
                        extras[places[lane]].read(space, mesh, corners, reads);
                    },
                );
                let mut lit_as = None;
                if scene.shading.mode == ShadingMode::Gouraud {
                    let lane = of.lanes.trailing_zeros() as usize & (LANES - 1);
                    let material = of_lanes[lane];
                    of.lanes &= simd.eq_mask(&of_lanes, material);
                    lit_as = Some(material as usize);
                }
                left &= !of.lanes;
                let mut into = [SPARE; LANES];
                for lane in lanes_of(of.lanes) {
                    let place = places[lane] % PLACES;
                    into[lane] = place;
                    let material = of_lanes[lane];
                    materials[place] = material;
                    reads[place] = of.reads(scene, material);
                    if let Some(extras) = extras.get_mut(place).filter(|_| !reads[place].any()) {
                        *extras = VertexExtras::NOTHING;
                    }
                }
                let tile = *tile;
                let setups = &mut *setups;
                let into = Target::Places(into, setups);
                simd.in_parts(&mut Preparation { scene, tile, of, lit_as, into });
                if lit_as.is_some() {
                    for lane in lanes_of(of.lanes) {
                        let place = places[lane] % PLACES;
                        let (material, reads) = (materials[place], reads[place]);
                        if !reads.any() {
                            continue;
                        }
                        let corners = corners_of(&setups[place], &extras[place]);
                        let light = corners
                            .map(|corner| light_at(scene, &corner, reads, material, &mut Silent));
                        put_vector(&mut setups[place], LIGHT, light);
                    }
                }
            }
        }
        pending.count = 0;
    }
}

/// The corners of a prepared triangle.
fn corners_of(setup: &TriangleSetup, extras: &VertexExtras) -> [Corner; 3] {
    let numbers = setup.rows.as_flattened();
    let extras = extras.rows.as_flattened();
    [0, 1, 2].map(|corner| {
        let vector = |at: VectorAt| -> [f32; 3] {
            std::array::from_fn(|axis| {
                let first = numbers[at[axis]];
                if corner == 0 { first } else { first + numbers[at[3 * corner + axis]] }
            })
        };
        let extra = |first: usize| {
            if corner == 0 { extras[first] } else { extras[first] + extras[first + corner] }
        };
        Corner {
            position: vector(POSITION),
            normal: vector(NORMAL),
            tangent: std::array::from_fn(|at| extra(TANGENT + 3 * at)),
            uv: UVS.map(|set| [extra(set), extra(set + 3)]),
            color: std::array::from_fn(|at| extra(COLOR + 3 * at)),
            light: [0.0; 3],
        }
    })
}

/// Writes a vector of three corners.
fn put_vector(setup: &mut TriangleSetup, at: VectorAt, [a, b, c]: [[f32; 3]; 3]) {
    let numbers = setup.rows.as_flattened_mut();
    for axis in 0..3 {
        numbers[at[axis]] = a[axis];
        numbers[at[3 + axis]] = b[axis] - a[axis];
        numbers[at[6 + axis]] = c[axis] - a[axis];
    }
}
