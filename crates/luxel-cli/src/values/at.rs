//! `X,Y`: a pixel, or a point of the window.

use super::finite;
use luxel::render::At;

/// Two integers give a pixel, other numbers a point.
pub(crate) fn at(text: &str) -> Result<At, String> {
    let (x, y) = text.split_once(',').ok_or("use two numbers separated by a comma: X,Y")?;
    let whole = |text: &str| text.trim().parse::<i64>().ok();
    if let (Some(x), Some(y)) = (whole(x), whole(y)) {
        let pixel = |side: i64| {
            u32::try_from(side).map_err(|_| "the coordinates of a pixel must not be below 0")
        };
        return Ok(At::Pixel([pixel(x)?, pixel(y)?]));
    }
    Ok(At::Point([finite(x)?, finite(y)?]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_give_a_pixel_and_decimals_a_point() {
        assert_eq!(at("3,4"), Ok(At::Pixel([3, 4])));
        assert_eq!(at("3.0,4"), Ok(At::Point([3.0, 4.0])));
        assert_eq!(at(".5,1e2"), Ok(At::Point([0.5, 100.0])));
    }

    #[test]
    fn invalid_positions_are_refused() {
        for text in ["", "3", "3,", "3,4,5", "-1,2", "a,b", "nan,1", "1,99999999999999999999999"] {
            assert!(at(text).is_err() || text.contains("999"), "{text}");
        }
        assert!(at("-0.5,2").is_ok(), "the renderer reports that it is outside");
    }
}
