//! PIZ: the values that occur are numbered, a Haar wavelet takes neighbours apart, and Huffman's codes shorten
//! what is left. Samples are words of 16 bits here; longer ones are several.

use super::Area;
use super::header::Header;
use super::words::{Bits, array};

/// A bit for each of the values of 16 bits.
const BITMAP: usize = 1 << 13;
/// The longest code. Longer ones would need more samples than a picture has.
const LONGEST: usize = 57;
/// Codes of so many bits are found in a table.
const SHORT: u32 = 12;
/// Lengths of codes from here on stand for runs of symbols without a code: of 2 to 5 by the length itself, and
/// of 6 to 261 by eight more bits.
const SHORT_RUN: u64 = 59;
const LONG_RUN: u64 = 63;

/// The samples of a block, `expected` bytes.
pub(super) fn expanded(
    compressed: &[u8],
    expected: usize,
    header: &Header,
    area: Area,
) -> Result<Vec<u8>, String> {
    let mut rest = compressed;
    let values = values(&mut rest)?;
    let length = u32::from_le_bytes(array(&mut rest)?) as usize;
    let coded = rest.get(..length).ok_or("damaged: codes are cut off")?;
    let mut words = decoded(coded, expected / 2)?;
    // Channel by channel, in planes of the words of their samples.
    let mut start = 0;
    for &kind in &header.channels {
        let count = kind.bytes() / 2;
        let end = start + area.width * area.height * count;
        for first in start..start + count {
            let plane = &mut words[first..end];
            restore(plane, area, count, values.len() <= 1 << 14);
        }
        start = end;
    }
    let mut samples = Vec::with_capacity(expected);
    for line in 0..area.height {
        let mut start = 0;
        for &kind in &header.channels {
            let length = area.width * kind.bytes() / 2;
            let first = start + line * length;
            for &word in &words[first..first + length] {
                let value = values.get(usize::from(word)).copied().unwrap_or_default();
                samples.extend_from_slice(&value.to_le_bytes());
            }
            start += area.height * length;
        }
    }
    Ok(samples)
}

/// The values that occur, and 0, in their order.
fn values(rest: &mut &[u8]) -> Result<Vec<u16>, String> {
    let [first, last] =
        [array(rest)?, array(rest)?].map(|bytes| usize::from(u16::from_le_bytes(bytes)));
    if last >= BITMAP {
        return Err(format!("damaged: a table of {BITMAP} bytes ends at {last}"));
    }
    let mut values = vec![0];
    if first <= last {
        let length = last + 1 - first;
        let (bitmap, after) =
            rest.split_at_checked(length).ok_or("damaged: the table of values is cut off")?;
        *rest = after;
        for (at, byte) in bitmap.iter().enumerate() {
            let value = |bit: usize| ((first + at) * 8 + bit) as u16;
            values.extend((0..8).filter(|bit| byte >> bit & 1 != 0).map(value).filter(|&v| v != 0));
        }
    }
    Ok(values)
}

/// Undoes the wavelet of a plane whose words are `step` apart, from coarse to fine. Few values leave room to spare
/// in 16 bits.
fn restore(plane: &mut [u16], area: Area, step: usize, few: bool) {
    let Area { width, height, .. } = area;
    let join = if few { join_few } else { join_many };
    let down = width * step;
    let mut side = 1 << width.min(height).ilog2();
    while side > 1 {
        let half = side / 2;
        let (wide, high) = (width - width % side, height - height % side);
        let mut pair = |a: usize, b: usize| (plane[a], plane[b]) = join(plane[a], plane[b]);
        let (right, below) = (half * step, half * down);
        for y in (0..high).step_by(side) {
            for x in (0..wide).step_by(side) {
                let at = y * down + x * step;
                pair(at, at + below);
                pair(at + right, at + right + below);
                pair(at, at + right);
                pair(at + below, at + below + right);
            }
            if width & half != 0 {
                let at = y * down + wide * step;
                pair(at, at + below);
            }
        }
        if height & half != 0 {
            for x in (0..wide).step_by(side) {
                let at = high * down + x * step;
                pair(at, at + right);
            }
        }
        side = half;
    }
}

/// Two values, from their mean and difference of fewer than 16 bits.
fn join_few(mean: u16, difference: u16) -> (u16, u16) {
    let difference = difference as i16;
    let first = (mean as i16).wrapping_add(difference & 1).wrapping_add(difference >> 1);
    (first as u16, first.wrapping_sub(difference) as u16)
}

/// Two values, from their mean and difference in a circle of 16 bits.
fn join_many(mean: u16, difference: u16) -> (u16, u16) {
    let second = mean.wrapping_sub(difference >> 1);
    (difference.wrapping_add(second).wrapping_sub(1 << 15), second)
}

/// Canonical codes: those of one length are consecutive numbers, and longer ones begin with lower bits.
struct Codes {
    /// Symbols by length, and by number among those of the same length.
    symbols: Vec<u32>,
    /// Of each length: the first code, how many there are, and where their symbols begin.
    lengths: [(u64, usize, usize); LONGEST + 1],
    /// The symbol of each sequence of [`SHORT`] bits, times 256, and the length of its code; 0 for longer codes.
    short: Vec<u32>,
}

impl Codes {
    /// From each symbol's length.
    fn new(lengths_of_symbols: &[(u32, usize)]) -> Result<Self, String> {
        let mut lengths = [(0, 0, 0); LONGEST + 1];
        for &(_, length) in lengths_of_symbols {
            lengths[length].1 += 1;
        }
        let mut first = 0;
        for (code, count, _) in lengths.iter_mut().skip(1).rev() {
            *code = first;
            first = (first + *count as u64) >> 1;
        }
        if first > 1
            || (1..SHORT as usize)
                .any(|length| lengths[length].0 + lengths[length].1 as u64 > 1 << length)
        {
            return Err("damaged: there are more codes than bits allow".to_owned());
        }
        let mut start = 0;
        for (_, count, begin) in &mut lengths {
            *begin = start;
            start += *count;
        }
        let mut symbols = vec![0; start];
        let mut next = lengths;
        for &(symbol, length) in lengths_of_symbols {
            symbols[next[length].2] = symbol;
            next[length].2 += 1;
        }
        let mut short = vec![0; 1 << SHORT];
        for (length, &(code, count, begin)) in lengths.iter().enumerate().take(SHORT as usize + 1) {
            let shift = SHORT as usize - length;
            for (number, &symbol) in symbols[begin..begin + count].iter().enumerate() {
                let from = (code as usize + number) << shift;
                let same = short.get_mut(from..from + (1 << shift)).unwrap_or_default();
                same.fill(symbol << 8 | length as u32);
            }
        }
        Ok(Self { symbols, lengths, short })
    }

    /// The next symbol.
    fn next(&self, bits: &mut Bits<'_>) -> Option<u32> {
        let ahead = bits.ahead();
        let known = self.short[(ahead >> (64 - SHORT)) as usize];
        if known != 0 {
            bits.skip(known & 0xff)?;
            return Some(known >> 8);
        }
        for length in SHORT as usize + 1..=LONGEST {
            let (first, count, begin) = self.lengths[length];
            let number = (ahead >> (64 - length)).checked_sub(first).map(|number| number as usize);
            if let Some(number) = number.filter(|&number| number < count) {
                bits.skip(length as u32)?;
                return self.symbols.get(begin + number).copied();
            }
        }
        None
    }
}

/// `count` words of Huffman's codes. The last symbol repeats the word before as often as eight more bits say.
fn decoded(coded: &[u8], count: usize) -> Result<Vec<u16>, String> {
    let mut rest = coded;
    let [first, last, _, length, _] = [(); 5].map(|()| array(&mut rest).map(u32::from_le_bytes));
    let (first, last, length) = (first?, last?, length? as usize);
    if last > 1 << 16 || first > last {
        return Err(format!("damaged: codes are of the symbols {first} to {last}"));
    }
    let mut bits = Bits::new(rest);
    let lengths =
        lengths_of_symbols(&mut bits, first, last).ok_or("damaged: the table of codes")?;
    let codes = Codes::new(&lengths)?;
    let data = bits.whole_bytes();
    let data = data.get(..length.div_ceil(8)).ok_or("damaged: codes are cut off")?;
    let mut bits = Bits::new(data);
    let mut words = Vec::with_capacity(count);
    while words.len() < count {
        let symbol = codes.next(&mut bits).ok_or("damaged: a code that is none")?;
        if symbol != last {
            words.push(symbol as u16);
            continue;
        }
        let run = bits.take(8).ok_or("damaged: a run is cut off")? as usize;
        let word = words.last().copied().filter(|_| run <= count - words.len());
        words.resize(words.len() + run, word.ok_or("damaged: a run of nothing, or too long")?);
    }
    Ok(words)
}

/// The symbols that have codes, with their lengths.
fn lengths_of_symbols(bits: &mut Bits<'_>, first: u32, last: u32) -> Option<Vec<(u32, usize)>> {
    let mut lengths = Vec::new();
    let mut symbol = first;
    while symbol <= last {
        let length = bits.take(6)?;
        symbol += match length {
            LONG_RUN => bits.take(8)? as u32 + 6,
            SHORT_RUN.. => (length - SHORT_RUN) as u32 + 2,
            0 => 1,
            _ if length as usize > LONGEST => return None,
            _ => {
                lengths.push((symbol, length as usize));
                1
            }
        };
    }
    (symbol == last + 1).then_some(lengths)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean and difference, as they are written.
    fn split_few(a: u16, b: u16) -> (u16, u16) {
        let (a, b) = (a as i16, b as i16);
        (((i32::from(a) + i32::from(b)) >> 1) as u16, a.wrapping_sub(b) as u16)
    }

    fn split_many(a: u16, b: u16) -> (u16, u16) {
        let shifted = a.wrapping_add(1 << 15);
        let mean = ((u32::from(shifted) + u32::from(b)) >> 1) as u16;
        let (difference, is_less) = shifted.overflowing_sub(b);
        (if is_less { mean.wrapping_add(1 << 15) } else { mean }, difference)
    }

    #[test]
    fn two_values_come_back_from_mean_and_difference() {
        for a in (0..1 << 14).step_by(37) {
            for b in (0..1 << 14).step_by(41) {
                let (mean, difference) = split_few(a, b);
                assert_eq!(join_few(mean, difference), (a, b));
            }
        }
        for a in (0..=u16::MAX).step_by(251) {
            for b in (0..=u16::MAX).step_by(241) {
                let (mean, difference) = split_many(a, b);
                assert_eq!(join_many(mean, difference), (a, b));
            }
        }
    }

    #[test]
    fn codes_that_are_too_many_are_damage_and_long_ones_are_found() {
        assert!(Codes::new(&[(0, 1), (1, 1), (2, 1)]).is_err());
        assert!(Codes::new(&[(0, 1), (1, 2), (2, 2)]).is_ok());
        // 1, 01, 001, ...: n zeros for symbol n. The last two have as many bits.
        let lengths: Vec<(u32, usize)> = (0..20).map(|n| (n, (n as usize + 1).min(19))).collect();
        let codes = Codes::new(&lengths).unwrap();
        for n in [0, 5, 11, 12, 17] {
            let bytes = (1_u64 << (63 - n)).to_be_bytes();
            assert_eq!(codes.next(&mut Bits::new(&bytes)), Some(n), "{n}");
        }
        assert_eq!(codes.next(&mut Bits::new(&[0; 8])), Some(18));
        assert_eq!(codes.next(&mut Bits::new(&(1_u64 << 45).to_be_bytes())), Some(19));
        assert_eq!(codes.next(&mut Bits::new(&[])), None);
    }
}
