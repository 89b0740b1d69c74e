//! Where a pixel lies in a texture, and how much of it it covers.

use luxel_math::Lanes;

/// Coordinates divided by q at the centre of a pixel, and how they change to a pixel to the right and one above.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Footprint<N> {
    pub(crate) at: [N; 3],
    pub(crate) per_pixel: [[N; 3]; 2],
}

impl<N: Lanes> Footprint<N> {
    /// On an image of so many dimensions: other axes don't change.
    #[inline(always)]
    pub(super) fn on_image(mut self, dimensions: usize) -> Self {
        let zero = self.at[0].zero();
        for change in &mut self.per_pixel {
            for change in &mut change[dimensions..] {
                *change = zero;
            }
        }
        self
    }

    /// On a face of a cube: +x, -x, +y, -y, +z, -z (table 3.21).
    #[inline(always)]
    pub(super) fn on_face(&self, face: usize) -> Self {
        let at = face_coordinates(face, self.at);
        let mut per_pixel = self.per_pixel;
        for change in &mut per_pixel {
            for (change, direction) in change.iter_mut().zip(self.at) {
                *change = direction + *change;
            }
            *change = face_coordinates(face, *change);
            for (change, at) in change.iter_mut().zip(at) {
                *change = *change - at;
            }
        }
        Self { at, per_pixel }
    }
}

/// s = (s_c / |m| + 1) / 2, t = (t_c / |m| + 1) / 2.
#[inline(always)]
fn face_coordinates<N: Lanes>(face: usize, [x, y, z]: [N; 3]) -> [N; 3] {
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
            let place = Footprint { at: [x, y, z], per_pixel: [[0.0; 3]; 2] }.on_face(face);
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
    fn section_3_8_8_changes_on_a_face_are_those_of_the_place_there() {
        let per_pixel = [[0.0, 0.5, 0.0], [2.0, 0.0, 0.0]];
        let place = Footprint { at: [2.0, 1.0, 1.0], per_pixel }.on_face(0);
        assert_eq!(place.per_pixel, [[0.0, -0.125, 0.0], [0.125, 0.125, 0.0]]);
        let image = Footprint { at: [0.0; 3], per_pixel }.on_image(1);
        assert_eq!(image.per_pixel, [[0.0; 3], [2.0, 0.0, 0.0]]);
    }
}
