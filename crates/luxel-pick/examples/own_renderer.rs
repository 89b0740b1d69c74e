//! Picking beside a renderer of your own, as with winit and wgpu: your buffers, your matrices, your
//! events. Neither crate is needed to run this; where a comment names one, its numbers go in.
//!
//!     cargo run -p luxel-pick --example own_renderer
//!
//! What lies under the mouse is found by rays, so no pixel has to come back from the graphics card.
//! Where ids have been drawn into a texture anyway, [`VisibleIds`] answers from those.

use luxel_pick::{
    LogicalPosition, LogicalSize, NO_ID, PhysicalPosition, PhysicalSize, Picker, Region, Viewport,
    VisibleIds, WorldHit, WorldRay, unproject,
};
use luxel_scene::{DMat4, DVec3, MaterialId, Mesh, MeshId, Node, Part, Scene, SceneMaterial, Size};

/// What you have uploaded: `wgpu::util::BufferInitDescriptor::contents`, before it became bytes.
struct Uploaded {
    vertices: Vec<[f32; 3]>,
    indices: Vec<u32>,
}

/// A draw call: a mesh and the model matrix of its uniform.
struct Drawn {
    name: &'static str,
    mesh: u32,
    world_from_model: DMat4,
}

/// Your meshes and draw calls as a scene: positions and indices are all that rays need.
fn scene_of(meshes: &[Uploaded], drawn: &[Drawn]) -> Scene {
    let mesh = |uploaded: &Uploaded| {
        let (triangles, _) = uploaded.indices.as_chunks::<3>();
        let count = triangles.len() as u32;
        Mesh {
            positions: uploaded.vertices.clone(),
            triangles: triangles.to_vec(),
            parts: vec![Part { first: 0, count, material: MaterialId(0) }],
            ..Mesh::default()
        }
    };
    let node = |drawn: &Drawn| Node {
        parent_from_node: drawn.world_from_model.into(),
        ..Node::root(drawn.name, Some(MeshId(drawn.mesh)))
    };
    Scene {
        meshes: meshes.iter().map(mesh).collect(),
        materials: vec![SceneMaterial::default()],
        nodes: drawn.iter().map(node).collect(),
        ..Scene::default()
    }
}

/// The matrices of your camera's uniform. Depth runs from 0 to 1 with wgpu; [`unproject`] has that of
/// OpenGL, -1 to 1.
struct Camera {
    view_from_world: DMat4,
    /// As `glam::camera::rh::proj::directx::perspective` and the like make it.
    clip_from_view: DMat4,
}

impl Camera {
    /// The projection with OpenGL's depth: z' = 2 z - w.
    fn clip_for_opengl(&self) -> DMat4 {
        let depth =
            DMat4::from_translation(DVec3::NEG_Z) * DMat4::from_scale(DVec3::new(1.0, 1.0, 2.0));
        depth * self.clip_from_view
    }

    /// The line of sight under the mouse, from the near plane on.
    fn ray(&self, mouse: PhysicalPosition, window: PhysicalSize) -> Option<WorldRay> {
        let (clip, viewport) = (self.clip_for_opengl(), Viewport::of(window.into()));
        // Windows begin at the upper left, GLU's at the lower left.
        let at = mouse.flipped(window);
        // Two places on the line; the second anywhere before the far plane, which may be at infinity.
        let place =
            |depth: f64| unproject(at.extend(depth), &self.view_from_world, &clip, viewport);
        let (near, beyond) = (place(0.0)?, place(0.5)?);
        Some(WorldRay::new(near, beyond - near))
    }
}

/// wgpu's perspective, depth 0 near to 1 at infinity.
fn perspective(fov_y_radians: f64, aspect: f64, near: f64) -> DMat4 {
    let height = 1.0 / libm::tan(fov_y_radians / 2.0);
    DMat4::from_cols_array(&[
        height / aspect,
        0.0,
        0.0,
        0.0,
        0.0,
        height,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.0,
        -1.0,
        0.0,
        0.0,
        -near,
        0.0,
    ])
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let pyramid = Uploaded {
        vertices: vec![
            [-1.0, 0.0, -1.0],
            [1.0, 0.0, -1.0],
            [1.0, 0.0, 1.0],
            [-1.0, 0.0, 1.0],
            [0.0, 1.5, 0.0],
        ],
        indices: vec![0, 1, 2, 0, 2, 3, 0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0],
    };
    let place = |x: f64, z: f64| DMat4::from_translation(DVec3::new(x, 0.0, z));
    let drawn = [
        Drawn { name: "left", mesh: 0, world_from_model: place(-1.5, 0.0) },
        Drawn { name: "right", mesh: 0, world_from_model: place(1.5, -2.0) },
    ];
    // Once; trees are built for each mesh, and one over all draw calls.
    let scene = scene_of(&[pyramid], &drawn);
    let picker = Picker::new(scene)?;

    // `Window::scale_factor` and `Window::inner_size`, which winit gives in pixels already.
    let scale_factor = 2.0;
    let window = LogicalSize { width: 640.0, height: 360.0 }.to_physical(scale_factor);
    let camera = Camera {
        view_from_world: DMat4::from_translation(DVec3::new(0.0, -0.6, -7.0)),
        clip_from_view: perspective(0.8, f64::from(window.width) / f64::from(window.height), 0.1),
    };

    // `WindowEvent::CursorMoved { position, .. }` is physical, too; egui's are logical.
    for mouse in [(220.0, 190.0), (410.0, 190.0), (20.0, 20.0)] {
        let mouse = LogicalPosition { x: mouse.0, y: mouse.1 }.to_physical(scale_factor);
        let hit = camera.ray(mouse, window).and_then(|ray| picker.closest(&ray));
        match hit {
            Some(WorldHit { object, triangle, position, .. }) => {
                println!(
                    "{mouse:?}: triangle {triangle} of {} at {position:.3}",
                    drawn[object].name
                );
            }
            None => println!("{mouse:?}: nothing"),
        }
    }

    // Where a pass has written ids (`TextureFormat::R32Uint`, cleared to 4294967295), a rubber band
    // is counted from them. Here rays stand in for the graphics card.
    let ids = ids_by_rays(&picker, &camera, window).ok_or("an id for each pixel")?;
    let band = Region::between([100.0, 200.0].into(), [500.0, 500.0].into())?;
    for seen in ids.in_region(&band) {
        println!("in the rubber band: {}, {} pixels", drawn[seen.object].name, seen.pixels);
    }
    Ok(())
}

/// What each pixel shows, as a pass that writes ids would leave it.
fn ids_by_rays(picker: &Picker, camera: &Camera, window: PhysicalSize) -> Option<VisibleIds> {
    let size: Size = window.into();
    let pixels = (0..size.height).flat_map(|y| (0..size.width).map(move |x| (x, y)));
    let hit = |(x, y)| {
        camera.ray(PhysicalPosition::centre_of(x, y), window).and_then(|ray| picker.closest(&ray))
    };
    let ids =
        |hit: Option<WorldHit>| hit.map_or((NO_ID, NO_ID), |hit| (hit.object as u32, hit.triangle));
    let (objects, triangles) = pixels.map(|pixel| ids(hit(pixel))).unzip();
    VisibleIds::new(size, objects, triangles)
}
