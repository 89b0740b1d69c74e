//! Directions as places of a square: the octahedral map.
//!
//! A direction d is p = d / (|x| + |y| + |z|), a point of an octahedron; its upper half is seen from
//! above, and the lower half is folded outwards over the edges (Cigolle et al., *A Survey of Efficient
//! Representations for Independent Unit Vectors*, JCGT 2014). +Y is the middle of the square, -Y all four
//! corners. There is no trigonometry in it and one division, and no seam but the border.

use luxel_math::{Lanes, Vec3};

/// The place of a direction of any length but 0, each coordinate within 0 and 1.
#[inline(always)]
pub(super) fn place<N: Lanes>(direction: Vec3<N>) -> [N; 2] {
    let Vec3 { x, y, z } = direction;
    let simd = x;
    let one = simd.one();
    let size = x.abs() + y.abs() + z.abs();
    let scale = one / size.maximum(simd.constant(f32::MIN_POSITIVE));
    let (across, down) = (x * scale, z * scale);
    let is_below = y.less(simd.zero());
    let folded_across = with_sign_of(one - down.abs(), across);
    let folded_down = with_sign_of(one - across.abs(), down);
    let half = simd.constant(0.5);
    [
        folded_across.select(is_below, across) * half + half,
        folded_down.select(is_below, down) * half + half,
    ]
}

#[inline(always)]
fn with_sign_of<N: Lanes>(value: N, sign: N) -> N {
    (-value).select(sign.less(sign.zero()), value)
}

/// The direction, of unit length, of a place of the square.
pub(super) fn direction([u, v]: [f64; 2]) -> [f64; 3] {
    let (across, down) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    let y = 1.0 - across.abs() - down.abs();
    let (x, z) = if y < 0.0 {
        ((1.0 - down.abs()).copysign(across), (1.0 - across.abs()).copysign(down))
    } else {
        (across, down)
    };
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

/// A square of light, with a border so that filtering needs no rule for edges.
#[derive(Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Square {
    /// Texels across and down, without the border.
    side: usize,
    /// Rows of side + 2 texels; the fourth number is not used.
    texels: Vec<[f32; 4]>,
}

impl Square {
    /// Bytes of a square of so many texels a side.
    pub(super) const fn bytes(side: u64) -> u64 {
        (side + 2) * (side + 2) * 16
    }

    /// A square of light, row by row.
    ///
    /// Beyond an edge the octahedron goes on at the mirrored place of the same edge.
    pub(super) fn new(side: usize, light: &[[f32; 3]]) -> Self {
        let inside = |at: usize| at.clamp(1, side) - 1;
        let mirrored = |at: usize| side - 1 - inside(at);
        let is_outside = |at: usize| at == 0 || at == side + 1;
        let mut texels = Vec::with_capacity((side + 2) * (side + 2));
        for row in 0..side + 2 {
            for column in 0..side + 2 {
                let (x, y) = match (is_outside(column), is_outside(row)) {
                    (false, false) => (inside(column), inside(row)),
                    (true, false) => (inside(column), mirrored(row)),
                    (false, true) => (mirrored(column), inside(row)),
                    (true, true) => (mirrored(column), mirrored(row)),
                };
                let [r, g, b] = light[y * side + x];
                texels.push([r, g, b, 0.0]);
            }
        }
        Self { side, texels }
    }

    /// Whether all texels are there.
    pub(super) fn is_whole(&self) -> bool {
        let stride = self.side.checked_add(2);
        stride.and_then(|stride| stride.checked_mul(stride)) == Some(self.texels.len())
    }

    /// The light at a place, filtered linearly.
    #[inline(always)]
    pub(super) fn at(&self, [u, v]: [f32; 2]) -> [f32; 4] {
        let side = self.side as f32;
        // Half a texel back to the middle of the first, one on for the border.
        let (x, y) = (u * side + 0.5, v * side + 0.5);
        let (column, row) = ((x as usize).min(self.side), (y as usize).min(self.side));
        let (right, down) = (x - column as f32, y - row as f32);
        let stride = self.side + 2;
        let first = row * stride + column;
        let [Some([a, b]), Some([c, d])] = [first, first + stride]
            .map(|at| self.texels.get(at..at + 2).and_then(|two| two.first_chunk::<2>()))
        else {
            return [0.0; 4];
        };
        let mut light = [0.0; 4];
        for channel in 0..4 {
            let above = a[channel] + (b[channel] - a[channel]) * right;
            let below = c[channel] + (d[channel] - c[channel]) * right;
            light[channel] = above + (below - above) * down;
        }
        light
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_directions_are_each_others_inverse() {
        for row in 0..64 {
            for column in 0..64 {
                let there = [column, row].map(|at| (f64::from(at) + 0.5) / 64.0);
                let [x, y, z] = direction(there).map(|axis| axis as f32);
                let back = place(Vec3::new(x, y, z));
                for axis in 0..2 {
                    assert!((f64::from(back[axis]) - there[axis]).abs() < 1e-6, "{there:?}");
                }
            }
        }
    }

    #[test]
    fn a_square_has_no_seam() {
        // Light that is linear in the direction: filtered, it may differ by what texels are wide.
        let side = 64;
        let light = |[x, y, z]: [f64; 3]| [x as f32, y as f32, z as f32];
        let at = |index: usize| {
            let there = [index % side, index / side].map(|at| (at as f64 + 0.5) / side as f64);
            light(direction(there))
        };
        let square = Square::new(side, &(0..side * side).map(at).collect::<Vec<_>>());
        for step in 0..=4000 {
            for edge in [0.0, 1.0] {
                let along = f64::from(step) / 4000.0;
                for there in [[along, edge], [edge, along]] {
                    let expected = light(direction(there));
                    let found = square.at(there.map(|at| at as f32));
                    for channel in 0..3 {
                        let error = (found[channel] - expected[channel]).abs();
                        assert!(error < 0.03, "{there:?}: {found:?}, {expected:?}");
                    }
                }
            }
        }
    }
}
