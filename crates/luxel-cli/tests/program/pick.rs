//! `luxel pick`: what is under a place of the window, in a part of it, and for places by the
//! million.

use crate::program::{Folder, SQUARE_PLY, luxel};
use serde_json::{Value, json};

/// The square fills the window's centre: 100 pixels per unit, its lower left corner at (150, 150).
const FLAGS: &str =
    "--size 400x300 --eye 0.5,0,2 --target 0.5,0,0 --ortho 3 --near 1 --far 5 --cull none";

fn run(folder: &Folder, line: &str) -> crate::program::Run {
    folder.run(line.split_whitespace().chain(FLAGS.split_whitespace()))
}

fn square() -> Folder {
    let folder = Folder::new();
    folder.write("square.ply", SQUARE_PLY);
    folder
}

#[track_caller]
fn assert_near(value: &Value, expected: &[f64]) {
    let value: Vec<f64> =
        value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect();
    assert_eq!(value.len(), expected.len());
    for (a, b) in value.iter().zip(expected) {
        assert!((a - b).abs() < 1e-6, "{value:?} isn't {expected:?}");
    }
}

#[test]
fn a_hit_has_every_key_that_scripts_rely_on() {
    let folder = square();
    let document = run(&folder, "pick square.ply --at 180,120 --json").json();
    let hits = document["hits"].as_array().unwrap();
    assert_eq!(hits.len(), 1);
    let hit = &hits[0];
    assert_eq!(hit["index"], 0);
    assert_eq!(hit["object"], "square");
    assert_eq!(hit["path"].as_array().unwrap().last(), Some(&json!("square")));
    assert!(hit["triangle"] == 0 || hit["triangle"] == 1);
    let weights: f64 =
        hit["barycentric"].as_array().unwrap().iter().map(|w| w.as_f64().unwrap()).sum();
    assert!((weights - 1.0).abs() < 1e-6);
    // Pixel (180, 120) has its centre at (180.5, 120.5).
    assert_near(&hit["position"], &[0.305, 0.295, 0.0]);
    assert_near(&hit["normal"], &[0.0, 0.0, 1.0]);
    assert_eq!(hit["uv"], Value::Null);
    assert_near(&json!([hit["depth"]]), &[0.25]);
    let distance = f64::sqrt(4.0 + 0.195 * 0.195 + 0.295 * 0.295);
    assert_near(&json!([hit["distance"]]), &[distance]);
    assert_eq!(document["camera"]["view_from_world"].as_array().unwrap().len(), 16);
    // Decimals give that point, not the centre of a pixel.
    let document = run(&folder, "pick square.ply --at 180.0,120 --json").json();
    assert_near(&document["hits"][0]["position"], &[0.3, 0.3, 0.0]);
}

#[test]
fn a_pick_without_hits_succeeds() {
    let folder = square();
    for at in ["20,20", "-0.001,3.5", "399,299", "399.998,5", "399.999,299.9999"] {
        let document = run(&folder, &format!("pick square.ply --json --at {at}")).json();
        assert_eq!(document["hits"], json!([]), "{at}");
    }
    assert_eq!(run(&folder, "pick square.ply --at 20,20").text(), "nothing\n");
    let document = run(&folder, "pick square.ply --json --rect 0,0,20,20").json();
    assert_eq!(document["hits"], json!([]));
}

#[test]
fn a_position_outside_of_the_window_is_wrong_usage() {
    let folder = square();
    for at in ["-5.5,3.5", "-0.01,3.5", "400,5", "400.0,5", "5,300", "1e9,1e9"] {
        run(&folder, &format!("pick square.ply --at {at}")).failed(2, "outside of the picture");
    }
    for region in ["--rect 2000,2000,10,10", "--rect -9,5,9,9", "--lasso 5,300,9,300,7,400"] {
        run(&folder, &format!("pick square.ply {region}")).failed(2, "outside of the picture");
    }
    run(&folder, "pick square.ply --rect -9,5,9.5,9").done();
    let line = ["pick", "square.ply", "--size", "400x300", "--at", "-"];
    let run = folder.run_with_input(line, b"20,20\n400,5\n30,30\n");
    assert_eq!(run.status, Some(2));
    assert!(run.stderr.contains("400,5 lies outside of the picture"), "{}", run.stderr);
    assert_eq!(run.stdout, b"nothing\n", "answers up to the wrong line");
}

#[test]
fn picks_agree_with_the_layers_of_render() {
    let folder = Folder::new();
    let (width, height) = (97, 71);
    for demo in ["spheres", "cornell"] {
        let flags = format!("demo:{demo} --size {width}x{height} --azimuth 40");
        let mut layers = Vec::new();
        for layer in ["object", "triangle"] {
            let line = format!("render {flags} --samples 1 --layer {layer} -o {layer}.npy");
            folder.run(line.split_whitespace()).done();
            let file = folder.read(&format!("{layer}.npy"));
            let values = &file[file.len() - 4 * width * height..];
            let words: Vec<u32> =
                values.as_chunks::<4>().0.iter().map(|word| u32::from_le_bytes(*word)).collect();
            layers.push(words);
        }
        let places: String =
            (0..width * height).map(|at| format!("{},{}\n", at % width, at / width)).collect();
        let line = format!("pick {flags} --at - --json");
        let run = folder.run_with_input(line.split_whitespace(), places.as_bytes()).done();
        let text = String::from_utf8(run.stdout).unwrap();
        let mut seen = 0;
        for (at, line) in text.lines().enumerate() {
            let document: Value = serde_json::from_str(line).unwrap();
            let hit = document["hits"].as_array().unwrap().first();
            let told = hit.map_or([u64::from(u32::MAX); 2], |hit| {
                seen += 1;
                [hit["index"].as_u64().unwrap(), hit["triangle"].as_u64().unwrap()]
            });
            assert_eq!(told, [u64::from(layers[0][at]), u64::from(layers[1][at])], "pixel {at}");
            assert_eq!(document["camera"]["clip_from_view"].as_array().unwrap().len(), 16);
        }
        // The visible objects in a region are those of the layers there.
        let (left, top, wide, high) = (20, 11, 51, 40);
        let line = format!("pick {flags} --rect {left},{top},{wide},{high} --visible --json");
        let document = folder.run(line.split_whitespace()).json();
        let mut counts = std::collections::BTreeMap::new();
        for (x, y) in (top..top + high).flat_map(|y| (left..left + wide).map(move |x| (x, y))) {
            *counts.entry(u64::from(layers[0][y * width + x])).or_insert(0_u64) += 1;
        }
        counts.remove(&u64::from(u32::MAX));
        let told: std::collections::BTreeMap<u64, u64> = document["hits"]
            .as_array()
            .unwrap()
            .iter()
            .map(|hit| (hit["index"].as_u64().unwrap(), hit["pixels"].as_u64().unwrap()))
            .collect();
        assert_eq!(told, counts, "{demo}");
        assert_eq!(text.lines().count(), width * height);
        assert!(seen > 1000);
    }
}

#[test]
fn a_benchmark_reports_the_time_of_picks() {
    let report = luxel("bench demo:spheres --size 64x48 --frames 1 --json").json();
    assert!(report["pick_us"].as_f64().unwrap() > 0.0, "{report}");
    assert!(luxel("bench demo:spheres --size 64x48 --frames 1").text().contains("pick"));
}

#[test]
fn answers_follow_the_order_of_lines_up_to_an_invalid_one() {
    let folder = square();
    let args = ["pick", "square.ply", "--at", "-"];
    let args = args.into_iter().chain(FLAGS.split_whitespace());
    let run = folder.run_with_input(args, b"180,120\n\n20,20\r\nhere\n1,1\n");
    assert_eq!(run.status, Some(1));
    let lines = String::from_utf8(run.stdout).unwrap();
    assert_eq!(lines.lines().count(), 2, "{lines}");
    assert!(lines.lines().nth(1) == Some("nothing"), "{lines}");
    assert!(run.stderr.contains("line 4"), "{}", run.stderr);
    let args = ["pick", "-", "--format", "ply", "--at", "-"];
    folder.run_with_input(args, b"").failed(2, "model and positions can't both be");
}

#[test]
fn all_hits_at_a_position_are_listed_nearest_first() {
    let document =
        luxel("pick demo:cornell --size 200x150 --at 100,75 --through --cull none --json").json();
    let depths: Vec<f64> = document["hits"]
        .as_array()
        .unwrap()
        .iter()
        .map(|hit| hit["depth"].as_f64().unwrap())
        .collect();
    assert!(depths.len() > 1 && depths.is_sorted(), "{depths:?}");
}

#[test]
fn a_rectangle_lists_depths_and_triangles_of_the_objects_it_overlaps() {
    let folder = square();
    let document = run(&folder, "pick square.ply --rect 160,60,5,5 --json").json();
    let hit = &document["hits"][0];
    assert_eq!(hit["object"], "square");
    assert_eq!(hit["names"], hit["path"]);
    assert_near(&json!([hit["z_min"], hit["z_max"]]), &[0.25, 0.25]);
    assert_eq!(hit["triangles"], 1);
    let document = run(&folder, "pick square.ply --rect 0,0,400,300 --visible --json").json();
    assert_eq!(document["hits"][0]["triangles"], 2);
    assert_eq!(document["hits"][0]["pixels"], 100 * 100);
    let lasso = "--lasso 140,40,260,40,260,160,140,160 --json";
    let document = run(&folder, &format!("pick square.ply {lasso} --enclosed")).json();
    assert_eq!(document["hits"].as_array().unwrap().len(), 1);
    let document = run(&folder, "pick square.ply --rect 160,60,90,90 --enclosed --json").json();
    assert_eq!(document["hits"], json!([]));
}

#[test]
fn near_and_far_planes_clip_rectangles_and_positions() {
    let folder = square();
    for planes in ["--near 0.5 --far 1.9", "--near 2.1 --far 5"] {
        let flags = format!("{FLAGS} {planes}");
        for place in ["--at 180,120", "--rect 0,0,400,300"] {
            let line = format!("pick square.ply {place} --json {flags}");
            let document = folder.run(line.split_whitespace()).json();
            assert_eq!(document["hits"], json!([]), "{place} {planes}");
        }
    }
}

#[test]
fn a_position_snaps_to_the_nearest_vertex() {
    let folder = square();
    let document = run(&folder, "pick square.ply --at 153.5,146.5 --snap vertex --json").json();
    assert_near(&document["snap"]["position"], &[0.0, 0.0, 0.0]);
    assert_near(&document["snap"]["window"], &[150.0, 150.0]);
    let document = run(&folder, "pick square.ply --at 147.5,100.5 --snap edge --json").json();
    assert_near(&document["snap"]["position"], &[0.0, 0.495, 0.0]);
    assert_near(&json!([document["snap"]["pixels"]]), &[2.5]);
    assert_eq!(document["hits"], json!([]));
    let document = run(&folder, "pick square.ply --at 20,20 --snap vertex --json").json();
    assert_eq!(document["snap"], Value::Null);
}

#[test]
fn contradictory_queries_are_refused() {
    for (line, expected) in [
        ("pick", "--at"),
        ("pick --at 1,2 --rect 1,2,3,4", "--rect"),
        ("pick --rect 1,2,3", "four numbers"),
        ("pick --rect 1,2,0,4", "above 0"),
        ("pick --rect 1,2,3,4 --through", "--rect"),
        ("pick --at 1,2 --visible", "--visible"),
        ("pick --lasso 1,2,3,4", "three corners"),
        ("pick --at 1,nan", "finite"),
        ("pick --at 1,2 --snap corner", "corner"),
        ("pick --at 1,2 --within -1", "between 0 and"),
    ] {
        luxel(line).failed(2, expected);
    }
}

#[test]
fn trees_beyond_the_memory_limit_are_refused_before_building() {
    luxel("pick demo:plane --at 1,1 --max-memory 100K").failed(1, "tree");
    luxel("pick demo:plane --at 1,1 --max-memory 10M").done();
}
