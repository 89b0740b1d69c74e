//! glTF geometry, feature by feature, on documents small enough to check by hand.

mod documents;

use documents::Document;
use luxel_formats::Loaded;
use luxel_scene::{DVec3, MaterialId, Mesh};
use serde_json::json;

fn mesh(loaded: &Loaded) -> &Mesh {
    &loaded.scene.meshes[0]
}

/// The documents' first mesh.
fn mesh_of(document: &Document) -> Mesh {
    document.load().scene.meshes.remove(0)
}

#[test]
fn a_triangle_without_indices_is_read() {
    let loaded = Document::triangle().load();
    assert_eq!(mesh(&loaded).triangles, [[0, 1, 2]]);
    assert_eq!(mesh(&loaded).positions[1], [1.0, 0.0, 0.0]);
    assert!(mesh(&loaded).normals.is_empty());
    assert!(loaded.warnings.is_empty(), "{:?}", loaded.warnings);
}

#[test]
fn indices_of_every_type_are_read() {
    for (component, bytes) in [
        (5121, vec![2, 1, 0]),
        (5123, vec![2, 0, 1, 0, 0, 0]),
        (5125, vec![2, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0]),
    ] {
        let mut document = Document::triangle();
        let indices = document.accessor("SCALAR", component, 3, &bytes);
        document.primitive()["indices"] = json!(indices);
        assert_eq!(mesh_of(&document).triangles, [[2, 1, 0]], "{component}");
    }
}

#[test]
fn strips_and_fans_keep_the_winding_of_the_specification() {
    let mut document = Document::new();
    let square = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0];
    let positions = document.floats("VEC3", &square);
    document.attribute("POSITION", positions);
    document.primitive()["mode"] = json!(5);
    assert_eq!(mesh_of(&document).triangles, [[0, 1, 2], [1, 3, 2]]);
    document.primitive()["mode"] = json!(6);
    assert_eq!(mesh_of(&document).triangles, [[1, 2, 0], [2, 3, 0]]);
}

#[test]
fn points_and_lines_are_read_and_counted_in_the_bounds() {
    for (mode, points, segments) in [(0, 3, 0), (1, 0, 1), (2, 0, 3), (3, 0, 2)] {
        let mut document = Document::triangle();
        document.primitive()["mode"] = json!(mode);
        let loaded = document.load();
        let mesh = mesh(&loaded);
        assert!(mesh.triangles.is_empty());
        assert_eq!(mesh.points.iter().map(|points| points.indices.len()).sum::<usize>(), points);
        assert_eq!(mesh.lines.iter().map(|lines| lines.segments.len()).sum::<usize>(), segments);
        assert_eq!(loaded.scene.bounds().max.x, 1.0);
    }
}

#[test]
fn sparse_values_replace_the_others() {
    let mut document = Document::triangle();
    let indices = document.view(&[1, 2]);
    let values: Vec<u8> =
        [5.0_f32, 6.0, 7.0, 8.0, 9.0, 10.0].iter().flat_map(|value| value.to_le_bytes()).collect();
    let values = document.view(&values);
    let sparse = json!({
        "count": 2,
        "indices": {"bufferView": indices, "componentType": 5121},
        "values": {"bufferView": values},
    });
    document.json["accessors"][0]["sparse"] = sparse.clone();
    let dense = mesh_of(&document);
    assert_eq!(dense.positions, [[0.0; 3], [5.0, 6.0, 7.0], [8.0, 9.0, 10.0]]);
    // Without a buffer view, the others are zeros.
    document.json["accessors"][0] =
        json!({"componentType": 5126, "count": 3, "type": "VEC3", "sparse": sparse});
    assert_eq!(mesh_of(&document).positions, dense.positions);
}

#[test]
fn a_stride_skips_what_lies_between() {
    let mut document = Document::triangle();
    let floats = [0.0_f32, 0.0, 0.0, 9.0, 1.0, 0.0, 0.0, 9.0, 0.0, 1.0, 0.0];
    let bytes: Vec<u8> = floats.iter().flat_map(|value| value.to_le_bytes()).collect();
    let view = document.view(&bytes);
    document.json["bufferViews"][view]["byteStride"] = json!(16);
    document.json["accessors"][0]["bufferView"] = json!(view);
    assert_eq!(mesh_of(&document).positions[1], [1.0, 0.0, 0.0]);
    assert_eq!(mesh_of(&document).positions[2], [0.0, 1.0, 0.0]);
}

#[test]
fn quantized_attributes_are_scaled_as_the_extension_defines() {
    let mut document = Document::new();
    document.json["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    document.json["nodes"][0]["scale"] = json!([0.5, 0.5, 0.5]);
    let positions = document.accessor(
        "VEC3",
        5122,
        3,
        &[0_i16, 0, 0, 0, 100, 0, 0, 0, 0, -200, 0, 0]
            .iter()
            .flat_map(|value| value.to_le_bytes())
            .collect::<Vec<_>>(),
    );
    document.json["bufferViews"][0]["byteStride"] = json!(8);
    document.attribute("POSITION", positions);
    let normals = document.accessor("VEC3", 5120, 3, &[0, 0, 127, 0, 128, 0, 0, 0x81, 0]);
    document.json["accessors"][normals]["normalized"] = json!(true);
    document.attribute("NORMAL", normals);
    let uvs = document.accessor("VEC2", 5121, 3, &[0, 255, 51, 0, 0, 0]);
    document.json["accessors"][uvs]["normalized"] = json!(true);
    document.attribute("TEXCOORD_0", uvs);
    let loaded = document.load();
    let mesh = mesh(&loaded);
    assert_eq!(mesh.positions, [[0.0; 3], [100.0, 0.0, 0.0], [0.0, -200.0, 0.0]]);
    assert_eq!(loaded.scene.bounds().max, DVec3::new(50.0, 0.0, 0.0));
    // -128 and -127 both stand for -1.
    assert_eq!(mesh.normals, [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [0.0, -1.0, 0.0]]);
    assert_eq!(mesh.uvs[0], [[0.0, 1.0], [0.2, 0.0], [0.0, 0.0]]);
}

#[test]
fn colors_of_three_components_are_opaque() {
    let mut document = Document::triangle();
    let colors = document.accessor("VEC3", 5121, 3, &[255, 0, 51, 0, 0, 0, 0, 0, 0]);
    document.json["accessors"][colors]["normalized"] = json!(true);
    document.attribute("COLOR_0", colors);
    let loaded = document.load();
    assert_eq!(mesh(&loaded).colors[0], [1.0, 0.0, 0.2, 1.0]);
    // A vertex colour is the colour itself where there is no material.
    assert_eq!(loaded.scene.materials[0].constants.diffuse, [1.0; 3]);
}

#[test]
fn primitives_become_parts_in_their_order() {
    let mut document = Document::triangle();
    let normals = document.floats("VEC3", &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let more = document.floats("VEC3", &[0.0, 0.0, 2.0, 1.0, 0.0, 2.0, 0.0, 1.0, 2.0]);
    document.push("materials", json!({"name": "red"}));
    document.json["meshes"][0]["primitives"] = json!([
        {"attributes": {"POSITION": 0}},
        {"attributes": {"POSITION": more, "NORMAL": normals}, "material": 0},
        {"attributes": {"POSITION": 0}},
    ]);
    let loaded = document.load();
    let mesh = mesh(&loaded);
    assert_eq!(mesh.triangles, [[0, 1, 2], [3, 4, 5], [0, 1, 2]]);
    let materials: Vec<_> = mesh.parts.iter().map(|part| part.material).collect();
    assert_eq!(materials, [MaterialId(1), MaterialId(0), MaterialId(1)]);
    // Normals that a primitive lacks are zero: computed later.
    assert_eq!(mesh.normals[..3], [[0.0; 3]; 3]);
    assert_eq!(mesh.normals[3..], [[0.0, 0.0, 1.0]; 3]);
}

#[test]
fn morph_targets_move_by_their_default_weights() {
    let mut document = Document::triangle();
    let target = document.floats("VEC3", &[0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    document.primitive()["targets"] = json!([{"POSITION": target}]);
    assert_eq!(mesh_of(&document).positions[0], [0.0, 0.0, 0.0]);
    document.json["meshes"][0]["weights"] = json!([0.5]);
    assert_eq!(mesh_of(&document).positions[0], [0.0, 0.0, 2.0]);
    // The node's weights come first, and its mesh is its own.
    document.json["nodes"] = json!([{"mesh": 0}, {"mesh": 0, "weights": [0.25]}]);
    document.json["scenes"][0]["nodes"] = json!([0, 1]);
    let scene = document.load().scene;
    let depths: Vec<_> = scene.meshes.iter().map(|mesh| mesh.positions[0][2]).collect();
    assert_eq!(depths, [2.0, 1.0]);
}

#[test]
fn a_skin_follows_its_joints_and_not_its_node() {
    let mut document = Document::triangle();
    let joints = document.accessor("VEC4", 5121, 3, &[0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0]);
    document.attribute("JOINTS_0", joints);
    let weights =
        document.floats("VEC4", &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.0, 0.0]);
    document.attribute("WEIGHTS_0", weights);
    let mut matrices = [0.0; 32];
    for entry in [0, 5, 10, 15, 16, 21, 26, 31] {
        matrices[entry] = 1.0;
    }
    // The second joint was bound at y = 3.
    matrices[29] = -3.0;
    let inverse_bind = document.floats("MAT4", &matrices);
    document.push("skins", json!({"joints": [2, 3], "inverseBindMatrices": inverse_bind}));
    document.json["nodes"] = json!([
        {"children": [1], "translation": [7.0, 0.0, 0.0]},
        {"mesh": 0, "skin": 0, "scale": [2.0, 2.0, 2.0]},
        {"children": [3]},
        {"translation": [0.0, 10.0, 0.0]},
    ]);
    document.json["scenes"][0]["nodes"] = json!([0, 2]);
    let scene = document.load().scene;
    let object = &scene.objects()[0];
    let at = |index| {
        let position = scene.meshes[0].position(index);
        object.world_from_mesh.matrix().transform_point3(position).to_array()
    };
    assert_eq!(at(0), [0.0, 0.0, 0.0]);
    assert_eq!(at(1), [1.0, 7.0, 0.0]);
    assert_eq!(at(2), [0.0, 4.5, 0.0]);
}

#[test]
fn faces_with_a_corner_that_is_not_finite_are_left_out_and_counted() {
    let mut document = Document::new();
    let nan = f32::NAN;
    let positions =
        document.floats("VEC3", &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, nan, 0.0, 0.0]);
    document.attribute("POSITION", positions);
    let indices = document.indices(&[0, 1, 3, 0, 1, 2, 3, 1, 0]);
    document.primitive()["indices"] = json!(indices);
    let loaded = document.load();
    assert_eq!(mesh(&loaded).triangles, [[0, 1, 2]]);
    assert_eq!(loaded.warnings.len(), 1);
    assert!(loaded.warnings[0].message.contains("2 faces"), "{}", loaded.warnings[0]);
    assert!(mesh(&loaded).positions.iter().flatten().all(|coordinate| coordinate.is_finite()));
}

#[test]
fn degenerate_triangles_are_kept() {
    let mut document = Document::triangle();
    let indices = document.indices(&[0, 0, 1, 0, 1, 2]);
    document.primitive()["indices"] = json!(indices);
    assert_eq!(mesh_of(&document).triangles, [[0, 0, 1], [0, 1, 2]]);
}

#[test]
fn instances_are_nodes_below_theirs() {
    let mut document = Document::triangle();
    document.json["extensionsRequired"] = json!(["EXT_mesh_gpu_instancing"]);
    let places = document.floats("VEC3", &[1.0, 0.0, 0.0, 5.0, 0.0, 0.0]);
    document.json["nodes"][0] = json!({
        "name": "tree", "mesh": 0,
        "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places}}},
    });
    let scene = document.load().scene;
    let objects = scene.objects();
    assert_eq!(objects.len(), 2);
    assert_eq!(scene.path(objects[1].node), ["tree", "tree_1"]);
    assert_eq!(scene.bounds().max.x, 6.0);
}

#[test]
fn ten_million_instances_declared_without_data_are_refused() {
    let mut document = Document::triangle();
    document.json["accessors"].as_array_mut().unwrap().push(json!({
        "componentType": 5126, "count": 10_000_000, "type": "VEC3",
    }));
    let places = document.json["accessors"].as_array().unwrap().len() - 1;
    document.json["nodes"][0] = json!({
        "mesh": 0,
        "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": places}}},
    });
    let error = document.read().unwrap_err().to_string();
    assert!(error.contains("/nodes/0/extensions/EXT_mesh_gpu_instancing"), "{error}");
    assert!(error.contains("10000000 instances without data"), "{error}");
}
