//! From the modes of primitives to triangles, segments and points (glTF 2.0 specification, section
//! 3.7.2.1).

/// How the vertices of a primitive are connected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    Points,
    Lines,
    LineLoop,
    LineStrip,
    Triangles,
    TriangleStrip,
    TriangleFan,
}

impl Mode {
    /// Maps OpenGL's constants, which glTF uses.
    pub(crate) const fn from_code(code: u32) -> Option<Self> {
        Some(match code {
            0 => Self::Points,
            1 => Self::Lines,
            2 => Self::LineLoop,
            3 => Self::LineStrip,
            4 => Self::Triangles,
            5 => Self::TriangleStrip,
            6 => Self::TriangleFan,
            _ => return None,
        })
    }

    /// Whether it draws triangles.
    pub(crate) const fn has_triangles(self) -> bool {
        matches!(self, Self::Triangles | Self::TriangleStrip | Self::TriangleFan)
    }

    /// Number of trailing vertices that complete no primitive.
    pub(crate) const fn left_over(self, vertices: usize) -> usize {
        match self {
            Self::Points => 0,
            Self::Lines => vertices % 2,
            Self::LineLoop | Self::LineStrip => (vertices < 2) as usize * vertices,
            Self::Triangles => vertices % 3,
            Self::TriangleStrip | Self::TriangleFan => (vertices < 3) as usize * vertices,
        }
    }
}

/// The triangles of a mode, with the corners in the order that the specification gives, which keeps
/// their winding the same.
pub(crate) fn triangles(mode: Mode, vertices: &[u32]) -> Vec<[u32; 3]> {
    match mode {
        Mode::Triangles => vertices.as_chunks::<3>().0.to_vec(),
        Mode::TriangleStrip => {
            let turned = |(index, corners): (usize, &[u32])| {
                let [a, b, c] = [corners[0], corners[1], corners[2]];
                if index % 2 == 0 { [a, b, c] } else { [a, c, b] }
            };
            vertices.windows(3).enumerate().map(turned).collect()
        }
        Mode::TriangleFan => {
            let Some((&hub, rim)) = vertices.split_first() else { return Vec::new() };
            rim.windows(2).map(|pair| [pair[0], pair[1], hub]).collect()
        }
        Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => Vec::new(),
    }
}

/// The segments of a mode.
pub(crate) fn segments(mode: Mode, vertices: &[u32]) -> Vec<[u32; 2]> {
    match mode {
        Mode::Lines => vertices.as_chunks::<2>().0.to_vec(),
        Mode::LineStrip | Mode::LineLoop => {
            let mut segments: Vec<_> = vertices.windows(2).map(|pair| [pair[0], pair[1]]).collect();
            if let (Mode::LineLoop, [first, _, .., last]) = (mode, vertices) {
                segments.push([*last, *first]);
            }
            segments
        }
        Mode::Points | Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_second_triangle_of_a_strip_swaps_two_corners() {
        let strip = triangles(Mode::TriangleStrip, &[5, 6, 7, 8, 9]);
        assert_eq!(strip, [[5, 6, 7], [6, 8, 7], [7, 8, 9]]);
    }

    #[test]
    fn a_fan_turns_about_its_first_vertex() {
        assert_eq!(triangles(Mode::TriangleFan, &[5, 6, 7, 8]), [[6, 7, 5], [7, 8, 5]]);
    }

    #[test]
    fn a_loop_is_closed() {
        assert_eq!(segments(Mode::LineLoop, &[1, 2, 3]), [[1, 2], [2, 3], [3, 1]]);
        assert_eq!(segments(Mode::LineStrip, &[1, 2, 3]), [[1, 2], [2, 3]]);
        assert_eq!(segments(Mode::LineLoop, &[1]), [[0_u32; 2]; 0]);
    }

    #[test]
    fn incomplete_primitives_are_dropped() {
        for mode in (0..7).filter_map(Mode::from_code) {
            assert!(triangles(mode, &[1, 2]).is_empty());
            assert!(segments(mode, &[1]).is_empty());
        }
        assert_eq!(Mode::Triangles.left_over(8), 2);
        assert_eq!(Mode::TriangleFan.left_over(2), 2);
        assert_eq!(Mode::TriangleFan.left_over(3), 0);
    }
}
