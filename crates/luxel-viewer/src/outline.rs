//! Lines about the objects that are selected or under the pointer, drawn over the picture.

use crate::marks::Marks;
use crate::theme::Theme;
use luxel::pick::VisibleIds;
use luxel::scene::Size;

/// What a pixel belongs to, or what is drawn there; a higher one wins.
const NOTHING: u8 = 0;
const HALO: u8 = 1;
const HOVERED: u8 = 2;
const SELECTED: u8 = 3;

/// Draws the outlines of what is seen of the marked objects, their lines within them, `scale` pixels
/// to a point, over the window's pixels; selected ones with a dark edge without, so that they are
/// told from any colour. `seen` may be smaller than the window.
pub(crate) fn outline(
    (seen, size): (&VisibleIds, Size),
    marks: &Marks,
    (theme, scale): (&Theme, f32),
    window: Size,
    pixels: &mut [u32],
) {
    if marks.selected().is_empty() && marks.hovered.is_none() {
        return;
    }
    let (across, down) = (window.width as usize, window.height as usize);
    if pixels.len() != across * down {
        return;
    }
    let owners = owners(seen, size, marks, window);
    let mut lines = vec![NOTHING; owners.len()];
    let point = (scale.round() as usize).max(1);
    for y in 0..down {
        for x in 0..across {
            let at = y * across + x;
            let (object, own) = owners[at];
            if own == NOTHING {
                continue;
            }
            // The window's edge is none of the object's.
            let mut look = |step: usize, is_in: bool, other: usize| {
                if !is_in || owners[other].0 == object {
                    return;
                }
                // Between two that are selected, each has its half of the line.
                let is_selected = owners[other].1 == SELECTED;
                if own != SELECTED {
                    lines[at] = if is_selected { lines[at] } else { lines[at].max(own) };
                } else if step <= point || !is_selected {
                    lines[at] = own;
                    lines[other] = lines[other].max(HALO);
                }
            };
            for step in 1..=if own == SELECTED { 2 * point } else { point } {
                look(step, x >= step, at.wrapping_sub(step));
                look(step, x + step < across, at + step);
                look(step, y >= step, at.wrapping_sub(step * across));
                look(step, y + step < down, at + step * across);
            }
        }
    }
    for (pixel, line) in pixels.iter_mut().zip(&lines) {
        *pixel = match *line {
            SELECTED => mixed(*pixel, theme.accent, 256),
            HOVERED => mixed(*pixel, theme.text, 150),
            HALO => mixed(*pixel, egui::Color32::BLACK, 110),
            _ => continue,
        };
    }
}

/// The object that each pixel of the window shows, and how it is marked.
fn owners(seen: &VisibleIds, size: Size, marks: &Marks, window: Size) -> Vec<(Option<usize>, u8)> {
    let place = |at: u32, of: u32, source: u32| {
        (u64::from(at) * u64::from(source) / u64::from(of.max(1))) as u32
    };
    let mut owners = Vec::with_capacity(window.width as usize * window.height as usize);
    // Neighbours mostly show the same.
    let mut last = (None, NOTHING);
    for y in 0..window.height {
        let row = place(y, window.height, size.height);
        for x in 0..window.width {
            let object = seen.at(place(x, window.width, size.width), row).map(|(object, _)| object);
            if object != last.0 {
                let mark = match object {
                    Some(object) if marks.selected().contains(&object) => SELECTED,
                    object if object.is_some() && object == marks.hovered => HOVERED,
                    _ => NOTHING,
                };
                last = (object, mark);
            }
            owners.push(last);
        }
    }
    owners
}

/// So many 256ths of a colour over a pixel, 0RGB.
fn mixed(pixel: u32, color: egui::Color32, part: u32) -> u32 {
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
    use crate::marks::Choice;
    use crate::theme::DARK;
    use luxel::pick::NOTHING as NONE;

    const SIZE: Size = Size { width: 12, height: 10 };
    const GREY: u32 = 0x0050_5050;

    /// Object 0 on columns 2 to 9, rows 2 to 8; object 1 on columns 10 and 11 of the same rows.
    fn seen() -> VisibleIds {
        let object = |at: u32| match (at % 12, at / 12) {
            (2..=9, 2..=8) => 0,
            (10.., 2..=8) => 1,
            _ => NONE,
        };
        let objects: Vec<_> = (0..120).map(object).collect();
        VisibleIds::new(SIZE, objects, vec![0; 120]).unwrap()
    }

    fn drawn(selected: &[usize], hovered: Option<usize>) -> Vec<u32> {
        let mut marks = Marks::default();
        marks.hovered = hovered;
        marks.select(selected.iter().copied(), Choice::Replace);
        let mut pixels = vec![GREY; 120];
        outline((&seen(), SIZE), &marks, (&DARK, 1.0), SIZE, &mut pixels);
        pixels
    }

    #[test]
    fn a_selected_object_has_a_line_within_and_keeps_its_colours_in_the_middle() {
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
    fn objects_selected_together_are_told_apart_by_a_line_no_wider_than_others() {
        let pixels = drawn(&[0, 1], None);
        let accent = mixed(0, DARK.accent, 256);
        let row = &pixels[5 * 12..][..12];
        assert_eq!((row[8], row[9], row[10]), (GREY, accent, accent));
        // There is none at the window's edge.
        assert_eq!(row[11], GREY);
    }

    #[test]
    fn the_object_under_the_pointer_is_marked_more_lightly() {
        let pixels = drawn(&[], Some(0));
        let line = pixels[5 * 12 + 2];
        assert!(line > GREY && line != mixed(0, DARK.accent, 256), "{line:x}");
        assert_eq!(pixels[5 * 12 + 3], GREY);
        assert_eq!(drawn(&[0], Some(0)), drawn(&[0], None));
    }

    #[test]
    fn nothing_marked_changes_nothing() {
        assert_eq!(drawn(&[], None), vec![GREY; 120]);
    }
}
