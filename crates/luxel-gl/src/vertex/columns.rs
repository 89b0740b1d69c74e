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
    let mut columns = [[0.0; LANES]; 4];
    values[0].store(&mut columns[0], 0);
    values[1].store(&mut columns[1], 0);
    values[2].store(&mut columns[2], 0);
    values[3].store(&mut columns[3], 0);
    for (lane, row) in out.iter_mut().enumerate().take(LANES) {
        *row = [columns[0][lane], columns[1][lane], columns[2][lane], columns[3][lane]];
    }
}
