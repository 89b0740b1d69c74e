//! Composes a picture over the background gradient, upscaled to the window.

use crate::theme::Theme;
use luxel::scene::Size;

/// An ordered dither for the gradient, in 64ths of a step (Bayer 1973, An optimum method for two-level
/// rendition of continuous-tone pictures).
const DITHER: [[i32; 4]; 4] =
    [[2, 34, 10, 42], [50, 18, 58, 26], [14, 46, 6, 38], [62, 30, 54, 22]];

/// The background along a row: red, green, blue of four consecutive pixels, which repeat.
fn background([top, bottom]: [[u8; 3]; 2], y: usize, height: usize) -> [[u8; 3]; 4] {
    let down = (y * 64 / height.max(1)) as i32;
    let fine = (y * 64 % height.max(1)) as i32 * 64 / height.max(1) as i32;
    // In 64ths of a step of a byte.
    let levels: [i32; 3] = std::array::from_fn(|channel| {
        let (from, to) = (i32::from(top[channel]), i32::from(bottom[channel]));
        from * 64 + (to - from) * down + (to - from) * fine / 64
    });
    DITHER[y % 4].map(|threshold| levels.map(|level| ((level + threshold) / 64) as u8))
}

/// Composes a picture with straight alpha over the background; window pixels are 0RGB.
///
/// Smaller pictures are upscaled bilinearly, between pixel centres.
pub(crate) fn compose(
    (picture, size): (&[[u8; 4]], Size),
    theme: &Theme,
    window: Size,
    pixels: &mut [u32],
) {
    let (across, down) = (window.width as usize, window.height as usize);
    let is_whole = size == window;
    let columns: Vec<_> = (0..across).map(|x| neighbours(x, across, size.width as usize)).collect();
    for (y, row) in pixels.chunks_exact_mut(across.max(1)).take(down).enumerate() {
        let [above, below, weight_y] = neighbours(y, down, size.height as usize);
        let line = |y: usize| &picture[y * size.width as usize..][..size.width as usize];
        let (above, below) = (line(above), line(below));
        let background = background(theme.background, y, down);
        for (x, out) in row.iter_mut().enumerate() {
            let color = if is_whole {
                above[x]
            } else {
                let [left, right, weight_x] = columns[x];
                let corners = [above[left], above[right], below[left], below[right]];
                if corners.iter().all(|corner| corner[3] == 0) {
                    [0; 4]
                } else {
                    bilinear(corners, weight_x as u32, weight_y as u32)
                }
            };
            *out = over(color, background[x % 4]);
        }
    }
}

/// The two source pixels around the centre of a target pixel, and the second's weight in 256ths.
fn neighbours(at: usize, of: usize, source: usize) -> [usize; 3] {
    // The centre in 256ths of source pixels.
    let place = ((2 * at + 1) * source * 128 / of.max(1)).saturating_sub(128);
    let first = (place / 256).min(source.saturating_sub(1));
    let second = (first + 1).min(source.saturating_sub(1));
    [first, second, place % 256]
}

/// Interpolates four pixels. Colours with straight alpha are weighted by it.
fn bilinear(corners: [[u8; 4]; 4], x: u32, y: u32) -> [u8; 4] {
    let weights = [(256 - x) * (256 - y), x * (256 - y), (256 - x) * y, x * y];
    let opaque = corners.iter().all(|corner| corner[3] == 255);
    if opaque {
        let mix = |channel: usize| {
            let parts = corners.iter().zip(weights);
            let sum: u32 = parts.map(|(corner, weight)| u32::from(corner[channel]) * weight).sum();
            ((sum + (1 << 15)) >> 16) as u8
        };
        return [mix(0), mix(1), mix(2), 255];
    }
    let mut sums = [0_u64; 4];
    for (corner, weight) in corners.iter().zip(weights) {
        let weighted = u64::from(weight) * u64::from(corner[3]);
        for channel in 0..3 {
            sums[channel] += u64::from(corner[channel]) * weighted;
        }
        sums[3] += weighted;
    }
    let alpha = sums[3];
    if alpha == 0 {
        return [0; 4];
    }
    let color = |channel: usize| ((sums[channel] + alpha / 2) / alpha) as u8;
    [color(0), color(1), color(2), ((alpha + (1 << 15)) >> 16) as u8]
}

/// A colour with straight alpha over the background.
fn over([r, g, b, alpha]: [u8; 4], background: [u8; 3]) -> u32 {
    match alpha {
        255 => pack([r, g, b]),
        0 => pack(background),
        _ => {
            let alpha = u32::from(alpha);
            let mix = |color: u8, below: u8| {
                ((u32::from(color) * alpha + u32::from(below) * (255 - alpha)) / 255) as u8
            };
            pack([mix(r, background[0]), mix(g, background[1]), mix(b, background[2])])
        }
    }
}

/// The background alone.
pub(crate) fn compose_empty(theme: &Theme, window: Size, pixels: &mut [u32]) {
    let (across, down) = (window.width as usize, window.height as usize);
    for (y, row) in pixels.chunks_exact_mut(across.max(1)).enumerate() {
        let background = background(theme.background, y, down);
        for (x, out) in row.iter_mut().enumerate() {
            *out = pack(background[x % 4]);
        }
    }
}

fn pack([r, g, b]: [u8; 3]) -> u32 {
    u32::from(r) << 16 | u32::from(g) << 8 | u32::from(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::theme::DARK;

    fn composed(picture: &[[u8; 4]], size: [u32; 2], window: [u32; 2]) -> Vec<u32> {
        let [size, window] = [size, window].map(|[width, height]| Size { width, height });
        let mut pixels = vec![0; (window.width * window.height) as usize];
        compose((picture, size), &DARK, window, &mut pixels);
        pixels
    }

    #[test]
    fn an_opaque_picture_of_the_window_s_size_is_unchanged() {
        let picture: Vec<_> = (0..6).map(|n| [n, 2 * n, 3 * n, 255]).collect();
        let expected: Vec<_> = (0..6).map(|n| pack([n, 2 * n, 3 * n])).collect();
        assert_eq!(composed(&picture, [3, 2], [3, 2]), expected);
    }

    #[test]
    fn enlarging_keeps_flat_colours_and_the_corners() {
        let flat = vec![[10, 200, 30, 255]; 6];
        assert!(composed(&flat, [3, 2], [17, 11]).iter().all(|&one| one == pack([10, 200, 30])));
        let ramp = [[0, 0, 0, 255], [200, 200, 200, 255]];
        let wide = composed(&ramp, [2, 1], [8, 1]);
        assert_eq!((wide[0], wide[7]), (0, pack([200; 3])));
        assert!(wide.is_sorted(), "{wide:x?}");
    }

    #[test]
    fn transparent_colours_do_not_bleed() {
        // White, but fully transparent.
        let edge = [[255, 255, 255, 0], [0, 0, 0, 255]];
        let wide = composed(&edge, [2, 1], [16, 1]);
        let lightest = wide.iter().map(|pixel| pixel >> 16).max().unwrap();
        assert!(lightest <= 0x24, "{lightest:x}");
    }

    #[test]
    fn the_background_runs_from_one_colour_to_the_other() {
        let window = Size { width: 8, height: 720 };
        let mut pixels = vec![0; 8 * 720];
        compose_empty(&DARK, window, &mut pixels);
        let mean = |row: usize| {
            let sum: u32 = pixels[row * 8..][..8].iter().map(|pixel| pixel >> 16).sum();
            f64::from(sum) / 8.0
        };
        assert!((mean(0) - f64::from(DARK.background[0][0])).abs() < 1.0);
        assert!((mean(719) - f64::from(DARK.background[1][0])).abs() < 1.0);
    }
}
