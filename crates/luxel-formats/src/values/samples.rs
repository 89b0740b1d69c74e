//! The number of samples of a pixel.

/// Parses a number of samples.
///
/// # Errors
/// Anything but 1, 2, 4, 8 and 16.
pub fn samples(text: &str) -> Result<u32, String> {
    match text {
        "1" => Ok(1),
        "2" => Ok(2),
        "4" => Ok(4),
        "8" => Ok(8),
        "16" => Ok(16),
        _ => Err("use 1, 2, 4, 8 or 16".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_numbers_than_powers_of_two_to_16_are_refused() {
        assert!(samples("3").is_err() && samples("16").is_ok() && samples("32").is_err());
    }
}
