//! How much a file may ask for.

use crate::{Error, ErrorKind, Place};

/// Bounds that are checked before memory is taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes that one model may take in memory, textures included.
    pub max_memory: u64,
    /// How deep nodes, groups or JSON values may nest.
    pub max_depth: u32,
}

impl Default for Limits {
    /// 8 GiB, 1024 levels.
    fn default() -> Self {
        Self { max_memory: 8 << 30, max_depth: 1024 }
    }
}

impl Limits {
    /// Checks that `count` things of `bytes_each` fit.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if they don't, also where the product overflows.
    pub fn check(
        &self,
        what: &str,
        count: u64,
        bytes_each: u64,
        place: Place,
    ) -> Result<(), Error> {
        let needed = count.saturating_mul(bytes_each);
        if needed <= self.max_memory {
            return Ok(());
        }
        let kind = ErrorKind::TooLarge { what: what.to_owned(), needed, limit: self.max_memory };
        Err(Error::at(place, kind))
    }
}
