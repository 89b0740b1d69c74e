use super::*;
use luxel_scene::{AlphaMode, Mesh};
use proptest::prelude::*;

fn load(bytes: &[u8]) -> Result<Loaded, Error> {
    read(bytes, "stem", &Limits::default())
}

fn mesh(text: &str) -> Mesh {
    load(text.as_bytes()).unwrap().scene.meshes.remove(0)
}

const HEAD: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
                    property float z\n";
const QUAD: &str = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

fn with_faces(count: usize, list: &str, faces: &str) -> String {
    format!(
        "{HEAD}element face {count}\nproperty list {list} vertex_indices\nend_header\n{QUAD}{faces}"
    )
}

#[test]
fn the_triangles_of_a_polygon_are_consecutive() {
    let mesh = mesh(&with_faces(2, "uchar int", "4 0 1 2 3\n3 2 1 0\n"));
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [2, 1, 0]]);
    assert_eq!(mesh.polygons, Some(vec![0, 0, 1]));
    assert_eq!(mesh.parts[0].count, 3);
}

#[test]
fn any_order_type_and_line_end_is_read() {
    let text = "ply\r\nformat ascii 1.0\r\ncomment x\r\nobj_info y\r\nelement face 1\r\n\
        property uchar flag\r\nproperty list uint8 uint16 vertex_index\r\nelement thing 1\r\n\
        property list char double stuff\r\nelement vertex 3\r\nproperty double z\r\n\
        property int32 y\r\nproperty short x\r\nproperty float confidence\r\nend_header\r\n\
        7 3 0 1 2\r\n2 0.5 0.5\r\n1.5 2 3 0\r\n4 5 6 0\r\n7 8 10 0\r\n";
    let mesh = mesh(text);
    assert_eq!(mesh.position(0).to_array(), [3.0, 2.0, 1.5]);
    assert_eq!(mesh.triangles, [[0, 1, 2]]);
}

#[test]
fn strips_swap_every_second_triangle_and_minus_one_restarts_them() {
    let text = format!(
        "{HEAD}element tristrips 1\nproperty list int int vertex_indices\nend_header\n{QUAD}\
         8 0 1 2 3 -1 3 1 0\n"
    );
    assert_eq!(mesh(&text).triangles, [[0, 1, 2], [2, 1, 3], [3, 1, 0]]);
}

#[test]
fn colours_are_linear_and_v_points_down() {
    let text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
        property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n\
        property uchar alpha\nproperty float s\nproperty float t\nproperty float nx\n\
        property float ny\nproperty float nz\nend_header\n0 0 0 255 0 188 51 0.25 0.25 0 0 2\n";
    let loaded = load(text.as_bytes()).unwrap();
    let mesh = &loaded.scene.meshes[0];
    let [r, g, b, a] = mesh.colors[0];
    // sRGB 188 is about a half in linear light.
    assert!(r == 1.0 && g == 0.0 && (b - 0.5).abs() < 5e-3 && a == 0.2, "{:?}", mesh.colors);
    assert_eq!(mesh.uvs[0], [[0.25, 0.75]]);
    assert_eq!(mesh.normals, [[0.0, 0.0, 1.0]]);
    assert_eq!(mesh.points[0].indices, [0]);
    assert_eq!(loaded.scene.materials[0].constants.diffuse, [1.0; 3]);
    assert_eq!(loaded.scene.materials[0].alpha_mode, AlphaMode::Blend);
}

#[test]
fn a_face_colour_fills_its_face_alone() {
    let text = format!(
        "{HEAD}element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\n\
         property uchar green\nproperty uchar blue\nend_header\n{QUAD}3 0 1 2 255 0 0\n\
         3 0 2 3 0 0 255\n"
    );
    let mesh = mesh(&text);
    assert_eq!(mesh.attribute_corners(), [[0, 1, 2], [3, 4, 5]]);
    assert_eq!(mesh.colors[0], [1.0, 0.0, 0.0, 1.0]);
    assert_eq!(mesh.colors[5], [0.0, 0.0, 1.0, 1.0]);
}

#[test]
fn errors_name_their_line() {
    let error = |text: &str| load(text.as_bytes()).unwrap_err().to_string();
    let text = with_faces(1, "uchar int", "3 0 1 4\n");
    assert_eq!(error(&text), "<input>:14: vertex 4 doesn't exist: there are 4");
    let text = with_faces(1, "uchar int", "3 0 1 -1\n");
    assert_eq!(error(&text), "<input>:14: vertex -1 doesn't exist: there are 4");
    let text = with_faces(1, "uchar int", "3 0 x 1\n");
    assert_eq!(error(&text), "<input>:14: row 0 of element `face`: `x` is not a number");
    let text = with_faces(2, "uchar int", "3 0 1 2\n3 1 2");
    assert!(error(&text).contains("row 1 of element `face`"));
    assert!(error("ply\nformat ascii 1.0\n").contains("`end_header` is missing"));
    assert!(error("ply\nformat ascii 1.0\nelement vertex -1\n").starts_with("<input>:3:"));
    assert!(error("plyx").starts_with("<input>:1:"));
}

#[test]
fn false_counts_fail_before_memory_is_allocated() {
    for count in ["4000000000", "9223372036854775807", "999999999999999999"] {
        for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
            let text = format!(
                "ply\nformat {format} 1.0\nelement vertex {count}\nproperty float x\nend_header\n1"
            );
            assert!(load(text.as_bytes()).is_err(), "{text}");
            let text = format!("ply\nformat {format} 1.0\nelement vertex {count}\nend_header\n1");
            // Rows without values: no vertex, or too many to index.
            if let Ok(loaded) = load(text.as_bytes()) {
                assert!(loaded.scene.meshes.is_empty());
            }
        }
    }
    let mut text = with_faces(1, "uint int", "").replace("ascii", "binary_little_endian");
    text.push_str("\u{7f}\u{7f}\u{7f}\u{7f}");
    assert!(load(text.as_bytes()).is_err());
}

#[test]
fn faces_with_infinite_corners_are_left_out_and_counted() {
    let text = with_faces(2, "uchar int", "4 0 1 2 3\n3 0 2 3\n").replace("1 0 0", "inf 0 0");
    let loaded = load(text.as_bytes()).unwrap();
    assert_eq!(loaded.scene.meshes[0].triangles, [[0, 2, 3]]);
    assert_eq!(loaded.warnings, ["1 face with a corner that is not finite was left out"]);
}

#[test]
fn edges_are_lines() {
    let text = format!(
        "{HEAD}element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n{QUAD}0 2\n"
    );
    let mesh = mesh(&text);
    assert_eq!(mesh.lines[0].segments, [[0, 2]]);
    assert!(mesh.points.is_empty());
}

/// Writes a mesh in each of the three encodings.
fn written(positions: &[[f32; 3]], faces: &[Vec<u8>], encoding: &str) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat {encoding} 1.0\nelement vertex {}\nproperty float x\nproperty float y\n\
         property double z\nelement face {}\nproperty list uchar ushort vertex_indices\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
        positions.len(),
        faces.len()
    )
    .into_bytes();
    let big = encoding == "binary_big_endian";
    let mut put = |mut value: Vec<u8>, text: String| {
        if encoding == "ascii" {
            bytes.extend(text.bytes().chain([b' ']));
        } else {
            if big {
                value.reverse();
            }
            bytes.extend(value);
        }
    };
    for [x, y, z] in positions {
        put(x.to_le_bytes().to_vec(), x.to_string());
        put(y.to_le_bytes().to_vec(), format!("{y:e}"));
        put(f64::from(*z).to_le_bytes().to_vec(), z.to_string());
    }
    for face in faces {
        put(vec![face.len() as u8], face.len().to_string());
        for &corner in face {
            put(u16::from(corner).to_le_bytes().to_vec(), corner.to_string());
        }
        for channel in [255, 0, face.len() as u8] {
            put(vec![channel], channel.to_string());
        }
    }
    bytes
}

const ENCODINGS: [&str; 3] = ["ascii", "binary_little_endian", "binary_big_endian"];

proptest! {
    #[test]
    fn all_encodings_give_back_what_was_written(
        positions in prop::collection::vec([-1e3_f32..1e3, -1.0..1.0, -1e-3..1e-3], 5..30),
        faces in prop::collection::vec(prop::collection::vec(0..5_u8, 3..6), 1..30),
        triangles_only in any::<bool>(),
    ) {
        let mut faces = faces;
        if triangles_only {
            faces.iter_mut().for_each(|face| face.truncate(3));
        }
        let meshes = ENCODINGS.map(|encoding| {
            load(&written(&positions, &faces, encoding)).unwrap().scene.meshes.remove(0)
        });
        let expected: usize = faces.iter().map(|face| face.len() - 2).sum();
        prop_assert_eq!(meshes[0].triangles.len(), expected);
        for (index, position) in positions.iter().enumerate() {
            let read = meshes[0].position(index as u32).as_vec3().to_array();
            prop_assert_eq!(read, *position);
        }
        prop_assert_eq!(&meshes[0], &meshes[1]);
        prop_assert_eq!(&meshes[0], &meshes[2]);
    }

    #[test]
    fn no_bytes_make_it_panic(
        bytes in prop::collection::vec(any::<u8>(), 0..200),
        which in 0..3_usize,
        change in prop::collection::vec((0..600_usize, any::<u8>()), 0..4),
    ) {
        let mut file = written(&[[0.0; 3]; 5], &[vec![0, 1, 2], vec![0, 1, 2, 3]], ENCODINGS[which]);
        for (at, byte) in change {
            let at = at % file.len();
            file[at] = byte;
        }
        let _ = load(&file);
        file.truncate(file.len() - bytes.len().min(file.len()));
        let _ = load(&file);
        file.extend(&bytes);
        let _ = load(&file);
    }
}
