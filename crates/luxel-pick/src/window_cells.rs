//! Which instances may cover a pixel.

use luxel_scene::Size;

/// The window in cells, each with the instances that may cover it, so that a scene of thousands of
/// objects asks few of them.
#[derive(Default)]
pub(crate) struct WindowCells {
    /// Pixels of a cell's side, across and down.
    side: [i32; 2],
    across: usize,
    down: usize,
    /// Those that cover a large part of the window, in order.
    everywhere: Vec<u32>,
    lists: Vec<Vec<u32>>,
}

/// Cells of a window's side, at most.
const CELLS: u32 = 32;

impl WindowCells {
    pub(crate) fn new(size: Size, places: &[Option<[f64; 4]>]) -> Self {
        let side = [size.width, size.height].map(|pixels| pixels.div_ceil(CELLS).max(8));
        let [across, down] = [(size.width, side[0]), (size.height, side[1])]
            .map(|(pixels, side)| pixels.div_ceil(side) as usize);
        let side = side.map(|side| side as i32);
        let mut cells = Self {
            side,
            across,
            down,
            everywhere: Vec::new(),
            lists: vec![Vec::new(); across * down],
        };
        for (number, place) in (0..).zip(places) {
            let Some([left, top, right, bottom]) = *place else { continue };
            let cell = |at: f64, side: i32, count: usize| {
                (at / f64::from(side)).floor().clamp(-1.0, count as f64) as i64
            };
            let first = [cell(left, side[0], across).max(0), cell(top, side[1], down).max(0)];
            let last = [
                cell(right, side[0], across).min(across as i64 - 1),
                cell(bottom, side[1], down).min(down as i64 - 1),
            ];
            if first[0] > last[0] || first[1] > last[1] {
                continue;
            }
            let count = (last[0] - first[0] + 1) * (last[1] - first[1] + 1);
            if count * 4 > (across * down) as i64 {
                cells.everywhere.push(number);
                continue;
            }
            for row in first[1]..=last[1] {
                for column in first[0]..=last[0] {
                    cells.lists[row as usize * across + column as usize].push(number);
                }
            }
        }
        cells
    }

    pub(crate) fn at(&self, pixel: [i32; 2]) -> impl Iterator<Item = usize> + '_ {
        let [column, row] = self.cell(pixel);
        let own = &self.lists[row * self.across + column];
        self.everywhere.iter().chain(own).map(|&number| number as usize)
    }

    /// Appends those that may cover a pixel between two, each once, in order.
    pub(crate) fn between(&self, first: [i32; 2], last: [i32; 2], numbers: &mut Vec<usize>) {
        let ([left, top], [right, bottom]) = (self.cell(first), self.cell(last));
        numbers.extend(self.everywhere.iter().map(|&number| number as usize));
        for row in top..=bottom {
            for own in &self.lists[row * self.across + left..=row * self.across + right] {
                numbers.extend(own.iter().map(|&number| number as usize));
            }
        }
        numbers.sort_unstable();
        numbers.dedup();
    }

    /// Column and row of a pixel's cell.
    fn cell(&self, [x, y]: [i32; 2]) -> [usize; 2] {
        let column = (x / self.side[0]).clamp(0, self.across as i32 - 1) as usize;
        let row = (y / self.side[1]).clamp(0, self.down as i32 - 1) as usize;
        [column, row]
    }
}
