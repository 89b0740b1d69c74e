//! Suggestions for misspelt names.

/// The known name nearest to a misspelt one, if it is near enough to be a typo: at most a third of
/// its letters differ.
#[must_use]
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let name: Vec<char> = name.chars().take(LONGEST + 1).collect();
    let most = (name.len() / 3).max(1);
    let distance_to = |other: &&str| distance(&name, &other.chars().collect::<Vec<_>>());
    let near = |other: &&str| name.len() <= LONGEST && other.chars().count() <= LONGEST;
    // The first of equally near names.
    let nearest = known.into_iter().filter(near).min_by_key(distance_to)?;
    (distance_to(&nearest) <= most).then_some(nearest)
}

/// Longer names get no suggestion.
const LONGEST: usize = 64;

/// The number of letters to change, delete, insert or swap with their neighbour (the
/// optimal string alignment distance).
fn distance(from: &[char], to: &[char]) -> usize {
    let mut before_last = vec![0; to.len() + 1];
    let mut last: Vec<usize> = (0..=to.len()).collect();
    for (i, a) in from.iter().enumerate() {
        let mut row = vec![i + 1; to.len() + 1];
        for (j, b) in to.iter().enumerate() {
            let changed = last[j] + usize::from(a != b);
            row[j + 1] = changed.min(last[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && *a == to[j - 1] && from[i - 1] == *b {
                row[j + 1] = row[j + 1].min(before_last[j - 1] + 1);
            }
        }
        before_last = std::mem::replace(&mut last, row);
    }
    last[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn typos_get_a_suggestion_and_other_words_do_not() {
        let known = ["shininess", "color", "ks", "kd"];
        assert_eq!(nearest("shinines", known), Some("shininess"));
        assert_eq!(nearest("colour", known), Some("color"));
        assert_eq!(nearest("colro", known), Some("color"));
        assert_eq!(nearest("sk", known), Some("ks"));
        assert_eq!(nearest("texture", known), None);
        assert_eq!(nearest("", known), None);
        assert_eq!(nearest(&"x".repeat(1000), known), None);
    }

    #[test]
    fn swapping_two_neighbours_counts_once() {
        let letters = |text: &str| text.chars().collect::<Vec<_>>();
        for (from, to, expected) in
            [("", "", 0), ("abc", "abc", 0), ("abc", "acb", 1), ("abc", "bd", 2), ("", "ab", 2)]
        {
            assert_eq!(distance(&letters(from), &letters(to)), expected, "{from} {to}");
        }
    }
}
