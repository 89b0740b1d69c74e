//! How the window writes numbers: one function for each kind, all with four significant digits.

/// A number, as `luxel explain` writes it: four significant digits or fewer.
pub(crate) fn number(value: f64) -> String {
    luxel::report::number(value as f32)
}

/// A count, with spaces between thousands.
pub(crate) fn count(value: u64) -> String {
    let digits = value.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// A fraction as percent: never 0 for some, nor 100 for less than all.
pub(crate) fn percent(share: f64) -> String {
    let percent = share * 100.0;
    let tenths = (percent * 10.0).round() / 10.0;
    if percent > 0.0 && tenths < 0.1 {
        "under 0.1 %".to_owned()
    } else if percent < 100.0 && tenths > 99.9 {
        "over 99.9 %".to_owned()
    } else {
        format!("{} %", number(tenths))
    }
}

/// An angle in degrees.
pub(crate) fn degrees(angle: f64) -> String {
    format!("{}\u{b0}", number(angle))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_any_size_have_four_digits_and_no_other_minus() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (0.012_346, "0.01235"),
            (-98.7654, "-98.77"),
            (4321.2, "4321"),
            (123_456.7, "1.235e5"),
            (2.5e-7, "2.5e-7"),
            (1.5e9, "1.5e9"),
        ] {
            assert_eq!(number(value), text);
        }
        assert_eq!(degrees(71.834_1), "71.83\u{b0}");
        assert_eq!(
            (count(999), count(1000), count(1_234_567)),
            ("999".into(), "1 000".into(), "1 234 567".into())
        );
    }

    #[test]
    fn fractions_are_rounded_neither_to_none_nor_to_all() {
        for (share, text) in [
            (0.0, "0 %"),
            (1e-6, "under 0.1 %"),
            (0.052, "5.2 %"),
            (0.9994, "99.9 %"),
            (0.9999, "over 99.9 %"),
            (1.0, "100 %"),
        ] {
            assert_eq!(percent(share), text);
        }
    }
}
