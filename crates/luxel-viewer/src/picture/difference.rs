//! Differences of two pictures, and two pictures side by side.

/// The difference of two pictures, in 8-bit steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PictureDifference {
    /// The largest difference of any channel, alpha included.
    pub(crate) largest: u8,
    /// The mean, over all pixels, of the largest difference of a channel.
    pub(crate) mean: f64,
    /// The fraction of pixels that differ.
    pub(crate) share: f64,
}

/// The colour scale of differences: least difference, label, colour.
pub(crate) const DIFFERENCE_SCALE: [(u8, &str, [u8; 3]); 8] = [
    (1, "1", [0x2d, 0x3a, 0x78]),
    (2, "2", [0x5a, 0x3f, 0x96]),
    (3, "3-4", [0x8c, 0x43, 0x98]),
    (5, "5-8", [0xbb, 0x48, 0x80]),
    (9, "9-16", [0xdd, 0x5f, 0x5c]),
    (17, "17-32", [0xf0, 0x88, 0x41]),
    (33, "33-64", [0xf8, 0xbd, 0x4f]),
    (65, "65+", [0xfd, 0xf3, 0xb8]),
];

/// The difference of two pictures of the same size: as colours of [`DIFFERENCE_SCALE`], transparent
/// where they agree, and as statistics.
pub(crate) fn difference_map(
    one: &[[u8; 4]],
    other: &[[u8; 4]],
) -> (Vec<[u8; 4]>, PictureDifference) {
    let mut largest = 0;
    let (mut sum, mut differing) = (0_u64, 0_u64);
    let color = |(a, b): (&[u8; 4], &[u8; 4])| {
        let difference = (0..4).map(|channel| a[channel].abs_diff(b[channel])).max().unwrap_or(0);
        largest = largest.max(difference);
        sum += u64::from(difference);
        differing += u64::from(difference > 0);
        let step = DIFFERENCE_SCALE.iter().rev().find(|(least, ..)| difference >= *least);
        step.map_or([0; 4], |(_, _, [r, g, b])| [*r, *g, *b, 255])
    };
    let colors: Vec<_> = one.iter().zip(other).map(color).collect();
    let count = colors.len().max(1) as f64;
    let (mean, share) = (sum as f64 / count, differing as f64 / count);
    (colors, PictureDifference { largest, mean, share })
}

/// Overwrites the columns from `from` on with those of another picture of the same width.
pub(crate) fn join_columns(left: &mut [u32], right: &[u32], width: usize, from: usize) {
    let rows = left.chunks_exact_mut(width.max(1)).zip(right.chunks_exact(width.max(1)));
    for (left, right) in rows {
        let from = from.min(left.len());
        left[from..].copy_from_slice(&right[from..]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_counted_by_the_channel_that_differs_most() {
        let one = [[10, 20, 30, 255], [0, 0, 0, 0], [200, 0, 0, 255], [5, 5, 5, 255]];
        let other = [[10, 22, 29, 255], [0, 0, 0, 0], [100, 0, 0, 255], [5, 5, 5, 254]];
        let (colors, difference) = difference_map(&one, &other);
        assert_eq!(difference, PictureDifference { largest: 100, mean: 103.0 / 4.0, share: 0.75 });
        let color = |at: usize| colors[at];
        assert_eq!(color(1), [0; 4]);
        for (at, step) in [(0, 1), (2, 7), (3, 0)] {
            let [r, g, b] = DIFFERENCE_SCALE[step].2;
            assert_eq!(color(at), [r, g, b, 255], "{at}");
        }
    }

    #[test]
    fn each_side_keeps_its_columns() {
        let mut left = vec![1; 12];
        join_columns(&mut left, &[2; 12], 4, 3);
        assert_eq!(left, [1, 1, 1, 2, 1, 1, 1, 2, 1, 1, 1, 2]);
        join_columns(&mut left, &[3; 12], 4, 9);
        assert_eq!(left[3], 2);
    }
}
