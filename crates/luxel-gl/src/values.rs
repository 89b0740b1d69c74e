//! Values of state, as queries return them (OpenGL 1.5, section 6.1.2).

/// Most values that one query returns: a matrix.
const MOST: usize = 16;

/// What a value is, which decides how it is converted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Boolean,
    Integer,
    Real,
    /// A colour, normal or depth: integers scale, so that 1 is the largest one.
    Scaled,
}

/// The values of one piece of state, in the type that it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Values {
    kind: Kind,
    count: usize,
    values: [f64; MOST],
}

impl Values {
    fn new(kind: Kind, values: impl IntoIterator<Item = f64>) -> Self {
        let mut all = Self { kind, count: 0, values: [0.0; MOST] };
        for (place, value) in all.values.iter_mut().zip(values) {
            *place = value;
            all.count += 1;
        }
        all
    }

    pub(crate) fn booleans<const N: usize>(values: [bool; N]) -> Self {
        Self::new(Kind::Boolean, values.map(|value| f64::from(u8::from(value))))
    }

    pub(crate) fn boolean(value: bool) -> Self {
        Self::booleans([value])
    }

    pub(crate) fn integers<const N: usize>(values: [i32; N]) -> Self {
        Self::new(Kind::Integer, values.map(f64::from))
    }

    pub(crate) fn integer(value: i32) -> Self {
        Self::integers([value])
    }

    /// A name or a symbolic constant.
    pub(crate) fn name(value: u32) -> Self {
        Self::new(Kind::Integer, [f64::from(value)])
    }

    /// A count, which fits an `i32` by the limits.
    pub(crate) fn count(value: usize) -> Self {
        Self::integer(i32::try_from(value).unwrap_or(i32::MAX))
    }

    /// No value at all, as of a list that is empty.
    pub(crate) fn none() -> Self {
        Self::new(Kind::Integer, [])
    }

    pub(crate) fn reals<const N: usize>(values: [f32; N]) -> Self {
        Self::new(Kind::Real, values.map(f64::from))
    }

    pub(crate) fn real(value: f32) -> Self {
        Self::reals([value])
    }

    pub(crate) fn doubles(values: [f64; MOST]) -> Self {
        Self::new(Kind::Real, values)
    }

    /// Components of a colour, a normal, or depths.
    pub(crate) fn scaled<const N: usize>(values: [f32; N]) -> Self {
        Self::new(Kind::Scaled, values.map(f64::from))
    }

    /// Depths in double precision.
    pub(crate) fn scaled_doubles<const N: usize>(values: [f64; N]) -> Self {
        Self::new(Kind::Scaled, values)
    }

    /// How many values there are, 16 at most.
    #[must_use]
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there is none, as of the list of compressed formats.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Value `index` as a `GLboolean`: 0 for zero, 1 for anything else. 0 beyond the last value.
    #[must_use]
    pub fn to_bool(&self, index: usize) -> u8 {
        u8::from(self.to_f64(index) != 0.0)
    }

    /// Value `index` as a `GLint`: colours, normals and depths times 2^31 - 1, others
    /// rounded to the nearest integer. The text would have -1 for 0, by ((2^32 - 1) f - 1) / 2; that 0 stays 0 is what
    /// later versions say (OpenGL 4.2, section 2.3.5) and programs expect. 0 beyond the last value.
    #[must_use]
    pub fn to_i32(&self, index: usize) -> i32 {
        let value = self.to_f64(index);
        match self.kind {
            // Names above 2^31 keep their bits.
            Kind::Integer if value > f64::from(i32::MAX) => value as u32 as i32,
            Kind::Scaled => (2_147_483_647.0 * value) as i32,
            _ => value.round() as i32,
        }
    }

    /// Value `index` as a `GLfloat`. 0 beyond the last value.
    #[must_use]
    pub fn to_f32(&self, index: usize) -> f32 {
        self.to_f64(index) as f32
    }

    /// Value `index` as a `GLdouble`. 0 beyond the last value.
    #[must_use]
    pub fn to_f64(&self, index: usize) -> f64 {
        self.values[..self.count].get(index).copied().unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_6_1_2_colours_scale_to_integers_and_other_numbers_round() {
        let color = Values::scaled([1.0, -1.0, 0.0]);
        assert_eq!([0, 1, 2].map(|at| color.to_i32(at)), [i32::MAX, -i32::MAX, 0]);
        let width = Values::real(2.5);
        assert_eq!((width.to_i32(0), width.to_f32(0), width.to_bool(0)), (3, 2.5, 1));
        assert_eq!(Values::name(0xffff_ffff).to_i32(0), -1);
        assert_eq!(Values::boolean(true).to_i32(0), 1);
        assert_eq!((Values::none().len(), Values::none().to_i32(3)), (0, 0));
    }
}
