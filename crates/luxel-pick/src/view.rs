//! A scene seen by a camera: instances with their fill rules, and a grid of the instances that may cover
//! each part of the window.

use crate::picker::{PickError, Picker};
use glam::{DMat4, DVec3};
use luxel_bvh::{Bvh, Quality};
use luxel_math::SUBPIXELS;
use luxel_scene::{AlphaMode, Camera, Mesh, Size};
use luxel_visibility::{
    Coverage, Cull, InstanceSpace, MAX_SIDE, PartUse, Probe, Reach, Strokes, ViewFromLocal,
    ViewRays, WindowRays, strokes,
};

/// A camera's view of a scene in a window, for queries by pixel.
///
/// Visibility follows the fill rule of frames (`luxel-visibility`): snapped corners, exact edges, the
/// top-left rule. So picks and frames agree at every pixel.
pub struct PickView<'p> {
    pub(crate) picker: &'p Picker<'p>,
    pub(crate) camera: Camera,
    pub(crate) size: Size,
    pub(crate) rays: WindowRays,
    pub(crate) view_rays: ViewRays,
    /// The objects' triangles, then the points and lines of some.
    pub(crate) instances: Vec<Instance>,
    strokes: Vec<(Strokes, Bvh)>,
    cells: Cells,
}

/// An object's triangles, or its points and lines, seen by the camera.
pub(crate) struct Instance {
    pub(crate) object: usize,
    /// The index among the view's strokes, for points and lines.
    pub(crate) strokes: Option<usize>,
    pub(crate) view_from_mesh: DMat4,
    /// From view space to the coordinates of the tree.
    pub(crate) tree_from_view: DMat4,
    pub(crate) space: InstanceSpace,
    pub(crate) probe: Probe,
    pub(crate) reach: Reach,
    /// `None` for an instance without triangles.
    pub(crate) thickness: Option<Thickness>,
    pub(crate) parts: Vec<PartUse>,
    /// Whether the tree holds the positions that the probe tests.
    pub(crate) bounds_tell_depth: bool,
}

/// Bounds of the distance between a triangle and the line of sight through a sample that it covers, in
/// the coordinates of an instance's tree.
#[derive(Clone, Copy)]
pub(crate) struct Thickness {
    /// Per unit of distance along the viewing axis; constant for orthographic cameras.
    pub(crate) snapped: DVec3,
    /// Constant.
    pub(crate) rounded: DVec3,
    /// The tree's box, enlarged by the bounds.
    pub(crate) wide: [[f32; 3]; 2],
    /// The largest coordinates in the tree.
    pub(crate) largest: [f32; 3],
}

/// The triangles of an instance.
#[derive(Clone, Copy)]
pub(crate) struct Geometry<'v> {
    pub(crate) mesh: &'v Mesh,
    pub(crate) bvh: &'v Bvh,
}

impl<'p> PickView<'p> {
    /// A camera's view of a scene in a window of this size, with the culling of its frames.
    ///
    /// # Errors
    /// [`PickError`] if an object has too many points and lines.
    ///
    /// # Panics
    /// If a side of the window is 0 or more than [`MAX_SIDE`] pixels.
    pub fn new(
        picker: &'p Picker<'p>,
        camera: Camera,
        size: Size,
        cull: Cull,
    ) -> Result<Self, PickError> {
        assert!(
            [size.width, size.height].iter().all(|side| (1..=MAX_SIDE).contains(side)),
            "a window of {} x {} pixels: a side has 1 to {MAX_SIDE}",
            size.width,
            size.height,
        );
        let scene = picker.scene;
        let strokes = strokes(scene, &picker.objects, &camera, size)
            .into_iter()
            .map(|strokes| {
                let mesh = &strokes.mesh;
                let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Fast)?;
                Ok((strokes, bvh))
            })
            .collect::<Result<Vec<_>, PickError>>()?;
        let rays = WindowRays::new(&camera.projection, size);
        let mut view = Self {
            picker,
            camera,
            size,
            rays,
            view_rays: ViewRays::new(&camera, &rays),
            instances: Vec::new(),
            strokes,
            cells: Cells::default(),
        };
        for object in 0..picker.objects.len() {
            let of = &picker.objects[object];
            let mirrored = of.world_from_mesh.determinant() < 0.0;
            let parts = picker.mesh(object).parts.iter().map(|part| {
                let material = &scene.materials[part.material.index()];
                PartUse {
                    cull: cull.faces(material.sides, mirrored),
                    coverage: match material.alpha_mode {
                        AlphaMode::Opaque => Coverage::Opaque,
                        AlphaMode::Mask { .. } | AlphaMode::Blend => Coverage::Cutout,
                    },
                }
            });
            let view_from_mesh = camera.view_from_world * of.world_from_mesh;
            let tree = picker.tree(object);
            let tree_from_view = *tree.tree_from_world * camera.view_from_world.inverse();
            view.add(object, None, view_from_mesh, tree_from_view, parts.collect(), tree.of_mesh);
        }
        for number in 0..view.strokes.len() {
            let (object, parts) =
                (view.strokes[number].0.object, view.strokes[number].0.mesh.parts.len());
            let parts = vec![PartUse::default(); parts];
            view.add(object, Some(number), DMat4::IDENTITY, DMat4::IDENTITY, parts, true);
        }
        let places: Vec<_> =
            view.instances.iter().map(|instance| view.place_in_window(instance)).collect();
        view.cells = Cells::new(size, &places);
        Ok(view)
    }

    fn add(
        &mut self,
        object: usize,
        strokes: Option<usize>,
        view_from_mesh: DMat4,
        tree_from_view: DMat4,
        parts: Vec<PartUse>,
        bounds_tell_depth: bool,
    ) {
        let mesh = match strokes {
            Some(number) => &self.strokes[number].0.mesh,
            None => self.picker.mesh(object),
        };
        let probe = Probe::new(&self.camera.projection, self.size, &view_from_mesh, mesh);
        let bounds = match strokes {
            Some(number) => self.strokes[number].1.bounds(),
            None => self.picker.tree(object).bvh.bounds(),
        };
        let largest = |bounds: [[f32; 3]; 2]| -> [f32; 3] {
            std::array::from_fn(|axis| bounds[0][axis].abs().max(bounds[1][axis].abs()))
        };
        // The probe tests the mesh's own positions.
        let of_mesh = if bounds_tell_depth { bounds } else { mesh_bounds(mesh) };
        let reach = probe.reach(of_mesh.map_or([0.0; 3], largest));
        let thickness = bounds.map(|bounds| self.thickness(bounds, &tree_from_view, &reach));
        let world_from_mesh = &self.picker.objects[object].world_from_mesh;
        let view_from_local = ViewFromLocal::new(&view_from_mesh, mesh.origin);
        let space = InstanceSpace::new(world_from_mesh, view_from_local, &self.camera);
        self.instances.push(Instance {
            object,
            strokes,
            view_from_mesh,
            tree_from_view,
            space,
            probe,
            reach,
            thickness,
            parts,
            bounds_tell_depth,
        });
    }

    fn thickness(&self, bounds: [[f32; 3]; 2], tree_from_view: &DMat4, reach: &Reach) -> Thickness {
        // The extent of a pixel at distance 1.
        let ((o0, d0), (o1, d1)) = (self.rays.ray(0.0, 0.0), self.rays.ray(1.0, 1.0));
        let pixel = ((o1 - o0) + (d1 - d0)).abs();
        let [x_axis, y_axis] =
            [tree_from_view.x_axis, tree_from_view.y_axis].map(|column| column.truncate().abs());
        let steps = |[x, y]: [f64; 2]| {
            // One percent of margin for rounding here and below.
            let scale = 1.01 / f64::from(SUBPIXELS);
            x_axis * (x * pixel.x * scale) + y_axis * (y * pixel.y * scale)
        };
        let snapped = steps([reach.constant; 2]);
        let rounded = steps(reach.by_distance);
        let farthest = if self.camera.projection.is_orthographic() {
            1.0
        } else {
            let view_from_tree = tree_from_view.inverse();
            let depths =
                corners_of(bounds).map(|corner| -view_from_tree.transform_point3(corner).z);
            depths.into_iter().fold(0.0, f64::max)
        };
        let grow = snapped * farthest + rounded;
        let wide = |corner: [f32; 3], sign: f64| {
            std::array::from_fn(|axis| (f64::from(corner[axis]) + sign * grow[axis]) as f32)
        };
        Thickness {
            snapped,
            rounded,
            wide: [wide(bounds[0], -1.0), wide(bounds[1], 1.0)],
            largest: std::array::from_fn(|axis| bounds[0][axis].abs().max(bounds[1][axis].abs())),
        }
    }

    /// The camera.
    #[must_use]
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The window's size.
    #[must_use]
    pub fn size(&self) -> Size {
        self.size
    }

    /// The scene.
    #[must_use]
    pub fn picker(&self) -> &'p Picker<'p> {
        self.picker
    }

    pub(crate) fn geometry(&self, instance: &Instance) -> Geometry<'_> {
        match instance.strokes {
            Some(number) => {
                let (strokes, bvh) = &self.strokes[number];
                Geometry { mesh: &strokes.mesh, bvh }
            }
            None => Geometry {
                mesh: self.picker.mesh(instance.object),
                bvh: self.picker.tree(instance.object).bvh,
            },
        }
    }

    /// The point or line that a triangle of strokes is part of.
    pub(crate) fn element(&self, strokes: usize, triangle: u32) -> u32 {
        self.strokes[strokes].0.elements[triangle as usize / 2]
    }

    /// The instances that may cover a pixel, in order.
    pub(crate) fn instances_at(&self, pixel: [i32; 2]) -> impl Iterator<Item = usize> + '_ {
        self.cells.at(pixel)
    }

    /// The pixels that an instance may cover, if any: the bounds of its box's corners, or the whole window
    /// if it reaches the eye.
    fn place_in_window(&self, instance: &Instance) -> Option<[f64; 4]> {
        let bounds_of_tree = self.geometry(instance).bvh.bounds()?;
        let view_from_tree = instance.tree_from_view.inverse();
        let projection = &self.camera.projection;
        let clip = projection.clip_from_view(self.size);
        let (width, height) = (f64::from(self.size.width), f64::from(self.size.height));
        let mut bounds = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        let mut nearest = f64::INFINITY;
        for corner in corners_of(bounds_of_tree) {
            let place = view_from_tree.transform_point3(corner);
            let clip = clip * place.extend(1.0);
            nearest = nearest.min(clip.w);
            let x = (clip.x / clip.w + 1.0) * 0.5 * width;
            let y = (1.0 - clip.y / clip.w) * 0.5 * height;
            bounds = [bounds[0].min(x), bounds[1].min(y), bounds[2].max(x), bounds[3].max(y)];
        }
        let depth = if projection.is_orthographic() { 1.0 } else { projection.near };
        let before_eye = nearest > depth * 0.5;
        if !before_eye || !bounds.iter().all(|bound| bound.is_finite()) {
            return Some([0.0, 0.0, width, height]);
        }
        // In steps of 1/256 pixel, with a margin of one pixel.
        let grow = |axis: usize| {
            (instance.reach.constant + instance.reach.by_distance[axis] / nearest) / 256.0 + 1.0
        };
        let [x, y] = [grow(0), grow(1)];
        Some([bounds[0] - x, bounds[1] - y, bounds[2] + x, bounds[3] + y])
    }
}

/// A grid over the window: cells list the instances that may cover them, so that queries test few of
/// thousands of objects.
#[derive(Default)]
struct Cells {
    /// A cell's width and height in pixels.
    side: [i32; 2],
    across: usize,
    down: usize,
    /// Instances that cover a large part of the window, in order.
    everywhere: Vec<u32>,
    lists: Vec<Vec<u32>>,
}

/// The most cells along a side of the window.
const CELLS: u32 = 32;

impl Cells {
    fn new(size: Size, places: &[Option<[f64; 4]>]) -> Self {
        let side = [size.width, size.height].map(|pixels| pixels.div_ceil(CELLS).max(8));
        let [across, down] = [(size.width, side[0]), (size.height, side[1])]
            .map(|(pixels, side)| pixels.div_ceil(side) as usize);
        let side = side.map(|side| side as i32);
        let mut cells = Self {
            side,
            across,
            down,
            everywhere: Vec::new(),
            lists: vec![Vec::new(); across * down],
        };
        for (number, place) in (0..).zip(places) {
            let Some([left, top, right, bottom]) = *place else { continue };
            let cell = |at: f64, side: i32, count: usize| {
                (at / f64::from(side)).floor().clamp(-1.0, count as f64) as i64
            };
            let first = [cell(left, side[0], across).max(0), cell(top, side[1], down).max(0)];
            let last = [
                cell(right, side[0], across).min(across as i64 - 1),
                cell(bottom, side[1], down).min(down as i64 - 1),
            ];
            if first[0] > last[0] || first[1] > last[1] {
                continue;
            }
            let count = (last[0] - first[0] + 1) * (last[1] - first[1] + 1);
            if count * 4 > (across * down) as i64 {
                cells.everywhere.push(number);
                continue;
            }
            for row in first[1]..=last[1] {
                for column in first[0]..=last[0] {
                    cells.lists[row as usize * across + column as usize].push(number);
                }
            }
        }
        cells
    }

    fn at(&self, [x, y]: [i32; 2]) -> impl Iterator<Item = usize> + '_ {
        let column = (x / self.side[0]).clamp(0, self.across as i32 - 1) as usize;
        let row = (y / self.side[1]).clamp(0, self.down as i32 - 1) as usize;
        let own = &self.lists[row * self.across + column];
        self.everywhere.iter().chain(own).map(|&number| number as usize)
    }
}

/// The corners of a box.
fn corners_of([low, high]: [[f32; 3]; 2]) -> [DVec3; 8] {
    std::array::from_fn(|corner| {
        let at = |axis: usize| f64::from(if corner >> axis & 1 == 0 { low } else { high }[axis]);
        DVec3::new(at(0), at(1), at(2))
    })
}

/// The box of a mesh's finite positions.
fn mesh_bounds(mesh: &Mesh) -> Option<[[f32; 3]; 2]> {
    let sound = mesh.positions.iter().filter(|place| place.iter().all(|x| x.is_finite()));
    sound.map(|&place| [place, place]).reduce(|[low, high], [place, _]| {
        [
            std::array::from_fn(|axis| low[axis].min(place[axis])),
            std::array::from_fn(|axis| high[axis].max(place[axis])),
        ]
    })
}
