//! One attribute of a run of vertices.

use super::view::Values;

/// Values of an attribute that commands set between vertices.
///
/// What nobody changes between vertices is kept once. The first change between them fills in the past, as far as it is
/// known: vertices before the first value have what was current when the run began.
#[derive(Clone, Debug)]
pub(crate) struct Column<T> {
    /// The value of the next vertex, and of all so far unless they vary; nothing until one is set.
    now: T,
    is_set: bool,
    varies: bool,
    /// The vertex of the first value.
    first: u32,
    values: Vec<T>,
}

/// Values that are the same down to each bit.
pub(crate) trait Bits {
    fn are_alike(&self, other: &Self) -> bool;
}

impl Bits for f32 {
    fn are_alike(&self, other: &Self) -> bool {
        self.to_bits() == other.to_bits()
    }
}

impl Bits for bool {
    fn are_alike(&self, other: &Self) -> bool {
        self == other
    }
}

impl<T: Bits, const N: usize> Bits for [T; N] {
    fn are_alike(&self, other: &Self) -> bool {
        // Without a way out: all are compared at once.
        self.iter().zip(other).fold(true, |alike, (own, other)| alike & own.are_alike(other))
    }
}

impl<T: Copy + Default> Default for Column<T> {
    fn default() -> Self {
        let values = Vec::new();
        Self { now: T::default(), is_set: false, varies: false, first: 0, values }
    }
}

impl<T: Copy> Column<T> {
    /// Begins a run of vertices whose value is known.
    pub(super) fn restart(&mut self, now: T) {
        self.clear();
        (self.now, self.is_set) = (now, true);
    }

    /// Forgets all values, but not the room for them.
    pub(super) fn clear(&mut self) {
        self.values.clear();
        (self.is_set, self.varies, self.first) = (false, false, 0);
    }

    /// Changes the value for the next vertex, of which `count` are already there.
    #[inline]
    pub(crate) fn set(&mut self, value: T, count: usize) {
        if !self.varies && count > 0 {
            self.vary(count);
        }
        (self.now, self.is_set) = (value, true);
    }

    /// Gives vertices values of their own.
    #[cold]
    fn vary(&mut self, count: usize) {
        self.varies = true;
        if self.is_set {
            self.values.resize(count, self.now);
        } else {
            self.first = count as u32;
        }
    }

    /// Appends a vertex.
    #[inline(always)]
    pub(super) fn push(&mut self) {
        if self.varies {
            self.values.push(self.now);
        }
    }

    /// Appends another run of `more` vertices to `count`, whose values are known.
    pub(super) fn append(&mut self, count: usize, other: &Self, more: usize) {
        if other.varies {
            if !self.varies {
                self.vary(count);
            }
            let before = self.values.len() + other.first as usize;
            self.values.resize(before, self.now);
            self.values.extend_from_slice(&other.values);
            self.now = other.now;
        } else {
            if other.is_set {
                self.set(other.now, count);
            }
            if self.varies {
                self.values.resize(self.values.len() + more, self.now);
            }
        }
    }

    /// Takes the value that another run has set last, for the next vertex, of which `count` are already there.
    pub(super) fn take(&mut self, count: usize, other: &Self) {
        if let Some(now) = other.now() {
            self.set(now, count);
        }
    }

    /// Keeps the first vertices.
    pub(super) fn truncate(&mut self, count: usize) {
        self.values.truncate(count.saturating_sub(self.first as usize));
    }

    /// Drops the first `count` vertices, whose values are known.
    pub(super) fn drop_first(&mut self, count: usize) {
        if self.varies {
            self.values.drain(..count);
        }
    }

    /// Whether all values are known, or none is.
    pub(super) fn is_known(&self) -> bool {
        !self.varies || self.first == 0
    }

    /// The values of vertices that are all known; where the run itself has set none, what is current.
    pub(super) fn view(&self, current: T) -> Values<'_, T> {
        Values {
            of_all: if self.is_set { self.now } else { current },
            of_each: self.varies.then_some(&self.values),
        }
    }

    /// The values of some vertices, all of which are known.
    pub(super) fn gathered(&self, places: &[u32]) -> Self {
        let places = if self.varies { places } else { &[] };
        let values = places.iter().map(|&place| self.values[place as usize]).collect();
        let Self { now, is_set, varies, .. } = *self;
        Self { now, is_set, varies, first: 0, values }
    }

    /// Bytes that it has room for.
    pub(super) fn bytes(&self) -> usize {
        self.values.capacity() * size_of::<T>()
    }

    /// Gives back room that nobody needs.
    pub(super) fn shrink(&mut self) {
        self.values.shrink_to_fit();
    }

    /// The value of the next vertex, if one has been set.
    pub(super) fn now(&self) -> Option<T> {
        self.is_set.then_some(self.now)
    }

    /// Whether vertices have values of their own.
    #[inline]
    pub(crate) fn varies(&self) -> bool {
        self.varies
    }
}

impl<T: Copy + Bits> Column<T> {
    /// Whether two vertices have the same value.
    #[inline]
    pub(super) fn are_alike(&self, a: usize, b: usize) -> bool {
        !self.varies || self.values[a].are_alike(&self.values[b])
    }
}
