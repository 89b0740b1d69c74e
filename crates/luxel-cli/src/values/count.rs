//! Integers: samples per pixel, threads.

/// Samples per pixel.
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

/// The largest number of threads: more than any machine has, and few enough not to exhaust one.
const MAX_THREADS: usize = 1024;

/// The number of threads.
pub(crate) fn threads(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(count @ 1..=MAX_THREADS) => Ok(count),
        _ => Err(format!("use a whole number from 1 to {MAX_THREADS}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_out_of_range_are_refused() {
        assert!(samples("3").is_err() && samples("16").is_ok() && samples("32").is_err());
        assert!(threads("0").is_err() && threads("-1").is_err() && threads("7").is_ok());
        assert!(threads("99999999999999999999").is_err());
    }
}
