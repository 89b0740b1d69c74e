//! A scene seen by a camera: instances with their fill rules, and a grid of the instances that may cover
//! each part of the window.

use crate::picker::{PickError, Picker};
use crate::window_cells::WindowCells;
use glam::{DMat4, DVec3};
use luxel_bvh::{Bvh, Quality};
use luxel_math::SUBPIXELS;
use luxel_parallel::Memo;
use luxel_scene::{Camera, Mesh, Size};
use luxel_visibility::{
    CoveragePolicy, Cull, DEFAULT_POINT_SIZE, MAX_SIDE, PlacedScene, Probe, Reach, Strokes,
    SurfaceRules, ViewRays, WindowRays,
};

/// A camera's view of a scene in a window, for queries by pixel.
///
/// Visibility follows the fill rule of frames (`luxel-visibility`): snapped corners, exact edges, the
/// top-left rule. So picks and frames agree at every pixel.
pub struct PickView<'p> {
    pub(crate) picker: &'p Picker,
    /// The instances, as frames place them.
    pub(crate) placed: PlacedScene<'p>,
    /// The tree of each instance, in their order, once a query has come to it.
    trees: Vec<Memo<Box<InstanceTree>>>,
    /// The trees of points and lines, in the order of [`PlacedScene::strokes`].
    bvhs_of_strokes: Vec<Bvh>,
    pub(crate) rays: WindowRays,
    pub(crate) view_rays: ViewRays,
    cells: WindowCells,
}

/// The tree of an instance before the camera.
pub(crate) struct InstanceTree {
    /// From view space to the coordinates of the tree.
    pub(crate) tree_from_view: DMat4,
    pub(crate) probe: Probe,
    pub(crate) reach: Reach,
    /// `None` for an instance without triangles.
    pub(crate) thickness: Option<Thickness>,
    /// Whether the tree's positions are those that the probe takes.
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
        picker: &'p Picker,
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
        let rules = SurfaceRules {
            cull,
            coverage: CoveragePolicy::NEAREST,
            wireframe: false,
            point_size: DEFAULT_POINT_SIZE,
        };
        let placed = PlacedScene::new(
            picker.scene(),
            (picker.objects(), picker.ranks()),
            &camera,
            size,
            &rules,
        );
        let bvhs_of_strokes = placed
            .strokes()
            .iter()
            .map(|Strokes { mesh, .. }| Bvh::build(&mesh.positions, &mesh.triangles, Quality::Fast))
            .collect::<Result<Vec<_>, _>>()?;
        let rays = WindowRays::new(&camera.projection, size);
        let mut view = Self {
            picker,
            placed,
            trees: Vec::new(),
            bvhs_of_strokes,
            rays,
            view_rays: ViewRays::new(&camera, &rays),
            cells: WindowCells::default(),
        };
        let mut places = Vec::new();
        for number in 0..view.placed.instances().len() {
            let tree = view.instance_tree(number);
            places.push(view.place_in_window(number, &tree));
            let kept = Memo::new();
            // To make it again would read all positions.
            if !tree.bounds_tell_depth {
                kept.get_or_compute(|| Box::new(tree));
            }
            view.trees.push(kept);
        }
        view.cells = WindowCells::new(size, &places);
        Ok(view)
    }

    /// The tree of an instance.
    #[inline]
    pub(crate) fn tree(&self, number: usize) -> &InstanceTree {
        self.trees[number].get_or_compute(|| Box::new(self.instance_tree(number)))
    }

    fn instance_tree(&self, number: usize) -> InstanceTree {
        let instance = &self.placed.instances()[number];
        let Geometry { mesh, bvh } = self.geometry(number);
        let (tree_from_view, bounds_tell_depth) = match instance.strokes {
            Some(_) => (DMat4::IDENTITY, true),
            None => {
                let tree = self.picker.tree(instance.first_object());
                let world_from_view = self.camera().view_from_world.inverse();
                (tree.tree_from_world * world_from_view, tree.of_mesh)
            }
        };
        let projection = &self.camera().projection;
        let probe = Probe::new(projection, self.size(), &self.placed.space(number).view_from_local);
        let largest = |bounds: [[f32; 3]; 2]| -> [f32; 3] {
            std::array::from_fn(|axis| bounds[0][axis].abs().max(bounds[1][axis].abs()))
        };
        let bounds = bvh.bounds();
        // The probe takes the mesh's own positions.
        let of_mesh = if bounds_tell_depth { bounds } else { mesh_bounds(mesh) };
        let reach = probe.reach(of_mesh.map_or([0.0; 3], largest));
        let thickness = bounds.map(|bounds| self.thickness(bounds, &tree_from_view, &reach));
        InstanceTree { tree_from_view, probe, reach, thickness, bounds_tell_depth }
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
        let farthest = if self.camera().projection.is_orthographic() {
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
        self.placed.camera()
    }

    /// The window's size.
    #[must_use]
    pub fn size(&self) -> Size {
        self.placed.size()
    }

    /// The scene.
    #[must_use]
    pub fn picker(&self) -> &'p Picker {
        self.picker
    }

    /// The triangles of an instance, and their tree.
    pub(crate) fn geometry(&self, number: usize) -> Geometry<'_> {
        let instance = &self.placed.instances()[number];
        let bvh = match instance.strokes {
            Some(strokes) => &self.bvhs_of_strokes[strokes as usize],
            None => self.picker.tree(instance.first_object()).bvh,
        };
        Geometry { mesh: self.placed.mesh(instance), bvh }
    }

    /// The point or line that a triangle of an instance of strokes is part of.
    pub(crate) fn element(&self, number: usize, triangle: u32) -> u32 {
        let strokes = self.placed.instances()[number].strokes.unwrap_or_default();
        self.placed.strokes()[strokes as usize].elements[triangle as usize / 2]
    }

    /// The instances that may cover a pixel, in order.
    pub(crate) fn instances_at(&self, pixel: [i32; 2]) -> impl Iterator<Item = usize> + '_ {
        self.cells.at(pixel)
    }

    /// Appends the instances that may cover samples between two positions, in order.
    pub(crate) fn instances_between(
        &self,
        first: [i32; 2],
        last: [i32; 2],
        instances: &mut Vec<usize>,
    ) {
        let pixel = |position: [i32; 2]| position.map(|steps| steps.div_euclid(SUBPIXELS));
        self.cells.between(pixel(first), pixel(last), instances);
    }

    /// The pixels that an instance may cover, `None` for none: the corners of its box, or all where
    /// it comes up to the eye.
    fn place_in_window(&self, number: usize, instance: &InstanceTree) -> Option<[f64; 4]> {
        let bounds_of_tree = self.geometry(number).bvh.bounds()?;
        let view_from_tree = instance.tree_from_view.inverse();
        let projection = &self.camera().projection;
        let clip = projection.clip_from_view(self.size());
        let (width, height) = (f64::from(self.size().width), f64::from(self.size().height));
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
