//! Places on triangles from which rays leave.

use crate::scene_rays::SceneRays;
use glam::{DMat4, DVec3};

/// A place on a triangle from which rays leave, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePlace {
    /// The place, in the triangle's plane to the rounding of `f64`, a little away from its edges.
    pub position: DVec3,
    /// The triangle's own normal, of unit length; its side is that of the corners' order.
    pub normal: DVec3,
    /// From the place to the origin of rays that leave on the normal's side: along the normal of the
    /// tree's coordinates, by [`LIFT`] of the corners' largest coordinate there.
    pub lift: DVec3,
}

/// How far origins of rays lie above their triangle, as a part of the largest coordinate of its corners,
/// which are about the mesh's own origin: 2^-20.
///
/// In the tree's coordinates, of which M is the largest at the triangle, an origin is rounded by 2^-25 M,
/// and the corners that the test takes about it by 2^-24 of twice M; a signed distance from a plane, a sum
/// of three products of them over the normal's length, is off by less than 8 such steps for triangles that
/// are not needles. 2^-20 M is twice that: rays don't hit their own triangle, nor, where the surface is
/// convex, its neighbours (Wächter and Binder, *A Fast and Robust Method for Avoiding Self-Intersection*,
/// Ray Tracing Gems, 2019, choose a similar step by trial). What lies nearer than the lift is not hit.
pub const LIFT: f64 = 1.0 / (1 << 20) as f64;

/// How near to an edge of its triangle a ray leaves, in units of the lift. At an edge itself, in a corner
/// of a room for example, the ray would begin in the plane of the other wall, or behind it.
const INSET: f64 = 4.0;

/// The farthest that a place is moved away from edges, in units of the lift: in an acute corner it stays
/// nearer to them than [`INSET`]. Origins thus lie within 8 lifts, 2^-17 M, of the place that was asked for.
const MOVE: f64 = 7.0;

impl SurfacePlace {
    /// The same place with its normal on the side of a direction.
    #[must_use]
    pub fn facing(self, direction: DVec3) -> Self {
        if self.normal.dot(direction) < 0.0 {
            Self { normal: -self.normal, lift: -self.lift, ..self }
        } else {
            self
        }
    }

    /// The origin of rays that leave on the normal's side.
    #[must_use]
    pub fn origin(&self) -> DVec3 {
        self.position + self.lift
    }
}

impl SceneRays {
    /// The place of an object's triangle with these barycentrics; `None` where the triangle has no area.
    ///
    /// Barycentrics of any error give a place in the plane, since the corners are the true ones.
    ///
    /// # Panics
    /// If there is no such object or triangle.
    #[must_use]
    pub fn place(
        &self,
        object: usize,
        triangle: u32,
        barycentric: [f32; 3],
    ) -> Option<SurfacePlace> {
        let tree = self.tree(object);
        let corners = self.mesh(object).triangles[triangle as usize].map(|vertex| {
            let [x, y, z] = tree.positions[vertex as usize];
            DVec3::new(x.into(), y.into(), z.into())
        });
        let largest = corners.iter().map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
        let [a, b, c] = corners;
        let twice_area = (b - a).cross(c - a);
        let in_tree = twice_area.try_normalize()?;
        let weights = barycentric.map(f64::from);
        let [v, w] = inset(
            weights,
            [(c - b).length(), (a - c).length(), (b - a).length()]
                .map(|edge| INSET * LIFT * largest * edge / twice_area.length()),
        );
        let moved = (b - a) * (v - weights[1]) + (c - a) * (w - weights[2]);
        let part = (MOVE * LIFT * largest / moved.length()).min(1.0);
        let [v, w] = [weights[1] + (v - weights[1]) * part, weights[2] + (w - weights[2]) * part];
        let world_from_tree: &DMat4 = tree.world_from_tree;
        let [a, ab, ac] = [
            world_from_tree.transform_point3(a),
            world_from_tree.transform_vector3(b - a),
            world_from_tree.transform_vector3(c - a),
        ];
        let normal = ab.cross(ac).try_normalize()?;
        let lift = world_from_tree.transform_vector3(in_tree * (largest * LIFT));
        let lift = if lift.dot(normal) < 0.0 { -lift } else { lift };
        let position = a + ab * v + ac * w;
        position.is_finite().then_some(SurfacePlace { position, normal, lift })
    }
}

/// The weights of the second and the third corner, with each corner's weight at least what `least` says,
/// and at least a third of all where the triangle is too small for that.
fn inset(weights: [f64; 3], least: [f64; 3]) -> [f64; 2] {
    let least = least.map(|least| least.min(1.0 / 3.0));
    let raised: [f64; 3] = std::array::from_fn(|at| weights[at].max(least[at]));
    // What is above the least is scaled, so that they add up to 1.
    let above: [f64; 3] = std::array::from_fn(|at| raised[at] - least[at]);
    let (sum, room) = (above.iter().sum::<f64>(), 1.0 - least.iter().sum::<f64>());
    let scale = if sum > 0.0 { room / sum } else { 0.0 };
    [least[1] + above[1] * scale, least[2] + above[2] * scale]
}
