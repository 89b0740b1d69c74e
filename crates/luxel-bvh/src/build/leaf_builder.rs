//! Fills the leaves of a tree over triangles: which vertices go into which block.

use crate::pages::Pages;
use crate::tree::{
    BLOCK, Child, FIRST_AT, HAS_NUMBERS, HAS_OWN_ROWS, Leaves, MORE_FOLLOW, MeshRef, NUMBER_AT,
    Node, SPAN, VertexRows, WIDTH, load_vertices,
};
use luxel_math::{Level, Simd, SimdLevel, dispatch_long, prelude::*, u32x8};
use luxel_parallel::each;
use std::ops::Range;

/// Nodes whose leaves are built by one task.
const RUN: usize = 1 << 8;

/// The memory budget of a tree with copies, in bytes per triangle.
pub(crate) const MOST_BYTES: usize = 32;
/// Classes of leaves by the value of copies in them, two for each power of two.
const CLASSES: usize = 1 << (32 - CLASS_AT);
const CLASS_AT: u32 = 22;

/// The leaves of a run of nodes.
#[derive(Clone)]
struct LeafRun {
    words: Vec<u32>,
    /// The first word of each leaf.
    starts: Vec<usize>,
    /// The size of all copies in leaves of each class, in words; empty without copies.
    copies: Vec<u32>,
}

impl LeafRun {
    const EMPTY: Self = Self { words: Vec::new(), starts: Vec::new(), copies: Vec::new() };

    #[inline(always)]
    fn new<S: Simd>(
        simd: S,
        nodes: &[Node],
        numbers: &[u32],
        mesh: &MeshRef<'_>,
        copies: bool,
    ) -> Self {
        let mut built = Self::EMPTY;
        let (some, all) =
            leaves(nodes).fold((0, 0), |(some, all), run| (some + 1, all + run.len()));
        built.starts.reserve(some);
        // Four triangles have about six vertices.
        let mut blocks = BlockWriter::with_room(some + if copies { 6 } else { 4 } * all);
        built.copies.resize(if copies { CLASSES } else { 0 }, 0);
        for (run, area) in leaves(nodes).zip(areas(nodes)) {
            let (at, count) = (blocks.end, run.len());
            built.starts.push(at);
            if copies {
                blocks.append(simd, &numbers[run], mesh);
                let copied = of_copies(blocks.end - at, count);
                built.copies[class(area, copied)] += copied;
            } else {
                blocks.append_separate(simd, &numbers[run], mesh, VertexRows::Numbers);
            }
        }
        built.words = blocks.into_words();
        built
    }

    /// Removes the copies from leaves below a class, and from those of the class itself until `words`
    /// are saved.
    #[inline(always)]
    fn without<S: Simd>(
        &self,
        simd: S,
        nodes: &[Node],
        numbers: &[u32],
        mesh: &MeshRef<'_>,
        (end, mut words): (usize, usize),
    ) -> Self {
        let mut built = Self::EMPTY;
        built.starts.reserve(self.starts.len());
        let mut blocks = BlockWriter::with_room(self.words.len());
        let length = self.words.len();
        let ends = self.starts.iter().skip(1).chain([&length]);
        let starts = self.starts.iter().zip(ends);
        for ((run, area), (&start, &stop)) in leaves(nodes).zip(areas(nodes)).zip(starts) {
            built.starts.push(blocks.end);
            let copied = of_copies(stop - start, run.len());
            let class = class(area, copied);
            if class > end || class == end && words == 0 {
                blocks.copy(&self.words[start..stop]);
            } else {
                blocks.append_separate(simd, &numbers[run], mesh, VertexRows::Numbers);
                words -= if class == end { words.min(copied as usize) } else { 0 };
            }
        }
        built.words = blocks.into_words();
        built
    }
}

/// The size of the copies in a leaf of `length` words and `count` triangles, in words.
fn of_copies(length: usize, count: usize) -> u32 {
    length.saturating_sub(1 + 4 * count) as u32
}

/// The class of a leaf: half its box's surface area, to which the number of rays that reach it is
/// proportional, per word of copies.
fn class(area: f32, copied: u32) -> usize {
    // Bits of numbers that aren't negative are ordered as the numbers are.
    ((area / copied as f32).abs().to_bits() >> CLASS_AT) as usize
}

/// Half the surface areas of the leaves' boxes, in the order of [`leaves`].
fn areas(nodes: &[Node]) -> impl Iterator<Item = f32> + Clone {
    nodes.iter().flat_map(|node| {
        let is_leaf = |slot: &usize| node.children[*slot].as_items().is_some_and(|(_, n)| n > 0);
        (0..WIDTH).filter(is_leaf).map(|slot| node.aabb(slot).half_area())
    })
}

/// The items of the leaves of a run of nodes.
fn leaves(nodes: &[Node]) -> impl Iterator<Item = Range<usize>> + Clone {
    let leaves = nodes.iter().flat_map(|node| &node.children).filter_map(|child| child.as_items());
    leaves.filter(|&(_, count)| count > 0).map(|(start, count)| start..start + count)
}

/// Builds the leaves of a tree over triangle numbers and points the nodes to them. With `copies`,
/// leaves hold their vertices as far as the tree stays within [`MOST_BYTES`] per triangle.
///
/// The budget goes to the leaves whose boxes have the largest surface relative to the size of their
/// copies, since rays reach those most often. Denying copies to the leaves that took the most per
/// triangle instead hit long thin triangles, which most rays hit: on the uneven mesh of the
/// measurements random rays now take three fifths of that time.
pub(crate) fn build_leaves(
    nodes: &mut [Node],
    numbers: &[u32],
    mesh: &MeshRef<'_>,
    copies: bool,
) -> Leaves {
    if !copies && leaves(nodes).all(|run| block_of(&numbers[run.clone()]).0 == run.len()) {
        return build_numbers(nodes, numbers, mesh);
    }
    let level = SimdLevel::Auto.resolve().unwrap_or_else(|_| Level::baseline());
    let mut built = vec![LeafRun::EMPTY; nodes.len().div_ceil(RUN)];
    each(nodes.chunks(RUN).zip(&mut built), &|(nodes, built)| {
        *built = dispatch_long!(level, simd => LeafRun::new(simd, nodes, numbers, mesh, copies));
    });
    let length = |built: &[LeafRun]| built.iter().map(|built| built.words.len()).sum::<usize>();
    let most = (MOST_BYTES * numbers.len()).saturating_sub(size_of_val(nodes)) / 4;
    let mut too_many = length(&built).saturating_sub(most);
    if copies && too_many > 0 {
        // The leaves whose copies are worth the least do without.
        let mut ends = vec![(0, 0); built.len()];
        for class in 0..CLASSES {
            for (built, end) in built.iter().zip(&mut ends) {
                if too_many > 0 {
                    *end = (class, too_many);
                    too_many = too_many.saturating_sub(built.copies[class] as usize);
                }
            }
        }
        each(nodes.chunks(RUN).zip(&mut built).zip(ends), &|((nodes, built), end)| {
            if built.copies[..=end.0].iter().any(|copied| *copied > 0) {
                *built =
                    dispatch_long!(level, simd => built.without(simd, nodes, numbers, mesh, end));
            }
        });
    }
    // No block begins at word 0, which stands for an empty slot.
    let mut words = Pages::zeroed(1 + length(&built) + BLOCK);
    let mut pieces = Vec::with_capacity(built.len());
    let (mut start, mut rest) = (1, &mut words[1..]);
    for (built, nodes) in built.iter().zip(nodes.chunks_mut(RUN)) {
        let (piece, more) = rest.split_at_mut(built.words.len());
        pieces.push((start, built, nodes, piece));
        (start, rest) = (start + built.words.len(), more);
    }
    each(pieces.into_iter(), &|(first, built, nodes, piece)| {
        piece.copy_from_slice(&built.words);
        let leaves = nodes.iter_mut().flat_map(|node| &mut node.children);
        let leaves = leaves.filter(|child| child.as_items().is_some_and(|(_, count)| count > 0));
        for (child, start) in leaves.zip(&built.starts) {
            *child = Child::block(first + start);
        }
    });
    Leaves { words, count: numbers.len() }
}

/// Builds leaves without copies, each of one block, so that their lengths are known in advance.
fn build_numbers(nodes: &mut [Node], numbers: &[u32], mesh: &MeshRef<'_>) -> Leaves {
    let length = |run: Range<usize>| 1 + 4 * run.len();
    let all: usize = leaves(nodes).map(length).sum();
    let mut words = Pages::zeroed(1 + all + BLOCK);
    let mut pieces = Vec::with_capacity(nodes.len().div_ceil(RUN));
    let (mut start, mut rest) = (1, &mut words[1..]);
    for nodes in nodes.chunks_mut(RUN) {
        let (piece, more) = rest.split_at_mut(leaves(nodes).map(length).sum());
        let next = start + piece.len();
        pieces.push((start, nodes, piece));
        (start, rest) = (next, more);
    }
    each(pieces.into_iter(), &|(first, nodes, piece)| {
        let mut at = 0;
        for child in nodes.iter_mut().flat_map(|node| &mut node.children) {
            if let Some((start, count)) = child.as_items().filter(|&(_, count)| count > 0) {
                *child = Child::block(first + at);
                write_numbers(&mut piece[at..], &numbers[start..start + count], mesh);
                at += 1 + 4 * count;
            }
        }
    });
    Leaves { words, count: numbers.len() }
}
/// The block under construction.
///
/// Its vertex numbers stay in a register, where one comparison finds a vertex. In memory each lookup
/// would load as a whole what was just stored in parts, and stall.
#[derive(Clone, Copy)]
struct OpenBlock<S: Simd> {
    first: u32,
    /// The number of triangles.
    count: usize,
    /// Vertex numbers.
    vertices: u32x8<S>,
    used: usize,
}

impl<S: Simd> OpenBlock<S> {
    #[inline(always)]
    fn none(simd: S) -> Self {
        Self { first: 0, count: 0, vertices: u32x8::splat(simd, u32::MAX), used: 0 }
    }

    /// Adds a triangle if it fits; returns its word.
    #[inline(always)]
    fn take(&mut self, simd: S, number: u32, corners: [u32; 3]) -> Option<u32> {
        const LANES: [u32; WIDTH] = [0, 1, 2, 3, 4, 5, 6, 7];
        let lanes = u32x8::simd_from(simd, LANES);
        let first = if self.count == 0 { number & !7 } else { self.first };
        if self.count == WIDTH || number < first || number - first >= SPAN {
            return None;
        }
        let (mut vertices, mut used, mut word) = (self.vertices, self.used, 0);
        for corner in 0..3 {
            let vertex = u32x8::splat(simd, corners[corner]);
            let found = vertices.simd_eq(vertex).to_bitmask() as u32;
            // The next free lane, if the vertex isn't there yet.
            let lane = (found | 1 << used).trailing_zeros();
            vertices = lanes.simd_eq(lane).select(vertex, vertices);
            used += usize::from(lane as usize == used);
            word |= lane << (3 * corner);
        }
        if used > WIDTH {
            return None;
        }
        *self = Self { first, count: self.count + 1, vertices, used };
        Some(word | (number - first) << NUMBER_AT)
    }
}

/// Appends blocks to a list of words.
struct BlockWriter {
    /// Padded by at least a leaf beyond the end.
    words: Vec<u32>,
    end: usize,
}

/// The most that a leaf's blocks and writes beyond the last of them take.
const ROOM: usize = 11 * WIDTH + BLOCK;

impl BlockWriter {
    /// Reserves room for `words`.
    fn with_room(words: usize) -> Self {
        Self { words: vec![0; words + ROOM], end: 0 }
    }

    fn into_words(mut self) -> Vec<u32> {
        self.words.truncate(self.end);
        self.words
    }

    fn copy(&mut self, words: &[u32]) {
        self.make_room(words.len());
        self.words[self.end..self.end + words.len()].copy_from_slice(words);
        self.end += words.len();
    }

    #[inline(always)]
    fn make_room(&mut self, words: usize) {
        if self.words.len() < self.end + words {
            self.words.resize(2 * (self.end + words), 0);
        }
    }

    /// Appends a leaf with copies of its vertices.
    #[inline(always)]
    fn append<S: Simd>(&mut self, simd: S, numbers: &[u32], mesh: &MeshRef<'_>) {
        // Triangle numbers too far apart begin new blocks, which take no more than separate rows.
        self.make_room(11 * numbers.len() + BLOCK);
        let start = self.end;
        let mut open = OpenBlock::none(simd);
        for &number in numbers {
            let corners = mesh.triangles[number as usize];
            let mut word = open.take(simd, number, corners);
            if word.is_none() {
                if open.used >= 3 * open.count && self.end == start && numbers.len() > 3 {
                    // No vertex is shared here.
                    self.append_separate(simd, numbers, mesh, VertexRows::Separate);
                    return;
                }
                self.finish(simd, &open, mesh, MORE_FOLLOW);
                open = OpenBlock::none(simd);
                word = open.take(simd, number, corners);
            }
            self.words[self.end + open.count] = word.unwrap_or_default();
        }
        self.finish(simd, &open, mesh, 0);
        if self.end - start > 1 + 10 * numbers.len() {
            self.end = start;
            self.append_separate(simd, numbers, mesh, VertexRows::Separate);
        }
    }

    /// Completes a block whose triangle words are already written.
    #[inline(always)]
    fn finish<S: Simd>(&mut self, simd: S, open: &OpenBlock<S>, mesh: &MeshRef<'_>, more: u32) {
        let (count, used) = (open.count, open.used);
        let head = (count as u32).wrapping_sub(1) | (used as u32).wrapping_sub(1) << 3;
        self.words[self.end] = head | more | open.first >> 3 << FIRST_AT;
        let at = self.end + 1 + count;
        let mut vertices = [0; WIDTH];
        open.vertices.store_slice(&mut vertices);
        // Each row overwrites the excess of the one before.
        let rows = load_vertices(simd, vertices, used, mesh.positions);
        for (row, values) in rows.into_iter().enumerate() {
            let at = at + row * used;
            values.bitcast::<u32x8<S>>().store_slice(&mut self.words[at..at + WIDTH]);
        }
        self.end = at + 3 * used;
    }

    /// Appends a leaf with separate rows.
    #[inline(always)]
    fn append_separate<S: Simd>(
        &mut self,
        simd: S,
        mut numbers: &[u32],
        mesh: &MeshRef<'_>,
        rows: VertexRows,
    ) {
        self.make_room(11 * numbers.len() + BLOCK);
        while !numbers.is_empty() {
            let (count, _) = block_of(numbers);
            let words = &mut self.words[self.end..];
            if rows == VertexRows::Separate {
                write_separate(simd, words, numbers, mesh);
                self.end += 1 + 10 * count;
            } else {
                write_numbers(words, numbers, mesh);
                self.end += 1 + 4 * count;
            }
            numbers = &numbers[count..];
        }
    }
}

/// How many of `numbers` fit into one block with separate rows, and the block's first number.
fn block_of(numbers: &[u32]) -> (usize, u32) {
    let first = numbers.first().map_or(0, |number| number & !7);
    let fits = |number: &&u32| **number >= first && **number - first < SPAN;
    (numbers.iter().take(WIDTH).take_while(fits).count(), first)
}

/// Writes the header of a block with separate rows and its triangle words; returns their count.
#[inline(always)]
fn write_header(words: &mut [u32], numbers: &[u32], kind: u32) -> usize {
    let (count, first) = block_of(numbers);
    let more = if count < numbers.len() { MORE_FOLLOW } else { 0 };
    words[0] = (count as u32 - 1) | kind | more | HAS_OWN_ROWS | first >> 3 << FIRST_AT;
    for (word, &number) in words[1..=count].iter_mut().zip(numbers) {
        *word = (number - first) << NUMBER_AT;
    }
    count
}

/// Writes a block with rows of vertex numbers.
fn write_numbers(words: &mut [u32], numbers: &[u32], mesh: &MeshRef<'_>) {
    let count = write_header(words, numbers, HAS_NUMBERS);
    for (lane, &number) in numbers[..count].iter().enumerate() {
        for (corner, vertex) in mesh.triangles[number as usize].into_iter().enumerate() {
            words[1 + count + lane + corner * count] = vertex;
        }
    }
}

/// Writes a block with rows of corners; overwrites what follows it.
#[inline(always)]
fn write_separate<S: Simd>(simd: S, words: &mut [u32], numbers: &[u32], mesh: &MeshRef<'_>) {
    let count = write_header(words, numbers, 0);
    let mut vertices = [[0; WIDTH]; 3];
    for (lane, &number) in numbers[..count].iter().enumerate() {
        for (corner, vertex) in mesh.triangles[number as usize].into_iter().enumerate() {
            vertices[corner][lane % WIDTH] = vertex;
        }
    }
    for (corner, vertices) in vertices.into_iter().enumerate() {
        let rows = load_vertices(simd, vertices, count, mesh.positions);
        for (axis, values) in rows.into_iter().enumerate() {
            let at = 1 + count + (3 * corner + axis) * count;
            values.bitcast::<u32x8<S>>().store_slice(&mut words[at..at + WIDTH]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tree::block_at;

    #[test]
    fn a_block_takes_what_it_can_express_and_no_more() {
        let words = dispatch_long!(Level::baseline(), simd => {
            let mut open = OpenBlock::none(simd);
            let mut blocks = BlockWriter::with_room(0);
            let mut takes = |number, corners| {
                let word = open.take(simd, number, corners);
                if let Some(word) = word {
                    blocks.words[open.count] = word;
                }
                word.is_some().then_some(open.used)
            };
            assert_eq!(takes(17, [3, 4, 5]), Some(3));
            assert_eq!(takes(18, [5, 4, 6]), Some(4));
            assert_eq!(takes(15, [3, 4, 5]), None, "below the lowest");
            assert_eq!(takes(16, [3, 4, 5]), Some(4), "rounded down");
            assert_eq!(takes(16 + SPAN, [3, 4, 5]), None, "too far above");
            assert_eq!(takes(15 + SPAN, [7, 8, 9]), Some(7));
            assert_eq!(takes(20, [10, 11, 3]), None, "one vertex too many");
            assert_eq!(takes(20, [10, 10, 3]), Some(8));
            let mesh = MeshRef { positions: &[[1.0; 3]; 11], triangles: &[] };
            blocks.finish(simd, &open, &mesh, 0);
            blocks.into_words()
        });
        let mut words = words;
        words.resize(BLOCK, 0);
        let block = block_at(&words, 0).expect("there is one");
        assert_eq!(block.header().len(), 1 + 5 + 3 * 8);
        assert_eq!([0, 1, 2, 3, 4].map(|lane| block.triangle(lane)), [17, 18, 16, 15 + SPAN, 20]);
    }
}
