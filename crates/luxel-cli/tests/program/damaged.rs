//! Damaged and hostile input fails fast, with status 1, an error with its place, and no output
//! file.

use crate::program::{Folder, SQUARE_PLY, luxel};
use std::time::{Duration, Instant};

/// Time limit of a refusal, on a busy machine.
const SOON: Duration = Duration::from_secs(20);

/// Both commands refuse the file with an error that names it.
#[track_caller]
fn refused(name: &str, bytes: impl AsRef<[u8]>, expected: &str) {
    let folder = Folder::new();
    folder.write(name, bytes);
    let start = Instant::now();
    for line in [["info", name, "--json", "-q"], ["render", name, "-o", "out.png"]] {
        let run = folder.run(line).failed(1, expected);
        assert!(run.stderr.contains(name), "the file is named: {}", run.stderr);
    }
    assert!(start.elapsed() < SOON, "{:?}", start.elapsed());
    assert_eq!(folder.files(), [name], "a file is left behind");
}

#[test]
fn the_error_of_a_missing_file_names_it() {
    luxel("info nosuch.glb").failed(1, "nosuch.glb");
    luxel("render nosuch.ply -o a.png").failed(1, "nosuch.ply");
    let folder = Folder::new();
    std::fs::create_dir(folder.path("folder.obj")).unwrap();
    folder.run(["info", "folder.obj"]).failed(1, "folder.obj: this is a folder");
    folder.run(["info", "."]).failed(1, "this is a folder");
    folder.write("model.xyz", "1 2 3");
    folder.run(["info", "model.xyz"]).failed(1, "glb, gltf, obj, stl or ply");
}

#[test]
fn empty_files_of_strict_formats_are_refused() {
    for name in ["a.glb", "a.gltf", "a.stl", "a.ply"] {
        refused(name, "", "");
    }
}

#[test]
fn indices_out_of_range_are_errors_with_their_line() {
    refused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "a.obj:4");
    refused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "a.obj:4");
    refused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "a.obj:4");
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
               property float z\nelement face 1\nproperty list uchar int vertex_indices\n\
               end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n";
    refused("a.ply", ply, "7");
}

#[test]
fn false_counts_are_refused_before_allocation() {
    let ply = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex 4000000000\nproperty float x\n\
             property float y\nproperty float z\nelement face 4000000000\n\
             property list uchar int vertex_indices\nend_header\n0 0 0\n"
        )
    };
    refused("a.ply", ply("ascii"), "");
    refused("a.ply", ply("binary_little_endian"), "");
    let mut stl = vec![0; 84];
    stl[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    refused("a.stl", stl, "");
    let mut glb = b"glTF".to_vec();
    for word in [2, u32::MAX, 0xffff_fff0, 0x4e4f_534a] {
        glb.extend(word.to_le_bytes());
    }
    refused("a.glb", glb, "");
}

#[test]
fn truncated_binaries_are_refused() {
    let mut stl = vec![0; 84 + 50 * 3 - 7];
    stl[80..84].copy_from_slice(&3_u32.to_le_bytes());
    refused("a.stl", stl, "");
    refused("a.glb", b"glTF\x02\0\0\0", "");
    refused("a.gltf", r#"{"asset":{"version":"2.0"},"nodes":[{"#, "");
}

#[test]
fn errors_in_gltf_documents_have_a_json_pointer() {
    let document = |rest: &str| format!(r#"{{"asset":{{"version":"2.0"}},{rest}}}"#);
    let cycle = r#""scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"children":[0]}]"#;
    refused("a.gltf", document(cycle), "/nodes/");
    let beyond = r#""scene":0,"scenes":[{"nodes":[7]}],"nodes":[{}]"#;
    refused("a.gltf", document(beyond), "/scenes/0");
    let needed = r#""extensionsRequired":["ACME_teleport"]"#;
    refused("a.gltf", document(needed), "ACME_teleport");
    let deep = "[".repeat(100_000);
    refused("a.gltf", document(&format!(r#""extras":{deep}"#)), "");
}

#[test]
fn a_uri_that_leads_out_of_the_folder_is_refused() {
    for uri in ["../secret.bin", "/etc/passwd", "a/../../secret.bin", "%2e%2e/secret.bin"] {
        let document = format!(
            r#"{{"asset":{{"version":"2.0"}},
                "buffers":[{{"uri":"{uri}","byteLength":36}}],
                "bufferViews":[{{"buffer":0,"byteLength":36}}],
                "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
                    "min":[0,0,0],"max":[1,1,0]}}],
                "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
                "nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}],"scene":0}}"#
        );
        refused("a.gltf", document, "/buffers/0");
    }
}

#[test]
fn faces_with_nan_corners_are_left_out() {
    let folder = Folder::new();
    let faces = "3 0 1 2\n3 0 2 3\n3 0 1 4\n3 0 1 5\n";
    let vertices = "0 1 0\ninf 0 0\n0 nan 0\n";
    let text = SQUARE_PLY.replace("vertex 4", "vertex 6").replace("face 1", "face 4");
    folder.write("a.ply", text.replace("0 1 0\n", vertices).replace("4 0 1 2 3\n", faces));
    let run = folder.run(["render", "a.ply", "-o", "a.png", "--size", "32x32", "--json"]);
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let report: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(report["triangles"], 2);
    assert_eq!(report["warnings"].as_array().unwrap().len(), 1);
}

#[test]
fn a_file_beyond_the_memory_limit_is_refused() {
    let folder = Folder::new();
    let long =
        SQUARE_PLY.replace("end_header", &format!("comment {}\nend_header", "x".repeat(9999)));
    folder.write("a.ply", &long);
    folder.run(["info", "a.ply", "--max-memory", "1K"]).failed(1, "--max-memory");
    folder
        .run_with_input(["info", "-", "--format", "ply", "--max-memory", "1K"], long.as_bytes())
        .failed(1, "--max-memory");
}

#[test]
fn random_bytes_never_crash_a_reader() {
    let folder = Folder::new();
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    for round in 0..8 {
        let mut bytes = Vec::new();
        for _ in 0..(1 << round) * 8 {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            bytes.extend(state.to_le_bytes());
        }
        for name in ["a.glb", "a.gltf", "a.obj", "a.stl", "a.ply"] {
            folder.write(name, &bytes);
            let run = folder.run(["info", name]);
            assert!(matches!(run.status, Some(0 | 1)), "{name}: {}", run.stderr);
            assert!(!run.stderr.contains("bug in luxel"), "{name}: {}", run.stderr);
        }
    }
}

#[test]
fn copies_of_a_triangle_that_fills_the_window_take_no_minutes() {
    let folder = Folder::new();
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    folder.write("one.obj", format!("{corners}f 1 2 3\n"));
    folder.write("same.obj", format!("{corners}{}", "f 1 2 3\n".repeat(1_000_000)));
    let groups: String = (0..50_000).map(|group| format!("g {group}\nf 1 2 3\n")).collect();
    folder.write("groups.obj", format!("{corners}{groups}"));
    // Two thousand nodes show a mesh of two thousand primitives, all of one triangle: four million draws.
    let primitive = r#"{"attributes":{"POSITION":0}}"#;
    let positions = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    let gltf = |nodes: usize, primitives: usize| {
        let numbers: Vec<_> = (0..nodes).map(|node| node.to_string()).collect();
        format!(
            r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],
            "meshes":[{{"primitives":[{}]}}],"buffers":[{{"byteLength":36,
            "uri":"data:application/octet-stream;base64,{positions}"}}],
            "bufferViews":[{{"buffer":0,"byteLength":36}}],"accessors":[{{"bufferView":0,
            "componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}}]}}"#,
            numbers.join(","),
            vec![r#"{"mesh":0}"#; nodes].join(","),
            vec![primitive; primitives].join(","),
        )
    };
    folder.write("one.gltf", gltf(1, 1));
    folder.write("nodes.gltf", gltf(2000, 2000));
    let draw = |name: &str| {
        let flags = ["--size", "320x240", "--color", ".8,.7,.6", "-o", "-"];
        folder.run(["render", name].into_iter().chain(flags)).done().stdout
    };
    let expected = [draw("one.obj"), draw("one.gltf")];
    for (name, of) in [("same.obj", 0), ("groups.obj", 0), ("nodes.gltf", 1)] {
        let start = Instant::now();
        assert!(draw(name) == expected[of], "{name} is not drawn as a single triangle");
        // Of a million triangles under a pixel, in one pass.
        let explained =
            folder.run(["explain", name, "--at", "160,100", "--size", "320x240"]).done();
        assert!(!explained.stdout.is_empty());
        assert!(start.elapsed().as_secs() < 60, "{name}: {:?}", start.elapsed());
    }
}
