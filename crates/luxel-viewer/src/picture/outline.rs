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

/// Draws outlines of the visible parts of selected and hovered objects over the window's pixels, at
/// `scale` pixels a point. Lines lie inside the objects; selected ones have a dark edge outside, for
/// contrast with any colour. `visible` may be smaller than the window.
pub(crate) fn draw_outlines(
    (visible, size): (&VisibleIds, Size),
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
    let owners = owners(visible, size, selection, window);
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
    for (pixel, line) in pixels.iter_mut().zip(&lines) {
        *pixel = match *line {
            SELECTED => mixed(*pixel, theme.accent, 256),
            HOVERED => mixed(*pixel, theme.text, 150),
            HALO => mixed(*pixel, ecolor::Color32::BLACK, 110),
            _ => continue,
        };
    }
}

/// The object at each pixel of the window, and its mark.
fn owners(
    visible: &VisibleIds,
    size: Size,
    selection: &Selection,
    window: Size,
) -> Vec<(Option<usize>, u8)> {
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
        draw_outlines((&visible(), SIZE), &selection, (&DARK, 1.0), SIZE, &mut pixels);
        pixels
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
