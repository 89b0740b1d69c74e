//! Welding: equal keys get one index.

/// A table from keys of three words to indices, in order of first occurrence.
///
/// Open addressing with linear probing; a slot holds part of the hash, so that unequal keys are
/// seldom compared. Indices depend on the order of keys alone.
#[derive(Debug)]
pub(crate) struct Welder {
    /// 0 if free, else the upper half of the hash above the index plus one.
    slots: Vec<u64>,
    keys: Vec<[u32; 3]>,
}

/// Maximum bytes of a key: itself, and its slots before and after the table grows.
pub(crate) const BYTES_PER_KEY: u64 = 12 + 8 * 4;

impl Welder {
    /// A table with room for about so many keys before it grows.
    pub(crate) fn with_room_for(count: usize) -> Self {
        let slots = if count == 0 { 0 } else { (count * 3 / 2).max(16).next_power_of_two() };
        Self { slots: vec![0; slots], keys: Vec::with_capacity(count) }
    }

    /// The index of a key, and whether it is new.
    #[inline]
    pub(crate) fn insert(&mut self, key: [u32; 3]) -> (u32, bool) {
        self.insert_hashed(key, hash(key))
    }

    /// The indices of several keys. Slots of large tables miss the cache: all are loaded before
    /// the first is used.
    #[inline]
    pub(crate) fn insert_all<const N: usize>(&mut self, keys: [[u32; 3]; N]) -> [u32; N] {
        let hashes = keys.map(hash);
        let mask = self.slots.len().wrapping_sub(1);
        let slots = hashes.map(|hash| self.slots.get(hash as usize & mask).copied());
        std::hint::black_box(&slots);
        let mut numbers = [0; N];
        for ((number, key), hash) in numbers.iter_mut().zip(keys).zip(hashes) {
            *number = self.insert_hashed(key, hash).0;
        }
        numbers
    }

    #[inline]
    fn insert_hashed(&mut self, key: [u32; 3], hash: u64) -> (u32, bool) {
        if (self.keys.len() + 1) * 4 > self.slots.len() * 3 {
            self.grow();
        }
        let mask = self.slots.len() - 1;
        let mut place = hash as usize & mask;
        loop {
            let slot = self.slots[place];
            if slot == 0 {
                break;
            }
            let index = slot as u32 - 1;
            if slot >> 32 == hash >> 32 && self.keys[index as usize] == key {
                return (index, false);
            }
            place = (place + 1) & mask;
        }
        let index = self.keys.len() as u32;
        self.keys.push(key);
        self.slots[place] = (hash >> 32 << 32) | u64::from(index + 1);
        (index, true)
    }

    /// The keys by index, without the table.
    pub(crate) fn into_keys(self) -> Vec<[u32; 3]> {
        self.keys
    }

    /// The keys by index.
    pub(crate) fn keys(&self) -> &[[u32; 3]] {
        &self.keys
    }

    #[cold]
    fn grow(&mut self) {
        let mask = (self.slots.len() * 2).max(16) - 1;
        self.slots.clear();
        self.slots.resize(mask + 1, 0);
        for (index, &key) in self.keys.iter().enumerate() {
            let hash = hash(key);
            let mut place = hash as usize & mask;
            while self.slots[place] != 0 {
                place = (place + 1) & mask;
            }
            self.slots[place] = (hash >> 32 << 32) | (index as u64 + 1);
        }
    }
}

/// Multiplies by odd constants (the golden ratio's, and two of xxHash's primes) and folds, so that
/// every bit of the key reaches the low bits.
#[inline]
fn hash([a, b, c]: [u32; 3]) -> u64 {
    let low = u64::from(a) | u64::from(b) << 32;
    let mixed = low.wrapping_mul(0x9e37_79b9_7f4a_7c15)
        ^ u64::from(c).wrapping_add(0x1656_67b1_9e37_79f9).wrapping_mul(0xc2b2_ae3d_27d4_eb4f);
    let mixed = (mixed ^ mixed >> 32).wrapping_mul(0xd6e8_feb8_6659_fd93);
    mixed ^ mixed >> 29
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::HashMap;

    proptest! {
        #[test]
        fn keys_are_numbered_as_a_map_would(
            keys in prop::collection::vec([0_u32..9, 0_u32..9, 0_u32..9], 0..999)
        ) {
            let mut welder = Welder::with_room_for(0);
            let mut map = HashMap::new();
            for key in keys {
                let next = map.len() as u32;
                let expected = *map.entry(key).or_insert(next);
                prop_assert_eq!(welder.insert(key), (expected, expected == next));
                prop_assert_eq!(welder.keys()[expected as usize], key);
            }
        }

        #[test]
        fn keys_are_numbered_alike_one_by_one_and_several_together(
            keys in prop::collection::vec([[0_u32..9, 0_u32..9, 0_u32..9], [0_u32..9, 0_u32..9, 0_u32..9]], 0..999)
        ) {
            let (mut alone, mut together) = (Welder::with_room_for(0), Welder::with_room_for(0));
            for keys in keys {
                let expected = keys.map(|key| alone.insert(key).0);
                prop_assert_eq!(together.insert_all(keys), expected);
            }
            prop_assert_eq!(together.keys(), alone.keys());
        }
    }
}
