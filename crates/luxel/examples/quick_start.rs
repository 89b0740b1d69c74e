//! A picture of a model file, or of the built-in teapot:
//! `cargo run --release -p luxel --example quick_start [MODEL [PICTURE.png]]`

use luxel::prelude::*;
use luxel::scene::demos;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let scene = match args.next() {
        Some(path) => load(path)?.scene,
        None => demos::demo("teapot").ok_or("the teapot is missing")?,
    };
    let path = args.next().map_or_else(|| std::env::temp_dir().join("luxel.png"), Into::into);

    // The default view, on another background.
    let mut view = default_view(&scene, Size { width: 640, height: 360 });
    view.background = [0.02, 0.02, 0.025, 1.0].into();
    let renderer = Renderer::new(scene, &Execution::default())?;
    let picture = renderer.rgba8(&view)?;
    picture.save(&path)?;
    println!("{} triangles drawn to {}", renderer.scene().triangle_count(), path.display());
    Ok(())
}
