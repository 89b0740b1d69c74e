//! Scenes that aren't sound are named, and the others are not.

use super::*;
use crate::{
    DVec3, Lines, MaterialId, MeshId, Part, Points, SceneLight, Section, TextureId, TextureUse,
    demos, primitives,
};

/// A ball, which has a seam, with points and a line, in a node below another one.
fn sound() -> Scene {
    let mut scene = Scene::default();
    let mut ball = primitives::icosphere(1.0, 2);
    let count = ball.triangles.len() as u32;
    ball.parts = vec![Part { first: 0, count, material: MaterialId(0) }];
    ball.points = vec![Points { indices: vec![0, 3], material: MaterialId(0) }];
    ball.lines = vec![Lines { segments: vec![[0, 1]], material: MaterialId(0) }];
    scene.meshes = vec![ball].into();
    scene.materials = vec![SceneMaterial::default()];
    scene.nodes = vec![Node::root("above", None), Node::root("ball", Some(MeshId(0)))];
    scene.nodes[1].parent = Some(NodeId(0));
    scene
}

/// Readers leave out faces with such corners, and keep the positions.
#[test]
fn positions_that_are_not_finite_are_sound() {
    let mut scene = sound();
    ball(&mut scene).positions.push([f32::NAN, f32::INFINITY, 0.0]);
    assert_eq!(scene.check(), Ok(()));
}

fn ball(scene: &mut Scene) -> &mut Mesh {
    &mut scene.meshes[0]
}

#[test]
fn demos_and_primitives_are_sound() {
    assert_eq!(sound().check(), Ok(()));
    for (name, _) in demos::names().into_iter().filter(|(name, _)| *name != "blob") {
        let scene = demos::demo(name).unwrap();
        assert_eq!(scene.check(), Ok(()), "{name}");
    }
}

#[test]
fn what_refers_to_something_missing_or_has_another_length_is_named_with_its_place() {
    type Case = (&'static str, fn(&mut Scene));
    let cases: [Case; 17] = [
        ("mesh 0: 42 texture coordinates for", |s| ball(s).uvs[0] = vec![[0.0; 2]; 42]),
        ("mesh 0: 3 colours for", |s| ball(s).colors = vec![[1.0; 4]; 3]),
        ("mesh 0: there is no position 4000", |s| ball(s).triangles[7][2] = 4000),
        ("mesh 0: there is no attribute vertex 4000", |s| {
            ball(s).attribute_corners.as_mut().unwrap()[7][2] = 4000;
        }),
        ("mesh 0: 1 corners of attributes for 80 triangles", |s| {
            ball(s).attribute_corners = Some(vec![[0; 3]]);
        }),
        ("mesh 0: 2 polygons for 80 triangles", |s| ball(s).polygons = Some(vec![0; 2])),
        ("mesh 0: there is no material 1", |s| ball(s).parts[0].material = MaterialId(1)),
        ("mesh 0: its parts have 79 triangles, there are 80", |s| ball(s).parts[0].count = 79),
        ("mesh 0: a part begins at triangle 1, not at 0", |s| ball(s).parts[0].first = 1),
        ("mesh 0: there is no position 999", |s| ball(s).points[0].indices.push(999)),
        ("mesh 0: there is no position 999", |s| ball(s).lines[0].segments.push([999, 0])),
        ("mesh 0: its last section doesn't end where the mesh does", |s| {
            ball(s).sections = vec![Section { triangles: 1, ..Section::default() }];
        }),
        ("material 0: there is no texture 2", |s| {
            s.materials[0].base_color = Some(TextureUse::new(TextureId(2)).into());
        }),
        ("node 1: there is no mesh 1", |s| s.nodes[1].mesh = Some(MeshId(1))),
        ("node 1: there is no section 1", |s| s.nodes[1].section = 1),
        ("node 0: there is no node 2", |s| s.nodes[0].parent = Some(NodeId(2))),
        (": it is above itself", |s| s.nodes[0].parent = Some(NodeId(1))),
    ];
    for (expected, spoil) in cases {
        let mut scene = sound();
        spoil(&mut scene);
        let message = scene.check().unwrap_err().to_string();
        assert!(message.contains(expected), "{message}, not {expected}");
    }
    let lit = |placement: Placement| {
        let mut scene = sound();
        scene.lights = vec![SceneLight::directional(DVec3::X, [1.0; 3]).placed(placement)];
        scene.check()
    };
    assert_eq!(lit(Placement::Node(NodeId(1))), Ok(()));
    assert_eq!(lit(Placement::Node(NodeId(2))).unwrap_err().part, ScenePart::Light);
}
