//! Frustum query: the triangles of a tree that may reach into a part of the window. Boxes are tested
//! against the planes through its sides and the near and far planes.

use crate::region::Piece;
use glam::{DMat4, DVec4};
use luxel_bvh::{Bvh, Node, WIDTH};

/// Four sides, near and far.
pub(crate) const PLANES: usize = 6;

/// The planes around one convex piece, in clip coordinates: plane . corner >= 0 inside.
pub(crate) type Planes = [DVec4; PLANES];

/// The planes around a piece of the window: with X = (x / w + 1) / 2 width and
/// Y = (1 - y / w) / 2 height, a X + b Y + c >= 0 times 2 w.
pub(crate) fn frustum_planes(piece: &Piece, [width, height]: [f64; 2]) -> Planes {
    let side = |[a, b, c]: [f64; 3]| {
        let (a, b) = (a * width, b * height);
        DVec4::new(a, -b, 0.0, a + b + 2.0 * c)
    };
    let [left, right, top, bottom] = piece.sides.map(side);
    let near = DVec4::new(0.0, 0.0, 1.0, 1.0);
    let far = DVec4::new(0.0, 0.0, -1.0, 1.0);
    [left, right, top, bottom, near, far]
}

/// Planes in a tree's coordinates, rounded conservatively: normal and distance.
pub(crate) struct Frustum {
    planes: [[f32; 4]; PLANES],
}

/// A bound of rounding errors, relative to the magnitudes of the summands.
const SLACK: f64 = 1e-5;

impl Frustum {
    /// `beyond` widens each plane, in units of plane . corner at w = 1.
    pub(crate) fn new(
        planes: &Planes,
        clip_from_tree: &DMat4,
        bounds: Option<[[f32; 3]; 2]>,
        beyond: [f64; PLANES],
    ) -> Self {
        let tree_from_clip = clip_from_tree.transpose();
        let [low, high] = bounds.unwrap_or_default();
        let rounded = |number: usize| {
            // plane . (M p) = (M^T plane) . p
            let plane = tree_from_clip * planes[number];
            let size =
                |axis: usize| plane[axis].abs() * f64::from(low[axis].abs().max(high[axis].abs()));
            let slack = SLACK * (size(0) + size(1) + size(2) + plane.w.abs()) + beyond[number];
            let scale = 1.0 / plane.abs().max_element().max(f64::MIN_POSITIVE);
            let [x, y, z, w] = [plane.x, plane.y, plane.z, plane.w + slack];
            [x, y, z, w].map(|value| (value * scale) as f32)
        };
        Self { planes: std::array::from_fn(rounded) }
    }

    /// Visits the triangles of leaves that may reach inside, block by block.
    pub(crate) fn visit_leaves(&self, bvh: &Bvh, mut visit: impl FnMut(&[u32])) {
        bvh.view().visit_blocks(
            |node| self.intersects(node),
            |block| {
                let mut triangles = [0; WIDTH];
                let count = block.count();
                for (lane, triangle) in triangles[..count].iter_mut().enumerate() {
                    *triangle = block.triangle(lane);
                }
                visit(&triangles[..count]);
            },
        );
    }

    /// A bit for each child whose box isn't entirely outside one plane.
    fn intersects(&self, node: &Node) -> u32 {
        let mut outside = [false; WIDTH];
        for [x, y, z, w] in self.planes {
            let row = |axis: usize, along: f32| &node.planes()[axis][usize::from(along >= 0.0)];
            let (rx, ry, rz) = (row(0, x), row(1, y), row(2, z));
            for slot in 0..WIDTH {
                let farthest = rx[slot] * x + ry[slot] * y + rz[slot] * z + w;
                outside[slot] |= farthest < 0.0;
            }
        }
        // Empty slots have an inverted box.
        (0..WIDTH).fold(0, |bits, slot| {
            let [low, high] = &node.planes()[0];
            let there = low[slot] <= high[slot];
            bits | u32::from(there && !outside[slot]) << slot
        })
    }
}
