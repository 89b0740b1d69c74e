//! Picking in a viewer with a window and a renderer of its own, as with winit and wgpu; neither is
//! needed to run this.
//!
//!     cargo run -p luxel-pick --example viewer
//!
//! The renderer is whatever draws with the camera's matrices. Where a comment names an event of
//! winit, its numbers go in.

use luxel_math::SimdLevel;
use luxel_pick::{
    Inclusion, LogicalPosition, LogicalSize, PhysicalSize, PickError, PickView, Picker, Quality,
    Region, SnapTo,
};
use luxel_scene::{Camera, DVec3, Lens, Projection, Scene, demos};
use luxel_visibility::Cull;

/// What the viewer knows.
struct Viewer {
    /// Made once for a scene: trees take about 30 bytes a triangle.
    picker: Picker,
    /// `WindowEvent::Resized`, in physical pixels.
    window: PhysicalSize,
    /// `WindowEvent::ScaleFactorChanged`
    scale_factor: f64,
    camera: Camera,
    /// Where the button went down, for a rectangle.
    pressed: Option<LogicalPosition>,
}

impl Viewer {
    fn new(scene: Scene) -> Result<Self, PickError> {
        let lens = Lens::Perspective { fov_y_radians: 0.8 };
        let scale_factor = 2.0;
        Ok(Self {
            picker: Picker::with(scene, Quality::Thorough, SimdLevel::Auto)?,
            window: LogicalSize { width: 640.0, height: 360.0 }.to_physical(scale_factor),
            scale_factor,
            camera: Camera {
                view_from_world: Camera::look_at(DVec3::new(4.0, 3.0, 8.0), DVec3::Y, DVec3::Y),
                projection: Projection { lens, near: 0.1, far: 100.0 },
            },
            pressed: None,
        })
    }

    /// What the camera sees; made anew when it moves.
    fn view(&self) -> Result<PickView<'_>, PickError> {
        PickView::new(&self.picker, self.camera, self.window.into(), Cull::Auto)
    }

    /// `WindowEvent::CursorMoved`: what lies under the cursor, and the vertex that it snaps to.
    fn hover(&self, cursor: LogicalPosition) -> Result<(), PickError> {
        let at = cursor.to_physical(self.scale_factor);
        let view = self.view()?;
        match view.at(at) {
            None => println!("nothing at {at:?}"),
            Some(hit) => {
                let name = self.name(hit.object);
                println!("{:?} of {name} at {:.3}", hit.element, hit.position);
            }
        }
        if let Some(snapped) = view.snap(at, SnapTo::Vertex, 12.0) {
            println!("  snaps to {snapped:?}");
        }
        Ok(())
    }

    /// `WindowEvent::MouseInput`, pressed.
    fn press(&mut self, cursor: LogicalPosition) {
        self.pressed = Some(cursor);
    }

    /// `WindowEvent::MouseInput`, released: everything in the rectangle that was drawn.
    fn release(&mut self, cursor: LogicalPosition) -> Result<(), Box<dyn std::error::Error>> {
        let Some(pressed) = self.pressed.take() else { return Ok(()) };
        let [a, b] = [pressed, cursor].map(|place| place.to_physical(self.scale_factor));
        let region = Region::between(a, b)?;
        let view = self.view()?;
        for hit in view.sliver(&region, Inclusion::Touching) {
            println!("in the rectangle: {} triangles of {}", hit.triangles, self.name(hit.object));
        }
        for seen in view.visible_in(&region) {
            println!("seen there: {}, {} pixels", self.name(seen.object), seen.pixels);
        }
        Ok(())
    }

    fn name(&self, object: usize) -> &str {
        let node = self.picker.objects()[object].node;
        &self.picker.scene().nodes[node.index()].name
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = demos::demo("plane").ok_or("no such demo")?;
    let mut viewer = Viewer::new(scene)?;
    println!("trees: {} bytes", viewer.picker.memory());
    for (x, y) in [(320.0, 180.0), (300.0, 150.0), (5.0, 5.0)] {
        viewer.hover(LogicalPosition { x, y })?;
    }
    viewer.press(LogicalPosition { x: 280.0, y: 140.0 });
    viewer.release(LogicalPosition { x: 360.0, y: 220.0 })
}
