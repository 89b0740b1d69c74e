//! Parses words and numbers of text formats from bytes.

/// The words of a line, separated by blanks.
#[derive(Clone, Debug)]
pub(crate) struct Words<'a> {
    rest: &'a [u8],
}

impl<'a> Words<'a> {
    pub(crate) const fn new(line: &'a [u8]) -> Self {
        Self { rest: line }
    }

    /// The number of bytes after the last word.
    pub(crate) const fn unread(&self) -> usize {
        self.rest.len()
    }

    /// The rest of the line, trimmed.
    pub(crate) fn rest(&self) -> &'a [u8] {
        self.rest.trim_ascii()
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let start = self.rest.iter().position(|&byte| !is_blank(byte))?;
        let rest = &self.rest[start..];
        let end = rest.iter().position(|&byte| is_blank(byte)).unwrap_or(rest.len());
        let (word, rest) = rest.split_at(end);
        self.rest = rest;
        Some(word)
    }
}

/// Anything up to a space, line ends and other control characters included.
pub(crate) const fn is_blank(byte: u8) -> bool {
    byte <= b' '
}

/// A number; accepts the spellings of infinities and NaN of C libraries.
pub(crate) fn number(word: &[u8]) -> Option<f64> {
    fast_float2::parse(word).ok().or_else(|| odd_number(word))
}

/// Like [`number`], rounded once to single precision.
pub(crate) fn single(word: &[u8]) -> Option<f32> {
    fast_float2::parse(word).ok().or_else(|| odd_number(word).map(|value| value as f32))
}

/// `-nan(ind)` and `1.#QNAN` as Microsoft's libraries write them, and Fortran's `1.5D+3`.
#[cold]
fn odd_number(word: &[u8]) -> Option<f64> {
    const LONGEST: usize = 64;
    let lower = word.get(..word.len().min(LONGEST))?.to_ascii_lowercase();
    let text = std::str::from_utf8(&lower).ok()?;
    if text.contains("#ind") || text.contains("nan") {
        return Some(f64::NAN);
    }
    if text.contains("#inf") {
        return Some(if text.starts_with('-') { f64::NEG_INFINITY } else { f64::INFINITY });
    }
    let exponent = text.find('d').filter(|_| word.len() <= LONGEST)?;
    fast_float2::parse(format!("{}e{}", &text[..exponent], &text[exponent + 1..])).ok()
}

/// A whole number.
pub(crate) fn integer(word: &[u8]) -> Option<i64> {
    let (negative, digits) = match word {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] | digits => (false, digits),
    };
    // Nineteen digits could overflow.
    if digits.is_empty() || digits.len() > 18 {
        return None;
    }
    let mut value = 0_i64;
    for &byte in digits {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return None;
        }
        value = value * 10 + i64::from(digit);
    }
    Some(if negative { -value } else { value })
}

/// Bytes as text for messages and names; bytes that are not UTF-8 are replaced.
pub(crate) fn shown(bytes: &[u8]) -> String {
    const LONGEST: usize = 200;
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(LONGEST)]);
    let mut text = text.replace(|c: char| c.is_control(), " ");
    if bytes.len() > LONGEST {
        text.push_str("...");
    }
    text
}

/// The line number of a byte, from 1.
pub(crate) fn line_of(bytes: &[u8], position: usize) -> u64 {
    let before = &bytes[..position.min(bytes.len())];
    before.iter().filter(|&&byte| byte == b'\n').count() as u64 + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_they_are_written() {
        for (word, expected) in [
            ("1e-7", 1e-7),
            (".5", 0.5),
            ("-.5", -0.5),
            ("+3", 3.0),
            ("5.", 5.0),
            ("1.5D+3", 1500.0),
            ("-1.#INF", f64::NEG_INFINITY),
            ("inf", f64::INFINITY),
        ] {
            assert_eq!(number(word.as_bytes()), Some(expected), "{word}");
        }
        for word in ["nan", "-nan(ind)", "1.#QNAN", "-NaN"] {
            assert!(number(word.as_bytes()).unwrap().is_nan(), "{word}");
        }
        for word in ["", "x", "1,5", "1.2.3", "--1"] {
            assert_eq!(number(word.as_bytes()), None, "{word}");
        }
    }

    #[test]
    fn whole_numbers_never_overflow() {
        assert_eq!(integer(b"-12"), Some(-12));
        assert_eq!(integer(b"+7"), Some(7));
        for word in ["", "-", "1.0", "99999999999999999999", "0x1"] {
            assert_eq!(integer(word.as_bytes()), None, "{word}");
        }
    }

    #[test]
    fn any_whitespace_separates_words() {
        let words: Vec<_> = Words::new(b"\t a  bc\r\n").collect();
        assert_eq!(words, [b"a".as_slice(), b"bc"]);
        let mut words = Words::new(b"newmtl\ta b \t");
        words.next();
        assert_eq!(words.rest(), b"a b");
    }
}
