//! Keys in order. One instance of the sort for each kind of key, for all crates.

use crate::pool::sort;

/// Sorts on all threads.
pub fn sort_u32(keys: &mut [u32]) {
    sort(keys);
}

/// Sorts on all threads.
pub fn sort_u64(keys: &mut [u64]) {
    sort(keys);
}

/// Sorts on all threads.
pub fn sort_u128(keys: &mut [u128]) {
    sort(keys);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_come_in_order() {
        let mixed = |number: u32| number.wrapping_mul(2_654_435_769);
        let mut keys: Vec<u32> = (0..50_000).map(mixed).collect();
        let mut long: Vec<u64> = keys.iter().map(|&key| u64::from(key) << 32 | 7).collect();
        let mut longest: Vec<u128> = keys.iter().map(|&key| u128::from(key) << 96 | 7).collect();
        sort_u32(&mut keys);
        sort_u64(&mut long);
        sort_u128(&mut longest);
        assert!(keys.is_sorted());
        assert!(long.iter().zip(&keys).all(|(long, &key)| *long == u64::from(key) << 32 | 7));
        assert!(longest.iter().zip(&keys).all(|(long, &key)| *long == u128::from(key) << 96 | 7));
    }
}
