//! Trees in the order of their items.

use super::boxes::{Boxes, CHUNK};
use crate::aabb::Aabb;
use crate::pages::Pages;
use crate::tree::{Child, Node, Tree, WIDTH};
use luxel_parallel::{fill, gather};

/// Builds a tree that keeps the order of items: eight consecutive items make a leaf, eight leaves a
/// node, and so on up to the root.
pub(super) fn build(source: &dyn Boxes) -> Tree {
    let items = gather(source.count(), CHUNK, &|run, numbers| source.append_included(run, numbers));
    if items.is_empty() {
        return Tree::default();
    }
    let mut boxes = vec![Aabb::EMPTY; items.len().div_ceil(WIDTH)];
    fill(&mut boxes, CHUNK / WIDTH, &|start, run| {
        for (bounds, leaf) in run.iter_mut().zip(items[start * WIDTH..].chunks(WIDTH)) {
            *bounds = source.union(leaf);
        }
    });
    // The lowest level first; children by their index in the level below.
    let mut levels: Vec<Vec<Node>> = Vec::new();
    loop {
        let lowest = levels.is_empty();
        let set = |node: &mut Node, number: usize, boxes: &[Aabb]| {
            for (slot, bounds) in boxes.iter().enumerate() {
                let child = number * WIDTH + slot;
                let first = child * WIDTH;
                let child = if lowest {
                    Child::items(first, WIDTH.min(items.len() - first))
                } else {
                    Child::inner(child as u32)
                };
                node.set(slot, bounds, child);
            }
        };
        let mut nodes = vec![Node::EMPTY; boxes.len().div_ceil(WIDTH)];
        fill(&mut nodes, CHUNK / WIDTH, &|start, run| {
            let boxes = boxes[start * WIDTH..].chunks(WIDTH);
            for ((number, node), boxes) in (start..).zip(run).zip(boxes) {
                set(node, number, boxes);
            }
        });
        let mut above = vec![Aabb::EMPTY; nodes.len()];
        fill(&mut above, CHUNK / WIDTH, &|start, run| {
            for (bounds, node) in run.iter_mut().zip(&nodes[start..]) {
                *bounds = node.union();
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
            if child.as_items().is_none() {
                child.0 += below;
            }
        }
        nodes.append(&mut level);
    }
    Tree { nodes: Pages::copied(&nodes), items, bounds: Some(boxes[0]) }
}
