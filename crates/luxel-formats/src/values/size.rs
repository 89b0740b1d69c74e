//! `WxH`: the size of an image.

use luxel_scene::Size;

/// The longest side of an image, in pixels.
const MAX_SIDE: u32 = 16_384;

/// Parses width and height.
///
/// # Errors
/// Anything but two whole numbers from 1 to 16384 with an `x` between them.
pub fn size(text: &str) -> Result<Size, String> {
    let (width, height) = text
        .split_once(['x', 'X'])
        .ok_or_else(|| "use WIDTHxHEIGHT in pixels, such as 1280x720".to_owned())?;
    Ok(Size { width: side(width)?, height: side(height)? })
}

fn side(text: &str) -> Result<u32, String> {
    let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    match text.parse() {
        Ok(side @ 1..=MAX_SIDE) if digits => Ok(side),
        _ if digits => Err(format!("a side has 1 to {MAX_SIDE} pixels, not {text}")),
        _ => Err(format!("`{text}` is not a whole number of pixels")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_up_to_the_limit_are_accepted() {
        assert_eq!(size("640x480"), Ok(Size { width: 640, height: 480 }));
        assert_eq!(size("1x1"), Ok(Size { width: 1, height: 1 }));
        assert_eq!(size("16384x16384"), Ok(Size { width: 16_384, height: 16_384 }));
    }

    #[test]
    fn invalid_and_excessive_sizes_are_refused() {
        for text in [
            "",
            "640",
            "x",
            "640x",
            "x480",
            "0x480",
            "640x0",
            "-1x5",
            "+1x5",
            "1.5x2",
            "16385x1",
            "100000x100000",
            "99999999999999999999x1",
            "640x480x3",
            "640*480",
            " 640x480",
        ] {
            assert!(size(text).is_err(), "{text}");
        }
    }
}
