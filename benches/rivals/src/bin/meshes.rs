//! Writes the meshes of the comparisons, bumpy balls, each as NAME.ply and NAME.bin.
//!
//!     cargo run --release --bin meshes FOLDER [1k|10k|100k|1m|5m...]

use luxel_rivals::ball::{BALLS, ball};
use luxel_rivals::{write_bin, write_ply};
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [folder, names @ ..] = &arguments[..] else {
        return Err("usage: meshes FOLDER [1k|10k|100k|1m|5m...]".into());
    };
    if let Some(name) = names.iter().find(|name| BALLS.iter().all(|(known, ..)| known != name)) {
        return Err(format!("no such mesh: {name}").into());
    }
    std::fs::create_dir_all(folder)?;
    for (name, rings, segments) in BALLS {
        if names.is_empty() || names.iter().any(|asked| asked == name) {
            let mesh = ball(rings, segments);
            let path = Path::new(folder).join(name);
            write_ply(&mesh, &path.with_extension("ply"))?;
            write_bin(&mesh, &path.with_extension("bin"))?;
        }
    }
    Ok(())
}
