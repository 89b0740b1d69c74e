//! Answers of picks.

use crate::fixture::{ON_THE_TEAPOT, SIZE, teapot, view};
use luxel_pick::{Inclusion, PickView, Picker, Region, SnapTo};
use luxel_render::Cull;
use luxel_report::{PickReport, RegionReport, camera_to_json};
use serde_json::Value;
use std::collections::BTreeMap;

fn read(json: &[u8]) -> Value {
    serde_json::from_slice(json).unwrap()
}

#[test]
fn a_pick_reads_back_as_json_and_is_a_line_of_text() {
    let scene = teapot();
    let picker = Picker::new(scene.clone()).unwrap();
    let pick = PickView::new(&picker, view(&scene).camera, SIZE, Cull::Auto).unwrap();
    let at = ON_THE_TEAPOT.map(|side| f64::from(side) + 0.5);
    let hits = pick.through(at);
    assert!(hits.len() > 1);
    let report = PickReport::new(&pick, at, &hits);
    let document = report.to_json();
    assert_eq!(document["hits"].as_array().unwrap().len(), hits.len());
    assert_eq!(document["hits"][0]["distance"].as_f64(), Some(hits[0].distance));
    assert_eq!(document["camera"], camera_to_json(pick.camera(), pick.size()));
    assert!(document.get("snap").is_none());
    let text = report.to_text();
    assert_eq!(text.lines().count(), hits.len());
    assert!(text.starts_with("teapot/"), "{text}");

    // A line for many answers holds the same.
    let mut line = Vec::new();
    let camera = camera_to_json(pick.camera(), pick.size()).to_string();
    report.append_json_line(&camera, &mut line);
    assert_eq!(line.pop(), Some(b'\n'));
    let text = document.to_string();
    assert_eq!(read(&line), read(text.as_bytes()));
}

#[test]
fn nothing_is_an_answer_too() {
    let scene = teapot();
    let picker = Picker::new(scene.clone()).unwrap();
    let pick = PickView::new(&picker, view(&scene).camera, SIZE, Cull::Auto).unwrap();
    let at = [0.5, 0.5];
    let snapped = pick.snap(at, SnapTo::Vertex, 2.0);
    let report = PickReport::new(&pick, at, &[]).with_snap(snapped.as_ref());
    assert_eq!(report.to_text(), "nothing\nnothing to snap to\n");
    let document = report.to_json();
    assert_eq!(document["hits"], Value::Array(Vec::new()));
    assert_eq!(document.get("snap"), Some(&Value::Null));
    assert_eq!(RegionReport::new(&pick, &[]).to_text(), "nothing\n");
}

#[test]
fn a_region_lists_objects_and_their_pixels() {
    let scene = teapot();
    let picker = Picker::new(scene.clone()).unwrap();
    let pick = PickView::new(&picker, view(&scene).camera, SIZE, Cull::Auto).unwrap();
    let region = Region::rectangle(0.0, 0.0, 96.0, 54.0).unwrap();
    let hits = pick.sliver(&region, Inclusion::Touching);
    let pixels: BTreeMap<_, _> =
        pick.visible_in(&region).into_iter().map(|seen| (seen.object, seen.pixels)).collect();
    let report = RegionReport::new(&pick, &hits).with_pixels(&pixels);
    let document = report.to_json();
    let entries = document["hits"].as_array().unwrap();
    assert_eq!(entries.len(), hits.len());
    for (entry, hit) in entries.iter().zip(&hits) {
        assert_eq!(entry["index"].as_u64(), Some(hit.object as u64));
        assert_eq!(entry["pixels"].as_u64(), pixels.get(&hit.object).copied());
    }
    assert_eq!(report.to_text().lines().count(), hits.len());
}
