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
/// of three products of them over the normal's length, is off by less than 8 such steps, 2^-20 M, for
/// triangles that are not needles. So rays don't hit their own triangle, nor, where the surface is
/// convex, its neighbours (Wächter and Binder, *A Fast and Robust Method for Avoiding Self-Intersection*,
/// Ray Tracing Gems, 2019, choose a similar step by trial). What lies nearer than the lift is not hit.
pub const LIFT: f64 = 1.0 / (1 << 20) as f64;

/// How near to an edge of its triangle a ray leaves, in units of the lift. At an edge itself, in a corner
/// of a room for example, the ray would begin in the plane of the other wall, or behind it.
const INSET: f64 = 4.0;

/// The farthest that a place is moved away from edges, in units of the lift: in an acute corner it stays
/// nearer to them than [`INSET`]. Origins thus lie within 8 lifts, 2^-17 M, of the place with the given
/// barycentrics.
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

/// The places of one triangle.
#[derive(Clone, Copy, Debug)]
pub struct TrianglePlaces {
    /// The first corner, and the ways to the others, in world space.
    corner: DVec3,
    ways: [DVec3; 2],
    /// The same ways in the tree's coordinates.
    in_tree: [DVec3; 2],
    normal: DVec3,
    lift: DVec3,
    /// The length of the lift in the tree's coordinates.
    lift_in_tree: f64,
    /// The least weights of the corners.
    least: [f64; 3],
}

impl SceneRays {
    /// The places of an object's triangle; `None` if it has no area.
    ///
    /// # Panics
    /// If there is no such object or triangle.
    #[must_use]
    pub fn places(&self, object: usize, triangle: u32) -> Option<TrianglePlaces> {
        let tree = self.tree(object);
        let corners = self.mesh(object).triangles[triangle as usize].map(|vertex| {
            let [x, y, z] = tree.positions[vertex as usize];
            DVec3::new(x.into(), y.into(), z.into())
        });
        let largest = corners.iter().map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
        let [a, b, c] = corners;
        let in_tree = [b - a, c - a];
        let twice_area = in_tree[0].cross(in_tree[1]);
        let normal_in_tree = twice_area.try_normalize()?;
        let lift_in_tree = LIFT * largest;
        let edge = INSET * lift_in_tree / twice_area.length();
        let least =
            [c - b, in_tree[1], in_tree[0]].map(|side| (side.length() * edge).min(1.0 / 3.0));
        let world_from_tree: &DMat4 = tree.world_from_tree;
        let corner = world_from_tree.transform_point3(a);
        let ways = in_tree.map(|way| world_from_tree.transform_vector3(way));
        let normal = ways[0].cross(ways[1]).try_normalize()?;
        let lift = world_from_tree.transform_vector3(normal_in_tree * lift_in_tree);
        let lift = if lift.dot(normal) < 0.0 { -lift } else { lift };
        corner.is_finite().then_some(TrianglePlaces {
            corner,
            ways,
            in_tree,
            normal,
            lift,
            lift_in_tree,
            least,
        })
    }
}

impl TrianglePlaces {
    /// The place with these barycentrics. Barycentrics of any error give a place in the plane, since the
    /// corners are the true ones.
    #[must_use]
    pub fn at(&self, barycentric: [f32; 3]) -> SurfacePlace {
        let Self { corner, ways, in_tree, normal, lift, lift_in_tree, ref least } = *self;
        let [u, mut v, mut w] = barycentric.map(f64::from);
        if u < least[0] || v < least[1] || w < least[2] {
            let [inner_v, inner_w] = inset([u, v, w], *least);
            let (by_v, by_w) = (inner_v - v, inner_w - w);
            let moved = (in_tree[0] * by_v + in_tree[1] * by_w).length();
            let part = (MOVE * lift_in_tree / moved).min(1.0);
            (v, w) = (v + by_v * part, w + by_w * part);
        }
        SurfacePlace { position: corner + ways[0] * v + ways[1] * w, normal, lift }
    }
}

/// The weights of the second and the third corner, with each corner's weight at least what `least` says.
fn inset(weights: [f64; 3], least: [f64; 3]) -> [f64; 2] {
    let raised: [f64; 3] = std::array::from_fn(|at| weights[at].max(least[at]));
    // What is above the least is scaled, so that they add up to 1.
    let above: [f64; 3] = std::array::from_fn(|at| raised[at] - least[at]);
    let (sum, room) = (above.iter().sum::<f64>(), 1.0 - least.iter().sum::<f64>());
    let scale = if sum > 0.0 { room / sum } else { 0.0 };
    [least[1] + above[1] * scale, least[2] + above[2] * scale]
}
