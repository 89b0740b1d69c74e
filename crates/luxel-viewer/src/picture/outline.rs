//! Outlines of selected and hovered objects.

use crate::selection::Selection;
use crate::theme::Theme;
use luxel::pick::VisibleIds;
use luxel::scene::Size;

/// Marks of a pixel's object, or of the line drawn at the pixel; the higher wins.
const UNMARKED: u8 = 0;
const HALO: u8 = 1;
const HOVERED: u8 = 2;
const SELECTED: u8 = 3;

/// The length of a dash and of a gap of a level line where a selected object is hidden, in points.
const DASH: usize = 5;

/// The objects that pixels show; the pictures may be smaller than the window.
pub(crate) struct OutlinedIds<'a> {
    pub(crate) visible: &'a VisibleIds,
    /// The selected objects alone, if others are in the scene.
    pub(crate) alone: Option<&'a VisibleIds>,
    pub(crate) size: Size,
}

/// Draws outlines of selected and hovered objects over the window's pixels, at `scale` pixels a point.
/// Lines lie inside the objects; selected ones have a dark edge outside, for contrast with any colour.
/// Where a selected object is hidden by others, its line is dashed and faint.
pub(crate) fn draw_outlines(
    ids: &OutlinedIds<'_>,
    selection: &Selection,
    (theme, scale): (&Theme, f32),
    window: Size,
    pixels: &mut [u32],
) {
    if selection.selected().is_empty() && selection.hovered.is_none() {
        return;
    }
    let (across, down) = (window.width as usize, window.height as usize);
    if pixels.len() != across * down {
        return;
    }
    let owners = owners(ids.visible, ids.size, selection, window);
    let mut lines = vec![UNMARKED; owners.len()];
    let point = (scale.round() as usize).max(1);
    for y in 0..down {
        for x in 0..across {
            let at = y * across + x;
            let (object, own) = owners[at];
            if own == UNMARKED {
                continue;
            }
            // The window's edge isn't an edge of the object.
            let mut mark = |step: usize, is_in: bool, other: usize| {
                if !is_in || owners[other].0 == object {
                    return;
                }
                // Two selected neighbours share the line, half each.
                let is_selected = owners[other].1 == SELECTED;
                if own != SELECTED {
                    lines[at] = if is_selected { lines[at] } else { lines[at].max(own) };
                } else if step <= point || !is_selected {
                    lines[at] = own;
                    lines[other] = lines[other].max(HALO);
                }
            };
            for step in 1..=if own == SELECTED { 2 * point } else { point } {
                mark(step, x >= step, at.wrapping_sub(step));
                mark(step, x + step < across, at + step);
                mark(step, y >= step, at.wrapping_sub(step * across));
                mark(step, y + step < down, at + step * across);
            }
        }
    }
    if let Some(alone) = ids.alone {
        let alone = self::owners(alone, ids.size, selection, window);
        draw_hidden((&alone, &owners), &lines, (theme, point), across, pixels);
    }
    for (pixel, line) in pixels.iter_mut().zip(&lines) {
        *pixel = match *line {
            SELECTED => mixed(*pixel, theme.accent, 256),
            HOVERED => mixed(*pixel, theme.text, 150),
            HALO => mixed(*pixel, ecolor::Color32::BLACK, 110),
            _ => continue,
        };
    }
}

/// The object at a pixel, and its mark.
type Owner = (Option<usize>, u8);

/// Draws the outlines of selected objects, which are `alone`, where others own the pixels.
fn draw_hidden(
    (alone, owners): (&[Owner], &[Owner]),
    lines: &[u8],
    (theme, point): (&Theme, usize),
    across: usize,
    pixels: &mut [u32],
) {
    let other_at = |at: usize| alone.get(at).map(|owner| owner.0);
    for (at, (object, mark)) in alone.iter().enumerate() {
        let is_hidden = *mark == SELECTED && owners[at].0 != *object && lines[at] != SELECTED;
        let (x, y) = (at % across, at / across);
        let is_dash = ((x + 2 * y) / (DASH * point)).is_multiple_of(2);
        if !is_hidden || !is_dash {
            continue;
        }
        let is_edge = (1..=2 * point).any(|step| {
            // The window's edge isn't an edge of the object.
            let beside = |is_in: bool, other: usize| is_in && other_at(other) != Some(*object);
            beside(x >= step, at.wrapping_sub(step))
                || beside(x + step < across, at + step)
                || beside(y >= step, at.wrapping_sub(step * across))
                || (other_at(at + step * across).is_some() && beside(true, at + step * across))
        });
        if is_edge {
            pixels[at] = mixed(pixels[at], theme.accent, 170);
        }
    }
}

/// The object at each pixel of the window, and its mark.
fn owners(visible: &VisibleIds, size: Size, selection: &Selection, window: Size) -> Vec<Owner> {
    let place = |at: u32, of: u32, source: u32| {
        (u64::from(at) * u64::from(source) / u64::from(of.max(1))) as u32
    };
    let mut owners = Vec::with_capacity(window.width as usize * window.height as usize);
    // Neighbouring pixels mostly show the same object.
    let mut last = (None, UNMARKED);
    for y in 0..window.height {
        let row = place(y, window.height, size.height);
        for x in 0..window.width {
            let object =
                visible.at(place(x, window.width, size.width), row).map(|(object, _)| object);
            if object != last.0 {
                let mark = match object {
                    Some(object) if selection.selected().contains(&object) => SELECTED,
                    object if object.is_some() && object == selection.hovered => HOVERED,
                    _ => UNMARKED,
                };
                last = (object, mark);
            }
            owners.push(last);
        }
    }
    owners
}

/// Mixes a colour over a pixel, 0RGB, by `part` 256ths.
fn mixed(pixel: u32, color: ecolor::Color32, part: u32) -> u32 {
    let [_, below @ ..] = pixel.to_be_bytes();
    let above = [color.r(), color.g(), color.b()];
    let mix = |at: usize| {
        ((u32::from(above[at]) * part + u32::from(below[at]) * (256 - part)) >> 8) as u8
    };
    u32::from_be_bytes([0, mix(0), mix(1), mix(2)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::selection::SelectMode;
    use crate::theme::DARK;
    use luxel::pick::NO_ID;

    const SIZE: Size = Size { width: 12, height: 10 };
    const GREY: u32 = 0x0050_5050;

    /// Object 0 on columns 2 to 9, rows 2 to 8; object 1 on columns 10 and 11 of the same rows.
    fn visible() -> VisibleIds {
        let object = |at: u32| match (at % 12, at / 12) {
            (2..=9, 2..=8) => 0,
            (10.., 2..=8) => 1,
            _ => NO_ID,
        };
        let objects: Vec<_> = (0..120).map(object).collect();
        VisibleIds::new(SIZE, objects, vec![0; 120]).unwrap()
    }

    fn drawn(selected: &[usize], hovered: Option<usize>) -> Vec<u32> {
        let mut selection = Selection::default();
        selection.hovered = hovered;
        selection.select(selected.iter().copied(), SelectMode::Replace);
        let mut pixels = vec![GREY; 120];
        let ids = OutlinedIds { visible: &visible(), alone: None, size: SIZE };
        draw_outlines(&ids, &selection, (&DARK, 1.0), SIZE, &mut pixels);
        pixels
    }

    #[test]
    fn the_hidden_part_of_a_selected_object_has_a_dashed_and_fainter_line() {
        // Object 1 goes on behind object 0, from column 5.
        let object = |at: u32| if at % 12 >= 5 && (2..=8).contains(&(at / 12)) { 1 } else { NO_ID };
        let alone = VisibleIds::new(SIZE, (0..120).map(object).collect(), vec![0; 120]).unwrap();
        let mut selection = Selection::default();
        selection.select([1], SelectMode::Replace);
        let plain = drawn(&[1], None);
        let mut pixels = vec![GREY; 120];
        let ids = OutlinedIds { visible: &visible(), alone: Some(&alone), size: SIZE };
        draw_outlines(&ids, &selection, (&DARK, 1.0), SIZE, &mut pixels);
        let accent = mixed(0, DARK.accent, 256);
        let changed: Vec<_> = (0..120).filter(|at| pixels[*at] != plain[*at]).collect();
        assert!(!changed.is_empty(), "nothing shows where it is hidden");
        for at in &changed {
            let (x, y) = (at % 12, at / 12);
            assert!((5..=9).contains(&x) && (2..=8).contains(&y), "{x} {y}");
            assert!(x <= 6 || y <= 3 || y >= 7, "{x} {y} is inside of it");
            assert_ne!(pixels[*at], accent, "{x} {y} looks as if it were visible");
        }
        let left_line = (2..=8).filter(|y| changed.contains(&(y * 12 + 5))).count();
        assert!((1..7).contains(&left_line), "{left_line} of 7 pixels are dashes");
        // Where it is visible, its line is as before.
        assert!((2..=8).all(|y| pixels[y * 12 + 10] == plain[y * 12 + 10]));
    }

    #[test]
    fn a_selected_object_has_a_line_inside_and_keeps_its_colours_in_the_middle() {
        let pixels = drawn(&[0], None);
        let accent = mixed(0, DARK.accent, 256);
        let at = |x: usize, y: usize| pixels[y * 12 + x];
        for (x, y) in [(2, 2), (3, 5), (9, 8), (8, 4), (5, 7), (5, 3)] {
            assert_eq!(at(x, y), accent, "{x} {y}");
        }
        assert_eq!((at(5, 5), at(0, 0), at(11, 9)), (GREY, GREY, GREY));
        assert!(at(1, 5) < GREY && at(10, 5) < GREY, "no dark edge");
    }

    #[test]
    fn adjacent_selected_objects_share_one_line_of_the_usual_width() {
        let pixels = drawn(&[0, 1], None);
        let accent = mixed(0, DARK.accent, 256);
        let row = &pixels[5 * 12..][..12];
        assert_eq!((row[8], row[9], row[10]), (GREY, accent, accent));
        // There is no line at the window's edge.
        assert_eq!(row[11], GREY);
    }

    #[test]
    fn the_hovered_object_has_a_fainter_line() {
        let pixels = drawn(&[], Some(0));
        let line = pixels[5 * 12 + 2];
        assert!(line > GREY && line != mixed(0, DARK.accent, 256), "{line:x}");
        assert_eq!(pixels[5 * 12 + 3], GREY);
        assert_eq!(drawn(&[0], Some(0)), drawn(&[0], None));
    }

    #[test]
    fn without_marks_nothing_is_drawn() {
        assert_eq!(drawn(&[], None), vec![GREY; 120]);
    }
}
