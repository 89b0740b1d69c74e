//! Numbers, colours and vectors as text.

/// A number with four significant digits, or with fewer where those that follow are 0.
#[must_use]
pub fn number(value: f32) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let size = value.abs();
    let rounded = if (1e-3..1e5).contains(&size) {
        format!("{value:.*}", 4 + leading_zeros(size) - digits_before_point(size).min(4))
    } else {
        format!("{value:.3e}")
    };
    let shortest = value.to_string();
    let trimmed = trimmed(&rounded);
    if shortest.len() <= trimmed.len() { shortest } else { trimmed }
}

/// Without the zeros that end a fraction.
fn trimmed(number: &str) -> String {
    let end = number.find('e').unwrap_or(number.len());
    let (digits, power) = number.split_at(end);
    if !digits.contains('.') {
        return number.to_owned();
    }
    format!("{}{power}", digits.trim_end_matches('0').trim_end_matches('.'))
}

/// Digits before the point.
fn digits_before_point(value: f32) -> usize {
    let (mut digits, mut rest) = (0, value.abs());
    while rest >= 1.0 {
        rest /= 10.0;
        digits += 1;
    }
    digits
}

/// Zeros behind the point of a number below 1.
fn leading_zeros(value: f32) -> usize {
    [0.1, 0.01].into_iter().filter(|power| value < *power).count()
}

/// A colour: one number where its three are equal.
pub(crate) fn color([r, g, b]: [f32; 3]) -> String {
    if r == g && g == b {
        number(r)
    } else {
        format!("({}, {}, {})", number(r), number(g), number(b))
    }
}

/// A coordinate of a unit vector with three decimals; 0 has no sign.
pub(crate) fn coordinate(value: f32) -> String {
    let text = format!("{value:.3}");
    if text == "-0.000" { "0.000".to_owned() } else { text }
}

/// A unit vector.
pub(crate) fn vector(vector: [f32; 3]) -> String {
    let [x, y, z] = vector.map(coordinate);
    format!("({x}, {y}, {z})")
}

/// A number of about 1 for a column: four decimals, or a power of ten.
pub(crate) fn in_column(value: f32) -> String {
    if value == 0.0 || (1e-4..1e4).contains(&value.abs()) {
        format!("{value:.4}")
    } else {
        format!("{value:.1e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits_or_fewer() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (0.5, "0.5"),
            (1.0 / 3.0, "0.3333"),
            (12.345_67, "12.35"),
            (-1234.56, "-1235"),
            (2.5e-7, "2.5e-7"),
            (0.180_001, "0.18"),
            (44.700_01, "44.7"),
            (99.999_9, "100"),
            (3.0e-9, "3e-9"),
            (0.012_345_6, "0.01235"),
            (-0.001_234_56, "-0.001235"),
            (1e6, "1e6"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn a_grey_is_one_number_and_no_coordinate_is_minus_0() {
        assert_eq!(color([0.25; 3]), "0.25");
        assert_eq!(color([0.25, 0.0, 1.0]), "(0.25, 0, 1)");
        assert_eq!(vector([-1e-5, 1.0, -0.5]), "(0.000, 1.000, -0.500)");
        assert_eq!(in_column(1e-5), "1.0e-5");
    }
}
