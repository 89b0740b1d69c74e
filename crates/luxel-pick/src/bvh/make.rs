//! Making the leaves of a tree over triangles: what goes into which block.

use super::leaves::{
    BLOCK, FIRST_AT, GOES_ON, HAS_NUMBERS, HAS_OWN_ROWS, Leaves, Mesh, NUMBER_AT, Rows, SPAN,
};
use super::{Child, Node, WIDTH};
use crate::gather::vertices_in_rows;
use luxel_math::{Level, Simd, SimdLevel, dispatch_long, prelude::*, u32x8};
use luxel_pages::Pages;
use luxel_parallel::each;
use std::ops::Range;

/// Nodes whose leaves are made by one task.
const RUN: usize = 1 << 8;

/// Bytes for a triangle that a whole tree takes at most, where copies are left out if need be.
const MOST_BYTES: usize = 32;
/// Classes of leaves by what copies in them are worth, two for each power of two.
const CLASSES: usize = 1 << (32 - CLASS_AT);
const CLASS_AT: u32 = 22;

/// Leaves of a run of nodes.
#[derive(Clone)]
struct Made {
    words: Vec<u32>,
    /// Where each begins.
    starts: Vec<usize>,
    /// What copies in leaves of each class take, if there are any, in words.
    copies: Vec<u32>,
}

impl Made {
    const NOTHING: Self = Self { words: Vec::new(), starts: Vec::new(), copies: Vec::new() };

    #[inline(always)]
    fn new<S: Simd>(
        simd: S,
        nodes: &[Node],
        numbers: &[u32],
        mesh: &Mesh<'_>,
        copies: bool,
    ) -> Self {
        let mut made = Self::NOTHING;
        let (some, all) =
            leaves(nodes).fold((0, 0), |(some, all), run| (some + 1, all + run.len()));
        made.starts.reserve(some);
        // Four triangles have about six vertices.
        let mut blocks = Blocks::with_room(some + if copies { 6 } else { 4 } * all);
        made.copies.resize(if copies { CLASSES } else { 0 }, 0);
        for (run, area) in leaves(nodes).zip(areas(nodes)) {
            let (at, count) = (blocks.end, run.len());
            made.starts.push(at);
            if copies {
                blocks.append(simd, &numbers[run], mesh);
                let copied = of_copies(blocks.end - at, count);
                made.copies[class(area, copied)] += copied;
            } else {
                blocks.append_apart(simd, &numbers[run], mesh, Rows::Numbers);
            }
        }
        made.words = blocks.into_words();
        made
    }

    /// Takes back the copies of leaves below a class, and of those in it until so many words are saved.
    #[inline(always)]
    fn without<S: Simd>(
        &self,
        simd: S,
        nodes: &[Node],
        numbers: &[u32],
        mesh: &Mesh<'_>,
        (end, mut words): (usize, usize),
    ) -> Self {
        let mut made = Self::NOTHING;
        made.starts.reserve(self.starts.len());
        let mut blocks = Blocks::with_room(self.words.len());
        let length = self.words.len();
        let ends = self.starts.iter().skip(1).chain([&length]);
        let starts = self.starts.iter().zip(ends);
        for ((run, area), (&start, &stop)) in leaves(nodes).zip(areas(nodes)).zip(starts) {
            made.starts.push(blocks.end);
            let copied = of_copies(stop - start, run.len());
            let class = class(area, copied);
            if class > end || class == end && words == 0 {
                blocks.copy(&self.words[start..stop]);
            } else {
                blocks.append_apart(simd, &numbers[run], mesh, Rows::Numbers);
                words -= if class == end { words.min(copied as usize) } else { 0 };
            }
        }
        made.words = blocks.into_words();
        made
    }
}

/// What copies take in a leaf of so many words and triangles, in words.
fn of_copies(length: usize, count: usize) -> u32 {
    length.saturating_sub(1 + 4 * count) as u32
}

/// The class of a leaf whose box has this surface, halved: rays meet it in proportion to that.
fn class(area: f32, copied: u32) -> usize {
    // Not below 0, so that the bits are in the order of the numbers; finite or not, all have a class.
    ((area / copied as f32).abs().to_bits() >> CLASS_AT) as usize
}

/// The surfaces of leaves' boxes, halved, in the order of [`leaves`].
fn areas(nodes: &[Node]) -> impl Iterator<Item = f32> + Clone {
    nodes.iter().flat_map(|node| {
        let is_leaf = |slot: &usize| node.children[*slot].as_leaf().is_some_and(|(_, n)| n > 0);
        (0..WIDTH).filter(is_leaf).map(|slot| node.bounds(slot).half_area())
    })
}

/// Which numbers are in the leaves of a run of nodes.
fn leaves(nodes: &[Node]) -> impl Iterator<Item = Range<usize>> + Clone {
    let leaves = nodes.iter().flat_map(|node| &node.children).filter_map(|child| child.as_leaf());
    leaves.filter(|&(_, count)| count > 0).map(|(start, count)| start..start + count)
}

impl Leaves {
    /// Makes the leaves of a tree over numbers, and tells their nodes where they are. Vertices are
    /// copied, if at all, as far as all may take [`MOST_BYTES`] for a triangle.
    pub(super) fn new(nodes: &mut [Node], numbers: &[u32], mesh: &Mesh<'_>, copies: bool) -> Self {
        if !copies && leaves(nodes).all(|run| block_of(&numbers[run.clone()]).0 == run.len()) {
            return Self::of_numbers(nodes, numbers, mesh);
        }
        let level = SimdLevel::Auto.resolve().unwrap_or_else(|_| Level::baseline());
        let mut made = vec![Made::NOTHING; nodes.len().div_ceil(RUN)];
        each(nodes.chunks(RUN).zip(&mut made), &|(nodes, made)| {
            *made = dispatch_long!(level, simd => Made::new(simd, nodes, numbers, mesh, copies));
        });
        let length = |made: &[Made]| made.iter().map(|made| made.words.len()).sum::<usize>();
        let most = (MOST_BYTES * numbers.len()).saturating_sub(size_of_val(nodes)) / 4;
        let mut too_many = length(&made).saturating_sub(most);
        if copies && too_many > 0 {
            // Leaves that rays meet the least, for what copies in them take, do without, as many as
            // need be.
            let mut ends = vec![(0, 0); made.len()];
            for class in 0..CLASSES {
                for (made, end) in made.iter().zip(&mut ends) {
                    if too_many > 0 {
                        *end = (class, too_many);
                        too_many = too_many.saturating_sub(made.copies[class] as usize);
                    }
                }
            }
            each(nodes.chunks(RUN).zip(&mut made).zip(ends), &|((nodes, made), end)| {
                if made.copies[..=end.0].iter().any(|copied| *copied > 0) {
                    *made = dispatch_long!(level, simd => made.without(simd, nodes, numbers, mesh, end));
                }
            });
        }
        // The first word is no block's: a child that begins there is none.
        let mut words = Pages::zeroed(1 + length(&made) + BLOCK);
        let mut pieces = Vec::with_capacity(made.len());
        let (mut start, mut rest) = (1, &mut words[1..]);
        for (made, nodes) in made.iter().zip(nodes.chunks_mut(RUN)) {
            let (piece, more) = rest.split_at_mut(made.words.len());
            pieces.push((start, made, nodes, piece));
            (start, rest) = (start + made.words.len(), more);
        }
        each(pieces.into_iter(), &|(first, made, nodes, piece)| {
            piece.copy_from_slice(&made.words);
            let leaves = nodes.iter_mut().flat_map(|node| &mut node.children);
            let leaves = leaves.filter(|child| child.as_leaf().is_some_and(|(_, count)| count > 0));
            for (child, start) in leaves.zip(&made.starts) {
                *child = Child::block(first + start);
            }
        });
        Self { words, count: numbers.len() }
    }

    /// The same without copies, where each leaf is one block: then it is known where each begins.
    fn of_numbers(nodes: &mut [Node], numbers: &[u32], mesh: &Mesh<'_>) -> Self {
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
                if let Some((start, count)) = child.as_leaf().filter(|&(_, count)| count > 0) {
                    *child = Child::block(first + at);
                    write_numbers(&mut piece[at..], &numbers[start..start + count], mesh);
                    at += 1 + 4 * count;
                }
            }
        });
        Self { words, count: numbers.len() }
    }
}

/// The vertices of the block that is being filled, in lanes: who stored one and then looked at all
/// would wait for what was just stored.
#[derive(Clone, Copy)]
struct Filled<S: Simd> {
    first: u32,
    /// How many triangles there are.
    count: usize,
    /// The vertices' numbers.
    vertices: u32x8<S>,
    used: usize,
}

impl<S: Simd> Filled<S> {
    #[inline(always)]
    fn none(simd: S) -> Self {
        Self { first: 0, count: 0, vertices: u32x8::splat(simd, u32::MAX), used: 0 }
    }

    /// Takes a triangle, if it fits; its word.
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
            // The next one, if it isn't among those in use.
            let place = (found | 1 << used).trailing_zeros();
            vertices = lanes.simd_eq(place).select(vertex, vertices);
            used += usize::from(place as usize == used);
            word |= place << (3 * corner);
        }
        if used > WIDTH {
            return None;
        }
        *self = Self { first, count: self.count + 1, vertices, used };
        Some(word | (number - first) << NUMBER_AT)
    }
}

/// Blocks one after another.
struct Blocks {
    /// With room for a leaf beyond the end.
    words: Vec<u32>,
    end: usize,
}

/// What the blocks of a leaf take at most, and what is written beyond the last of them.
const ROOM: usize = 11 * WIDTH + BLOCK;

impl Blocks {
    /// With room for so many words.
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

    /// Appends the blocks of a leaf with copies of its vertices.
    #[inline(always)]
    fn append<S: Simd>(&mut self, simd: S, numbers: &[u32], mesh: &Mesh<'_>) {
        // What numbers too far apart begin new blocks for takes no more than rows for each triangle.
        self.make_room(11 * numbers.len() + BLOCK);
        let start = self.end;
        let mut filled = Filled::none(simd);
        for &number in numbers {
            let corners = mesh.triangles[number as usize];
            let mut word = filled.take(simd, number, corners);
            if word.is_none() {
                if filled.used >= 3 * filled.count && self.end == start && numbers.len() > 3 {
                    // Nothing is shared here.
                    self.append_apart(simd, numbers, mesh, Rows::Apart);
                    return;
                }
                self.finish(simd, &filled, mesh, GOES_ON);
                filled = Filled::none(simd);
                word = filled.take(simd, number, corners);
            }
            self.words[self.end + filled.count] = word.unwrap_or_default();
        }
        self.finish(simd, &filled, mesh, 0);
        if self.end - start > 1 + 10 * numbers.len() {
            self.end = start;
            self.append_apart(simd, numbers, mesh, Rows::Apart);
        }
    }

    /// Ends a block whose triangles' words are there.
    #[inline(always)]
    fn finish<S: Simd>(&mut self, simd: S, filled: &Filled<S>, mesh: &Mesh<'_>, more: u32) {
        let (count, used) = (filled.count, filled.used);
        let head = (count as u32).wrapping_sub(1) | (used as u32).wrapping_sub(1) << 3;
        self.words[self.end] = head | more | filled.first >> 3 << FIRST_AT;
        let at = self.end + 1 + count;
        let mut vertices = [0; WIDTH];
        filled.vertices.store_slice(&mut vertices);
        // Each row's end is written over by the next one.
        let rows = vertices_in_rows(simd, vertices, used, mesh.positions);
        for (row, values) in rows.into_iter().enumerate() {
            let at = at + row * used;
            values.bitcast::<u32x8<S>>().store_slice(&mut self.words[at..at + WIDTH]);
        }
        self.end = at + 3 * used;
    }

    /// The same with rows for each triangle.
    #[inline(always)]
    fn append_apart<S: Simd>(&mut self, simd: S, mut numbers: &[u32], mesh: &Mesh<'_>, rows: Rows) {
        self.make_room(11 * numbers.len() + BLOCK);
        while !numbers.is_empty() {
            let (count, _) = block_of(numbers);
            let words = &mut self.words[self.end..];
            if rows == Rows::Apart {
                write_apart(simd, words, numbers, mesh);
                self.end += 1 + 10 * count;
            } else {
                write_numbers(words, numbers, mesh);
                self.end += 1 + 4 * count;
            }
            numbers = &numbers[count..];
        }
    }
}

/// How many of some triangles a block with rows for each takes, and the number that it tells them
/// from.
fn block_of(numbers: &[u32]) -> (usize, u32) {
    let first = numbers.first().map_or(0, |number| number & !7);
    let fits = |number: &&u32| **number >= first && **number - first < SPAN;
    (numbers.iter().take(WIDTH).take_while(fits).count(), first)
}

/// Writes the head of a block with rows for each triangle, and its triangles' words; how many there
/// are.
#[inline(always)]
fn write_head(words: &mut [u32], numbers: &[u32], kind: u32) -> usize {
    let (count, first) = block_of(numbers);
    let more = if count < numbers.len() { GOES_ON } else { 0 };
    words[0] = (count as u32 - 1) | kind | more | HAS_OWN_ROWS | first >> 3 << FIRST_AT;
    for (word, &number) in words[1..=count].iter_mut().zip(numbers) {
        *word = (number - first) << NUMBER_AT;
    }
    count
}

/// Writes a block with rows of vertices' numbers.
fn write_numbers(words: &mut [u32], numbers: &[u32], mesh: &Mesh<'_>) {
    let count = write_head(words, numbers, HAS_NUMBERS);
    for (lane, &number) in numbers[..count].iter().enumerate() {
        for (corner, vertex) in mesh.triangles[number as usize].into_iter().enumerate() {
            words[1 + count + lane + corner * count] = vertex;
        }
    }
}

/// Writes a block with rows of corners, and anything beyond it.
#[inline(always)]
fn write_apart<S: Simd>(simd: S, words: &mut [u32], numbers: &[u32], mesh: &Mesh<'_>) {
    let count = write_head(words, numbers, 0);
    let mut vertices = [[0; WIDTH]; 3];
    for (lane, &number) in numbers[..count].iter().enumerate() {
        for (corner, vertex) in mesh.triangles[number as usize].into_iter().enumerate() {
            vertices[corner][lane % WIDTH] = vertex;
        }
    }
    for (corner, vertices) in vertices.into_iter().enumerate() {
        let rows = vertices_in_rows(simd, vertices, count, mesh.positions);
        for (axis, values) in rows.into_iter().enumerate() {
            let at = 1 + count + (3 * corner + axis) * count;
            values.bitcast::<u32x8<S>>().store_slice(&mut words[at..at + WIDTH]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bvh::leaves::{Head, block, corners, number};
    use crate::{Bvh, Quality};

    /// A sheet of two triangles a cell, row by row.
    fn sheet(side: u32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
        let place = |at: u32| [(at % side) as f32, (at / side) as f32, (at as f32 * 0.7).fract()];
        let positions = (0..side * side).map(place).collect();
        let cells = (0..side * (side - 1)).filter(|at| at % side != side - 1);
        let triangles =
            cells.flat_map(|at| [[at, at + 1, at + side], [at + 1, at + side + 1, at + side]]);
        (positions, triangles.collect())
    }

    /// The same triangles, none of which shares a vertex.
    fn apart(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
        let corners = triangles.as_flattened().iter().map(|&vertex| positions[vertex as usize]);
        let triangles = (0..triangles.len() as u32).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]);
        (corners.collect(), triangles.collect())
    }

    /// Which kinds of rows there are, after checking that each triangle is there once, with its
    /// corners.
    fn kinds(positions: &[[f32; 3]], triangles: &[[u32; 3]], quality: Quality) -> [usize; 3] {
        let bvh = Bvh::build(positions, triangles, quality).expect("there are few");
        let mut seen = vec![false; triangles.len()];
        let mut kinds = [0; 3];
        for child in bvh.nodes().iter().flat_map(|node| node.children) {
            let Some(start) = child.as_block().filter(|_| child != Child::NONE) else { continue };
            bvh.leaves().each_block(start, &mut |block| {
                kinds[Head::of(block).rows() as usize] += 1;
                for lane in 0..Head::of(block).count() {
                    let number = number(block, lane) as usize;
                    assert!(!std::mem::replace(&mut seen[number], true), "it is there twice");
                    let expected = triangles[number].map(|vertex| positions[vertex as usize]);
                    assert_eq!(corners(block, lane, positions, [0, 1, 2]), expected);
                }
            });
        }
        assert!(seen.into_iter().all(|seen| seen));
        assert!(bvh.memory() <= MOST_BYTES * triangles.len() + 4 * BLOCK);
        kinds
    }

    #[test]
    fn leaves_have_each_triangle_once_with_its_corners_and_bounded_memory() {
        let (positions, triangles) = sheet(60);
        let [shared, _, numbers] = kinds(&positions, &triangles, Quality::Thorough);
        assert!(shared > 500 && numbers == 0, "{shared} {numbers}");
        assert_eq!(kinds(&positions, &triangles, Quality::InOrder)[..2], [0, 0]);
        let (positions, triangles) = apart(&positions, &triangles);
        let [shared, apart, numbers] = kinds(&positions, &triangles, Quality::Thorough);
        assert!(shared == 0 && apart > 100 && numbers > 100, "{shared} {apart} {numbers}");
    }

    #[test]
    fn a_block_takes_what_it_can_tell_and_no_more() {
        let words = dispatch_long!(Level::baseline(), simd => {
            let mut filled = Filled::none(simd);
            let mut blocks = Blocks::with_room(0);
            let mut takes = |number, corners| {
                let word = filled.take(simd, number, corners);
                if let Some(word) = word {
                    blocks.words[filled.count] = word;
                }
                word.is_some().then_some(filled.used)
            };
            assert_eq!(takes(17, [3, 4, 5]), Some(3));
            assert_eq!(takes(18, [5, 4, 6]), Some(4));
            assert_eq!(takes(15, [3, 4, 5]), None, "below the lowest");
            assert_eq!(takes(16, [3, 4, 5]), Some(4), "rounded down");
            assert_eq!(takes(16 + SPAN, [3, 4, 5]), None, "too far above");
            assert_eq!(takes(15 + SPAN, [7, 8, 9]), Some(7));
            assert_eq!(takes(20, [10, 11, 3]), None, "one vertex too many");
            assert_eq!(takes(20, [10, 10, 3]), Some(8));
            let mesh = Mesh { positions: &[[1.0; 3]; 11], triangles: &[] };
            blocks.finish(simd, &filled, &mesh, 0);
            blocks.into_words()
        });
        let mut words = words;
        words.resize(BLOCK, 0);
        let block = block(&words, 0).unwrap();
        assert_eq!(Head::of(block).len(), 1 + 5 + 3 * 8);
        assert_eq!([0, 1, 2, 3, 4].map(|lane| number(block, lane)), [17, 18, 16, 15 + SPAN, 20]);
    }
}
