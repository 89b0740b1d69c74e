//! Framebuffer objects, their images and samples, copies between them, clip control, what is read.

use super::Numbers;
use luxel_gl::Context;

const FRAMEBUFFER: u32 = 0x8d40;
const TARGETS: &[u32] = &[FRAMEBUFFER, FRAMEBUFFER, 0x8ca8, 0x8ca9];
const RENDERBUFFER: u32 = 0x8d41;
const ATTACHMENTS: &[u32] = &[0x8ce0, 0x8ce0, 0x8d00, 0x8d20, 0x821a];
const COLORS: &[u32] = &[0x8058, 0x8051, 0x8c43];
const DEPTHS: &[u32] = &[0x88f0, 0x88f0, 0x8cad, 0x81a5, 0x81a6, 0x8cac];
const STENCILS: &[u32] = &[0x8d48, 0x8d46];
const TEXTURES: &[u32] = &[0x8058, 0x8051, 0x8c43, 0x81a6, 0x8cac, 0x88f0, 0x8cad, 0x1909];
const FORMATS: &[u32] = &[0x1908, 0x1907, 0x1902, 0x1901, 0x84f9];
const TYPES: &[u32] = &[0x1401, 0x1403, 0x1405, 0x1406, 0x84fa, 0x8dad];
const BUFFERS: &[u32] = &[0x8ce0, 0x8ce0, 0x8ce0, 0x8ce0, 0, 0x0404, 0x0405];
const MULTISAMPLE: &[u32] = &[0x809d, 0x809e, 0x809f, 0x80a0];

/// An object with colours and depths is bound.
pub(super) fn prepare(context: &mut Context) {
    for (name, format, attachment) in [(1, 0x8058, 0x8ce0), (2, 0x88f0, 0x821a)] {
        context.bind_renderbuffer(RENDERBUFFER, name);
        context.renderbuffer_storage(RENDERBUFFER, 4, format, 80, 60);
        context.bind_framebuffer(FRAMEBUFFER, 1);
        context.framebuffer_renderbuffer(FRAMEBUFFER, attachment, RENDERBUFFER, name);
    }
}

/// The window is bound, with the colours of all objects side by side in it.
pub(super) fn finish(context: &mut Context) {
    context.resize_default(150, 70);
    context.disable(0x0c11);
    for name in 1..4 {
        context.bind_framebuffer(0x8ca8, name);
        context.bind_framebuffer(0x8ca9, 0);
        let left = 50 * (name as i32 - 1);
        context.blit_framebuffer([0, 0, 50, 60], [left, 10, left + 50, 70], 0x4000, 0x2600);
    }
    context.bind_framebuffer(FRAMEBUFFER, 0);
}

/// One command on framebuffers with its arguments.
pub(super) fn command(context: &mut Context, n: &mut Numbers, answers: &mut Vec<u64>) {
    match n.below(30) {
        0..=3 => context.bind_framebuffer(n.of(TARGETS), n.below(4)),
        26..=28 => context.bind_framebuffer(FRAMEBUFFER, n.below(2)),
        29 => prepare(context),
        4 => context.bind_renderbuffer(RENDERBUFFER, n.below(5)),
        5..=6 => {
            let (width, height) = (n.below(140) as i32 - 1, n.below(90) as i32);
            // Mostly, odd names have colours and even ones depths, the first two with samples, so that many objects can
            // be drawn to.
            let name = n.below(5);
            let samples = n.of(if name < 3 { &[4, 4, 4, 2, 0] } else { &[0, 0, 0, 4, 5] }) as i32;
            let formats = if name % 2 == 1 { COLORS } else { DEPTHS };
            let formats = if n.below(8) == 0 { STENCILS } else { formats };
            context.bind_renderbuffer(RENDERBUFFER, name);
            context.renderbuffer_storage(RENDERBUFFER, samples, n.of(formats), width, height);
        }
        7..=9 => {
            let name = n.below(5);
            let fitting = if name % 2 == 1 { 0x8ce0 } else { 0x821a };
            let attachment = if n.below(8) == 0 { n.of(ATTACHMENTS) } else { fitting };
            context.framebuffer_renderbuffer(n.of(TARGETS), attachment, RENDERBUFFER, name);
        }
        10..=11 => {
            let (target, attachment) = (n.of(TARGETS), n.of(ATTACHMENTS));
            let texture_target = n.of(&[0x0de1, 0x0de1, 0x0de0, 0x806f, 0x8515]);
            let (level, layer) = (n.below(2) as i32, n.below(3) as i32 - 1);
            let name = n.below(5);
            context.framebuffer_texture(target, attachment, texture_target, name, level, layer);
        }
        12 => {
            context.bind_texture(0x0de1, n.below(5));
            let (internal, side) = (n.of(TEXTURES) as i32, n.below(100) as i32);
            let [level, height] = [n.below(9) / 8, n.below(70)].map(|value| value as i32);
            let format = if matches!(internal, 0x81a6 | 0x8cac) { 0x1902 } else { 0x1908 };
            context.tex_image_2d(0x0de1, level, internal, [side, height], 0, format, 0x1401, None);
        }
        13 => context.generate_mipmap(0x0de1),
        14 => match n.below(5) {
            0 => context.delete_framebuffers(&[n.below(4)]),
            1 => context.delete_renderbuffers(&[n.below(5)]),
            2 => context.delete_textures(1, &[n.below(5)]),
            3 => context.remove_default(),
            _ => context.resize_default(150, 70),
        },
        15..=17 => {
            let rectangle = |n: &mut Numbers| {
                let [x, y] = [n.below(150) as i32 - 10, n.below(90) as i32 - 10];
                [x, y, x + n.below(80) as i32 - 10, y + n.below(50) as i32 - 10]
            };
            let source = rectangle(n);
            // As large, as samples demand, or of any size.
            let target = if n.below(2) == 0 {
                let by = [n.below(60) as i32 - 10, n.below(40) as i32 - 10];
                [source[0] + by[0], source[1] + by[1], source[2] + by[0], source[3] + by[1]]
            } else {
                rectangle(n)
            };
            let mask = n.of(&[0x4000, 0x4000, 0x4000, 0x100, 0x400, 0x4500]);
            context.blit_framebuffer(source, target, mask, n.of(&[0x2600, 0x2601]));
        }
        18 => context.clip_control(n.of(&[0x8ca1, 0x8ca2]), n.of(&[0x935e, 0x935f])),
        19 => {
            context.sample_coverage(n.unit(), n.below(2) == 0);
            if n.below(2) == 0 {
                context.enable(n.of(MULTISAMPLE));
            } else {
                context.disable(n.of(MULTISAMPLE));
            }
        }
        20..=21 => {
            let (format, data_type) = (n.of(FORMATS), n.of(TYPES));
            let [x, y] = [n.below(120) as i32 - 9, n.below(80) as i32 - 9];
            let bytes = context.pack_bytes(9, 5, format, data_type);
            let mut out = vec![0; bytes.min(4096)];
            context.read_pixels(x, y, 9, 5, format, data_type, &mut out);
            let sum = out.iter().fold(0, |sum: u64, byte| sum.wrapping_mul(31) + u64::from(*byte));
            answers.push(sum);
        }
        22 => {
            let from = [n.below(90) as i32 - 9, n.below(90) as i32 - 9];
            context.bind_texture(0x0de1, n.below(5));
            let side = n.below(40) as i32;
            context.copy_tex_image(2, 0x0de1, 0, n.of(TEXTURES), from, [side; 2], 0);
        }
        23 => context.draw_buffer(n.of(BUFFERS)),
        24 => context.read_buffer(n.of(BUFFERS)),
        _ => {
            answers.push(context.check_framebuffer_status(n.of(TARGETS)).into());
            let query = n.of(&[0x8cd0, 0x8cd1, 0x8cd2, 0x8cd3]);
            let (target, attachment) = (n.of(TARGETS), n.of(ATTACHMENTS));
            let found = context.get_framebuffer_attachment_parameter(target, attachment, query);
            answers.extend(found.map(|values| u64::from(values.to_i32(0).cast_unsigned())));
        }
    }
}
