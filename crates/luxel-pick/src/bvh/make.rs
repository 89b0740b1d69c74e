//! Making the leaves of a tree over triangles: what goes into which block.

use super::leaves::{
    BLOCK, FIRST_AT, GOES_ON, HAS_NUMBERS, HAS_OWN_ROWS, Leaves, Mesh, NUMBER_AT, Rows, SPAN,
};
use super::{Child, Node, WIDTH};
use luxel_pages::Pages;
use luxel_parallel::each;
use std::ops::Range;

/// Nodes whose leaves are made by one task.
const RUN: usize = 1 << 10;

/// Bytes for a triangle that a whole tree takes at most, where copies are left out if need be.
const MOST_BYTES: usize = 32;
/// Classes of leaves by what they take for a triangle, in quarters of a word.
const CLASSES: usize = 48;

/// Leaves of a run of nodes.
#[derive(Clone)]
struct Made {
    words: Vec<u32>,
    /// Where each begins.
    starts: Vec<usize>,
    /// What leaves of each class take beyond what they would without copies.
    beyond: [usize; CLASSES],
}

impl Made {
    const NOTHING: Self = Self { words: Vec::new(), starts: Vec::new(), beyond: [0; CLASSES] };

    fn new(nodes: &[Node], numbers: &[u32], mesh: &Mesh<'_>, copies: bool) -> Self {
        let mut made = Self::NOTHING;
        let (some, all) =
            leaves(nodes).fold((0, 0), |(some, all), run| (some + 1, all + run.len()));
        made.starts.reserve(some);
        // Four triangles have about six vertices.
        made.words.reserve(some + if copies { 6 } else { 4 } * all);
        for run in leaves(nodes) {
            let count = run.len();
            let at = made.words.len();
            made.starts.push(at);
            if copies {
                append(&mut made.words, &numbers[run], mesh);
                let length = made.words.len() - at;
                made.beyond[class(length, count)] += length.saturating_sub(1 + 4 * count);
            } else {
                append_apart(&mut made.words, &numbers[run], mesh, Rows::Numbers);
            }
        }
        made
    }

    /// Takes back the copies of leaves from a class on.
    fn without(&self, nodes: &[Node], numbers: &[u32], mesh: &Mesh<'_>, end: usize) -> Self {
        let mut made = Self::NOTHING;
        made.starts.reserve(self.starts.len());
        made.words.reserve(self.words.len());
        let length = self.words.len();
        let ends = self.starts.iter().skip(1).chain([&length]);
        for ((run, &start), &stop) in leaves(nodes).zip(&self.starts).zip(ends) {
            made.starts.push(made.words.len());
            if class(stop - start, run.len()) < end {
                made.words.extend_from_slice(&self.words[start..stop]);
            } else {
                append_apart(&mut made.words, &numbers[run], mesh, Rows::Numbers);
            }
        }
        made
    }
}

/// The class of a leaf of so many words and triangles.
fn class(length: usize, count: usize) -> usize {
    (length * 4 / count).min(CLASSES - 1)
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
        let mut made = vec![Made::NOTHING; nodes.len().div_ceil(RUN)];
        each(nodes.chunks(RUN).zip(&mut made), &|(nodes, made)| {
            *made = Made::new(nodes, numbers, mesh, copies);
        });
        let length = |made: &[Made]| made.iter().map(|made| made.words.len()).sum::<usize>();
        let most = (MOST_BYTES * numbers.len()).saturating_sub(size_of_val(nodes)) / 4;
        let mut too_many = length(&made).saturating_sub(most);
        if copies && too_many > 0 {
            // Leaves that take the most for a triangle do without, as many as need be.
            let mut ends = vec![CLASSES; made.len()];
            for class in (0..CLASSES).rev() {
                for (made, end) in made.iter().zip(&mut ends) {
                    if too_many > 0 {
                        *end = class;
                        too_many = too_many.saturating_sub(made.beyond[class]);
                    }
                }
            }
            each(nodes.chunks(RUN).zip(&mut made).zip(ends), &|((nodes, made), end)| {
                if made.beyond[end..].iter().any(|beyond| *beyond > 0) {
                    *made = made.without(nodes, numbers, mesh, end);
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
                    write(&mut piece[at..], &numbers[start..start + count], mesh, Rows::Numbers);
                    at += 1 + 4 * count;
                }
            }
        });
        Self { words, count: numbers.len() }
    }
}

/// The block that is being filled.
struct Filled {
    first: u32,
    /// Words of triangles.
    triangles: [u32; WIDTH],
    count: usize,
    /// The vertices' numbers.
    vertices: [u32; WIDTH],
    used: usize,
}

impl Filled {
    const NONE: Self =
        Self { first: 0, triangles: [0; WIDTH], count: 0, vertices: [u32::MAX; WIDTH], used: 0 };

    /// Takes a triangle, if it fits.
    #[inline(always)]
    fn take(&mut self, number: u32, corners: [u32; 3]) -> bool {
        let first = if self.count == 0 { number & !7 } else { self.first };
        let (mut used, mut word) = (self.used, 0);
        if self.count == WIDTH || number < first || number - first >= SPAN {
            return false;
        }
        for (corner, vertex) in corners.into_iter().enumerate() {
            let mut found = 0;
            for place in 0..WIDTH {
                found |= u32::from(self.vertices[place] == vertex) << place;
            }
            // What a triangle that didn't fit has left behind is beyond those in use.
            let mut place = found.trailing_zeros() as usize;
            if place >= used {
                if used == WIDTH {
                    return false;
                }
                self.vertices[used] = vertex;
                place = used;
                used += 1;
            }
            word |= (place as u32) << (3 * corner);
        }
        self.triangles[self.count] = word | (number - first) << NUMBER_AT;
        (self.first, self.used) = (first, used);
        self.count += 1;
        true
    }

    /// Appends it as a block; where its head is.
    fn append(&self, words: &mut Vec<u32>, positions: &[[f32; 3]]) -> usize {
        let at = words.len();
        words.push(
            (self.count - 1) as u32 | (self.used as u32 - 1) << 3 | self.first >> 3 << FIRST_AT,
        );
        words.extend_from_slice(&self.triangles[..self.count]);
        let mut rows = [[0; WIDTH]; 3];
        for (place, &vertex) in self.vertices[..self.used].iter().enumerate() {
            let position = positions[vertex as usize];
            for axis in 0..3 {
                rows[axis][place % WIDTH] = position[axis].to_bits();
            }
        }
        for row in rows {
            words.extend_from_slice(&row[..self.used]);
        }
        at
    }
}

/// Appends the blocks of a leaf with copies of its vertices.
fn append(words: &mut Vec<u32>, numbers: &[u32], mesh: &Mesh<'_>) {
    let start = words.len();
    let mut filled = Filled::NONE;
    for &number in numbers {
        let corners = mesh.triangles[number as usize];
        if !filled.take(number, corners) {
            if filled.used >= 3 * filled.count && words.len() == start && numbers.len() > 3 {
                // Nothing is shared here.
                append_apart(words, numbers, mesh, Rows::Apart);
                return;
            }
            let at = filled.append(words, mesh.positions);
            words[at] |= GOES_ON;
            filled = Filled::NONE;
            filled.take(number, corners);
        }
    }
    filled.append(words, mesh.positions);
    if words.len() - start > 1 + 10 * numbers.len() {
        words.truncate(start);
        append_apart(words, numbers, mesh, Rows::Apart);
    }
}

/// The same with rows for each triangle.
fn append_apart(words: &mut Vec<u32>, mut numbers: &[u32], mesh: &Mesh<'_>, rows: Rows) {
    while !numbers.is_empty() {
        let (count, _) = block_of(numbers);
        let at = words.len();
        words.resize(at + 1 + if rows == Rows::Apart { 10 } else { 4 } * count, 0);
        write(&mut words[at..], numbers, mesh, rows);
        numbers = &numbers[count..];
    }
}

/// How many of some triangles a block with rows for each takes, and the number that it tells them
/// from.
fn block_of(numbers: &[u32]) -> (usize, u32) {
    let first = numbers.first().map_or(0, |number| number & !7);
    let fits = |number: &&u32| **number >= first && **number - first < SPAN;
    (numbers.iter().take(WIDTH).take_while(fits).count(), first)
}

/// Writes a block with rows for each triangle.
fn write(words: &mut [u32], numbers: &[u32], mesh: &Mesh<'_>, rows: Rows) {
    let (count, first) = block_of(numbers);
    let more = if count < numbers.len() { GOES_ON } else { 0 };
    let kind = if rows == Rows::Numbers { HAS_NUMBERS } else { 0 };
    words[0] = (count as u32 - 1) | kind | more | HAS_OWN_ROWS | first >> 3 << FIRST_AT;
    for (lane, &number) in numbers[..count].iter().enumerate() {
        words[1 + lane] = (number - first) << NUMBER_AT;
        for (corner, vertex) in mesh.triangles[number as usize].into_iter().enumerate() {
            let place = 1 + count + lane;
            if rows == Rows::Numbers {
                words[place + corner * count] = vertex;
                continue;
            }
            let position = mesh.positions[vertex as usize];
            for axis in 0..3 {
                words[place + (3 * corner + axis) * count] = position[axis].to_bits();
            }
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
        let mut filled = Filled::NONE;
        assert!(filled.take(17, [3, 4, 5]));
        assert!(filled.take(18, [5, 4, 6]) && filled.used == 4);
        assert!(!filled.take(15, [3, 4, 5]), "below the lowest");
        assert!(filled.take(16, [3, 4, 5]), "rounded down");
        assert!(!filled.take(16 + SPAN, [3, 4, 5]), "too far above");
        assert!(filled.take(15 + SPAN, [7, 8, 9]) && filled.used == 7);
        assert!(!filled.take(20, [10, 11, 3]), "one vertex too many");
        assert!(filled.take(20, [10, 10, 3]) && filled.used == 8);
        let mut words = Vec::new();
        filled.append(&mut words, &[[1.0; 3]; 11]);
        words.resize(BLOCK, 0);
        let block = block(&words, 0).unwrap();
        assert_eq!(Head::of(block).len(), 1 + 5 + 3 * 8);
        assert_eq!([0, 1, 2, 3, 4].map(|lane| number(block, lane)), [17, 18, 16, 15 + SPAN, 20]);
    }
}
