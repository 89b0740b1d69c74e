//! The tree of nodes of glTF documents.

mod documents;

use documents::Document;
use luxel_formats::{Format, Limits, read};
use luxel_scene::DVec3;
use serde_json::{Value, json};

fn tree(nodes: Value, roots: Value) -> Document {
    let mut document = Document::triangle();
    document.json["nodes"] = nodes;
    document.json["scenes"][0]["nodes"] = roots;
    document
}

fn names(document: &Document) -> Vec<String> {
    document.load().scene.nodes.iter().map(|node| node.name.to_string()).collect()
}

#[test]
fn nodes_are_walked_a_branch_after_the_other() {
    let document = tree(
        json!([
            {"name": "a", "children": [3, 1]}, {"name": "b"}, {"name": "c"}, {"name": "d"},
            {"name": "not shown"},
        ]),
        json!([2, 0]),
    );
    assert_eq!(names(&document), ["c", "a", "d", "b"]);
}

#[test]
fn nodes_without_names_are_called_by_mesh_or_number() {
    let mut document = tree(json!([{"mesh": 0, "children": [1]}, {"name": ""}]), json!([0]));
    assert_eq!(names(&document), ["node_0", "node_1"]);
    document.json["meshes"][0]["name"] = json!("wheel");
    assert_eq!(names(&document), ["wheel", "node_1"]);
}

#[test]
fn the_shown_scene_is_the_default_the_first_or_all() {
    let mut document = tree(json!([{"name": "a"}, {"name": "b", "children": [2]}, {}]), json!([0]));
    document.push("scenes", json!({"nodes": [1]}));
    assert_eq!(names(&document), ["a"]);
    document.json["scene"] = json!(1);
    assert_eq!(names(&document), ["b", "node_2"]);
    document.json["scene"] = Value::Null;
    assert_eq!(names(&document), ["a"]);
    document.json["scenes"] = json!([]);
    assert_eq!(names(&document), ["a", "b", "node_2"]);
    document.json["scene"] = json!(4);
    assert_eq!(document.fault().0, "/scene");
}

#[test]
fn places_are_scaled_then_turned_then_moved() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let document = tree(
        json!([
            {"children": [1], "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 10, 1]},
            // A quarter turn about z takes +x to +y. Not quite of unit length, as exporters write.
            {"mesh": 0, "translation": [1.0, 0.0, 0.0], "scale": [3.0, 1.0, 1.0],
             "rotation": [0.0, 0.0, 2.0 * half, 2.0 * half]},
        ]),
        json!([0]),
    );
    let scene = document.load().scene;
    let world = scene.objects()[0].world_from_mesh.matrix();
    let x = world.transform_point3(DVec3::X);
    assert!(x.abs_diff_eq(DVec3::new(1.0, 3.0, 10.0), 1e-12), "{x}");
}

#[test]
fn a_mesh_of_two_nodes_is_two_objects() {
    let document = tree(json!([{"mesh": 0}, {"mesh": 0, "scale": [-1, 1, 1]}]), json!([0, 1]));
    let scene = document.load().scene;
    assert_eq!(scene.meshes.len(), 1);
    assert_eq!(scene.objects().len(), 2);
    assert_eq!(scene.triangle_count(), 2);
}

#[test]
fn cycles_and_second_parents_are_errors() {
    for (nodes, pointer) in [
        (json!([{"children": [0]}]), "/nodes/0/children"),
        (json!([{"children": [1]}, {"children": [2]}, {"children": [1]}]), "/nodes/2/children/0"),
        (json!([{"children": [1]}, {}, {"children": [1]}]), "/nodes/2/children/0"),
        (json!([{"children": [1, 1]}, {}]), "/nodes/0/children/1"),
        (json!([{"children": [9]}]), "/nodes/0/children/0"),
        (json!([{}, {"children": [2]}, {"children": [3]}, {"children": [1]}]), "/nodes/3/children"),
        (json!([{"children": [1]}, {"children": [0]}]), "/nodes/0/children"),
    ] {
        for roots in [json!([]), json!([0])] {
            assert_eq!(tree(nodes.clone(), roots).fault().0, pointer, "{nodes}");
        }
    }
}

#[test]
fn a_tree_may_be_deep_but_not_endless() {
    let chain = |length: usize| {
        let link = |node: usize| match node + 1 < length {
            true => json!({"children": [node + 1]}),
            false => json!({"mesh": 0}),
        };
        tree((0..length).map(link).collect(), json!([0]))
    };
    assert_eq!(chain(1024).load().scene.objects().len(), 1);
    assert!(documents::is_unsupported(&chain(1025).read().unwrap_err()));
    let limits = Limits { max_depth: 3, ..Limits::default() };
    assert!(read(&chain(4).glb(), Format::Glb, "test", None, &limits).is_err());
}

#[test]
fn a_node_listed_with_its_ancestor_is_shown_once() {
    let document = tree(json!([{"children": [1]}, {"mesh": 0}]), json!([1, 0, 0]));
    let loaded = document.load();
    assert_eq!(loaded.scene.nodes.len(), 2);
    assert_eq!(loaded.warnings.len(), 2);
}

#[test]
fn a_place_beyond_all_numbers_is_an_error() {
    let document = tree(
        json!([{"children": [1], "scale": [1e300, 1, 1]}, {"scale": [1e300, 1, 1]}]),
        json!([0]),
    );
    assert_eq!(document.fault().0, "/nodes/1");
}
