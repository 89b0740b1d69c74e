use super::*;
use proptest::prelude::*;

fn load(bytes: &[u8]) -> Result<Loaded, Error> {
    read(bytes, "stem", &Limits::default())
}

fn binary(header: &[u8], triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for corners in triangles {
        bytes.extend([0; 12]);
        bytes.extend(corners.as_flattened().iter().flat_map(|value| value.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn corners(mesh: &Mesh) -> Vec<[[f32; 3]; 3]> {
    let triangles = mesh.triangles.iter();
    triangles.map(|corners| corners.map(|index| mesh.positions[index as usize])).collect()
}

const QUAD: [[[f32; 3]; 3]; 2] = [
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]],
    [[-0.0, 0.0, -0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
];

const TEXT: &str = "\
SOLID first one
 facet normal 0 0 1
  Outer Loop
   vertex 0 0 0\r
   vertex 1e0 0 0
   VERTEX .5 1 -0
  endloop
 endfacet
endsolid first one
solid
 facet normal nan nan nan outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 nan 0 endloop endfacet
 facet normal 0 0 0 outer loop vertex 0 0 0 vertex 2 0 0 vertex 0 3 0 endloop endfacet
endsolid
";

#[test]
fn a_binary_file_whose_header_says_solid_is_binary() {
    let loaded = load(&binary(b"solid facet endsolid", &QUAD)).unwrap();
    assert_eq!(loaded.scene.triangle_count(), 2);
    assert_eq!(loaded.scene.nodes[0].name, "stem");
    assert_eq!(loaded.scene.up, DVec3::Z);
}

#[test]
fn equal_corners_are_welded_and_minus_zero_is_zero() {
    let mesh = &load(&binary(b"", &QUAD)).unwrap().scene.meshes[0];
    assert_eq!(mesh.positions.len(), 4);
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
}

#[test]
fn the_error_of_a_truncated_binary_file_names_its_last_byte() {
    let bytes = binary(b"", &QUAD);
    let error = load(&bytes[..bytes.len() - 1]).unwrap_err();
    assert_eq!(error.place, Place::Byte(183));
    assert!(error.to_string().contains("triangle 1: the file declares 2"), "{error}");
    assert!(load(&bytes[..50]).is_err());
}

#[test]
fn bytes_after_the_last_triangle_are_a_warning() {
    let mut bytes = binary(b"solid x", &QUAD);
    bytes.extend(b"more");
    let loaded = load(&bytes).unwrap();
    assert_eq!(loaded.scene.triangle_count(), 2);
    assert_eq!(loaded.warnings, ["byte 184: 4 bytes after the last triangle are ignored"]);
}

#[test]
fn a_false_count_fails_before_memory_is_allocated() {
    let mut bytes = binary(b"", &QUAD);
    bytes[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    assert!(matches!(load(&bytes).unwrap_err().kind, ErrorKind::Truncated(_)));
    let limits = Limits { max_memory: 100, ..Limits::default() };
    let error = read(&binary(b"", &QUAD), "x", &limits).err().unwrap();
    assert!(matches!(error.kind, ErrorKind::TooLarge { .. }));
}

#[test]
fn text_solids_are_objects_in_any_case_and_layout() {
    let loaded = load(TEXT.as_bytes()).unwrap();
    let names: Vec<_> = loaded.scene.nodes.iter().map(|node| node.name.as_str()).collect();
    assert_eq!(names, ["first one", "stem"]);
    assert_eq!(corners(&loaded.scene.meshes[0]), [[[0.0; 3], [1.0, 0.0, 0.0], [0.5, 1.0, 0.0]]]);
    assert_eq!(loaded.warnings, ["1 face with a corner that is not finite was left out"]);
    assert_eq!(loaded.scene.meshes[1].triangles.len(), 1);
}

#[test]
fn errors_in_text_files_name_their_line() {
    let text = TEXT.replace("1e0", "one");
    let error = load(text.as_bytes()).unwrap_err();
    assert_eq!(error.to_string(), "<input>:5: expected a number, found `one`");
    let error = load(&TEXT.as_bytes()[..60]).unwrap_err();
    assert_eq!(error.place, Place::Line(4));
    assert!(matches!(error.kind, ErrorKind::Truncated(_)));
}

#[test]
fn a_file_without_facets_is_valid() {
    let loaded = load(b"solid nothing\nendsolid nothing\n").unwrap();
    assert!(loaded.scene.nodes.is_empty());
    assert!(load(&binary(b"", &[])).unwrap().scene.nodes.is_empty());
}

proptest! {
    #[test]
    fn both_kinds_give_back_what_was_written(
        triangles in prop::collection::vec(
            prop::array::uniform3([-1e6_f32..1e6, -1.0..1.0, 0.0..1e-6]), 1..40)
    ) {
        use std::fmt::Write;
        let mut text = String::from("solid\n");
        for corners in &triangles {
            text.push_str("facet normal 0 0 0\nouter loop\n");
            for [x, y, z] in corners {
                writeln!(text, "vertex {x} {y:e} {z}").unwrap();
            }
            text.push_str("endloop\nendfacet\n");
        }
        text.push_str("endsolid");
        for bytes in [binary(b"", &triangles), text.into_bytes()] {
            let loaded = load(&bytes).unwrap();
            prop_assert_eq!(corners(&loaded.scene.meshes[0]), triangles.clone());
        }
    }

    #[test]
    fn no_bytes_make_it_panic(bytes in prop::collection::vec(any::<u8>(), 0..400), cut in 0..999_usize) {
        let _ = load(&bytes);
        let _ = load(&[b"solid ".as_slice(), &bytes].concat());
        let _ = load(&TEXT.as_bytes()[..cut.min(TEXT.len())]);
        let _ = load(&binary(&bytes[..bytes.len().min(80)], &QUAD)[..cut.min(184)]);
    }
}
