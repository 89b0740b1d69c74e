//! Pictures read back as others read them.

#![expect(clippy::unwrap_used, reason = "a file that can't be read fails the test")]

use flate2::read::ZlibDecoder;
use luxel_lighting::PictureEncoding;
use luxel_render::*;
use luxel_scene::Size;
use std::collections::BTreeMap;
use std::io::{Cursor, Read};

const SIZE: Size = Size { width: 5, height: 37 };
const PIXELS: usize = 5 * 37;

fn rgba8() -> Vec<[u8; 4]> {
    (0..PIXELS).map(|i| [i as u8, (i * 7) as u8, (i * 31) as u8, 255 - (i % 3) as u8]).collect()
}

fn linear() -> Vec<[f32; 4]> {
    (0..PIXELS).map(|i| [i as f32 * 0.01, 0.5, -0.25, (i % 5) as f32 * 0.25]).collect()
}

fn layer(name: &str, channels: usize, values: LayerValues) -> LayerImage {
    LayerImage { name: name.to_owned(), channels, values }
}

fn depths() -> LayerImage {
    layer("depth", 1, LayerValues::F32((0..PIXELS).map(|i| i as f32 / 184.0).collect()))
}

fn objects() -> LayerImage {
    let ids = (0..PIXELS).map(|i| if i % 4 == 0 { u32::MAX } else { i as u32 / 50 });
    layer("object", 1, LayerValues::U32(ids.collect()))
}

fn normals() -> LayerImage {
    let values = (0..3 * PIXELS).map(|i| (i % 9) as f32 / 4.0 - 1.0);
    layer("normal", 3, LayerValues::F32(values.collect()))
}

fn read_png(bytes: &[u8]) -> (png::ColorType, png::BitDepth, Vec<u8>) {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), (SIZE.width, SIZE.height));
    (info.color_type, info.bit_depth, pixels)
}

/// The words of bytes, high byte first.
fn words(bytes: &[u8]) -> Vec<u16> {
    bytes.as_chunks().0.iter().map(|&pair| u16::from_be_bytes(pair)).collect()
}

/// The header and the data of an NPY file.
fn read_npy(bytes: &[u8]) -> (&str, &[u8]) {
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert_eq!((10 + length) % 64, 0);
    let header = std::str::from_utf8(&bytes[10..10 + length]).unwrap();
    assert!(header.ends_with('\n'));
    (header.trim_end(), &bytes[10 + length..])
}

/// The magic, the largest value and the data of a PPM file.
fn read_ppm(bytes: &[u8]) -> (&str, u32, &[u8]) {
    let mut ends = bytes.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(at, _)| at);
    let end = ends.nth(2).unwrap();
    let fields: Vec<_> = std::str::from_utf8(&bytes[..end]).unwrap().split_whitespace().collect();
    assert_eq!(fields[1..3], ["5", "37"]);
    (fields[0], fields[3].parse().unwrap(), &bytes[end + 1..])
}

/// A channel of an EXR file: its kind (0 for uint32, 2 for float32) and the bits of its values.
type ExrChannel = (i32, Vec<u32>);

/// Reads an EXR file of ZIP-compressed scan lines by the layout that its specification gives.
fn read_exr(bytes: &[u8]) -> BTreeMap<String, ExrChannel> {
    let int = |at: usize| i32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let text = |at: usize| {
        let end = at + bytes[at..].iter().position(|&byte| byte == 0).unwrap();
        (String::from_utf8(bytes[at..end].to_vec()).unwrap(), end + 1)
    };
    assert_eq!((int(0), int(4) & 0xff), (20_000_630, 2));
    let mut channels = Vec::new();
    let mut at = 8;
    while bytes[at] != 0 {
        let (name, kind_at) = text(at);
        let (_, size_at) = text(kind_at);
        let value_at = size_at + 4;
        at = value_at + int(size_at) as usize;
        match name.as_str() {
            "channels" => {
                let mut entry = value_at;
                while bytes[entry] != 0 {
                    let (name, after) = text(entry);
                    channels.push((name, int(after)));
                    entry = after + 16;
                }
            }
            "compression" => assert_eq!(bytes[value_at], 3),
            "dataWindow" => {
                assert_eq!([int(value_at), int(value_at + 4)], [0, 0]);
                assert_eq!([int(value_at + 8), int(value_at + 12)], [4, 36]);
            }
            _ => {}
        }
    }
    at += 1;
    let mut found: BTreeMap<_, ExrChannel> =
        channels.iter().map(|(name, kind)| (name.clone(), (*kind, Vec::new()))).collect();
    for block in 0..37_usize.div_ceil(16) {
        let offset = u64::from_le_bytes(bytes[at + 8 * block..][..8].try_into().unwrap()) as usize;
        assert_eq!(int(offset), 16 * block as i32);
        let data = &bytes[offset + 8..][..int(offset + 4) as usize];
        let lines = 16.min(37 - 16 * block);
        let size = lines * 5 * 4 * channels.len();
        let mut raw = Vec::new();
        if data.len() == size {
            raw.extend(data);
        } else {
            ZlibDecoder::new(data).read_to_end(&mut raw).unwrap();
            for place in 1..raw.len() {
                raw[place] = raw[place].wrapping_add(raw[place - 1]).wrapping_sub(128);
            }
            let half = raw.len().div_ceil(2);
            raw = (0..raw.len())
                .map(|i| raw[if i % 2 == 0 { i / 2 } else { half + i / 2 }])
                .collect();
        }
        assert_eq!(raw.len(), size);
        let mut values = raw.as_chunks().0.iter().map(|&bytes| u32::from_le_bytes(bytes));
        for _ in 0..lines {
            for (name, _) in &channels {
                found.get_mut(name).unwrap().1.extend(values.by_ref().take(5));
            }
        }
    }
    found
}

#[test]
fn a_png_of_bytes_reads_back_and_tells_its_encoding() {
    let mut file = Vec::new();
    write_rgba8(PictureFormat::Png, SIZE, &rgba8(), PictureEncoding::Srgb, &mut file).unwrap();
    let (color, depth, pixels) = read_png(&file);
    assert_eq!((color, depth), (png::ColorType::Rgba, png::BitDepth::Eight));
    assert_eq!(pixels, rgba8().as_flattened());
    assert!(file.windows(4).any(|name| name == b"sRGB"));
}

#[test]
fn a_png_of_light_holds_sixteen_encoded_bits() {
    for encoding in [PictureEncoding::Srgb, PictureEncoding::None] {
        let mut file = Vec::new();
        write_linear(PictureFormat::Png, SIZE, &linear(), encoding, &mut file).unwrap();
        let (color, depth, pixels) = read_png(&file);
        assert_eq!((color, depth), (png::ColorType::Rgba, png::BitDepth::Sixteen));
        let expected: Vec<u16> = linear()
            .iter()
            .flat_map(|&[r, g, b, a]| {
                let alpha = PictureEncoding::None.word(a);
                [encoding.word(r), encoding.word(g), encoding.word(b), alpha]
            })
            .collect();
        assert_eq!(words(&pixels), expected);
    }
}

#[test]
fn a_ppm_lies_over_black() {
    let mut file = Vec::new();
    let mut pixels = rgba8();
    pixels[0] = [200, 100, 50, 255];
    pixels[1] = [200, 100, 50, 0];
    pixels[2] = [200, 100, 50, 51];
    write_rgba8(PictureFormat::Ppm, SIZE, &pixels, PictureEncoding::Srgb, &mut file).unwrap();
    let (magic, largest, data) = read_ppm(&file);
    assert_eq!((magic, largest, data.len()), ("P6", 255, 3 * PIXELS));
    assert_eq!(data[..9], [200, 100, 50, 0, 0, 0, 40, 20, 10]);

    let mut file = Vec::new();
    write_linear(PictureFormat::Ppm, SIZE, &linear(), PictureEncoding::None, &mut file).unwrap();
    let (magic, largest, data) = read_ppm(&file);
    assert_eq!((magic, largest, data.len()), ("P6", 65535, 6 * PIXELS));
}

#[test]
fn an_exr_of_light_is_linear_and_multiplied_by_alpha() {
    let mut file = Vec::new();
    write_linear(PictureFormat::Exr, SIZE, &linear(), PictureEncoding::Srgb, &mut file).unwrap();
    let channels = read_exr(&file);
    assert_eq!(channels.keys().collect::<Vec<_>>(), ["A", "B", "G", "R"]);
    for (name, place) in [("R", 0), ("G", 1), ("B", 2)] {
        let expected: Vec<u32> =
            linear().iter().map(|pixel| (pixel[place] * pixel[3]).to_bits()).collect();
        assert_eq!(channels[name], (2, expected));
    }
}

#[test]
fn an_exr_holds_several_layers_with_whole_numbers_kept_whole() {
    let mut file = Vec::new();
    let z = layer("z", 1, LayerValues::F32(vec![f32::INFINITY; PIXELS]));
    let light = layer("light:a lamp with a long name", 3, LayerValues::F32(vec![2.5; 3 * PIXELS]));
    let layers = [depths(), objects(), normals(), z, light];
    let legend = write_layers(PictureFormat::Exr, SIZE, &layers, &mut file).unwrap();
    assert_eq!(legend, None);
    let channels = read_exr(&file);
    assert_eq!(
        channels.keys().collect::<Vec<_>>(),
        [
            "N.X",
            "N.Y",
            "N.Z",
            "Z",
            "depth",
            "light:a lamp with a long name.B",
            "light:a lamp with a long name.G",
            "light:a lamp with a long name.R",
            "object",
        ]
    );
    let LayerValues::U32(ids) = objects().values else { panic!("ids are whole") };
    assert_eq!(channels["object"], (0, ids));
    let LayerValues::F32(normals) = normals().values else { panic!("normals are floats") };
    let y: Vec<u32> = normals.iter().skip(1).step_by(3).map(|y| y.to_bits()).collect();
    assert_eq!(channels["N.Y"], (2, y));
    assert!(channels["Z"].1.iter().all(|&bits| bits == f32::INFINITY.to_bits()));
}

#[test]
fn the_same_layer_twice_cannot_be_an_exr() {
    let layers = [depths(), depths()];
    let result = write_layers(PictureFormat::Exr, SIZE, &layers, &mut Vec::new());
    assert!(matches!(result, Err(PictureError::Channel(name)) if name == "depth"));
}

#[test]
fn an_npy_has_the_shape_and_the_bits_of_the_layer() {
    for (layer, shape, kind) in [
        (depths(), "(37, 5)", "<f4"),
        (objects(), "(37, 5)", "<u4"),
        (normals(), "(37, 5, 3)", "<f4"),
    ] {
        let mut file = Vec::new();
        write_layers(PictureFormat::Npy, SIZE, std::slice::from_ref(&layer), &mut file).unwrap();
        let (header, data) = read_npy(&file);
        let expected = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
        assert_eq!(header, expected);
        let bytes: Vec<u8> = match layer.values {
            LayerValues::F32(values) => values.into_iter().flat_map(f32::to_le_bytes).collect(),
            LayerValues::U32(values) => values.into_iter().flat_map(u32::to_le_bytes).collect(),
        };
        assert_eq!(data, bytes);
    }
    let mut file = Vec::new();
    write_linear(PictureFormat::Npy, SIZE, &linear(), PictureEncoding::Srgb, &mut file).unwrap();
    let (header, data) = read_npy(&file);
    assert!(header.contains("(37, 5, 4)"));
    assert_eq!(data[..4], linear()[0][0].to_le_bytes());
}

#[test]
fn a_png_of_depths_spans_zero_to_one() {
    let mut file = Vec::new();
    let legend = write_layers(PictureFormat::Png, SIZE, &[depths()], &mut file).unwrap();
    assert_eq!(legend, Some(Legend::Scaled(vec![[0.0, 1.0]])));
    let (color, depth, pixels) = read_png(&file);
    assert_eq!((color, depth), (png::ColorType::Grayscale, png::BitDepth::Sixteen));
    let words = words(&pixels);
    assert_eq!((words[0], words[PIXELS - 1]), (0, 65535));
    assert_eq!(words[92], 32768);
}

#[test]
fn a_png_of_distances_spans_what_is_there_and_nothing_is_far() {
    let mut values = vec![f32::INFINITY; PIXELS];
    values[3] = 2.0;
    values[4] = 6.0;
    values[5] = 4.0;
    let mut file = Vec::new();
    let z = layer("z", 1, LayerValues::F32(values));
    let legend = write_layers(PictureFormat::Png, SIZE, &[z], &mut file).unwrap();
    assert_eq!(legend, Some(Legend::Scaled(vec![[2.0, 6.0]])));
    let (.., pixels) = read_png(&file);
    assert_eq!(words(&pixels)[2..6], [65535, 0, 65535, 32768]);
}

#[test]
fn a_png_of_numbers_has_the_colours_that_the_legend_tells() {
    let mut file = Vec::new();
    let legend = write_layers(PictureFormat::Png, SIZE, &[objects()], &mut file).unwrap();
    let Some(Legend::Colors(colors)) = legend else { panic!("numbers have colours") };
    assert_eq!(colors.iter().map(|(id, _)| *id).collect::<Vec<_>>(), [0, 1, 2, 3]);
    let (color, _, pixels) = read_png(&file);
    assert_eq!(color, png::ColorType::Rgb);
    let words = words(&pixels);
    let LayerValues::U32(ids) = objects().values else { panic!("ids are whole") };
    for (pixel, id) in words.as_chunks::<3>().0.iter().zip(ids) {
        let expected = colors.iter().find(|(known, _)| *known == id).map_or([0; 3], |(_, c)| *c);
        assert_eq!(*pixel, expected);
    }
}

#[test]
fn different_numbers_have_different_colours_none_of_them_dark() {
    let mut seen = std::collections::HashSet::new();
    for id in (0..200_000).chain(u32::MAX - 1000..u32::MAX) {
        let color = id_color(id);
        assert!(color.iter().all(|&word| word >= 0x2800));
        assert!(seen.insert(color), "{id}");
    }
    assert_eq!(id_color(u32::MAX), [0; 3]);
}

#[test]
fn values_that_do_not_fill_the_picture_are_an_error() {
    let pixels = &rgba8()[1..];
    let out = &mut Vec::new();
    let result = write_rgba8(PictureFormat::Png, SIZE, pixels, PictureEncoding::Srgb, out);
    assert!(matches!(result, Err(PictureError::Values { values: 184, .. })));
    let two = [depths(), objects()];
    let result = write_layers(PictureFormat::Png, SIZE, &two, out);
    assert!(matches!(result, Err(PictureError::Layers { layers: 2, .. })));
    assert!(out.is_empty());
}
