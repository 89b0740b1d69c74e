//! Encodings of pictures for terminals: kitty's and iTerm2's protocols, sixels, and half blocks, which
//! every terminal with colours shows.

use crate::picture::rgba_of;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use luxel::lighting::PictureEncoding;
use luxel::render::{PictureFormat, write_rgba8};
use luxel::scene::Size;
use std::fmt::Write;

/// A way to show pictures in a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Graphics {
    /// kitty's protocol, also of Ghostty and others.
    Kitty,
    /// Inline pictures of iTerm2, WezTerm and mintty.
    Iterm2,
    /// Sixels, as in DEC's VT340 of 1987.
    Sixel,
    /// Upper half blocks in two colours: two pixels a cell.
    Blocks,
}

/// How pictures are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GraphicsChoice {
    /// The best way that the terminal supports, by environment variables or its answer to a query.
    #[default]
    Auto,
    /// This way.
    Only(Graphics),
}

impl GraphicsChoice {
    /// Resolves the choice. `variable` reads the environment, `query` asks the terminal.
    pub(super) fn graphics(
        self,
        variable: impl Fn(&str) -> Option<String>,
        query: impl FnOnce() -> Option<Graphics>,
    ) -> Graphics {
        if let Self::Only(graphics) = self {
            return graphics;
        }
        let is = |name: &str, parts: &[&str]| {
            let value = variable(name).unwrap_or_default().to_lowercase();
            parts.iter().any(|part| value.contains(part))
        };
        // tmux and screen don't pass pictures through.
        if is("TERM", &["tmux", "screen"]) || variable("TMUX").is_some() {
            Graphics::Blocks
        } else if variable("KITTY_WINDOW_ID").is_some()
            || is("TERM", &["kitty", "ghostty"])
            || is("TERM_PROGRAM", &["ghostty"])
        {
            Graphics::Kitty
        } else if is("TERM_PROGRAM", &["iterm", "wezterm", "mintty"])
            || is("LC_TERMINAL", &["iterm"])
        {
            Graphics::Iterm2
        } else if is("TERM", &["sixel", "foot", "mlterm", "contour"])
            || variable("KONSOLE_VERSION").is_some()
        {
            Graphics::Sixel
        } else {
            query().unwrap_or(Graphics::Blocks)
        }
    }
}

/// The largest chunk of kitty's protocol, in bytes.
const CHUNK: usize = 4096;

impl Graphics {
    /// Encodes a 0RGB picture, shown from the cursor over so many columns and rows.
    pub(super) fn encode(self, pixels: &[u32], size: Size, cells: [u32; 2]) -> String {
        match self {
            Self::Kitty => kitty(&png(pixels, size), cells),
            Self::Iterm2 => iterm2(&png(pixels, size), cells),
            Self::Sixel => sixel(pixels, size),
            Self::Blocks => blocks(pixels, size),
        }
    }

    /// The sequence that deletes the picture.
    pub(super) fn cleanup(self) -> &'static str {
        if self == Self::Kitty { "\x1b_Ga=d,d=A,q=2\x1b\\" } else { "" }
    }
}

fn png(pixels: &[u32], size: Size) -> String {
    let mut bytes = Vec::new();
    let rgba = rgba_of(pixels);
    // Writing to memory fails only for a wrong size.
    let written = write_rgba8(PictureFormat::Png, size, &rgba, PictureEncoding::Srgb, &mut bytes);
    if written.is_err() {
        bytes.clear();
    }
    STANDARD.encode(bytes)
}

/// Replaces the last picture without moving the cursor.
fn kitty(data: &str, [columns, rows]: [u32; 2]) -> String {
    let mut text = String::with_capacity(data.len() + data.len() / CHUNK * 16 + 64);
    let mut rest = data;
    let mut is_first = true;
    while is_first || !rest.is_empty() {
        let (piece, more) = rest.split_at(rest.len().min(CHUNK));
        let last = u8::from(!more.is_empty());
        let head = if is_first {
            format!("a=T,f=100,i=1,p=1,q=2,C=1,c={columns},r={rows},m={last}")
        } else {
            format!("m={last}")
        };
        // Writing to a string can't fail.
        let _ = write!(text, "\x1b_G{head};{piece}\x1b\\");
        (rest, is_first) = (more, false);
    }
    text
}

fn iterm2(data: &str, [columns, rows]: [u32; 2]) -> String {
    format!(
        "\x1b]1337;File=inline=1;width={columns};height={rows};preserveAspectRatio=0;\
         doNotMoveCursor=1:{data}\x07"
    )
}

/// Levels of each channel of the sixels' palette.
const LEVELS: u32 = 6;
/// An ordered dither, in 16ths of a level (Bayer 1973).
const DITHER: [[u32; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// The palette index of a pixel, dithered.
fn palette_index(pixel: u32, x: usize, y: usize) -> u8 {
    let [_, channels @ ..] = pixel.to_be_bytes();
    let threshold = DITHER[y % 4][x % 4];
    let level = |channel: u8| (u32::from(channel) * (LEVELS - 1) * 16 / 255 + threshold) / 16;
    let [r, g, b] = channels.map(|channel| level(channel).min(LEVELS - 1));
    ((r * LEVELS + g) * LEVELS + b) as u8
}

/// Encodes bands of six rows: for each colour, runs of characters whose bits are the rows.
fn sixel(pixels: &[u32], size: Size) -> String {
    let (width, height) = (size.width as usize, size.height as usize);
    let mut text = format!("\x1bP0;1q\"1;1;{width};{height}");
    for number in 0..LEVELS * LEVELS * LEVELS {
        let part = |level: u32| level % LEVELS * 100 / (LEVELS - 1);
        let [r, g, b] = [number / (LEVELS * LEVELS), number / LEVELS, number].map(part);
        let _ = write!(text, "#{number};2;{r};{g};{b}");
    }
    let mut band = vec![0_u8; width * 6];
    for top in (0..height).step_by(6) {
        let rows = (height - top).min(6);
        let mut used = [false; 256];
        for row in 0..rows {
            for x in 0..width {
                let color = palette_index(pixels[(top + row) * width + x], x, top + row);
                band[row * width + x] = color;
                used[color as usize] = true;
            }
        }
        for color in (0..=255_u8).filter(|color| used[*color as usize]) {
            let _ = write!(text, "#{color}");
            let bits = |x: usize| {
                (0..rows)
                    .fold(0, |bits, row| bits | u8::from(band[row * width + x] == color) << row)
            };
            let mut x = 0;
            while x < width {
                let bits_here = bits(x);
                let run = (x..width).take_while(|at| bits(*at) == bits_here).count();
                let letter = char::from(63 + bits_here);
                if run > 3 {
                    let _ = write!(text, "!{run}{letter}");
                } else {
                    text.extend(std::iter::repeat_n(letter, run));
                }
                x += run;
            }
            text.push('$');
        }
        text.push('-');
    }
    text.push_str("\x1b\\");
    text
}

/// Encodes two pixels a cell: the upper one as foreground colour, the lower one as background.
fn blocks(pixels: &[u32], size: Size) -> String {
    let (width, height) = (size.width as usize, size.height as usize);
    let mut text = String::new();
    for row in 0..height.div_ceil(2) {
        // Each line is positioned, so that the terminal's wrapping doesn't matter.
        let _ = write!(text, "\x1b[{};1H", row + 1);
        let mut last = None;
        for x in 0..width {
            let upper = pixels[2 * row * width + x];
            let lower = pixels.get((2 * row + 1) * width + x).copied().unwrap_or(upper);
            if last != Some((upper, lower)) {
                let [_, r, g, b] = upper.to_be_bytes();
                let _ = write!(text, "\x1b[38;2;{r};{g};{b}");
                let [_, r, g, b] = lower.to_be_bytes();
                let _ = write!(text, ";48;2;{r};{g};{b}m");
                last = Some((upper, lower));
            }
            text.push('\u{2580}');
        }
    }
    text.push_str("\x1b[0m");
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Size = Size { width: 8, height: 13 };

    fn pixels() -> Vec<u32> {
        (0..8 * 13)
            .map(|at| if (at / 8 + at) % 5 == 0 { 0x00ff_0000 } else { 0x0000_33ff })
            .collect()
    }

    /// Decodes sixels: the palette index of each pixel.
    fn decode(text: &str, size: Size) -> Vec<Option<u8>> {
        let width = size.width as usize;
        let mut pixels = vec![None; width * size.height as usize];
        let body = text.strip_suffix("\x1b\\").unwrap();
        let bytes = &body.as_bytes()[body.find('"').unwrap()..];
        let number = |at: &mut usize| {
            let digits = bytes[*at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
            let text = std::str::from_utf8(&bytes[*at..*at + digits]).unwrap();
            *at += digits;
            text.parse::<usize>().unwrap()
        };
        let (mut at, mut x, mut top, mut color) = (0, 0, 0, 0);
        while at < bytes.len() {
            let byte = bytes[at];
            at += 1;
            let mut run = 1;
            let letter = match byte {
                b'"' | b'#' => {
                    let first = number(&mut at);
                    if byte == b'#' {
                        color = first as u8;
                    }
                    while bytes.get(at) == Some(&b';') {
                        at += 1;
                        number(&mut at);
                    }
                    continue;
                }
                b'$' => {
                    x = 0;
                    continue;
                }
                b'-' => {
                    (x, top) = (0, top + 6);
                    continue;
                }
                b'!' => {
                    run = number(&mut at);
                    at += 1;
                    bytes[at - 1]
                }
                letter => letter,
            };
            for _ in 0..run {
                for row in (0..6).filter(|row| (letter - 63) >> row & 1 == 1) {
                    pixels[(top + row) * width + x] = Some(color);
                }
                x += 1;
            }
        }
        pixels
    }

    #[test]
    fn sixels_decode_to_every_pixel_s_colour() {
        let pixels = pixels();
        let found = decode(&sixel(&pixels, SIZE), SIZE);
        for (at, pixel) in pixels.iter().enumerate() {
            assert_eq!(found[at], Some(palette_index(*pixel, at % 8, at / 8)), "{at}");
        }
        // Palette colours aren't dithered.
        assert_eq!(palette_index(0x00ff_0000, 0, 0), palette_index(0x00ff_0000, 1, 1));
    }

    #[test]
    fn kitty_s_chunks_are_the_png_s_bytes_in_order() {
        let noise: Vec<u32> = (0..128 * 96_u32).map(|n| n.wrapping_mul(0x9e37_79b1) >> 8).collect();
        let size = Size { width: 128, height: 96 };
        let data = png(&noise, size);
        assert!(data.len() > 2 * CHUNK);
        let text = kitty(&data, [10, 5]);
        let pieces: Vec<_> = text.split("\x1b\\").filter(|piece| !piece.is_empty()).collect();
        let joined: String = pieces.iter().map(|piece| piece.split_once(';').unwrap().1).collect();
        assert_eq!(joined, data);
        assert!(pieces.iter().all(|piece| piece.len() < CHUNK + 100));
        let more = |piece: &str| piece.split_once(';').unwrap().0.ends_with("m=1");
        let (last, others) = pieces.split_last().unwrap();
        assert!(others.iter().all(|piece| more(piece)) && !more(last));
    }

    #[test]
    fn half_blocks_have_two_pixels_each_and_an_odd_last_row() {
        let text = blocks(&pixels(), SIZE);
        assert_eq!(text.matches('\u{2580}').count(), 8 * 7);
        assert!(text.contains("\x1b[38;2;255;0;0;48;2;0;51;255m"), "{text:?}");
        let plain = blocks(&[0x0001_0203; 104], SIZE);
        assert_eq!(plain.matches("38;2;1;2;3;48;2;1;2;3m").count(), 7, "once a line");
    }

    #[test]
    fn a_terminal_is_identified_by_its_environment() {
        let of = |variables: &[(&str, &str)]| {
            let find = |name: &str| {
                variables.iter().find(|(one, _)| *one == name).map(|(_, value)| (*value).to_owned())
            };
            GraphicsChoice::Auto.graphics(find, || None)
        };
        assert_eq!(of(&[("TERM", "xterm-kitty")]), Graphics::Kitty);
        assert_eq!(
            of(&[("TERM", "xterm-256color"), ("TERM_PROGRAM", "iTerm.app")]),
            Graphics::Iterm2
        );
        assert_eq!(of(&[("TERM", "foot")]), Graphics::Sixel);
        assert_eq!(of(&[("TERM", "xterm-256color")]), Graphics::Blocks);
        assert_eq!(of(&[("TERM", "tmux-256color"), ("KITTY_WINDOW_ID", "1")]), Graphics::Blocks);
        assert_eq!(of(&[]), Graphics::Blocks);
        let only = GraphicsChoice::Only(Graphics::Sixel);
        assert_eq!(only.graphics(|_| None, || Some(Graphics::Kitty)), Graphics::Sixel);
        // Known terminals and multiplexers aren't queried.
        let sixel = || Some(Graphics::Sixel);
        let named = |value: &'static str| {
            GraphicsChoice::Auto.graphics(|name| (name == "TERM").then(|| value.to_owned()), sixel)
        };
        assert_eq!(named("xterm-kitty"), Graphics::Kitty);
        assert_eq!(named("xterm-256color"), Graphics::Sixel);
        assert_eq!(named("tmux-256color"), Graphics::Blocks);
    }
}
