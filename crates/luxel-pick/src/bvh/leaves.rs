//! The leaves of a tree over triangles: blocks of up to eight, one after another in one list of
//! words.
//!
//! What a ray waits for in a large tree is memory, so a block holds the places of its triangles'
//! vertices: neighbours share most of theirs, and four triangles have about six. A block is
//!
//! | words | what |
//! | --- | --- |
//! | 1 | its [`Head`] |
//! | a triangle each | three bits for each corner's vertex in the block; above them the triangle's number, from the first that the head tells |
//! | three rows, a vertex each | x of all vertices, then y, then z |
//!
//! Eight vertices are the lanes of a vector: what a ray asks of them is computed once for each, and
//! comes to the corners of triangles by permuting lanes. Triangles that share too little have rows of
//! corners instead, x, y and z of the first ones, the second ones, the third ones. Where copies would
//! take more memory than a tree may, leaves where rays come the least have only the numbers of
//! their vertices, a row for each corner. A leaf that doesn't fit into one block goes on in the next.

use super::{Box3, MAX_TRIANGLES, WIDTH};
use luxel_math::{Simd, prelude::*, u32x8};
use luxel_pages::Pages;

/// The longest block; lists end with as much room, so that this many words can be read wherever one
/// begins.
pub(crate) const BLOCK: usize = 1 + WIDTH + 9 * WIDTH;
/// A block and what follows.
pub(crate) type Block = [u32; BLOCK];

/// What a block begins with: three bits for the triangles, less one, three for the vertices, less
/// one, whether the leaf goes on, whether triangles have rows of their own, and an eighth of the lowest
/// number, rounded down.
#[derive(Clone, Copy)]
pub(crate) struct Head(u32);

/// What is in a block's rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rows {
    /// Vertices that triangles share.
    Shared,
    /// The corners of each triangle.
    Apart,
    /// Vertices' numbers.
    Numbers,
}

pub(super) const GOES_ON: u32 = 1 << 6;
pub(super) const HAS_OWN_ROWS: u32 = 1 << 7;
/// With their own rows, triangles have the numbers of vertices in them.
pub(super) const HAS_NUMBERS: u32 = 1 << 3;
pub(super) const FIRST_AT: u32 = 8;
/// Of a triangle's word, where its number begins.
pub(super) const NUMBER_AT: u32 = 9;
/// Numbers of triangles from the first of a block on.
pub(super) const SPAN: u32 = 1 << (32 - NUMBER_AT);

const _: () = assert!(MAX_TRIANGLES.div_ceil(WIDTH) <= 1 << (32 - FIRST_AT));

impl Head {
    #[inline(always)]
    pub(crate) fn of(block: &Block) -> Self {
        Self(block[0])
    }

    /// How many triangles there are.
    #[inline(always)]
    pub(crate) fn count(self) -> usize {
        (self.0 & 7) as usize + 1
    }

    /// Words of a row.
    #[inline(always)]
    fn row(self) -> usize {
        if self.0 & HAS_OWN_ROWS == 0 { (self.0 >> 3 & 7) as usize + 1 } else { self.count() }
    }

    #[inline(always)]
    pub(crate) fn rows(self) -> Rows {
        if self.0 & HAS_OWN_ROWS == 0 {
            Rows::Shared
        } else if self.0 & HAS_NUMBERS == 0 {
            Rows::Apart
        } else {
            Rows::Numbers
        }
    }

    /// Whether the leaf has another block after this one.
    #[inline(always)]
    pub(crate) fn goes_on(self) -> bool {
        self.0 & GOES_ON != 0
    }

    #[inline(always)]
    fn first(self) -> u32 {
        self.0 >> FIRST_AT << 3
    }

    /// How many words the block has.
    #[inline(always)]
    pub(crate) fn len(self) -> usize {
        1 + self.count() + if self.rows() == Rows::Apart { 9 } else { 3 } * self.row()
    }
}

/// A block and what follows.
#[inline(always)]
pub(crate) fn block(words: &[u32], start: usize) -> Option<&Block> {
    words.get(start..)?.first_chunk()
}

/// Eight words from one of a block's rows on; the first of them are the row.
#[inline(always)]
pub(crate) fn row(block: &Block, row: usize) -> [u32; WIDTH] {
    let head = Head::of(block);
    let start = 1 + head.count() + row.min(8) * head.row();
    let mut words = [0; WIDTH];
    words.copy_from_slice(&block[start..start + WIDTH]);
    words
}

/// Whether a lane has a triangle, from the eighth less their count on.
const FILLED: [u32; 2 * WIDTH] = {
    let mut filled = [0; 2 * WIDTH];
    let mut lane = 0;
    while lane < WIDTH {
        filled[lane] = u32::MAX;
        lane += 1;
    }
    filled
};

/// The triangles' words; 0 in lanes beyond them, since what follows are no numbers to compute with:
/// some processors take a hundred times as long for those near 0.
#[inline(always)]
pub(crate) fn triangle_words<S: Simd>(simd: S, block: &Block) -> u32x8<S> {
    let mut filled = [0; WIDTH];
    let start = WIDTH - Head::of(block).count();
    filled.copy_from_slice(&FILLED[start..start + WIDTH]);
    let [_, a, b, c, d, e, f, g, h, ..] = *block;
    u32x8::simd_from(simd, [a, b, c, d, e, f, g, h]) & u32x8::simd_from(simd, filled)
}

/// The number of one of a block's triangles.
#[inline(always)]
pub(crate) fn number(block: &Block, lane: usize) -> u32 {
    Head::of(block).first() + (block[1 + (lane & (WIDTH - 1))] >> NUMBER_AT)
}

/// Where a block has a corner of a triangle: x, which y and z follow at a distance of a row; or the
/// number of its vertex.
#[inline(always)]
fn place(block: &Block, lane: usize, corner: usize) -> usize {
    let head = Head::of(block);
    let start = 1 + head.count();
    let lane = lane & (WIDTH - 1);
    match head.rows() {
        Rows::Shared => start + (block[1 + lane] >> (3 * corner) & 7) as usize,
        Rows::Apart => start + 3 * corner * head.row() + lane,
        Rows::Numbers => start + corner * head.row() + lane,
    }
}

/// A triangle's corners, each with its axes in a certain order: who indexed a copy by axis would wait
/// for what was just stored.
#[inline(always)]
pub(crate) fn corners(
    block: &Block,
    lane: usize,
    positions: &[[f32; 3]],
    axes: [usize; 3],
) -> [[f32; 3]; 3] {
    let head = Head::of(block);
    let mut corners = [[0.0; 3]; 3];
    for corner in 0..3 {
        let place = place(block, lane, corner);
        for (to, axis) in axes.into_iter().enumerate() {
            corners[corner][to] = if head.rows() == Rows::Numbers {
                positions[block[place] as usize][axis]
            } else {
                f32::from_bits(block[place + axis * head.row()])
            };
        }
    }
    corners
}

/// What leaves are made of.
pub(super) struct Mesh<'m> {
    pub(super) positions: &'m [[f32; 3]],
    pub(super) triangles: &'m [[u32; 3]],
}

/// The blocks of all leaves, a leaf's one after another.
#[derive(Clone, Debug, Default)]
pub(crate) struct Leaves {
    pub(super) words: Pages<u32>,
    /// How many triangles are in them.
    pub(crate) count: usize,
}

impl Leaves {
    /// All of them.
    #[inline]
    pub(crate) fn words(&self) -> &[u32] {
        &self.words
    }

    /// Visits a leaf's blocks.
    pub(crate) fn each_block(&self, mut start: usize, visit: &mut dyn FnMut(&Block)) {
        let words = self.words();
        while let Some(block) = block(words, start) {
            visit(block);
            let head = Head::of(block);
            if !head.goes_on() {
                return;
            }
            start += head.len();
        }
    }

    /// What they take, in bytes.
    pub(crate) fn memory(&self) -> usize {
        size_of_val(&self.words[..])
    }
}

impl Leaves {
    /// Takes over where a leaf's vertices are now; the box around its triangles.
    pub(super) fn refit(&mut self, mut start: usize, mesh: &Mesh<'_>) -> Box3 {
        let mut bounds = Box3::EMPTY;
        while let Some(block) = block(&self.words, start).copied() {
            let head = Head::of(&block);
            for lane in 0..head.count() {
                let vertices = mesh.triangles[number(&block, lane) as usize];
                let corners = vertices.map(|vertex| mesh.positions[vertex as usize]);
                bounds = bounds.union(&Box3::around(corners));
                if head.rows() == Rows::Numbers {
                    continue;
                }
                for (corner, position) in corners.iter().enumerate() {
                    let place = start + place(&block, lane, corner);
                    for axis in 0..3 {
                        self.words[place + axis * head.row()] = position[axis].to_bits();
                    }
                }
            }
            if !head.goes_on() {
                break;
            }
            start += head.len();
        }
        bounds
    }
}
