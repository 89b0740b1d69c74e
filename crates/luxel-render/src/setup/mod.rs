//! Triangles prepared for shading: what interpolation reads, made sixteen at a time and kept for the
//! blocks of one tile.
//!
//! One record serves every block, whatever it sees: plain, textured, blended or vertex-coloured ones
//! differ in which of its numbers they read. Attributes are kept as the first corner's value and what
//! the other two differ from it: an interpolated attribute is then two products and two sums a
//! component, and what is the same at all corners is the same at all samples, to the bit.

mod cache;
mod corners;
mod prepare;

pub(crate) use cache::{Prepared, SetupCache};
pub(crate) use corners::{CornerReader, PlacedCorners, ReadCorners};
pub(crate) use prepare::SetupColumns;

use luxel_visibility::TILE_FORMS;

/// Rows of eight numbers: what transposes in registers.
const ROWS: usize = 5;

/// How many triangles a thread keeps, a power of 2: 160 KiB, a part of a core's second-level cache.
/// Enough for the blocks that are looked at together.
const PLACES: usize = 1024;

/// A triangle within one tile. Its numbers, in the order of [`TileForms::to_array`] and of the
/// constants below.
///
/// [`TileForms::to_array`]: luxel_visibility::TileForms::to_array
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(crate) struct TriangleSetup {
    pub(crate) rows: [[f32; 8]; ROWS],
}

impl TriangleSetup {
    const NOTHING: Self = Self { rows: [[0.0; 8]; ROWS] };
}

/// Where a vector's numbers are: of the first corner, then the differences of the second and of the
/// third.
pub(crate) type VectorAt = [usize; 9];

/// The corners' normals: of unit length, in world space, turned to the side that is seen.
pub(crate) const NORMAL: VectorAt = [13, 14, 15, 16, 17, 18, 19, 20, 21];
/// The corners' positions: about the eye, along the world's axes.
pub(crate) const POSITION: VectorAt = [24, 25, 26, 27, 28, 29, 30, 31, 22];
/// The corners' light, where it is computed there.
pub(crate) const LIGHT: VectorAt = [32, 33, 34, 35, 36, 37, 38, 39, 23];

/// The row with most of the positions, and that with most of the light: those before are read always.
pub(crate) const POSITION_ROW: usize = 3;
pub(crate) const LIGHT_ROW: usize = 4;

const _: () = assert!(TILE_FORMS == NORMAL[0], "normals follow the forms");
const _: () = assert!(size_of::<TriangleSetup>() == 160, "two and a half lines of the cache");

/// What else triangles have, as they are in [`EXTRAS`](VertexExtras): for each component the first
/// corner's value and the differences of the other two.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(crate) struct VertexExtras {
    pub(crate) rows: [[f32; 8]; ROWS],
}

impl VertexExtras {
    /// Of a triangle of which nothing is read: white, and 0 for all else.
    const NOTHING: Self = {
        let mut rows = [[0.0; 8]; ROWS];
        let mut component = 0;
        while component < 4 {
            let at = COLOR + 3 * component;
            rows[at / 8][at % 8] = 1.0;
            component += 1;
        }
        Self { rows }
    };

    /// Writes an attribute of three corners from number `first` on.
    fn put<const C: usize>(&mut self, first: usize, [a, b, c]: [[f32; C]; 3]) {
        let numbers = self.rows.as_flattened_mut();
        for component in 0..C {
            let at = first + 3 * component;
            numbers[at] = a[component];
            numbers[at + 1] = b[component] - a[component];
            numbers[at + 2] = c[component] - a[component];
        }
    }
}

/// Where the two sets of texture coordinates begin: three numbers a component.
pub(crate) const UVS: [usize; 2] = [0, 6];
/// Where the tangent begins: in world space, with the bitangent's sign.
pub(crate) const TANGENT: usize = 12;
/// Where the vertex colour begins, with alpha.
pub(crate) const COLOR: usize = 24;

const _: () = assert!(COLOR + 12 <= 8 * ROWS, "all of them fit");
