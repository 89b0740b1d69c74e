//! The cone that holds the normals of a cluster's triangles: |n - a| <= s about an axis a.

use glam::DVec3;
use luxel_math::LANES;

/// Words of the cones of sixteen clusters: axis x16 y16 z16, spread, height.
pub(crate) const CONE_WORDS: usize = 5 * LANES;

/// The normals of some triangles, and the lowest of their heights upon their longest sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cone {
    axis: [f32; 3],
    /// How far the normals' ends lie from the axis' end at most.
    spread: f32,
    height: f32,
}

impl Cone {
    /// Of triangles that look to all sides, or of which nothing is known.
    pub(crate) const ANY: Self = Self { axis: [0.0; 3], spread: 2.0, height: 0.0 };

    /// Of triangles by their corners. Any, if one of them has no area, or no place.
    pub(crate) fn of(triangles: impl Iterator<Item = [[f32; 3]; 3]> + Clone) -> Self {
        let normals = triangles.map(|corners| {
            let [a, b, c] = corners.map(|[x, y, z]| DVec3::new(x.into(), y.into(), z.into()));
            let (ab, ac, bc) = (b - a, c - a, c - b);
            let normal = ab.cross(ac);
            let longest = ab.length_squared().max(ac.length_squared()).max(bc.length_squared());
            let doubled_area = normal.length();
            (normal / doubled_area, doubled_area / longest.sqrt())
        });
        let sum: DVec3 = normals.clone().map(|(normal, _)| normal).sum();
        let axis = sum.normalize_or_zero();
        let (mut spread, mut height) = (0.0_f64, f64::INFINITY);
        for (normal, own_height) in normals {
            spread = spread.max((normal - axis).length_squared());
            height = height.min(own_height);
        }
        // Comparisons with NaN are false. Rounded to the side that claims less.
        let spread = spread.sqrt() as f32 + 1e-6;
        let height = height as f32 * (1.0 - 1e-6);
        let is_known = sum.is_finite() && spread < 1.0 && height > 0.0 && height < f32::INFINITY;
        if is_known { Self { axis: axis.as_vec3().to_array(), spread, height } } else { Self::ANY }
    }

    /// Transposed for the lanes; the last group ends with any.
    pub(crate) fn by_sixteen(cones: &[Self]) -> Vec<f32> {
        let mut words = Vec::with_capacity(cones.len().next_multiple_of(LANES) * 5);
        for group in cones.chunks(LANES) {
            let padded = || group.iter().chain(std::iter::repeat(&Self::ANY)).take(LANES);
            for axis in 0..3 {
                words.extend(padded().map(|cone| cone.axis[axis]));
            }
            words.extend(padded().map(|cone| cone.spread));
            words.extend(padded().map(|cone| cone.height));
        }
        words
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cone(triangles: &[[[f32; 3]; 3]]) -> Cone {
        Cone::of(triangles.iter().copied())
    }

    #[test]
    fn a_cone_holds_the_normals_and_the_lowest_height() {
        let flat = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 2.0, 0.0]];
        let Cone { axis, spread, height } = cone(&[flat]);
        assert_eq!(axis, [0.0, 0.0, 1.0]);
        assert!(spread < 1e-5, "{spread}");
        assert!((height - 2.0).abs() < 1e-5 && height < 2.0, "{height}");

        // Turned by 30 degrees either way about x.
        let (sin, cos) = (0.5, 0.75_f32.sqrt());
        let turned = |sin: f32| [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 0.5 * cos, 0.5 * sin]];
        let Cone { axis, spread, height } = cone(&[turned(sin), turned(-sin)]);
        assert!((axis[2] - 1.0).abs() < 1e-6, "{axis:?}");
        // 2 sin(15 degrees)
        assert!((spread - 0.517_638).abs() < 1e-4, "{spread}");
        assert!((height - 0.5).abs() < 1e-5, "{height}");
    }

    #[test]
    fn triangles_without_area_or_place_or_a_side_in_common_have_no_cone() {
        let flat = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let [a, b, c] = flat;
        assert_eq!(cone(&[flat, [a, a, b]]), Cone::ANY);
        assert_eq!(cone(&[flat, [a, b, [f32::NAN, 0.0, 0.0]]]), Cone::ANY);
        assert_eq!(cone(&[flat, [a, b, [f32::INFINITY, 0.0, 0.0]]]), Cone::ANY);
        assert_eq!(cone(&[flat, [a, c, b]]), Cone::ANY);
        assert_eq!(cone(&[]), Cone::ANY);
    }
}
