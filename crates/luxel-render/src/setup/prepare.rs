//! Preparation of triangles, one a lane.
//!
//! Corners are f64, of which sixteen lanes fill more registers than there are without AVX-512: there
//! they are made in two halves.

use crate::context::ShadingContext;
use crate::material::lights_at;
use crate::setup::corners::{PlacedCorners, ReadCorners};
use crate::setup::{PLACES, ROWS, TriangleSetup};
use luxel_math::{LANES, Lanes, Rgb, SplitLanes, Vec3};
use luxel_visibility::TileForms;

/// Triangles on their way to [`TriangleSetup`]s.
pub(crate) struct Preparation<'a> {
    pub(crate) scene: &'a ShadingContext<'a>,
    /// The first pixel of the tile.
    pub(crate) tile: [i32; 2],
    pub(crate) of: ReadCorners<'a>,
    /// The material by which corners are lit, if they are.
    pub(crate) lit_as: Option<usize>,
    pub(crate) into: Target<'a>,
}

/// Where prepared triangles are put.
pub(crate) enum Target<'a> {
    /// Each lane's into a place of its own.
    Places([usize; LANES], &'a mut [TriangleSetup; PLACES]),
    /// All side by side.
    Columns(&'a mut SetupColumns),
}

/// The numbers of sixteen triangles side by side, each number as [`TriangleSetup`] has them.
pub(crate) type SetupColumns = [[f32; LANES]; 8 * ROWS];

impl SplitLanes for Preparation<'_> {
    #[inline(always)]
    fn part<N: Lanes>(&mut self, simd: N, first: usize) {
        if self.of.lanes >> first & simd.all_lanes() == 0 {
            return;
        }
        let Self { scene, tile, .. } = *self;
        let space = scene.space(self.of.instance);
        let (placed, in_mesh) = self.of.placed(simd, scene, first);
        let PlacedCorners { in_view, sides, towards_eye } = &placed;
        let forms = TileForms::new(scene.frame.rays(), in_view, *sides, *towards_eye, tile);
        // In the order of NORMAL, POSITION and LIGHT. Written out: a list that a loop fills is memory; and
        // one after the other, as all at once would be more than there are registers.
        let f = forms.to_array();
        self.put_row(first, 0, [f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7]]);
        let zero = simd.zero();
        let mut third_side = zero;
        if scene.needs_positions || self.lit_as.is_some() {
            let [p, s, t] = placed.first_and_sides(space);
            self.put_row(first, 3, [p.x, p.y, p.z, s.x, s.y, s.z, t.x, t.y]);
            third_side = t.z;
        }
        let [n, nb, nc] = placed.normals(space, in_mesh);
        let (ns, nt) = (nb - n, nc - n);
        let mut third_light = zero;
        if let Some(material) = self.lit_as {
            let [pa, pb, pc] = placed.positions(space);
            let l = vector(lights_at(scene, &pa, &n, material));
            let s = vector(lights_at(scene, &pb, &nb, material)) - l;
            let t = vector(lights_at(scene, &pc, &nc, material)) - l;
            self.put_row(first, 4, [l.x, l.y, l.z, s.x, s.y, s.z, t.x, t.y]);
            third_light = t.z;
        }
        self.put_row(first, 1, [f[8], f[9], f[10], f[11], f[12], n.x, n.y, n.z]);
        self.put_row(first, 2, [ns.x, ns.y, ns.z, nt.x, nt.y, nt.z, third_side, third_light]);
    }
}

impl Preparation<'_> {
    /// Writes a row of each lane's triangle.
    #[inline(always)]
    fn put_row<N: Lanes>(&mut self, first: usize, row: usize, columns: [N; 8]) {
        match &mut self.into {
            Target::Places(into, setups) => N::store_transposed(
                columns,
                #[inline(always)]
                |lane, values| {
                    setups[into[(first + lane) & (LANES - 1)] % PLACES].rows[row] = values;
                },
            ),
            Target::Columns(numbers) => {
                for (number, column) in columns.into_iter().enumerate() {
                    column.store(&mut numbers[8 * row + number], first);
                }
            }
        }
    }
}

#[inline(always)]
fn vector<N>(light: Rgb<N>) -> Vec3<N> {
    Vec3::new(light.r, light.g, light.b)
}
