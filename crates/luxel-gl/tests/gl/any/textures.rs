//! Textures, their environments and generated coordinates.

use super::Numbers;
use luxel_gl::{Context, lengths};

const TARGETS: &[u32] = &[0x0DE0, 0x0DE1, 0x0DE1, 0x0DE1, 0x806F, 0x8513];
const FORMATS: &[u32] = &[
    1, 2, 3, 4, 0x1906, 0x1907, 0x1908, 0x1909, 0x190A, 0x8049, 0x8058, 0x805B, 0x8059, 0x81A5,
    0x81A6, 0x8C43, 0x8C41, 0x2A10, 0x84EE,
];
const PIXELS: &[u32] = &[0x1903, 0x1906, 0x1907, 0x1908, 0x1909, 0x190A, 0x80E0, 0x80E1, 0x1902];
const TYPES: &[u32] =
    &[0x1400, 0x1401, 0x1402, 0x1403, 0x1404, 0x1405, 0x1406, 0x8033, 0x8035, 0x8367];
const FILTERS: &[u32] = &[0x2600, 0x2601, 0x2700, 0x2701, 0x2702, 0x2703];
const WRAPS: &[u32] = &[0x2900, 0x2901, 0x812F, 0x812D, 0x8370];
const PARAMETERS: &[u32] = &[
    0x2800, 0x2801, 0x2802, 0x2803, 0x8072, 0x1004, 0x813A, 0x813B, 0x813C, 0x813D, 0x8501, 0x884B,
    0x884C, 0x884D, 0x8191, 0x8066,
];
const ENVIRONMENT: &[u32] = &[
    0x2200, 0x2201, 0x8571, 0x8572, 0x8580, 0x8581, 0x8582, 0x8588, 0x8589, 0x858A, 0x8590, 0x8591,
    0x8592, 0x8598, 0x8599, 0x859A, 0x8573, 0x0D1C,
];
const NAMES: &[u32] = &[
    0x1E01, 0x2100, 0x2101, 0x0BE2, 0x0104, 0x8570, 0x8574, 0x8575, 0x84E7, 0x86AE, 0x86AF, 0x1702,
    0x8576, 0x8577, 0x8578, 0x84C0, 0x84C1, 0x0300, 0x0301, 0x0302, 0x0303, 1, 2, 4,
];

/// A target of an image.
fn image_target(n: &mut Numbers) -> (u32, u32) {
    match n.below(9) {
        0 => (1, 0x0DE0),
        1..=4 => (2, 0x0DE1),
        5 => (3, 0x806F),
        6 => (2, 0x8064),
        _ => (2, 0x8515 + n.below(6)),
    }
}

/// One command on textures with its arguments.
pub(super) fn command(context: &mut Context, n: &mut Numbers, _: &mut Vec<u64>) {
    match n.below(24) {
        0..=5 => {
            let (dimensions, target) = image_target(n);
            let side = 1 << n.below(5);
            let size = [side, if n.below(4) == 0 { n.below(20) as i32 - 1 } else { side }, side];
            let size = [size[0], size[1], size[2].min(4)];
            let (format, data_type) = (n.of(PIXELS), n.of(TYPES));
            let (level, border) = (n.below(3) as i32, i32::from(n.below(9) == 0));
            let internal = n.of(FORMATS) as i32;
            let length = context.tex_image_bytes(
                dimensions, target, level, internal, size, border, format, data_type,
            );
            let data: Vec<u8> = (0..length.min(1 << 16)).map(|_| n.next() as u8).collect();
            let data = (n.below(5) != 0).then_some(&data[..]);
            match dimensions {
                1 => context.tex_image_1d(
                    target, level, internal, size[0], border, format, data_type, data,
                ),
                2 => context.tex_image_2d(
                    target,
                    level,
                    internal,
                    [size[0], size[1]],
                    border,
                    format,
                    data_type,
                    data,
                ),
                _ => context
                    .tex_image_3d(target, level, internal, size, border, format, data_type, data),
            }
        }
        6 => {
            let (dimensions, target) = image_target(n);
            let size = [n.below(6) as i32, n.below(6) as i32, 1];
            let offset = [n.below(6) as i32 - 1, n.below(6) as i32 - 1, 0];
            let (format, data_type) = (n.of(PIXELS), n.of(TYPES));
            let length =
                context.tex_sub_image_bytes(dimensions, target, 0, offset, size, format, data_type);
            let data: Vec<u8> = (0..length.min(1 << 16)).map(|_| n.next() as u8).collect();
            context.tex_sub_image(dimensions, target, 0, offset, size, format, data_type, &data);
        }
        7 => {
            let (dimensions, target) = image_target(n);
            let from = [n.below(90) as i32 - 9, n.below(90) as i32 - 9];
            let side = 1 << n.below(5);
            if n.below(2) == 0 {
                context.copy_tex_image(dimensions, target, 0, n.of(FORMATS), from, [side; 2], 0);
            } else {
                context.copy_tex_sub_image(dimensions, target, 0, [1, 0, 0], from, [side; 2]);
            }
        }
        8 => context.bind_texture(n.of(TARGETS), n.below(5)),
        9 => context.delete_textures(1, &[n.below(5)]),
        10 => context.active_texture(0x84C0 + n.below(3)),
        11 => context.generate_mipmap(n.of(TARGETS)),
        12..=13 => context.tex_parameter(n.of(TARGETS), 0x2801, &[n.of(FILTERS) as f32]),
        14 => {
            let wrap = n.of(&[0x2802, 0x2803, 0x8072]);
            context.tex_parameter(n.of(TARGETS), wrap, &[n.of(WRAPS) as f32]);
        }
        15 => {
            let pname = n.of(PARAMETERS);
            let value = match n.below(3) {
                0 => n.place(),
                1 => n.below(4) as f32,
                _ => n.of(&[0x1909, 0x8049, 0x1906, 0x884E, 0, 0x203, 0x205]) as f32,
            };
            context.tex_parameter(
                n.of(TARGETS),
                pname,
                &[value; 4][..lengths::tex_parameter(pname)],
            );
        }
        16..=18 => {
            let pname = n.of(ENVIRONMENT);
            let value = n.of(NAMES) as f32;
            context.tex_env(n.of(&[0x2300, 0x2300, 0x8500]), pname, &[value, 0.5, 0.2, 0.7]);
        }
        19 => {
            let mode = n.of(&[0x2400, 0x2401, 0x2402, 0x8511, 0x8512]);
            context.tex_gen(0x2000 + n.below(4), 0x2500, &[mode as f32]);
        }
        20 => {
            let plane = [n.place(), n.place(), n.unit(), n.unit()];
            context.tex_gen(0x2000 + n.below(4), n.of(&[0x2501, 0x2502]), &plane);
        }
        21 => {
            context.enable(n.of(&[0x0DE0, 0x0DE1, 0x0DE1, 0x806F, 0x8513, 0x0C60, 0x0C61, 0x0C62]));
        }
        22 => context.disable(n.of(&[0x0DE0, 0x0DE1, 0x806F, 0x8513, 0x0C60, 0x0C61, 0x0C63])),
        _ => {
            let unit = 0x84C0 + n.below(3);
            let q = if n.below(4) == 0 { n.place() } else { 1.0 };
            context.tex_coord(unit, [n.place(), n.place(), n.place(), q]);
        }
    }
}

/// What can be seen from the first command on.
pub(super) fn prepare(context: &mut Context) {
    for unit in 0..2 {
        context.active_texture(0x84C0 + unit);
        context.enable(0x0DE1);
        context.tex_parameter(0x0DE1, 0x8191, &[1.0]);
    }
}
