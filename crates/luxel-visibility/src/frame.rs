//! One view of a list of instances: culled and binned once, then drawn tile by tile.

use crate::cluster::{Instance, Instances, TooManyTriangles, TriangleOf};
use crate::cull::{Bins, Tiles, VisibleCluster, visible_clusters};
use crate::query::{Forms, ProbedCluster, SeenCluster, WindowRays};
use crate::raster::{self, LargeClusters, Plane, Tile};
use crate::types::{
    Asked, Coverage, Holes, MAX_SIDE, PartUse, Region, Samples, TILE, TriangleId, ViewFromLocal,
};
use glam::DVec3;
use luxel_math::{Level, SUBPIXELS, dispatch};
use luxel_scene::{Projection, Size, rank_of};

/// A view, ready to be drawn tile by tile.
pub struct Frame<'a> {
    size: Size,
    samples: Samples,
    rays: WindowRays,
    instances: Instances<'a>,
    opaque: Binned,
    blended: Binned,
}

/// What may be seen, tile by tile.
struct Binned {
    /// Clusters that reach many tiles, by their triangles.
    large: LargeClusters,
    /// All others.
    clusters: Bins,
}

impl Binned {
    fn new(
        mut clusters: Vec<VisibleCluster>,
        instances: &Instances<'_>,
        size: Size,
        samples: Samples,
        level: Level,
    ) -> Self {
        let large = LargeClusters::taken_from(&mut clusters, instances, size, samples, level);
        Self { large, clusters: Bins::new(&clusters, size) }
    }

    /// What a tile's work is estimated by; 0 if nothing reaches it. A cluster that is drawn takes as long
    /// as some four large triangles.
    fn load(&self, tile: usize) -> u32 {
        self.clusters.load(tile).saturating_mul(4).saturating_add(self.large.load(tile))
    }

    fn is_empty(&self) -> bool {
        self.clusters.is_empty() && self.large.is_empty()
    }
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
        Self::of_part(instances, projection, size, Region::whole(size), samples, level)
    }

    /// [`Frame::new`] for a part of the window: tiles with pixels of the part are drawn as in the whole frame. Other tiles
    /// lack the clusters that don't reach the part's.
    ///
    /// # Errors
    /// As [`Frame::new`].
    ///
    /// # Panics
    /// As [`Frame::new`].
    pub fn of_part(
        instances: Vec<Instance<'a>>,
        projection: &Projection,
        size: Size,
        part: Region,
        samples: Samples,
        level: Level,
    ) -> Result<Self, TooManyTriangles> {
        assert!(
            [size.width, size.height].iter().all(|side| (1..=MAX_SIDE).contains(side)),
            "a window of {} x {} pixels: a side has 1 to {MAX_SIDE}",
            size.width,
            size.height,
        );
        let tiles = Tiles::of_region(part, size);
        let instances = Instances::new(instances, projection, size)?;
        let (blended, opaque): (Vec<_>, Vec<_>) =
            visible_clusters(&instances, projection, size, level)
                .filter_map(|visible| visible.within(tiles))
                .partition(|visible| {
                    instances.part_use(visible.cluster).coverage == Coverage::Blended
                });
        let binned = |clusters| Binned::new(clusters, &instances, size, samples, level);
        let (opaque, blended) = (binned(opaque), binned(blended));
        Ok(Self {
            size,
            samples,
            rays: WindowRays::new(projection, size),
            instances,
            opaque,
            blended,
        })
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
        &self.instances.list
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
        tiles.sort_by_cached_key(|&tile| std::cmp::Reverse(self.load(tile as usize)));
        tiles
    }

    /// What a tile's work is estimated by.
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

    /// All blended triangles that cover a sample of a tile, at `position` in steps of 1/256 pixel: nearest
    /// first, of equally near ones the first submitted.
    ///
    /// These are the layers that [`draw_layer`](Self::draw_layer) peels off there, found in one pass.
    #[must_use]
    pub fn blended_at(
        &self,
        number: usize,
        position: [i32; 2],
        holes: &dyn Holes,
    ) -> Vec<TriangleId> {
        let large = self.blended.large.of_tile(number).map(|large| large.id);
        let pixel = position.map(|steps| (steps / SUBPIXELS) as u16);
        let [x, y] = pixel;
        let reaches = |cluster: &&VisibleCluster| {
            (cluster.left..=cluster.right).contains(&x)
                && (cluster.top..=cluster.bottom).contains(&y)
        };
        let clusters = self.blended.clusters.of_tile(number).filter(reaches);
        let mut covering: Vec<(f32, u64, TriangleId)> = Vec::new();
        let mut add = |id: TriangleId, cluster: &ProbedCluster<'_>| {
            let covers = cluster.covers(id, position);
            let seen = covers.filter(|_| holes.holes(&Asked::one(id, position)) == 0);
            covering.extend(seen.map(|depth| (depth, self.instances.submitted(id), id)));
        };
        for id in large {
            add(id, &ProbedCluster::new(&self.instances, id.cluster()));
        }
        for VisibleCluster { cluster, .. } in clusters {
            let probed = ProbedCluster::new(&self.instances, *cluster);
            self.instances.triangles_of(*cluster).for_each(|id| add(id, &probed));
        }
        covering.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        covering.into_iter().map(|(.., id)| id).collect()
    }

    /// The one place where drawing meets the instruction set, so that it is compiled once a level.
    fn draw(
        &self,
        level: Level,
        binned: &Binned,
        number: usize,
        holes: &dyn Holes,
        behind: Option<&[Plane]>,
        tile: &mut Tile,
    ) {
        let view =
            raster::View { instances: &self.instances, samples: self.samples, holes, behind };
        let (large, clusters) = (binned.large.of_tile(number), binned.clusters.of_tile(number));
        dispatch!(level, simd => raster::draw(simd, &view, large, clusters, tile));
    }

    /// What a scene calls the triangle of an id; `None` for [`TriangleId::NONE`].
    #[must_use]
    pub fn triangle(&self, id: TriangleId) -> Option<TriangleOf> {
        self.instances.triangle(id)
    }

    /// All triangles of all instances: instance by instance, in the order of clusters.
    pub fn triangle_ids(&self) -> impl Iterator<Item = TriangleId> + '_ {
        self.instances.triangle_ids()
    }

    /// The instance of a visible triangle, by its place in the list.
    #[must_use]
    #[inline]
    pub fn instance_of(&self, id: TriangleId) -> usize {
        self.instances.of_cluster(id.cluster())
    }

    /// The cluster of a visible triangle, which finds several of its triangles faster than the frame.
    ///
    /// # Panics
    /// If the frame has no such triangle.
    #[must_use]
    #[inline]
    pub fn cluster(&self, id: TriangleId) -> SeenCluster<'_> {
        SeenCluster::new(&self.instances, id)
    }

    /// The forms that give a triangle's barycentrics anywhere in the window.
    #[must_use]
    pub fn forms(&self, of: TriangleOf) -> Forms {
        Forms::new(&self.rays, self.in_view(of))
    }

    /// How an instance's coordinates become those of view space.
    #[must_use]
    pub fn view_from_local(&self, instance: usize) -> &'a ViewFromLocal {
        self.instances.list[instance].view_from_local
    }

    /// A triangle's corners in view space.
    #[must_use]
    pub fn corners_in_view(&self, of: TriangleOf) -> [DVec3; 3] {
        self.in_view(of).map(DVec3::from_array)
    }

    fn in_view(&self, of: TriangleOf) -> [[f64; 3]; 3] {
        let mesh = self.instances.list[of.instance].mesh;
        let corners = mesh.triangles[of.triangle as usize];
        let corners = corners.map(|corner| mesh.positions[corner as usize]);
        self.view_from_local(of.instance).corners(corners)
    }

    /// The [rank](luxel_scene::CoplanarRanks) of a triangle among those in its plane.
    #[must_use]
    pub fn rank_of(&self, of: TriangleOf) -> u8 {
        rank_of(self.instances.list[of.instance].ranks, of.triangle)
    }

    /// How a triangle is drawn.
    #[must_use]
    pub fn use_of(&self, of: TriangleOf) -> PartUse {
        self.instances.list[of.instance].parts[of.part]
    }
}
