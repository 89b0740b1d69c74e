//! Meshes and their files: CHM1, as src/main.rs says, and PLY.

use std::error::Error;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Triangles, by positions and normals.
pub struct Mesh {
    pub positions: Vec<[f32; 3]>,
    pub normals: Vec<[f32; 3]>,
    pub triangles: Vec<[u32; 3]>,
}

/// Reads a CHM1 file.
pub fn read(path: &str) -> Result<Mesh, Box<dyn Error>> {
    let bytes = std::fs::read(path)?;
    if !bytes.starts_with(b"CHM1") {
        return Err("no CHM1 mesh".into());
    }
    let word = |at: usize| {
        bytes.get(at..at + 4).and_then(|word| word.try_into().ok()).map(u32::from_le_bytes)
    };
    let count = |at| word(at).map(|count| count as usize).ok_or("too short");
    let (vertices, triangles) = (count(4)?, count(8)?);
    let triple = |at: usize| Some([word(at)?, word(at + 4)?, word(at + 8)?]);
    let vectors = |from: usize| {
        let at = (0..vertices).map(|at| triple(from + 12 * at));
        at.map(|vector| vector.map(|words| words.map(f32::from_bits))).collect::<Option<_>>()
    };
    let corners = (0..triangles).map(|at| triple(12 + 24 * vertices + 12 * at));
    let positions = vectors(12).ok_or("too short")?;
    let normals = vectors(12 + 12 * vertices).ok_or("too short")?;
    let triangles = corners.collect::<Option<_>>().ok_or("too short")?;
    Ok(Mesh { positions, normals, triangles })
}

/// Writes a CHM1 file.
pub fn write_bin(mesh: &Mesh, path: &Path) -> io::Result<()> {
    let mut file = BufWriter::new(std::fs::File::create(path)?);
    file.write_all(b"CHM1")?;
    for count in [mesh.positions.len(), mesh.triangles.len()] {
        file.write_all(&(count as u32).to_le_bytes())?;
    }
    for vectors in [&mesh.positions, &mesh.normals] {
        vectors.as_flattened().iter().try_for_each(|part| file.write_all(&part.to_le_bytes()))?;
    }
    let corners = mesh.triangles.as_flattened();
    corners.iter().try_for_each(|corner| file.write_all(&corner.to_le_bytes()))?;
    file.flush()
}

/// Writes a binary PLY file with normals.
pub fn write_ply(mesh: &Mesh, path: &Path) -> io::Result<()> {
    let mut file = BufWriter::new(std::fs::File::create(path)?);
    writeln!(
        file,
        "ply\nformat binary_little_endian 1.0\nelement vertex {}",
        mesh.positions.len()
    )?;
    for name in ["x", "y", "z", "nx", "ny", "nz"] {
        writeln!(file, "property float {name}")?;
    }
    writeln!(file, "element face {}", mesh.triangles.len())?;
    writeln!(file, "property list uchar int vertex_indices\nend_header")?;
    for part in
        mesh.positions.iter().zip(&mesh.normals).flat_map(|(at, normal)| [at, normal]).flatten()
    {
        file.write_all(&part.to_le_bytes())?;
    }
    for triangle in &mesh.triangles {
        file.write_all(&[3])?;
        triangle.iter().try_for_each(|corner| file.write_all(&corner.to_le_bytes()))?;
    }
    file.flush()
}
