//! Places on triangles from which rays leave.

use crate::scene_rays::SceneRays;
use glam::DVec3;
use luxel_math::prelude::*;
use luxel_math::{LANES, lanes_of};

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

/// [`SurfacePlace`], lane by lane.
#[derive(Clone, Copy, Debug)]
pub struct PlaceLanes<F> {
    /// The places.
    pub position: [F; 3],
    /// The triangles' own normals.
    pub normal: [F; 3],
    /// From the places to the origins of rays.
    pub lift: [F; 3],
}

/// The places of one triangle.
#[derive(Clone, Copy, Debug, Default)]
pub struct TrianglePlaces {
    /// The first corner, the ways to the others, the normal and the lift, in world space. The fourth
    /// components of the first three are the least weights of the corners.
    rows: [[f64; 4]; 5],
    /// The ways to the other corners in the tree's coordinates.
    in_tree: [DVec3; 2],
    /// The length of the lift in the tree's coordinates.
    lift_in_tree: f64,
}

impl SceneRays {
    /// The places of an object's triangle; `None` if it has no area.
    ///
    /// # Panics
    /// If there is no such object or triangle.
    #[must_use]
    pub fn places(&self, object: usize, triangle: u32) -> Option<TrianglePlaces> {
        let mut places = TrianglePlaces::default();
        self.places_into(object, triangle, &mut places).then_some(places)
    }

    /// [`SceneRays::places`] written to where they are kept, which saves copies; returns whether there are
    /// any, else writes nothing.
    ///
    /// # Panics
    /// If there is no such object or triangle.
    pub fn places_into(&self, object: usize, triangle: u32, places: &mut TrianglePlaces) -> bool {
        let (body, triangle) = self.in_body(object, triangle);
        let tree = self.tree(body);
        let corners = self.mesh(body).triangles[triangle as usize].map(|vertex| {
            let [x, y, z] = tree.positions[vertex as usize];
            DVec3::new(x.into(), y.into(), z.into())
        });
        let largest = corners.iter().map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
        let [a, b, c] = corners;
        let in_tree = [b - a, c - a];
        let twice_area = in_tree[0].cross(in_tree[1]);
        let twice_area_length = length(twice_area);
        let Some(normal_in_tree) = over_length(twice_area, twice_area_length) else { return false };
        let lift_in_tree = LIFT * largest;
        let edge = INSET * lift_in_tree / twice_area_length;
        let sides = [c - b, in_tree[1], in_tree[0]];
        let least = sides.map(|side| (length(side) * edge).min(1.0 / 3.0));
        let world_from_tree = tree.world_from_tree.matrix();
        let corner = world_from_tree.transform_point3(a);
        let ways = in_tree.map(|way| world_from_tree.transform_vector3(way));
        let across = ways[0].cross(ways[1]);
        let Some(normal) = over_length(across, length(across)) else { return false };
        let lift = world_from_tree.transform_vector3(normal_in_tree * lift_in_tree);
        let lift = if lift.dot(normal) < 0.0 { -lift } else { lift };
        if !corner.is_finite() {
            return false;
        }
        let row = |DVec3 { x, y, z }, last| [x, y, z, last];
        places.rows = [
            row(corner, least[0]),
            row(ways[0], least[1]),
            row(ways[1], least[2]),
            row(normal, 0.0),
            row(lift, 0.0),
        ];
        places.in_tree = in_tree;
        places.lift_in_tree = lift_in_tree;
        true
    }
}

/// The length of a vector. Not glam's, whose root is a call into `libm` that several can't share.
#[inline(always)]
fn length(vector: DVec3) -> f64 {
    vector.dot(vector).sqrt()
}

/// A vector of unit length from its length, by glam's operations; `None` if it has no direction.
#[inline(always)]
fn over_length(vector: DVec3, length: f64) -> Option<DVec3> {
    let reciprocal = 1.0 / length;
    (reciprocal.is_finite() && reciprocal > 0.0).then(|| vector * reciprocal)
}

impl TrianglePlaces {
    /// The place with these barycentrics. Barycentrics of any error give a place in the plane, since the
    /// corners are the true ones.
    #[must_use]
    pub fn at(&self, barycentric: [f32; 3]) -> SurfacePlace {
        Self::at_lanes(&[self; LANES], &barycentric, 1).place()
    }

    /// [`TrianglePlaces::at`] of a triangle for each lane whose bit is set.
    #[inline(always)]
    #[must_use]
    pub fn at_lanes<N: Lanes>(
        of: &[&Self; LANES],
        barycentric: &[N; 3],
        lanes: u32,
    ) -> PlaceLanes<N::F64> {
        let [u, v, w] = *barycentric;
        let (u, mut v, mut w) = (u.to_f64(), v.to_f64(), w.to_f64());
        let [x, y, z, least_u] = columns::<N>(u, of, 0);
        let [first_x, first_y, first_z, least_v] = columns::<N>(u, of, 1);
        let [second_x, second_y, second_z, least_w] = columns::<N>(u, of, 2);
        let near =
            (least_u - u).is_positive() | (least_v - v).is_positive() | (least_w - w).is_positive();
        let near = near.bits() & lanes;
        if near != 0 {
            let mut weights = [[0.0; LANES]; 3];
            for (stored, weight) in weights.iter_mut().zip([u, v, w]) {
                weight.store(stored);
            }
            for lane in lanes_of(near) {
                let moved = of[lane].inset(weights.map(|weight| weight[lane]));
                [weights[1][lane], weights[2][lane]] = moved;
            }
            (v, w) = (v.load(&weights[1]), w.load(&weights[2]));
        }
        let position = [
            x + first_x * v + second_x * w,
            y + first_y * v + second_y * w,
            z + first_z * v + second_z * w,
        ];
        let [x, y, z, _] = columns::<N>(u, of, 3);
        let normal = [x, y, z];
        let [x, y, z, _] = columns::<N>(u, of, 4);
        PlaceLanes { position, normal, lift: [x, y, z] }
    }

    /// The weights of the second and the third corner, moved away from the edges.
    fn inset(&self, [u, v, w]: [f64; 3]) -> [f64; 2] {
        let Self { rows, in_tree, lift_in_tree } = self;
        let [inner_v, inner_w] = inset([u, v, w], [rows[0][3], rows[1][3], rows[2][3]]);
        let (by_v, by_w) = (inner_v - v, inner_w - w);
        let moved = (in_tree[0] * by_v + in_tree[1] * by_w).length();
        let part = (MOVE * lift_in_tree / moved).min(1.0);
        [v + by_v * part, w + by_w * part]
    }
}

/// A row of each lane's triangle, as columns; `simd` selects the lane type.
#[inline(always)]
fn columns<N: Lanes>(simd: N::F64, of: &[&TrianglePlaces; LANES], row: usize) -> [N::F64; 4] {
    simd.load_transposed(
        #[inline(always)]
        |lane| &of[lane % LANES].rows[row],
    )
}

impl<F: F64Lanes> PlaceLanes<F> {
    /// The same places with their normals on the side of a direction, which is given for each.
    #[inline(always)]
    #[must_use]
    pub fn facing(self, direction: [F; 3]) -> Self {
        // A product with -1 turns the sign and rounds nothing.
        let simd = direction[0].to_f32();
        let is_away = (-dot(self.normal, direction)).is_positive();
        let side = simd.constant(-1.0).select(is_away, simd.one()).to_f64();
        Self {
            position: self.position,
            normal: scaled(self.normal, side),
            lift: scaled(self.lift, side),
        }
    }

    /// The place of each lane, where it has one.
    #[inline(always)]
    pub fn each(&self, lanes: u32, mut work: impl FnMut(usize, SurfacePlace)) {
        let mut stored = [[[0.0; LANES]; 3]; 3];
        for (stored, lanes) in stored.iter_mut().zip([self.position, self.normal, self.lift]) {
            for (stored, lanes) in stored.iter_mut().zip(lanes) {
                lanes.store(stored);
            }
        }
        for lane in lanes_of(lanes) {
            let [position, normal, lift] =
                stored.map(|[x, y, z]| DVec3::new(x[lane], y[lane], z[lane]));
            work(lane, SurfacePlace { position, normal, lift });
        }
    }

    /// The origins of rays that leave on the normals' sides.
    #[inline(always)]
    #[must_use]
    pub fn origin(&self) -> [F; 3] {
        let ([x, y, z], [lift_x, lift_y, lift_z]) = (self.position, self.lift);
        [x + lift_x, y + lift_y, z + lift_z]
    }
}

impl PlaceLanes<f64> {
    /// The only place.
    #[must_use]
    pub fn place(&self) -> SurfacePlace {
        let [position, normal, lift] =
            [self.position, self.normal, self.lift].map(DVec3::from_array);
        SurfacePlace { position, normal, lift }
    }
}

impl From<&SurfacePlace> for PlaceLanes<f64> {
    fn from(place: &SurfacePlace) -> Self {
        let [position, normal, lift] =
            [place.position, place.normal, place.lift].map(|of| of.to_array());
        Self { position, normal, lift }
    }
}

/// The product of two vectors, lane by lane.
#[inline(always)]
pub(crate) fn dot<F: F64Lanes>([x, y, z]: [F; 3], [a, b, c]: [F; 3]) -> F {
    x * a + y * b + z * c
}

#[inline(always)]
fn scaled<F: F64Lanes>([x, y, z]: [F; 3], by: F) -> [F; 3] {
    [x * by, y * by, z * by]
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
