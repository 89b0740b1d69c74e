//! A ray in the form of the triangle test.

use crate::ray::{axis_order, longest_axis};

/// The transform that takes a ray to the z axis: a permutation of axes and a shear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShearedRay {
    /// The axis of the direction's largest component, and whether that component is negative.
    pub(crate) last: usize,
    pub(crate) is_negative: bool,
    /// In the order of [`axis_order`], as is the shear.
    pub(crate) origin: [f32; 3],
    pub(crate) shear: [f32; 3],
}

impl ShearedRay {
    pub(crate) fn new(origin: [f32; 3], direction: [f32; 3]) -> Self {
        let [x, y, z] = direction.map(|along| 1.0 / along);
        Self::with_inverse(&origin, &direction, &[x, y, z, 0.0])
    }

    /// With the reciprocal direction already computed.
    #[inline(always)]
    pub(crate) fn with_inverse(
        origin: &[f32; 3],
        direction: &[f32; 3],
        inverse: &[f32; 4],
    ) -> Self {
        let last = longest_axis(direction);
        let [x, y, z] = axis_order(last);
        let inverse = inverse[z];
        Self {
            last,
            is_negative: inverse < 0.0,
            origin: [origin[x], origin[y], origin[z]],
            shear: [direction[x] * inverse, direction[y] * inverse, inverse],
        }
    }

    /// Transforms three corners, whose axes are in the ray's order.
    #[inline(always)]
    pub(super) fn transform(&self, corners: [[f32; 3]; 3]) -> [[f32; 3]; 3] {
        let [ox, oy, oz] = self.origin;
        let [sx, sy, sz] = self.shear;
        let mut transformed = [[0.0; 3]; 3];
        for (to, [x, y, z]) in transformed.iter_mut().zip(corners) {
            let along = z - oz;
            *to = [x - ox - sx * along, y - oy - sy * along, sz * along];
        }
        transformed
    }

    /// Barycentric coordinates of the hit on a triangle that the ray hits, computed in `f64`. The
    /// corners' axes are in the ray's order.
    #[inline(always)]
    pub(crate) fn barycentric(&self, corners: [[f32; 3]; 3]) -> [f32; 3] {
        let weights = edge_functions(&self.transform(corners));
        let sum = weights[0] + weights[1] + weights[2];
        weights.map(|weight| (weight / sum) as f32)
    }
}

/// The three edge functions, with exact signs.
#[inline(always)]
pub(super) fn edge_functions(corners: &[[f32; 3]; 3]) -> [f64; 3] {
    let [a, b, c] = corners.map(|[x, y, _]| [f64::from(x), f64::from(y)]);
    [c[0] * b[1] - c[1] * b[0], a[0] * c[1] - a[1] * c[0], b[0] * a[1] - b[1] * a[0]]
}
