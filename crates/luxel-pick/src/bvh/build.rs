//! From boxes to a tree: large runs are cut in two by all threads, then each piece becomes wide
//! nodes of its own, and all are joined in order.

use super::split::{Ref, bounds_of, split};
use super::{Box3, Child, Node, Quality, RUN, Tree, WIDTH};
use luxel_parallel::{any, each, fill, gather, join};
use std::ops::Range;

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

/// The number of what is left out.
const LEFT_OUT: u32 = u32::MAX;

/// Things that have a box. The provided methods go through many at a time.
pub(crate) trait Boxes: Sync {
    /// How many there are.
    fn count(&self) -> usize;

    /// The box of one; `None` if it isn't sound.
    fn bounds(&self, number: usize) -> Option<Box3>;

    /// The boxes of those from `start` on.
    fn refs(&self, start: usize, refs: &mut [Ref]) {
        for (number, of) in (start..).zip(refs) {
            let bounds = self.bounds(number);
            let id = if bounds.is_some() { number as u32 } else { LEFT_OUT };
            let Box3 { low, high } = bounds.unwrap_or(Box3::EMPTY);
            *of = Ref { low, id, high, spare: 0 };
        }
    }

    /// Appends the numbers of those of a run that are sound.
    fn sound(&self, run: Range<usize>, numbers: &mut Vec<u32>) {
        for number in run {
            if self.bounds(number).is_some() {
                numbers.push(number as u32);
            }
        }
    }

    /// The box around several.
    fn around(&self, numbers: &[u32]) -> Box3 {
        let mut all = Box3::EMPTY;
        for &number in numbers {
            if let Some(bounds) = self.bounds(number as usize) {
                all = all.union(&bounds);
            }
        }
        all
    }
}

/// Builds a tree over things that have a box, leaving out those that aren't sound.
pub(crate) fn build(things: &dyn Boxes, quality: Quality) -> Tree {
    if quality == Quality::InOrder {
        return in_order(things);
    }
    let nothing = Ref { low: [0.0; 3], id: 0, high: [0.0; 3], spare: 0 };
    let mut refs = vec![nothing; things.count()];
    fill(&mut refs, RUN, &|start, run| things.refs(start, run));
    if any(refs.len(), RUN, &|run| refs[run].iter().any(|of| of.id == LEFT_OUT)) {
        refs.retain(|of| of.id != LEFT_OUT);
    }
    if refs.is_empty() {
        return Tree::default();
    }
    let mut scratch = vec![nothing; refs.len()];
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
    let mut items = vec![0; refs.len()];
    fill(&mut items, RUN, &|start, run| {
        for (item, of) in run.iter_mut().zip(&refs[start..]) {
            *item = of.id;
        }
    });
    Tree { nodes, items, bounds: Some(bounds) }
}

/// A tree over things as they stand: each eight that follow one another are a leaf, each eight leaves
/// a node, and so on up to the root.
fn in_order(things: &dyn Boxes) -> Tree {
    let items = gather(things.count(), RUN, &|run, numbers| things.sound(run, numbers));
    if items.is_empty() {
        return Tree::default();
    }
    let mut boxes = vec![Box3::EMPTY; items.len().div_ceil(WIDTH)];
    fill(&mut boxes, RUN / WIDTH, &|start, run| {
        for (bounds, leaf) in run.iter_mut().zip(items[start * WIDTH..].chunks(WIDTH)) {
            *bounds = things.around(leaf);
        }
    });
    // The lowest level first; children by their places within the level below.
    let mut levels: Vec<Vec<Node>> = Vec::new();
    loop {
        let lowest = levels.is_empty();
        let set = |node: &mut Node, number: usize, boxes: &[Box3]| {
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
        };
        let mut nodes = vec![Node::EMPTY; boxes.len().div_ceil(WIDTH)];
        fill(&mut nodes, RUN / WIDTH, &|start, run| {
            let boxes = boxes[start * WIDTH..].chunks(WIDTH);
            for ((number, node), boxes) in (start..).zip(run).zip(boxes) {
                set(node, number, boxes);
            }
        });
        let mut above = vec![Box3::EMPTY; nodes.len()];
        fill(&mut above, RUN / WIDTH, &|start, run| {
            for (bounds, node) in run.iter_mut().zip(&nodes[start..]) {
                *bounds = node.all_bounds();
            }
        });
        boxes = above;
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
    let (left, right) = join(|| cut_in_tasks(left, quality), || cut_in_tasks(right, quality));
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
    let parts = children(part, quality);
    let mut below: Vec<(Box3, usize, usize, Vec<Node>)> = Vec::new();
    below.resize_with(parts.len(), Default::default);
    each(parts.into_iter().zip(&mut below), &|(part, below)| {
        let (bounds, count) = (*part.bounds(), part.count());
        *below = match part {
            Part::Run(run) if count <= WIDTH => (bounds, count, run.start, Vec::new()),
            part => (bounds, count, 0, nodes(part, quality)),
        };
    });
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
