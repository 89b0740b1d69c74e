//! The Utah teapot.
//!
//! Martin Newell made it in 1975 of bicubic Bézier patches (*The Utilization of Procedure Models in
//! Digital Image Synthesis*, PhD thesis, University of Utah), and gave the numbers away (also in
//! Crow 1987, *The Origins of the Teapot*, IEEE Computer Graphics and Applications 7(1)). His 28
//! patches have no bottom; the four that close it are those in general use since.
//!
//! Its symmetry makes the data small. Body and lid are surfaces of revolution, four equal quarters
//! about the axis. Handle and spout are their own mirror images, so that a row of control points
//! is a loop round two places. Here stand the profiles and loops, in Newell's units, 3.15 high;
//! the 306 control points of the usual files follow from them.

use super::builder::SceneBuilder;
use crate::primitives::{MeshBuilder, Patch};
use crate::{DMat4, DVec2, DVec3, MaterialId, Mesh, NodeId, Scene};
use luxel_lighting::{Material, Reflection};

/// A profile's control point: radius, lever and height. The lever is how far the control points of
/// a quarter circle stand off its ends, 0.56 of the radius but at the knob.
type ProfilePoint = [f64; 3];

/// A loop's control points: x and height of the inner place, of the outer place, half the width.
type Loop = [f64; 5];

/// The rim, from inside over its edge, the upper and the lower body, and the bottom.
const BODY: [[ProfilePoint; 4]; 4] = [
    [[1.4, 0.784, 2.4], [1.3375, 0.749, 2.531_25], [1.4375, 0.805, 2.531_25], [1.5, 0.84, 2.4]],
    [[1.5, 0.84, 2.4], [1.75, 0.98, 1.875], [2.0, 1.12, 1.35], [2.0, 1.12, 0.9]],
    [[2.0, 1.12, 0.9], [2.0, 1.12, 0.45], [1.5, 0.84, 0.225], [1.5, 0.84, 0.15]],
    [[1.5, 0.84, 0.15], [1.5, 0.84, 0.075], [1.425, 0.798, 0.0], [0.0, 0.0, 0.0]],
];

/// The knob and the lid below it.
const LID: [[ProfilePoint; 4]; 2] = [
    [[0.0, 0.0, 3.15], [0.8, 0.45, 3.15], [0.0, 0.0, 2.85], [0.2, 0.112, 2.7]],
    [[0.2, 0.112, 2.7], [0.4, 0.224, 2.55], [1.3, 0.728, 2.55], [1.3, 0.728, 2.4]],
];

/// From the rim backwards, and down to the body.
const HANDLE: [[Loop; 4]; 2] = [
    [
        [-1.6, 2.025, -1.5, 2.25, 0.3],
        [-2.3, 2.025, -2.5, 2.25, 0.3],
        [-2.7, 2.025, -3.0, 2.25, 0.3],
        [-2.7, 1.8, -3.0, 1.8, 0.3],
    ],
    [
        [-2.7, 1.8, -3.0, 1.8, 0.3],
        [-2.7, 1.575, -3.0, 1.35, 0.3],
        [-2.5, 1.125, -2.65, 0.9375, 0.3],
        [-2.0, 0.9, -1.9, 0.6, 0.3],
    ],
];

/// From the body upwards, and round the lip into the mouth.
const SPOUT: [[Loop; 4]; 2] = [
    [
        [1.7, 1.425, 1.7, 0.6, 0.66],
        [2.6, 1.425, 3.1, 0.825, 0.66],
        [2.3, 2.1, 2.4, 2.025, 0.25],
        [2.7, 2.4, 3.3, 2.4, 0.25],
    ],
    [
        [2.7, 2.4, 3.3, 2.4, 0.25],
        [2.8, 2.475, 3.525, 2.493_75, 0.25],
        [2.9, 2.475, 3.45, 2.5125, 0.15],
        [2.8, 2.4, 3.2, 2.4, 0.15],
    ],
];

/// Quadrilaterals along each side of a patch: no facet shows at the size of a screen.
const STEPS: u32 = 16;

/// The teapot's parts by name, `steps` quadrilaterals along each side of a patch. It stands on
/// y = 0 about the y axis, its spout towards +X.
pub(super) fn parts(steps: u32) -> [(&'static str, Mesh); 4] {
    [
        ("body", revolved(&BODY, steps)),
        ("lid", revolved(&LID, steps)),
        ("handle", mirrored(&HANDLE, steps)),
        ("spout", mirrored(&SPOUT, steps)),
    ]
}

/// Hangs the teapot's parts on a node.
pub(super) fn add(builder: &mut SceneBuilder, parent: NodeId, material: MaterialId) {
    for (name, part) in parts(STEPS) {
        let mesh = builder.mesh(part, material);
        builder.object(name, parent, DMat4::IDENTITY, mesh);
    }
}

/// Glazed earthenware: a warm colour under a clear gloss.
pub(super) fn glaze() -> Material {
    Material {
        reflection: Reflection::BlinnPhong,
        diffuse: [0.52, 0.18, 0.06],
        k_s: 0.6,
        shininess: 60.0,
        ..Material::default()
    }
}

/// The teapot with the default camera and lights.
pub(super) fn scene() -> Scene {
    let mut builder = SceneBuilder::default();
    let material = builder.material("glaze", glaze());
    let root = builder.group("teapot", None, DMat4::IDENTITY);
    add(&mut builder, root, material);
    builder.scene
}

/// Four quarters about the axis for each profile, from the back (-Z) to the right, seen from
/// outside. One texture goes once round, from the profile's upper end to its lower one.
fn revolved(profiles: &[[ProfilePoint; 4]], steps: u32) -> Mesh {
    let directions = [DVec3::NEG_Z, DVec3::NEG_X, DVec3::Z, DVec3::X];
    strips(profiles.len(), 4, steps, |strip, quarter| {
        let (from, to) = (directions[quarter], directions[(quarter + 1) % 4]);
        Patch(profiles[strip].map(|[radius, lever, height]| {
            [(radius, 0.0), (radius, lever), (lever, radius), (0.0, radius)]
                .map(|(along, across)| from * along + to * across + DVec3::Y * height)
        }))
    })
}

/// The half on the -Z side and its mirror image for each strip of loops.
fn mirrored(strips_of_loops: &[[Loop; 4]], steps: u32) -> Mesh {
    strips(strips_of_loops.len(), 2, steps, |strip, half| {
        Patch(strips_of_loops[strip].map(|[inner_x, inner_y, outer_x, outer_y, width]| {
            let inner = |z| DVec3::new(inner_x, inner_y, z);
            let outer = |z| DVec3::new(outer_x, outer_y, z);
            if half == 0 {
                [inner(0.0), inner(-width), outer(-width), outer(0.0)]
            } else {
                [outer(0.0), outer(width), inner(width), inner(0.0)]
            }
        }))
    })
}

/// Patches in strips from top to bottom, each of `around` patches from left to right, under one
/// texture.
fn strips(strips: usize, around: usize, steps: u32, patch: impl Fn(usize, usize) -> Patch) -> Mesh {
    let mut builder = MeshBuilder::default();
    let size = DVec2::new(around as f64, strips as f64);
    for strip in 0..strips {
        for place in 0..around {
            let corner = DVec2::new(place as f64, strip as f64);
            patch(strip, place).tessellate(&mut builder, steps, |at| (corner + at) / size);
        }
    }
    builder.finish()
}

#[cfg(test)]
mod tests;
