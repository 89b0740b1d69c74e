//! Sixteen lanes, and the instruction set that runs them.
//!
//! Hot code is written once, generic over a token `S:` [`Simd`](fearless_simd::Simd), on types of
//! exactly sixteen lanes: a block of 4x4 pixels, sixteen vertices, sixteen triangles. Narrower
//! hardware splits them; the grouping, and so every result, stays the same.

use fearless_simd::{Level, Simd};
use std::fmt;
use std::str::FromStr;

/// Lanes of every vector: a block of 4x4 pixels.
pub const LANES: usize = 16;

/// The lanes whose bits are set, lowest first.
#[inline(always)]
pub fn lanes_of(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}

/// An instruction set.
///
/// The levels differ in speed only: pixels are the same at all of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SimdLevel {
    /// The best that this machine has and this build has kernels for.
    #[default]
    Auto,
    /// No more than every machine of its kind has: 128-bit vectors on x86-64 and aarch64, one value
    /// at a time elsewhere and with this crate's feature `scalar`.
    Scalar,
    /// 128 bits: x86-64's baseline.
    Sse2,
    /// 128 bits, x86-64 since 2008.
    Sse42,
    /// 256 bits, x86-64 since 2013.
    Avx2,
    /// 512 bits, x86-64 since Ice Lake and Zen 4; with this crate's feature `avx512`.
    Avx512,
    /// 128 bits, aarch64.
    Neon,
    /// 128 bits, WebAssembly.
    Simd128,
}

/// Every level but `Auto`, narrowest first.
const LEVELS: [SimdLevel; 7] = [
    SimdLevel::Scalar,
    SimdLevel::Sse2,
    SimdLevel::Sse42,
    SimdLevel::Avx2,
    SimdLevel::Avx512,
    SimdLevel::Neon,
    SimdLevel::Simd128,
];

impl SimdLevel {
    /// The levels that this machine has and this build has kernels for, narrowest first.
    #[must_use]
    pub fn available() -> Vec<Self> {
        LEVELS.into_iter().filter(|level| level.resolve().is_ok()).collect()
    }

    /// The name that [`FromStr`] reads.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Scalar => "scalar",
            Self::Sse2 => "sse2",
            Self::Sse42 => "sse4.2",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
            Self::Neon => "neon",
            Self::Simd128 => "simd128",
        }
    }

    /// The level that [`dispatch`](crate::dispatch) takes.
    ///
    /// # Errors
    /// [`UnavailableSimdLevel`] if this machine lacks the instructions, or this build the kernels.
    pub fn resolve(self) -> Result<Level, UnavailableSimdLevel> {
        let best = with_kernels(Level::new());
        let level = match self {
            Self::Auto => Some(best),
            #[cfg(feature = "scalar")]
            Self::Scalar => Some(Level::fallback()),
            #[cfg(not(feature = "scalar"))]
            Self::Scalar => Some(with_kernels(Level::baseline())),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Sse2 => best.as_sse2().map(Level::Sse2),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Sse42 => best.as_sse4_2().map(Level::Sse4_2),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Avx2 => best.as_avx2().map(Level::Avx2),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Avx512 => best.as_avx512().map(Level::Avx512),
            #[cfg(target_arch = "aarch64")]
            Self::Neon => best.as_neon().map(Level::Neon),
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Self::Simd128 => best.as_wasm_simd128().map(Level::WasmSimd128),
            #[allow(unreachable_patterns, reason = "which levels are left depends on the target")]
            _ => None,
        };
        level.ok_or(UnavailableSimdLevel(self))
    }

    /// The name of a resolved level.
    #[must_use]
    pub fn name_of(level: Level) -> &'static str {
        let level = match level {
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Sse2(_) => Self::Sse2,
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Sse4_2(_) => Self::Sse42,
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx2(_) => Self::Avx2,
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx512(_) => Self::Avx512,
            #[cfg(target_arch = "aarch64")]
            Level::Neon(_) => Self::Neon,
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Level::WasmSimd128(_) => Self::Simd128,
            _ => Self::Scalar,
        };
        level.name()
    }
}

/// Whether one register holds sixteen lanes, and there are thirty-two of them: with AVX-512.
/// Elsewhere sixteen lanes of a few numbers fill all registers.
#[inline(always)]
pub fn has_wide_registers<S: Simd>(simd: S) -> bool {
    match simd.level() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx512(_) => true,
        _ => false,
    }
}

/// Whether a long kernel is worth a second copy for its frequent case.
///
/// Not with SSE2: sixteen lanes are four of its registers, so its code is the longest and takes the
/// compiler half of its time, while x86 processors made since 2013 run AVX2's. Pixels are the same.
#[must_use]
pub const fn is_specialized<S: Simd>() -> bool {
    let is_x86 = cfg!(any(target_arch = "x86", target_arch = "x86_64"));
    !is_x86 || size_of::<S::f32s>() > 16
}

/// The best level up to this one that has kernels: without the feature `avx512`, AVX2 instead of
/// AVX-512.
fn with_kernels(level: Level) -> Level {
    #[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), not(feature = "avx512")))]
    if let (Level::Avx512(_), Some(avx2)) = (level, level.as_avx2()) {
        return Level::Avx2(avx2);
    }
    level
}

impl fmt::Display for SimdLevel {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

impl FromStr for SimdLevel {
    type Err = ParseSimdLevelError;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        LEVELS
            .into_iter()
            .chain([Self::Auto])
            .find(|level| level.name() == name)
            .ok_or_else(|| ParseSimdLevelError(name.to_owned()))
    }
}

/// A name that is not a [`SimdLevel`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseSimdLevelError(String);

impl fmt::Display for ParseSimdLevelError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<_> = LEVELS.iter().map(|level| level.name()).collect();
        write!(formatter, "`{}` is not a SIMD level: use auto, {}", self.0, names.join(", "))
    }
}

impl std::error::Error for ParseSimdLevelError {}

/// A level whose instructions this machine lacks, or whose kernels this build leaves out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnavailableSimdLevel(pub SimdLevel);

impl fmt::Display for UnavailableSimdLevel {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<_> = SimdLevel::available().into_iter().map(SimdLevel::name).collect();
        let names = names.join(", ");
        // The machine's own level is another one only where its kernels are left out.
        if SimdLevel::name_of(Level::new()) == self.0.name() {
            write!(formatter, "this build leaves out {}: it has {names}", self.0)
        } else {
            write!(formatter, "this machine has no {}: it has {names}", self.0)
        }
    }
}

impl std::error::Error for UnavailableSimdLevel {}

/// [`dispatch`](fearless_simd::dispatch) for long kernels: those of SSE4.2 run as SSE2's.
///
/// Each copy of lighting and of the traversal of trees takes seconds to compile, and lighting gains
/// less than a hundredth of its instructions from what SSE4.2 adds.
#[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), not(feature = "scalar")))]
#[macro_export]
macro_rules! dispatch_long {
    ($level:expr, $simd:ident => $kernel:expr) => {
        'kernel: {
            let level: $crate::Level = $level;
            $crate::__try_avx512!('kernel, level, $simd => $kernel);
            #[cfg(not(disable_dispatch_avx2))]
            $crate::__try_level!('kernel, level.as_avx2(), $simd => $kernel);
            $crate::__try_level!('kernel, level.as_sse2(), $simd => $kernel);
            unreachable!("every level of these machines has SSE2")
        }
    };
}

/// [`dispatch`](fearless_simd::dispatch) where AVX-512's kernels are left out: as AVX2's they run.
#[cfg(all(
    any(target_arch = "x86", target_arch = "x86_64"),
    not(any(feature = "avx512", feature = "scalar"))
))]
#[macro_export]
macro_rules! dispatch {
    ($level:expr, $simd:ident => $kernel:expr) => {
        'kernel: {
            let level: $crate::Level = $level;
            #[cfg(not(disable_dispatch_avx2))]
            $crate::__try_level!('kernel, level.as_avx2(), $simd => $kernel);
            #[cfg(not(disable_dispatch_sse4_2))]
            $crate::__try_level!('kernel, level.as_sse4_2(), $simd => $kernel);
            $crate::__try_level!('kernel, level.as_sse2(), $simd => $kernel);
            unreachable!("every level of these machines has SSE2")
        }
    };
}

/// Leaves a block with what a kernel returns, if there is a token to run it with.
#[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), not(feature = "scalar")))]
#[doc(hidden)]
#[macro_export]
macro_rules! __try_level {
    ($block:lifetime, $token:expr, $simd:ident => $kernel:expr) => {
        if let Some($simd) = $token {
            break $block $crate::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $kernel,
            );
        }
    };
}

/// The same with AVX-512. A feature in a macro's body is one of the crate that calls it, hence two
/// macros.
#[cfg(all(
    any(target_arch = "x86", target_arch = "x86_64"),
    feature = "avx512",
    not(feature = "scalar")
))]
#[doc(hidden)]
#[macro_export]
macro_rules! __try_avx512 {
    ($block:lifetime, $level:expr, $simd:ident => $kernel:expr) => {
        #[cfg(not(disable_dispatch_avx512))]
        $crate::__try_level!($block, $level.as_avx512(), $simd => $kernel);
    };
}

/// Nothing: AVX-512's kernels are left out.
#[cfg(all(
    any(target_arch = "x86", target_arch = "x86_64"),
    not(any(feature = "avx512", feature = "scalar"))
))]
#[doc(hidden)]
#[macro_export]
macro_rules! __try_avx512 {
    ($block:lifetime, $level:expr, $simd:ident => $kernel:expr) => {};
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_reads_back_as_its_level() {
        for level in LEVELS {
            assert_eq!(level.name().parse(), Ok(level));
        }
        assert!("mmx".parse::<SimdLevel>().is_err());
    }

    #[test]
    fn the_machine_has_auto_and_scalar_at_least() {
        assert!(SimdLevel::Auto.resolve().is_ok());
        assert!(SimdLevel::available().contains(&SimdLevel::Scalar));
    }

    #[test]
    fn levels_without_compiled_kernels_are_not_offered() {
        let offered = SimdLevel::available();
        assert!(cfg!(feature = "avx512") || !offered.contains(&SimdLevel::Avx512));
        for level in offered {
            let name = SimdLevel::name_of(level.resolve().unwrap());
            assert!(cfg!(feature = "avx512") || name != "avx512", "{level} runs {name}");
        }
    }
}
