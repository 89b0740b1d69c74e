//! A shallow tree over the drawn points of a mesh, for exact searches of the outermost ones.
//!
//! Leaves hold [`LEAF`] points, nodes [`WIDTH`] children with a [`Dop`] of each: 1.9 bytes a point
//! in all. Points are taken in the mesh's own order, which in most files keeps neighbours together,
//! so that nothing is sorted and no list of points is needed. Where it doesn't, or where some
//! positions aren't drawn, a list of 4 bytes a point gives the order.

mod dop;

pub(crate) use dop::nearest_sides;

use crate::Mesh;
use dop::{Dop, SIDES};
use luxel_parallel::gather;
use std::ops::Range;

/// Points of a leaf. With 32, fits of 50 000 points take a tenth less time, and the tree twice the
/// memory.
pub(crate) const LEAF: usize = 64;
/// Children of a node.
pub(crate) const WIDTH: usize = 8;

/// How many leaves one thread takes at a time, and how many points.
const LEAVES: usize = 64;
const POINTS: usize = LEAF * LEAVES;

/// Meshes of fewer leaves keep their own order, whatever it is.
const LEAST_SORTED: usize = 16;
/// Leaves that are larger than this part of the mesh, in the mean of their extents, are scattered.
/// For surfaces in order it is about one by the root of the number of leaves; at random it is 0.9.
const SCATTERED: f64 = 0.25;

/// The polytopes of a node's children, side by side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    pub(crate) reaches: [[f32; WIDTH]; SIDES],
    /// How many there are.
    pub(crate) children: u32,
}

impl Node {
    fn of(children: &[Dop]) -> Self {
        let mut reaches = [[f32::NEG_INFINITY; WIDTH]; SIDES];
        for (at, child) in children.iter().enumerate() {
            for (reaches, reach) in reaches.iter_mut().zip(child.reaches) {
                reaches[at] = reach;
            }
        }
        Self { reaches, children: children.len() as u32 }
    }

    fn children(&self) -> impl Iterator<Item = Dop> {
        (0..self.children as usize).map(|at| Dop { reaches: self.reaches.map(|side| side[at]) })
    }

    fn union(&self) -> Dop {
        self.children().fold(Dop::default(), |all, child| all.union(&child))
    }
}

/// The drawn points of a mesh, and polytopes around them.
#[derive(Debug)]
pub(crate) struct PointTree {
    /// The positions of the points by number, leaf by leaf; `None`: all, as the mesh has them.
    order: Option<Vec<u32>>,
    points: usize,
    /// The lowest and the highest coordinates.
    bounds: [[f32; 3]; 2],
    /// From the parents of leaves up to the root. A tree of one leaf has none.
    levels: Vec<Vec<Node>>,
}

impl PointTree {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let drawn = mesh.drawn_positions();
        let mut order = drawn.contains(&false).then(|| {
            let numbers = (0..drawn.len() as u32).zip(&drawn);
            numbers.filter(|(_, drawn)| **drawn).map(|(number, _)| number).collect::<Vec<_>>()
        });
        let points = order.as_ref().map_or(drawn.len(), Vec::len);
        drop(drawn);
        let mut leaves = leaves(mesh, order.as_deref(), points);
        let bounds = leaves.iter().fold(Dop::default(), |all, leaf| all.union(leaf)).bounds();
        if is_scattered(&leaves, bounds) {
            order = Some(along_a_curve(mesh, order, bounds));
            leaves = self::leaves(mesh, order.as_deref(), points);
        }
        let mut levels: Vec<Vec<Node>> = Vec::new();
        let mut children = leaves;
        while children.len() > 1 {
            let nodes: Vec<Node> = children.chunks(WIDTH).map(Node::of).collect();
            children = nodes.iter().map(Node::union).collect();
            levels.push(nodes);
        }
        Self { order, points, bounds, levels }
    }

    /// How many points there are.
    pub(crate) fn len(&self) -> usize {
        self.points
    }

    /// The lowest and the highest coordinates, without the mesh's origin.
    pub(crate) fn bounds(&self) -> [[f32; 3]; 2] {
        self.bounds
    }

    /// From the parents of leaves up to the root; child `c` of node `n` is node, or leaf,
    /// `WIDTH n + c` of the level below. Without levels there is one leaf at most.
    pub(crate) fn levels(&self) -> &[Vec<Node>] {
        &self.levels
    }

    /// The points of a leaf, as the mesh has them, without its origin; in `room` if they have to be
    /// gathered.
    #[inline]
    pub(crate) fn leaf<'a>(
        &self,
        mesh: &'a Mesh,
        leaf: usize,
        room: &'a mut [[f32; 3]; LEAF],
    ) -> &'a [[f32; 3]] {
        let first = LEAF * leaf;
        points_of(mesh, self.order.as_deref(), first..self.points.min(first + LEAF), room)
    }
}

/// A few points, one after the other.
#[inline]
fn points_of<'a>(
    mesh: &'a Mesh,
    order: Option<&[u32]>,
    points: Range<usize>,
    room: &'a mut [[f32; 3]; LEAF],
) -> &'a [[f32; 3]] {
    let Some(order) = order else { return &mesh.positions[points] };
    let room = &mut room[..points.len()];
    for (position, &number) in room.iter_mut().zip(&order[points]) {
        *position = mesh.positions[number as usize];
    }
    room
}

fn leaves(mesh: &Mesh, order: Option<&[u32]>, points: usize) -> Vec<Dop> {
    gather(points.div_ceil(LEAF), LEAVES, &|task, leaves| {
        let mut room = [[0.0; 3]; LEAF];
        leaves.extend(task.map(|leaf| {
            let first = LEAF * leaf;
            Dop::of(points_of(mesh, order, first..points.min(first + LEAF), &mut room))
        }));
    })
}

/// Whether leaves reach over much of the mesh, so that a search would have to open most of them.
fn is_scattered(leaves: &[Dop], bounds: [[f32; 3]; 2]) -> bool {
    let size = |[low, high]: [[f32; 3]; 2]| {
        let lengths = (0..3).map(|axis| f64::from(high[axis]) - f64::from(low[axis]));
        lengths.sum::<f64>().max(0.0)
    };
    let sum: f64 = leaves.iter().map(|leaf| size(leaf.bounds())).sum();
    leaves.len() >= LEAST_SORTED && sum > SCATTERED * size(bounds) * leaves.len() as f64
}

/// The points along Morton's curve through the cells of a grid, sorted by counting: as many cells
/// as points at most, of which a surface fills few.
fn along_a_curve(mesh: &Mesh, order: Option<Vec<u32>>, [low, high]: [[f32; 3]; 2]) -> Vec<u32> {
    /// Of a cell's number along an axis, at most: 8 MB of counters.
    const BITS: u32 = 7;
    let order = order.unwrap_or_else(|| (0..mesh.positions.len() as u32).collect());
    let bits = (order.len().ilog2() / 3).min(BITS);
    let size = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f32::max);
    let cells_by_length = (1 << bits) as f32 / size;
    let cell = |number: u32| {
        let position = mesh.positions[number as usize];
        let mut cell = 0;
        for axis in 0..3 {
            // Saturates; NaN becomes 0.
            let along = ((position[axis] - low[axis]) * cells_by_length) as u32;
            cell |= spread(along.min((1 << bits) - 1)) << axis;
        }
        cell
    };
    let cells = gather(order.len(), POINTS, &|task, cells| {
        cells.extend(order[task].iter().map(|&number| cell(number)));
    });
    let mut next = vec![0_u32; 1 << (3 * bits)];
    for &cell in &cells {
        next[cell as usize] += 1;
    }
    let mut sum = 0;
    for count in &mut next {
        (*count, sum) = (sum, sum + *count);
    }
    let mut sorted = vec![0; order.len()];
    for (&number, &cell) in order.iter().zip(&cells) {
        let next = &mut next[cell as usize];
        sorted[*next as usize] = number;
        *next += 1;
    }
    sorted
}

/// Ten bits, each followed by two zeros.
fn spread(bits: u32) -> u32 {
    let bits = (bits | bits << 16) & 0x0300_00ff;
    let bits = (bits | bits << 8) & 0x0300_f00f;
    let bits = (bits | bits << 4) & 0x030c_30c3;
    (bits | bits << 2) & 0x0924_9249
}

#[cfg(test)]
mod tests;
