//! Bicubic Bézier patches (Bézier 1970; Foley et al. 1990, section 11.3.2).

use super::builder::{MeshBuilder, SurfacePoint};
use glam::{DVec2, DVec3};

/// A patch: S(s, t) = sum over i, j of B_i(t) B_j(s) P_ij, with Bernstein's polynomials B of the
/// third degree. Seen from the front, s runs to the right along a row, t downwards from row to row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch(pub(crate) [[DVec3; 4]; 4]);

impl Patch {
    /// Adds the patch as `steps` x `steps` quadrilaterals; `uv` gives its texture coordinates
    /// from (s, t).
    pub(crate) fn tessellate(
        &self,
        builder: &mut MeshBuilder,
        steps: u32,
        uv: impl Fn(DVec2) -> DVec2,
    ) {
        let parameter = |step: u32| f64::from(step) / f64::from(steps);
        builder.grid(steps, steps, |column, row| {
            let (s, t) = (parameter(column), parameter(row));
            SurfacePoint {
                position: self.position(s, t),
                normal: self.normal(s, t),
                uv: uv(DVec2::new(s, t)),
            }
        });
    }

    fn position(&self, s: f64, t: f64) -> DVec3 {
        weighted(cubic(t), self.0.map(|row| weighted(cubic(s), row)))
    }

    /// The normal to the front, of any length: dS/dt x dS/ds.
    ///
    /// Where a whole row of control points is one place, dS/ds vanishes there. Near it, it grows
    /// like the distance times d2S/(ds dt), which takes its place, turned round at the patch's
    /// lower end, where the distance is measured backwards.
    fn normal(&self, s: f64, t: f64) -> DVec3 {
        let rows = self.0;
        let along_t = weighted(derivative(t), rows.map(|row| weighted(cubic(s), row)));
        let along_s = weighted(cubic(t), rows.map(|row| weighted(derivative(s), row)));
        let normal = along_t.cross(along_s);
        // Relative to the tangent's possible length, far below that of a regular patch.
        const VANISHING: f64 = 1e-12;
        if along_s.length_squared() > VANISHING * along_t.length_squared() {
            return normal;
        }
        let mixed = weighted(derivative(t), rows.map(|row| weighted(derivative(s), row)));
        along_t.cross(if t < 0.5 { mixed } else { -mixed })
    }
}

/// Bernstein's polynomials of the third degree.
///
/// Grouped, like the sums below, so that a mirrored patch has mirrored bits.
fn cubic(t: f64) -> [f64; 4] {
    let u = 1.0 - t;
    let both = 3.0 * (t * u);
    [u * u * u, both * u, both * t, t * t * t]
}

/// Their derivatives.
fn derivative(t: f64) -> [f64; 4] {
    let u = 1.0 - t;
    [-3.0 * u * u, 3.0 * u * u - 6.0 * t * u, 6.0 * t * u - 3.0 * t * t, 3.0 * t * t]
}

fn weighted([a, b, c, d]: [f64; 4], points: [DVec3; 4]) -> DVec3 {
    (points[0] * a + points[3] * d) + (points[1] * b + points[2] * c)
}
