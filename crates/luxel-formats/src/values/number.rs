//! Numbers: `.5`, `-3`, `1e-7`; never NaN, never infinite.

/// A finite number.
///
/// # Errors
/// Anything else.
pub fn finite(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let number: f64 = text.parse().map_err(|_| format!("`{text}` is not a number"))?;
    if number.is_finite() { Ok(number) } else { Err(format!("`{text}` is not a finite number")) }
}

/// A finite number above 0.
///
/// # Errors
/// Anything else.
pub fn positive(text: &str) -> Result<f64, String> {
    let number = finite(text)?;
    if number > 0.0 { Ok(number) } else { Err("it must be above 0".to_owned()) }
}

/// A finite number of at least 0.
fn non_negative(text: &str) -> Result<f64, String> {
    let number = finite(text)?;
    if number >= 0.0 { Ok(number) } else { Err("it must not be below 0".to_owned()) }
}

/// A finite number of at least 0, in single precision.
///
/// # Errors
/// Anything else.
pub fn non_negative_f32(text: &str) -> Result<f32, String> {
    single(non_negative(text)?)
}

/// The number in single precision, unless it overflows.
pub(super) fn single(number: f64) -> Result<f32, String> {
    let single = number as f32;
    if single.is_finite() { Ok(single) } else { Err(format!("{number:e} is too large")) }
}

/// The distance of the far plane: above 0, or `infinity`.
///
/// # Errors
/// Anything but a finite number or `infinity`.
pub fn far_plane(text: &str) -> Result<f64, String> {
    match text.trim() {
        "infinity" | "inf" => Ok(f64::INFINITY),
        text => finite(text),
    }
}

/// An angle of view in degrees, between 0 and 180.
///
/// # Errors
/// Anything else.
pub fn fov(text: &str) -> Result<f64, String> {
    let degrees = finite(text)?;
    if degrees > 0.0 && degrees < 180.0 {
        Ok(degrees)
    } else {
        Err("it must be between 0 and 180 degrees".to_owned())
    }
}

/// The fewest digits of degrees that give these radians, bitwise equal if possible.
#[must_use]
pub fn degrees(radians: f64) -> f64 {
    let near = radians.to_degrees();
    let rounded = [1.0, 1e3, 1e6, 1e9].map(|unit| (near * unit).round() / unit);
    let (up, down) = (near.next_up(), near.next_down());
    let next = [near, up, down, up.next_up(), down.next_down()];
    let is_same = |degrees: &f64| degrees.to_radians() == radians;
    rounded.into_iter().chain(next).find(is_same).unwrap_or(near)
}

/// A number from 0 to 1, in single precision.
///
/// # Errors
/// Anything else.
pub fn unit_interval(text: &str) -> Result<f32, String> {
    let share = finite(text)?;
    if (0.0..=1.0).contains(&share) { Ok(share as f32) } else { Err("use 0 to 1".to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_leading_digit_is_optional_and_exponents_are_read() {
        assert_eq!(finite(".5"), Ok(0.5));
        assert_eq!(finite("-.5"), Ok(-0.5));
        assert_eq!(finite("1e-7"), Ok(1e-7));
        assert_eq!(finite("+3"), Ok(3.0));
        assert_eq!(finite("5."), Ok(5.0));
    }

    #[test]
    fn nan_infinity_and_overflow_are_refused() {
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
    fn every_usual_angle_is_written_as_it_was_given() {
        for angle in 1..180 {
            let angle = f64::from(angle);
            assert_eq!(degrees(angle.to_radians()), angle);
        }
    }

    #[test]
    fn numbers_out_of_range_are_refused() {
        assert!(fov("0").is_err() && fov("180").is_err() && fov("179.9").is_ok());
        assert!(positive("0").is_err() && non_negative("0").is_ok() && non_negative("-1").is_err());
    }

    proptest! {
        #[test]
        fn an_angle_in_degrees_is_recovered_bit_for_bit(angle in 0.0..360.0_f64) {
            let radians = angle.to_radians();
            prop_assert_eq!(degrees(radians).to_radians(), radians);
        }

        #[test]
        fn every_finite_number_reads_back_exactly(number in proptest::num::f64::NORMAL) {
            prop_assert_eq!(finite(&number.to_string()), Ok(number));
            prop_assert_eq!(finite(&format!("{number:e}")), Ok(number));
        }
    }
}
