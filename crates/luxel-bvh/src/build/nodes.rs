//! Splits become nodes of eight children.

use super::quality::Quality;
use super::run::{Part, Run};
use super::split::{BuildSettings, split};
use crate::aabb::Aabb;
use crate::pages::Pages;
use crate::tree::{Child, Node, WIDTH};
use luxel_parallel::each;

/// Leaves of more triangles than this are split again while their node has free slots: what six
/// triangles share mostly fits into one block. Four or eight instead of six were as fast, with a
/// little more memory or more leaves to visit.
const SMALL_LEAF: usize = 6;
/// Runs up to this size become one node that has only leaves. Opening them for the node above would
/// fill that one and leave their own half empty: 8 bytes a triangle for nodes instead of 14, with no
/// more nodes on a ray's path.
const FULL: usize = 6 * WIDTH;
/// Unless there is a free slot for each so many of their triangles.
const ITEMS_PER_FREE_SLOT: usize = 5;

/// The part of a node to replace by its two halves: of those too large for one node the one with the
/// largest surface, then the one of the most triangles whose leaves fit here.
fn child_to_open(parts: &[Part<'_>]) -> Option<usize> {
    let room = ITEMS_PER_FREE_SLOT * (WIDTH + 1 - parts.len());
    let mut best: Option<(usize, bool, f32)> = None;
    for (index, part) in parts.iter().enumerate() {
        let count = part.count();
        let is_large = count > FULL;
        if !is_large && (count <= WIDTH || count > room) {
            continue;
        }
        let size = if is_large { part.bounds().half_area() } else { count as f32 };
        if best.is_none_or(|(_, large, most)| is_large & !large || is_large == large && size > most)
        {
            best = Some((index, is_large, size));
        }
    }
    best.map(|(index, ..)| index)
}

/// The children of a node: opens parts until there are eight, then splits small leaves while slots
/// are free.
fn children(part: Part<'_>, settings: BuildSettings) -> Vec<Part<'_>> {
    let mut parts = Vec::with_capacity(WIDTH);
    parts.extend(part.split(settings));
    while parts.len() < WIDTH {
        let Some(index) = child_to_open(&parts) else { break };
        let [left, right] = parts.swap_remove(index).split(settings);
        parts.extend([left, right]);
    }
    while settings.quality == Quality::Thorough && parts.len() < WIDTH {
        let worth = |part: &Part<'_>| match part {
            Part::Run(run) => (SMALL_LEAF + 1..=WIDTH).contains(&run.refs.len()) && !run.keep_whole,
            Part::Split { .. } => false,
        };
        let Some(index) = parts.iter().position(worth) else { break };
        let Part::Run(run) = parts.swap_remove(index) else { break };
        let (count, area) = (run.refs.len(), run.bounds.half_area());
        let halves = split(run.refs, run.scratch, &run.centroids, run.depth, settings);
        if halves.cost < area * count as f32 {
            parts.extend(run.parts(halves.at, halves.sides).map(Part::Run));
        } else {
            parts.push(Part::Run(Run { keep_whole: true, ..run }));
        }
    }
    parts
}

/// What a slot of a node refers to.
enum BuiltSubtree {
    /// The items from here on.
    Leaf(usize),
    /// The nodes of a task, its own first.
    Task(Vec<Node>),
    /// A node's children, each with its box and its number of items; and the number of nodes.
    Node(Vec<(Aabb, usize, Self)>, usize),
}

impl BuiltSubtree {
    fn of(part: Part<'_>, settings: BuildSettings) -> Self {
        let part = match part {
            Part::Run(run) if run.refs.len() <= WIDTH => return Self::Leaf(run.start),
            Part::Run(run) => {
                let mut nodes = Vec::new();
                append_nodes(run, settings, &mut nodes);
                return Self::Task(nodes);
            }
            part @ Part::Split { .. } => part,
        };
        let parts = children(part, settings);
        let mut below: Vec<_> =
            parts.iter().map(|part| (*part.bounds(), part.count(), Self::Leaf(0))).collect();
        each(parts.into_iter().zip(&mut below), &|(part, (.., below))| {
            *below = Self::of(part, settings);
        });
        let count = 1 + below.iter().map(|(.., below)| below.count()).sum::<usize>();
        Self::Node(below, count)
    }

    /// The number of nodes.
    fn count(&self) -> usize {
        match self {
            Self::Leaf(_) => 0,
            Self::Task(nodes) => nodes.len(),
            Self::Node(_, count) => *count,
        }
    }

    /// Writes the nodes above all tasks to `nodes`, which begin at the tree's node `first`, and
    /// collects where the tasks' nodes go in `tasks`.
    fn write<'n>(
        &'n self,
        first: usize,
        nodes: &'n mut [Node],
        tasks: &mut Vec<(usize, &'n [Node], &'n mut [Node])>,
    ) {
        match self {
            Self::Leaf(_) => {}
            Self::Task(own) => tasks.push((first, own, nodes)),
            Self::Node(below, _) => {
                let Some((top, mut rest)) = nodes.split_first_mut() else { return };
                *top = Node::EMPTY;
                let mut at = first + 1;
                for (slot, (bounds, count, below)) in below.iter().enumerate() {
                    let child = match below {
                        Self::Leaf(start) => Child::items(*start, *count),
                        _ => Child::inner(at as u32),
                    };
                    top.set(slot, bounds, child);
                    let (own, more) = rest.split_at_mut(below.count());
                    below.write(at, own, tasks);
                    (at, rest) = (at + below.count(), more);
                }
            }
        }
    }
}

/// The nodes of a part that exceeds a leaf, its own first.
pub(super) fn build(part: Part<'_>, settings: BuildSettings) -> Pages<Node> {
    let below = BuiltSubtree::of(part, settings);
    let mut nodes = Pages::zeroed(below.count());
    let mut tasks = Vec::new();
    below.write(0, &mut nodes, &mut tasks);
    each(tasks.into_iter(), &|(first, own, nodes)| {
        nodes.copy_from_slice(own);
        for child in nodes.iter_mut().flat_map(|node| &mut node.children) {
            if child.as_items().is_none() {
                child.0 += first as u32;
            }
        }
    });
    nodes
}

/// Appends the nodes of a run that exceeds a leaf; returns the index of its own.
fn append_nodes(run: Run<'_>, settings: BuildSettings, all: &mut Vec<Node>) -> u32 {
    let number = all.len();
    all.push(Node::EMPTY);
    for (slot, part) in children(Part::Run(run), settings).into_iter().enumerate() {
        let Part::Run(run) = part else { continue };
        let bounds = run.bounds;
        let child = if run.refs.len() <= WIDTH {
            Child::items(run.start, run.refs.len())
        } else {
            Child::inner(append_nodes(run, settings, all))
        };
        all[number].set(slot, &bounds, child);
    }
    number as u32
}
