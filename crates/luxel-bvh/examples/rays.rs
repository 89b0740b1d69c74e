//! Rays against a mesh: closest hits in batches as an image of characters, shadow rays, all hits.
//!
//! `cargo run --release -p luxel-bvh --example rays`

use luxel_bvh::{Bvh, MeshRays, Quality, Ray, TooManyForTree};

/// A height field of two triangles per cell, from -1 to 1 along x and y.
fn hills(side: u32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let at = |step: u32| step as f32 / (side - 1) as f32 * 2.0 - 1.0;
    let bump = |x: f32, y: f32| (1.0 - 6.0 * (x * x + y * y)).max(0.0);
    let position = |vertex: u32| {
        let (x, y) = (at(vertex % side), at(vertex / side));
        [x, y, 0.6 * bump(x + 0.3, y) + 0.3 * bump(x - 0.5, y - 0.3)]
    };
    let cells = (0..side * (side - 1)).filter(|vertex| vertex % side != side - 1);
    let triangles = cells.flat_map(|a| {
        let [b, c, d] = [a + 1, a + side + 1, a + side];
        [[a, b, c], [a, c, d]]
    });
    ((0..side * side).map(position).collect(), triangles.collect())
}

fn main() -> Result<(), TooManyForTree> {
    const COLUMNS: u16 = 64;
    const ROWS: u16 = 24;
    let (positions, triangles) = hills(120);
    let bvh = Bvh::build(&positions, &triangles, Quality::Thorough)?;
    println!("{} triangles, {} KiB, {} levels", bvh.triangles(), bvh.memory() / 1024, bvh.depth());
    let rays = MeshRays::new(&bvh, &positions);

    // One ray per character, straight down. Rays in the order of an image run close together.
    let mut down = Vec::new();
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let x = (f32::from(column) + 0.5) / f32::from(COLUMNS) * 2.0 - 1.0;
            let y = 1.0 - (f32::from(row) + 0.5) / f32::from(ROWS) * 2.0;
            down.push(Ray::new([x, y, 2.0], [0.0, 0.0, -1.0]));
        }
    }
    let hits = rays.closest_of_each(&down);

    // From each hit a shadow ray to the light, beginning a little above the surface.
    let light = [-0.9, 0.9, 0.7];
    let shadow = |(ray, hit): (&Ray, &Option<luxel_bvh::RayHit>)| {
        let t = hit.map_or(0.0, |hit| hit.t);
        let point: [f32; 3] =
            std::array::from_fn(|axis| ray.origin[axis] + ray.direction[axis] * t);
        Ray { range: [1e-3, 1.0], ..Ray::between(point, light) }
    };
    let shadows = rays.any_of_each(&down.iter().zip(&hits).map(shadow).collect::<Vec<_>>());
    let symbols: String = hits
        .iter()
        .zip(&shadows)
        .map(|(hit, is_dark)| match hit {
            None => ' ',
            Some(_) if *is_dark => '.',
            Some(hit) if hit.t < 1.7 => '#',
            Some(_) => '+',
        })
        .collect();
    for row in 0..usize::from(ROWS) {
        let columns = usize::from(COLUMNS);
        println!("{}", &symbols[row * columns..(row + 1) * columns]);
    }
    println!(
        "{} of {} points lie in shadow",
        shadows.iter().filter(|dark| **dark).count(),
        hits.len()
    );

    // One ray through both hills: every surface that it passes.
    let across = Ray::new([-2.0, 0.1, 0.15], [1.0, 0.03, 0.0]);
    for hit in rays.all(&across) {
        println!("at t = {:.3}: triangle {}, {:.2?}", hit.t, hit.triangle, hit.barycentric);
    }
    // The same answers, one ray at a time.
    assert_eq!(rays.closest(&across), rays.all(&across).first().copied());
    assert!(rays.any(&across));
    Ok(())
}
