//! A cursor over bytes that knows what ends too early.
#![cfg_attr(
    not(all(feature = "exr", feature = "hdr")),
    allow(dead_code, reason = "each decoder uses a part of it")
)]

use crate::{Error, ErrorKind, Place};

/// Bytes with a place in them.
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Cursor<'a> {
    pub(super) const fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at }
    }

    /// The place of the next byte.
    pub(super) const fn at(&self) -> usize {
        self.at
    }

    /// Takes bytes; an error names `what` they are if the file ends before.
    pub(super) fn take(&mut self, count: usize, what: &str) -> Result<&'a [u8], Error> {
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let taken = rest.get(..count).ok_or_else(|| self.truncated(what))?;
        self.at += count;
        Ok(taken)
    }

    pub(super) fn array<const N: usize>(&mut self, what: &str) -> Result<[u8; N], Error> {
        let taken = self.take(N, what)?;
        taken.first_chunk().copied().ok_or_else(|| self.truncated(what))
    }

    pub(super) fn byte(&mut self, what: &str) -> Result<u8, Error> {
        self.array::<1>(what).map(|[byte]| byte)
    }

    pub(super) fn i32(&mut self, what: &str) -> Result<i32, Error> {
        self.array(what).map(i32::from_le_bytes)
    }

    pub(super) fn u32(&mut self, what: &str) -> Result<u32, Error> {
        self.array(what).map(u32::from_le_bytes)
    }

    pub(super) fn u64(&mut self, what: &str) -> Result<u64, Error> {
        self.array(what).map(u64::from_le_bytes)
    }

    /// The bytes before the next `end`, at most `most`, which is taken, too.
    pub(super) fn until(&mut self, end: u8, most: usize, what: &str) -> Result<&'a [u8], Error> {
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let within = &rest[..rest.len().min(most + 1)];
        let Some(length) = within.iter().position(|&byte| byte == end) else {
            if within.len() <= most {
                return Err(self.truncated(what));
            }
            let message = format!("{what} is longer than {most} bytes");
            return Err(Error::at(Place::Byte(self.at as u64), ErrorKind::Malformed(message)));
        };
        self.at += length + 1;
        Ok(&within[..length])
    }

    pub(super) fn truncated(&self, what: &str) -> Error {
        let end = Place::Byte(self.bytes.len() as u64);
        Error::at(end, ErrorKind::Truncated(what.to_owned()))
    }
}
