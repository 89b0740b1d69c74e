//! A scene prepared for rays: a tree per mesh, and one over all bodies.

use crate::bodies::{Bodies, opaque_parts};
use crate::body_tree::{BodyTree, PlacedTree, PlacedTrees, Sphere, all, sphere_around};
use glam::DVec3;
use luxel_bvh::{BoxTree, Bvh, MeshRays, Quality, TooManyForTree};
use luxel_math::{Level, SimdLevel};
use luxel_parallel::map;
use luxel_scene::{Mesh, Object, Scene, UnsoundScene};
use std::ops::Range;
use std::sync::Arc;

/// Why a scene can't be prepared for rays.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RaysError {
    /// The scene refers to what isn't there.
    #[error(transparent)]
    Unsound(#[from] UnsoundScene),
    /// A mesh has too many triangles.
    #[error(transparent)]
    TooManyTriangles(#[from] TooManyForTree),
}

/// A scene prepared for world-space rays. It shares the scene: a program can keep both.
pub struct SceneRays {
    scene: Arc<Scene>,
    pub(crate) bodies: Bodies,
    pub(crate) level: Level,
    trees: MeshTrees,
    /// The trees of the bodies.
    placed: PlacedTrees,
    /// Whether nothing shines through a mesh.
    opaque_meshes: Vec<bool>,
    /// The tree over the bodies' boxes, relative to `middle`.
    pub(crate) top: BoxTree,
    pub(crate) middle: DVec3,
}

/// The trees of a scene's meshes, without what places them in the world.
pub struct MeshTrees {
    bvhs: Vec<Bvh>,
    spheres: Vec<Option<Sphere>>,
    /// How many triangles each mesh has.
    counts: Vec<usize>,
    quality: Quality,
}

impl MeshTrees {
    /// Builds the trees of a scene's meshes on all threads of the current pool.
    ///
    /// # Errors
    /// [`TooManyForTree`] if a mesh has too many triangles.
    fn build(scene: &Scene, quality: Quality) -> Result<Self, TooManyForTree> {
        let bvhs = map(scene.meshes.len(), 1, &|run| {
            let mesh = &scene.meshes[run.start];
            Some(Bvh::build(&mesh.positions, &mesh.triangles, quality))
        });
        let bvhs = all(bvhs)?;
        let spheres = bvhs.iter().map(sphere_around).collect();
        let counts = scene.meshes.iter().map(|mesh| mesh.triangles.len()).collect();
        Ok(Self { bvhs, spheres, counts, quality })
    }

    /// Whether a scene has as many meshes with as many triangles.
    fn are_of(&self, scene: &Scene) -> bool {
        let counts = scene.meshes.iter().map(|mesh| mesh.triangles.len());
        counts.eq(self.counts.iter().copied())
    }
}

/// A world-space box relative to `middle`, rounded outwards.
fn rounded([low, high]: [DVec3; 2], middle: DVec3) -> [[f32; 3]; 2] {
    [
        (low - middle).as_vec3().to_array().map(f32::next_down),
        (high - middle).as_vec3().to_array().map(f32::next_up),
    ]
}

fn is_valid([low, high]: &[DVec3; 2]) -> bool {
    low.cmple(*high).all() && low.is_finite() && high.is_finite()
}

/// A scene in which bodies can be traced as one, and these objects in it: with a mesh for every object, if the scene
/// itself is none.
fn traceable(scene: Arc<Scene>, objects: Arc<Vec<Object>>) -> (Arc<Scene>, Arc<Vec<Object>>) {
    if Bodies::are_traceable(&scene, &objects) {
        return (scene, objects);
    }
    let separate = scene.separated().into_owned();
    let mut all: Vec<Option<Object>> = vec![None; separate.nodes.len()];
    for object in separate.objects() {
        let node = object.node.index();
        all[node] = Some(object);
    }
    let objects = objects.iter().filter_map(|object| all[object.node.index()].take());
    (Arc::new(separate), Arc::new(objects.collect()))
}

impl SceneRays {
    /// Builds the trees on all threads of the current pool, for the best instruction set of the machine.
    ///
    /// # Errors
    /// [`RaysError`] if the scene isn't [sound](Scene::check) or a mesh has too many triangles.
    pub fn new(scene: impl Into<Arc<Scene>>) -> Result<Self, RaysError> {
        let level = SimdLevel::Auto.resolve().unwrap_or_else(|_| Level::baseline());
        Self::with(scene.into(), Quality::Thorough, level)
    }

    /// Builds the trees with a given quality and instruction set.
    ///
    /// # Errors
    /// [`RaysError`] if the scene isn't [sound](Scene::check) or a mesh has too many triangles.
    pub fn with(scene: Arc<Scene>, quality: Quality, level: Level) -> Result<Self, RaysError> {
        scene.check()?;
        let objects = scene.objects();
        Ok(Self::of_objects(scene, objects, quality, level)?)
    }

    /// [`SceneRays::with`], for some objects only of a scene that has been checked: hits number these.
    ///
    /// Where objects share a mesh of which others are left out, or of which only a part is opaque, all get meshes of
    /// their own first, in a copy of the scene.
    ///
    /// # Errors
    /// [`TooManyForTree`] if a mesh has too many triangles.
    ///
    /// # Panics
    /// If the scene isn't [sound](Scene::check), or an object isn't its own.
    pub fn of_objects(
        scene: Arc<Scene>,
        objects: impl Into<Arc<Vec<Object>>>,
        quality: Quality,
        level: Level,
    ) -> Result<Self, TooManyForTree> {
        let (scene, objects) = traceable(scene, objects.into());
        let trees = MeshTrees::build(&scene, quality)?;
        Self::placed(trees, scene, objects, level)
    }

    /// [`SceneRays::of_objects`], with trees that were built before: of a scene with the same meshes, but
    /// perhaps other materials, nodes or objects. Meshes with other numbers of triangles get new trees;
    /// those with as many, but other ones, would be hit wrongly.
    ///
    /// # Errors
    /// [`TooManyForTree`] if a mesh has too many triangles.
    ///
    /// # Panics
    /// If the scene isn't [sound](Scene::check), or an object isn't its own.
    pub fn with_trees(
        trees: MeshTrees,
        scene: Arc<Scene>,
        objects: impl Into<Arc<Vec<Object>>>,
        level: Level,
    ) -> Result<Self, TooManyForTree> {
        let (scene, objects) = traceable(scene, objects.into());
        let quality = trees.quality;
        let trees = if trees.are_of(&scene) { trees } else { MeshTrees::build(&scene, quality)? };
        Self::placed(trees, scene, objects, level)
    }

    /// Lets go of the scene, and keeps the trees of its meshes.
    #[must_use]
    pub fn into_trees(self) -> MeshTrees {
        self.trees
    }

    /// Places the trees of a scene's meshes where its objects are.
    fn placed(
        trees: MeshTrees,
        scene: Arc<Scene>,
        objects: Arc<Vec<Object>>,
        level: Level,
    ) -> Result<Self, TooManyForTree> {
        let quality = trees.quality;
        let opaque_meshes =
            scene.meshes.iter().map(|mesh| opaque_parts(&scene, mesh).all(|is| is)).collect();
        let bodies = Bodies::new(objects);
        let objects = (0..bodies.len()).map(|body| bodies.object(body));
        let placed = PlacedTrees::new(&scene, objects, quality)?;
        let mut rays = Self {
            scene,
            bodies,
            level,
            trees,
            placed,
            opaque_meshes,
            top: BoxTree::default(),
            middle: DVec3::ZERO,
        };
        // Computed twice: to keep them takes more memory than all else of small bodies.
        let boxes = || (0..rays.bodies.len()).map(|body| rays.tree(body).world_box());
        let all = boxes()
            .filter(is_valid)
            .fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], bounds| {
                [low.min(bounds[0]), high.max(bounds[1])]
            });
        let middle = if is_valid(&all) { all[0] * 0.5 + all[1] * 0.5 } else { DVec3::ZERO };
        let boxes: Vec<_> =
            boxes().map(|bounds| is_valid(&bounds).then(|| rounded(bounds, middle))).collect();
        rays.middle = middle;
        rays.top = BoxTree::build(&boxes, Quality::Fast)?;
        Ok(rays)
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// The objects; hits give their indices.
    #[must_use]
    pub fn objects(&self) -> &[Object] {
        self.bodies.objects()
    }

    /// How many bodies there are: an object each, or all that share a mesh as its [sections](Mesh::sections).
    #[must_use]
    pub fn bodies(&self) -> usize {
        self.bodies.len()
    }

    /// The objects of a body, which follow one another.
    ///
    /// # Panics
    /// If there is no such body.
    #[must_use]
    pub fn objects_of(&self, body: usize) -> Range<usize> {
        self.bodies.objects_of(body)
    }

    /// The body of an object.
    #[must_use]
    pub fn body_of(&self, object: usize) -> usize {
        self.bodies.body_of(object)
    }

    /// The body of an object, and the place in the body's mesh of the object's triangle.
    ///
    /// # Panics
    /// If there is no such object.
    #[must_use]
    pub fn in_body(&self, object: usize, triangle: u32) -> (usize, u32) {
        let body = self.bodies.body_of(object);
        let mesh = self.mesh(body);
        if mesh.sections.is_empty() {
            return (body, triangle);
        }
        let section = self.bodies.objects()[object].section;
        (body, mesh.range_of(section).triangles.start + triangle)
    }

    /// The object of a triangle of a body's mesh, and the triangle's number in the object.
    ///
    /// # Panics
    /// If there is no such body.
    #[must_use]
    pub fn in_object(&self, body: usize, triangle: u32) -> (usize, u32) {
        let (section, triangle) = self.mesh(body).section_of(triangle);
        (self.bodies.objects_of(body).start + section as usize, triangle)
    }

    /// The memory of the trees, in bytes, without the scene.
    #[must_use]
    pub fn memory(&self) -> usize {
        let baked = |placed: &PlacedTree| {
            placed
                .baked
                .as_ref()
                .map_or(0, |baked| baked.bvh.memory() + size_of_val(&baked.positions[..]))
        };
        self.trees.bvhs.iter().map(Bvh::memory).sum::<usize>()
            + self.placed.iter().map(baked).sum::<usize>()
    }

    /// The instruction set that runs.
    #[must_use]
    pub fn level(&self) -> Level {
        self.level
    }

    /// The mesh of a body.
    ///
    /// # Panics
    /// If there is no such body.
    #[must_use]
    pub fn mesh(&self, body: usize) -> &Mesh {
        &self.scene.meshes[self.bodies.object(body).mesh.index()]
    }

    /// Whether nothing shines through a body.
    pub(crate) fn is_opaque(&self, body: usize) -> bool {
        self.opaque_meshes[self.bodies.object(body).mesh.index()]
    }

    /// The tree of a body.
    ///
    /// # Panics
    /// If there is no such body.
    #[must_use]
    pub fn tree(&self, body: usize) -> BodyTree<'_> {
        let placed = self.placed.of_body(body);
        let (bvh, positions) = match &placed.baked {
            Some(baked) => (&baked.bvh, &baked.positions),
            None => {
                let mesh = self.bodies.object(body).mesh.index();
                (&self.trees.bvhs[mesh], &self.scene.meshes[mesh].positions)
            }
        };
        BodyTree {
            bvh,
            positions,
            world_from_tree: &placed.world_from_tree,
            tree_from_world: placed.tree_from_world.matrix(),
            of_mesh: placed.baked.is_none(),
        }
    }

    /// The sphere around the tree of a body; `None` for a tree over nothing.
    pub(crate) fn sphere(&self, body: usize) -> Option<Sphere> {
        let placed = self.placed.of_body(body);
        match &placed.baked {
            Some(baked) => baked.sphere,
            None => self.trees.spheres[self.bodies.object(body).mesh.index()],
        }
    }

    pub(crate) fn rays(&self, body: usize) -> MeshRays<'_> {
        let tree = self.tree(body);
        MeshRays::with_level(tree.bvh, tree.positions, self.level)
    }
}
