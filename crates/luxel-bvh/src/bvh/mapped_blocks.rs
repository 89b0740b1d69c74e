//! Vertices of blocks in lanes, in trees over meshes.

use super::Bvh;
use crate::build::Quality;
use crate::tree::{Block, Node, VertexMap, VertexRows, WIDTH};
use luxel_math::{Level, Simd, dispatch_long, f32x8, prelude::*};

/// The lanes of a block's vertices.
struct Identity;

impl VertexMap<3> for Identity {
    #[inline(always)]
    fn map<S: Simd>(&self, position: [f32x8<S>; 3]) -> [f32x8<S>; 3] {
        position
    }
}

#[test]
fn rows_are_zero_beyond_their_vertices_and_corners_are_those_of_the_mesh() {
    let place = |at: u32| [at as f32 + 1.0, (at as f32 * 0.7).fract() + 2.0, (at % 7) as f32 + 3.0];
    let positions: Vec<[f32; 3]> = (0..600).map(place).collect();
    let strip: Vec<[u32; 3]> = (0..598).map(|at| [at, at + 1, at + 2]).collect();
    let apart: Vec<[u32; 3]> = (0..200).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]).collect();
    for triangles in [strip, apart] {
        let bvh = Bvh::build(&positions, &triangles, Quality::Thorough).expect("there are few");
        bvh.view().visit_blocks(Node::occupied, |block| {
            let numbers = block.header().rows() == VertexRows::Numbers;
            let [rows, corners] = lanes(block, &positions, !numbers);
            let length = block.header().row_length();
            assert!(rows.as_flattened().iter().all(|row| row[length..] == [0.0; 8][length..]));
            for lane in 0..block.count() {
                let expected = block.corners(lane, &positions);
                let found = [0, 1, 2].map(|corner| corners[corner].map(|row| row[lane]));
                assert_eq!(found, expected);
            }
        });
    }
}

/// The first vertices and all corners of a block, at the baseline.
fn lanes(block: Block<'_>, positions: &[[f32; 3]], rows: bool) -> [[[[f32; WIDTH]; 3]; 3]; 2] {
    let mut stored = [[[[0.0; WIDTH]; 3]; 3]; 2];
    dispatch_long!(Level::baseline(), simd => {
        let corners = block.map_corners(simd, positions, &Identity);
        for corner in 0..3 {
            for axis in 0..3 {
                corners[corner][axis].store_slice(&mut stored[1][corner][axis]);
            }
        }
        if rows {
            let vertices = block.vertices(simd, 0);
            for axis in 0..3 {
                vertices[axis].store_slice(&mut stored[0][0][axis]);
            }
        }
    });
    stored
}
