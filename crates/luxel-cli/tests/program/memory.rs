//! Memory stays within ten times the file and 50 MB, whatever small things the file is made of.

use crate::output::shell;
use crate::program::Folder;
use std::fmt::Write;

/// These commands do with so much memory: the file is read, and drawn. `ulimit -d` counts what a process may write to,
/// stacks included.
#[track_caller]
fn read_within_bounds(folder: &Folder, model: &str, bytes: usize) {
    let lines = [format!("info {model}"), format!("render {model} --size 64x48 -o x.png")];
    work_within_bounds(folder, &lines, bytes);
}

/// The same, with rays: picks and shadows.
#[track_caller]
fn traced_within_bounds(folder: &Folder, model: &str, bytes: usize) {
    let size = "--size 64x48";
    let lines = [
        format!("pick {model} {size} --at 32,24"),
        format!("render {model} {size} --shadows -o x.png"),
    ];
    work_within_bounds(folder, &lines, bytes);
}

#[track_caller]
fn work_within_bounds(folder: &Folder, lines: &[String], bytes: usize) {
    let kilobytes = (10 * bytes + 50_000_000) / 1024;
    for line in lines {
        let run = format!("ulimit -d {kilobytes} && \"$0\" {line} --quiet");
        let (status, message) = shell(folder, &run);
        assert_eq!(status, Some(0), "{line}, {kilobytes} kB: {message}");
    }
}

#[test]
fn tens_of_thousands_of_solids_take_ten_times_their_file() {
    let folder = Folder::new();
    let mut text = String::new();
    for z in 0..40_000 {
        let _ = write!(
            text,
            "solid {z}\nfacet normal 0 0 1\nouter loop\nvertex 0 0 {z}\nvertex 1 0 {z}\nvertex 0 1 {z}\n\
             endloop\nendfacet\nendsolid\n"
        );
    }
    folder.write("solids.stl", &text);
    read_within_bounds(&folder, "solids.stl", text.len());
    traced_within_bounds(&folder, "solids.stl", text.len());
}

#[test]
fn hundreds_of_thousands_of_unused_materials_take_ten_times_their_file() {
    let folder = Folder::new();
    let mut text = String::new();
    for number in 0..300_000 {
        let _ = writeln!(text, "newmtl m{number}\nKd 1 0 0");
    }
    folder.write("all.mtl", &text);
    let model = "mtllib all.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m7\nf 1 2 3\n";
    folder.write("one.obj", model);
    read_within_bounds(&folder, "one.obj", text.len() + model.len());
}

#[test]
fn hundreds_of_thousands_of_groups_take_ten_times_their_file() {
    let folder = Folder::new();
    let mut shared = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    let mut own = String::new();
    for number in 0..100_000 {
        let _ = writeln!(shared, "g g{number}\nf 1 2 3");
        let _ = writeln!(
            own,
            "v 0 0 {number}\nv 1 0 {number}\nv 0 1 {number}\ng g{number}\nf -3 -2 -1"
        );
    }
    for (name, text) in [("shared.obj", shared), ("own.obj", own)] {
        folder.write(name, &text);
        read_within_bounds(&folder, name, text.len());
        // Trees over triangles of their own are counted by `--max-memory`, beside what the file takes.
        if name == "shared.obj" {
            traced_within_bounds(&folder, name, text.len());
        }
    }
}

#[test]
fn hundreds_of_thousands_of_used_materials_take_ten_times_their_file() {
    let folder = Folder::new();
    let mut text = String::new();
    let mut model = String::from("mtllib all.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
    for number in 0..200_000 {
        let _ = writeln!(text, "newmtl m{number}\nKd .5 .5 .5");
        let _ = writeln!(model, "usemtl m{number}\nf 1 2 3");
    }
    folder.write("all.mtl", &text);
    folder.write("used.obj", &model);
    read_within_bounds(&folder, "used.obj", text.len() + model.len());
}

/// A document with these nodes, all of them roots, and a mesh of one triangle.
fn document(nodes: &[String]) -> String {
    let numbers: Vec<String> = (0..=nodes.len()).map(|number| number.to_string()).collect();
    format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{{"mesh":0}},{}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],"buffers":[{{"byteLength":36,
        "uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}],
        "bufferViews":[{{"buffer":0,"byteLength":36}}],"accessors":[{{"bufferView":0,
        "componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}}]}}"#,
        numbers.join(","),
        nodes.join(","),
    )
}

#[test]
fn a_million_nodes_without_anything_take_ten_times_their_file() {
    let folder = Folder::new();
    let text = document(&vec!["{}".to_owned(); 1_000_000]);
    folder.write("empty.gltf", &text);
    read_within_bounds(&folder, "empty.gltf", text.len());
}

#[test]
fn hundreds_of_thousands_of_instances_in_one_place_take_ten_times_their_file() {
    let folder = Folder::new();
    let text = document(&vec![r#"{"mesh":0}"#.to_owned(); 200_000]);
    folder.write("same.gltf", &text);
    read_within_bounds(&folder, "same.gltf", text.len());
    let pick = ["pick same.gltf --size 64x48 --at 32,24".to_owned()];
    work_within_bounds(&folder, &pick, text.len());
}

#[test]
fn hundreds_of_thousands_of_instances_side_by_side_take_ten_times_their_file() {
    let folder = Folder::new();
    let node = |number: usize| {
        format!(r#"{{"mesh":0,"translation":[{},{},0]}}"#, number % 450, number / 450)
    };
    let text = document(&(0..200_000).map(node).collect::<Vec<_>>());
    folder.write("grid.gltf", &text);
    read_within_bounds(&folder, "grid.gltf", text.len());
    traced_within_bounds(&folder, "grid.gltf", text.len());
}

#[test]
fn hundreds_of_thousands_of_instances_each_turned_differently_take_ten_times_their_file() {
    let folder = Folder::new();
    let node = |number: usize| {
        let (row, column) = (number / 450, number % 450);
        let [x, y, z, w] =
            [1 + number % 97, 1 + number % 101, 1 + row, 1 + column].map(|part| part as f64);
        let length = (x * x + y * y + z * z + w * w).sqrt();
        let [x, y, z, w] = [x, y, z, w].map(|part| part / length);
        format!(
            r#"{{"mesh":0,"translation":[{column},{row},0],"rotation":[{x:.4},{y:.4},{z:.4},{w:.4}]}}"#
        )
    };
    let text = document(&(0..200_000).map(node).collect::<Vec<_>>());
    folder.write("turned.gltf", &text);
    read_within_bounds(&folder, "turned.gltf", text.len());
    traced_within_bounds(&folder, "turned.gltf", text.len());
}

/// The trees that shadows need, in bytes, by the message of a run that may not take them.
fn trees_of(folder: &Folder, line: &str, limit: &str) -> u64 {
    let run = folder.run(line.split_whitespace().chain(["--max-memory", limit]));
    let message = run.failed(1, "--max-memory").stderr;
    assert!(message.contains("trees over"), "{line}: {message}");
    let before = message.split(" bytes").next().unwrap_or_default();
    before.rsplit(' ').next().and_then(|number| number.parse().ok()).expect("it says how much")
}

#[test]
fn trees_beyond_the_limit_are_refused_and_within_it_are_built() {
    let folder = Folder::new();
    let size = "demo:teapot --size 64x48";
    for line in [
        format!("render {size} -o x.png --shadows"),
        format!("render {size} -o x.png --ao --ao-rays 1"),
        format!("render {size} -o x.png --ground"),
        format!(
            "render {size} -o x.png --ground --layer depth --layer ambient --output-format exr"
        ),
        format!("explain {size} --at 32,24 --shadows"),
        format!("bench {size} --frames 1 --shadows"),
    ] {
        let needed = trees_of(&folder, &line, "200K");
        assert!(folder.files().is_empty(), "{line}");
        let run = |limit: u64| {
            let limit = ["--max-memory".to_owned(), limit.to_string()];
            folder.run(line.split_whitespace().map(str::to_owned).chain(limit))
        };
        run(needed - 1).failed(1, "--max-memory");
        let done = run(needed);
        assert_eq!(done.status, Some(0), "{line}: {}", done.stderr);
        let _ = std::fs::remove_file(folder.path("x.png"));
    }
    // Without rays there are no trees.
    let line = format!("render {size} -o x.png --max-memory 200K");
    folder.run(line.split_whitespace()).done();
}

/// Whether a line works with so many kilobytes.
fn works_within(folder: &Folder, line: &str, kilobytes: u64) -> bool {
    let run = format!("ulimit -d {kilobytes} && \"$0\" {line} --quiet 2> /dev/null");
    shell(folder, &run).0 == Some(0)
}

#[cfg(target_os = "linux")]
#[test]
fn trees_take_no_more_than_the_limit_counts() {
    let folder = Folder::new();
    let side = 400;
    let mut sheet = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        side * side,
        2 * (side - 1) * (side - 1)
    );
    for at in 0..side * side {
        let _ = writeln!(sheet, "{} {} {}", at % side, at / side, at * 7 % 10);
    }
    for a in (0..side * (side - 1)).filter(|at| at % side != side - 1) {
        let b = a + side;
        let _ = writeln!(sheet, "3 {a} {} {b}\n3 {} {} {b}", a + 1, a + 1, b + 1);
    }
    folder.write("sheet.ply", sheet);
    let mut small = String::from("vt 0 0\n");
    for number in 0..30_000 {
        let (x, y) = (number % 200, number / 200);
        // Objects with texture coordinates share no mesh with those without.
        let corners = ["-3 -2 -1", "-3/1 -2/1 -1/1"][number % 2];
        let _ =
            writeln!(small, "v {x} {y} 0\nv {x}.5 {y} 0\nv {x} {y}.5 0\no {number}\nf {corners}");
    }
    folder.write("small.obj", small);
    // Of many small things, heaps of several threads take more or less from run to run.
    for (model, threads) in [("sheet.ply", 2), ("small.obj", 1)] {
        let plain = format!("render {model} --size 64x48 --samples 1 --threads {threads} -o x.png");
        let shadows = format!("{plain} --shadows");
        let needed = trees_of(&folder, &shadows, "30M") / 1024;
        // What it takes without trees, to a few megabytes.
        let (mut fails, mut works) = (0, 500_000);
        while works - fails > 2_000 {
            let middle = (fails + works) / 2;
            if works_within(&folder, &plain, middle) {
                works = middle;
            } else {
                fails = middle;
            }
        }
        assert!(works_within(&folder, &plain, works), "{model}: {works} kB");
        assert!(works_within(&folder, &shadows, works + needed), "{model}: {works} + {needed} kB");
    }
}
