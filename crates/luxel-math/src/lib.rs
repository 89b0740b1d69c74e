//! Numbers with the same bits on every machine.
//!
//! Everything that reaches a pixel of luxel is computed by this crate's means: `+ - * / sqrt`,
//! comparisons, integers, and functions made of those. Nothing is fused, nothing reassociated, no
//! function of the platform's mathematics library is called, so a picture has the same bytes on
//! x86-64 at every SIMD level, on aarch64 and in WebAssembly.
//!
//! [`Lanes`] is one `f32` or sixteen of them ([`f32x16`]); whatever is written over it runs for
//! one pixel and for a block of 4x4 pixels with equal results, lane by lane.
//!
//! | module | subject |
//! | --- | --- |
//! | [`Lanes`] | the operations that one `f32` and sixteen of them share |
//! | [`F64Lanes`] | the same lanes as `f64`, for differences of distant positions |
//! | [`elementary`] | `log2`, `exp2`, powers, made of those operations |
//! | [`Vec3`], [`Rgb`] | three numbers in space, three numbers of light |
//! | [`permuted`] | eight lanes in an order known only at run time |
//! | [`SubPixel`] | window positions in steps of 1/256 pixel |
//! | [`SimdLevel`] | which instruction set runs the lanes |

#![forbid(unsafe_code)]

pub mod elementary;
mod fixed;
mod lanes;
mod permute;
mod simd_level;
mod vector;

#[cfg(not(all(any(target_arch = "x86", target_arch = "x86_64"), not(feature = "scalar"))))]
pub use fearless_simd::dispatch as dispatch_long;
#[cfg(any(
    not(any(target_arch = "x86", target_arch = "x86_64")),
    feature = "avx512",
    feature = "scalar"
))]
pub use fearless_simd::dispatch;
pub use fearless_simd::{
    Level, Simd, f32x4, f32x8, f32x16, f64x4, i16x32, i32x4, i32x8, i32x16, mask32x4, mask32x8,
    mask32x16, u32x8, u32x16,
};
pub use fixed::{SUBPIXELS, SubPixel};
pub use lanes::{F64Lanes, F64x8, F64x16, Lanes, Mask, SplitLanes, columns, wide_columns};
pub use permute::permuted;
pub use simd_level::{
    LANES, ParseSimdLevelError, SimdLevel, UnavailableSimdLevel, has_wide_registers,
    is_specialized, lanes_of,
};
pub use vector::{Rgb, Vec3};

/// The items that code over sixteen lanes needs.
pub mod prelude {
    pub use crate::lanes::{F64Lanes, Lanes, Mask};
    pub use fearless_simd::prelude::*;
}
