//! Triangles made ready, one a lane.
//!
//! Corners are f64, of which sixteen lanes fill more registers than there are without AVX-512: there
//! they are made in two halves.

use crate::context::ShadingContext;
use crate::material::lights_at;
use crate::setup::TriangleSetup;
use crate::setup::corners::{CornerReader, PlacedCorners, ReadLanes};
use luxel_math::{LANES, Number, Piecewise, Rgb, Vec3};
use luxel_visibility::TileForms;

/// Triangles on their way to [`TriangleSetup`]s.
pub(crate) struct Preparation<'a> {
    pub(crate) scene: &'a ShadingContext<'a>,
    /// The first pixel of the tile.
    pub(crate) tile: [i32; 2],
    pub(crate) of: ReadLanes,
    pub(crate) reader: &'a CornerReader,
    /// The material by which corners are lit, if they are.
    pub(crate) lit_as: Option<usize>,
    /// Where each lane's is put.
    pub(crate) into: [usize; LANES],
    pub(crate) setups: &'a mut [TriangleSetup],
}

impl Piecewise for Preparation<'_> {
    #[inline(always)]
    fn piece<N: Number>(&mut self, like: N, first: usize) {
        if self.of.lanes >> first & like.all_lanes() == 0 {
            return;
        }
        let Self { scene, tile, .. } = *self;
        let placed = self.reader.placed(like, scene, &self.of, first);
        let f = TileForms::new(&placed.forms, scene.frame.rays(), tile).to_array();
        let PlacedCorners { first: p, sides: [ps, pt], normals: [n, nb, nc], .. } = placed;
        let (ns, nt) = (nb - n, nc - n);
        let zero = like.zero();
        let (mut l, mut ls, mut lt) = (Vec3::new(zero, zero, zero), p, p);
        if let Some(material) = self.lit_as {
            l = vector(lights_at(scene, &p, &n, material));
            ls = vector(lights_at(scene, &(p + ps), &nb, material)) - l;
            lt = vector(lights_at(scene, &(p + pt), &nc, material)) - l;
        }
        // In the order of NORMAL, POSITION and LIGHT. Written out: a list that a loop fills is memory.
        self.put_row(first, 0, [f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7]]);
        self.put_row(first, 1, [f[8], f[9], f[10], f[11], f[12], n.x, n.y, n.z]);
        self.put_row(first, 2, [ns.x, ns.y, ns.z, nt.x, nt.y, nt.z, pt.z, lt.z]);
        self.put_row(first, 3, [p.x, p.y, p.z, ps.x, ps.y, ps.z, pt.x, pt.y]);
        if self.lit_as.is_some() {
            self.put_row(first, 4, [l.x, l.y, l.z, ls.x, ls.y, ls.z, lt.x, lt.y]);
        }
    }
}

impl Preparation<'_> {
    /// Writes a row of each lane's triangle.
    #[inline(always)]
    fn put_row<N: Number>(&mut self, first: usize, row: usize, columns: [N; 8]) {
        let Self { into, setups, .. } = self;
        N::rows(
            columns,
            #[inline(always)]
            |lane, values| {
                setups[into[(first + lane) & (LANES - 1)]].rows[row] = values;
            },
        );
    }
}

#[inline(always)]
fn vector<N>(light: Rgb<N>) -> Vec3<N> {
    Vec3::new(light.r, light.g, light.b)
}
