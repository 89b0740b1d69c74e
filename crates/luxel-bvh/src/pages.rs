//! Lists of plain values in large pages of memory, where the system has them.
//!
//! The processor translates the address of each access and caches some thousand translations: four
//! megabytes of pages of four kilobytes. Random access to more memory spends more time on translation
//! than on reading. Linux offers pages of two megabytes on request. Elsewhere, and for short lists,
//! [`Pages`] is a plain `Vec`.

use bytemuck::Pod;
#[cfg(target_os = "linux")]
use memmap2::{Advice, MmapMut};
use std::fmt;
use std::ops::{Deref, DerefMut};

/// A list of fixed length, in large pages if it is long.
///
/// Each access by index finds out first where the memory is; hot code takes a slice once.
pub(crate) struct Pages<T>(Memory<T>);

enum Memory<T> {
    Plain(Vec<T>),
    /// `length` elements from `start` on, where a large page begins.
    #[cfg(target_os = "linux")]
    Large {
        map: MmapMut,
        start: usize,
        length: usize,
    },
}

impl<T> Default for Pages<T> {
    fn default() -> Self {
        Self(Memory::Plain(Vec::new()))
    }
}

/// The size of a large page, in bytes.
#[cfg(target_os = "linux")]
const LARGE: usize = 1 << 21;

impl<T: Pod> Pages<T> {
    /// A list of zeros.
    pub(crate) fn zeroed(length: usize) -> Self {
        #[cfg(target_os = "linux")]
        if let Some(large) = large(length) {
            return Self(large);
        }
        Self(Memory::Plain(vec![T::zeroed(); length]))
    }

    /// A copy of a list.
    pub(crate) fn copied(values: &[T]) -> Self {
        let mut pages = Self::zeroed(values.len());
        pages.copy_from_slice(values);
        pages
    }
}

/// Memory in large pages; `None` if the system refuses or the list is shorter than a page.
#[cfg(target_os = "linux")]
fn large<T: Pod>(length: usize) -> Option<Memory<T>> {
    let bytes = length.checked_mul(size_of::<T>())?;
    if bytes < LARGE {
        return None;
    }
    let map = MmapMut::map_anon(bytes.checked_add(LARGE)?).ok()?;
    let start = map.as_ptr().align_offset(LARGE);
    // The rest gets small pages: no memory is taken that isn't used.
    map.advise_range(Advice::HugePage, start, bytes / LARGE * LARGE).ok()?;
    // Fails only for elements aligned to more than a page.
    bytemuck::try_cast_slice::<u8, T>(map.get(start..start + bytes)?).ok()?;
    Some(Memory::Large { map, start, length })
}

impl<T: Pod> Deref for Pages<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        match &self.0 {
            Memory::Plain(values) => values,
            #[cfg(target_os = "linux")]
            Memory::Large { map, start, length } => {
                bytemuck::cast_slice(&map[*start..*start + *length * size_of::<T>()])
            }
        }
    }
}

impl<T: Pod> DerefMut for Pages<T> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        match &mut self.0 {
            Memory::Plain(values) => values,
            #[cfg(target_os = "linux")]
            Memory::Large { map, start, length } => {
                bytemuck::cast_slice_mut(&mut map[*start..*start + *length * size_of::<T>()])
            }
        }
    }
}

impl<T: Pod> Clone for Pages<T> {
    fn clone(&self) -> Self {
        Self::copied(self)
    }
}

impl<T: Pod + fmt::Debug> fmt::Debug for Pages<T> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self[..].fmt(formatter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lengths around those at which pages begin to be large, and to be filled.
    const LENGTHS: [usize; 8] = [0, 1, 1000, 262_143, 262_144, 262_145, 1_000_000, 2_097_152];

    #[test]
    fn a_list_begins_as_zeros_and_keeps_what_is_written() {
        for length in LENGTHS {
            let mut pages = Pages::<u64>::zeroed(length);
            assert_eq!(pages.len(), length);
            assert!(pages.iter().all(|value| *value == 0));
            for (index, value) in pages.iter_mut().enumerate() {
                *value = index as u64;
            }
            assert!((0..).zip(pages.iter()).all(|(index, value)| *value == index));
        }
    }

    #[test]
    fn a_copy_is_a_list_of_its_own() {
        for length in LENGTHS {
            let values: Vec<[f32; 3]> = (0..length).map(|index| [index as f32, 1.0, 2.0]).collect();
            let pages = Pages::copied(&values);
            let mut copy = pages.clone();
            assert_eq!(copy[..], values[..]);
            if let Some(first) = copy.first_mut() {
                *first = [7.0; 3];
            }
            assert_eq!(pages[..], values[..]);
        }
    }

    #[test]
    fn long_lists_begin_where_a_large_page_does() {
        let pages = Pages::<u32>::zeroed(1 << 20);
        if cfg!(target_os = "linux") {
            assert_eq!(pages.as_ptr().addr() % (1 << 21), 0);
        }
    }

    #[test]
    fn elements_may_need_more_than_bytes_do() {
        #[derive(Clone, Copy, bytemuck::Zeroable, bytemuck::Pod)]
        #[repr(C, align(64))]
        struct Line([u8; 64]);
        for length in [1, 1 << 16] {
            let pages = Pages::<Line>::zeroed(length);
            assert_eq!(pages.as_ptr().addr() % 64, 0);
            assert!(pages.iter().all(|line| line.0 == [0; 64]));
        }
    }
}
