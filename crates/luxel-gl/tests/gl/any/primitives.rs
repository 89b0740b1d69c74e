//! Vertices and the state that decides how they are drawn, lists, modes.

use super::Numbers;
use crate::canvas::gl;
use luxel_gl::Context;

const CAPABILITIES: &[u32] = &[
    gl::DEPTH_TEST,
    gl::LIGHTING,
    gl::LIGHT0,
    0x4001,
    gl::BLEND,
    gl::CULL_FACE,
    gl::SCISSOR_TEST,
    0x0B57,
    0x0BA1,
    0x803A,
    0x0BC0,
    0x0B90,
    0x0BF2,
    0x0B60,
    0x8458,
    0x0B24,
    0x0B42,
    0x8037,
    0x2A02,
    0x2A01,
    0x3000,
    0x3001,
    0x3007,
    0x0B20,
];
const FUNCS: &[u32] = &[0x200, 0x201, 0x202, 0x203, 0x204, 0x205, 0x206, 0x207];
const FACES: &[u32] = &[0x0404, 0x0405, 0x0408];
const FACTORS: &[u32] =
    &[0, 1, 0x0300, 0x0301, 0x0302, 0x0303, 0x0304, 0x0305, 0x0306, 0x0307, 0x8001, 0x8004];

/// One command with its arguments.
pub(super) fn command(context: &mut Context, n: &mut Numbers) {
    match n.below(64) {
        0..=3 => context.begin(n.of(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9])),
        4..=6 => context.end(),
        7..=24 => {
            let w = if n.below(8) == 0 { n.place() } else { 1.0 };
            let position = [n.place(), n.place(), n.place(), w];
            context.vertex(position);
        }
        25..=28 => context.color(n.color()),
        29 => context.normal([n.place(), n.place(), n.place()]),
        30 => context.secondary_color([n.unit(), n.unit(), n.unit()]),
        31 => context.fog_coord(n.place()),
        32 => context.edge_flag(n.below(2) == 0),
        33..=35 => context.enable(n.of(CAPABILITIES)),
        36..=37 => context.disable(n.of(CAPABILITIES)),
        38 => context.matrix_mode(n.of(&[0x1700, 0x1701, 0x1702])),
        39 => context.load_identity(),
        40 => context.rotate(f64::from(n.below(720)), 1.0, f64::from(n.place()), 0.5),
        41 => context.translate(f64::from(n.unit()), f64::from(n.unit()), f64::from(n.unit())),
        42 => context.frustum(-1.0, 1.0, -1.0, 1.0, f64::from(n.unit()), 10.0),
        43 => {
            let side = |n: &mut Numbers| n.below(300) as i32 - 20;
            context.viewport(side(n), side(n), side(n), side(n));
        }
        44 => context.depth_range(f64::from(n.unit()), f64::from(n.unit())),
        45 => {
            let values = n.color();
            context.light(0x4000 + n.below(3), 0x1200 + n.below(4), &values);
        }
        46 => context.light(0x4000, n.of(&[0x1205, 0x1206, 0x1207, 0x1208]), &[n.place() * 40.0]),
        47 => {
            let values = n.color();
            context.material(n.of(FACES), n.of(&[0x1200, 0x1201, 0x1202, 0x1600, 0x1601]), &values);
        }
        48 => context.light_model(n.of(&[0x0B51, 0x0B52, 0x81F8]), &[n.of(&[0, 1, 33274]) as f32]),
        49 => context.shade_model(n.of(&[0x1D00, 0x1D01])),
        50 => context.polygon_mode(n.of(FACES), n.of(&[0x1B00, 0x1B01, 0x1B02])),
        51 => {
            context.line_width(n.unit() * 6.0);
            context.point_size(n.unit() * 9.0);
            context.line_stipple(n.below(5) as i32, n.next() as u16);
        }
        52 => context.depth_func(n.of(FUNCS)),
        53 => {
            context.alpha_func(n.of(FUNCS), n.unit());
            context.stencil_func(n.of(FUNCS), n.below(9) as i32, n.next());
            let operation = |n: &mut Numbers| n.of(&[0, 0x1E00, 0x1E01, 0x1E02, 0x1E03, 0x150A]);
            context.stencil_op(operation(n), operation(n), operation(n));
        }
        54 => context.blend_func(n.of(FACTORS), n.of(FACTORS)),
        55 => {
            let bit = |n: &mut Numbers| n.below(4) != 0;
            context.color_mask(bit(n), bit(n), bit(n), bit(n));
            context.logic_op(0x1500 + n.below(17));
        }
        56 => {
            context.clear_color(n.color());
            context.clear(n.of(&[0x4000, 0x100, 0x400, 0x4500]));
        }
        57 => context.scissor(n.below(90) as i32 - 9, n.below(90) as i32, n.below(90) as i32, 60),
        58 => {
            let plane = [n.place(), n.place(), n.place(), n.place()].map(f64::from);
            context.clip_plane(0x3000 + n.below(9), plane);
        }
        59 => {
            context.new_list(n.below(4), n.of(&[gl::COMPILE, gl::COMPILE_AND_EXECUTE]));
        }
        60 => context.end_list(),
        61 => {
            // Not one that calls itself: that takes a second.
            let name = n.below(4);
            let open = context.get(0x0B33).map_or(1, |values| values.to_i32(0) as u32);
            if open == 0 || name < open {
                context.call_list(name);
            }
        }
        62 => match n.below(5) {
            0 => context.push_attrib(n.next()),
            1 => context.pop_attrib(),
            2 => context.push_matrix(),
            3 => context.pop_matrix(),
            _ => context.raster_pos([n.place(), n.place(), n.place(), 1.0]),
        },
        _ => {
            context.fog(
                n.of(&[0x0B62, 0x0B63, 0x0B64, 0x0B65, 0x8450]),
                &[n.of(&[1, 2, 2048, 9729, 33873]) as f32],
            );
            context.polygon_offset(n.place(), n.place());
            match n.below(30) {
                0 => {
                    context.select_buffer(n.below(40) as i32);
                    context.feedback_buffer(n.below(400) as i32, 0x0600 + n.below(5));
                }
                1 => {
                    context.render_mode(n.of(&[gl::RENDER, gl::SELECT, gl::FEEDBACK]));
                }
                2 => {
                    context.init_names();
                    context.push_name(n.next());
                }
                _ => {}
            }
        }
    }
}
