//! A model turns once around, a picture every 30 degrees, in the memory of one:
//! `cargo run --release -p luxel --example turntable [MODEL [FOLDER]]`

use luxel::prelude::*;
use luxel::render::Picture;
use luxel::scene::{Viewpoint, demos, fit_view};
use std::error::Error;
use std::path::PathBuf;
use std::sync::Arc;

const PICTURES: u32 = 12;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let scene = match args.next() {
        Some(path) => load(path)?.scene,
        None => demos::demo("teapot").ok_or("the teapot is missing")?,
    };
    let folder = args.next().map_or_else(std::env::temp_dir, PathBuf::from);

    // The renderer shares the scene, which stays at hand for fitting cameras.
    let scene = Arc::new(scene);
    let renderer = Renderer::new(Arc::clone(&scene), &Execution::default())?;
    let size = Size { width: 320, height: 240 };
    let mut view = default_view(&scene, size);
    let mut picture = Picture::default();
    for number in 0..PICTURES {
        let azimuth_radians = std::f64::consts::TAU * f64::from(number) / f64::from(PICTURES);
        let viewpoint = Viewpoint { up: scene.up, azimuth_radians, elevation_radians: 0.35 };
        let lens = Lens::Perspective { fov_y_radians: 0.8 };
        view.camera = fit_view(&scene, &viewpoint, lens, size);
        renderer.rgba8_into(&view, &mut picture)?;
        picture.save(folder.join(format!("luxel-turntable_{number:02}.png")))?;
    }
    println!("{PICTURES} pictures drawn to {}", folder.display());
    Ok(())
}
