//! One view of a list of instances: what is culled and binned once, then drawn tile by tile.

use crate::barycentric::{Forms, WindowRays};
use crate::bin::Bins;
use crate::buffer::{Plane, TILE, Tile, TriangleId};
use crate::cluster::{Block, Clusters, Numbers, SLOT_BITS, ShadingVertex};
use crate::cull::{BackFaces, MAX_SIDE, VisibleCluster, cull_group};
use crate::facing::Onlooker;
use crate::holes::Holes;
use crate::open::corners;
use crate::samples::Samples;
use crate::setup::CullFaces;
use crate::space::ViewFromLocal;
use crate::tile;
use crate::transform::WindowTransform;
use glam::{DMat4, DVec3};
use luxel_math::{LANES, Level, Simd, dispatch};
use luxel_scene::{Mesh, Projection, Size};
use rayon::prelude::*;

/// A mesh in its place.
#[derive(Clone, Debug)]
pub struct Instance<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// The mesh, cut into clusters.
    pub clusters: &'a Clusters,
    /// From the mesh's own space to the camera's.
    pub view_from_mesh: DMat4,
    /// How each part of the mesh is drawn.
    pub parts: Vec<PartUse>,
}

/// How a part of a mesh is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PartUse {
    /// The faces that are left out.
    pub cull: CullFaces,
    /// What its triangles do to what lies behind them.
    pub coverage: Coverage,
}

/// What a triangle does to what lies behind it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Coverage {
    /// Hides it.
    #[default]
    Opaque,
    /// Hides it but for holes.
    Cutout,
    /// Lets it through: drawn in layers.
    Blended,
}

/// A triangle by what a scene calls it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TriangleOf {
    /// The instance, by its place in the list.
    pub instance: usize,
    /// The triangle, by its place in the mesh.
    pub triangle: u32,
    /// The part of the mesh.
    pub part: usize,
}

/// More clusters than ids can number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the scene has {clusters} clusters of triangles; ids can tell {limit} apart")]
pub struct TooManyTriangles {
    /// Clusters of all instances.
    pub clusters: u64,
    /// The most.
    pub limit: u64,
}

/// A view, ready to be drawn tile by tile.
pub struct Frame<'a> {
    size: Size,
    samples: Samples,
    rays: WindowRays,
    instances: Vec<Instance<'a>>,
    transforms: Vec<WindowTransform>,
    places: Vec<ViewFromLocal>,
    /// The number of each instance's first cluster, and after them the number of all.
    first_clusters: Vec<u32>,
    opaque: Bins,
    blended: Bins,
}

impl<'a> Frame<'a> {
    /// Culls and bins the clusters of all instances.
    ///
    /// # Errors
    /// [`TooManyTriangles`] beyond some billions.
    ///
    /// # Panics
    /// If a side of the window is 0 or more than [`MAX_SIDE`] pixels.
    pub fn new(
        instances: Vec<Instance<'a>>,
        projection: &Projection,
        size: Size,
        samples: Samples,
        level: Level,
    ) -> Result<Self, TooManyTriangles> {
        assert!(
            [size.width, size.height].iter().all(|side| (1..=MAX_SIDE).contains(side)),
            "a window of {} x {} pixels: a side has 1 to {MAX_SIDE}",
            size.width,
            size.height,
        );
        let mut first_clusters = vec![0];
        let mut clusters = 0_u64;
        // The highest number of all stands for nothing.
        let limit = (1 << (u32::BITS - SLOT_BITS)) - 1;
        for instance in &instances {
            clusters += instance.clusters.count() as u64;
            first_clusters.push(clusters.min(limit) as u32);
        }
        if clusters > limit {
            return Err(TooManyTriangles { clusters, limit });
        }
        let (transforms, onlookers): (Vec<_>, Vec<_>) = instances
            .iter()
            .map(|instance| {
                let view_from_local =
                    instance.view_from_mesh * DMat4::from_translation(instance.mesh.origin);
                let onlooker = Onlooker::new(projection, size, &view_from_local);
                (WindowTransform::new(projection, size, &view_from_local), onlooker)
            })
            .unzip();

        // Groups of sixteen clusters, in runs that are cut by number.
        const RUN: usize = 64;
        let runs: Vec<(usize, std::ops::Range<usize>)> = instances
            .iter()
            .enumerate()
            .flat_map(|(number, instance)| {
                let groups = instance.clusters.count().div_ceil(LANES);
                (0..groups).step_by(RUN).map(move |start| (number, start..groups.min(start + RUN)))
            })
            .collect();
        let visible: Vec<Vec<VisibleCluster>> = runs
            .into_par_iter()
            .map(|(number, groups)| {
                let (transform, clusters) = (&transforms[number], instances[number].clusters);
                let first = first_clusters[number];
                let parts = &instances[number].parts;
                let onlooker = onlookers[number].as_ref();
                let faces = onlooker.map(|onlooker| BackFaces { onlooker, parts });
                dispatch!(level, simd => cull_run(simd, transform, size, clusters, groups.clone(), first, faces))
            })
            .collect();
        let places = instances
            .iter()
            .map(|instance| ViewFromLocal::new(&instance.view_from_mesh, instance.mesh.origin))
            .collect();
        let mut frame = Self {
            places,
            size,
            samples,
            rays: WindowRays::new(projection, size),
            instances,
            transforms,
            first_clusters,
            opaque: Bins::default(),
            blended: Bins::default(),
        };
        let (blended, opaque): (Vec<_>, Vec<_>) = visible
            .into_iter()
            .flatten()
            .partition(|visible| frame.part_use(visible.cluster).coverage == Coverage::Blended);
        frame.opaque = Bins::new(opaque, size);
        frame.blended = Bins::new(blended, size);
        Ok(frame)
    }

    /// The window's size.
    #[must_use]
    pub fn size(&self) -> Size {
        self.size
    }

    /// The sample pattern.
    #[must_use]
    pub fn samples(&self) -> Samples {
        self.samples
    }

    /// How window positions become rays.
    #[must_use]
    pub fn rays(&self) -> &WindowRays {
        &self.rays
    }

    /// The instances, as they were given.
    #[must_use]
    pub fn instances(&self) -> &[Instance<'a>] {
        &self.instances
    }

    /// Tiles across and down.
    #[must_use]
    pub fn tiles(&self) -> [usize; 2] {
        [self.size.width, self.size.height].map(|pixels| (pixels as usize).div_ceil(TILE as usize))
    }

    /// The first pixel of a tile: column and row.
    #[must_use]
    pub fn tile_origin(&self, tile: usize) -> [i32; 2] {
        let [across, _] = self.tiles();
        [(tile % across) as i32 * TILE, (tile / across) as i32 * TILE]
    }

    /// All tiles, those with the most work first, so that no worker ends with a long one.
    #[must_use]
    pub fn tiles_by_load(&self) -> Vec<u32> {
        let [across, down] = self.tiles();
        let mut tiles: Vec<u32> = (0..(across * down) as u32).collect();
        tiles.sort_by_key(|&tile| std::cmp::Reverse(self.load(tile as usize)));
        tiles
    }

    /// What a tile's work is estimated by: how many clusters it has to look at.
    fn load(&self, tile: usize) -> u32 {
        self.opaque.load(tile).saturating_add(self.blended.load(tile))
    }

    /// Whether nothing can be seen in a tile.
    #[must_use]
    pub fn is_tile_empty(&self, tile: usize) -> bool {
        self.load(tile) == 0
    }

    /// Whether anything blended may be seen anywhere.
    #[must_use]
    pub fn has_blended(&self) -> bool {
        !self.blended.is_empty()
    }

    /// Draws what is opaque in a tile, from nothing.
    pub fn draw_opaque(&self, level: Level, number: usize, holes: &dyn Holes, tile: &mut Tile) {
        let [x, y] = self.tile_origin(number);
        tile.clear(x, y, self.size);
        self.draw(level, &self.opaque, number, holes, None, tile);
    }

    /// Draws the nearest blended layer of a tile: before `opaque`, and behind the layers that were
    /// drawn before (`behind`). Samples without one keep the opaque id. Whether there is any.
    ///
    /// Called again and again with the last outcome, it peels off layer after layer (Everitt 2001).
    pub fn draw_layer(
        &self,
        level: Level,
        number: usize,
        holes: &dyn Holes,
        opaque: &Tile,
        behind: Option<&Tile>,
        tile: &mut Tile,
    ) -> bool {
        tile.copy_from(opaque);
        if self.blended.is_empty() {
            return false;
        }
        let behind = behind.map(Tile::planes);
        self.draw(level, &self.blended, number, holes, behind, tile);
        let changed = |(layer, opaque): (&Plane, &Plane)| layer.ids != opaque.ids;
        tile.planes().iter().zip(opaque.planes()).any(changed)
    }

    /// The one place where drawing meets the instruction set, so that it is compiled once a level.
    fn draw(
        &self,
        level: Level,
        bins: &Bins,
        number: usize,
        holes: &dyn Holes,
        behind: Option<&[Plane]>,
        tile: &mut Tile,
    ) {
        dispatch!(level, simd => tile::draw(simd, self, bins.of_tile(number), holes, behind, tile));
    }

    /// What a scene calls the triangle of an id; `None` for [`TriangleId::NONE`].
    #[must_use]
    pub fn triangle(&self, id: TriangleId) -> Option<TriangleOf> {
        if id == TriangleId::NONE {
            return None;
        }
        let instance = self.instance_of(id.cluster());
        let clusters = self.instances[instance].clusters;
        let cluster = (id.cluster() - self.first_clusters[instance]) as usize;
        let triangle = clusters.original(cluster, id.slot());
        Some(TriangleOf { instance, triangle, part: clusters.headers[cluster].part as usize })
    }

    /// All triangles of all instances: instance by instance, in the order of clusters.
    pub fn triangle_ids(&self) -> impl Iterator<Item = TriangleId> + '_ {
        self.instances.iter().zip(&self.first_clusters).flat_map(|(instance, &first)| {
            let headers = (first..).zip(&instance.clusters.headers);
            headers.flat_map(|(cluster, header)| {
                (0..usize::from(header.triangles)).map(move |slot| TriangleId::new(cluster, slot))
            })
        })
    }

    /// The cluster of a triangle that is seen, opened to be asked for several of its triangles.
    ///
    /// # Panics
    /// If the frame has no such triangle.
    #[must_use]
    #[inline]
    pub fn cluster(&self, id: TriangleId) -> SeenCluster<'_> {
        let number = id.cluster();
        let instance = self.instance_of(number);
        let within = self.within_instance(instance, number);
        let Instance { mesh, clusters, .. } = self.instances[instance];
        SeenCluster {
            number,
            instance,
            part: clusters.headers[within].part as usize,
            numbers: clusters.numbers(within),
            mesh,
            block: clusters.kept(within),
        }
    }

    /// The place of a triangle in the order in which triangles were submitted.
    pub(crate) fn submitted(&self, id: TriangleId) -> u64 {
        self.triangle(id).map_or(u64::MAX, |of| (of.instance as u64) << 32 | u64::from(of.triangle))
    }

    /// The forms that give a triangle's barycentrics anywhere in the window.
    #[must_use]
    pub fn forms(&self, of: TriangleOf) -> Forms {
        Forms::new(&self.rays, self.in_view(of))
    }

    /// How an instance's coordinates become those of view space.
    #[must_use]
    pub fn view_from_local(&self, instance: usize) -> ViewFromLocal {
        self.places[instance]
    }

    /// A triangle's corners in view space.
    #[must_use]
    pub fn corners_in_view(&self, of: TriangleOf) -> [DVec3; 3] {
        self.in_view(of).map(DVec3::from_array)
    }

    fn in_view(&self, of: TriangleOf) -> [[f64; 3]; 3] {
        let mesh = self.instances[of.instance].mesh;
        let corners = mesh.triangles[of.triangle as usize];
        let corners = corners.map(|corner| mesh.positions[corner as usize]);
        self.places[of.instance].corners(corners)
    }

    /// The instance that a cluster belongs to.
    pub(crate) fn instance_of(&self, cluster: u32) -> usize {
        if self.instances.len() == 1 {
            return 0;
        }
        self.first_clusters.partition_point(|&first| first <= cluster) - 1
    }

    /// A cluster's number within its instance.
    pub(crate) fn within_instance(&self, instance: usize, cluster: u32) -> usize {
        (cluster - self.first_clusters[instance]) as usize
    }

    pub(crate) fn transform(&self, instance: usize) -> &WindowTransform {
        &self.transforms[instance]
    }

    /// How a triangle is drawn.
    #[must_use]
    pub fn use_of(&self, of: TriangleOf) -> PartUse {
        self.instances[of.instance].parts[of.part]
    }

    fn part_use(&self, cluster: u32) -> PartUse {
        let instance = self.instance_of(cluster);
        let within = self.within_instance(instance, cluster);
        let Instance { clusters, parts, .. } = &self.instances[instance];
        parts[clusters.headers[within].part as usize]
    }
}

/// A cluster of a frame, of which something is seen.
pub struct SeenCluster<'f> {
    number: u32,
    instance: usize,
    part: usize,
    numbers: Numbers<'f>,
    mesh: &'f Mesh,
    /// Where it is drawn from, if that is kept.
    block: Option<Block<'f>>,
}

impl<'f> SeenCluster<'f> {
    /// Whether a triangle belongs to it.
    #[must_use]
    #[inline(always)]
    pub fn holds(&self, id: TriangleId) -> bool {
        id.cluster() == self.number
    }

    /// The instance that it is part of, by its place in the list.
    #[must_use]
    #[inline(always)]
    pub fn instance(&self) -> usize {
        self.instance
    }

    /// The part of the mesh.
    #[must_use]
    #[inline(always)]
    pub fn part(&self) -> usize {
        self.part
    }

    /// The place in the mesh of a triangle that it [`holds`](Self::holds).
    ///
    /// # Panics
    /// If it has no such triangle.
    #[must_use]
    #[inline(always)]
    pub fn triangle(&self, id: TriangleId) -> u32 {
        self.numbers.of(id.slot())
    }

    /// The positions of the corners of a triangle that it [`holds`](Self::holds), about the mesh's
    /// origin: from what it was drawn from, which was in the cache then.
    ///
    /// # Panics
    /// If it has no such triangle.
    #[must_use]
    #[inline(always)]
    pub fn positions(&self, id: TriangleId) -> [[f32; 3]; 3] {
        match &self.block {
            Some(block) => block.positions(id.slot()),
            None => corners(self.mesh, self.triangle(id)),
        }
    }

    /// What the corners of a triangle that it [`holds`](Self::holds) carry, if that is kept.
    ///
    /// # Panics
    /// If it has no such triangle.
    #[must_use]
    #[inline(always)]
    pub fn shading_vertices(&self, id: TriangleId) -> Option<[&'f ShadingVertex; 3]> {
        self.block?.shading_vertices(id.slot())
    }
}

/// Culls the groups of a run.
#[inline(always)]
fn cull_run<S: Simd>(
    simd: S,
    transform: &WindowTransform,
    size: Size,
    clusters: &Clusters,
    groups: std::ops::Range<usize>,
    first_cluster: u32,
    back_faces: Option<BackFaces<'_>>,
) -> Vec<VisibleCluster> {
    let mut visible = Vec::new();
    for group in groups {
        cull_group(simd, transform, size, clusters, group, first_cluster, back_faces, &mut visible);
    }
    visible
}
