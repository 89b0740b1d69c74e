//! `X,Y`: a pixel, or a point of the window.

use super::finite;
use luxel::render::At;

/// A pixel by two whole numbers; by any others, a point.
pub(crate) fn at(text: &str) -> Result<At, String> {
    let (x, y) = text.split_once(',').ok_or("use two numbers with a comma between them: X,Y")?;
    let whole = |text: &str| text.trim().parse::<i64>().ok();
    if let (Some(x), Some(y)) = (whole(x), whole(y)) {
        let pixel = |side: i64| u32::try_from(side).map_err(|_| "a pixel lies at 0 or beyond");
        return Ok(At::Pixel([pixel(x)?, pixel(y)?]));
    }
    Ok(At::Point([finite(x)?, finite(y)?]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_are_a_pixel_and_others_a_point() {
        assert_eq!(at("3,4"), Ok(At::Pixel([3, 4])));
        assert_eq!(at("3.0,4"), Ok(At::Point([3.0, 4.0])));
        assert_eq!(at(".5,1e2"), Ok(At::Point([0.5, 100.0])));
    }

    #[test]
    fn what_is_no_place_in_a_window_is_refused() {
        for text in ["", "3", "3,", "3,4,5", "-1,2", "a,b", "nan,1", "1,99999999999999999999999"] {
            assert!(at(text).is_err() || text.contains("999"), "{text}");
        }
        assert!(at("-0.5,2").is_ok(), "the renderer says that it lies outside");
    }
}
