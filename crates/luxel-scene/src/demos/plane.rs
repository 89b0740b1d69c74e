//! A coloured ground plane with named things standing on it.

use super::builder::{SceneBuilder, srgb};
use super::teapot;
use crate::primitives::{self, MeshBuilder};
use crate::{DMat4, DVec3, MaterialId, Mesh, NodeId, Scene};
use luxel_lighting::Material;

/// Fields along each side of the ground.
const FIELDS: i32 = 12;
/// The side of a field.
const FIELD: f64 = 1.5;
/// Steps round the round things: outlines without corners at the size of a screen.
const ROUND: u32 = 96;

pub(super) fn scene() -> Scene {
    let mut builder = SceneBuilder::default();
    let root = builder.group("plane", None, DMat4::IDENTITY);

    ground(&mut builder, root);
    let things = builder.group("things", Some(root), DMat4::IDENTITY);
    let glaze = builder.material("glaze", teapot::glaze());
    let pot = builder.group("teapot", Some(things), standing([-0.2, 0.0, -0.4], -28.0));
    teapot::add(&mut builder, pot, glaze);

    let tower = builder.group("tower", Some(things), standing([-4.3, 0.0, -2.6], 20.0));
    let column = primitives::cylinder(0.75, 2.6, ROUND);
    let column = add(&mut builder, tower, "column", [0.0, 1.3, 0.0], column, 0xd9_d3c6, 0.25);
    let ball = primitives::sphere(0.85, ROUND, ROUND / 2);
    add(&mut builder, column, "ball", [0.0, 2.15, 0.0], ball, 0x4c_82d8, 0.6);

    let stack = builder.group("stack", Some(things), standing([-3.6, 0.0, 2.6], 32.0));
    let cube = primitives::cuboid(DVec3::splat(1.5));
    let cube = add(&mut builder, stack, "cube", [0.0, 0.75, 0.0], cube, 0x6f_b04a, 0.15);
    let ring = primitives::torus(0.48, 0.2, ROUND, ROUND / 2);
    add(&mut builder, cube, "torus", [0.0, 0.95, 0.0], ring, 0xf2_b84b, 0.6);

    let sphere = primitives::icosphere(0.9, 24);
    add(&mut builder, things, "sphere", [3.1, 0.9, 2.7], sphere, 0xe5_533d, 0.7);
    let cone = primitives::cone(0.95, 2.4, ROUND, 12);
    add(&mut builder, things, "cone", [4.0, 1.2, -2.5], cone, 0x6f_d3c7, 0.3);

    daylight(&mut builder);
    builder.camera(root, DVec3::new(4.6, 6.2, 12.4), DVec3::new(-0.2, 0.9, 0.0), 36.0);
    builder.scene
}

/// The ground.
pub(super) fn ground(builder: &mut SceneBuilder, root: NodeId) {
    let paint = Material { k_s: 0.06, shininess: 12.0, diffuse: [1.0; 3], ..Material::default() };
    let ground = builder.material("ground", paint);
    let mesh = builder.mesh(chequered(), ground);
    builder.object("ground", root, DMat4::IDENTITY, mesh);
}

/// The sun is to the upper left behind the eye, and the sky fills in from the right.
pub(super) fn daylight(builder: &mut SceneBuilder) {
    builder.sun("sun", DVec3::new(0.55, -1.0, -0.62), [0.86, 0.82, 0.74]);
    builder.sun("sky", DVec3::new(-0.9, -0.45, -0.35), [0.15, 0.18, 0.24]);
    builder.ambient([0.15, 0.16, 0.19]);
}

/// A place on the ground, turned about the vertical.
pub(super) fn standing(place: [f64; 3], turn_degrees: f64) -> DMat4 {
    DMat4::from_translation(DVec3::from_array(place))
        * DMat4::from_rotation_y(turn_degrees.to_radians())
}

/// Adds an object with a new material, in its parent's coordinates.
fn add(
    builder: &mut SceneBuilder,
    parent: NodeId,
    name: &str,
    place: [f64; 3],
    shape: Mesh,
    color: u32,
    k_s: f32,
) -> NodeId {
    let constants = Material { diffuse: srgb(color), k_s, shininess: 60.0, ..Material::default() };
    let material: MaterialId = builder.material(name, constants);
    let mesh = builder.mesh(shape, material);
    builder.object(name, parent, DMat4::from_translation(DVec3::from_array(place)), mesh)
}

/// The ground, its fields of two cool colours by vertex colours.
fn chequered() -> Mesh {
    let mut builder = MeshBuilder::default();
    let mut colors = Vec::new();
    let shades = [srgb(0x4a_6076), srgb(0x86_9cab)];
    for row in -FIELDS / 2..FIELDS / 2 {
        for column in -FIELDS / 2..FIELDS / 2 {
            let corner = |right: i32, down: i32| {
                DVec3::new(f64::from(column + right) * FIELD, 0.0, f64::from(row + down) * FIELD)
            };
            builder.quadrilateral([corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)]);
            let [red, green, blue] = shades[(row + column).rem_euclid(2) as usize];
            colors.extend([[red, green, blue, 1.0]; 4]);
        }
    }
    Mesh { colors, ..builder.finish() }
}
