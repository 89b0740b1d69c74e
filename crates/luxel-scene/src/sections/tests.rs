use super::*;
use crate::{
    Lens, MaterialId, NormalOptions, NormalSource, Points, SceneMaterial, Size, Viewpoint, bodies,
    fit_along, fit_view,
};
use glam::DMat4;

/// A strip of triangles in a fold, from a place, of two materials, with what else its number decides.
fn strip(number: u32) -> Mesh {
    let at = number as f32;
    let mut mesh = Mesh::default();
    for corner in 0..6_u8 {
        let along = f32::from(corner / 2);
        mesh.positions.push([at + along, f32::from(corner % 2), (along - 1.0).abs() * (at % 4.0)]);
        mesh.uvs[0].push([along, f32::from(corner % 2)]);
    }
    mesh.triangles = vec![[0, 2, 1], [1, 2, 3], [2, 4, 3], [3, 4, 5]];
    let part = |first, material| Part { first, count: 2, material: MaterialId(material) };
    mesh.parts = vec![part(0, number % 3), part(2, 3)];
    mesh.smoothing_groups = Some(vec![number % 2, number % 2, 1, 1]);
    if number.is_multiple_of(3) {
        mesh.polygons = Some(vec![0, 0, 1, 1]);
    }
    if number.is_multiple_of(5) {
        mesh.attribute_corners = Some(vec![[0, 1, 2], [2, 1, 3], [1, 4, 3], [3, 4, 5]]);
        mesh.normal_faults = vec![NormalFault { position: 3, undefined: true }];
    }
    mesh
}

/// Strips as one scene, joined if they are so many.
fn scene(meshes: &[Mesh], count: usize) -> Scene {
    let mut joiner = Joiner::new(count);
    for (number, mesh) in meshes.iter().enumerate() {
        joiner.push(format!("{number}"), mesh.clone());
    }
    let mut scene = Scene::default();
    joiner.finish(&mut scene);
    scene.materials = vec![SceneMaterial::default(); 4];
    scene
}

fn strips() -> Vec<Mesh> {
    (0..16).map(strip).collect()
}

#[test]
fn joined_objects_keep_their_meshes() {
    let meshes = strips();
    let scene = scene(&meshes, LEAST_OBJECTS);
    assert_eq!(scene.meshes.len(), 1);
    let objects = scene.objects();
    for (object, mesh) in objects.iter().zip(&meshes) {
        assert_eq!(*scene.mesh_of(object), *mesh);
    }
    assert_eq!(scene.triangle_count(), 64);
    let separate = scene.separated();
    assert_eq!(*separate.meshes, meshes);
    assert_eq!(separate.objects().len(), 16);
    assert!(separate.nodes.iter().all(|node| node.section == 0));
}

#[test]
fn a_few_objects_keep_a_mesh_each() {
    let meshes = strips();
    assert_eq!(scene(&meshes, LEAST_OBJECTS - 1).meshes.len(), 16);
}

#[test]
fn only_small_objects_of_triangles_with_the_same_attributes_are_joined() {
    let mut meshes = strips();
    meshes[3].uvs[0].clear();
    meshes[6].points = vec![Points { indices: vec![0], material: MaterialId(0) }];
    meshes[9].triangles = [0, 1, 2].map(|first| [first, first + 1, first + 2]).repeat(64);
    meshes[9].parts = vec![Part { first: 0, count: 192, material: MaterialId(0) }];
    (meshes[9].smoothing_groups, meshes[9].polygons) = (Some(vec![0; 192]), None);
    let scene = scene(&meshes, LEAST_OBJECTS);
    // 0 to 2, 3, 4 and 5, 6, 7 and 8, 9, 10 to 15.
    assert_eq!(scene.meshes.len(), 7);
    assert_eq!(*scene.separated().meshes, meshes);
}

#[test]
fn normals_and_tangents_of_sections_are_those_of_meshes() {
    let sources = [NormalSource::File, NormalSource::Mean, NormalSource::AreaAngle];
    for options in sources.map(|source| NormalOptions { source, ..NormalOptions::default() }) {
        let meshes = strips();
        let mut joined = scene(&meshes, LEAST_OBJECTS);
        joined.compute_normals(&options);
        joined.meshes[0].compute_tangents(0);
        for (object, mut mesh) in joined.objects().iter().zip(meshes) {
            mesh.compute_normals(&options);
            mesh.compute_tangents(0);
            assert!(!mesh.tangents.is_empty());
            assert_eq!(*joined.mesh_of(object), mesh);
        }
    }
}

#[test]
fn triangles_know_their_section() {
    let scene = scene(&strips(), LEAST_OBJECTS);
    let mesh = &scene.meshes[0];
    for triangle in 0..64 {
        assert_eq!(mesh.section_of(triangle), (triangle / 4, triangle % 4));
    }
    assert_eq!(strip(0).section_of(3), (0, 3));
}

#[test]
fn bounds_and_fitted_views_have_the_same_bits() {
    let meshes = strips();
    let place = DMat4::from_translation(DVec3::new(3.0, 0.1, -7.0)) * DMat4::from_rotation_x(0.4);
    let [joined, separate] = [LEAST_OBJECTS, 0].map(|count| {
        let mut scene = scene(&meshes, count);
        let moved = scene.nodes.iter().map(|node| node.clone().at(None, place)).collect();
        scene.nodes = moved;
        scene
    });
    assert_eq!(joined.bounds(), separate.bounds());
    for (one, other) in joined.objects().iter().zip(&separate.objects()) {
        assert_eq!(joined.bounds_of_object(one), separate.bounds_of_object(other));
    }
    let viewpoint = Viewpoint { up: DVec3::Y, azimuth_radians: 0.5, elevation_radians: 0.2 };
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    let size = Size { width: 64, height: 48 };
    let fitted = |scene: &Scene| {
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        (fit_view(scene, &viewpoint, lens, size), fit_along(scene, axes, lens, size))
    };
    assert_eq!(fitted(&joined), fitted(&separate));
}

#[test]
fn objects_in_different_places_are_bodies_of_their_own() {
    let mut scene = scene(&strips(), LEAST_OBJECTS);
    assert_eq!(bodies(&scene.objects()).next(), Some(0..16));
    let again: Vec<_> = scene.nodes.clone();
    scene.nodes.extend(again);
    scene.nodes[3] = scene.nodes[3].clone().at(None, DMat4::from_scale(DVec3::splat(2.0)));
    let found: Vec<_> = bodies(&scene.objects()).collect();
    assert_eq!(found, [0..3, 3..4, 4..16, 16..32]);
}

#[test]
fn far_objects_share_an_origin_where_it_is_as_good_as_their_own() {
    // More than keep their own origins, in steps of their size.
    let count = 2 * MOST_APART as u32;
    let mut joiner = Joiner::new(count as usize);
    for number in 0..count {
        let mut mesh = Mesh { triangles: vec![[0, 1, 2]], ..Mesh::default() };
        mesh.parts = vec![Part { first: 0, count: 1, material: MaterialId(0) }];
        let x = 1e6 + f64::from(number);
        mesh.set_positions(&[[x, 0.1, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.3]]);
        joiner.push(String::new(), mesh);
    }
    let mut scene = Scene::default();
    joiner.finish(&mut scene);
    assert!(scene.meshes.len() < MOST_APART * 9 / 8, "{}", scene.meshes.len());
    for (number, object) in (0..).zip(scene.objects()) {
        let mesh = scene.mesh_of(&object);
        let place = mesh.position(2) - DVec3::new(1e6 + f64::from(number), 1.0, 0.3);
        assert!(place.abs().max_element() < 1e-6, "{number}: {place}");
    }
}
