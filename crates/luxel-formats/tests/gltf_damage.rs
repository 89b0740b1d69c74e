//! Damaged glTF gives an error with its place, within the limits, and never a panic.

mod documents;

use documents::Document;
use luxel_formats::{Error, ErrorKind, Format, Limits, Place, read};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::path::Path;
use std::time::{Duration, Instant};

fn text(json: &str) -> Result<(), Error> {
    let folder = Some(Path::new("."));
    read(json.as_bytes(), Format::Gltf, "test", folder, &Limits::default()).map(|_| ())
}

#[test]
fn syntax_errors_have_their_line_or_byte() {
    let error = text("{\n  \"asset\": }").unwrap_err();
    assert_eq!(error.place, Place::Line(2));
    let mut glb = Document::triangle().glb();
    glb[20] = b'?';
    let error = read(&glb, Format::Glb, "test", None, &Limits::default()).unwrap_err();
    assert_eq!(error.place, Place::Byte(20));
}

#[test]
fn a_value_of_the_wrong_type_is_an_error_with_its_pointer() {
    for (json, pointer) in [
        (r#"{"asset":{"version":"2.0"},"nodes":[{},{"children":[0,-1]}]}"#, "/nodes/1/children/1"),
        (r#"{"asset":{"version":"2.0"},"accessors":[{"count":"many"}]}"#, "/accessors/0/count"),
        (r#"{"asset":{"version":"2.0"},"accessors":[{}]}"#, "/accessors/0"),
        (r#"{"asset":{"version":2}}"#, "/asset/version"),
        ("[]", ""),
    ] {
        assert_eq!(text(json).unwrap_err().place, Place::Pointer(pointer.to_owned()), "{json}");
    }
}

#[test]
fn other_versions_are_refused() {
    for json in [
        r#"{"asset":{"version":"1.0"}}"#,
        r#"{"accessors":{"first":{}},"asset":{"version":"1.0.2"}}"#,
        r#"{"asset":{"version":"2.1","minVersion":"2.1"}}"#,
    ] {
        assert!(documents::is_unsupported(&text(json).unwrap_err()), "{json}");
    }
    assert!(text("{}").is_err());
    assert!(text(r#"{"asset":{"version":"2.0"}}"#).is_ok(), "an empty document is valid");
}

#[test]
fn json_may_not_nest_without_end() {
    let deep = "[".repeat(100_000);
    assert!(text(&format!(r#"{{"asset":{{"version":"2.0"}},"extras":{deep}"#)).is_err());
}

/// A change to a sound document, and the pointer that the error has to tell.
type Fault = (fn(&mut Document), &'static str);

#[test]
fn errors_of_accessors_have_their_pointer() {
    let faults: &[Fault] = &[
        (
            |d| d.primitive()["attributes"]["POSITION"] = json!(7),
            "/meshes/0/primitives/0/attributes/POSITION",
        ),
        (|d| d.primitive()["mode"] = json!(7), "/meshes/0/primitives/0/mode"),
        (|d| d.primitive()["material"] = json!(0), "/meshes/0/primitives/0/material"),
        (|d| d.primitive()["indices"] = json!(0), "/meshes/0/primitives/0/indices"),
        (|d| d.json["nodes"][0]["mesh"] = json!(1), "/nodes/0/mesh"),
        (|d| d.json["nodes"][0]["camera"] = json!(1), "/nodes/0/camera"),
        (|d| d.json["nodes"][0]["skin"] = json!(1), "/nodes/0/skin"),
        (|d| d.json["accessors"][0]["bufferView"] = json!(3), "/accessors/0/bufferView"),
        (|d| d.json["accessors"][0]["count"] = json!(4), "/accessors/0"),
        (|d| d.json["accessors"][0]["count"] = json!(u64::MAX), "/accessors/0"),
        (|d| d.json["accessors"][0]["byteOffset"] = json!(1), "/accessors/0"),
        (|d| d.json["accessors"][0]["byteOffset"] = json!(u64::MAX), "/accessors/0"),
        (|d| d.json["accessors"][0]["componentType"] = json!(1), "/accessors/0/componentType"),
        (|d| d.json["accessors"][0]["type"] = json!("VEC9"), "/accessors/0/type"),
        (
            |d| d.json["accessors"][0]["type"] = json!("VEC2"),
            "/meshes/0/primitives/0/attributes/POSITION",
        ),
        (|d| d.json["bufferViews"][0]["byteStride"] = json!(0), "/accessors/0"),
        (|d| d.json["bufferViews"][0]["byteStride"] = json!(11), "/accessors/0"),
        (|d| d.json["bufferViews"][0]["byteStride"] = json!(u64::MAX), "/accessors/0"),
        (|d| d.json["bufferViews"][0]["byteLength"] = json!(37), "/bufferViews/0"),
        (|d| d.json["bufferViews"][0]["byteOffset"] = json!(u64::MAX), "/bufferViews/0"),
        (|d| d.json["bufferViews"][0]["buffer"] = json!(1), "/bufferViews/0/buffer"),
        (|d| d.json["buffers"] = json!([{"byteLength": 99}]), "/buffers/0/byteLength"),
        (
            |d| d.json["buffers"] = json!([{"byteLength": 36, "uri": "data:;base64,AAAA"}]),
            "/buffers/0/byteLength",
        ),
        (
            |d| d.json["buffers"] = json!([{"byteLength": 36, "uri": "data:;base64,****"}]),
            "/buffers/0/uri",
        ),
        (|d| d.json["buffers"] = json!([{"byteLength": 36, "uri": "../x.bin"}]), "/buffers/0/uri"),
        (|d| d.json["buffers"] = json!([{"byteLength": 36, "uri": "x.bin"}]), "/buffers/0/uri"),
    ];
    for (fault, pointer) in faults {
        let mut document = Document::triangle();
        fault(&mut document);
        let (found, message) = document.fault();
        assert_eq!(found, *pointer, "{message}");
    }
}

#[test]
fn an_index_out_of_range_names_the_vertex() {
    let mut document = Document::triangle();
    let indices = document.indices(&[0, 1, 3]);
    document.primitive()["indices"] = json!(indices);
    let error = document.read().unwrap_err();
    assert_eq!(error.place, Place::Pointer("/meshes/0/primitives/0/indices".to_owned()));
    assert!(matches!(error.kind, ErrorKind::OutOfRange { index: 3, count: 3, .. }), "{error}");
}

#[test]
fn sparse_indices_out_of_range_are_errors() {
    let mut document = Document::triangle();
    let indices = document.view(&[3]);
    document.json["accessors"][0]["sparse"] = json!({
        "count": 1,
        "indices": {"bufferView": indices, "componentType": 5121},
        "values": {"bufferView": 0},
    });
    assert_eq!(document.fault().0, "/accessors/0/sparse/indices");
}

#[test]
fn shorter_attributes_than_positions_are_errors() {
    let mut document = Document::triangle();
    let normals = document.floats("VEC3", &[0.0, 0.0, 1.0]);
    document.attribute("NORMAL", normals);
    assert_eq!(document.fault().0, "/meshes/0/primitives/0/attributes/NORMAL");
}

#[test]
fn a_missing_joint_is_an_error() {
    let mut document = Document::triangle();
    let joints = document.accessor("VEC4", 5121, 3, &[1; 12]);
    document.attribute("JOINTS_0", joints);
    let weights = document.floats("VEC4", &[1.0; 12]);
    document.attribute("WEIGHTS_0", weights);
    document.push("skins", json!({"joints": [0]}));
    document.json["nodes"][0]["skin"] = json!(0);
    assert_eq!(document.fault().0, "/meshes/0/primitives/0/attributes/JOINTS_0");
}

#[test]
fn counts_are_checked_before_memory_is_taken() {
    // Zeros without bytes behind them: the one accessor that a few words make large.
    let mut document = Document::triangle();
    document.json["accessors"][0] =
        json!({"componentType": 5126, "count": 4_000_000_000_u64, "type": "VEC3"});
    let error = document.read().unwrap_err();
    assert!(matches!(error.kind, ErrorKind::TooLarge { .. }), "{error}");
    // Every request counts, also a repeated one.
    let mut document = Document::triangle();
    let zeros =
        document.push("accessors", json!({"componentType": 5126, "count": 9999, "type": "VEC3"}));
    let primitives: Vec<Value> = (0..1000)
        .map(|uv| json!({"attributes": {"POSITION": zeros, format!("_{uv}"): 0}}))
        .collect();
    document.json["meshes"][0]["primitives"] = json!(primitives);
    let limits = Limits { max_memory: 1 << 27, ..Limits::default() };
    let error = read(&document.glb(), Format::Glb, "test", None, &limits).unwrap_err();
    assert!(matches!(error.kind, ErrorKind::TooLarge { .. }), "{error}");
}

/// A document with most features that the reader supports.
fn rich() -> Document {
    let mut document = Document::triangle();
    let joints = document.accessor("VEC4", 5121, 3, &[0; 12]);
    document.attribute("JOINTS_0", joints);
    let weights =
        document.floats("VEC4", &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    document.attribute("WEIGHTS_0", weights);
    let target = document.floats("VEC3", &[0.5; 9]);
    document.primitive()["targets"] = json!([{"POSITION": target}]);
    document.json["meshes"][0]["weights"] = json!([0.5]);
    let indices = document.indices(&[0, 1, 2]);
    document.primitive()["indices"] = json!(indices);
    document.push("skins", json!({"joints": [1]}));
    document.json["nodes"] = json!([{"mesh": 0, "skin": 0, "children": [1]}, {"camera": 0}]);
    document.push(
        "cameras",
        json!({"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}),
    );
    let sparse = document.view(&[1]);
    document.json["accessors"][target]["sparse"] = json!({
        "count": 1,
        "indices": {"bufferView": sparse, "componentType": 5121},
        "values": {"bufferView": 0},
    });
    document
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn changed_and_shortened_files_never_panic(
        changes in proptest::collection::vec((any::<usize>(), any::<u8>()), 0..6),
        length in any::<usize>(),
        is_cut in any::<bool>(),
    ) {
        let mut glb = rich().glb();
        prop_assert!(rich().read().is_ok());
        for (at, value) in changes {
            let at = at % glb.len();
            glb[at] = value;
        }
        if is_cut {
            glb.truncate(length % glb.len());
        }
        let start = Instant::now();
        let limits = Limits { max_memory: 1 << 26, ..Limits::default() };
        let _ = read(&glb, Format::Glb, "test", None, &limits);
        prop_assert!(start.elapsed() < Duration::from_secs(2));
    }

    #[test]
    fn changed_numbers_never_panic(
        digits in proptest::collection::vec((any::<usize>(), b'0'..=b'9'), 1..6),
    ) {
        let mut glb = rich().glb();
        let text_length = u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize;
        let places: Vec<_> =
            (20..20 + text_length).filter(|&at| glb[at].is_ascii_digit()).collect();
        for (place, digit) in digits {
            glb[places[place % places.len()]] = digit;
        }
        let limits = Limits { max_memory: 1 << 26, ..Limits::default() };
        let _ = read(&glb, Format::Glb, "test", None, &limits);
    }
}

#[test]
fn fewer_positions_than_a_draco_stream_has_vertices_are_an_error() {
    let mut glb = include_bytes!("grid/draco-sequential.glb").to_vec();
    // The stream's own positions go by a name that nothing reads, so that an accessor of fewer has
    // to stand in.
    let (start, length) = (20, u32::from_le_bytes([glb[12], glb[13], glb[14], glb[15]]) as usize);
    let text = std::str::from_utf8(&glb[start..start + length]).unwrap();
    let text = text.replace("\"attributes\":{\"POSITION\":0", "\"attributes\":{\"POSITIOM\":0");
    let text = text.replace("\"count\":36", "\"count\":35");
    glb[start..start + length].copy_from_slice(text.as_bytes());
    let error = read(&glb, Format::Glb, "test", None, &Limits::default()).unwrap_err();
    assert!(error.kind.to_string().contains("36 vertices"), "{error}");
}
