//! Images, transfers, sums and queries.

use super::Numbers;
use luxel_gl::Context;

const FORMATS: &[u32] =
    &[0x1908, 0x1907, 0x80E1, 0x1903, 0x1906, 0x1909, 0x190A, 0x1902, 0x1901, 0x84F9];
const TYPES: &[u32] = &[0x1401, 0x1400, 0x1403, 0x1402, 0x1405, 0x1406, 0x8035, 0x8363, 0x84FA];
pub(super) const SAMPLES_PASSED: u32 = 0x8914;

/// One command on images of the window, with its arguments.
pub(super) fn command(context: &mut Context, n: &mut Numbers, answers: &mut Vec<u64>) {
    match n.below(12) {
        0..=2 => {
            let size = [n.below(20) as i32 - 1, n.below(20) as i32];
            let bytes: Vec<u8> = (0..20 * 20 * 16).map(|_| n.next() as u8).collect();
            context.draw_pixels(size, n.of(FORMATS), n.of(TYPES), &bytes);
        }
        3..=4 => {
            let from = [n.below(200) as i32 - 30, n.below(90) as i32 - 10];
            let size = [n.below(60) as i32 - 1, n.below(60) as i32];
            context.copy_pixels(from, size, n.of(&[0x1800, 0x1801, 0x1802, 0x84F9]));
        }
        5 => context.pixel_zoom(n.place() * 3.0, n.place() * 3.0),
        6..=7 => {
            let place = [n.below(150) as f32, n.below(70) as f32, n.unit()];
            context.window_pos(place);
        }
        8 => {
            let values = n.color();
            context.pixel_map(0x0C70 + n.below(11), n.below(6) as i32, &values);
        }
        9 => context.pixel_transfer(0x0D10 + n.below(17), n.place()),
        10 => context.accum(0x0100 + n.below(6), n.place()),
        _ => match n.below(4) {
            0 => context.begin_query(n.of(&[SAMPLES_PASSED]), n.below(4)),
            1 => context.end_query(SAMPLES_PASSED),
            2 => answers.extend(context.get_query_object(n.below(4), 0x8866)),
            _ => context.delete_queries(&[n.below(4)]),
        },
    }
}
