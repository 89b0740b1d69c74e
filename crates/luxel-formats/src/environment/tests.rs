//! The readers of pictures of environments.
#![cfg(all(feature = "exr", feature = "hdr"))]

use super::*;
use crate::Hint;

const LIMITS: Limits =
    Limits { max_memory: 64 << 20, max_depth: 8, progress: None, files: None, given: None };

fn image(bytes: &[u8]) -> EquirectangularImage {
    decode(bytes, &LIMITS).unwrap()
}

fn message(bytes: &[u8]) -> String {
    read_environment(bytes, "x", &LIMITS).unwrap_err().to_string()
}

fn hdr(size: &str, rows: &[u8]) -> Vec<u8> {
    let head =
        format!("#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n\n{size}\n");
    [head.as_bytes(), rows].concat()
}

#[test]
fn texels_of_radiance_are_mantissas_times_powers_of_two() {
    let bytes = hdr("-Y 1 +X 3", &[128, 64, 0, 129, 255, 1, 2, 136, 9, 9, 9, 0]);
    let light = vec![[1.0, 0.5, 0.0], [255.0, 1.0, 2.0], [0.0; 3]];
    assert_eq!(image(&bytes), EquirectangularImage { width: 3, height: 1, light });
    // The smallest and the largest exponent.
    let bytes = hdr("-Y 1 +X 2", &[1, 255, 0, 1, 255, 0, 0, 255]);
    let [small, large] = image(&bytes).light[..] else { panic!("two texels") };
    assert_eq!(f64::from(small[1]), libm::ldexp(255.0, -135));
    assert_eq!(f64::from(large[0]), libm::ldexp(255.0, 119));
}

#[test]
fn runs_of_channels_and_of_texels_are_read() {
    // Eight texels by channels: a run, bytes as they are, both.
    let mut row = vec![2, 2, 0, 8, 128 + 8, 128, 8, 1, 2, 3, 4, 5, 6, 7, 8];
    row.extend([4, 0, 0, 0, 0, 128 + 4, 64, 128 + 8, 128]);
    let light = image(&hdr("-Y 1 +X 8", &row)).light;
    assert_eq!(light[0], [0.5, 1.0 / 256.0, 0.0]);
    assert_eq!(light[7], [0.5, 8.0 / 256.0, 0.25]);
    // A texel, repeated five times, and 256 times.
    let row = [64, 64, 64, 129, 1, 1, 1, 5, 1, 1, 1, 1];
    let light = image(&hdr("-Y 1 +X 262", &row)).light;
    assert_eq!(light, vec![[0.5; 3]; 262]);
}

#[test]
fn a_radiance_file_that_is_cut_off_names_the_row() {
    let row = [2, 2, 0, 8, 136, 128, 136, 128, 136, 128, 136, 128];
    let whole = hdr("-Y 2 +X 8", &[row, row].concat());
    assert_eq!(image(&whole).light.len(), 16);
    for length in 2..whole.len() {
        let error = decode(&whole[..length], &LIMITS);
        let error = error.err().unwrap_or_else(|| panic!("{length} bytes were read"));
        assert!(error.place != Place::File, "{error}");
    }
    let cut = message(&whole[..whole.len() - 3]);
    assert!(cut.contains("ends here, in the middle of row 1 of 2"), "{cut}");
}

#[test]
fn false_sizes_are_errors_before_anything_is_allocated() {
    let error = read_environment(&hdr("-Y 100000 +X 100000", &[]), "x", &Limits::default());
    let error = error.unwrap_err();
    assert_eq!(error.hint(), Some(Hint::RaiseMemoryLimit), "{error}");
    assert!(error.to_string().contains("100000x100000"), "{error}");
    let vast = Limits { max_memory: u64::MAX, ..LIMITS };
    let error = read_environment(&hdr("-Y 100000 +X 100000", &[]), "x", &vast).unwrap_err();
    assert!(error.to_string().contains("has only"), "{error}");
    for (size, expected) in [
        ("-Y 0 +X 8", "0 texels"),
        ("-Y 8 +X -8", "is not the size"),
        ("-Y 99999999999 +X 8", "is not the size"),
        ("+X 8 -Y 8", "from top to bottom"),
        ("nonsense", "-Y HEIGHT +X WIDTH"),
    ] {
        let message = message(&hdr(size, &[0; 64]));
        assert!(message.contains(expected), "{size}: {message}");
    }
}

#[test]
fn damaged_runs_are_errors() {
    for (width, row, expected) in [
        (8, &[2, 2, 0, 9, 137, 128][..], "has 9 texels, and the picture 8"),
        (8, &[2, 2, 0, 8, 137, 128], "ends beyond the row"),
        (8, &[2, 2, 0, 8, 0, 128], "ends beyond the row"),
        (4, &[1, 1, 1, 2], "has no texel before it"),
        (4, &[9, 9, 9, 128, 1, 1, 1, 9], "ends beyond the row"),
    ] {
        let message = message(&hdr(&format!("-Y 1 +X {width}"), row));
        assert!(message.contains(expected), "{row:?}: {message}");
    }
    let foreign = b"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n\0\0\0\0";
    assert!(message(foreign).contains("32-bit_rle_xyze"));
    assert!(message(b"GIF89a").contains("neither Radiance"));
    assert!(message(b"").contains("empty"));
}

#[test]
fn light_that_is_not_finite_names_its_texel_and_negative_light_is_none() {
    let image = |light: Vec<[f32; 3]>| EquirectangularImage { width: 2, height: 2, light };
    let mut one = image(vec![[1.0; 3], [1.0; 3], [1.0; 3], [0.0, f32::NAN, 1.0]]);
    let message = check_light(&mut one).unwrap_err().to_string();
    assert!(message.contains("column 1, row 1") && message.contains("NaN"), "{message}");
    let mut two = image(vec![[1.0; 3], [0.5, -0.25, 1.0], [1.0; 3], [-1.0; 3]]);
    let warnings = check_light(&mut two).unwrap();
    assert_eq!(warnings.len(), 1);
    let warning = &warnings[0].message;
    assert!(
        warning.starts_with("2 texels have") && warning.contains("column 1, row 0"),
        "{warning}"
    );
    assert_eq!(two.light[1], [0.5, 0.0, 1.0]);
    assert_eq!(two.light[3], [0.0; 3]);
}

/// Pictures of 40x20 texels that the crate `exr` wrote: x / 4 + 4 y, and half more for each of R, G, B.
const WRITTEN: [(&str, &[u8]); 8] = [
    ("none-half", include_bytes!("../../tests/environments/none-half.exr")),
    ("rle-half", include_bytes!("../../tests/environments/rle-half.exr")),
    ("zips-half-tiles", include_bytes!("../../tests/environments/zips-half-tiles.exr")),
    ("zip-float", include_bytes!("../../tests/environments/zip-float.exr")),
    ("zip-half", include_bytes!("../../tests/environments/zip-half.exr")),
    ("piz-half", include_bytes!("../../tests/environments/piz-half.exr")),
    ("pxr24-half", include_bytes!("../../tests/environments/pxr24-half.exr")),
    ("pxr24-float", include_bytes!("../../tests/environments/pxr24-float.exr")),
];

#[test]
fn pictures_of_another_program_have_its_texels() {
    for (name, bytes) in WRITTEN {
        let EquirectangularImage { width, height, light } = image(bytes);
        assert_eq!([width, height], [40, 20], "{name}");
        for (at, light) in light.iter().enumerate() {
            let (x, y) = ((at % 40) as f32, (at / 40) as f32);
            let expected = [0.0, 0.5, 1.0].map(|more| x * 0.25 + y * 4.0 + more);
            assert_eq!(*light, expected, "{name} {x} {y}");
        }
    }
}

/// Pictures of 11x35 texels that the OpenEXR library wrote, with channels A and Z beside R, G and B, of half, float and
/// uint; and the one that has the same texels without compression, as that library reads them.
const OF_OPENEXR: [(&str, &[u8], &[u8]); 4] = [
    (
        "piz",
        include_bytes!("../../tests/environments/openexr-piz.exr"),
        include_bytes!("../../tests/environments/openexr-none.exr"),
    ),
    (
        "piz-tiles",
        include_bytes!("../../tests/environments/openexr-piz-tiles.exr"),
        include_bytes!("../../tests/environments/openexr-none.exr"),
    ),
    (
        "b44",
        include_bytes!("../../tests/environments/openexr-b44.exr"),
        include_bytes!("../../tests/environments/openexr-b44-none.exr"),
    ),
    (
        "b44a",
        include_bytes!("../../tests/environments/openexr-b44a.exr"),
        include_bytes!("../../tests/environments/openexr-b44-none.exr"),
    ),
];
/// A picture of 640x32 texels: the halves from 0 on, by their bits.
const MANY: &[u8] = include_bytes!("../../tests/environments/openexr-piz-many.exr");

#[test]
fn pictures_of_openexr_have_the_texels_of_their_uncompressed_twins() {
    for (name, bytes, twin) in OF_OPENEXR {
        let [own, twin] = [image(bytes), image(twin)];
        assert_eq!([own.width, own.height], [11, 35], "{name}");
        assert!(own.light == twin.light, "{name}");
        assert!(own.light.iter().any(|light| *light != own.light[0]), "{name}");
    }
}

#[test]
fn blocks_of_most_values_of_16_bits_are_read() {
    let many = image(MANY);
    assert_eq!([many.width, many.height], [640, 32]);
    for (bits, light) in (0..).zip(many.light) {
        let (exponent, mantissa) = (bits / 1024, f64::from(bits % 1024) / 1024.0);
        let whole = if exponent == 0 { 0.0 } else { 1.0 };
        let expected = libm::ldexp(whole + mantissa, exponent.max(1) - 15);
        assert_eq!(light.map(f64::from), [expected; 3], "{bits}");
    }
}

#[test]
fn blocks_that_share_their_bytes_are_errors() {
    let (_, _, bytes) = OF_OPENEXR[0];
    // Each of 35 lines is a block; the table that tells where they begin lies before the first.
    let block = 4 + 4 + 11 * (2 + 4 + 2 + 2 + 4);
    let first = bytes.len() - 35 * block;
    let mut shared = bytes[..first + block].to_vec();
    for offset in shared[first - 35 * 8..first].chunks_exact_mut(8) {
        offset.copy_from_slice(&(first as u64).to_le_bytes());
    }
    let message = message(&shared);
    assert!(message.contains("lies where another one does"), "{message}");
}

#[test]
fn a_size_of_openexr_beyond_all_numbers_is_an_error() {
    let (_, _, bytes) = OF_OPENEXR[0];
    let mut vast = bytes.to_vec();
    for name in [&b"dataWindow"[..], b"displayWindow"] {
        let at = vast.windows(name.len()).position(|window| window == name).unwrap();
        let value = at + name.len() + 1 + b"box2i\0".len() + 4;
        let window = [i32::MIN + 1, i32::MIN + 1, i32::MAX - 1, i32::MAX - 1].map(i32::to_le_bytes);
        vast[value..value + 16].copy_from_slice(window.as_flattened());
    }
    assert!(message(&vast).contains("4294967294x4294967294"), "{}", message(&vast));
}

#[test]
fn cut_and_changed_pictures_of_openexr_are_errors_or_pictures() {
    let of_openexr = OF_OPENEXR.map(|(name, bytes, _)| (name, bytes));
    for (name, bytes) in WRITTEN.into_iter().chain(of_openexr).chain([("many", MANY)]) {
        for length in (0..bytes.len()).step_by(7) {
            assert!(decode(&bytes[..length], &LIMITS).is_err(), "{name}: {length} bytes were read");
        }
        // Any byte may change; the result is an error or a picture of sane size.
        let step = if bytes.len() > 9000 { 61 } else { 3 };
        for at in (0..bytes.len()).step_by(step) {
            for flip in [0x01, 0x80, 0xff] {
                let mut changed = bytes.to_vec();
                changed[at] ^= flip;
                let _ = decode(&changed, &LIMITS);
            }
        }
    }
}

#[test]
fn compressions_that_are_not_read_are_named() {
    let message = message(include_bytes!("../../tests/environments/openexr-dwaa.exr"));
    assert!(message.contains("DWAA") && message.contains("ZIP"), "{message}");
}

#[test]
fn only_regular_files_are_opened() {
    let message = |path: &str| open_environment(Path::new(path), &LIMITS).unwrap_err().to_string();
    assert!(message("/nowhere/sky.hdr").starts_with("/nowhere/sky.hdr"));
    #[cfg(unix)]
    assert!(message("/dev/zero").contains("not a regular file"), "{}", message("/dev/zero"));
}
