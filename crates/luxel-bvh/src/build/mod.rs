//! Building: boxes become a tree, and a tree's leaves become blocks of triangles.
//!
//! Large runs of boxes are split by all threads; each piece then becomes nodes on its own, and the
//! pieces are joined in order. The split is the surface area heuristic's over bins (Wald 2007). The
//! result depends only on the boxes, so it is the same for any number of threads.

mod bins;
mod boxes;
mod in_order;
mod leaf_builder;
mod nodes;
mod quality;
mod run;
mod split;

pub(crate) use boxes::Boxes;
#[cfg(test)]
pub(crate) use leaf_builder::MOST_BYTES;
pub(crate) use leaf_builder::build_leaves;
pub use quality::Quality;

use crate::pages::Pages;
use crate::tree::{Child, Node, Tree, WIDTH};
use bins::{BoxRef, Side};
use boxes::CHUNK;
use luxel_math::{Level, SimdLevel};
use luxel_parallel::{any, fill};
use run::Run;
use split::{BuildSettings, side_of};

/// Builds a tree over items that have boxes, without those whose box isn't sound.
pub(crate) fn build(boxes: &dyn Boxes, quality: Quality) -> Tree {
    if quality == Quality::InOrder {
        return in_order::build(boxes);
    }
    let level = SimdLevel::Auto.resolve().unwrap_or_else(|_| Level::baseline());
    let settings = BuildSettings { quality, level };
    // All threads touch this memory first, since whoever does waits for the system. Filling it with
    // zeros took a fifth of the time with two threads at a million triangles.
    let mut refs = Pages::zeroed(boxes.count());
    fill(&mut refs, CHUNK, &|start, run| boxes.write_refs(start, run));
    let mut count = refs.len();
    if any(count, CHUNK, &|run| refs[run].iter().any(BoxRef::is_excluded)) {
        count = compact(&mut refs);
    }
    let refs = &mut refs[..count];
    if refs.is_empty() {
        return Tree::default();
    }
    let mut scratch = Pages::zeroed(count);
    let Side { bounds, centroids } = side_of(refs, level);
    let nodes = if refs.len() <= WIDTH {
        let mut root = Node::EMPTY;
        root.set(0, &bounds, Child::items(0, refs.len()));
        Pages::copied(&[root])
    } else {
        let run = Run::all(&mut *refs, &mut scratch, bounds, centroids);
        nodes::build(run::split_in_tasks(run, settings), settings)
    };
    let mut items = vec![0; refs.len()];
    fill(&mut items, CHUNK, &|start, run| {
        for (item, of) in run.iter_mut().zip(&refs[start..]) {
            *item = of.number();
        }
    });
    Tree { nodes, items, bounds: Some(bounds) }
}

/// Moves the boxes that aren't excluded to the front; returns their count.
fn compact(refs: &mut [BoxRef]) -> usize {
    let mut kept = 0;
    for at in 0..refs.len() {
        if !refs[at].is_excluded() {
            refs[kept] = refs[at];
            kept += 1;
        }
    }
    kept
}
