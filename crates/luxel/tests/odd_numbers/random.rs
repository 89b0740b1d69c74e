//! Odd numbers at random.

const TINY: [f32; 10] = [0.0, -0.0, 1e-45, -1e-45, 1e-38, -1e-38, 1e-30, -1e-20, 1e-10, -1e-7];
const COMMON: [f32; 9] = [1.0, -1.0, 0.5, 0.25, 2.0, -3.0, 0.999_999, 1.000_000_1, 7.5];
const HUGE: [f32; 8] = [1e7, -1e8, 8_388_608.0, 16_777_217.0, 1e15, -1e20, 3e38, -3e38];

/// xorshift64* (Vigna 2016).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 16
    }

    pub(crate) fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.next() % choices.len() as u64) as usize]
    }

    /// Whether this is one of the cases that are `percent` of all.
    pub(crate) fn is_in_percent(&mut self, percent: u64) -> bool {
        self.next() % 100 < percent
    }

    /// A number, a tiny one in `tiny` percent of all cases.
    pub(crate) fn number(&mut self, tiny: u64) -> f32 {
        if self.is_in_percent(tiny) {
            self.one_of(&TINY)
        } else if self.is_in_percent(4) {
            self.one_of(&HUGE)
        } else if self.is_in_percent(50) {
            self.one_of(&COMMON)
        } else {
            (self.next() % 4001) as f32 / 1000.0 - 2.0
        }
    }

    /// Such numbers.
    pub(crate) fn vector<const N: usize>(&mut self, tiny: u64) -> [f32; N] {
        [(); N].map(|()| self.number(tiny))
    }
}
