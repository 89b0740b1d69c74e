//! Vectors of sixteen vertices in lanes, and out of them.

use luxel_math::{LANES, Lanes, Rgb};

/// Vectors of all lanes, from `of(lane)`; `simd` selects the lane type. Mark the closure `#[inline(always)]`.
#[inline(always)]
pub(super) fn load4<N: Lanes>(simd: N, of: impl Fn(usize) -> [f32; 4]) -> [N; 4] {
    let mut columns = [[0.0; LANES]; 4];
    for lane in 0..LANES {
        let [x, y, z, w] = of(lane);
        columns[0][lane] = x;
        columns[1][lane] = y;
        columns[2][lane] = z;
        columns[3][lane] = w;
    }
    [
        simd.load(&columns[0], 0),
        simd.load(&columns[1], 0),
        simd.load(&columns[2], 0),
        simd.load(&columns[3], 0),
    ]
}

/// Colours of all lanes.
#[inline(always)]
pub(super) fn color_lanes<N: Lanes>(simd: N, colors: &[[f32; 4]; LANES]) -> Rgb<N> {
    let [r, g, b, _] = load4(
        simd,
        #[inline(always)]
        |lane| colors[lane],
    );
    Rgb::new(r, g, b)
}

/// Writes the vectors of the first lanes.
#[inline(always)]
pub(super) fn store<N: Lanes>(values: &[N; 4], out: &mut [[f32; 4]]) {
    let [x, y, z, w] = *values;
    N::store_transposed(
        [x, y, z, w, x, y, z, w],
        #[inline(always)]
        |lane, [x, y, z, w, ..]| {
            if let Some(out) = out.get_mut(lane) {
                *out = [x, y, z, w];
            }
        },
    );
}

/// Rows of `K` numbers in lanes, lane by lane from row `first` on; lanes beyond the last of `count` repeat it.
///
/// `K` is at most 8.
#[inline(always)]
pub(super) fn load_rows<N: Lanes, const K: usize>(
    simd: N,
    rows: &[[f32; K]],
    first: usize,
    count: usize,
) -> [N; K] {
    let mut of = [simd; K];
    // Eight numbers from the start of each row on: the next rows' are not looked at.
    let reach = first * K..first * K + (LANES - 1) * K + 8;
    match rows.as_flattened().get(reach) {
        Some(flat) if count == LANES => {
            let columns = simd.load_transposed(
                #[inline(always)]
                |lane| flat[lane * K..].first_chunk().unwrap_or(&[0.0; 8]),
            );
            of.copy_from_slice(&columns[..K]);
        }
        _ => {
            let mut columns = [[0.0; LANES]; K];
            for lane in 0..LANES {
                let row = rows[first + lane.min(count - 1)];
                for (column, value) in columns.iter_mut().zip(row) {
                    column[lane] = value;
                }
            }
            for (lanes, column) in of.iter_mut().zip(&columns) {
                *lanes = simd.load(column, 0);
            }
        }
    }
    of
}
