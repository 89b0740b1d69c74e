//! Numbers: `.5`, `-3`, `1e-7`; never NaN, never infinite.

/// A finite number.
pub(crate) fn finite(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let number: f64 = text.parse().map_err(|_| format!("`{text}` is no number"))?;
    if number.is_finite() { Ok(number) } else { Err(format!("`{text}` is not a finite number")) }
}

/// A finite number above 0.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    let number = finite(text)?;
    if number > 0.0 { Ok(number) } else { Err("it must be above 0".to_owned()) }
}

/// A finite number of at least 0.
fn non_negative(text: &str) -> Result<f64, String> {
    let number = finite(text)?;
    if number >= 0.0 { Ok(number) } else { Err("it must not be below 0".to_owned()) }
}

/// A finite number of at least 0, in single precision.
pub(crate) fn non_negative_f32(text: &str) -> Result<f32, String> {
    single(non_negative(text)?)
}

/// The number in single precision, if it has room there.
pub(crate) fn single(number: f64) -> Result<f32, String> {
    let single = number as f32;
    if single.is_finite() { Ok(single) } else { Err(format!("{number:e} is too large")) }
}

/// The distance of the far plane: above 0, or `infinity`.
pub(crate) fn far_plane(text: &str) -> Result<f64, String> {
    match text.trim() {
        "infinity" | "inf" => Ok(f64::INFINITY),
        text => finite(text),
    }
}

/// An angle of view in degrees, between 0 and 180.
pub(crate) fn fov(text: &str) -> Result<f64, String> {
    let degrees = finite(text)?;
    if degrees > 0.0 && degrees < 180.0 {
        Ok(degrees)
    } else {
        Err("it must lie between 0 and 180 degrees".to_owned())
    }
}

/// Samples a pixel.
pub(crate) fn samples(text: &str) -> Result<u32, String> {
    match text {
        "1" => Ok(1),
        "2" => Ok(2),
        "4" => Ok(4),
        "8" => Ok(8),
        "16" => Ok(16),
        _ => Err("use 1, 2, 4, 8 or 16".to_owned()),
    }
}

/// The most threads that can be asked for: far above any machine, far below what would exhaust one.
const MAX_THREADS: usize = 1024;

/// A number of threads.
pub(crate) fn threads(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(count @ 1..=MAX_THREADS) => Ok(count),
        _ => Err(format!("use a whole number from 1 to {MAX_THREADS}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_without_leading_digit_and_with_exponents_are_numbers() {
        assert_eq!(finite(".5"), Ok(0.5));
        assert_eq!(finite("-.5"), Ok(-0.5));
        assert_eq!(finite("1e-7"), Ok(1e-7));
        assert_eq!(finite("+3"), Ok(3.0));
        assert_eq!(finite("5."), Ok(5.0));
    }

    #[test]
    fn nan_infinity_and_overflow_are_no_numbers() {
        for text in ["nan", "NaN", "-nan", "inf", "-inf", "infinity", "1e999", "", "x", "0x10"] {
            assert!(finite(text).is_err(), "{text}");
        }
        assert!(non_negative_f32("1e39").is_err());
    }

    #[test]
    fn only_the_far_plane_may_be_infinite() {
        assert_eq!(far_plane("infinity"), Ok(f64::INFINITY));
        assert!(far_plane("-infinity").is_err());
        assert!(far_plane("nan").is_err());
        assert!(positive("infinity").is_err());
    }

    #[test]
    fn ranges_are_kept() {
        assert!(fov("0").is_err() && fov("180").is_err() && fov("179.9").is_ok());
        assert!(positive("0").is_err() && non_negative("0").is_ok() && non_negative("-1").is_err());
        assert!(samples("3").is_err() && samples("16").is_ok() && samples("32").is_err());
        assert!(threads("0").is_err() && threads("-1").is_err() && threads("7").is_ok());
        assert!(threads("99999999999999999999").is_err());
    }

    proptest! {
        #[test]
        fn every_finite_number_reads_back_exactly(number in proptest::num::f64::NORMAL) {
            prop_assert_eq!(finite(&number.to_string()), Ok(number));
            prop_assert_eq!(finite(&format!("{number:e}")), Ok(number));
        }
    }
}
