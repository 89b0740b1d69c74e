//! Arrays in memory and in buffers, elements, evaluators.

use super::Numbers;
use luxel_gl::{ClientMemory, Context};

const ARRAY: u32 = 0x8892;
const TARGETS: &[u32] = &[ARRAY, ARRAY, 0x8893];
const USAGE: u32 = 0x88e4;
const ARRAYS: &[u32] =
    &[0x8074, 0x8074, 0x8074, 0x8075, 0x8076, 0x8077, 0x8078, 0x8079, 0x8457, 0x845e];
const TYPES: &[u32] = &[0x1400, 0x1401, 0x1402, 0x1403, 0x1404, 0x1405, 0x1406, 0x140a];
const MAPS: &[u32] = &[0x0d90, 0x0d92, 0x0d93, 0x0d94, 0x0d96, 0x0d97, 0x0d98];

/// Small floats and bytes, whatever the address is.
struct Memory(Vec<u8>);

impl Memory {
    fn new(n: &mut Numbers) -> Self {
        Self((0..1024).flat_map(|_| n.place().to_ne_bytes()).collect())
    }
}

impl ClientMemory for Memory {
    fn bytes(&self, address: usize, length: usize) -> &[u8] {
        let start = (address % 64).min(self.0.len());
        &self.0[start..(start + length).min(self.0.len())]
    }
}

/// Places are taken from a buffer.
pub(super) fn prepare(context: &mut Context) {
    let mut numbers = Numbers(77);
    let data: Vec<u8> = (0..600).flat_map(|_| numbers.unit().to_ne_bytes()).collect();
    context.bind_buffer(ARRAY, 1);
    context.buffer_data(ARRAY, data.len() as isize, Some(&data), USAGE);
    context.vertex_pointer(3, 0x1406, 0, 0);
    context.enable_client_state(0x8074);
}

/// One command on arrays or maps with its arguments.
pub(super) fn command(context: &mut Context, n: &mut Numbers, answers: &mut Vec<u64>) {
    let memory = Memory::new(n);
    let mode = n.of(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
    match n.below(24) {
        0..=1 => context.bind_buffer(n.of(TARGETS), n.below(4)),
        2 => {
            let data: Vec<u8> = (0..n.below(400)).flat_map(|_| n.unit().to_ne_bytes()).collect();
            let size = data.len() as isize + if n.below(4) == 0 { 9 } else { 0 };
            let data = (n.below(5) != 0).then_some(&data[..]);
            context.buffer_data(n.of(TARGETS), size, data, USAGE + n.below(8));
        }
        3 => {
            let offset = n.below(900) as isize - 20;
            let bytes: Vec<u8> = (0..n.below(40)).map(|_| n.next() as u8).collect();
            context.buffer_sub_data(n.of(TARGETS), offset, &bytes);
            let mut read = [0; 8];
            context.get_buffer_sub_data(n.of(TARGETS), offset, &mut read);
            answers.push(u64::from_le_bytes(read));
        }
        4 => {
            let target = n.of(TARGETS);
            let mapped = context.map_buffer(target, 0x88b8 + n.below(3));
            let mut storage = mapped.map(|mapped| mapped.storage);
            if n.below(3) == 0 {
                context.draw_arrays(mode, 0, 9, &memory);
            }
            if let Some(byte) = storage.as_mut().and_then(|bytes| bytes.first_mut()) {
                *byte = byte.wrapping_add(1);
            }
            answers.push(context.unmap_buffer(target, storage).into());
        }
        5 => context.delete_buffers(&[n.below(4)]),
        6..=8 => {
            let (size, data_type) = (n.below(5) as i32, n.of(TYPES));
            let (stride, pointer) = (n.below(20) as i32 - 1, n.below(300) as usize);
            match n.below(9) {
                0..=2 => context.vertex_pointer(size, data_type, stride, pointer),
                3 => context.normal_pointer(data_type, stride, pointer),
                4 => context.color_pointer(size, data_type, stride, pointer),
                5 => context.secondary_color_pointer(size, data_type, stride, pointer),
                6 => context.edge_flag_pointer(stride, pointer),
                7 => context.fog_coord_pointer(data_type, stride, pointer),
                _ => {
                    context.client_active_texture(0x84c0 + n.below(3));
                    context.tex_coord_pointer(size, data_type, stride, pointer);
                }
            }
        }
        9 => context.enable_client_state(n.of(ARRAYS)),
        10 => context.disable_client_state(n.of(&ARRAYS[3..])),
        11 => prepare(context),
        12 => context.interleaved_arrays(0x2a20 + n.below(14), n.below(40) as i32, 16),
        13..=14 => {
            let [first, count] = [n.below(40), n.below(60)].map(|value| value as i32 - 1);
            context.draw_arrays(mode, first, count, &memory);
        }
        15..=16 => {
            let (count, data_type) = (n.below(40) as i32 - 1, n.of(&[0x1401, 0x1403, 0x1405]));
            context.draw_elements(mode, count, data_type, n.below(200) as usize, &memory);
        }
        17 => {
            context.begin(mode);
            for _ in 0..n.below(9) {
                context.array_element(n.below(60) as i32 - 1, &memory);
            }
            context.end();
        }
        18 => match n.below(2) {
            0 => context.push_client_attrib(n.next()),
            _ => context.pop_client_attrib(),
        },
        19 => {
            let points: Vec<f64> = (0..80).map(|_| n.place().into()).collect();
            let (target, order) = (n.of(MAPS), n.below(6) as i32);
            let domain = [f64::from(n.unit()), f64::from(n.unit())];
            context.map_1(target, domain, 4, order, &points);
            context.enable(target);
        }
        20 => {
            let points: Vec<f64> = (0..80).map(|_| n.place().into()).collect();
            let target = n.of(MAPS) + 0x20;
            let order = [n.below(4) as i32, n.below(5) as i32];
            let domain = [[f64::from(n.unit()), f64::from(n.unit())], [0.0, 1.0]];
            context.map_2(target, domain, [4, 16], order, &points);
            context.enable(target);
        }
        21 => {
            context.map_grid_1(n.below(9) as i32, [n.unit(), n.unit()]);
            let steps = [n.below(9) as i32, n.below(9) as i32];
            context.map_grid_2(steps, [[n.unit(), n.unit()], [0.0, 1.0]]);
        }
        22 => {
            let [from, to] = [n.below(9), n.below(9)].map(|step| step as i32);
            context.eval_mesh_1(0x1b00 + n.below(3), [from, to]);
            context.eval_mesh_2(0x1b00 + n.below(3), [from, to], [0, n.below(6) as i32]);
        }
        _ => {
            context.begin(mode);
            for _ in 0..n.below(7) {
                context.eval_coord_1(n.unit());
                context.eval_coord_2([n.unit(), n.unit()]);
                context.eval_point_2([n.below(9) as i32, n.below(9) as i32]);
            }
            context.end();
        }
    }
}
