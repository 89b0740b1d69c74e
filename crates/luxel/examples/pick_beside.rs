//! What lies under the mouse in a window that another renderer draws: only its matrices are needed.
//! `cargo run --release -p luxel --example pick_beside [X Y]`

use luxel::pick::{PickView, Picker, SnapTo};
use luxel::prelude::*;
use luxel::render::Cull;
use luxel::scene::demos;
use std::error::Error;
use std::sync::Arc;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let mut side = |default: f64| args.next().map_or(Ok(default), |text| text.parse());
    let mouse = [side(320.5)?, side(180.5)?];

    // The meshes that wgpu, OpenGL or a game engine draws, in their places.
    let scene = Arc::new(demos::demo("spheres").ok_or("the spheres are missing")?);
    // Once a scene: a tree for each mesh.
    let picker = Picker::new(Arc::clone(&scene))?;

    // Once a camera: the view matrix and the projection that the other renderer draws with.
    let window = Size { width: 640, height: 360 };
    let view_from_world =
        Camera::look_at(DVec3::new(2.0, 2.5, 7.0), DVec3::new(0.0, 0.4, 0.0), DVec3::Y);
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    let camera = Camera { view_from_world, projection: Projection { lens, near: 0.1, far: 100.0 } };
    let view = PickView::new(&picker, camera, window, Cull::Auto)?;

    let Some(hit) = view.at(mouse) else {
        println!("nothing is there");
        return Ok(());
    };
    let name = |object: usize| scene.nodes[picker.objects()[object].node.index()].name.as_str();
    println!("{:?} of {} at {:.3}", hit.element, name(hit.object), hit.position);
    println!("normal {:.3?}, distance {:.3}", hit.normal, hit.distance);
    for behind in view.through(mouse).iter().skip(1) {
        println!("behind it {} at a distance of {:.3}", name(behind.object), behind.distance);
    }
    if let Some(snapped) = view.snap(mouse, SnapTo::Vertex, 12.0) {
        println!("snapped to {:?}", snapped.to);
    }
    Ok(())
}
