//! A line through a tree over items.

use super::stack::TraversalStack;
use crate::intersect::SlabTest;
use crate::tree::{Child, Tree};
use luxel_math::Level;
use std::cell::Cell;

thread_local! {
    /// Kept from call to call, since 4 KiB of zeros cost more than most trees over items. A call inside of
    /// `visit` makes another one.
    static STACK: Cell<Option<Box<TraversalStack>>> = const { Cell::new(None) };
}

/// Visits the items of leaves whose boxes a line hits, near ones first; `visit` returns the distance
/// beyond which nothing counts any more.
pub(crate) fn visit_items(
    level: Level,
    tree: &Tree,
    (slabs, farthest): (&SlabTest, f32),
    mut visit: impl FnMut(u32) -> f32,
) {
    let mut limit = farthest;
    let stack = STACK.take().unwrap_or_else(|| Box::new(TraversalStack::new()));
    let mut top = 0;
    let mut next = Some(Child::inner(0));
    while let Some(child) = next {
        if let Some((start, count)) = child.as_items() {
            for &item in &tree.items[start..start + count] {
                limit = limit.min(visit(item));
            }
        } else {
            let node = &tree.nodes[child.0 as usize];
            let (distances, bits) = slabs.hit_children_at(level, node, limit);
            stack.push(&mut top, node.words(), &distances, bits);
        }
        next = stack.pop(&mut top, limit).map(Child);
    }
    STACK.set(Some(stack));
}
