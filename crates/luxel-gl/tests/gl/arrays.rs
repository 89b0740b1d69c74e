//! Vertex arrays (section 2.8) and buffer objects (section 2.9).

use crate::canvas::{canvas, gl, pixels};
use luxel_gl::{ClientMemory, Context, NoClientMemory};

const VERTEX_ARRAY: u32 = 0x8074;
const COLOR_ARRAY: u32 = 0x8076;
const ARRAY_BUFFER: u32 = 0x8892;
const ELEMENT_BUFFER: u32 = 0x8893;
const STATIC_DRAW: u32 = 0x88E4;
const DOUBLE: u32 = 0x140A;
const SHORT: u32 = 0x1402;
const UNSIGNED_SHORT: u32 = 0x1403;

/// A program's memory: addresses from 4096 on.
struct Memory(Vec<u8>);

const START: usize = 4096;

impl ClientMemory for Memory {
    fn bytes(&self, address: usize, length: usize) -> &[u8] {
        &self.0[address - START..address - START + length]
    }
}

const PLACES: [[f32; 2]; 5] = [[1.0, 1.0], [14.0, 2.0], [13.0, 13.0], [2.0, 15.0], [7.0, 8.0]];
const COLORS: [[u8; 4]; 5] =
    [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 0, 255], [9, 99, 200, 255]];

/// Places as two floats, colours as four bytes, one after the other: 12 bytes a vertex.
fn interleaved() -> Vec<u8> {
    let mut bytes = Vec::new();
    for (place, color) in PLACES.iter().zip(COLORS) {
        bytes.extend(place.iter().flat_map(|value| value.to_ne_bytes()));
        bytes.extend(color);
    }
    bytes
}

/// The same vertices between `glBegin` and `glEnd`.
fn immediate(mode: u32, vertices: &[usize]) -> Vec<[u8; 4]> {
    let mut context = canvas(16, 16);
    context.begin(mode);
    for &vertex in vertices {
        context.color(COLORS[vertex].map(luxel_gl::convert::ubyte));
        let [x, y] = PLACES[vertex];
        context.vertex([x, y, 0.0, 1.0]);
    }
    context.end();
    pixels(&mut context)
}

/// Sets both arrays from an address on.
fn set_arrays(context: &mut Context, start: usize) {
    context.enable_client_state(VERTEX_ARRAY);
    context.enable_client_state(COLOR_ARRAY);
    context.vertex_pointer(2, gl::FLOAT, 12, start);
    context.color_pointer(4, gl::UNSIGNED_BYTE, 12, start + 8);
}

#[test]
fn section_2_8_arrays_draw_what_single_vertices_draw() {
    let memory = Memory(interleaved());
    for mode in 0..=9 {
        let mut context = canvas(16, 16);
        set_arrays(&mut context, START);
        context.draw_arrays(mode, 1, 4, &memory);
        assert_eq!(pixels(&mut context), immediate(mode, &[1, 2, 3, 4]), "mode {mode}");
        let mut context = canvas(16, 16);
        set_arrays(&mut context, START);
        context.begin(mode);
        for vertex in [4, 0, 2] {
            context.array_element(vertex, &memory);
        }
        context.end();
        assert_eq!(pixels(&mut context), immediate(mode, &[4, 0, 2]), "mode {mode}");
        assert_eq!(context.get_error(), gl::NO_ERROR);
    }
}

#[test]
fn section_2_8_elements_take_vertices_in_any_order() {
    let mut bytes = interleaved();
    let indices = [3_u16, 0, 2, 2, 0, 1];
    bytes.extend(indices.iter().flat_map(|index| index.to_ne_bytes()));
    let memory = Memory(bytes);
    let expected = immediate(gl::TRIANGLES, &[3, 0, 2, 2, 0, 1]);
    let mut context = canvas(16, 16);
    set_arrays(&mut context, START);
    context.draw_range_elements(gl::TRIANGLES, 0, 3, 6, UNSIGNED_SHORT, START + 60, &memory);
    assert_eq!(pixels(&mut context), expected);
    let mut context = canvas(16, 16);
    set_arrays(&mut context, START);
    let both = [START + 60, START + 66];
    context.multi_draw_elements(gl::TRIANGLES, &[3, 3], UNSIGNED_SHORT, &both, &memory);
    assert_eq!(pixels(&mut context), expected);
}

#[test]
fn section_2_9_buffers_take_the_place_of_memory() {
    let mut context = canvas(16, 16);
    let [vertices, elements] = context.gen_buffers(2).try_into().unwrap();
    context.bind_buffer(ARRAY_BUFFER, vertices);
    context.buffer_data(ARRAY_BUFFER, 60, Some(&interleaved()), STATIC_DRAW);
    context.bind_buffer(ELEMENT_BUFFER, elements);
    context.buffer_data(ELEMENT_BUFFER, 8, None, STATIC_DRAW);
    context.buffer_sub_data(ELEMENT_BUFFER, 1, &[3, 0, 2, 2, 0, 1]);
    set_arrays(&mut context, 0);
    context.bind_buffer(ARRAY_BUFFER, 0);
    context.draw_elements(gl::TRIANGLES, 6, gl::UNSIGNED_BYTE, 1, &NoClientMemory);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    assert_eq!(pixels(&mut context), immediate(gl::TRIANGLES, &[3, 0, 2, 2, 0, 1]));
    // What a buffer doesn't hold is nothing; it must not be read from anywhere else.
    context.draw_arrays(gl::TRIANGLES, 3, 900, &NoClientMemory);
    context.draw_elements(gl::TRIANGLES, 6, gl::UNSIGNED_INT, usize::MAX - 7, &NoClientMemory);
    pixels(&mut context);
}

#[test]
fn section_2_8_lists_hold_the_vertices_of_their_making() {
    let mut memory = Memory(interleaved());
    let mut context = canvas(16, 16);
    set_arrays(&mut context, START);
    context.new_list(1, gl::COMPILE);
    context.draw_arrays(gl::POLYGON, 0, 4, &memory);
    context.end_list();
    memory.0.fill(0);
    context.disable_client_state(VERTEX_ARRAY);
    context.call_list(1);
    assert_eq!(pixels(&mut context), immediate(gl::POLYGON, &[0, 1, 2, 3]));
}

#[test]
fn section_2_8_doubles_shorts_and_interleaved_formats_mean_the_same() {
    let expected = {
        let mut context = canvas(16, 16);
        crate::canvas::draw(
            &mut context,
            gl::TRIANGLES,
            &[[1.0, 1.0, 0.0], [14.0, 2.0, 0.0], [13.0, 13.0, 0.0]],
        );
        pixels(&mut context)
    };
    let doubles: Vec<u8> =
        PLACES.iter().flatten().flat_map(|v| f64::from(*v).to_ne_bytes()).collect();
    let shorts: Vec<u8> = PLACES.iter().flatten().flat_map(|v| (*v as i16).to_ne_bytes()).collect();
    for (data_type, bytes) in [(DOUBLE, doubles), (SHORT, shorts)] {
        let mut context = canvas(16, 16);
        context.enable_client_state(VERTEX_ARRAY);
        context.vertex_pointer(2, data_type, 0, START);
        context.multi_draw_arrays(gl::TRIANGLES, &[0], &[3], &Memory(bytes));
        assert_eq!(pixels(&mut context), expected, "{data_type:#x}");
    }
    // GL_C4UB_V2F
    let mut bytes = Vec::new();
    for (place, color) in PLACES.iter().zip(COLORS) {
        bytes.extend(color);
        bytes.extend(place.iter().flat_map(|value| value.to_ne_bytes()));
    }
    let mut context = canvas(16, 16);
    context.interleaved_arrays(0x2A22, 0, START);
    context.draw_arrays(gl::TRIANGLES, 0, 3, &Memory(bytes));
    assert_eq!(pixels(&mut context), immediate(gl::TRIANGLES, &[0, 1, 2]));
    assert!(context.is_enabled(COLOR_ARRAY) && !context.is_enabled(0x8075));
    assert_eq!(context.get_pointer(0x808E), Some(START + 4));
}

#[test]
fn section_2_9_mapping_moves_the_storage_out_and_back() {
    let mut context = canvas(16, 16);
    context.bind_buffer(ARRAY_BUFFER, 7);
    context.buffer_data(ARRAY_BUFFER, 60, None, STATIC_DRAW);
    let mut mapped = context.map_buffer(ARRAY_BUFFER, 0x88B9).unwrap();
    assert_eq!((mapped.name, mapped.storage.len()), (7, 60));
    assert!(context.map_buffer(ARRAY_BUFFER, 0x88B9).is_none());
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    set_arrays(&mut context, 0);
    context.draw_arrays(gl::QUADS, 0, 4, &NoClientMemory);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.buffer_sub_data(ARRAY_BUFFER, 0, &[1]);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    mapped.storage.copy_from_slice(&interleaved());
    assert!(context.unmap_buffer(ARRAY_BUFFER, Some(mapped.storage)));
    context.draw_arrays(gl::QUADS, 0, 4, &NoClientMemory);
    assert_eq!(pixels(&mut context), immediate(gl::QUADS, &[0, 1, 2, 3]));
    let mut last = [0; 4];
    context.get_buffer_sub_data(ARRAY_BUFFER, 56, &mut last);
    assert_eq!(last, COLORS[4]);
    context.get_buffer_sub_data(ARRAY_BUFFER, 57, &mut last);
    assert_eq!(context.get_error(), gl::INVALID_VALUE);
    context.delete_buffers(&[7]);
    assert_eq!(context.get(0x8894).unwrap().to_i32(0), 0);
    assert!(!context.is_buffer(7));
}

#[test]
fn sections_2_8_and_2_9_arguments_that_are_wrong_have_these_errors() {
    type Case = (&'static str, fn(&mut Context), u32);
    let cases: [Case; 12] = [
        ("glVertexPointer size", |c| c.vertex_pointer(1, gl::FLOAT, 0, 0), gl::INVALID_VALUE),
        ("glVertexPointer type", |c| c.vertex_pointer(3, 0x1401, 0, 0), gl::INVALID_ENUM),
        ("glColorPointer stride", |c| c.color_pointer(3, gl::FLOAT, -1, 0), gl::INVALID_VALUE),
        ("glNormalPointer", |c| c.normal_pointer(0x1401, 0, 0), gl::INVALID_ENUM),
        ("glEnableClientState", |c| c.enable_client_state(0x1234), gl::INVALID_ENUM),
        ("glDrawArrays mode", |c| c.draw_arrays(10, 0, 1, &NoClientMemory), gl::INVALID_ENUM),
        ("glDrawArrays count", |c| c.draw_arrays(0, 0, -1, &NoClientMemory), gl::INVALID_VALUE),
        ("glDrawElements", |c| c.draw_elements(0, 1, 0x1406, 0, &NoClientMemory), gl::INVALID_ENUM),
        ("glInterleavedArrays", |c| c.interleaved_arrays(1, 0, 0), gl::INVALID_ENUM),
        ("glBindBuffer", |c| c.bind_buffer(0x88EB, 1), gl::INVALID_ENUM),
        (
            "glBufferData",
            |c| c.buffer_data(ARRAY_BUFFER, 1, None, STATIC_DRAW),
            gl::INVALID_OPERATION,
        ),
        ("glUnmapBuffer", |c| assert!(!c.unmap_buffer(ARRAY_BUFFER, None)), gl::INVALID_OPERATION),
    ];
    for (name, command, error) in cases {
        let mut context = canvas(4, 4);
        command(&mut context);
        assert_eq!(context.get_error(), error, "{name}");
    }
}

#[test]
fn section_2_8_huge_counts_are_out_of_memory() {
    let mut context = canvas(4, 4);
    context.bind_buffer(ARRAY_BUFFER, 1);
    context.buffer_data(ARRAY_BUFFER, 60, Some(&interleaved()), STATIC_DRAW);
    set_arrays(&mut context, 0);
    context.draw_arrays(gl::TRIANGLES, 0, i32::MAX, &NoClientMemory);
    assert_eq!(context.get_error(), 0x0505);
    context.buffer_data(ARRAY_BUFFER, isize::MAX, None, STATIC_DRAW);
    assert_eq!(context.get_error(), 0x0505);
}

#[test]
fn table_6_7_the_client_stack_restores_arrays_with_the_active_unit() {
    const CLIENT_VERTEX_ARRAY_BIT: u32 = 2;
    const CLIENT_ACTIVE_TEXTURE: u32 = 0x84e1;
    const TEXTURE_COORD_ARRAY: u32 = 0x8078;
    let mut context = canvas(16, 16);
    context.client_active_texture(0x84c1);
    context.push_client_attrib(CLIENT_VERTEX_ARRAY_BIT);
    context.client_active_texture(0x84c2);
    context.enable_client_state(TEXTURE_COORD_ARRAY);
    context.pop_client_attrib();
    assert_eq!(context.get(CLIENT_ACTIVE_TEXTURE).unwrap().to_i32(0), 0x84c1);
    context.client_active_texture(0x84c2);
    assert_eq!(context.get(TEXTURE_COORD_ARRAY).unwrap().to_i32(0), 0);
}

#[test]
fn ext_vertex_array_switches_arrays_by_gl_enable_too() {
    let mut context = canvas(16, 16);
    context.enable(VERTEX_ARRAY);
    context.enable(COLOR_ARRAY);
    assert!(context.is_enabled(VERTEX_ARRAY) && context.is_enabled(COLOR_ARRAY));
    context.disable(COLOR_ARRAY);
    assert!(!context.is_enabled(COLOR_ARRAY));
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_2_8_a_negative_count_of_several_draws_none() {
    let bytes = interleaved();
    let memory = Memory(bytes);
    let mut context = canvas(16, 16);
    context.vertex_pointer(2, gl::FLOAT, 12, START);
    context.enable_client_state(VERTEX_ARRAY);
    context.multi_draw_arrays(gl::TRIANGLES, &[0, 0], &[3, -1], &memory);
    assert_eq!(context.get_error(), gl::INVALID_VALUE);
    context.multi_draw_elements(gl::TRIANGLES, &[3, -1], gl::UNSIGNED_BYTE, &[START; 2], &memory);
    assert_eq!(context.get_error(), gl::INVALID_VALUE);
    assert!(pixels(&mut context).iter().all(|pixel| *pixel == [0; 4]));
}

#[test]
fn ext_compiled_vertex_array_locks_once() {
    let mut context = canvas(1, 1);
    context.unlock_arrays();
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.lock_arrays(0, 0);
    assert_eq!(context.get_error(), gl::INVALID_VALUE);
    context.lock_arrays(2, 3);
    assert_eq!([0x81A8, 0x81A9].map(|name| context.get(name).unwrap().to_i32(0)), [2, 3]);
    context.lock_arrays(0, 1);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.unlock_arrays();
    assert_eq!(context.get_error(), gl::NO_ERROR);
}
