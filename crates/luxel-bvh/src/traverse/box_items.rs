//! A ray through a tree over items.

use super::stack::TraversalStack;
use crate::intersect::SlabTest;
use crate::ray::Ray;
use crate::tree::{Child, Tree};
use luxel_math::Level;

/// Visits the items of leaves whose boxes a ray hits, near ones first; `visit` returns the distance
/// beyond which nothing counts any more.
pub(crate) fn visit_items(level: Level, tree: &Tree, ray: &Ray, mut visit: impl FnMut(u32) -> f32) {
    let Some(bounds) = tree.bounds else { return };
    let slabs = SlabTest::new(ray.origin, ray.direction, ray.range[0], bounds.largest());
    let mut limit = ray.range[1];
    let (stack, mut top) = (TraversalStack::new(), 0);
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
}
