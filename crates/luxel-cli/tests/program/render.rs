//! `luxel render`: images and layers in every format.

use crate::program::{Folder, SQUARE_PLY, luxel};
use serde_json::Value;
use std::io::Cursor;

/// A camera in which the square of `SQUARE_PLY` fills the middle half of the window.
const CAMERA: &str = "--size 64x64 --eye .5,.5,5 --target .5,.5,0 --ortho 2";
const WHITE: &str = "--light directional:dir=0,0,-1 --color 1,1,1 --reflection lambert";

fn square(flags: &str) -> Folder {
    let folder = Folder::new();
    folder.write("square.ply", SQUARE_PLY);
    let line = format!("render square.ply {CAMERA} {WHITE} {flags}");
    folder.run(line.split_whitespace()).done();
    folder
}

/// Width, height and bytes of a PNG.
fn png(bytes: &[u8]) -> (u32, u32, Vec<u8>, png::OutputInfo) {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    (info.width, info.height, pixels, info)
}

/// The shape, the kind and the data of an NPY.
fn npy(bytes: &[u8]) -> (String, &[u8]) {
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let length = u16::from_le_bytes([bytes[8], bytes[9]]) as usize;
    let header = String::from_utf8(bytes[10..10 + length].to_vec()).unwrap();
    (header, &bytes[10 + length..])
}

#[test]
fn a_white_surface_facing_a_unit_light_is_white_on_transparent_black() {
    let folder = square("-o a.png --samples 1");
    let (width, height, pixels, _) = png(&folder.read("a.png"));
    assert_eq!((width, height), (64, 64));
    let pixel = |x: usize, y: usize| &pixels[4 * (y * 64 + x)..][..4];
    for (x, y) in [(16, 16), (47, 47), (32, 32), (16, 47)] {
        assert_eq!(pixel(x, y), [255; 4], "({x}, {y})");
    }
    for (x, y) in [(15, 16), (16, 15), (48, 47), (47, 48), (0, 0)] {
        assert_eq!(pixel(x, y), [0; 4], "({x}, {y})");
    }
}

#[test]
fn half_the_light_is_encoded_by_srgb_or_linearly() {
    let at = |flags: &str| {
        let folder = square(&format!("-o a.ppm --color .5,.5,.5 {flags}"));
        let bytes = folder.read("a.ppm");
        assert!(bytes.starts_with(b"P6\n64 64\n255\n"));
        bytes[bytes.len() - 64 * 64 * 3..][3 * (32 * 64 + 32)]
    };
    assert_eq!(at(""), 188);
    assert_eq!(at("--encoding none"), 128);
}

#[test]
fn a_background_fills_what_nothing_covers() {
    let folder = square("-o a.png --background 1,0,0");
    let (_, _, pixels, _) = png(&folder.read("a.png"));
    assert_eq!(pixels[..4], [255, 0, 0, 255]);
}

#[test]
fn sixteen_bits_are_finer_than_eight() {
    let folder = square("-o a.png --bits 16 --color .5,.5,.5 --encoding none");
    let (_, _, pixels, info) = png(&folder.read("a.png"));
    assert_eq!(info.bit_depth, png::BitDepth::Sixteen);
    let place = 8 * (32 * 64 + 32);
    assert_eq!(u16::from_be_bytes([pixels[place], pixels[place + 1]]), 32_768);
}

#[test]
fn exr_and_npy_have_linear_light() {
    let folder = square("-o a.npy --color .25,2,.5");
    let bytes = folder.read("a.npy");
    let (header, data) = npy(&bytes);
    assert!(header.contains("'<f4'") && header.contains("(64, 64, 4)"), "{header}");
    let place = 16 * (32 * 64 + 32);
    let values: Vec<_> = data[place..place + 16]
        .chunks(4)
        .map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap()))
        .collect();
    assert_eq!(values, [0.25, 2.0, 0.5, 1.0]);
}

#[test]
fn layers_sample_depth_and_ids_at_the_pixel_centre() {
    let folder = square("-o depth.npy --layer depth --near 4 --far 8");
    let bytes = folder.read("depth.npy");
    let (header, data) = npy(&bytes);
    assert!(header.contains("'<f4'") && header.contains("(64, 64)"), "{header}");
    let depth =
        |x: usize, y: usize| f32::from_le_bytes(data[4 * (y * 64 + x)..][..4].try_into().unwrap());
    assert!((depth(32, 32) - 0.25).abs() < 1e-6, "{}", depth(32, 32));
    assert_eq!(depth(0, 0), 1.0);

    let folder = square("-o triangle.npy --layer triangle");
    let bytes = folder.read("triangle.npy");
    let (header, data) = npy(&bytes);
    assert!(header.contains("'<u4'"), "{header}");
    let number =
        |x: usize, y: usize| u32::from_le_bytes(data[4 * (y * 64 + x)..][..4].try_into().unwrap());
    assert_eq!(number(0, 0), u32::MAX);
    // The square is cut along a diagonal into its triangles 0 and 1.
    let mut seen = [number(20, 40), number(40, 20), number(20, 20), number(40, 44)];
    seen.sort_unstable();
    assert_eq!((seen[0], seen[3]), (0, 1), "{seen:?}");
}

#[test]
fn an_exr_has_several_layers() {
    let folder = square("-o a.exr --layer depth --layer normal --layer object");
    let bytes = folder.read("a.exr");
    assert_eq!(bytes[..4], 20_000_630_u32.to_le_bytes());
    let header = &bytes[..400];
    for channel in ["N.X\0", "N.Y\0", "N.Z\0", "depth\0", "object\0"] {
        let found = header.windows(channel.len()).any(|part| part == channel.as_bytes());
        assert!(found, "{channel}");
    }
}

#[test]
fn the_report_has_every_key_that_scripts_rely_on() {
    let folder = Folder::new();
    let flags = "--size 64x48 -o a.png --json";
    let report = folder.run(format!("render demo:cornell {flags}").split_whitespace()).json();
    assert_eq!(report["file"], "a.png");
    assert_eq!(report["size"], serde_json::json!([64, 48]));
    assert!(report["triangles"].as_u64().unwrap() > 0);
    assert!(report["simd"].is_string());
    assert!(report["ms"]["total"].as_f64().unwrap() > 0.0);
    let info = luxel("info demo:cornell --json --size 64x48").json();
    assert_eq!(report["camera"], info["camera"], "info tells the camera of render");
}

#[test]
fn a_png_of_numbers_has_a_legend() {
    let folder = Folder::new();
    let flags = "--size 64x48 -o a.png --layer object --json";
    let report = folder.run(format!("render demo:cornell {flags}").split_whitespace()).json();
    let legend = report["legend"].as_array().unwrap();
    assert!(legend.len() > 3);
    let mut colors: Vec<_> = legend.iter().map(|entry| entry["color"].to_string()).collect();
    colors.sort();
    colors.dedup();
    assert_eq!(colors.len(), legend.len(), "colours are distinct");
    assert!(legend.iter().all(|entry| entry["name"].is_string()));
}

#[test]
fn a_minus_writes_to_the_standard_output() {
    let folder = Folder::new();
    let run = folder.run("render demo:cornell --size 32x32 -o -".split_whitespace());
    let (width, height, ..) = png(&run.done().stdout);
    assert_eq!((width, height), (32, 32));
    let run =
        folder.run("render demo:cornell --size 32x32 -o - --output-format ppm".split_whitespace());
    assert!(run.done().stdout.starts_with(b"P6\n32 32\n"));
    assert!(folder.files().is_empty());
}

#[test]
fn a_turntable_starts_at_the_image_and_makes_a_full_turn() {
    let folder = Folder::new();
    let run = |flags: &str| {
        let line = format!("render demo:teapot --size 48x32 {flags}");
        folder.run(line.split_whitespace()).json()
    };
    let report: Value = run("--turntable 4 -o f_{n:3}.png --json");
    let names = ["f_000.png", "f_001.png", "f_002.png", "f_003.png"];
    assert_eq!(folder.files(), names);
    assert_eq!(report["files"], serde_json::json!(names));
    let pictures: Vec<_> = names.iter().map(|name| folder.read(name)).collect();
    for (place, picture) in pictures.iter().enumerate() {
        assert!(!pictures[..place].contains(picture), "each side looks different");
    }
}

#[test]
fn a_wireframe_covers_less_than_faces_and_edges_darken_them() {
    let covered = |flags: &str| {
        let (_, _, pixels, _) = png(&square(&format!("-o a.png {flags}")).read("a.png"));
        let (mut alpha, mut light) = (0_u64, 0_u64);
        for pixel in pixels.chunks(4) {
            alpha += u64::from(pixel[3]);
            light += u64::from(pixel[0]);
        }
        (alpha, light)
    };
    let (whole, bright) = covered("");
    let (wires, _) = covered("--wireframe");
    let (faces, darker) = covered("--edges");
    assert!(wires > 0 && wires < whole / 2);
    assert_eq!(faces, whole);
    assert!(darker < bright);
}

#[test]
fn an_existing_file_is_replaced_without_leftovers() {
    let folder = Folder::new();
    folder.write("a.png", "old");
    folder.run("render demo:cornell --size 8x8 -o a.png".split_whitespace()).done();
    assert_eq!(folder.files(), ["a.png"]);
    assert_eq!(png(&folder.read("a.png")).0, 8);
}

#[cfg(unix)]
#[test]
fn links_are_followed_and_devices_are_written_to() {
    let folder = Folder::new();
    folder.write("real.png", "old");
    std::os::unix::fs::symlink("real.png", folder.path("link.png")).unwrap();
    folder.run("render demo:cornell --size 8x8 -o link.png".split_whitespace()).done();
    assert!(folder.path("link.png").is_symlink());
    assert_eq!(png(&folder.read("real.png")).0, 8);
    let line = "render demo:cornell --size 8x8 -o /dev/null --output-format png";
    folder.run(line.split_whitespace()).done();
}

#[test]
fn unwritable_outputs_are_errors_before_any_work() {
    luxel("render demo:cornell -o nosuch/a.png").failed(1, "nosuch");
    luxel("render demo:cornell --turntable 3 -o nosuch/{n}.png").failed(1, "nosuch");
    let folder = Folder::new();
    std::fs::create_dir(folder.path("a.png")).unwrap();
    folder.run(["render", "demo:cornell", "-o", "a.png"]).failed(1, "folder");
}

#[test]
fn an_image_beyond_the_memory_limit_is_refused() {
    luxel("render demo:cornell --size 16384x16384 --max-memory 100M -o a.png")
        .failed(1, "--max-memory");
    luxel("render demo:cornell --size 4000x4000 --max-memory 100M -o a.exr")
        .failed(1, "--max-memory");
}

#[test]
fn light_scale_multiplies_the_lights() {
    let light = "-o a.png --light directional:dir=0,0,-1:ambient=.5,.5,.5 --ambient .25,.25,.25";
    let scaled = square(&format!("{light} --light-scale 0.5"));
    let half = "directional:dir=0,0,-1:ambient=.25,.25,.25:diffuse=.5,.5,.5";
    let written_out = square(&format!("-o a.png --light {half} --ambient .125,.125,.125"));
    assert_eq!(scaled.read("a.png"), written_out.read("a.png"));
}

#[test]
fn an_unlit_scene_is_its_ambient_light() {
    let folder = square("-o a.png --light ambient:color=.5,.5,.5 --encoding none --samples 1");
    let (_, _, pixels, _) = png(&folder.read("a.png"));
    // The first light counts, too: 1 + 0.5 is white.
    assert_eq!(pixels[4 * (32 * 64 + 32)], 255);
    let only = Folder::new();
    only.write("square.ply", SQUARE_PLY);
    let line = format!(
        "render square.ply {CAMERA} --color 1,1,1 --light ambient:color=.5,.5,.5 --encoding none \
         --samples 1 -o a.png"
    );
    only.run(line.split_whitespace()).done();
    let (_, _, pixels, _) = png(&only.read("a.png"));
    assert_eq!(pixels[4 * (32 * 64 + 32)], 128);
}

#[cfg(target_os = "linux")]
#[test]
fn file_names_may_be_invalid_unicode() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let folder = Folder::new();
    let model = OsStr::from_bytes(b"m\xff.ply");
    let picture = OsStr::from_bytes(b"p\xfe.png");
    std::fs::write(folder.path(".").join(model), SQUARE_PLY).unwrap();
    let line = [OsStr::new("render"), model, OsStr::new("-o"), picture];
    folder.run(line.into_iter().chain(["--size", "8x8"].map(OsStr::new))).done();
    assert!(folder.path(".").join(picture).is_file());
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_no_partial_file() {
    use std::process::{Command, Stdio};
    use std::time::Duration;
    let folder = Folder::new();
    let mut child = Command::new(env!("CARGO_BIN_EXE_luxel"))
        .args("render demo:cornell --size 640x480 --turntable 900 -o {n}.ppm".split_whitespace())
        .current_dir(folder.path("."))
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    while folder.files().len() < 3 {
        assert!(child.try_wait().unwrap().is_none(), "it goes on until it is interrupted");
        std::thread::sleep(Duration::from_millis(5));
    }
    let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(kill.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    for name in folder.files() {
        assert!(name.ends_with(".ppm"), "{name}");
        assert_eq!(folder.read(&name).len(), "P6\n640 480\n255\n".len() + 640 * 480 * 3, "{name}");
    }
}

#[test]
fn an_svg_of_a_square_has_its_colour_and_the_background() {
    let folder = square("-o a.svg --background 0,0,1 --json");
    let text = String::from_utf8(folder.read("a.svg")).unwrap();
    let expected = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"64\" height=\"64\" \
                    viewBox=\"0 0 64 64\">\n<rect width=\"64\" height=\"64\" fill=\"#00f\"/>\n\
                    <path fill=\"#fff\" d=\"m16 48v-32h32v32z\"/>\n</svg>\n";
    assert_eq!(text, expected);
}

#[test]
fn svg_accepts_a_tolerance_and_refuses_edges_and_layers() {
    let folder = Folder::new();
    folder.write("square.ply", SQUARE_PLY);
    let run =
        |flags: &str| folder.run(format!("render square.ply -o a.svg {flags}").split_whitespace());
    run("--tolerance 8").done();
    assert_eq!(run("--json --size 64x64").json()["svg"]["paths"], 1);
    run("--edges").failed(2, "has no edges");
    run("--wireframe").failed(2, "has no edges");
    run("--bits 16").failed(2, "8 bits");
    run("--layer depth").failed(2, "layers need a pixel format");
}
