//! Lines of OBJ and MTL.

use std::borrow::Cow;

/// Lines; one that ends in a backslash is joined with the next.
#[derive(Clone)]
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    /// The line terminator: LF, perhaps after CR; in very old files CR alone.
    end: u8,
    /// The number of the last line returned; for a joined one, of its first.
    pub(super) number: u64,
    next_number: u64,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let rest = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let end = if rest.contains(&b'\n') { b'\n' } else { b'\r' };
        Self { rest, end, number: 0, next_number: 1 }
    }

    /// The lines of the next block: at least `least` bytes, to the end of a line that isn't joined
    /// with the next. `None` at the end.
    pub(super) fn block(&mut self, at_least: usize) -> Option<Self> {
        if self.rest.is_empty() {
            return None;
        }
        let mut length = at_least.min(self.rest.len());
        while length < self.rest.len() {
            let line = self.rest[length..].iter().position(|&byte| byte == self.end);
            length = line.map_or(self.rest.len(), |line| length + line + 1);
            let before = &self.rest[..length - 1];
            if before.strip_suffix(b"\r").unwrap_or(before).last() != Some(&b'\\') {
                break;
            }
        }
        let (block, rest) = self.rest.split_at(length);
        self.rest = rest;
        Some(Self { rest: block, end: self.end, number: 0, next_number: 1 })
    }

    /// The number of lines returned so far.
    pub(super) const fn given(&self) -> u64 {
        self.next_number - 1
    }

    pub(super) fn next(&mut self) -> Option<Cow<'a, [u8]>> {
        self.number = self.next_number;
        let line = self.physical()?;
        if line.last() != Some(&b'\\') || line.first() == Some(&b'#') {
            return Some(Cow::Borrowed(line));
        }
        let mut joined = line.to_vec();
        while joined.pop_if(|byte| *byte == b'\\').is_some() {
            joined.push(b' ');
            joined.extend(self.physical().unwrap_or_default());
        }
        Some(Cow::Owned(joined))
    }

    fn physical(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        let end = self.rest.iter().position(|&byte| byte == self.end);
        let (line, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest.get(1..).unwrap_or_default();
        self.next_number += 1;
        Some(line.strip_suffix(b"\r").unwrap_or(line))
    }
}
