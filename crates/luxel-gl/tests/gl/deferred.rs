//! Draws whose vertices are processed long after their calls: what changes in between (section 2.1: commands take effect
//! in their order).

use crate::canvas::{canvas, gl};
use luxel_gl::{ClientMemory, Context, NoClientMemory};
use proptest::prelude::*;

const FRONT_AND_BACK: u32 = 0x0408;
const VERTEX_ARRAY: u32 = 0x8074;
const COLOR_ARRAY: u32 = 0x8076;
const ARRAY_BUFFER: u32 = 0x8892;
const ELEMENT_BUFFER: u32 = 0x8893;
const STATIC_DRAW: u32 = 0x88E4;
const TEXTURE_2D: u32 = 0x0DE1;
const MIN_FILTER: u32 = 0x2801;
const NEAREST: u32 = 0x2600;
const POLYGON_OFFSET_FILL: u32 = 0x8037;

/// What a test does to a context.
type Step = fn(&mut Context);

/// Triangles of a mesh: more than draws have that are made at once.
const TRIANGLES: u32 = 48;

/// The corners of the mesh: two floats and four bytes of colour each.
fn corners() -> Vec<([f32; 2], [u8; 4])> {
    let corner = |number: u32| {
        let (column, row) = (number % 8, number / 8 % 6);
        let place = [column as f32 * 4.0 + (number % 3) as f32 * 3.0, row as f32 * 5.0];
        (place, [(30 * column) as u8, 255 - (40 * row) as u8, (number * 37 % 256) as u8, 200])
    };
    (0..3 * TRIANGLES).map(|number| corner(number * 29 % 53)).collect()
}

/// The mesh as it lies in memory.
fn bytes() -> Vec<u8> {
    let bytes = |(place, color): ([f32; 2], [u8; 4])| {
        place.into_iter().flat_map(f32::to_ne_bytes).chain(color).collect::<Vec<u8>>()
    };
    corners().into_iter().flat_map(bytes).collect()
}

/// A program's memory, from address 64 on.
struct Memory(Vec<u8>);

impl ClientMemory for Memory {
    fn bytes(&self, address: usize, length: usize) -> &[u8] {
        &self.0[address - 64..address - 64 + length]
    }
}

fn set_arrays(context: &mut Context, start: usize) {
    context.enable_client_state(VERTEX_ARRAY);
    context.vertex_pointer(2, gl::FLOAT, 12, start);
    context.color_pointer(4, gl::UNSIGNED_BYTE, 12, start + 8);
}

/// Draws the mesh, `count` triangles at a time; `between` follows each draw.
type Mesh = fn(&mut Context, count: usize, between: Step);

/// A corner in a colour, or in that of now.
struct Corner {
    place: [f32; 2],
    z: f32,
    color: Option<[u8; 4]>,
}

fn draw(context: &mut Context, corners: &[Corner]) {
    context.begin(gl::TRIANGLES);
    for &Corner { place: [x, y], z, color } in corners {
        if let Some(color) = color {
            context.color(color.map(luxel_gl::convert::ubyte));
            context.tex_coord(0x84C0, [x * 0.1, y * 0.1, 0.0, 1.0]);
        }
        context.vertex([x, y, z, 1.0]);
    }
    context.end();
}

const MESHES: &[Mesh] = &[
    |context, count, between| {
        let corner = |(place, color): ([f32; 2], [u8; 4])| {
            let (z, color) = (place[0] * 0.01, Some(color));
            Corner { place, z, color }
        };
        let corners: Vec<Corner> = corners().into_iter().map(corner).collect();
        for part in corners.chunks(3 * count) {
            draw(context, part);
            between(context);
        }
    },
    // In the colour of now, out of memory that is gone afterwards.
    |context, count, between| {
        set_arrays(context, 64);
        for first in (0..TRIANGLES as usize).step_by(count) {
            let (first, count) =
                (3 * first as i32, 3 * count.min(TRIANGLES as usize - first) as i32);
            context.draw_arrays(gl::TRIANGLES, first, count, &Memory(bytes()));
            between(context);
        }
    },
    // Out of buffers that change afterwards.
    |context, count, between| {
        let vertices = bytes();
        context.bind_buffer(ARRAY_BUFFER, 1);
        context.buffer_data(ARRAY_BUFFER, vertices.len() as isize, Some(&vertices), STATIC_DRAW);
        set_arrays(context, 0);
        context.enable_client_state(COLOR_ARRAY);
        let elements: Vec<u8> = (0..3 * TRIANGLES as u8).rev().collect();
        context.bind_buffer(ELEMENT_BUFFER, 2);
        context.buffer_data(ELEMENT_BUFFER, elements.len() as isize, Some(&elements), STATIC_DRAW);
        for (number, part) in elements.chunks(3 * count).enumerate() {
            let (of, first) = (part.len() as i32, 3 * count * number);
            context.draw_elements(gl::TRIANGLES, of, gl::UNSIGNED_BYTE, first, &NoClientMemory);
            between(context);
        }
        context.buffer_data(ARRAY_BUFFER, 3, Some(&[9; 3]), STATIC_DRAW);
        context.delete_buffers(&[2]);
        context.bind_buffer(ARRAY_BUFFER, 0);
        context.disable_client_state(COLOR_ARRAY);
    },
    // Out of a list that is another one afterwards: so many vertices that those that are alike become one.
    |context, count, between| {
        let copy = |number: u8| {
            let z = f32::from(number % 2) * 0.3;
            corners().into_iter().map(move |(place, _)| Corner { place, z, color: None })
        };
        let corners: Vec<Corner> = (0..120).flat_map(copy).collect();
        if count < TRIANGLES as usize {
            for part in corners.chunks(3 * count) {
                draw(context, part);
                between(context);
            }
            return;
        }
        context.new_list(1, gl::COMPILE);
        draw(context, &corners);
        context.end_list();
        context.call_list(1);
        between(context);
        context.new_list(1, gl::COMPILE);
        context.end_list();
    },
];

fn texture(context: &mut Context, shade: u8) {
    let texels = [[255, shade, 90, 255], [shade, 200, 255, 128], [90, 255, shade, 255], [255; 4]];
    let texels = texels.as_flattened();
    let bytes = gl::UNSIGNED_BYTE;
    context.tex_image_2d(TEXTURE_2D, 0, gl::RGBA as i32, [2; 2], 0, gl::RGBA, bytes, Some(texels));
}

/// Changes of state.
const CHANGES: &[Step] = &[
    |context| context.color([0.9, 0.5, 0.2, 0.6]),
    |context| context.normal([0.6, 0.0, 0.8]),
    |context| context.rotate(20.0, 0.1, 0.2, 1.0),
    |context| context.scale(0.8, 1.1, 1.0),
    |context| context.load_identity(),
    |context| context.enable(gl::LIGHTING),
    |context| context.disable(gl::LIGHTING),
    |context| context.light(gl::LIGHT0, 0x1201, &[0.3, 0.9, 0.5, 1.0]),
    |context| context.material(FRONT_AND_BACK, 0x1201, &[0.2, 0.6, 0.9, 0.7]),
    |context| context.enable(0x0b57),
    |context| context.shade_model(0x1d00),
    |context| context.enable(gl::CULL_FACE),
    |context| context.front_face(0x0900),
    |context| context.polygon_mode(0x0405, 0x1b01),
    |context| context.polygon_mode(FRONT_AND_BACK, 0x1b02),
    |context| {
        context.enable(POLYGON_OFFSET_FILL);
        context.polygon_offset(3.0, 4000.0);
    },
    |context| context.viewport(5, 3, 60, 50),
    |context| context.depth_range(0.2, 0.7),
    |context| context.scissor(8, 6, 40, 30),
    |context| context.enable(gl::SCISSOR_TEST),
    |context| context.enable(gl::BLEND),
    |context| context.blend_func(0x0302, 0x0303),
    |context| context.depth_func(0x0203),
    |context| context.enable(0x0b60),
    |context| context.fog(0x0b62, &[2.0]),
    |context| context.enable(0x3000),
    |context| context.clip_plane(0x3000, [1.0, 0.3, 0.0, -12.0]),
    |context| context.enable(TEXTURE_2D),
    |context| texture(context, 10),
    |context| texture(context, 240),
    |context| context.bind_texture(TEXTURE_2D, 7),
    |context| context.delete_textures(1, &[7]),
    |context| context.push_attrib(gl::ALL_ATTRIB_BITS),
    |context| context.pop_attrib(),
    |context| context.clear(gl::DEPTH_BUFFER_BIT),
    |context| context.rect([3.0, 4.0], [20.0, 9.0]),
];

/// Colours and depths after meshes, which are drawn so many triangles at a time, and changes.
fn outcome(steps: &[(usize, usize)], count: usize, between: Step) -> (Vec<u8>, Vec<u8>) {
    let mut context = canvas(96, 72);
    context.enable(gl::DEPTH_TEST);
    context.enable(gl::LIGHT0);
    context.tex_parameter(TEXTURE_2D, MIN_FILTER, &[NEAREST as f32]);
    texture(&mut context, 120);
    for &(mesh, change) in steps {
        context.translate(4.0, 2.0, 0.01);
        MESHES[mesh](&mut context, count, between);
        CHANGES[change](&mut context);
        between(&mut context);
    }
    let (mut colors, mut depths) = (vec![0; 96 * 72 * 4], vec![0; 96 * 72 * 4]);
    context.read_pixels(0, 0, 96, 72, gl::RGBA, gl::UNSIGNED_BYTE, &mut colors);
    context.read_pixels(0, 0, 96, 72, gl::DEPTH_COMPONENT, gl::FLOAT, &mut depths);
    (colors, depths)
}

/// Draws that are carried out together have the outcome of small ones, each of which is made and carried out at once.
fn agree(steps: &[(usize, usize)]) -> bool {
    let at_last = outcome(steps, TRIANGLES as usize, |_| {});
    at_last == outcome(steps, TRIANGLES as usize, Context::finish)
        && at_last == outcome(steps, 20, Context::finish)
}

#[test]
fn section_2_1_a_draw_has_the_state_of_its_call_whatever_changes_before_it_is_carried_out() {
    for mesh in 0..MESHES.len() {
        let steps: Vec<(usize, usize)> = (0..CHANGES.len()).map(|change| (mesh, change)).collect();
        assert!(agree(&steps), "mesh {mesh}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn section_2_1_draws_in_any_order_of_changes_have_the_state_of_their_calls(
        steps in prop::collection::vec((0..MESHES.len(), 0..CHANGES.len()), 1..12),
    ) {
        prop_assert!(agree(&steps));
    }
}
