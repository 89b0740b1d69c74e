//! From boxes to a tree: large runs are cut in two by all threads, then each piece becomes wide
//! nodes of its own, and all are joined in order.

use super::bins::{Lanes, Ref, Side};
use super::split::{Care, side_of, split, split_many};
use super::{Box3, Child, Node, Quality, RUN, Tree, WIDTH};
use luxel_math::{Level, SimdLevel};
use luxel_pages::Pages;
use luxel_parallel::{any, each, fill, gather, join};
use std::ops::Range;

/// Runs up to this size are one task's. Fixed, so that trees don't depend on threads.
const TASK: usize = 1 << 13;
/// Leaves of more than this are cut again while their node has places left: what they share then
/// mostly fits into one block.
const SMALL_LEAF: usize = 6;
/// Runs up to this size are one node with leaves only. They aren't opened for the node above, which
/// would have more children and those fewer of their own: nodes that are half empty take memory.
const FULL: usize = 6 * WIDTH;
/// Unless there is a place for each so many of them.
const EACH: usize = 5;

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
    /// The box of its boxes' middles.
    middles: Lanes,
    depth: u32,
    /// Whether `refs` is part of what is scratch for others.
    swapped: bool,
    /// Whether cutting it has been found not to pay.
    whole: bool,
}

/// Things that have a box. The provided methods go through many at a time.
pub(crate) trait Boxes: Sync {
    /// How many there are.
    fn count(&self) -> usize;

    /// The box of one; `None` if it isn't sound.
    fn bounds(&self, number: usize) -> Option<Box3>;

    /// The boxes of those from `start` on.
    fn refs(&self, start: usize, refs: &mut [Ref]) {
        for (number, of) in (start..).zip(refs) {
            *of = Ref::new(number as u32, self.bounds(number));
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
    let level = SimdLevel::Auto.resolve().unwrap_or_else(|_| Level::baseline());
    let care = Care { quality, level };
    // Memory that isn't touched before all threads do: who comes first waits for the system.
    let mut refs = Pages::zeroed(things.count());
    fill(&mut refs, RUN, &|start, run| things.refs(start, run));
    let mut count = refs.len();
    if any(count, RUN, &|run| refs[run].iter().any(Ref::is_left_out)) {
        count = keep(&mut refs);
    }
    let refs = &mut refs[..count];
    if refs.is_empty() {
        return Tree::default();
    }
    let mut scratch = Pages::zeroed(count);
    let Side { bounds, middles } = side_of(refs, level);
    let run = Run {
        refs: &mut *refs,
        scratch: &mut scratch,
        start: 0,
        bounds,
        middles,
        depth: 0,
        swapped: false,
        whole: false,
    };
    let nodes = if run.refs.len() <= WIDTH {
        let mut root = Node::EMPTY;
        root.set(0, &bounds, Child::leaf(0, run.refs.len()));
        Pages::copied(&[root])
    } else {
        nodes(cut_in_tasks(run, care), care)
    };
    let mut items = vec![0; refs.len()];
    fill(&mut items, RUN, &|start, run| {
        for (item, of) in run.iter_mut().zip(&refs[start..]) {
            *item = of.number();
        }
    });
    Tree { nodes, items, bounds: Some(bounds) }
}

/// Moves what isn't left out to the front; how many there are.
fn keep(refs: &mut [Ref]) -> usize {
    let mut kept = 0;
    for place in 0..refs.len() {
        if !refs[place].is_left_out() {
            refs[kept] = refs[place];
            kept += 1;
        }
    }
    kept
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
    Tree { nodes: Pages::copied(&nodes), items, bounds: Some(boxes[0]) }
}

impl<'r> Run<'r> {
    /// Both parts.
    fn cut(self, care: Care) -> [Self; 2] {
        let split = split(self.refs, self.scratch, &self.middles, self.depth, care);
        self.parts(split.at, split.sides)
    }

    /// The same by all threads, for more than a task's.
    fn cut_many(mut self, care: Care) -> [Self; 2] {
        let (split, moved) = split_many(self.refs, self.scratch, &self.middles, self.depth, care);
        if moved {
            std::mem::swap(&mut self.refs, &mut self.scratch);
            self.swapped = !self.swapped;
        }
        self.parts(split.at, split.sides)
    }

    fn parts(self, at: usize, [left, right]: [Side; 2]) -> [Self; 2] {
        let (left_refs, right_refs) = self.refs.split_at_mut(at);
        let (left_scratch, right_scratch) = self.scratch.split_at_mut(at);
        let (depth, swapped, whole) = (self.depth + 1, self.swapped, false);
        let part = |refs, scratch, start, Side { bounds, middles }| Run {
            refs,
            scratch,
            start,
            bounds,
            middles,
            depth,
            swapped,
            whole,
        };
        [
            part(left_refs, left_scratch, self.start, left),
            part(right_refs, right_scratch, self.start + at, right),
        ]
    }

    /// Back to where all belong.
    fn settled(mut self) -> Self {
        if self.swapped {
            self.scratch.copy_from_slice(self.refs);
            std::mem::swap(&mut self.refs, &mut self.scratch);
            self.swapped = false;
        }
        self
    }
}

/// Cuts a run until none of its parts is larger than a task.
fn cut_in_tasks(run: Run<'_>, care: Care) -> Part<'_> {
    if run.refs.len() <= TASK {
        return Part::Run(run.settled());
    }
    let (bounds, count) = (run.bounds, run.refs.len());
    let [left, right] = run.cut_many(care);
    let (left, right) = join(|| cut_in_tasks(left, care), || cut_in_tasks(right, care));
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

    fn cut(self, care: Care) -> [Self; 2] {
        match self {
            Self::Run(run) => run.cut(care).map(Part::Run),
            Self::Cut { parts, .. } => *parts,
        }
    }
}

/// Which of a node's parts is opened: of those too large for a node the one with the largest surface,
/// then that of the most triangles whose leaves find room here.
fn to_open(parts: &[Part<'_>]) -> Option<usize> {
    let room = EACH * (WIDTH + 1 - parts.len());
    let mut best: Option<(usize, bool, f32)> = None;
    for (place, part) in parts.iter().enumerate() {
        let count = part.count();
        let is_large = count > FULL;
        if !is_large && (count <= WIDTH || count > room) {
            continue;
        }
        let size = if is_large { part.bounds().half_area() } else { count as f32 };
        if best.is_none_or(|(_, large, most)| is_large & !large || is_large == large && size > most)
        {
            best = Some((place, is_large, size));
        }
    }
    best.map(|(place, ..)| place)
}

/// The children of a node: parts are opened until there are eight, then small leaves are cut while
/// there is room.
fn children(part: Part<'_>, care: Care) -> Vec<Part<'_>> {
    let mut parts = Vec::with_capacity(WIDTH);
    parts.extend(part.cut(care));
    while parts.len() < WIDTH {
        let Some(place) = to_open(&parts) else { break };
        let [left, right] = parts.swap_remove(place).cut(care);
        parts.extend([left, right]);
    }
    while care.quality == Quality::Thorough && parts.len() < WIDTH {
        let worth = |part: &Part<'_>| match part {
            Part::Run(run) => (SMALL_LEAF + 1..=WIDTH).contains(&run.refs.len()) && !run.whole,
            Part::Cut { .. } => false,
        };
        let Some(place) = parts.iter().position(worth) else { break };
        let Part::Run(run) = parts.swap_remove(place) else { break };
        let (count, area) = (run.refs.len(), run.bounds.half_area());
        let halves = split(run.refs, run.scratch, &run.middles, run.depth, care);
        if halves.cost < area * count as f32 {
            parts.extend(run.parts(halves.at, halves.sides).map(Part::Run));
        } else {
            parts.push(Part::Run(Run { whole: true, ..run }));
        }
    }
    parts
}

/// What is below one of a node's places.
enum Below {
    /// Things from here on.
    Leaf(usize),
    /// The nodes of a task, its own first.
    Task(Vec<Node>),
    /// A node's children, each with its box and how many things it has; and how many nodes that is.
    Node(Vec<(Box3, usize, Self)>, usize),
}

impl Below {
    fn of(part: Part<'_>, care: Care) -> Self {
        let part = match part {
            Part::Run(run) if run.refs.len() <= WIDTH => return Self::Leaf(run.start),
            Part::Run(run) => {
                let mut nodes = Vec::new();
                append(run, care, &mut nodes);
                return Self::Task(nodes);
            }
            part @ Part::Cut { .. } => part,
        };
        let parts = children(part, care);
        let mut below: Vec<_> =
            parts.iter().map(|part| (*part.bounds(), part.count(), Self::Leaf(0))).collect();
        each(parts.into_iter().zip(&mut below), &|(part, (.., below))| {
            *below = Self::of(part, care);
        });
        let count = 1 + below.iter().map(|(.., below)| below.count()).sum::<usize>();
        Self::Node(below, count)
    }

    /// How many nodes there are.
    fn count(&self) -> usize {
        match self {
            Self::Leaf(_) => 0,
            Self::Task(nodes) => nodes.len(),
            Self::Node(_, count) => *count,
        }
    }

    /// Writes what is above all tasks to `nodes`, the first of which is the tree's node `first`, and
    /// leaves the tasks' nodes to `tasks`.
    fn lay<'n>(
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
                        Self::Leaf(start) => Child::leaf(*start, *count),
                        _ => Child::inner(at as u32),
                    };
                    top.set(slot, bounds, child);
                    let (own, more) = rest.split_at_mut(below.count());
                    below.lay(at, own, tasks);
                    (at, rest) = (at + below.count(), more);
                }
            }
        }
    }
}

/// The nodes of a part of more than a leaf, its own first.
fn nodes(part: Part<'_>, care: Care) -> Pages<Node> {
    let below = Below::of(part, care);
    let mut nodes = Pages::zeroed(below.count());
    let mut tasks = Vec::new();
    below.lay(0, &mut nodes, &mut tasks);
    each(tasks.into_iter(), &|(first, own, nodes)| {
        nodes.copy_from_slice(own);
        for child in nodes.iter_mut().flat_map(|node| &mut node.children) {
            if child.as_leaf().is_none() {
                child.0 += first as u32;
            }
        }
    });
    nodes
}

/// Appends the nodes of a run of more than a leaf; the number of its own.
fn append(run: Run<'_>, care: Care, all: &mut Vec<Node>) -> u32 {
    let number = all.len();
    all.push(Node::EMPTY);
    for (slot, part) in children(Part::Run(run), care).into_iter().enumerate() {
        let Part::Run(run) = part else { continue };
        let bounds = run.bounds;
        let child = if run.refs.len() <= WIDTH {
            Child::leaf(run.start, run.refs.len())
        } else {
            Child::inner(append(run, care, all))
        };
        all[number].set(slot, &bounds, child);
    }
    number as u32
}
