//! Triangles made ready for shading, up to sixteen at once, and kept for the next blocks: where a block
//! sees a few triangles, and those around it see them too.

use crate::gathered::{Gathered, OfInstance, Placed};
use crate::shade::Scene16;
use crate::varying::lanes_of;
use crate::vertex::plain_light_at;
use crate::view::ShadingMode;
use luxel_math::{LANES, Number, Piecewise};
use luxel_visibility::{Carried, PackedForms, TriangleId};

/// A triangle with what interpolation wants on plain surfaces.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(crate) struct ReadyTriangle {
    pub(crate) forms: PackedForms,
    /// At each corner the position about the eye, along the world's axes; then the unit normal in
    /// world space, turned to the side that is seen, or the light where that is computed there.
    pub(crate) corners: [Carried; 3],
}

const _: () = assert!(size_of::<ReadyTriangle>() == 192, "three cache lines");

impl ReadyTriangle {
    const NOTHING: Self = Self { forms: [[0.0; 4]; 3], corners: [[0.0; 8]; 3] };
}

/// Up to so many triangles that sixteen samples see are made ready when they are lit, if they aren't; with
/// more, few of them are seen by the next sixteen, too.
const FEW: u32 = 8;
/// How many are kept: 192 KiB, a part of a core's second-level cache. Enough for the blocks that are
/// looked at together.
const KEPT: usize = 1024;
/// A place for what nobody asked for.
const SPARE: usize = KEPT;
/// Places of the table from ids to triangles: enough that two of these seldom want the same.
const TABLE: usize = 4096;
/// How many can be asked for before they have to be made ready.
const PENDING: usize = 4 * LANES;

/// The triangles that a thread has made ready last.
pub(crate) struct Ready {
    /// By the low bits of an id: which of the others it may be.
    table: Box<[u16; TABLE]>,
    triangles: Vec<ReadyTriangle>,
    ids: [u32; KEPT],
    materials: [u32; KEPT],
    /// The one that is overwritten next.
    next: usize,
    pending: Pending,
}

/// Triangles that have a place, and are to be made ready for it.
struct Pending {
    ids: [u32; PENDING],
    places: [usize; PENDING],
    count: usize,
}

/// What each of sixteen samples sees.
#[derive(Clone, Copy)]
pub(crate) struct Rows<'r> {
    pub(crate) triangles: [&'r ReadyTriangle; LANES],
    /// The number of their material; `None` if there are several.
    pub(crate) material: Option<u32>,
}

impl Ready {
    pub(crate) fn new() -> Self {
        Self {
            table: Box::new([0; TABLE]),
            triangles: Vec::new(),
            ids: [TriangleId::NONE.0; KEPT],
            materials: [0; KEPT],
            next: 0,
            pending: Pending { ids: [TriangleId::NONE.0; PENDING], places: [0; PENDING], count: 0 },
        }
    }

    /// A triangle and the number of its material, made ready if it has to be.
    #[inline(always)]
    pub(crate) fn one<N: Number>(
        &mut self,
        like: N,
        scene: &Scene16<'_>,
        gathered: &mut Gathered,
        id: u32,
    ) -> Option<(&ReadyTriangle, u32)> {
        if !self.has(id) {
            self.ask(id);
            self.make(like, scene, gathered);
        }
        let place = self.place(id);
        Some((self.triangles.get(place)?, self.materials[place]))
    }

    /// The triangles of these lanes, made ready if they have to be; `None` if there are too many for
    /// that. Other lanes get one that is seen. `begins` are those lanes of which each triangle has at
    /// least one, see [`Number::lanes_that_begin`].
    #[inline(always)]
    pub(crate) fn rows<N: Number>(
        &mut self,
        like: N,
        scene: &Scene16<'_>,
        gathered: &mut Gathered,
        ids: &[u32; LANES],
        [lanes, begins]: [u32; 2],
    ) -> Option<Rows<'_>> {
        if !self.has_all(ids, begins) {
            if begins.count_ones() > FEW {
                return None;
            }
            self.ask_all(ids, begins);
            self.make(like, scene, gathered);
            if !self.has_all(ids, begins) {
                return None;
            }
        }
        let triangles: &[ReadyTriangle; KEPT + 1] = self.triangles.as_slice().try_into().ok()?;
        let first = ids[lanes.trailing_zeros() as usize & (LANES - 1)];
        let mut rows = [&ReadyTriangle::NOTHING; LANES];
        let material = self.materials[self.place(first)];
        let mut others = 0;
        for lane in 0..LANES {
            let id = if lanes >> lane & 1 == 1 { ids[lane] } else { first };
            let place = self.place(id);
            rows[lane] = &triangles[place];
            others |= self.materials[place] ^ material;
        }
        Some(Rows { triangles: rows, material: (others == 0).then_some(material) })
    }

    /// Whether the triangles of these lanes are ready.
    #[inline(always)]
    fn has_all(&self, ids: &[u32; LANES], lanes: u32) -> bool {
        lanes_of(lanes).all(|lane| self.has(ids[lane & (LANES - 1)]))
    }

    #[inline(always)]
    fn place(&self, id: u32) -> usize {
        usize::from(self.table[id as usize % TABLE]) % KEPT
    }

    /// Whether a triangle is ready.
    #[inline(always)]
    fn has(&self, id: u32) -> bool {
        self.ids[self.place(id)] == id
    }

    /// Makes ready what lanes of a block that comes next see, or asks for it until [`Ready::make`] is
    /// called.
    #[inline(always)]
    pub(crate) fn look_ahead<N: Number>(
        &mut self,
        like: N,
        scene: &Scene16<'_>,
        gathered: &mut Gathered,
        ids: &[u32; LANES],
        lanes: u32,
    ) {
        self.ask_all(ids, lanes);
        if self.pending.count > PENDING - LANES {
            self.make(like, scene, gathered);
        }
    }

    /// Asks for what these lanes see and isn't ready.
    #[inline(always)]
    fn ask_all(&mut self, ids: &[u32; LANES], lanes: u32) {
        for lane in lanes_of(lanes) {
            let id = ids[lane & (LANES - 1)];
            if !self.has(id) && id != TriangleId::NONE.0 {
                self.ask(id);
            }
        }
    }

    /// Gives a triangle a place, and notes that it is to be made ready.
    #[inline(always)]
    fn ask(&mut self, id: u32) {
        let place = self.next;
        self.next = (place + 1) % KEPT;
        self.ids[place] = id;
        self.table[id as usize % TABLE] = place as u16;
        let Pending { ids, places, count } = &mut self.pending;
        ids[*count % PENDING] = id;
        places[*count % PENDING] = place;
        *count += 1;
    }

    /// Makes ready what was asked for.
    #[inline(always)]
    pub(crate) fn make<N: Number>(
        &mut self,
        like: N,
        scene: &Scene16<'_>,
        gathered: &mut Gathered,
    ) {
        if self.pending.count > 0 {
            self.make_now(like, scene, gathered);
        }
    }

    /// Compiled once a kind of number.
    #[inline(never)]
    fn make_now<N: Number>(&mut self, like: N, scene: &Scene16<'_>, gathered: &mut Gathered) {
        like.vectorized(
            #[inline(always)]
            || self.make_lanes(like, scene, gathered),
        );
    }

    #[inline(always)]
    fn make_lanes<N: Number>(&mut self, like: N, scene: &Scene16<'_>, gathered: &mut Gathered) {
        if self.triangles.is_empty() {
            self.triangles.resize(KEPT + 1, ReadyTriangle::NOTHING);
        }
        let Self { pending, triangles, materials, .. } = self;
        let Ok(triangles) = <&mut [_; KEPT + 1]>::try_from(triangles.as_mut_slice()) else {
            return;
        };
        let places = pending.places.as_chunks::<LANES>().0;
        let sixteens = pending.ids.as_chunks::<LANES>().0.iter().zip(places);
        for (first, (ids, places)) in (0..pending.count).step_by(LANES).zip(sixteens) {
            let mut left = u32::MAX >> (32 - LANES.min(pending.count - first));
            while left != 0 {
                let mut of = gathered.read(scene, ids, left, false);
                let mut lit_as = None;
                if scene.shading.mode == ShadingMode::Gouraud {
                    let lane = of.lanes.trailing_zeros() as usize & (LANES - 1);
                    let material = gathered.materials[lane];
                    of.lanes &= like.lanes_equal(&gathered.materials, material);
                    lit_as = Some(material as usize);
                }
                left &= !of.lanes;
                let mut into = [SPARE; LANES];
                for lane in 0..LANES {
                    if of.lanes >> lane & 1 == 1 {
                        into[lane] = places[lane] % KEPT;
                        materials[into[lane]] = gathered.materials[lane];
                    }
                }
                let triangles = &mut *triangles;
                like.piecewise(&mut Making { scene, of, gathered, lit_as, into, triangles });
            }
        }
        pending.count = 0;
    }
}

/// Triangles on their way to [`ReadyTriangle`]s, piece by piece: corners are f64.
struct Making<'a> {
    scene: &'a Scene16<'a>,
    of: OfInstance,
    gathered: &'a Gathered,
    /// The material by which corners are lit, if they are.
    lit_as: Option<usize>,
    /// Where each is put.
    into: [usize; LANES],
    triangles: &'a mut [ReadyTriangle; KEPT + 1],
}

impl Piecewise for Making<'_> {
    #[inline(always)]
    fn piece<N: Number>(&mut self, like: N, first: usize) {
        let lanes = self.of.lanes >> first & like.all_lanes();
        if lanes == 0 {
            return;
        }
        let Placed { forms, about_eye, normals, .. } =
            self.gathered.placed(like, self.scene, &self.of, first);
        let into = self.into;
        let triangles = &mut *self.triangles;
        forms.linear().pack(
            #[inline(always)]
            |lane, row, values| {
                triangles[into[(first + lane) & (LANES - 1)]].forms[row] = values;
            },
        );
        for corner in 0..3 {
            let (position, normal) = (about_eye[corner], normals[corner]);
            let mut carried = [normal.x, normal.y, normal.z];
            if let Some(material) = self.lit_as {
                let light = plain_light_at(self.scene, &position, &normal, material);
                carried = [light.r, light.g, light.b];
            }
            let [u, v, w] = carried;
            let zero = like.zero();
            N::rows(
                [position.x, position.y, position.z, u, v, w, zero, zero],
                #[inline(always)]
                |lane, values| {
                    triangles[into[(first + lane) & (LANES - 1)]].corners[corner] = values;
                },
            );
        }
    }
}
