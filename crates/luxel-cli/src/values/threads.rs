//! The number of threads.

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
        assert!(threads("0").is_err() && threads("-1").is_err() && threads("7").is_ok());
        assert!(threads("99999999999999999999").is_err());
    }
}
