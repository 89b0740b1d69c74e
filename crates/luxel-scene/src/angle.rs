//! Angles as weights: quick, and the same everywhere.

/// a . b
#[inline]
pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a x b
#[inline]
pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The angle between two vectors, to 4e-8: tan(t/2) = |a x b| / (|a| |b| + a.b); 0 if they point
/// the same or opposite ways, or if one is 0.
#[inline]
pub(crate) fn angle_between(a: [f64; 3], b: [f64; 3]) -> f64 {
    let normal = cross(a, b);
    let sine = dot(normal, normal).sqrt();
    let cosine = dot(a, b);
    let lengths = (dot(a, a) * dot(b, b)).sqrt();
    if sine > 0.0 { 2.0 * arc_tangent_of_ratio(sine, (lengths + cosine).max(0.0)) } else { 0.0 }
}

/// atan(y / x) for y > 0, x >= 0, to 2e-8 (Abramowitz and Stegun 1964, 4.4.49): weights need no
/// more, and it is several times as fast as an exact one.
#[inline]
pub(crate) fn arc_tangent_of_ratio(y: f64, x: f64) -> f64 {
    const SERIES: [f64; 9] = [
        0.002_866_225_7,
        -0.016_165_736_7,
        0.042_909_613_8,
        -0.075_289_640_0,
        0.106_562_639_3,
        -0.142_088_994_4,
        0.199_935_508_5,
        -0.333_331_452_8,
        1.0,
    ];
    let (small, large) = if y <= x { (y, x) } else { (x, y) };
    let ratio = small / large;
    let squared = ratio * ratio;
    let angle = ratio * SERIES.iter().fold(0.0, |sum, factor| sum * squared + factor);
    if y <= x { angle } else { std::f64::consts::FRAC_PI_2 - angle }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arc_tangents_are_within_the_documented_error() {
        for step in 0..=10_000 {
            let angle = f64::from(step + 1) / 10_001.0 * std::f64::consts::FRAC_PI_2;
            let found = arc_tangent_of_ratio(libm::sin(angle), libm::cos(angle).max(0.0));
            assert!((found - angle).abs() < 2e-8, "{angle}: {found}");
            let turned = [3.0 * libm::cos(2.0 * angle), 0.0, 3.0 * libm::sin(2.0 * angle)];
            let found = angle_between([0.5, 0.0, 0.0], turned);
            // Next to a half turn the sine is all that is left of the angle.
            assert!((found - 2.0 * angle).abs() < 5e-8, "{angle}: {found}");
        }
    }
}
