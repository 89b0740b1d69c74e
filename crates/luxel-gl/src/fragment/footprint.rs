//! Where a pixel lies in a texture, and how much of it it covers.

use luxel_math::Lanes;

/// s, t, r and q at the centre of a pixel, a pixel to the right and a pixel above.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Footprint<N> {
    pub(crate) centre: [N; 4],
    pub(crate) right: [N; 4],
    pub(crate) above: [N; 4],
}

/// Coordinates on an image, and how they change from pixel to pixel.
pub(super) struct Place<N> {
    pub(super) at: [N; 3],
    pub(super) per_pixel: [[N; 3]; 2],
}

impl<N: Lanes> Footprint<N> {
    /// Divided by q; axes beyond `dimensions` don't change.
    #[inline(always)]
    pub(super) fn divided(&self, dimensions: usize) -> Place<N> {
        let zero = self.centre[0].zero();
        let at = by_q(self.centre);
        let mut per_pixel = [by_q(self.right), by_q(self.above)];
        for change in &mut per_pixel {
            for (axis, (change, at)) in change.iter_mut().zip(at).enumerate() {
                *change = if axis < dimensions { *change - at } else { zero };
            }
        }
        Place { at, per_pixel }
    }

    /// On a face of a cube: +x, -x, +y, -y, +z, -z (table 3.21).
    #[inline(always)]
    pub(super) fn on_face(&self, face: usize) -> Place<N> {
        let at = face_coordinates(face, self.centre);
        let mut per_pixel =
            [face_coordinates(face, self.right), face_coordinates(face, self.above)];
        for change in &mut per_pixel {
            for (change, at) in change.iter_mut().zip(at) {
                *change = *change - at;
            }
        }
        Place { at, per_pixel }
    }
}

#[inline(always)]
fn by_q<N: Lanes>([s, t, r, q]: [N; 4]) -> [N; 3] {
    let scale = q.one() / q;
    [s * scale, t * scale, r * scale]
}

/// s = (s_c / |m| + 1) / 2, t = (t_c / |m| + 1) / 2.
#[inline(always)]
fn face_coordinates<N: Lanes>(face: usize, [x, y, z, _]: [N; 4]) -> [N; 3] {
    let (s, t, major) = match face {
        0 => (-z, -y, x),
        1 => (z, -y, -x),
        2 => (x, z, y),
        3 => (x, -z, -y),
        4 => (x, -y, z),
        _ => (-x, -y, -z),
    };
    let half = s.constant(0.5);
    let scale = half / major;
    [s * scale + half, t * scale + half, s.zero()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_3_21_each_face_has_its_axes() {
        let on_face = |face, x: f32, y, z| {
            let centre = [x, y, z, 1.0];
            let place = Footprint { centre, right: centre, above: centre }.on_face(face);
            [place.at[0], place.at[1]]
        };
        assert_eq!(on_face(0, 2.0, 1.0, 1.0), [0.25, 0.25]);
        assert_eq!(on_face(1, -2.0, 1.0, 1.0), [0.75, 0.25]);
        assert_eq!(on_face(2, 1.0, 2.0, -1.0), [0.75, 0.25]);
        assert_eq!(on_face(3, 1.0, -2.0, -1.0), [0.75, 0.75]);
        assert_eq!(on_face(4, 1.0, 1.0, 2.0), [0.75, 0.25]);
        assert_eq!(on_face(5, 1.0, 1.0, -2.0), [0.25, 0.25]);
    }

    #[test]
    fn section_3_8_8_coordinates_are_divided_by_q_before_they_are_compared() {
        let footprint = Footprint {
            centre: [1.0, 2.0, 3.0, 2.0],
            right: [2.0, 2.0, 3.0, 2.0],
            above: [1.0, 2.0, 3.0, 1.0],
        };
        let place = footprint.divided(2);
        assert_eq!(place.at, [0.5, 1.0, 1.5]);
        assert_eq!(place.per_pixel, [[0.5, 0.0, 0.0], [0.5, 1.0, 0.0]]);
    }
}
