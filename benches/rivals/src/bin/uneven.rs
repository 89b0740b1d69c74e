//! Writes a mesh that is hard on trees, in the unit ball: a coarse ball, three tiny fine ones on it,
//! and a hundred thousand long thin triangles in all directions.
//!
//!     cargo run --release --bin uneven FILE.bin

use std::f32::consts::{PI, TAU};

#[derive(Default)]
struct Mesh {
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// A ball of rings from pole to pole.
    fn ball(&mut self, centre: [f32; 3], radius: f32, rings: u32, around: u32) {
        let first = self.positions.len() as u32;
        for ring in 0..=rings {
            let (height, width) = (PI * ring as f32 / rings as f32).cos_sin();
            for step in 0..around {
                let (x, y) = (TAU * step as f32 / around as f32).cos_sin();
                let at = [x * width, y * width, height];
                self.positions.push(std::array::from_fn(|axis| centre[axis] + radius * at[axis]));
            }
        }
        for ring in 0..rings {
            for step in 0..around {
                let at = |ring: u32, step: u32| first + ring * around + step % around;
                let (a, b) = (at(ring, step), at(ring, step + 1));
                let (c, d) = (at(ring + 1, step), at(ring + 1, step + 1));
                self.triangles.extend([[a, c, b], [b, c, d]]);
            }
        }
    }
}

trait CosSin {
    fn cos_sin(self) -> (f32, f32);
}

impl CosSin for f32 {
    fn cos_sin(self) -> (f32, f32) {
        (self.cos(), self.sin())
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("usage: uneven FILE.bin")?;
    let mut mesh = Mesh::default();
    mesh.ball([0.0; 3], 0.6, 16, 24);
    for centre in [[0.0, 0.1, 0.62], [-0.3, 0.2, 0.5], [0.4, -0.3, 0.4]] {
        mesh.ball(centre, 0.02, 200, 250);
    }
    let mut state = 1_u64;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1 << 23) as f32 - 1.0
    };
    for _ in 0..100_000 {
        let first = mesh.positions.len() as u32;
        let middle: [f32; 3] = std::array::from_fn(|_| 0.5 * next());
        let way: [f32; 3] = std::array::from_fn(|_| 0.03 * next());
        mesh.positions.push(std::array::from_fn(|axis| middle[axis] - way[axis]));
        mesh.positions.push(std::array::from_fn(|axis| middle[axis] + way[axis]));
        mesh.positions.push(std::array::from_fn(|axis| middle[axis] + way[axis] + 3e-4 * next()));
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    let mut bytes = b"CHM1".to_vec();
    bytes.extend((mesh.positions.len() as u32).to_le_bytes());
    bytes.extend((mesh.triangles.len() as u32).to_le_bytes());
    bytes.extend(mesh.positions.as_flattened().iter().flat_map(|value| value.to_le_bytes()));
    bytes.resize(bytes.len() + 12 * mesh.positions.len(), 0);
    bytes.extend(mesh.triangles.as_flattened().iter().flat_map(|value| value.to_le_bytes()));
    std::fs::write(path, bytes)?;
    Ok(())
}
