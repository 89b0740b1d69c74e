//! `RADIUS` of ambient occlusion, and numbers of rays.

use super::number::positive;

/// The radius of ambient occlusion, possibly infinite; `None` for the default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OcclusionRadius(pub Option<f64>);

/// Parses the radius of ambient occlusion.
///
/// # Errors
/// Anything but a number above 0, `infinity` and `auto`.
pub fn occlusion_radius(text: &str) -> Result<OcclusionRadius, String> {
    match text {
        "auto" => Ok(OcclusionRadius(None)),
        "infinity" | "inf" => Ok(OcclusionRadius(Some(f64::INFINITY))),
        _ => positive(text)
            .map(|radius| OcclusionRadius(Some(radius)))
            .map_err(|_| "use a radius above 0, infinity or auto".to_owned()),
    }
}

/// Parses a number of rays.
///
/// # Errors
/// Anything but a whole number from 1 to 4096.
pub fn rays(text: &str) -> Result<u32, String> {
    match text.parse() {
        Ok(count @ 1..=4096) => Ok(count),
        _ => Err("use a whole number from 1 to 4096".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_radius_is_above_0_and_rays_are_counted() {
        assert_eq!(occlusion_radius("0.5"), Ok(OcclusionRadius(Some(0.5))));
        assert_eq!(occlusion_radius("auto"), Ok(OcclusionRadius(None)));
        assert_eq!(occlusion_radius("infinity"), Ok(OcclusionRadius(Some(f64::INFINITY))));
        for text in ["", "0", "-1", "nan", "x"] {
            assert!(occlusion_radius(text).is_err(), "{text}");
        }
        assert_eq!((rays("1"), rays("4096")), (Ok(1), Ok(4096)));
        for text in ["", "0", "-1", "4097", "1.5"] {
            assert!(rays(text).is_err(), "{text}");
        }
    }
}
