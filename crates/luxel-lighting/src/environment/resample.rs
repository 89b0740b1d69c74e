//! An equirectangular picture becomes a square of the octahedral map.
//!
//! Each texel of the picture is cut into pieces smaller than the square's cells, and each piece adds its
//! light times its solid angle to the cell where it lies: so no light is lost, however small its source.
//! Sines and cosines are needed for rows and columns alone.

use super::EquirectangularImage;
use libm::sincos;
use std::f64::consts::PI;

/// The light of the sphere's cells, row by row.
pub(super) struct Cells {
    /// Cells across and down.
    pub(super) side: usize,
    /// Red, green and blue, each times solid angle; solid angle.
    pub(super) sums: Vec<[f32; 4]>,
}

/// Pieces are at most 2 pi / (8 side) wide and high: where cells are narrowest, they are parallelograms with
/// room for a circle of a diameter of 1.41 / side, so that none stays empty.
const PIECES_PER_CELL: usize = 8;

/// Where pieces of columns lie.
struct Columns {
    /// The texels left and right of a piece, and how far it is from the left one to the right one.
    between: Vec<(usize, usize, f32)>,
    /// The parts of longitudes along X and Z, without their sign.
    across: Vec<f32>,
    down: Vec<f32>,
}

/// The middles of `pieces` of each of `count` texels: the texels before and after, and how far it is from
/// one to the other.
fn between(count: usize, pieces: usize, wraps: bool) -> Vec<(usize, usize, f32)> {
    let of = |piece: usize| {
        let (texel, within) = (piece / pieces, piece % pieces);
        let offset = (within as f32 + 0.5) / pieces as f32 - 0.5;
        let before = match texel.checked_sub(1) {
            Some(before) => before,
            None if wraps => count - 1,
            None => 0,
        };
        let after = if texel + 1 < count {
            texel + 1
        } else if wraps {
            0
        } else {
            texel
        };
        if offset < 0.0 { (before, texel, offset + 1.0) } else { (texel, after, offset) }
    };
    (0..count * pieces).map(of).collect()
}

/// Sums up the light of a picture in a square of `side` cells, an even number.
pub(super) fn cells(image: &EquirectangularImage, side: usize) -> Cells {
    let (width, height) = (image.width as usize, image.height as usize);
    let pieces = |texels: usize, cells: usize| (PIECES_PER_CELL * cells).div_ceil(texels).max(1);
    let (pieces_across, pieces_down) = (pieces(width, side), pieces(height, side / 2));
    let across = width * pieces_across;
    let longitude = |piece: usize| sincos(PI * (2 * piece + 1) as f64 / across as f64);
    // The longitude is 0 at the left edge, where the direction is -X.
    let columns = Columns {
        between: between(width, pieces_across, true),
        across: (0..across).map(|piece| longitude(piece).1.abs() as f32).collect(),
        down: (0..across).map(|piece| longitude(piece).0.abs() as f32).collect(),
    };
    let rows = between(height, pieces_down, false);

    // A quarter of the square each, which no other quarter of the picture's columns reaches.
    let half = side / 2;
    let mut quarters: [Vec<[f32; 4]>; 4] = std::array::from_fn(|_| vec![[0.0; 4]; half * half]);
    luxel_parallel::each(quarters.iter_mut().enumerate(), &|(quarter, sums)| {
        add_quarter(image, &columns, &rows, quarter, half, sums);
    });
    let mut sums = vec![[0.0; 4]; side * side];
    for (quarter, of_quarter) in quarters.iter().enumerate() {
        let is_right = matches!(quarter, 1 | 2);
        let is_lower = quarter >= 2;
        for (at, sum) in of_quarter.iter().enumerate() {
            let (x, y) = (at % half, at / half);
            let column = if is_right { half + x } else { half - 1 - x };
            let row = if is_lower { half + y } else { half - 1 - y };
            sums[row * side + column] = *sum;
        }
    }
    Cells { side, sums }
}

/// Sums up a quarter of the columns: from -X over -Z, +X and +Z. The cells' coordinates begin in the
/// square's middle.
fn add_quarter(
    image: &EquirectangularImage,
    columns: &Columns,
    rows: &[(usize, usize, f32)],
    quarter: usize,
    half: usize,
    sums: &mut [[f32; 4]],
) {
    let width = image.width as usize;
    let across = columns.between.len();
    // Of a piece whose middle lies on the border, one side has it.
    let first = |quarter: usize| (2 * quarter * across).saturating_sub(4).div_ceil(8);
    let own = if quarter == 3 { first(3)..across } else { first(quarter)..first(quarter + 1) };
    let step = 2.0 * PI / across as f64;
    let mut row_light = vec![[0.0_f32; 3]; width];
    for (number, &(above, below, fraction)) in rows.iter().enumerate() {
        let latitude = |edge: usize| sincos(PI * (0.5 - edge as f64 / rows.len() as f64)).0;
        let (upper, lower) = (latitude(number), latitude(number + 1));
        let solid_angle = (step * (upper - lower)) as f32;
        let (sine, cosine) = sincos(PI * (0.5 - (number as f64 + 0.5) / rows.len() as f64));
        let (sine, cosine) = (sine as f32, cosine as f32);
        let is_below = sine < 0.0;
        let sine = sine.abs();

        let row = |row: usize| &image.light[row * width..][..width];
        for ((light, a), b) in row_light.iter_mut().zip(row(above)).zip(row(below)) {
            for channel in 0..3 {
                light[channel] = a[channel] + (b[channel] - a[channel]) * fraction;
            }
        }
        for piece in own.clone() {
            let (x, z) = (cosine * columns.across[piece], cosine * columns.down[piece]);
            let scale = 1.0 / (x + sine + z);
            let (x, z) = (x * scale, z * scale);
            let (x, z) = if is_below { (1.0 - z, 1.0 - x) } else { (x, z) };
            let cell = |at: f32| ((at * half as f32) as usize).min(half - 1);
            let sum = &mut sums[cell(z) * half + cell(x)];
            let (left, right, fraction) = columns.between[piece];
            let (left, right) = (row_light[left], row_light[right]);
            for channel in 0..3 {
                let light = left[channel] + (right[channel] - left[channel]) * fraction;
                sum[channel] += light * solid_angle;
            }
            sum[3] += solid_angle;
        }
    }
}
