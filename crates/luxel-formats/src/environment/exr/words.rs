//! Small numbers at the front of a block, and bits, the highest of a byte first.

/// Takes the first bytes.
pub(super) fn array<const N: usize>(rest: &mut &[u8]) -> Result<[u8; N], String> {
    let (taken, after) = rest.split_first_chunk().ok_or("damaged: it is cut off")?;
    *rest = after;
    Ok(*taken)
}

/// Bits, taken one after another.
pub(super) struct Bits<'a> {
    bytes: &'a [u8],
    /// Bytes from which no bit is in `ahead`.
    rest: &'a [u8],
    /// The next bits, from the highest on, and how many there are; 0 beyond them.
    ahead: u64,
    count: u32,
}

impl<'a> Bits<'a> {
    pub(super) const fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, rest: bytes, ahead: 0, count: 0 }
    }

    /// The next 57 bits at least, and zeros after the last one.
    pub(super) fn ahead(&mut self) -> u64 {
        while self.count <= 56
            && let Some((&byte, after)) = self.rest.split_first()
        {
            self.ahead |= u64::from(byte) << (56 - self.count);
            self.count += 8;
            self.rest = after;
        }
        self.ahead
    }

    /// Passes by bits that [`ahead`](Self::ahead) has shown, 63 at most; `None` if there are fewer.
    pub(super) fn skip(&mut self, count: u32) -> Option<()> {
        self.count = self.count.checked_sub(count)?;
        self.ahead <<= count;
        Some(())
    }

    /// Takes 1 to 57 bits.
    pub(super) fn take(&mut self, count: u32) -> Option<u64> {
        let value = self.ahead() >> (64 - count);
        self.skip(count).map(|()| value)
    }

    /// The bytes of which no bit has been taken.
    pub(super) fn whole_bytes(&self) -> &'a [u8] {
        let whole = self.rest.len() + self.count as usize / 8;
        &self.bytes[self.bytes.len() - whole..]
    }
}
