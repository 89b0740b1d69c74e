//! A tree over boxes of any items.

use crate::aabb::Aabb;
use crate::build::{Boxes, Quality, build};
use crate::bvh::TooManyForTree;
use crate::intersect::SlabTest;
use crate::ray::Ray;
use crate::traverse::visit_items;
use crate::tree::{MAX_TRIANGLES, Tree};
use luxel_math::Level;

/// A tree over boxes: the upper level over objects that have trees of their own.
#[derive(Clone, Debug, Default)]
pub struct BoxTree(Tree);

struct Items<'b>(&'b [Option<[[f32; 3]; 2]>]);

impl Boxes for Items<'_> {
    fn count(&self) -> usize {
        self.0.len()
    }

    fn bounds(&self, number: usize) -> Option<Aabb> {
        self.0[number].map(|[low, high]| Aabb { low, high })
    }
}

impl BoxTree {
    /// Builds a tree over the lowest and highest corners of items; leaves out `None`.
    ///
    /// ```
    /// use luxel_bvh::{BoxTree, Quality, Ray};
    /// use luxel_math::Level;
    ///
    /// let boxes = [0.0, 2.0, 4.0].map(|x| Some([[x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]]));
    /// let tree = BoxTree::build(&boxes, Quality::Fast)?;
    /// let mut visited = Vec::new();
    /// let ray = Ray::new([2.5, 0.5, 9.0], [0.0, 0.0, -1.0]);
    /// tree.visit_along(Level::baseline(), &ray, |item| {
    ///     visited.push(item);
    ///     f32::INFINITY
    /// });
    /// assert!(visited.contains(&1));
    /// # Ok::<(), luxel_bvh::TooManyForTree>(())
    /// ```
    ///
    /// # Errors
    /// [`TooManyForTree`] beyond [`MAX_TRIANGLES`] boxes.
    pub fn build(
        boxes: &[Option<[[f32; 3]; 2]>],
        quality: Quality,
    ) -> Result<Self, TooManyForTree> {
        if boxes.len() > MAX_TRIANGLES {
            return Err(TooManyForTree(boxes.len()));
        }
        Ok(Self(build(&Items(boxes), quality)))
    }

    /// The lowest and highest corner of the box around all; `None` for a tree over nothing.
    #[must_use]
    pub fn bounds(&self) -> Option<[[f32; 3]; 2]> {
        self.0.bounds.map(|bounds| [bounds.low, bounds.high])
    }

    /// Visits the items whose boxes a ray may hit, roughly near ones first; items that share a leaf
    /// come together. `visit` returns the distance beyond which nothing counts any more, at most that
    /// of the nearest hit so far.
    pub fn visit_along(&self, level: Level, ray: &Ray, visit: impl FnMut(u32) -> f32) {
        let Some(bounds) = self.0.bounds else { return };
        let slabs = SlabTest::new(ray.origin, ray.direction, ray.range[0], bounds.largest());
        visit_items(level, &self.0, (&slabs, ray.range[1]), visit);
    }

    /// Visits the items whose boxes a line may hit, thick as it may be, up to the distance `farthest`.
    pub fn visit_within(
        &self,
        level: Level,
        line: &SlabTest,
        farthest: f32,
        mut visit: impl FnMut(u32),
    ) {
        if self.0.bounds.is_some() {
            visit_items(level, &self.0, (line, farthest), |item| {
                visit(item);
                f32::INFINITY
            });
        }
    }
}
