//! A picture with its depth, normals and ids from one pass, as a training set wants them:
//! `cargo run --release -p luxel --example layers [MODEL [OUT.exr]]`

use luxel::prelude::*;
use luxel::render::{LayerImage, LayerValues, Picture, PictureFormat, write_layers};
use luxel::scene::demos;
use std::collections::BTreeMap;
use std::error::Error;
use std::fs::File;
use std::io::BufWriter;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let scene = match args.next() {
        Some(path) => load(path)?.scene,
        None => demos::demo("spheres").ok_or("the spheres are missing")?,
    };
    let path =
        args.next().map_or_else(|| std::env::temp_dir().join("luxel-layers.exr"), Into::into);

    let view = default_view(&scene, Size { width: 224, height: 224 }).with_samples(1);
    let layers = [Layer::Z, Layer::Normal, Layer::Object, Layer::Triangle];
    let renderer = Renderer::new(scene, &Execution::default())?;
    let mut picture = Picture::default();
    let mut values = Vec::new();
    renderer.rgba8_with_layers(&view, &layers, &mut picture, &mut values)?;

    // How many pixels each object has, by the layer of objects.
    let mut pixels: BTreeMap<u32, usize> = BTreeMap::new();
    if let Some(LayerValues::U32(objects)) = values.get(2) {
        for &object in objects.iter().filter(|&&object| object != u32::MAX) {
            *pixels.entry(object).or_default() += 1;
        }
    }
    for (object, count) in pixels {
        let node = renderer.objects()[object as usize].node;
        println!("{count:6} pixels of {}", renderer.scene().nodes[node.index()].name);
    }

    let images = layers.iter().zip(values).map(|(layer, values)| LayerImage {
        name: layer.name(),
        channels: layer.channels(),
        values,
    });
    let images: Vec<LayerImage> = images.collect();
    let mut out = BufWriter::new(File::create(&path)?);
    write_layers(PictureFormat::Exr, picture.size, &images, &mut out)?;
    println!("{} layers written to {}", images.len(), path.display());
    Ok(())
}
