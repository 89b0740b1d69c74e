//! Sixteen rays side by side, and their way into the coordinates of a tree.

use crate::body_tree::BodyTree;
use crate::surface_place::dot;
use crate::world_ray::WorldRay;
use glam::{DMat4, DVec3, DVec4};
use luxel_math::prelude::*;
use luxel_math::{LANES, f32x16, i32x16, lanes_of};

/// Up to sixteen rays in world space, all from t = 0 on.
#[derive(Clone, Debug)]
pub struct RayLanes {
    /// The points at t = 0, axis by axis.
    pub origin: [[f64; LANES]; 3],
    /// The directions, of any length but 0.
    pub direction: [[f64; LANES]; 3],
    /// The largest t, which may be infinite.
    pub end: [f64; LANES],
    /// A bit for each lane that has a ray.
    pub lanes: u32,
}

/// How rays that are traced together run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// Close together, as those from neighbouring places to one light: they share their tests.
    Narrow,
    /// All ways, as those that measure openness.
    Wide,
}

impl RayLanes {
    /// No rays.
    pub const NONE: Self = Self {
        origin: [[0.0; LANES]; 3],
        direction: [[0.0; LANES]; 3],
        end: [0.0; LANES],
        lanes: 0,
    };

    /// The ray of a lane.
    ///
    /// # Panics
    /// If there are fewer lanes.
    #[must_use]
    pub fn ray(&self, lane: usize) -> WorldRay {
        let vector =
            |rows: &[[f64; LANES]; 3]| DVec3::new(rows[0][lane], rows[1][lane], rows[2][lane]);
        WorldRay {
            origin: vector(&self.origin),
            direction: vector(&self.direction),
            range: [0.0, self.end[lane]],
        }
    }

    /// Puts a ray that begins at t = 0 into a lane.
    ///
    /// # Panics
    /// If there are fewer lanes.
    pub fn put(&mut self, lane: usize, ray: &WorldRay) {
        for axis in 0..3 {
            self.origin[axis][lane] = ray.origin[axis];
            self.direction[axis][lane] = ray.direction[axis];
        }
        self.end[lane] = ray.range[1];
        self.lanes |= 1 << lane;
    }

    /// The rays in the coordinates of a tree, as columns: what [`RebasedRay`](crate::RebasedRay) makes of those that
    /// begin inside of the sphere around it, which are a bit each. Then those that begin outside and may reach the
    /// sphere.
    ///
    /// No square root of glam's comes here: it is an instruction of SSE, which waits for hundreds of cycles
    /// amid those of AVX. Two of them were four fifths of this function's time.
    #[inline(always)]
    pub(crate) fn rebased<S: Simd>(
        &self,
        simd: S,
        tree: &BodyTree<'_>,
        (centre, radius): (DVec3, f64),
    ) -> ([f32x16<S>; 8], [u32; 2]) {
        let simd = f32x16::splat(simd, 0.0);
        let wide = simd.to_f64();
        let [x, y, z] = &self.origin;
        let origin = [wide.load(x), wide.load(y), wide.load(z)];
        let [x, y, z] = &self.direction;
        let direction = [wide.load(x), wide.load(y), wide.load(z)];
        let DMat4 { x_axis, y_axis, z_axis, w_axis } = tree.tree_from_world;
        let axes = [x_axis, y_axis, z_axis].map(DVec4::truncate);
        let [x, y, z] = turned(origin, axes);
        let origin =
            [x + wide.constant(w_axis.x), y + wide.constant(w_axis.y), z + wide.constant(w_axis.z)];
        let (unit, length) = match self.only_direction() {
            Some(direction) => {
                let ([x, y, z], length) = unit_and_length(direction, axes);
                ([wide.constant(x), wide.constant(y), wide.constant(z)], wide.constant(length))
            }
            None => unit_and_length(direction, axes),
        };
        let way = [
            origin[0] - wide.constant(centre.x),
            origin[1] - wide.constant(centre.y),
            origin[2] - wide.constant(centre.z),
        ];
        let is_outside = (dot(way, way) - wide.constant(radius * radius)).is_positive();
        let outside = is_outside.bits() & self.lanes;
        let end = wide.load(&self.end) * length;
        let mut passing = 0;
        // Rays of shadows begin inside, but for those of the ground.
        if outside != 0 {
            // A sphere of 2.1 times the radius: `RebasedRay` takes 2, and rounding needs some room.
            let wider = wide.constant(2.1 * radius);
            let along = -dot(way, unit);
            let across =
                [way[0] + unit[0] * along, way[1] + unit[1] * along, way[2] + unit[2] * along];
            let aside = dot(across, across);
            let passes = (aside - wider * wider).is_positive()
                | (-(along + wider)).is_positive()
                | (along - wider - end).is_positive();
            passing = passes.bits();
        }
        // The next larger `f32`, which for numbers from 0 on has the next bits.
        let end = end.to_f32();
        let bits = end.bitcast::<i32x16<S>>();
        let end = end.simd_lt(f32::INFINITY).select(bits + 1, bits).bitcast::<f32x16<S>>();
        let columns = [
            origin[0].to_f32(),
            origin[1].to_f32(),
            origin[2].to_f32(),
            unit[0].to_f32(),
            unit[1].to_f32(),
            unit[2].to_f32(),
            simd,
            end,
        ];
        (columns, [!outside & self.lanes, outside & !passing])
    }

    /// The direction that all lanes share, as those to a light far away do: in lanes, its root and its
    /// divisions take as long as everything else about it.
    #[inline(always)]
    fn only_direction(&self) -> Option<[f64; 3]> {
        let mut differs = 0;
        for row in &self.direction {
            differs |= row.iter().fold(0, |bits, x| bits | (x.to_bits() ^ row[0].to_bits()));
        }
        let [x, y, z] = &self.direction;
        (differs == 0).then_some([x[0], y[0], z[0]])
    }

    /// All rays.
    pub(crate) fn rays(&self) -> impl Iterator<Item = WorldRay> {
        lanes_of(self.lanes).map(|lane| self.ray(lane))
    }
}

/// Directions through the columns of a matrix, of unit length, and the lengths that they had.
#[inline(always)]
fn unit_and_length<F: F64Lanes>(direction: [F; 3], axes: [DVec3; 3]) -> ([F; 3], F) {
    let [x, y, z] = turned(direction, axes);
    let length = dot([x, y, z], [x, y, z]).sqrt();
    ([x / length, y / length, z / length], length)
}

/// Vectors through the columns of a matrix.
#[inline(always)]
fn turned<F: F64Lanes>([x, y, z]: [F; 3], [a, b, c]: [DVec3; 3]) -> [F; 3] {
    [
        x * x.constant(a.x) + y * y.constant(b.x) + z * z.constant(c.x),
        x * x.constant(a.y) + y * y.constant(b.y) + z * z.constant(c.y),
        x * x.constant(a.z) + y * y.constant(b.z) + z * z.constant(c.z),
    ]
}
