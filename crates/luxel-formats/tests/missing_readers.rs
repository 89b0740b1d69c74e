//! Builds without some readers: `cargo test -p luxel-formats --no-default-features --test
//! missing_readers`.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_formats::{ErrorKind, Format, Limits, open, read};

#[test]
fn a_format_without_its_reader_names_the_feature() {
    let formats = [Format::Gltf, Format::Glb, Format::Obj, Format::Stl, Format::Ply, Format::Toml];
    for format in formats {
        let expected = if format == Format::Glb { "gltf" } else { format.name() };
        let error = read(b"x", format, "x", None, &Limits::default()).err();
        let missing = match error.map(|error| error.kind) {
            Some(ErrorKind::MissingFeature { feature, .. }) => Some(feature),
            _ => None,
        };
        assert_eq!(missing, (!format.is_supported()).then_some(expected), "{format:?}");
    }
}

#[test]
fn a_file_without_its_reader_is_named() {
    let path = std::env::temp_dir().join(format!("luxel-missing-{}.toml", std::process::id()));
    std::fs::write(&path, b"x").unwrap();
    let error = open(&path, &Limits::default()).unwrap_err();
    std::fs::remove_file(&path).unwrap();
    assert_eq!(error.file.as_deref(), Some(&*path));
    let is_missing = matches!(error.kind, ErrorKind::MissingFeature { .. });
    assert_eq!(is_missing, !Format::Toml.is_supported());
}
