//! Areas as text: paths with two decimals, relative commands, and no byte that says nothing.

use super::web::Place;
use std::fmt::Write;

/// Units of the paths' numbers in a pixel.
const UNITS: f64 = 100.0;
/// Corners that lie nearer than this to the line between their neighbours are left out, in units.
const STRAIGHT: f64 = 1.0;

/// The data of a path around outlines; empty if none of them has an area at two decimals.
pub(super) fn data(outlines: &[Vec<Place>], closed: bool) -> String {
    let mut data = String::new();
    // Where the last outline began: `z` goes back there.
    let mut at: Option<[i64; 2]> = None;
    for outline in outlines {
        let corners = corners(outline, closed);
        let Some((&first, rest)) =
            corners.split_first().filter(|(_, rest)| rest.len() > usize::from(closed))
        else {
            continue;
        };
        match at {
            // The first `m` counts from the window's corner, and what follows it from there.
            None => pair(&mut data, 'm', first),
            Some([x, y]) => pair(&mut data, 'm', [first[0] - x, first[1] - y]),
        }
        let mut last = 'm';
        let mut here = first;
        for &[x, y] in rest {
            let (dx, dy) = (x - here[0], y - here[1]);
            here = [x, y];
            let command = match (dx, dy) {
                (_, 0) => 'h',
                (0, _) => 'v',
                _ => 'l',
            };
            // After `m`, pairs are lines; the same command isn't said twice.
            let said = command == last || (command == 'l' && last == 'm');
            let numbers: &[i64] = match command {
                'h' => &[dx],
                'v' => &[dy],
                _ => &[dx, dy],
            };
            if said {
                for &value in numbers {
                    separated(&mut data, value);
                }
            } else {
                data.push(command);
                number(&mut data, numbers[0]);
                if let Some(&second) = numbers.get(1) {
                    separated(&mut data, second);
                }
            }
            last = command;
        }
        at = Some(if closed { first } else { here });
        if closed {
            data.push('z');
        }
    }
    data
}

/// The corners of an outline in units, without those that say nothing.
fn corners(outline: &[Place], closed: bool) -> Vec<[i64; 2]> {
    let mut corners: Vec<[i64; 2]> = Vec::with_capacity(outline.len());
    for place in outline {
        let corner = place.map(|side| (side * UNITS).round() as i64);
        if corners.last() != Some(&corner) {
            corners.push(corner);
        }
    }
    while closed && corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    // What is left out since the last corner that was kept must lie near the new line too.
    let mut kept: Vec<[i64; 2]> = Vec::with_capacity(corners.len());
    let mut since: Vec<[i64; 2]> = Vec::new();
    for (at, &corner) in corners.iter().enumerate() {
        let next = corners[(at + 1) % corners.len()];
        since.push(corner);
        let Some(&from) = kept.last() else {
            kept.push(corner);
            since.clear();
            continue;
        };
        let may_go = (closed || at + 1 < corners.len())
            && since.len() < 32
            && since.iter().all(|&other| is_between(from, other, next));
        if !may_go {
            kept.push(corner);
            since.clear();
        }
    }
    kept
}

/// Whether a corner lies on the way between two others, nearly.
fn is_between(from: [i64; 2], corner: [i64; 2], to: [i64; 2]) -> bool {
    let [ux, uy, vx, vy] =
        [to[0] - from[0], to[1] - from[1], corner[0] - from[0], corner[1] - from[1]]
            .map(|side| side as f64);
    let squared = ux * ux + uy * uy;
    let (along, aside) = (ux * vx + uy * vy, ux * vy - uy * vx);
    (0.0..=squared).contains(&along) && aside * aside <= STRAIGHT * STRAIGHT * 0.25 * squared
}

fn pair(data: &mut String, command: char, [x, y]: [i64; 2]) {
    data.push(command);
    number(data, x);
    separated(data, y);
}

/// A number after another: a minus parts them, or the point of a fraction after a fraction.
fn separated(data: &mut String, value: i64) {
    let last_has_point = data
        .rsplit(|c: char| !c.is_ascii_digit() && c != '.')
        .next()
        .is_some_and(|last| last.contains('.'));
    let begins_with_point = (0..100).contains(&value) && value != 0;
    if value >= 0 && !(begins_with_point && last_has_point) {
        data.push(' ');
    }
    number(data, value);
}

/// Hundredths as short as can be: 1.5, .25, -3, 0.
pub(super) fn number(data: &mut String, value: i64) {
    if value < 0 {
        data.push('-');
    }
    let (whole, part) = (value.unsigned_abs() / 100, value.unsigned_abs() % 100);
    if whole > 0 || part == 0 {
        let _ = write!(data, "{whole}");
    }
    if part % 10 != 0 {
        let _ = write!(data, ".{part:02}");
    } else if part > 0 {
        let _ = write!(data, ".{}", part / 10);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let text = |value| {
            let mut text = String::new();
            number(&mut text, value);
            text
        };
        let values = [0, 5, 50, -25, 100, 150, -1234].map(text);
        assert_eq!(values, ["0", ".05", ".5", "-.25", "1", "1.5", "-12.34"]);
    }

    #[test]
    fn a_path_is_relative_and_says_no_command_twice() {
        let square = vec![[1.0, 1.0], [1.5, 1.25], [2.0, 2.25], [2.0, 3.0], [1.0, 3.0]];
        let inner = vec![[1.25, 2.0], [1.5, 2.5], [1.25, 2.5]];
        assert_eq!(data(&[square, inner], true), "m1 1 .5.25.5 1v.75h-1zm.25 1 .25.5h-.25z");
    }

    #[test]
    fn corners_on_a_straight_way_are_left_out() {
        let places = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0]];
        assert_eq!(data(&[places], true), "m0 0h2v2z");
        assert_eq!(data(&[vec![[0.0, 0.0], [1.0, 0.001], [2.0, 0.0]]], true), "");
    }
}
