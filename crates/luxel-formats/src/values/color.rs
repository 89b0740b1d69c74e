//! Colours: linear numbers, CSS names, and hexadecimal digits.

use super::number::single;
use super::vector::numbers;
use luxel_scene::{Background, Encoding};

/// The ways to write a colour, for messages.
const USAGE: &str = "use R,G,B, a CSS name such as tomato, or #rrggbb";

/// Linear red, green and blue of any intensity: `R,G,B`, or a colour of CSS, which is sRGB.
///
/// # Errors
/// Anything but three numbers in the range of single precision, a CSS name, `#rgb` or `#rrggbb`.
pub fn color(text: &str) -> Result<[f32; 3], String> {
    if !is_css(text) {
        let [r, g, b] = numbers(text).map_err(|message| format!("{message}: {USAGE}"))?;
        return Ok([single(r)?, single(g)?, single(b)?]);
    }
    match css(text)? {
        [r, g, b, 255] => Ok(linear([r, g, b])),
        _ => Err(format!("`{text}` has an alpha, which only a background has")),
    }
}

/// Linear red, green and blue of a surface: none below 0.
///
/// # Errors
/// Anything but a colour without negative components.
pub fn reflectance(text: &str) -> Result<[f32; 3], String> {
    let color = color(text)?;
    if color.iter().all(|&component| component >= 0.0) {
        Ok(color)
    } else {
        Err("a surface's colour must not be below 0".to_owned())
    }
}

/// `studio`; linear red, green and blue, with optional alpha from 0 to 1 (default 1); or a colour of CSS,
/// whose alpha is linear, too.
///
/// # Errors
/// Anything but `studio`, or a colour with or without alpha.
pub fn background(text: &str) -> Result<Background, String> {
    if text == Background::STUDIO {
        Ok(Background::Studio)
    } else {
        color_with_alpha(text).map(Background::Flat)
    }
}

fn color_with_alpha(text: &str) -> Result<[f32; 4], String> {
    if is_css(text) {
        let [r, g, b, alpha] = css(text)?;
        let [r, g, b] = linear([r, g, b]);
        return Ok([r, g, b, f32::from(alpha) / 255.0]);
    }
    if text.split(',').count() == 3 {
        let [r, g, b] = color(text)?;
        return Ok([r, g, b, 1.0]);
    }
    let [r, g, b, alpha] = numbers(text).map_err(|message| format!("{message} (or 3): {USAGE}"))?;
    if (0.0..=1.0).contains(&alpha) {
        Ok([single(r)?, single(g)?, single(b)?, single(alpha)?])
    } else {
        Err("alpha must be between 0 and 1".to_owned())
    }
}

/// Whether a text is meant as a name or as hexadecimal digits.
fn is_css(text: &str) -> bool {
    let is_name = text.len() > 1 && text.bytes().all(|byte| byte.is_ascii_alphabetic());
    // What reads as a number that is not finite.
    let is_number = text.parse::<f64>().is_ok();
    text.starts_with('#') || is_name && !is_number
}

/// The bytes of a CSS colour, encoded in sRGB, and its alpha.
fn css(text: &str) -> Result<[u8; 4], String> {
    let unknown = |_| format!("`{text}` is not a colour: {USAGE}");
    let color = ::color::parse_color(&text.to_ascii_lowercase()).map_err(unknown)?;
    // Names and digits are bytes.
    Ok(color.components.map(|component| (component * 255.0).round() as u8))
}

fn linear(bytes: [u8; 3]) -> [f32; 3] {
    bytes.map(|byte| Encoding::Srgb.linear(byte))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_alpha_of_a_background_is_1_by_default() {
        assert_eq!(background("1,0,0"), Ok(Background::Flat([1.0, 0.0, 0.0, 1.0])));
        assert_eq!(background("1,0,0,.25"), Ok(Background::Flat([1.0, 0.0, 0.0, 0.25])));
        assert!(background("1,0,0,2").is_err() && background("1,0").is_err());
    }

    #[test]
    fn reflectance_is_not_negative() {
        assert_eq!(reflectance("2,0,0"), Ok([2.0, 0.0, 0.0]));
        assert!(reflectance("-0.1,0,0").is_err());
        assert!(color("1e39,0,0").is_err(), "single precision would make it infinite");
    }

    #[test]
    fn names_and_digits_are_srgb_as_in_css() {
        // CSS Color Module Level 4, section 6.1: tomato is 255, 99, 71.
        let tomato = linear([255, 99, 71]);
        for text in ["tomato", "Tomato", "#ff6347", "#FF6347"] {
            assert_eq!(color(text), Ok(tomato), "{text}");
            assert_eq!(reflectance(text), Ok(tomato), "{text}");
        }
        assert!((tomato[1] - 0.124_772).abs() < 1e-6, "IEC 61966-2-1");
        assert_eq!(color("#fff"), Ok([1.0; 3]));
        assert_eq!(color("rebeccapurple"), color("#663399"));
    }

    #[test]
    fn a_background_may_be_transparent() {
        assert_eq!(background("transparent"), Ok(Background::Flat([0.0; 4])));
        assert_eq!(background("#fff"), Ok(Background::Flat([1.0; 4])));
        assert_eq!(
            background("#0f08"),
            Ok(Background::Flat([0.0, 1.0, 0.0, f32::from(0x88_u8) / 255.0]))
        );
        assert_eq!(background("#00ff0080"), Ok(Background::Flat([0.0, 1.0, 0.0, 128.0 / 255.0])));
        for text in ["transparent", "#0f08", "#00ff0080"] {
            assert!(color(text).unwrap_err().contains("alpha"), "{text}");
        }
    }

    #[test]
    fn other_words_and_digits_are_refused() {
        for text in ["", "tomatoe", "fff", "#", "#ff", "#ggg", "#fffff", "inf", "nan", "rgb(1,2,3)"]
        {
            let error = color(text).unwrap_err();
            assert!(error.contains("tomato"), "{text}: {error}");
            assert!(background(text).is_err(), "{text}");
        }
    }
}
