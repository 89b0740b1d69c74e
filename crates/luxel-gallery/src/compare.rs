//! The error of an image against its reference.

use crate::picture::Picture;

/// The difference of two pictures in steps of 8 bits, the largest of the three channels counting
/// for a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Error {
    /// Of the worst pixel.
    pub largest: f64,
    /// Over all pixels that were compared.
    pub mean: f64,
}

impl Error {
    /// Of some differences.
    pub(crate) fn of(differences: impl Iterator<Item = f64>) -> Self {
        let (mut largest, mut sum, mut count) = (0.0_f64, 0.0, 0_u32);
        for difference in differences {
            largest = largest.max(difference);
            sum += difference;
            count += 1;
        }
        Self { largest, mean: if count == 0 { 0.0 } else { sum / f64::from(count) } }
    }
}

/// The difference of two pixels.
fn difference(a: [u8; 3], b: [u8; 3]) -> u8 {
    a[0].abs_diff(b[0]).max(a[1].abs_diff(b[1])).max(a[2].abs_diff(b[2]))
}

/// How far a picture is from a reference, where `counts` is true.
pub(crate) fn error(picture: &Picture, reference: &Picture, counts: &[bool]) -> Error {
    let pairs = picture.pixels.iter().zip(&reference.pixels).zip(counts);
    Error::of(pairs.filter(|(_, counts)| **counts).map(|((a, b), _)| difference(*a, *b).into()))
}

/// So many steps and more are white in a picture of errors; half of them are amber.
pub(crate) const WHITE: f64 = 64.0;

/// Where a picture differs from a reference: dark, amber, white. Where nothing is compared it is
/// darker still.
pub(crate) fn error_picture(picture: &Picture, reference: &Picture, counts: &[bool]) -> Picture {
    let pairs = picture.pixels.iter().zip(&reference.pixels).zip(counts);
    let heat = |((a, b), counts): ((&[u8; 3], &[u8; 3]), &bool)| {
        if *counts { heat(f64::from(difference(*a, *b)) / WHITE) } else { [0x10, 0x11, 0x13] }
    };
    Picture { size: picture.size, pixels: pairs.map(heat).collect() }
}

/// A colour for 0 to 1.
fn heat(t: f64) -> [u8; 3] {
    const STOPS: [[f64; 3]; 3] = [[35.0, 38.0, 43.0], [242.0, 184.0, 75.0], [255.0, 252.0, 244.0]];
    let t = t.clamp(0.0, 1.0) * 2.0;
    let (from, to, t) = if t < 1.0 { (0, 1, t) } else { (1, 2, t - 1.0) };
    [0, 1, 2].map(|at| (STOPS[from][at] + (STOPS[to][at] - STOPS[from][at]) * t).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::scene::Size;

    fn picture(pixels: Vec<[u8; 3]>) -> Picture {
        Picture { size: Size { width: pixels.len() as u32, height: 1 }, pixels }
    }

    #[test]
    fn the_error_is_that_of_the_worst_channel_within_the_mask() {
        let a = picture(vec![[10, 20, 30], [0, 0, 0], [200, 0, 0]]);
        let b = picture(vec![[12, 15, 30], [0, 0, 0], [0, 0, 0]]);
        let found = error(&a, &b, &[true, true, false]);
        assert_eq!(found, Error { largest: 5.0, mean: 2.5 });
        assert_eq!(error(&a, &b, &[true; 3]).largest, 200.0);
    }
}
