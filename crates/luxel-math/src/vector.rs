//! Three numbers: a place or direction in space ([`Vec3`]), an amount of light ([`Rgb`]).
//!
//! Sums of three go from left to right, `(x + y) + z`, everywhere.

use crate::Lanes;
use std::ops::{Add, Mul, Neg, Sub};

/// A vector or point with three coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3<N> {
    /// First coordinate.
    pub x: N,
    /// Second coordinate.
    pub y: N,
    /// Third coordinate.
    pub z: N,
}

/// Linear red, green and blue, of any intensity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb<N> {
    /// Red.
    pub r: N,
    /// Green.
    pub g: N,
    /// Blue.
    pub b: N,
}

impl<N> Vec3<N> {
    /// A vector from its coordinates.
    #[inline(always)]
    pub const fn new(x: N, y: N, z: N) -> Self {
        Self { x, y, z }
    }
}

impl<N: Lanes> Vec3<N> {
    /// The same vector in every lane; `simd` selects the lane type.
    #[inline(always)]
    pub fn splat(simd: N, [x, y, z]: [f32; 3]) -> Self {
        Self::new(simd.constant(x), simd.constant(y), simd.constant(z))
    }

    /// a . b = a_x b_x + a_y b_y + a_z b_z
    #[inline(always)]
    pub fn dot(self, other: Self) -> N {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// a x b, perpendicular to both, right-handed.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// |a|
    #[inline(always)]
    pub fn length(self) -> N {
        self.dot(self).sqrt()
    }

    /// The vector of length 1 in the same direction; 0 for the zero vector and where the squared
    /// length underflows.
    #[inline(always)]
    #[must_use]
    pub fn normalized_or_zero(self) -> Self {
        let squared = self.dot(self);
        let sound = squared.zero().less(squared);
        let length = squared.select(sound, squared.one()).sqrt();
        let scale = (length.one() / length).masked(sound);
        self * scale
    }

    /// Both vectors at length 1 with one division: 1 / |a| = |b| / (|a| |b|). 0 for a zero vector, as
    /// [`Self::normalized_or_zero`]; `other` is not short: at least 1e-3 long, and at most 1e6.
    ///
    #[inline(always)]
    #[must_use]
    pub fn normalized_pair(self, other: Self) -> (Self, Self) {
        let squared = self.dot(self);
        let sound = squared.zero().less(squared);
        let length = squared.select(sound, squared.one()).sqrt();
        let other_length = other.length();
        let scale = length.one() / (length * other_length);
        (self * (scale * other_length).masked(sound), other * (scale * length))
    }

    /// Lanes of `self` where the mask is true, of `other` elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn select(self, mask: N::Mask, other: Self) -> Self {
        Self::new(
            self.x.select(mask, other.x),
            self.y.select(mask, other.y),
            self.z.select(mask, other.z),
        )
    }

    /// Writes lanes of `self` to a place in memory where the mask is true.
    #[inline(always)]
    pub fn put(self, mask: N::Mask, place: &mut Self) {
        self.x.put(mask, &mut place.x);
        self.y.put(mask, &mut place.y);
        self.z.put(mask, &mut place.z);
    }

    /// The coordinates of one lane.
    #[inline(always)]
    pub fn lane(self, lane: usize) -> [f32; 3] {
        [self.x.lane(lane), self.y.lane(lane), self.z.lane(lane)]
    }
}

impl<N> Rgb<N> {
    /// A colour from its components.
    #[inline(always)]
    pub const fn new(r: N, g: N, b: N) -> Self {
        Self { r, g, b }
    }
}

impl<N: Lanes> Rgb<N> {
    /// The same colour in every lane; `simd` selects the lane type.
    #[inline(always)]
    pub fn splat(simd: N, [r, g, b]: [f32; 3]) -> Self {
        Self::new(simd.constant(r), simd.constant(g), simd.constant(b))
    }

    /// No light.
    #[inline(always)]
    pub fn black(simd: N) -> Self {
        Self::splat(simd, [0.0; 3])
    }

    /// Lanes of `self` where the mask is true, of `other` elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn select(self, mask: N::Mask, other: Self) -> Self {
        Self::new(
            self.r.select(mask, other.r),
            self.g.select(mask, other.g),
            self.b.select(mask, other.b),
        )
    }

    /// Writes lanes of `self` to a place in memory where the mask is true.
    #[inline(always)]
    pub fn put(self, mask: N::Mask, place: &mut Self) {
        self.r.put(mask, &mut place.r);
        self.g.put(mask, &mut place.g);
        self.b.put(mask, &mut place.b);
    }

    /// The components of one lane.
    #[inline(always)]
    pub fn lane(self, lane: usize) -> [f32; 3] {
        [self.r.lane(lane), self.g.lane(lane), self.b.lane(lane)]
    }
}

/// The operations by which both kinds of triples are combined, component by component.
macro_rules! componentwise {
    ($name:ident, $x:ident, $y:ident, $z:ident) => {
        impl<N: Lanes> Add for $name<N> {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self::new(self.$x + other.$x, self.$y + other.$y, self.$z + other.$z)
            }
        }
        impl<N: Lanes> Sub for $name<N> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self::new(self.$x - other.$x, self.$y - other.$y, self.$z - other.$z)
            }
        }
        impl<N: Lanes> Neg for $name<N> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self::new(-self.$x, -self.$y, -self.$z)
            }
        }
        impl<N: Lanes> Mul<N> for $name<N> {
            type Output = Self;
            #[inline(always)]
            fn mul(self, factor: N) -> Self {
                Self::new(self.$x * factor, self.$y * factor, self.$z * factor)
            }
        }
    };
}

componentwise!(Vec3, x, y, z);
componentwise!(Rgb, r, g, b);

/// Light that a coloured surface or filter leaves of light: component by component, so that a red
/// light on a green surface is black.
impl<N: Lanes> Mul for Rgb<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zero_vector_stays_zero_when_normalized() {
        assert_eq!(Vec3::new(0.0_f32, 0.0, 0.0).normalized_or_zero(), Vec3::new(0.0, 0.0, 0.0));
        assert_eq!(Vec3::new(0.0_f32, 3.0, 4.0).normalized_or_zero(), Vec3::new(0.0, 0.6, 0.8));
    }

    #[test]
    fn the_cross_product_is_right_handed() {
        let (x, y) = (Vec3::new(1.0_f32, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
        assert_eq!(x.cross(y), Vec3::new(0.0, 0.0, 1.0));
    }

    #[test]
    fn a_red_light_on_a_green_surface_is_black() {
        let product = Rgb::new(1.0_f32, 0.0, 0.0) * Rgb::new(0.0, 1.0, 0.0);
        assert_eq!(product, Rgb::new(0.0, 0.0, 0.0));
    }
}
