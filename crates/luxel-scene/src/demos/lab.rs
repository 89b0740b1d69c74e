//! The lab of problems: small scenes, each of which shows one thing that shading does wrong, and
//! those beside them in which it is cured by another mesh.
//!
//! The resolution of each scene is a parameter, so that a cure can be tried at many; the built-in
//! demos are those sizes at which the problem is seen best. All stand before the same quiet ground.

mod ball;
mod column;
mod contact;
mod corrugated;
mod floor;
mod panel;
mod quad;
mod seam;
mod terminator;

pub use ball::ball;
pub use column::column;
pub use contact::contact;
pub use corrugated::corrugated;
pub use floor::floor;
pub use panel::panel;
pub use quad::quad;
pub use seam::{Seam, seam};
pub use terminator::terminator;

use super::Demo;
use super::builder::{SceneBuilder, srgb};
use crate::primitives::{MeshBuilder, SurfacePoint};
use crate::{DVec2, DVec3, MaterialId, Mesh};
use luxel_lighting::Material;

/// Faces around a ball with a polygonal silhouette.
pub const COARSE: u32 = 12;
/// Faces around a ball with a smooth silhouette.
pub const FINE: u32 = 192;
/// Faces around a ball with a smeared highlight.
pub const MIDDLING: u32 = 24;
/// Faces around a ball whose triangles shade themselves.
pub const TURNED: u32 = 40;
/// The exponent of the smearing highlight.
pub const SHININESS: f32 = 24.0;
/// Cells of the sheet along its seam.
pub const CELLS: u32 = 8;
/// Quadrilaterals along each side of the quad that rolls without harm.
pub const CUT: u32 = 16;

pub(super) const DEMOS: [Demo; 13] = [
    Demo {
        name: "lab-silhouette",
        about: "a ball of 12 faces round: smooth inside, with a polygonal silhouette",
        make: || ball("lab-silhouette", COARSE, 20.0),
    },
    Demo {
        name: "lab-silhouette-cured",
        about: "the same with 192 faces round",
        make: || ball("lab-silhouette-cured", FINE, 20.0),
    },
    Demo {
        name: "lab-perspective",
        about: "a floor of one polygon: its texture slides under screen-linear interpolation",
        make: || floor("lab-perspective", 1),
    },
    Demo {
        name: "lab-rolling",
        about: "a quad of four colours: they change as it rolls under scan-line interpolation",
        make: || quad("lab-rolling", 1),
    },
    Demo {
        name: "lab-rolling-cured",
        about: "the same cut into 16 x 16 quads",
        make: || quad("lab-rolling-cured", CUT),
    },
    Demo {
        name: "lab-t-junction",
        about: "a sheet whose left half lacks the corners on the seam",
        make: || seam("lab-t-junction", Seam::Forgotten, CELLS),
    },
    Demo {
        name: "lab-t-junction-cured",
        about: "the same with the corners shared",
        make: || seam("lab-t-junction-cured", Seam::Shared, CELLS),
    },
    Demo {
        name: "lab-corrugated",
        about: "a folded sheet that looks flat with averaged normals",
        make: || corrugated("lab-corrugated"),
    },
    Demo {
        name: "lab-lamp",
        about: "a lamp before a panel of one polygon: gouraud shading misses the highlight",
        make: || panel("lab-lamp", 1),
    },
    Demo {
        name: "lab-highlight",
        about: "a glossy ball of 24 faces round, chalky with gouraud shading",
        make: || ball("lab-highlight", MIDDLING, SHININESS),
    },
    Demo {
        name: "lab-mach",
        about: "a column of 12 faces: Mach bands with flat and gouraud shading",
        make: || column("lab-mach", COARSE),
    },
    Demo {
        name: "lab-contact",
        about: "two balls over a board: only shadows tell which one stands on it",
        make: || contact("lab-contact"),
    },
    Demo {
        name: "lab-terminator",
        about: "a ball of 40 faces round lit from the side: its own shadow follows its triangles",
        make: || terminator("lab-terminator", TURNED),
    },
];

/// The background.
const GROUND: u32 = 0x1c_1f23;

/// A scene of one object under a root of the scene's name, before the ground.
fn stage(
    name: &str,
    object: &str,
    material: Material,
    mesh: Mesh,
) -> (SceneBuilder, crate::NodeId) {
    let mut builder = SceneBuilder::default();
    let root = builder.group(name, None, crate::DMat4::IDENTITY);
    let material: MaterialId = builder.material(object, material);
    let mesh = builder.mesh(mesh, material);
    builder.object(object, root, crate::DMat4::IDENTITY, mesh);
    let [red, green, blue] = srgb(GROUND);
    builder.scene.background = Some([red, green, blue, 1.0].into());
    (builder, root)
}

/// A grid of `columns` x `rows` quadrilaterals, each of them one polygon; `point` gives place and
/// normal at (u, v) from 0 to 1, to the right and downwards seen from the front.
fn grid(columns: u32, rows: u32, point: impl Fn(f64, f64) -> (DVec3, DVec3)) -> Mesh {
    let mut builder = MeshBuilder::default();
    builder.grid(columns, rows, |column, row| {
        let uv =
            DVec2::new(f64::from(column) / f64::from(columns), f64::from(row) / f64::from(rows));
        let (position, normal) = point(uv.x, uv.y);
        SurfacePoint { position, normal, uv }
    });
    let mut mesh = builder.finish();
    mesh.polygons = Some((0..columns * rows).flat_map(|polygon| [polygon; 2]).collect());
    mesh
}
