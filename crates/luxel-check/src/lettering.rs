//! Letters as strokes, so that a legend needs no font: a to z, digits and the hyphen.

/// A letter is this wide, with the gap to the next.
pub(crate) const ADVANCE: f64 = 11.0;
/// From the lowest stroke to the highest.
pub(crate) const HEIGHT: f64 = 16.0;
/// The highest stroke above the baseline.
pub(crate) const ASCENT: f64 = 12.0;

/// Places across and upwards from the left end of the baseline; small letters are 8 high.
type Stroke = &'static [(i8, i8)];

const BOWL: Stroke = &[(2, 0), (6, 0), (8, 2), (8, 6), (6, 8), (2, 8), (0, 6), (0, 2), (2, 0)];

/// The strokes of a character; none for what has no letter here.
fn strokes(letter: char) -> &'static [Stroke] {
    match letter {
        'a' => &[BOWL, &[(8, 8), (8, 0)]],
        'b' => &[BOWL, &[(0, 12), (0, 0)]],
        'c' => &[&[(8, 6), (6, 8), (2, 8), (0, 6), (0, 2), (2, 0), (6, 0), (8, 2)]],
        'd' => &[BOWL, &[(8, 12), (8, 0)]],
        'e' => &[&[(0, 4), (8, 4), (8, 6), (6, 8), (2, 8), (0, 6), (0, 2), (2, 0), (6, 0), (8, 1)]],
        'f' => &[&[(8, 12), (6, 12), (4, 10), (4, 0)], &[(1, 8), (7, 8)]],
        'g' => &[BOWL, &[(8, 8), (8, -2), (6, -4), (2, -4), (0, -3)]],
        'h' => &[&[(0, 12), (0, 0)], &[(0, 6), (2, 8), (6, 8), (8, 6), (8, 0)]],
        'i' => &[&[(4, 8), (4, 0)], &[(4, 12), (4, 12)]],
        'j' => &[&[(5, 8), (5, -2), (3, -4), (1, -4)], &[(5, 12), (5, 12)]],
        'k' => &[&[(0, 12), (0, 0)], &[(7, 8), (0, 3)], &[(3, 5), (8, 0)]],
        'l' => &[&[(3, 12), (3, 2), (5, 0), (6, 0)]],
        'm' => &[
            &[(0, 8), (0, 0)],
            &[(0, 6), (2, 8), (4, 6), (4, 0)],
            &[(4, 6), (6, 8), (8, 6), (8, 0)],
        ],
        'n' => &[&[(0, 8), (0, 0)], &[(0, 6), (2, 8), (6, 8), (8, 6), (8, 0)]],
        'o' => &[BOWL],
        'p' => &[BOWL, &[(0, 8), (0, -4)]],
        'q' => &[BOWL, &[(8, 8), (8, -4)]],
        'r' => &[&[(1, 8), (1, 0)], &[(1, 5), (4, 8), (7, 8)]],
        's' => &[&[(8, 7), (6, 8), (2, 8), (0, 6), (2, 4), (6, 4), (8, 2), (6, 0), (2, 0), (0, 1)]],
        't' => &[&[(3, 12), (3, 2), (5, 0), (7, 0)], &[(0, 8), (7, 8)]],
        'u' => &[&[(0, 8), (0, 2), (2, 0), (6, 0), (8, 2)], &[(8, 8), (8, 0)]],
        'v' => &[&[(0, 8), (4, 0), (8, 8)]],
        'w' => &[&[(0, 8), (2, 0), (4, 6), (6, 0), (8, 8)]],
        'x' => &[&[(0, 8), (8, 0)], &[(0, 0), (8, 8)]],
        'y' => &[&[(0, 8), (4, 0)], &[(8, 8), (3, -2), (1, -4), (0, -4)]],
        'z' => &[&[(0, 8), (8, 8), (0, 0), (8, 0)]],
        '-' => &[&[(1, 4), (7, 4)]],
        '0' => &[&[(2, 0), (6, 0), (8, 2), (8, 10), (6, 12), (2, 12), (0, 10), (0, 2), (2, 0)]],
        '1' => &[&[(1, 10), (4, 12), (4, 0)]],
        '2' => &[&[(0, 10), (2, 12), (6, 12), (8, 10), (8, 8), (0, 0), (8, 0)]],
        '3' => &[&[(0, 12), (8, 12), (4, 7), (6, 7), (8, 5), (8, 2), (6, 0), (2, 0), (0, 2)]],
        '4' => &[&[(6, 0), (6, 12), (0, 4), (8, 4)]],
        '5' => &[&[(8, 12), (1, 12), (0, 7), (6, 7), (8, 5), (8, 2), (6, 0), (2, 0), (0, 1)]],
        '6' => &[&[
            (7, 12),
            (2, 9),
            (0, 6),
            (0, 2),
            (2, 0),
            (6, 0),
            (8, 2),
            (8, 5),
            (6, 7),
            (2, 7),
            (0, 5),
        ]],
        '7' => &[&[(0, 12), (8, 12), (3, 0)]],
        '8' => &[
            &[(2, 7), (6, 7), (8, 9), (8, 10), (6, 12), (2, 12), (0, 10), (0, 9), (2, 7)],
            &[(2, 7), (0, 5), (0, 2), (2, 0), (6, 0), (8, 2), (8, 5), (6, 7)],
        ],
        '9' => &[&[
            (1, 0),
            (6, 3),
            (8, 6),
            (8, 10),
            (6, 12),
            (2, 12),
            (0, 10),
            (0, 7),
            (2, 5),
            (6, 5),
            (8, 7),
        ]],
        _ => &[],
    }
}

/// The lines of a text whose baseline begins at a place, y downwards; `unit` is the letters' unit in
/// pixels.
pub(crate) fn text_lines(text: &str, [left, baseline]: [f64; 2], unit: f64) -> Vec<[[f64; 2]; 2]> {
    let mut lines = Vec::new();
    for (number, letter) in text.chars().enumerate() {
        let left = left + number as f64 * ADVANCE * unit;
        let place =
            |&(x, y): &(i8, i8)| [left + f64::from(x) * unit, baseline - f64::from(y) * unit];
        for stroke in strokes(letter) {
            lines.extend(stroke.windows(2).map(|pair| [place(&pair[0]), place(&pair[1])]));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::finding::Kind;

    #[test]
    fn every_letter_of_a_legend_has_strokes_of_its_own() {
        let mut letters: Vec<char> =
            Kind::ALL.iter().flat_map(|kind| kind.name().chars()).collect();
        letters.extend('0'..='9');
        letters.sort_unstable();
        letters.dedup();
        for (at, &letter) in letters.iter().enumerate() {
            let own = strokes(letter);
            assert!(!own.is_empty(), "`{letter}` is blank");
            let twin = letters[..at].iter().find(|&&other| strokes(other) == own);
            assert_eq!(twin, None, "looks like `{letter}`");
            for &(x, y) in own.iter().copied().flatten() {
                assert!((0..=8).contains(&x) && (-4..=12).contains(&y), "`{letter}` sticks out");
            }
        }
    }
}
