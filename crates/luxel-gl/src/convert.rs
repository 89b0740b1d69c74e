//! Integer components of colours, normals and depths as floating-point numbers (OpenGL 1.5, section 2.14,
//! table 2.9): unsigned ones c / (2^b - 1), signed ones (2 c + 1) / (2^b - 1).

/// A signed 8-bit component: (2 c + 1) / 255.
#[must_use]
pub fn byte(c: i8) -> f32 {
    (2.0 * f32::from(c) + 1.0) / 255.0
}

/// An unsigned 8-bit component: c / 255.
#[must_use]
pub fn ubyte(c: u8) -> f32 {
    f32::from(c) / 255.0
}

/// A signed 16-bit component: (2 c + 1) / 65535.
#[must_use]
pub fn short(c: i16) -> f32 {
    (2.0 * f32::from(c) + 1.0) / 65535.0
}

/// An unsigned 16-bit component: c / 65535.
#[must_use]
pub fn ushort(c: u16) -> f32 {
    f32::from(c) / 65535.0
}

/// A signed 32-bit component: (2 c + 1) / (2^32 - 1).
#[must_use]
pub fn int(c: i32) -> f32 {
    ((2.0 * f64::from(c) + 1.0) / 4_294_967_295.0) as f32
}

/// An unsigned 32-bit component: c / (2^32 - 1).
#[must_use]
pub fn uint(c: u32) -> f32 {
    (f64::from(c) / 4_294_967_295.0) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_2_14_the_ends_of_integer_ranges_become_minus_one_zero_and_one() {
        assert_eq!([byte(-128), byte(127)], [-1.0, 1.0]);
        assert_eq!([ubyte(0), ubyte(255)], [0.0, 1.0]);
        assert_eq!([short(i16::MIN), short(i16::MAX)], [-1.0, 1.0]);
        assert_eq!([ushort(0), ushort(u16::MAX)], [0.0, 1.0]);
        assert_eq!([int(i32::MIN), int(i32::MAX)], [-1.0, 1.0]);
        assert_eq!([uint(0), uint(u32::MAX)], [0.0, 1.0]);
    }
}
