//! The index codecs: triangles that share edges with the ones before, and plain sequences.

use super::{Cursor, unzigzag};

const TRIANGLES_HEADER: u8 = 0xe1;
const SEQUENCE_HEADER: u8 = 0xd1;
/// Length of the table of corner codes that ends a triangle stream.
const TRIANGLES_TAIL: usize = 16;
const SEQUENCE_TAIL: usize = 4;
const ESCAPE: u8 = 15;

/// The last sixteen entries, the latest at 0.
struct Recent<T> {
    ring: [T; 16],
    next: usize,
}

impl<T: Copy> Recent<T> {
    const fn new(value: T) -> Self {
        Self { ring: [value; 16], next: 0 }
    }

    fn push(&mut self, value: T) {
        self.ring[self.next & 15] = value;
        self.next = self.next.wrapping_add(1);
    }

    /// The entry pushed `age + 1` steps ago.
    fn get(&self, age: u8) -> T {
        self.ring[self.next.wrapping_sub(1 + usize::from(age)) & 15]
    }
}

/// The state that encoder and decoder of triangles share.
struct Triangles<'a> {
    data: Cursor<'a>,
    edges: Recent<[u32; 2]>,
    vertices: Recent<u32>,
    /// The lowest vertex that hasn't been used.
    next: u32,
    /// The last index written explicitly.
    last: u32,
}

impl Triangles<'_> {
    fn fresh(&mut self) -> u32 {
        let vertex = self.next;
        self.next = vertex.wrapping_add(1);
        vertex
    }

    fn explicit(&mut self) -> Result<u32, String> {
        self.last = self.last.wrapping_add(unzigzag(self.data.variable()?));
        Ok(self.last)
    }

    /// A triangle that shares an edge: the edge in the upper half of the code, the corner in the
    /// lower.
    fn across_edge(&mut self, code: u8) -> Result<[u32; 3], String> {
        let [a, b] = self.edges.get(code >> 4);
        let (c, is_new) = match code & 15 {
            0 => (self.fresh(), true),
            13 => {
                self.last = self.last.wrapping_sub(1);
                (self.last, true)
            }
            14 => {
                self.last = self.last.wrapping_add(1);
                (self.last, true)
            }
            ESCAPE => (self.explicit()?, true),
            age => (self.vertices.get(age), false),
        };
        if is_new {
            self.vertices.push(c);
        }
        self.edges.push([c, b]);
        self.edges.push([a, c]);
        Ok([a, b, c])
    }

    /// A triangle that shares no edge: how each corner is coded.
    fn alone(&mut self, first: u8, others: u8) -> Result<[u32; 3], String> {
        let codes = [first, others >> 4, others & 15];
        // Lookups use the vertices from before this triangle; explicit ones follow in order.
        let mut corners = [0; 3];
        for (corner, &code) in corners.iter_mut().zip(&codes) {
            *corner = match code {
                0 => self.fresh(),
                ESCAPE => 0,
                age => self.vertices.get(age - 1),
            };
        }
        for (corner, &code) in corners.iter_mut().zip(&codes) {
            if code == ESCAPE {
                *corner = self.explicit()?;
            }
        }
        for (&corner, &code) in corners.iter().zip(&codes) {
            if matches!(code, 0 | ESCAPE) {
                self.vertices.push(corner);
            }
        }
        let [a, b, c] = corners;
        self.edges.push([b, a]);
        self.edges.push([c, b]);
        self.edges.push([a, c]);
        Ok(corners)
    }
}

/// Decodes a list of `count` indices, three for each triangle.
pub(super) fn decode_triangles(stream: &[u8], count: usize) -> Result<Vec<u32>, String> {
    if !count.is_multiple_of(3) {
        return Err(format!("{count} indices are not a whole number of triangles"));
    }
    let mut cursor = Cursor { rest: stream };
    check_header(cursor.byte()?, TRIANGLES_HEADER)?;
    let codes = cursor.bytes(count / 3)?;
    let data = cursor.rest.len().checked_sub(TRIANGLES_TAIL).ok_or(super::ENDS_EARLY)?;
    let (data, pairs) = cursor.rest.split_at(data);
    let mut state = Triangles {
        data: Cursor { rest: data },
        edges: Recent::new([u32::MAX; 2]),
        vertices: Recent::new(u32::MAX),
        next: 0,
        last: 0,
    };
    let mut indices = Vec::with_capacity(count);
    for &code in codes {
        let triangle = match code {
            0..0xf0 => state.across_edge(code)?,
            0xf0..0xfe => state.alone(0, pairs[usize::from(code & 15)])?,
            _ => {
                let others = state.data.byte()?;
                if others == 0 {
                    state.next = 0;
                }
                state.alone(if code == 0xfe { 0 } else { ESCAPE }, others)?
            }
        };
        indices.extend(triangle);
    }
    check_end(&state.data)?;
    Ok(indices)
}

/// Decodes a sequence of `count` indices: deltas from one of two running values.
pub(super) fn decode_sequence(stream: &[u8], count: usize) -> Result<Vec<u32>, String> {
    let mut cursor = Cursor { rest: stream };
    check_header(cursor.byte()?, SEQUENCE_HEADER)?;
    let data = cursor.rest.len().checked_sub(SEQUENCE_TAIL).ok_or(super::ENDS_EARLY)?;
    // Each index takes at least one byte.
    if data < count {
        return Err(super::ENDS_EARLY.to_owned());
    }
    let mut cursor = Cursor { rest: &cursor.rest[..data] };
    let mut last = [0_u32; 2];
    let mut indices = Vec::with_capacity(count);
    for _ in 0..count {
        let code = cursor.variable()?;
        let base = &mut last[(code & 1) as usize];
        *base = base.wrapping_add(unzigzag(code >> 1));
        indices.push(*base);
    }
    check_end(&cursor)?;
    Ok(indices)
}

fn check_header(header: u8, expected: u8) -> Result<(), String> {
    if header == expected {
        return Ok(());
    }
    Err(format!("the index stream begins with {header:#04x}, not {expected:#04x}"))
}

fn check_end(cursor: &Cursor<'_>) -> Result<(), String> {
    match cursor.rest.len() {
        0 => Ok(()),
        more => Err(format!("{more} bytes follow the last index")),
    }
}
