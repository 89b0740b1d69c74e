//! From boxes to a tree: large runs are cut in two by all threads, then each piece becomes wide
//! nodes of its own, and all are joined in order.

use super::split::{Ref, bounds_of, split};
use super::{Box3, Child, Node, Quality, Tree, WIDTH};
use rayon::prelude::*;

/// Runs up to this size are one task's. Fixed, so that trees don't depend on threads.
const TASK: usize = 1 << 13;
/// Leaves of more than this are cut again while their node has places left.
const SMALL_LEAF: usize = 4;

/// A run of boxes that is still to be cut, or two parts of one.
enum Part<'r> {
    Run(Run<'r>),
    Cut { bounds: Box3, count: usize, parts: Box<[Self; 2]> },
}

struct Run<'r> {
    refs: &'r mut [Ref],
    scratch: &'r mut [Ref],
    /// The first one's place in the order of all.
    start: usize,
    bounds: Box3,
    depth: u32,
    /// Whether cutting it has been found not to pay.
    whole: bool,
}

/// Builds a tree over things that have a box, leaving out those that aren't sound.
pub(crate) fn build<T: Sync>(
    things: &[T],
    is_sound: &(impl Fn(&T) -> bool + Sync),
    bounds: &(impl Fn(&T) -> Box3 + Sync),
    quality: Quality,
) -> Tree {
    if quality == Quality::InOrder {
        return in_order(things, is_sound, bounds);
    }
    const LEFT_OUT: u32 = u32::MAX;
    let of = |(number, thing): (usize, &T)| {
        let id = if is_sound(thing) { number as u32 } else { LEFT_OUT };
        let Box3 { low, high } = bounds(thing);
        Ref { low, id, high, spare: 0 }
    };
    let mut refs: Vec<Ref> = things.par_iter().enumerate().map(of).collect();
    if refs.par_iter().any(|of| of.id == LEFT_OUT) {
        refs.retain(|of| of.id != LEFT_OUT);
    }
    if refs.is_empty() {
        return Tree::default();
    }
    let mut scratch = vec![Ref { low: [0.0; 3], id: 0, high: [0.0; 3], spare: 0 }; refs.len()];
    let bounds = bounds_of(&refs);
    let run =
        Run { refs: &mut refs, scratch: &mut scratch, start: 0, bounds, depth: 0, whole: false };
    let nodes = if run.refs.len() <= WIDTH {
        let mut root = Node::EMPTY;
        root.set(0, &bounds, Child::leaf(0, run.refs.len()));
        vec![root]
    } else {
        nodes(cut_in_tasks(run, quality), quality)
    };
    let items = refs.par_iter().map(|of| of.id).collect();
    Tree { nodes, items, bounds: Some(bounds) }
}

/// A tree over things as they stand: each eight that follow one another are a leaf, each eight leaves
/// a node, and so on up to the root.
fn in_order<T: Sync>(
    things: &[T],
    is_sound: &(impl Fn(&T) -> bool + Sync),
    bounds: &(impl Fn(&T) -> Box3 + Sync),
) -> Tree {
    let numbers = 0..things.len() as u32;
    let sound = |&item: &u32| is_sound(&things[item as usize]);
    let items: Vec<u32> = numbers.into_par_iter().filter(sound).collect();
    if items.is_empty() {
        return Tree::default();
    }
    let of_leaf = |leaf: &[u32]| {
        let boxes = leaf.iter().map(|&item| bounds(&things[item as usize]));
        boxes.fold(Box3::EMPTY, |all, bounds| all.union(&bounds))
    };
    let mut boxes: Vec<Box3> = items.par_chunks(WIDTH).map(of_leaf).collect();
    // The lowest level first; children by their places within the level below.
    let mut levels: Vec<Vec<Node>> = Vec::new();
    loop {
        let lowest = levels.is_empty();
        let of_node = |(number, boxes): (usize, &[Box3])| {
            let mut node = Node::EMPTY;
            for (slot, bounds) in boxes.iter().enumerate() {
                let child = number * WIDTH + slot;
                let first = child * WIDTH;
                let child = if lowest {
                    Child::leaf(first, WIDTH.min(items.len() - first))
                } else {
                    Child::inner(child as u32)
                };
                node.set(slot, bounds, child);
            }
            node
        };
        let nodes: Vec<Node> = boxes.par_chunks(WIDTH).enumerate().map(of_node).collect();
        boxes = nodes.par_iter().map(Node::all_bounds).collect();
        levels.push(nodes);
        if boxes.len() == 1 {
            break;
        }
    }
    let mut nodes = Vec::with_capacity(levels.iter().map(Vec::len).sum());
    for mut level in levels.into_iter().rev() {
        let below = (nodes.len() + level.len()) as u32;
        for child in level.iter_mut().flat_map(|node| &mut node.children) {
            if child.as_leaf().is_none() {
                child.0 += below;
            }
        }
        nodes.append(&mut level);
    }
    Tree { nodes, items, bounds: Some(boxes[0]) }
}

impl<'r> Run<'r> {
    fn cut(self, quality: Quality) -> [Self; 2] {
        let split = split(self.refs, self.scratch, self.depth, quality);
        let (left, right) = self.refs.split_at_mut(split.at);
        let (left_scratch, right_scratch) = self.scratch.split_at_mut(split.at);
        let depth = self.depth + 1;
        let start = self.start + split.at;
        [
            Run {
                refs: left,
                scratch: left_scratch,
                start: self.start,
                bounds: split.left,
                depth,
                whole: false,
            },
            Run {
                refs: right,
                scratch: right_scratch,
                start,
                bounds: split.right,
                depth,
                whole: false,
            },
        ]
    }
}

/// Cuts a run until none of its parts is larger than a task.
fn cut_in_tasks(run: Run<'_>, quality: Quality) -> Part<'_> {
    if run.refs.len() <= TASK {
        return Part::Run(run);
    }
    let (bounds, count) = (run.bounds, run.refs.len());
    let [left, right] = run.cut(quality);
    let (left, right) =
        rayon::join(|| cut_in_tasks(left, quality), || cut_in_tasks(right, quality));
    Part::Cut { bounds, count, parts: Box::new([left, right]) }
}

impl<'r> Part<'r> {
    fn bounds(&self) -> &Box3 {
        match self {
            Self::Run(run) => &run.bounds,
            Self::Cut { bounds, .. } => bounds,
        }
    }

    fn count(&self) -> usize {
        match self {
            Self::Run(run) => run.refs.len(),
            Self::Cut { count, .. } => *count,
        }
    }

    fn cut(self, quality: Quality) -> [Self; 2] {
        match self {
            Self::Run(run) => run.cut(quality).map(Part::Run),
            Self::Cut { parts, .. } => *parts,
        }
    }
}

/// The children of a node: the part with the largest surface is opened until there are eight, then
/// small leaves are cut while there is room.
fn children(part: Part<'_>, quality: Quality) -> Vec<Part<'_>> {
    let mut parts = Vec::with_capacity(WIDTH);
    parts.extend(part.cut(quality));
    while parts.len() < WIDTH {
        let mut largest: Option<(usize, f32)> = None;
        for (place, part) in parts.iter().enumerate().filter(|(_, part)| part.count() > WIDTH) {
            let area = part.bounds().half_area();
            if largest.is_none_or(|(_, most)| area > most) {
                largest = Some((place, area));
            }
        }
        let Some((place, _)) = largest else { break };
        let [left, right] = parts.swap_remove(place).cut(quality);
        parts.extend([left, right]);
    }
    while quality == Quality::Thorough && parts.len() < WIDTH {
        let worth = |part: &Part<'_>| match part {
            Part::Run(run) => (SMALL_LEAF + 1..=WIDTH).contains(&run.refs.len()) && !run.whole,
            Part::Cut { .. } => false,
        };
        let Some(place) = parts.iter().position(worth) else { break };
        let Part::Run(run) = parts.swap_remove(place) else { break };
        let (count, area) = (run.refs.len(), run.bounds.half_area());
        let halves = split(run.refs, run.scratch, run.depth, quality);
        if halves.cost < area * count as f32 {
            let (left, right) = run.refs.split_at_mut(halves.at);
            let (left_scratch, right_scratch) = run.scratch.split_at_mut(halves.at);
            let depth = run.depth + 1;
            let start = run.start;
            let of = |refs, scratch, start, bounds| {
                Part::Run(Run { refs, scratch, start, bounds, depth, whole: false })
            };
            parts.push(of(left, left_scratch, start, halves.left));
            parts.push(of(right, right_scratch, start + halves.at, halves.right));
        } else {
            parts.push(Part::Run(Run { whole: true, ..run }));
        }
    }
    parts
}

/// The nodes of a part of more than a leaf, its own first.
fn nodes(part: Part<'_>, quality: Quality) -> Vec<Node> {
    let mut all = Vec::new();
    if let Part::Run(run) = part {
        append(run, quality, &mut all);
        return all;
    }
    let below: Vec<(Box3, usize, usize, Vec<Node>)> = children(part, quality)
        .into_par_iter()
        .map(|part| {
            let (bounds, count) = (*part.bounds(), part.count());
            match part {
                Part::Run(run) if count <= WIDTH => (bounds, count, run.start, Vec::new()),
                part => (bounds, count, 0, nodes(part, quality)),
            }
        })
        .collect();
    all.push(Node::EMPTY);
    for (slot, (bounds, count, start, mut nodes)) in below.into_iter().enumerate() {
        let first = all.len() as u32;
        let child = if nodes.is_empty() { Child::leaf(start, count) } else { Child::inner(first) };
        all[0].set(slot, &bounds, child);
        for child in nodes.iter_mut().flat_map(|node| &mut node.children) {
            if child.as_leaf().is_none() {
                child.0 += first;
            }
        }
        all.append(&mut nodes);
    }
    all
}

/// Appends the nodes of a run of more than a leaf; the number of its own.
fn append(run: Run<'_>, quality: Quality, all: &mut Vec<Node>) -> u32 {
    let number = all.len();
    all.push(Node::EMPTY);
    for (slot, part) in children(Part::Run(run), quality).into_iter().enumerate() {
        let Part::Run(run) = part else { continue };
        let bounds = run.bounds;
        let child = if run.refs.len() <= WIDTH {
            Child::leaf(run.start, run.refs.len())
        } else {
            Child::inner(append(run, quality, all))
        };
        all[number].set(slot, &bounds, child);
    }
    number as u32
}
