//! `--up`: what stands on the ground and what lies around it turn with it.

use crate::program::Folder;

/// Without an `up`, as OBJ has none.
const SCENE: &str = r#"
format = "luxel-scene"
version = 1
environment = "studio"
[[models]]
source = "z.obj"
[render]
ground = true
"#;

/// An L of two boxes, as OBJ, each corner passed through `place`.
fn letter(place: impl Fn([i32; 3]) -> [i32; 3]) -> String {
    let mut text = String::new();
    for (number, [low, high]) in [[[0, 0, 0], [4, 1, 2]], [[0, 1, 0], [1, 5, 2]]].iter().enumerate()
    {
        for corner in 0..8 {
            let [x, y, z] = place(
                [0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] }),
            );
            text += &format!("v {x} {y} {z}\n");
        }
        for face in
            [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]]
        {
            let [a, b, c, d] = face.map(|corner| corner + 8 * number);
            text += &format!("f {a} {b} {c} {d}\n");
        }
    }
    text
}

/// The pixels of a picture of 96x64.
fn pixels(folder: &Folder, model: &str, flags: &str) -> Vec<u8> {
    let line = format!("render {model} {flags} --size 96x64 --samples 1 -o out.npy");
    let run = folder.run(line.split_whitespace());
    assert_eq!(run.status, Some(0), "{line}: {}", run.stderr);
    let floats = folder.read("out.npy");
    let floats = floats[floats.len() - 96 * 64 * 16..].as_chunks::<4>().0;
    floats
        .iter()
        .map(|bytes| (f32::from_le_bytes(*bytes) * 255.0).clamp(0.0, 255.0) as u8)
        .collect()
}

#[test]
fn ground_studio_and_maps_turn_with_the_model_and_its_up() {
    let folder = Folder::new();
    folder.write("y.obj", letter(|place| place));
    folder.write("z.obj", letter(|[x, y, z]| [x, -z, y]));
    folder.write("sky.hdr", sky());
    folder.write("ground.toml", SCENE);
    let around = "--environment-background --elevation 0 --fov 90";
    for flags in [
        "--ground --background white".to_owned(),
        "--ground --ao --ao-rays 4 --shadows".to_owned(),
        format!("--reflection microfacet --environment studio {around}"),
        format!("--environment sky.hdr --environment-rotation 70 --exposure auto {around}"),
    ] {
        let upright = pixels(&folder, "y.obj", &flags);
        let turned = pixels(&folder, "z.obj", &format!("{flags} --up Z"));
        let lying = pixels(&folder, "z.obj", &flags);
        // Sums in another order: a step here and there, and edges.
        let far =
            |other: &[u8]| upright.iter().zip(other).filter(|(a, b)| a.abs_diff(**b) > 2).count();
        assert!(far(&turned) < 200, "{flags}: {} numbers differ", far(&turned));
        assert!(far(&lying) > 1000, "{flags}: {} numbers differ", far(&lying));
    }
    let flags = "--environment-background --elevation 10";
    let upright = pixels(&folder, "y.obj", &format!("--ground --environment studio {flags}"));
    let turned = pixels(&folder, "ground.toml", &format!("{flags} --up Z"));
    let far = upright.iter().zip(&turned).filter(|(a, b)| a.abs_diff(**b) > 2).count();
    assert!(far < 200, "a scene file's ground and studio: {far} numbers differ");
}

/// A map of 8x4 texels, each row and column of another colour.
fn sky() -> Vec<u8> {
    let mut bytes = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n".to_vec();
    for row in 0..4_u8 {
        for column in 0..8_u8 {
            bytes.extend([60 * row + 20, 30 * column + 20, 128, 128]);
        }
    }
    bytes
}
