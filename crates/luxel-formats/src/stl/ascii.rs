//! Text STL: `solid NAME`, facets of three vertices each, `endsolid`, in any case.

use super::{Facets, Solids, check_count};
use crate::text::{Words, line_of, shown, single};
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Limits, Place};

/// The shortest facet, `facet normal 0 0 0 outer loop vertex 0 0 0 ... endloop endfacet`.
const SHORTEST_FACET: usize = 78;

/// The solids with their names, in order.
pub(super) fn read(
    bytes: &[u8],
    name: &str,
    limits: &Limits,
    warnings: &mut Warnings,
) -> Result<Solids, Error> {
    check_count((bytes.len() / SHORTEST_FACET) as u64, limits, Place::File)?;
    let body = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut reader =
        Reader { bytes: body, at: 0, solids: Solids::default(), open: None, inside: false };
    while let Some(word) = reader.word() {
        reader.statement(word, name)?;
    }
    if reader.inside {
        let line = line_of(body, body.len());
        warnings.push(format!("line {line}: the file ends without `endsolid`"));
    }
    reader.close();
    Ok(reader.solids)
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    solids: Solids,
    /// The last solid, with its name.
    open: Option<(String, Facets)>,
    /// Whether it hasn't ended.
    inside: bool,
}

impl<'a> Reader<'a> {
    /// The next word, across line ends.
    #[inline]
    fn word(&mut self) -> Option<&'a [u8]> {
        let mut words = Words::new(&self.bytes[self.at..]);
        let word = words.next()?;
        self.at = self.bytes.len() - words.unread();
        Some(word)
    }

    /// The rest of the line.
    fn line(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(|&byte| byte == b'\n' || byte == b'\r');
        let end = end.unwrap_or(rest.len());
        self.at += end;
        rest[..end].trim_ascii()
    }

    fn statement(&mut self, word: &[u8], name: &str) -> Result<(), Error> {
        if word.eq_ignore_ascii_case(b"facet") {
            if !self.inside {
                return Err(self.unexpected(word, "`solid`"));
            }
            let corners = self.facet()?;
            if let Some((_, facets)) = &mut self.open {
                facets.push(corners);
            }
        } else if word.eq_ignore_ascii_case(b"solid") {
            let given = self.line();
            let name = if given.is_empty() { name.to_owned() } else { shown(given) };
            self.close();
            self.open = Some((name, Facets::with_room_for(0)));
            self.inside = true;
        } else if word.eq_ignore_ascii_case(b"endsolid") {
            self.line();
            self.inside = false;
        } else {
            return Err(self.unexpected(word, "`facet` or `endsolid`"));
        }
        Ok(())
    }

    /// Makes a mesh of the last solid, since what welds corners takes several times its memory. A file may
    /// hold millions of solids; those without facets don't count as objects.
    fn close(&mut self) {
        if let Some((name, facets)) = self.open.take() {
            self.solids.push(name, facets);
        }
    }

    /// The rest of a facet: a normal, which is ignored, and three corners.
    fn facet(&mut self) -> Result<[[f32; 3]; 3], Error> {
        self.keyword(b"normal")?;
        for _ in 0..3 {
            self.value()?;
        }
        self.keyword(b"outer")?;
        self.keyword(b"loop")?;
        let mut corners = [[0.0; 3]; 3];
        for corner in &mut corners {
            self.keyword(b"vertex")?;
            for value in corner {
                *value = self.value()?;
            }
        }
        self.keyword(b"endloop")?;
        self.keyword(b"endfacet")?;
        Ok(corners)
    }

    fn keyword(&mut self, keyword: &'static [u8]) -> Result<(), Error> {
        match self.word() {
            Some(word) if word.eq_ignore_ascii_case(keyword) => Ok(()),
            Some(word) => Err(self.unexpected(word, &format!("`{}`", shown(keyword)))),
            None => Err(self.truncated()),
        }
    }

    fn value(&mut self) -> Result<f32, Error> {
        let Some(word) = self.word() else { return Err(self.truncated()) };
        single(word).ok_or_else(|| self.unexpected(word, "a number"))
    }

    fn unexpected(&self, word: &[u8], expected: &str) -> Error {
        let message = format!("expected {expected}, found `{}`", shown(word));
        let line = line_of(self.bytes, self.at.saturating_sub(1));
        Error::at(Place::Line(line), ErrorKind::Malformed(message))
    }

    fn truncated(&self) -> Error {
        let line = line_of(self.bytes, self.bytes.len());
        Error::at(Place::Line(line), ErrorKind::Truncated("a facet".to_owned()))
    }
}
