//! Vertex colours, which files encode in sRGB.

/// Decodes sRGB to linear (IEC 61966-2-1): v / 12.92 up to 0.04045, else
/// ((v + 0.055) / 1.055)^2.4. Values outside 0 to 1 are clamped; NaN becomes 0.
pub(crate) fn linear(v: f64) -> f32 {
    let v = if v > 0.0 { v.min(1.0) } else { 0.0 };
    let linear = if v <= 0.04045 { v / 12.92 } else { libm::pow((v + 0.055) / 1.055, 2.4) };
    linear as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_scene::Encoding;

    #[test]
    fn fractions_and_bytes_mean_the_same_colour() {
        for byte in 0..=255 {
            let expected = Encoding::Srgb.linear(byte);
            let computed = linear(f64::from(byte) / 255.0);
            assert!((computed - expected).abs() <= expected * f32::EPSILON, "{byte}");
        }
        assert_eq!(linear(f64::NAN), 0.0);
        assert_eq!(linear(7.0), 1.0);
    }
}
