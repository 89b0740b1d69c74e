//! `f_{n:3}.png`: numbered file names.

use std::path::{Path, PathBuf};

/// A file name with one place for a number, `{n}` or `{n:WIDTH}`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Numbering {
    before: String,
    width: usize,
    after: String,
}

/// The widest number: enough for any turntable.
const MAX_WIDTH: usize = 9;

impl Numbering {
    /// Parses the pattern. A name without a place for the number gets one before its extension: `x.png`
    /// is `x_{n}.png`.
    ///
    /// # Errors
    /// A sentence that describes the expected value.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let wrong = || {
            format!("`{text}` needs one place for the number: {{n}}, or {{n:3}} for three digits")
        };
        if !text.contains('{') {
            let extension = Path::new(text).extension().map_or(0, |ending| ending.len() + 1);
            let (before, after) = text.split_at(text.len() - extension);
            return Ok(Self { before: format!("{before}_"), width: 0, after: after.to_owned() });
        }
        let (before, rest) = text.split_once("{n").ok_or_else(wrong)?;
        let (width, after) = rest.split_once('}').ok_or_else(wrong)?;
        let width = match width.strip_prefix(':') {
            None if width.is_empty() => 0,
            Some(digits) => match digits.parse() {
                Ok(width @ 1..=MAX_WIDTH) => width,
                _ => {
                    return Err(format!(
                        "`{digits}` is not a number of digits from 1 to {MAX_WIDTH}"
                    ));
                }
            },
            None => return Err(wrong()),
        };
        if after.contains("{n") {
            return Err(wrong());
        }
        Ok(Self { before: before.to_owned(), width, after: after.to_owned() })
    }

    /// The file's name with its number, padded with zeros.
    pub(crate) fn name(&self, number: u32) -> PathBuf {
        format!("{}{number:0width$}{}", self.before, self.after, width = self.width).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(pattern: &str, number: u32) -> String {
        Numbering::parse(pattern).unwrap().name(number).to_string_lossy().into_owned()
    }

    #[test]
    fn numbers_are_padded_to_their_width() {
        assert_eq!(name("f_{n:3}.png", 7), "f_007.png");
        assert_eq!(name("f_{n:3}.png", 1234), "f_1234.png");
        assert_eq!(name("{n}.png", 7), "7.png");
        assert_eq!(name("out/a {n:2} b.exr", 7), "out/a 07 b.exr");
    }

    #[test]
    fn a_name_without_a_place_gets_its_number_before_the_extension() {
        assert_eq!(name("x.png", 0), "x_0.png");
        assert_eq!(name("a.b/x.tar.png", 12), "a.b/x.tar_12.png");
        assert_eq!(name("x", 3), "x_3");
    }

    #[test]
    fn names_with_a_damaged_place_are_refused() {
        for text in ["f_{n.png", "f_{m}.png", "{n}{n}", "{n:}", "{n:0}", "{n:x}", "{n:99}", "{nn}"]
        {
            assert!(Numbering::parse(text).is_err(), "{text}");
        }
    }
}
