//! The Cornell box.
//!
//! Measured in millimetres by the Cornell University Program of Computer Graphics (Goral et al.
//! 1984, *Modeling the Interaction of Light Between Diffuse Surfaces*; dimensions and camera as
//! published with the box's photographs, 1998). Here it is lit by local reflection only: a lamp
//! without a shadow below the ceiling's opening, and a faint cool light from the viewer instead of
//! indirect light between the walls.

use super::builder::{SceneBuilder, srgb};
use crate::primitives::MeshBuilder;
use crate::{DMat4, DVec3, MaterialId, Mesh, NodeId, Scene};
use luxel_lighting::{Material, Reflection};

/// Four corners, counter-clockwise seen from inside the room (or from outside a block).
type Quadrilateral = [[f64; 3]; 4];

const FLOOR: Quadrilateral =
    [[549.6, 0.0, 559.2], [552.8, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 559.2]];
const CEILING: Quadrilateral =
    [[556.0, 548.8, 0.0], [556.0, 548.8, 559.2], [0.0, 548.8, 559.2], [0.0, 548.8, 0.0]];
const BACK_WALL: Quadrilateral =
    [[556.0, 548.8, 559.2], [549.6, 0.0, 559.2], [0.0, 0.0, 559.2], [0.0, 548.8, 559.2]];
/// On the left as the camera sees it.
const RED_WALL: Quadrilateral =
    [[556.0, 548.8, 0.0], [552.8, 0.0, 0.0], [549.6, 0.0, 559.2], [556.0, 548.8, 559.2]];
const GREEN_WALL: Quadrilateral =
    [[0.0, 548.8, 559.2], [0.0, 0.0, 559.2], [0.0, 0.0, 0.0], [0.0, 548.8, 0.0]];
/// The lamp's opening, just below the ceiling.
const LAMP: Quadrilateral =
    [[343.0, 548.0, 227.0], [343.0, 548.0, 332.0], [213.0, 548.0, 332.0], [213.0, 548.0, 227.0]];

/// A block's corners in plan, x and z, counter-clockwise seen from above, and its height.
struct Block {
    plan: [[f64; 2]; 4],
    height: f64,
}

const SHORT_BLOCK: Block =
    Block { plan: [[130.0, 65.0], [82.0, 225.0], [240.0, 272.0], [290.0, 114.0]], height: 165.0 };
const TALL_BLOCK: Block =
    Block { plan: [[423.0, 247.0], [265.0, 296.0], [314.0, 456.0], [472.0, 406.0]], height: 330.0 };

pub(super) fn scene() -> Scene {
    let mut builder = SceneBuilder::default();
    let root = builder.group("cornell", None, DMat4::IDENTITY);
    let white = matte(&mut builder, "white", srgb(0xdd_dbd7));
    let red = matte(&mut builder, "red", srgb(0xcf_4a3c));
    let green = matte(&mut builder, "green", srgb(0x5f_b24c));
    let glow = builder.material(
        "glow",
        Material { emission: srgb(0xff_f6e0), k_a: 0.0, k_d: 0.0, k_s: 0.0, ..Material::default() },
    );

    let room = builder.group("room", Some(root), DMat4::IDENTITY);
    wall(&mut builder, room, "floor", FLOOR, white);
    wall(&mut builder, room, "ceiling", CEILING, white);
    wall(&mut builder, room, "back_wall", BACK_WALL, white);
    wall(&mut builder, room, "red_wall", RED_WALL, red);
    wall(&mut builder, room, "green_wall", GREEN_WALL, green);
    wall(&mut builder, room, "lamp", LAMP, glow);

    let blocks = builder.group("blocks", Some(root), DMat4::IDENTITY);
    for (name, block) in [("short_block", SHORT_BLOCK), ("tall_block", TALL_BLOCK)] {
        let mesh = builder.mesh(block.mesh(), white);
        builder.object(name, blocks, DMat4::IDENTITY, mesh);
    }

    // Half as strong at about 320 millimetres as at the lamp; so near its front edge that the tall
    // block's front gets some of it.
    let warm = [1.0, 0.93, 0.80];
    builder.lamp("lamp", DVec3::new(278.0, 490.0, 225.0), warm, [0.5, 0.0, 5.0e-6]);
    let cool = [0.26, 0.31, 0.40];
    builder.lamp("viewer", DVec3::new(500.0, 380.0, -250.0), cool, [0.5, 0.0, 2.0e-6]);
    builder.ambient([0.10, 0.10, 0.11]);

    // A lens of 35 mm before a film of 25 x 25 mm.
    let fov_y_degrees = (2.0 * libm::atan(12.5 / 35.0)).to_degrees();
    let eye = DVec3::new(278.0, 273.0, -800.0);
    builder.camera(root, eye, eye + DVec3::Z * 800.0, fov_y_degrees);
    builder.scene
}

fn matte(builder: &mut SceneBuilder, name: &str, diffuse: [f32; 3]) -> MaterialId {
    let reflection = Reflection::Lambert;
    builder.material(name, Material { reflection, diffuse, k_s: 0.0, ..Material::default() })
}

fn wall(
    builder: &mut SceneBuilder,
    parent: NodeId,
    name: &str,
    corners: Quadrilateral,
    material: MaterialId,
) {
    let mut wall = MeshBuilder::default();
    wall.quadrilateral(corners.map(DVec3::from_array));
    let mesh = builder.mesh(wall.finish(), material);
    builder.object(name, parent, DMat4::IDENTITY, mesh);
}

impl Block {
    /// The top and the four sides; the bottom is on the floor.
    fn mesh(&self) -> Mesh {
        let mut builder = MeshBuilder::default();
        let corner = |index: usize, y: f64| {
            let [x, z] = self.plan[index % 4];
            DVec3::new(x, y, z)
        };
        builder.quadrilateral(std::array::from_fn(|index| corner(index, self.height)));
        for side in 0..4 {
            builder.quadrilateral([
                corner(side, self.height),
                corner(side, 0.0),
                corner(side + 1, 0.0),
                corner(side + 1, self.height),
            ]);
        }
        builder.finish()
    }
}
