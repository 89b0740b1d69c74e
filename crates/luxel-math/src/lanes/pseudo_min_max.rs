//! Minimum and maximum by one instruction of WebAssembly: `f32x4.pmin` of (b, a) is `a < b ? a : b` and `f32x4.pmax` of
//! (b, a) is `b < a ? a : b`, bit for bit, with NaN and both zeros. `f32x4.min` and `f32x4.max` treat NaN in a way of
//! their own, for which x86 needs up to eight instructions; a comparison and a selection need four.

use core::arch::wasm32::{f32x4_pmax, f32x4_pmin};
use fearless_simd::{Simd, f32x4, f32x8, f32x16, prelude::*};

/// `a < b ? a : b` and `b < a ? a : b`, lane by lane.
pub(super) trait PseudoMinMax {
    fn pseudo_minimum(self, other: Self) -> Self;
    fn pseudo_maximum(self, other: Self) -> Self;
}

impl<S: Simd> PseudoMinMax for f32x4<S> {
    #[inline(always)]
    fn pseudo_minimum(self, other: Self) -> Self {
        f32x4_pmin(other.into(), self.into()).simd_into(self.simd)
    }
    #[inline(always)]
    fn pseudo_maximum(self, other: Self) -> Self {
        f32x4_pmax(other.into(), self.into()).simd_into(self.simd)
    }
}

macro_rules! by_halves {
    ($($Lanes:ident),*) => {$(
        impl<S: Simd> PseudoMinMax for $Lanes<S> {
            #[inline(always)]
            fn pseudo_minimum(self, other: Self) -> Self {
                let ((low, high), (other_low, other_high)) = (self.split(), other.split());
                low.pseudo_minimum(other_low).combine(high.pseudo_minimum(other_high))
            }
            #[inline(always)]
            fn pseudo_maximum(self, other: Self) -> Self {
                let ((low, high), (other_low, other_high)) = (self.split(), other.split());
                low.pseudo_maximum(other_low).combine(high.pseudo_maximum(other_high))
            }
        }
    )*};
}
by_halves!(f32x8, f32x16);
