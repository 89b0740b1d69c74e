//! Bumpy balls of about so many triangles, as PLY files.

use std::f64::consts::PI;
use std::io::{BufWriter, Error, Write};
use std::path::Path;

/// Writes a ball of rings and segments within the unit ball; how many triangles it has.
pub fn write(path: &Path, rings: u32, segments: u32) -> Result<u32, Error> {
    let triangles = 2 * segments * (rings - 1);
    let mut file = BufWriter::new(std::fs::File::create(path)?);
    write!(
        file,
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\n\
         property float z\nelement face {triangles}\nproperty list uchar int vertex_indices\nend_header\n",
        segments * (rings - 1) + 2
    )?;
    let mut vertex = |ring: u32, segment: u32| -> Result<(), Error> {
        let down = PI * f64::from(ring) / f64::from(rings);
        let around = 2.0 * PI * f64::from(segment) / f64::from(segments);
        let [x, y, z] = [down.sin() * around.cos(), down.cos(), down.sin() * around.sin()];
        let bumps = 0.12 * (5.0 * x + 1.0).sin() * (6.0 * y).cos() * (4.0 * z - 2.0).sin()
            + 0.04 * (19.0 * x).sin() * (17.0 * y + 0.5).sin() * (23.0 * z).cos();
        for part in [x, y, z] {
            file.write_all(&((part * (0.8 + bumps)) as f32).to_le_bytes())?;
        }
        Ok(())
    };
    // The poles are first and last.
    vertex(0, 0)?;
    for ring in 1..rings {
        for segment in 0..segments {
            vertex(ring, segment)?;
        }
    }
    vertex(rings, 0)?;
    let mut triangle = |corners: [u32; 3]| -> Result<(), Error> {
        file.write_all(&[3])?;
        corners.iter().try_for_each(|corner| file.write_all(&corner.to_le_bytes()))
    };
    let at = |ring: u32, segment: u32| 1 + (ring - 1) * segments + segment % segments;
    let last = segments * (rings - 1) + 1;
    for segment in 0..segments {
        triangle([0, at(1, segment + 1), at(1, segment)])?;
        for ring in 1..rings - 1 {
            let [a, b] = [at(ring, segment), at(ring, segment + 1)];
            let [c, d] = [at(ring + 1, segment), at(ring + 1, segment + 1)];
            triangle([a, b, d])?;
            triangle([a, d, c])?;
        }
        triangle([at(rings - 1, segment), at(rings - 1, segment + 1), last])?;
    }
    file.flush()?;
    Ok(triangles)
}
