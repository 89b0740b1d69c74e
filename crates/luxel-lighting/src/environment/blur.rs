//! The environment as rough surfaces mirror it: sums over the whole sphere, by a tree.
//!
//! The split sum (Karis, *Real Shading in Unreal Engine 4*, 2013) takes N = V = R. The halfway vector then
//! depends on L.R alone, so that the lobe of a roughness is a round blur of the environment:
//!
//! ```text
//! E(R) = sum E(L) w(L.R) / sum w(L.R), w(c) = D(sqrt((1 + c) / 2)) max(c, 0)
//! ```
//!
//! The sums are over the cells of the octahedral map, each times its solid angle. Far from the lobe's middle,
//! where w is smooth, a cell of a coarser level stands for those below it (as in the algorithm of Barnes and
//! Hut, 1986). Its light counts where the mean of its light lies, so that a sun within a large
//! cell is not in the wrong place.

use super::octahedron;
use super::resample::Cells;

/// Light from a part of the sphere.
#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    /// Red, green and blue times solid angle.
    light: [f32; 3],
    /// Solid angle.
    area: f32,
    /// Its middle, of unit length.
    middle: [f32; 3],
    /// The middle of its light, of unit length.
    light_middle: [f32; 3],
}

/// A pyramid of cells: each level half as many across and down.
pub(super) struct Pyramid {
    /// The finest first.
    levels: Vec<Level>,
}

struct Level {
    side: usize,
    cells: Vec<Cell>,
}

/// The most cells a side of the finest level that is summed up.
const FINEST: usize = 512;
/// Cells a side of the level where sums begin.
const COARSEST: usize = 8;
/// A cell is taken as a whole if its solid angle is smaller than this part of the squared distance to the
/// lobe's middle and of the lobe's width, these being at most [`LARGEST`].
const COARSENESS: f32 = 1.0 / 16.0;
/// So that the edge of the half space doesn't run through large cells.
const LARGEST: f32 = 0.25;
/// Cells per run of one thread.
const RUN: usize = 1 << 10;

/// Bytes of the pyramid of a square of cells.
pub(super) const fn bytes(side: u64) -> u64 {
    let finest = if side < FINEST as u64 { side } else { FINEST as u64 };
    finest * finest * size_of::<Cell>() as u64 * 4 / 3
}

impl Pyramid {
    /// The pyramid over a square of at least 8 cells a side, a power of two.
    pub(super) fn new(finest: &Cells) -> Self {
        let mut sums;
        let Cells { side, sums: of_side } = finest;
        let (mut side, mut current) = (*side, of_side.as_slice());
        while side > FINEST {
            sums = halved(side, current);
            side /= 2;
            current = &sums;
        }
        let mut cells = vec![Cell::default(); side * side];
        luxel_parallel::fill(&mut cells, RUN, &|start, run| {
            for (at, cell) in (start..).zip(run) {
                let there = [at % side, at / side].map(|at| (at as f64 + 0.5) / side as f64);
                let middle = octahedron::direction(there).map(|axis| axis as f32);
                let [r, g, b, area] = current[at];
                *cell = Cell { light: [r, g, b], area, middle, light_middle: middle };
            }
        });
        let mut levels = vec![Level { side, cells }];
        while side > COARSEST {
            let above = levels.last().map_or(&[][..], |level| &level.cells);
            side /= 2;
            let mut cells = vec![Cell::default(); side * side];
            luxel_parallel::fill(&mut cells, RUN, &|start, run| {
                for (at, cell) in (start..).zip(run) {
                    let first = at / side * side * 4 + at % side * 2;
                    let four = [first, first + 1, first + 2 * side, first + 2 * side + 1];
                    *cell = Cell::of_four(four.map(|at| above[at]));
                }
            });
            levels.push(Level { side, cells });
        }
        Self { levels }
    }

    /// The finest cells: light times solid angle, solid angle, middle.
    pub(super) fn finest(&self) -> impl Iterator<Item = ([f32; 3], f32, [f32; 3])> {
        let cells = self.levels.first().map_or(&[][..], |level| &level.cells);
        cells.iter().map(|cell| (cell.light, cell.area, cell.middle))
    }

    /// The environment blurred for a perceptual roughness above 0, in a square of `side` texels, a multiple
    /// of 4.
    pub(super) fn blurred(&self, side: usize, roughness: f32) -> Vec<[f32; 3]> {
        let tiles_across = side / TILE;
        let mut tiles = vec![[[0.0; 3]; TILE * TILE]; tiles_across * tiles_across];
        luxel_parallel::fill(&mut tiles, 8, &|start, run| {
            let (mut open, mut taken) = (Vec::new(), Vec::new());
            for (at, tile) in (start..).zip(run) {
                let corner = [at % tiles_across * TILE, at / tiles_across * TILE];
                let lobes = Lobes::new(corner, side, roughness * roughness);
                self.collect(&lobes, &mut open, &mut taken);
                *tile = lobes.light(&taken);
            }
        });
        let of_texel = |at: usize| {
            let (x, y) = (at % side, at / side);
            tiles[y / TILE * tiles_across + x / TILE][y % TILE * TILE + x % TILE]
        };
        (0..side * side).map(of_texel).collect()
    }

    /// Collects the cells that are summed up for a tile. `open` is room for cells to come.
    fn collect(&self, lobes: &Lobes, open: &mut Vec<(usize, usize)>, taken: &mut Vec<Cell>) {
        let coarsest = self.levels.len() - 1;
        taken.clear();
        open.extend((0..self.levels[coarsest].cells.len()).rev().map(|at| (coarsest, at)));
        while let Some((number, at)) = open.pop() {
            let Level { side, cells } = &self.levels[number];
            let cell = cells[at];
            if number == 0 || cell.area <= lobes.largest_cell(cell.middle) {
                taken.push(cell);
                continue;
            }
            let first = at / side * side * 4 + at % side * 2;
            let below = 2 * side;
            for child in [first + below + 1, first + below, first + 1, first] {
                open.push((number - 1, child));
            }
        }
    }
}

/// Texels across and down that share the choice of cells.
const TILE: usize = 4;

/// The lobes of the texels of a tile.
struct Lobes {
    alpha2: f32,
    /// Their middles: X, Y, Z.
    middles: [[f32; TILE * TILE]; 3],
    /// About the middle of the tile.
    centre: [f32; 3],
    radius: f32,
}

impl Lobes {
    fn new([left, top]: [usize; 2], side: usize, alpha: f32) -> Self {
        let direction = |x: f64, y: f64| {
            octahedron::direction([x, y].map(|at| at / side as f64)).map(|axis| axis as f32)
        };
        let half = TILE as f64 / 2.0;
        let centre = direction(left as f64 + half, top as f64 + half);
        let mut middles = [[0.0; TILE * TILE]; 3];
        let mut squared_radius = 0.0_f32;
        for at in 0..TILE * TILE {
            let (x, y) = (left + at % TILE, top + at / TILE);
            let middle = direction(x as f64 + 0.5, y as f64 + 0.5);
            squared_radius = squared_radius.max(squared_distance(middle, centre));
            for axis in 0..3 {
                middles[axis][at] = middle[axis];
            }
        }
        Self { alpha2: alpha * alpha, middles, centre, radius: squared_radius.sqrt() }
    }

    /// The largest solid angle that a cell with this middle may have to be taken as a whole.
    fn largest_cell(&self, middle: [f32; 3]) -> f32 {
        let distance = (squared_distance(middle, self.centre).sqrt() - self.radius).max(0.0);
        COARSENESS * (distance * distance + 4.0 * self.alpha2).min(LARGEST)
    }

    /// The light of each lobe. Loops are over lobes, so that they run in lanes.
    fn light(&self, cells: &[Cell]) -> [[f32; 3]; TILE * TILE] {
        let [x, y, z] = &self.middles;
        let mut sums = [[0.0_f32; TILE * TILE]; 3];
        let mut weights = [0.0_f32; TILE * TILE];
        for cell in cells {
            let Cell { light, area, middle, light_middle } = *cell;
            for at in 0..TILE * TILE {
                let mirrored = [x[at], y[at], z[at]];
                weights[at] += weight(squared_distance(middle, mirrored), self.alpha2) * area;
                let of_light = weight(squared_distance(light_middle, mirrored), self.alpha2);
                for channel in 0..3 {
                    sums[channel][at] += light[channel] * of_light;
                }
            }
        }
        let of_lobe = |at: usize| {
            let weight = weights[at].max(f32::MIN_POSITIVE);
            [sums[0][at] / weight, sums[1][at] / weight, sums[2][at] / weight]
        };
        std::array::from_fn(of_lobe)
    }
}

/// w of a direction at a squared distance from R on the unit sphere, 2 - 2 L.R, but for a factor: with
/// 1 - (N.H)^2 = squared / 4, D is 1 / (squared / 4 + alpha^2 (1 - squared / 4))^2.
#[inline(always)]
fn weight(squared: f32, alpha2: f32) -> f32 {
    let cosine = 1.0 - 0.5 * squared;
    let aside = 0.25 * squared;
    let width = aside + alpha2 * (1.0 - aside);
    // Scaled to 1 in the middle, so that nothing overflows.
    let scaled = alpha2 / width;
    (if cosine > 0.0 { cosine } else { 0.0 }) * scaled * scaled
}

#[inline(always)]
fn squared_distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    let [x, y, z] = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    x * x + y * y + z * z
}

/// Each four cells as one.
fn halved(side: usize, sums: &[[f32; 4]]) -> Vec<[f32; 4]> {
    let half = side / 2;
    let mut all = vec![[0.0; 4]; half * half];
    luxel_parallel::fill(&mut all, RUN, &|start, run| {
        for (at, sum) in (start..).zip(run) {
            let first = at / half * side * 2 + at % half * 2;
            let four = [first, first + 1, first + side, first + side + 1].map(|at| sums[at]);
            for channel in 0..4 {
                let [a, b, c, d] = [four[0], four[1], four[2], four[3]].map(|one| one[channel]);
                sum[channel] = (a + b) + (c + d);
            }
        }
    });
    all
}

impl Cell {
    fn of_four(four: [Self; 4]) -> Self {
        let mut all = Self::default();
        let (mut middle, mut light_middle) = ([0.0; 3], [0.0; 3]);
        for one in four {
            let [r, g, b] = one.light;
            let brightness = r + g + b;
            for axis in 0..3 {
                all.light[axis] += one.light[axis];
                middle[axis] += one.middle[axis] * one.area;
                light_middle[axis] += one.light_middle[axis] * brightness;
            }
            all.area += one.area;
        }
        all.middle = unit(middle).unwrap_or(four[0].middle);
        all.light_middle = unit(light_middle).unwrap_or(all.middle);
        all
    }
}

/// The direction at length 1; `None` where it has none.
fn unit(direction: [f32; 3]) -> Option<[f32; 3]> {
    let largest = direction.iter().fold(0.0_f32, |largest, axis| largest.max(axis.abs()));
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    let scaled = direction.map(|axis| axis / largest);
    let length = (scaled[0] * scaled[0] + scaled[1] * scaled[1] + scaled[2] * scaled[2]).sqrt();
    Some(scaled.map(|axis| axis / length))
}
