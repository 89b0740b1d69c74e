//! `luxel check`: reports and exit status.

use crate::program::{Folder, SQUARE_PLY, luxel};
use luxel_testing::models;
use serde_json::Value;

/// A square of two triangles with opposite winding.
const TWISTED_PLY: &str = "\
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0 1 0
3 0 1 2
3 0 3 2
";

#[test]
fn check_exits_with_0_for_a_valid_mesh_and_3_for_a_faulty_one() {
    let folder = Folder::new();
    folder.write("sound.ply", SQUARE_PLY);
    folder.write("twisted.ply", TWISTED_PLY);
    let sound = folder.run(["check", "sound.ply"]).text();
    assert_eq!(sound, "sound.ply: nothing found in 2 triangles\n");
    let run = folder.run(["check", "twisted.ply"]);
    assert_eq!((run.status, run.stderr.as_str()), (Some(3), ""));
    let text = String::from_utf8(run.stdout).unwrap();
    assert!(text.starts_with("twisted.ply: 1 kind of finding in 2 triangles\n"), "{text}");
    assert!(text.contains("\ninconsistent-winding  1, not visible in luxel\n"), "{text}");
    assert!(text.contains("  cure: make the winding consistent"), "{text}");
}

#[test]
fn the_document_has_every_key_that_scripts_rely_on() {
    let folder = Folder::new();
    folder.write("sound.ply", SQUARE_PLY);
    folder.write("twisted.ply", TWISTED_PLY);
    let sound = folder.run(["check", "sound.ply", "--json"]).json();
    assert_eq!(sound["findings"], Value::Array(Vec::new()));
    let run = folder.run(["check", "twisted.ply", "--json"]);
    assert_eq!(run.status, Some(3));
    let document: Value = serde_json::from_slice(&run.stdout).unwrap();
    let finding = &document["findings"][0];
    assert_eq!(finding["kind"], "inconsistent-winding");
    assert_eq!(finding["count"], 1);
    // luxel splits normals between opposite windings: on a flat square nothing shows.
    assert_eq!(finding["severity"], 0.0);
    assert!(finding["cure"].as_str().unwrap().len() > 10);
    let place = &finding["places"][0];
    assert_eq!(place["object"], "twisted");
    assert_eq!(place["path"], serde_json::json!(["twisted"]));
    assert_eq!(place["triangle"], 1);
    assert!((place["position"][0].as_f64().unwrap() - 1.0 / 3.0).abs() < 1e-6);
}

#[test]
fn check_reports_normals_that_readers_repair() {
    let folder = Folder::new();
    let with_normals = |normals: &str| {
        let head = SQUARE_PLY.replace(
            "property float z\n",
            "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n",
        );
        let mut normals = normals.split(';');
        let rows: Vec<String> = head
            .lines()
            .map(|line| match line.split(' ').count() {
                3 if !line.starts_with(|c: char| c.is_alphabetic()) => {
                    format!("{line} {}", normals.next().unwrap())
                }
                _ => line.to_owned(),
            })
            .collect();
        rows.join("\n") + "\n"
    };
    let found = |normals: &str| -> Vec<(String, u64)> {
        folder.write("n.ply", with_normals(normals));
        let run = folder.run(["check", "n.ply", "--json", "-q"]);
        let document: Value = serde_json::from_slice(&run.stdout).unwrap();
        let findings = document["findings"].as_array().unwrap().iter();
        findings
            .map(|f| (f["kind"].as_str().unwrap().to_owned(), f["count"].as_u64().unwrap()))
            .collect()
    };
    assert_eq!(found("0 0 1;0 0 1;0 0 1;0 0 1"), []);
    assert_eq!(found("0 0 2;0 0 1;0 0 .5;0 0 1"), [("non-unit-normal".to_owned(), 2)]);
    assert_eq!(found("0 0 0;0 0 1;nan 0 1;0 0 1"), [("undefined-normal".to_owned(), 2)]);
    folder.write("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 3\nvn 0 0 1\nf 1//1 2//2 3//1\n");
    let run = folder.run(["check", "n.obj", "--json"]);
    let document: Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(document["findings"][0]["kind"], "non-unit-normal");
    assert_eq!(document["findings"][0]["count"], 2);
}

#[test]
fn marks_are_written_as_an_image() {
    let folder = Folder::new();
    folder.write("twisted.ply", TWISTED_PLY);
    let run = folder.run(["check", "twisted.ply", "-o", "marks.ppm", "--size", "60x40"]);
    assert_eq!(run.status, Some(3));
    let bytes = folder.read("marks.ppm");
    let pixels: Vec<_> = bytes["P6\n60 40\n255\n".len()..].chunks(3).collect();
    let is_red = |pixel: &&&[u8]| pixel[0] > 200 && pixel[1] < 100;
    let is_grey = |pixel: &&&[u8]| pixel[0] > 30 && pixel[0].abs_diff(pixel[2]) < 20;
    assert!(pixels.iter().filter(is_red).count() > 100);
    assert!(pixels.iter().filter(is_grey).count() > 100);
    // Only one kind is marked: with others the model stays grey.
    let only = |kind: &str| {
        let line = ["check", "twisted.ply", "-o", "marks.ppm", "--size", "60x40", "--layer", kind];
        assert_eq!(folder.run(line).status, Some(3));
        folder.read("marks.ppm")
    };
    assert!(only("inconsistent-winding") == bytes);
    let others = only("sliver");
    let pixels: Vec<_> = others["P6\n60 40\n255\n".len()..].chunks(3).collect();
    assert_eq!(pixels.iter().filter(is_red).count(), 0);
    assert!(pixels.iter().filter(is_grey).count() > 100);
    let wrong = ["check", "twisted.ply", "-o", "marks.ppm", "--layer", "slivers"];
    folder.run(wrong).failed(2, "did you mean `sliver`?");
    folder.run(["check", "twisted.ply", "--layer", "sliver"]).failed(2, "--output");
    folder.run(["check", "twisted.ply", "-o", "marks.exr"]).failed(2, ".png or .ppm");
    assert_eq!(folder.files(), ["marks.ppm", "twisted.ply"]);
}

/// The pixels of a PPM.
fn ppm(folder: &Folder, line: &[&str], [width, height]: [usize; 2]) -> Vec<[u8; 3]> {
    let size = format!("{width}x{height}");
    let run = folder.run(line.iter().copied().chain(["-o", "marks.ppm", "--size", &size]));
    assert_eq!(run.status, Some(3));
    let bytes = folder.read("marks.ppm");
    let head = format!("P6\n{width} {height}\n255\n").len();
    bytes[head..].chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

#[test]
fn marks_of_edges_are_thick_and_have_a_dark_rim() {
    let folder = Folder::new();
    // Two squares whose middle edge a third triangle shares: one upright line in the picture.
    folder.write(
        "fin.obj",
        "v -1 -1 0\nv 0 -1 0\nv 1 -1 0\nv -1 1 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\n\
         f 1 2 5 4\nf 2 3 6 5\nf 2 5 7\n",
    );
    let line = ["check", "fin.obj", "--eye", "0,0,9", "--target", "0,0,0"];
    let pixels = ppm(&folder, &line, [640, 480]);
    let document = folder.run(line.into_iter().chain(["--json"]));
    let document: Value = serde_json::from_slice(&document.stdout).unwrap();
    assert_eq!(document["findings"][0]["kind"], "non-manifold-edge");
    let hex = document["findings"][0]["color"].as_str().unwrap();
    let channel = |at: usize| u8::from_str_radix(&hex[at..at + 2], 16).unwrap();
    let color = [channel(1), channel(3), channel(5)];
    // Across the edge, a little above its middle.
    let row = &pixels[200 * 640..][..640];
    let core: Vec<usize> = (300..340).filter(|&x| row[x] == color).collect();
    assert!(core.len() >= 2, "the line is {} pixels wide", core.len());
    for beside in [core[0] - 2, core[core.len() - 1] + 2] {
        let dark = row[beside].iter().all(|&value| value < 60);
        assert!(dark, "no rim at {beside}: {:?}", row[beside]);
    }
}

#[test]
fn a_legend_names_the_kinds_that_are_drawn_in_their_colours() {
    let folder = Folder::new();
    folder.write("twisted.ply", TWISTED_PLY);
    let size = [640, 480];
    let drawn = ppm(&folder, &["check", "twisted.ply"], size);
    let other = ppm(&folder, &["check", "twisted.ply", "--layer", "sliver"], size);
    // Text is only in the legend, and only if something is drawn.
    let text = |pixels: &[[u8; 3]]| {
        let is_text = |pixel: &&[u8; 3]| pixel.iter().all(|&value| value > 0xa0);
        pixels.iter().filter(is_text).count()
    };
    assert!(text(&drawn) > 150, "{} pixels of text", text(&drawn));
    assert_eq!(text(&other), 0);
    // Beside it lies a sample of the colour: in a corner, far from the model.
    let red = |at: usize| drawn[at][0] > 200 && drawn[at][1] < 100;
    let corner = (420..480).flat_map(|y| (0..60).map(move |x| y * 640 + x));
    assert!(corner.filter(|&at| red(at)).count() >= 100, "the legend has no sample");
}

#[test]
fn check_of_an_unreadable_file_exits_with_1() {
    luxel("check missing.obj").failed(1, "missing.obj");
}

/// The findings in public models; `docs/check.md` explains each.
const MODELS: &[(&str, &[&str])] = &[
    ("DepthOfFieldExample.glb", &[]),
    ("VertexColorTest/VertexColorTest.gltf", &[]),
    ("bunny.ply", &[]),
    ("busted.STL", &[]),
    ("cornell_box/cornell_box.obj", &[]),
    ("spot/spot.obj", &[]),
    ("two_objects_ascii.stl", &[]),
    ("teapot.obj", &["duplicate-vertex"]),
    ("suzanne.ply", &["unrepresentative-normals", "hidden-fold"]),
    ("featuretype.STL", &["crack", "sliver"]),
    ("octagonal_pocket.stl", &["crack", "sliver"]),
];

#[test]
fn the_findings_in_public_models_are_the_known_ones() {
    let Some(folder) = models::folder() else { return };
    for (name, expected) in MODELS {
        let path = folder.join(name).into_os_string().into_string().unwrap();
        let run = luxel(&format!("check {path} --json -q"));
        let document: Value = serde_json::from_slice(&run.stdout).unwrap();
        let findings = document["findings"].as_array().unwrap();
        let kinds: Vec<_> = findings.iter().map(|f| f["kind"].as_str().unwrap()).collect();
        assert_eq!(kinds, *expected, "{name}");
        assert_eq!(run.status, Some(if expected.is_empty() { 0 } else { 3 }), "{name}");
    }
}

#[test]
fn twenty_thousand_marks_in_one_place_are_drawn_in_seconds() {
    let folder = Folder::new();
    let same = "f 1 2 3\n".repeat(20_000);
    folder.write("same.obj", format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{same}"));
    let start = std::time::Instant::now();
    let run = folder.run(["check", "same.obj", "-o", "x.png"]);
    assert_eq!(run.status, Some(3), "{}", run.stderr);
    // Each alone takes two milliseconds, far more in a build for tests.
    assert!(start.elapsed() < std::time::Duration::from_secs(30), "{:?}", start.elapsed());
}
