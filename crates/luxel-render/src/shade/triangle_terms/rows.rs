//! Between columns of sixteen triangles' terms and rows of one triangle's: transposed in registers.

use super::columns::TermColumns;
use luxel_math::{LANES, Lanes, SplitLanes};

/// The terms of triangles, triangle by triangle and place by place, in rows of eight.
pub(super) struct TermRows {
    rows: Vec<[f32; 8]>,
    places: usize,
    /// Rows of one place.
    of_place: usize,
}

impl TermRows {
    pub(super) fn new() -> Self {
        Self { rows: Vec::new(), places: 1, of_place: 0 }
    }

    /// Makes room for triangles of so many places, and forgets what was there.
    pub(super) fn begin_frame(&mut self, triangles: usize, places: usize, of_place: usize) {
        self.rows.clear();
        self.rows.resize(triangles * places * of_place, [0.0; 8]);
        (self.places, self.of_place) = (places, of_place);
    }

    /// Places of a triangle.
    #[inline(always)]
    pub(super) fn places(&self) -> usize {
        self.places
    }

    /// Writes the terms of the lanes' triangles, of each place.
    #[inline(always)]
    pub(super) fn put<N: Lanes>(
        &mut self,
        simd: N,
        (triangles, lanes): (&[usize; LANES], u32),
        columns: &[TermColumns],
    ) {
        let firsts = self.firsts(triangles);
        simd.in_parts(&mut Put { rows: self, firsts, lanes, columns });
    }

    /// Reads the terms of each lane's triangle, of each place.
    #[inline(always)]
    pub(super) fn gather<N: Lanes>(
        &self,
        simd: N,
        triangles: &[usize; LANES],
        columns: &mut [TermColumns],
    ) {
        simd.in_parts(&mut Gather { rows: self, firsts: self.firsts(triangles), columns });
    }

    /// The first rows of the lanes' triangles.
    #[inline(always)]
    fn firsts(&self, triangles: &[usize; LANES]) -> [usize; LANES] {
        let step = self.places * self.of_place;
        std::array::from_fn(
            #[inline(always)]
            |lane| triangles[lane] * step,
        )
    }
}

struct Put<'a> {
    rows: &'a mut TermRows,
    firsts: [usize; LANES],
    lanes: u32,
    columns: &'a [TermColumns],
}

impl SplitLanes for Put<'_> {
    #[inline(always)]
    fn part<N: Lanes>(&mut self, simd: N, first: usize) {
        let Self { rows, firsts, lanes, .. } = self;
        let of_place = rows.of_place;
        for (place, columns) in self.columns.iter().enumerate() {
            for (row, columns) in columns.0.as_chunks::<8>().0.iter().enumerate() {
                N::store_transposed(
                    [
                        simd.load(&columns[0], first),
                        simd.load(&columns[1], first),
                        simd.load(&columns[2], first),
                        simd.load(&columns[3], first),
                        simd.load(&columns[4], first),
                        simd.load(&columns[5], first),
                        simd.load(&columns[6], first),
                        simd.load(&columns[7], first),
                    ],
                    #[inline(always)]
                    |lane, values| {
                        let lane = (first + lane) & (LANES - 1);
                        if *lanes >> lane & 1 == 1 {
                            rows.rows[firsts[lane] + place * of_place + row] = values;
                        }
                    },
                );
            }
        }
    }
}

struct Gather<'a> {
    rows: &'a TermRows,
    firsts: [usize; LANES],
    columns: &'a mut [TermColumns],
}

impl SplitLanes for Gather<'_> {
    #[inline(always)]
    fn part<N: Lanes>(&mut self, simd: N, first: usize) {
        let Self { rows, firsts, .. } = self;
        for (place, columns) in self.columns.iter_mut().enumerate() {
            for (row, columns) in columns.0.as_chunks_mut::<8>().0.iter_mut().enumerate() {
                let [a, b, c, d, e, f, g, h] = simd.load_transposed(
                    #[inline(always)]
                    |lane| {
                        let first = firsts[(first + lane) & (LANES - 1)];
                        rows.rows.get(first + place * rows.of_place + row).unwrap_or(&[0.0; 8])
                    },
                );
                a.store(&mut columns[0], first);
                b.store(&mut columns[1], first);
                c.store(&mut columns[2], first);
                d.store(&mut columns[3], first);
                e.store(&mut columns[4], first);
                f.store(&mut columns[5], first);
                g.store(&mut columns[6], first);
                h.store(&mut columns[7], first);
            }
        }
    }
}
