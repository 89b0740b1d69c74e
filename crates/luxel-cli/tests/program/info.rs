//! `luxel info`: the contents of a file, and the camera that `render` would use.

use crate::program::{Folder, SQUARE_PLY, luxel};
use serde_json::{Value, json};

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

#[track_caller]
fn assert_near(value: &Value, expected: &[f64]) {
    let value = numbers(value);
    assert_eq!(value.len(), expected.len());
    for (a, b) in value.iter().zip(expected) {
        assert!((a - b).abs() < 1e-12, "{value:?} isn't {expected:?}");
    }
}

#[test]
fn the_document_has_every_key_that_scripts_rely_on() {
    let folder = Folder::new();
    folder.write("square.ply", SQUARE_PLY);
    let info = folder.run(["info", "square.ply", "--json"]).json();
    assert_eq!(info["format"], "ply");
    assert_eq!(info["triangles"], 2);
    assert_eq!(info["vertices"], 4);
    assert_eq!(info["bounds"], json!({ "min": [0.0, 0.0, 0.0], "max": [1.0, 1.0, 0.0] }));
    let objects = info["objects"].as_array().unwrap();
    assert_eq!(objects.len(), 1);
    assert_eq!(objects[0]["name"], "square");
    assert_eq!(objects[0]["triangles"], 2);
    assert_eq!(objects[0]["bounds"], info["bounds"]);
    assert_eq!(objects[0]["path"].as_array().unwrap().last(), Some(&json!("square")));
    for list in ["materials", "lights", "cameras", "warnings"] {
        assert!(info[list].is_array(), "{list}");
    }
    assert_eq!(numbers(&info["camera"]["view_from_world"]).len(), 16);
    assert_eq!(numbers(&info["camera"]["clip_from_view"]).len(), 16);
}

#[test]
fn info_prints_the_camera_of_the_flags_column_by_column() {
    let flags = "--size 200x100 --eye 0,0,5 --target 0,0,0 --fov 90 --near 1 --far 3";
    let info = luxel(&format!("info demo:cornell --json {flags}")).json();
    assert_near(
        &info["camera"]["view_from_world"],
        &[1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., -5., 1.],
    );
    // gluPerspective(90, 2, 1, 3)
    assert_near(
        &info["camera"]["clip_from_view"],
        &[0.5, 0., 0., 0., 0., 1., 0., 0., 0., 0., -2., -1., 0., 0., -3., 0.],
    );
}

#[test]
fn an_infinite_far_plane_gives_the_limit_of_the_matrix() {
    let flags = "--eye 0,0,5 --target 0,0,0 --near 1 --far infinity --size 1x1 --fov 90";
    let info = luxel(&format!("info demo:cornell --json {flags}")).json();
    assert_near(
        &info["camera"]["clip_from_view"],
        &[1., 0., 0., 0., 0., 1., 0., 0., 0., 0., -1., -1., 0., 0., -2., 0.],
    );
}

#[test]
fn parallel_rays_have_the_matrix_of_gl_ortho() {
    let flags = "--eye 0,0,5 --target 0,0,0 --ortho 4 --near -1 --far 3 --size 200x100";
    let info = luxel(&format!("info demo:cornell --json {flags}")).json();
    assert_near(
        &info["camera"]["clip_from_view"],
        &[0.25, 0., 0., 0., 0., 0.5, 0., 0., 0., 0., -0.5, 0., 0., 0., -0.5, 1.],
    );
}

#[test]
fn a_view_matrix_is_printed_unchanged() {
    let matrix = "0,0,1,0,0,1,0,0,-1,0,0,0,.25,-3,1e-3,1";
    let info = luxel(&format!("info demo:cornell --json --view-matrix {matrix}")).json();
    let expected = [0., 0., 1., 0., 0., 1., 0., 0., -1., 0., 0., 0., 0.25, -3., 1e-3, 1.];
    assert_near(&info["camera"]["view_from_world"], &expected);
}

#[test]
fn the_file_s_camera_is_used_unless_a_flag_overrides_it() {
    let view = |flags: &str| {
        luxel(&format!("info demo:cornell --json {flags}")).json()["camera"]["view_from_world"]
            .clone()
    };
    let of_file = view("");
    assert_eq!(view("--camera camera"), of_file);
    assert_eq!(view("--size 10x10 --fov 20"), of_file, "the lens moves no eye");
    assert_ne!(view("--azimuth 30"), of_file);
    luxel("info demo:cornell --camera nosuch").failed(1, "no camera `nosuch`");
}

#[test]
fn near_and_far_are_fitted_to_the_scene() {
    let info = luxel("info demo:teapot --json --eye 0,0,50 --target 0,0,0").json();
    let clip = numbers(&info["camera"]["clip_from_view"]);
    // From a = -(far + near) / (far - near), b = -2 far near / (far - near).
    let (a, b) = (clip[10], clip[14]);
    let (near, far) = (b / (a - 1.0), b / (a + 1.0));
    assert!(near < 48.0 && near > 47.5, "near {near}");
    assert!(far > 52.0 && far < 52.5, "far {far}");
}

#[test]
fn info_summarizes_a_file_without_geometry() {
    let folder = Folder::new();
    folder.write(
        "empty.ply",
        "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n\
         property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n",
    );
    folder.write("empty.gltf", r#"{"asset":{"version":"2.0"}}"#);
    for name in ["empty.ply", "empty.gltf"] {
        let info = folder.run(["info", name, "--json"]).json();
        assert_eq!(info["triangles"], 0, "{name}");
        assert_eq!(info["bounds"], Value::Null, "{name}");
        assert!(folder.run(["info", name]).text().contains("nothing to draw"), "{name}");
        folder.run(["render", name, "-o", "x.png"]).failed(1, "nothing to draw");
    }
    assert!(!folder.files().contains(&"x.png".to_owned()));
}

#[test]
fn warnings_are_in_the_document_and_on_the_standard_error() {
    let folder = Folder::new();
    folder.write("nan.ply", SQUARE_PLY.replace("1 0 0\n", "nan 0 0\n").replace("4 0", "3 0"));
    let run = folder.run(["info", "nan.ply", "--json"]);
    assert_eq!(run.status, Some(0));
    assert!(run.stderr.starts_with("luxel: warning: "), "{}", run.stderr);
    let info: Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(info["triangles"], 0);
    assert_eq!(info["warnings"].as_array().unwrap().len(), 1);
    folder.run(["info", "nan.ply", "--json", "--quiet"]).done();
    let told = folder.run(["info", "nan.ply", "-v"]);
    assert!(told.stderr.contains("read in"), "{}", told.stderr);
}

#[test]
fn vertices_alone_are_points_that_are_counted_and_drawn() {
    let folder = Folder::new();
    folder.write("cloud.obj", "v 0 0 0\nv 1 0 0\nv nan 1 0\nv 0 1 0\n");
    folder.write(
        "cloud.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
         property float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n",
    );
    for name in ["cloud.obj", "cloud.ply"] {
        let info = folder.run(["info", name, "--json"]).json();
        let counts = ["points", "lines", "triangles"].map(|what| info[what].as_u64());
        assert_eq!(counts, [Some(3), Some(0), Some(0)], "{name}");
        assert!(folder.run(["info", name]).text().contains("points     3"), "{name}");
        folder.run(["render", name, "-o", "x.png", "--size", "40x30"]).done();
    }
    folder.write("path.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\np 2\n");
    let info = folder.run(["info", "path.obj", "--json"]).json();
    assert_eq!([&info["points"], &info["lines"]], [1, 2]);
}

#[test]
fn lines_of_a_ply_header_without_a_keyword_are_warned_of_as_are_unused_properties() {
    let folder = Folder::new();
    let header = "ply\nformat ascii 1.0\nCreated by Blender 2.49\nelement vertex 3\n\
                  property float x\nproperty float y\nproperty float z\nproperty float quality\n\
                  element face 1\nproperty list uchar int vertex_indices\nproperty int flags\nend_header\n";
    folder.write("old.ply", format!("{header}0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2 9\n"));
    let info = folder.run(["info", "old.ply", "--json", "-q"]).json();
    assert_eq!(info["triangles"], 1);
    let warnings = info["warnings"].as_array().unwrap();
    let expected = [
        "line 3: `Created by Blender 2.49` is not a header line of PLY and is ignored",
        "properties that are not used: vertex quality, face flags",
    ];
    assert_eq!(warnings, &expected);
}

#[test]
fn text_in_utf_16_is_named_as_such() {
    let folder = Folder::new();
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let gltf = r#"{"asset":{"version":"2.0"}}"#;
    let scene = "format = \"luxel-scene\"\nversion = 1\n";
    let texts = [("a.obj", obj), ("a.ply", "ply\n"), ("a.stl", "solid\n"), ("a.gltf", gltf)];
    for (name, text) in texts.into_iter().chain([("a.toml", scene)]) {
        let units = || text.encode_utf16();
        let little: Vec<u8> = units().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = [0xfeff].into_iter().chain(units()).flat_map(u16::to_be_bytes).collect();
        for bytes in [little, big] {
            folder.write(name, bytes);
            let run = folder.run(["info", name]).failed(1, "text in UTF-16: save it as UTF-8");
            assert!(!run.stderr.contains("damaged"), "{}", run.stderr);
        }
    }
}

#[test]
fn a_missing_buffer_is_not_called_damage() {
    let folder = Folder::new();
    folder.write(
        "a.gltf",
        r#"{"asset":{"version":"2.0"},"buffers":[{"uri":"no.bin","byteLength":36}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}]}"#,
    );
    let run = folder.run(["info", "a.gltf"]).failed(1, "`no.bin` can't be read: No such file");
    assert!(run.stderr.contains("the model needs this file"), "{}", run.stderr);
    assert!(!run.stderr.contains("damaged"), "{}", run.stderr);
    #[cfg(unix)]
    {
        let made = std::process::Command::new("mkfifo").arg(folder.path("no.bin")).status();
        assert!(made.is_ok_and(|status| status.success()), "mkfifo");
        let run = folder
            .run(["info", "a.gltf"])
            .failed(1, "`no.bin` is not read: it is not a regular file");
        assert!(!run.stderr.contains("damaged"), "{}", run.stderr);
        std::fs::remove_file(folder.path("no.bin")).unwrap();
    }
    folder.write("no.bin", vec![0; 100_000]);
    let run = folder.run(["info", "a.gltf", "--max-memory", "50K"]).failed(1, "--max-memory");
    assert!(run.stderr.contains("no.bin") && !run.stderr.contains("damaged"), "{}", run.stderr);
}
