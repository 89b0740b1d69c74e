//! Why a pixel of a demo has its colour, as text and as JSON:
//! `cargo run --release -p luxel --example explain [DEMO [X Y]]`

use luxel::prelude::*;
use luxel::render::{At, Unseen};
use luxel::report::Report;
use luxel::scene::demos;
use std::error::Error;
use std::sync::Arc;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let name = args.next().unwrap_or_else(|| "teapot".to_owned());
    let mut side = |default: u32| args.next().map_or(Ok(default), |text| text.parse());
    let pixel = [side(320)?, side(180)?];
    let scene = Arc::new(demos::demo(&name).ok_or("there is no such demo")?);

    let view = default_view(&scene, Size { width: 640, height: 360 });
    let renderer = Renderer::new(Arc::clone(&scene), &Execution::default())?;
    let explanation = renderer.explain(&view, At::Pixel(pixel))?;
    let unseen = Unseen::new(&renderer, &view, &explanation)?;

    let report = Report::new(&explanation, &scene, &view).with_model(&name).with_unseen(&unseen);
    print!("{}", report.to_text());
    println!("{}", report.to_json());
    Ok(())
}
