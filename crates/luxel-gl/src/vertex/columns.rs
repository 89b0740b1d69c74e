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
    let flat = rows.as_flattened();
    // Eight numbers from the start of each row on: the next rows' are not looked at.
    let mut last = [[0.0; 8]; LANES];
    let start = first * K;
    let whole = count == LANES && start + (LANES - 1) * K + 8 <= flat.len();
    if !whole {
        for (lane, copy) in last.iter_mut().enumerate() {
            copy[..K].copy_from_slice(&rows[first + lane.min(count - 1)]);
        }
    }
    let columns = simd.load_transposed(
        #[inline(always)]
        |lane| {
            let at = start + lane * K;
            let row = if whole { flat.get(at..).and_then(<[f32]>::first_chunk) } else { None };
            row.unwrap_or(&last[lane])
        },
    );
    let mut of = [simd; K];
    of.copy_from_slice(&columns[..K]);
    of
}
