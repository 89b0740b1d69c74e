//! Parses an exposure.

use super::finite;
use luxel_lighting::Display;

/// The exposure of a view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exposure {
    /// In stops.
    Ev(f32),
    /// From the scene's own light.
    Auto,
}

/// A number of stops, or `auto`.
///
/// # Errors
/// Other text, and stops beyond [`Display::MAX_EV`] either way.
pub fn exposure(text: &str) -> Result<Exposure, String> {
    if text.trim() == "auto" {
        return Ok(Exposure::Auto);
    }
    let ev = finite(text).map_err(|error| format!("{error}: use a number of stops, or auto"))?;
    let most = f64::from(Display::MAX_EV);
    if (-most..=most).contains(&ev) {
        Ok(Exposure::Ev(ev as f32))
    } else {
        Err(format!("it must be between -{most} and {most} stops"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exposures_are_stops_within_bounds_or_auto() {
        assert_eq!(exposure("auto"), Ok(Exposure::Auto));
        assert_eq!(exposure("-.5"), Ok(Exposure::Ev(-0.5)));
        assert_eq!(exposure("64"), Ok(Exposure::Ev(64.0)));
        for wrong in ["", "Auto", "nan", "inf", "65", "-1e9", "1EV"] {
            assert!(exposure(wrong).is_err(), "{wrong}");
        }
    }
}
