//! Vertices out of arrays: of the program's memory or of buffer objects, by section 2.8 of OpenGL 1.5.

use crate::convert;
use crate::enums as gl;
use crate::state::arrays::VertexArray;

/// The program's memory, which the C side lends for the length of a call.
pub trait ClientMemory {
    /// `length` bytes from an address on. What the program promises to be there is there.
    fn bytes(&self, address: usize, length: usize) -> &[u8];
}

/// No memory at all: for programs in Rust, whose arrays are in buffer objects.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoClientMemory;

impl ClientMemory for NoClientMemory {
    fn bytes(&self, _: usize, _: usize) -> &[u8] {
        &[]
    }
}

/// Which attributes have arrays, and their values for a run of vertices.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fetched {
    pub(crate) positions: Vec<[f32; 4]>,
    pub(crate) normals: Option<Vec<[f32; 3]>>,
    pub(crate) colors: Option<Vec<[f32; 4]>>,
    pub(crate) secondary: Option<Vec<[f32; 3]>>,
    pub(crate) edge_flags: Option<Vec<bool>>,
    pub(crate) fog_coords: Option<Vec<f32>>,
    /// By unit.
    pub(crate) tex_coords: Vec<Option<Vec<[f32; 4]>>>,
}

impl Fetched {
    /// Bytes that it takes.
    pub(crate) fn bytes(&self) -> usize {
        fn of<T>(values: Option<&Vec<T>>) -> usize {
            values.map_or(0, |values| size_of_val(values.as_slice()))
        }
        of(Some(&self.positions))
            + of(self.normals.as_ref())
            + of(self.colors.as_ref())
            + of(self.secondary.as_ref())
            + of(self.edge_flags.as_ref())
            + of(self.fog_coords.as_ref())
            + self.tex_coords.iter().map(|values| of(values.as_ref())).sum::<usize>()
    }
}

/// Vertices of arrays, and the order in which a draw takes them.
#[derive(Clone, Debug, Default)]
pub(crate) struct ArrayDraw {
    pub(crate) mode: u32,
    pub(crate) vertices: Fetched,
    /// Numbers of vertices; `None` for one after the other.
    pub(crate) elements: Option<Vec<u32>>,
}

/// Which vertices are fetched.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Wanted<'a> {
    Range { first: usize, count: usize },
    List(&'a [u32]),
}

impl Wanted<'_> {
    pub(crate) fn count(&self) -> usize {
        match self {
            Self::Range { count, .. } => *count,
            Self::List(list) => list.len(),
        }
    }

    /// The first vertex, and how many from it on there are in memory.
    pub(crate) fn span(&self) -> (usize, usize) {
        match *self {
            Self::Range { first, count } => (first, count),
            Self::List(list) => {
                if list.is_empty() {
                    return (0, 0);
                }
                let first = list.iter().fold(u32::MAX, |least, number| least.min(*number));
                let last = list.iter().fold(0, |most, number| most.max(*number));
                (first as usize, (last - first) as usize + 1)
            }
        }
    }
}

/// Where an array's bytes of some vertices begin, and how many they are; `None` where no memory is as large.
pub(crate) fn byte_range(
    array: &VertexArray,
    first: usize,
    count: usize,
) -> Option<(usize, usize)> {
    if count == 0 {
        return Some((array.pointer, 0));
    }
    let start = first.checked_mul(array.step())?.checked_add(array.pointer)?;
    let length = (count - 1).checked_mul(array.step())?.checked_add(array.element_bytes())?;
    start.checked_add(length)?;
    isize::try_from(length).ok()?;
    Some((start, length))
}

/// Elements of an array as `N` components of `f32`, those that it hasn't from `fill`. Elements that the bytes don't hold
/// are `fill`: a buffer object may be too short.
///
/// `bytes` begins at the first vertex of the span.
pub(crate) fn decode<const N: usize>(
    array: &VertexArray,
    bytes: &[u8],
    vertices: Wanted<'_>,
    normalized: bool,
    fill: [f32; N],
) -> Vec<[f32; N]> {
    macro_rules! each {
        ($number:ty, $of:expr) => {{
            const WIDTH: usize = size_of::<$number>();
            let of: fn($number) -> f32 = $of;
            let of = |bytes: &[u8; WIDTH]| of(<$number>::from_ne_bytes(*bytes));
            match array.size.min(N) {
                1 => elements::<N, 1, WIDTH>(array, bytes, vertices, fill, of),
                2 => elements::<N, 2, WIDTH>(array, bytes, vertices, fill, of),
                3 => elements::<N, 3, WIDTH>(array, bytes, vertices, fill, of),
                _ => elements::<N, 4, WIDTH>(array, bytes, vertices, fill, of),
            }
        }};
    }
    match (array.data_type, normalized) {
        (gl::FLOAT, _) => each!(f32, |value| value),
        (gl::DOUBLE, _) => each!(f64, |value| value as f32),
        (gl::BYTE, true) => each!(i8, convert::byte),
        (gl::UNSIGNED_BYTE, true) => each!(u8, convert::ubyte),
        (gl::SHORT, true) => each!(i16, convert::short),
        (gl::UNSIGNED_SHORT, true) => each!(u16, convert::ushort),
        (gl::INT, true) => each!(i32, convert::int),
        (gl::UNSIGNED_INT, true) => each!(u32, convert::uint),
        (gl::BYTE, false) => each!(i8, f32::from),
        (gl::UNSIGNED_BYTE, false) => each!(u8, f32::from),
        (gl::SHORT, false) => each!(i16, f32::from),
        (gl::UNSIGNED_SHORT, false) => each!(u16, f32::from),
        (gl::INT, false) => each!(i32, |value| value as f32),
        _ => each!(u32, |value| value as f32),
    }
}

/// Elements of `SIZE` components of `WIDTH` bytes each.
fn elements<const N: usize, const SIZE: usize, const WIDTH: usize>(
    array: &VertexArray,
    bytes: &[u8],
    vertices: Wanted<'_>,
    fill: [f32; N],
    of: impl Fn(&[u8; WIDTH]) -> f32,
) -> Vec<[f32; N]> {
    let step = array.step();
    let element = |number: usize| {
        let mut values = fill;
        let start = number * step;
        if let Some(bytes) = bytes.get(start..start + SIZE * WIDTH) {
            for (value, bytes) in values.iter_mut().zip(bytes.as_chunks().0) {
                *value = of(bytes);
            }
        }
        values
    };
    match vertices {
        Wanted::Range { count, .. } => (0..count).map(element).collect(),
        Wanted::List(list) => {
            let (first, _) = vertices.span();
            list.iter().map(|&number| element(number as usize - first)).collect()
        }
    }
}

/// Indices of a type that is one, as `u32`; those that the bytes don't hold are left out.
pub(crate) fn decode_indices(data_type: u32, bytes: &[u8]) -> Vec<u32> {
    match data_type {
        gl::UNSIGNED_BYTE => bytes.iter().map(|&index| u32::from(index)).collect(),
        gl::UNSIGNED_SHORT => {
            bytes.as_chunks().0.iter().map(|b| u32::from(u16::from_ne_bytes(*b))).collect()
        }
        _ => bytes.as_chunks().0.iter().map(|b| u32::from_ne_bytes(*b)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_2_8_elements_are_strided_converted_and_filled_up() {
        let mut array = crate::state::arrays::Arrays::default().color;
        (array.size, array.data_type, array.stride) = (3, gl::UNSIGNED_BYTE, 4);
        let bytes = [255, 0, 51, 9, 0, 255, 0, 9, 102, 0, 0];
        let all = Wanted::Range { first: 0, count: 4 };
        let colors = decode(&array, &bytes, all, true, [0.0, 0.0, 0.0, 1.0]);
        let expected = [
            [1.0, 0.0, 0.2, 1.0],
            [0.0, 1.0, 0.0, 1.0],
            [0.4, 0.0, 0.0, 1.0],
            [0.0, 0.0, 0.0, 1.0],
        ];
        assert_eq!(colors, expected);
        let listed = decode(&array, &bytes[4..], Wanted::List(&[2, 1]), true, [0.0; 4]);
        assert_eq!(listed, [[0.4, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]]);
        assert_eq!(byte_range(&array, 1, 2), Some((4, 7)));
        assert_eq!(byte_range(&array, usize::MAX, 2), None);
    }

    #[test]
    fn section_2_8_indices_have_three_types() {
        assert_eq!(decode_indices(gl::UNSIGNED_BYTE, &[1, 255]), [1, 255]);
        let shorts: Vec<u8> = [7_u16, 65535].iter().flat_map(|index| index.to_ne_bytes()).collect();
        assert_eq!(decode_indices(gl::UNSIGNED_SHORT, &shorts), [7, 65535]);
    }
}
