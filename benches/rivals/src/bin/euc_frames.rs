//! Frames of a mesh drawn by euc: what luxel is timed beside.
//!
//!     RUSTFLAGS="-C target-cpu=native" cargo run --release --bin euc_frames -- \
//!         MESH.bin 640x480 none|back FRAMES LIGHTS [PICTURE.ppm]
//!
//! The scene is that of gl/frames.c, with the same equation for each pixel; but euc doesn't tell which
//! side of a triangle it draws, so where both are drawn each pixel's normal is turned to the eye. It has
//! one thread, and without the processor's own instructions for a fused multiplication and addition
//! calls a function for each.
//! Prints the median and the least milliseconds from clearing to the last pixel.

use euc::rasterizer::{BackfaceCullingDisabled, BackfaceCullingEnabled, Triangles};
use euc::{Pipeline, Target, buffer::Buffer2d};
use luxel_rivals::{Mesh, read};
use std::error::Error;
use std::f32::consts::{SQRT_2, TAU};
use std::time::Instant;
use vek::{Rgb, Vec3};

/// The mesh, turned about y, before an eye 3 away.
struct Scene<'a> {
    mesh: &'a Mesh,
    turn: (f32, f32),
    /// How much larger a distance from the middle of the window is there than at depth one.
    scale: (f32, f32),
    both_sides: bool,
    /// Lights beside the one far away.
    points: u32,
}

impl Scene<'_> {
    fn turned(&self, [x, y, z]: [f32; 3]) -> Vec3<f32> {
        let (cos, sin) = self.turn;
        Vec3::new(cos * x + sin * z, y, cos * z - sin * x)
    }
}

impl Pipeline for Scene<'_> {
    type Vertex = u32;
    /// The place and the normal, as the eye has them.
    type VsOut = (Vec3<f32>, Vec3<f32>);
    type Pixel = u32;

    #[inline(always)]
    fn vert(&self, &vertex: &u32) -> ([f32; 4], Self::VsOut) {
        let at = self.turned(self.mesh.positions[vertex as usize]) - Vec3::new(0.0, 0.0, 3.0);
        let normal = self.turned(self.mesh.normals[vertex as usize]);
        let depth = (-10.1 * at.z - 2.0) / 9.9;
        ([self.scale.0 * at.x, self.scale.1 * at.y, depth, -at.z], (at, normal))
    }

    #[inline(always)]
    fn frag(&self, &(at, normal): &Self::VsOut) -> u32 {
        let view = -at.normalized();
        let normal = normal.normalized();
        let normal = if self.both_sides && normal.dot(view) < 0.0 { -normal } else { normal };
        let base = Rgb::new(0.8, 0.7, 0.6);
        let from_far = Vec3::new(0.4, 0.6, 1.0).normalized();
        let mut sum = base * 0.1 + reflected(base, normal, view, from_far) * 0.6;
        for number in 0..self.points {
            let x = if number & 1 == 0 { -1.5 } else { 1.5 };
            let y = if number & 2 == 0 { -1.2 } else { 1.2 };
            let way = Vec3::new(x, y, -1.5) - at;
            let distance = way.magnitude();
            let strength = 0.3 / (1.0 + 0.1 * distance + 0.05 * distance * distance);
            sum += reflected(base, normal, view, way / distance) * strength;
        }
        let [red, green, blue] = sum.map(|value| (value.min(1.0) * 255.0 + 0.5) as u8).into_array();
        u32::from_le_bytes([red, green, blue, 255])
    }
}

/// Light of strength one, by Blinn and Phong.
#[inline(always)]
fn reflected(base: Rgb<f32>, normal: Vec3<f32>, view: Vec3<f32>, light: Vec3<f32>) -> Rgb<f32> {
    let cos = normal.dot(light);
    if cos <= 0.0 {
        return Rgb::new(0.0, 0.0, 0.0);
    }
    let half = (light + view).normalized();
    base * cos + 0.4 * normal.dot(half).max(0.0).powi(32)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [path, size, cull, frames, lights, picture @ ..] = &arguments[..] else {
        return Err("usage: euc_frames MESH.bin WxH none|back FRAMES LIGHTS [PICTURE.ppm]".into());
    };
    let (width, height) = size.split_once('x').ok_or("no size")?;
    let (width, height): (usize, usize) = (width.parse()?, height.parse()?);
    let (frames, lights): (u32, u32) = (frames.parse()?, lights.parse()?);
    if frames == 0 || !(1..=5).contains(&lights) {
        return Err("at least one frame, one to five lights".into());
    }
    let both_sides = cull != "back";
    let mesh = read(path)?;
    let corners = mesh.triangles.as_flattened();
    let mut colors = Buffer2d::new([width, height], 0);
    let mut depths = Buffer2d::new([width, height], f32::INFINITY);
    let tall = 1.0 + SQRT_2;
    let scale = (tall * height as f32 / width as f32, tall);
    let mut draw = |frame: u32| {
        let start = Instant::now();
        let (sin, cos) = (TAU * frame as f32 / frames as f32).sin_cos();
        let (turn, points) = ((cos, sin), lights - 1);
        let scene = Scene { mesh: &mesh, turn, scale, both_sides, points };
        colors.clear(0);
        depths.clear(f32::INFINITY);
        let depths = Some(&mut depths);
        if both_sides {
            scene.draw::<Triangles<_, BackfaceCullingDisabled>, _>(corners, &mut colors, depths);
        } else {
            scene.draw::<Triangles<_, BackfaceCullingEnabled>, _>(corners, &mut colors, depths);
        }
        start.elapsed().as_secs_f64() * 1e3
    };
    for frame in 0..=frames / 10 {
        draw(frame);
    }
    let mut times: Vec<f64> = (0..frames).map(&mut draw).collect();
    times.sort_by(f64::total_cmp);
    println!("{:.3} ms, least {:.3}, euc", times[times.len() / 2], times[0]);
    if let [picture, ..] = picture {
        draw(0);
        let mut bytes = format!("P6\n{width} {height}\n255\n").into_bytes();
        bytes.extend(
            colors.as_ref().iter().flat_map(|color| color.to_le_bytes().into_iter().take(3)),
        );
        std::fs::write(picture, bytes)?;
    }
    Ok(())
}
