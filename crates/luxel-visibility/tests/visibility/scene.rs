//! Scenes whose snapped corners are known exactly: parallel rays, one unit a pixel, corners on the
//! grid of 1/256 pixel, and depths that f32 holds.

use glam::{DMat4, DVec3};
use luxel_math::{Level, SimdLevel};
use luxel_scene::{Lens, MaterialId, Mesh, Part, Projection, Size};
use luxel_visibility::{
    Clusters, Frame, Frames, Holes, Instance, PartUse, Samples, TILE, Tile, TriangleId,
    ViewFromLocal,
};
use std::collections::HashMap;

/// Depths are whole numbers of `1 / DEPTHS`.
pub(crate) const DEPTHS: u16 = 1024;

/// A corner in the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Corner {
    /// Steps of 1/256 pixel from the upper left.
    pub(crate) x: i32,
    pub(crate) y: i32,
    /// Reversed depth times [`DEPTHS`].
    pub(crate) z: u16,
}

impl Corner {
    pub(crate) fn position(self) -> [i32; 2] {
        [self.x, self.y]
    }

    pub(crate) fn depth(self) -> f32 {
        f32::from(self.z) / f32::from(DEPTHS)
    }
}

/// Instance and triangle.
pub(crate) type Submitted = (usize, u32);

/// The triangles of one instance.
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    pub(crate) triangles: Vec<([Corner; 3], PartUse)>,
    /// Whether corners at the same place are one vertex.
    pub(crate) shared: bool,
    /// Whether the mesh is kept upside down, and its matrix turns it.
    pub(crate) mirrored: bool,
}

#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) size: Size,
    pub(crate) samples: u32,
    pub(crate) instances: Vec<Placed>,
}

/// A scene as meshes, ready for frames.
pub(crate) struct Built {
    size: Size,
    samples: Samples,
    instances: Vec<(Mesh, Clusters, ViewFromLocal, Vec<PartUse>)>,
}

impl Scene {
    /// One instance of triangles that are drawn alike.
    pub(crate) fn of(
        size: [u32; 2],
        samples: u32,
        triangles: &[[Corner; 3]],
        part: PartUse,
    ) -> Self {
        let triangles = triangles.iter().map(|corners| (*corners, part)).collect();
        let placed = Placed { triangles, shared: true, mirrored: false };
        Self { size: Size { width: size[0], height: size[1] }, samples, instances: vec![placed] }
    }

    pub(crate) fn build(&self) -> Built {
        let instances = self.instances.iter().map(|placed| self.build_instance(placed)).collect();
        Built { size: self.size, samples: Samples::new(self.samples).unwrap(), instances }
    }

    fn build_instance(&self, placed: &Placed) -> (Mesh, Clusters, ViewFromLocal, Vec<PartUse>) {
        let mut mesh = Mesh::default();
        let mut vertices = HashMap::new();
        let mut uses = Vec::new();
        let up = if placed.mirrored { 1.0 } else { -1.0 };
        for (number, (corners, part)) in (0..).zip(&placed.triangles) {
            let triangle = corners.map(|corner| {
                let next = mesh.positions.len() as u32;
                let vertex =
                    if placed.shared { *vertices.entry(corner).or_insert(next) } else { next };
                if vertex == next {
                    let pixels = |steps: i32| steps as f32 / 256.0;
                    let z = f32::from(corner.z) - f32::from(DEPTHS);
                    mesh.positions.push([pixels(corner.x), up * pixels(corner.y), z]);
                }
                vertex
            });
            mesh.triangles.push(triangle);
            match (uses.last(), mesh.parts.last_mut()) {
                (Some(last), Some(run)) if last == part => run.count += 1,
                _ => {
                    mesh.parts.push(Part { first: number, count: 1, material: MaterialId(0) });
                    uses.push(*part);
                }
            }
        }
        let centre =
            DVec3::new(-0.5 * f64::from(self.size.width), 0.5 * f64::from(self.size.height), 0.0);
        let turned = DVec3::new(1.0, -f64::from(up), 1.0);
        let view_from_mesh = DMat4::from_translation(centre) * DMat4::from_scale(turned);
        let clusters = Clusters::new(&mesh, Frames::Many);
        let place = ViewFromLocal::new(&view_from_mesh, mesh.origin);
        (mesh, clusters, place, uses)
    }

    /// Every sample of the window: its number in a [`Picture`] and its position.
    pub(crate) fn sample_positions(&self) -> impl Iterator<Item = (usize, [i32; 2])> + use<> {
        let samples = Samples::new(self.samples).unwrap();
        let offsets = samples.positions().to_vec();
        let Size { width, height } = self.size;
        (0..height as i32)
            .flat_map(move |y| (0..width as i32).map(move |x| [x, y]))
            .flat_map(move |[x, y]| {
                offsets.clone().into_iter().map(move |o| [x * 256 + o[0], y * 256 + o[1]])
            })
            .enumerate()
    }
}

impl Built {
    pub(crate) fn frame(&self, level: Level) -> Frame<'_> {
        let instances = self
            .instances
            .iter()
            .map(|(mesh, clusters, view_from_local, parts)| Instance {
                mesh,
                clusters,
                view_from_local,
                parts: parts.as_slice().into(),
                ranks: &[],
                is_repeated: false,
            })
            .collect();
        let lens = Lens::Orthographic { height: f64::from(self.size.height) };
        let projection = Projection { lens, near: 0.0, far: f64::from(DEPTHS) };
        Frame::new(instances, &projection, self.size, self.samples, level).unwrap()
    }

    /// The picture of everything opaque.
    pub(crate) fn draw(&self, level: Level) -> Picture {
        Picture::opaque(&self.frame(level), level)
    }
}

/// What every sample of a window sees, pixel by pixel, row by row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Picture {
    pub(crate) seen: Vec<Option<(f32, Submitted)>>,
}

impl Picture {
    /// Nothing anywhere.
    fn new(frame: &Frame<'_>) -> Self {
        let Size { width, height } = frame.size();
        Self { seen: vec![None; (width * height) as usize * frame.samples().count()] }
    }

    pub(crate) fn opaque(frame: &Frame<'_>, level: Level) -> Self {
        Self::with_holes(frame, level, &no_holes)
    }

    pub(crate) fn with_holes(frame: &Frame<'_>, level: Level, hole: &dyn Holes) -> Self {
        let mut picture = Self::new(frame);
        let mut tile = Tile::new(frame.samples().count());
        for number in 0..frame.tiles().iter().product() {
            frame.draw_opaque(level, number, hole, &mut tile);
            picture.take(frame, &tile);
        }
        picture
    }

    /// The blended layers, nearest first, until there is nothing left.
    pub(crate) fn layers(frame: &Frame<'_>, level: Level, hole: &dyn Holes) -> Vec<Self> {
        let mut layers: Vec<Self> = Vec::new();
        let samples = frame.samples().count();
        let [mut opaque, mut behind, mut tile] = [(); 3].map(|()| Tile::new(samples));
        for number in 0..frame.tiles().iter().product() {
            frame.draw_opaque(level, number, hole, &mut opaque);
            let mut layer = 0;
            let mut last: Option<&Tile> = None;
            while frame.draw_layer(level, number, hole, &opaque, last, &mut tile) {
                if layers.len() == layer {
                    layers.push(Self::new(frame));
                }
                layers[layer].take(frame, &tile);
                std::mem::swap(&mut behind, &mut tile);
                last = Some(&behind);
                layer += 1;
            }
        }
        layers
    }

    fn take(&mut self, frame: &Frame<'_>, tile: &Tile) {
        let Size { width, height } = frame.size();
        let samples = frame.samples().count();
        let [left, top] = tile.origin();
        for y in 0..TILE.min(height as i32 - top) {
            for x in 0..TILE.min(width as i32 - left) {
                let pixel = ((top + y) * width as i32 + left + x) as usize;
                let (block, lane) = Tile::place(x, y);
                for (sample, plane) in tile.planes().iter().enumerate() {
                    let id = tile.id(x, y, sample);
                    assert_eq!(id, TriangleId(plane.ids[block][lane]));
                    self.seen[pixel * samples + sample] = frame
                        .triangle(id)
                        .map(|of| (plane.depth[block][lane], (of.instance, of.triangle)));
                }
            }
        }
    }
}

pub(crate) fn no_holes(_: TriangleId, _: [i32; 2]) -> bool {
    false
}

/// The best level of this machine.
pub(crate) fn best() -> Level {
    SimdLevel::Auto.resolve().unwrap()
}
