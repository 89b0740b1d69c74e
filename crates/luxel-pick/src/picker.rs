//! A scene prepared for picking: a tree per mesh, and one over all objects.

use glam::{DMat3, DMat4, DVec3};
use luxel_bvh::{BoxTree, Bvh, MeshRays, Quality, TooManyForTree};
use luxel_math::{Level, SimdLevel, UnavailableSimdLevel};
use luxel_parallel::{fill, map};
use luxel_scene::{Mesh, Object, Scene};
use std::sync::Arc;

/// Why a scene can't be prepared.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PickError {
    /// A mesh has too many triangles.
    #[error(transparent)]
    TooManyTriangles(#[from] TooManyForTree),
    /// The machine lacks the instruction set.
    #[error("{0}")]
    Simd(String),
}

impl From<UnavailableSimdLevel> for PickError {
    fn from(error: UnavailableSimdLevel) -> Self {
        Self::Simd(error.to_string())
    }
}

/// A scene prepared for queries: world-space rays, and, through a [`PickView`](crate::PickView), what a
/// camera sees. It shares the scene: a program can keep both.
pub struct Picker {
    pub(crate) scene: Arc<Scene>,
    pub(crate) objects: Vec<Object>,
    pub(crate) level: Level,
    bvhs: Vec<Bvh>,
    placed: Vec<PlacedTree>,
    /// The tree over the objects' boxes, relative to `middle`.
    pub(crate) top: BoxTree,
    pub(crate) middle: DVec3,
}

/// The tree of an object, with its transforms.
struct PlacedTree {
    mesh: usize,
    world_from_tree: DMat4,
    tree_from_world: DMat4,
    /// A tree in world coordinates, if the object's transform is singular or too anisotropic for rays to
    /// be transformed.
    baked: Option<Box<BakedTree>>,
}

struct BakedTree {
    bvh: Bvh,
    positions: Vec<[f32; 3]>,
}

/// A view of an object's tree.
#[derive(Clone, Copy)]
pub(crate) struct ObjectTree<'p> {
    pub(crate) bvh: &'p Bvh,
    pub(crate) positions: &'p [[f32; 3]],
    pub(crate) world_from_tree: &'p DMat4,
    pub(crate) tree_from_world: &'p DMat4,
    /// Whether the tree's positions are the mesh's own.
    pub(crate) of_mesh: bool,
}

/// Stronger anisotropy, roughly the ratio of the longest axis to the shortest, costs transformed rays
/// their precision.
const MAX_STRETCH: f64 = 1e4;

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

impl Picker {
    /// Builds the trees on all threads of the current pool, for the best instruction set of the machine.
    ///
    /// # Errors
    /// [`PickError`] if a mesh has too many triangles.
    pub fn new(scene: impl Into<Arc<Scene>>) -> Result<Self, PickError> {
        Self::with(scene, Quality::Thorough, SimdLevel::Auto)
    }

    /// Builds the trees with a given quality and instruction set.
    ///
    /// # Errors
    /// [`PickError`] if a mesh has too many triangles or the machine lacks the instructions.
    pub fn with(
        scene: impl Into<Arc<Scene>>,
        quality: Quality,
        simd: SimdLevel,
    ) -> Result<Self, PickError> {
        Self::build(scene.into(), quality, simd.resolve()?)
    }

    fn build(mut scene: Arc<Scene>, quality: Quality, level: Level) -> Result<Self, PickError> {
        if scene.has_sections() {
            Arc::make_mut(&mut scene).separate();
        }
        let bvhs = map(scene.meshes.len(), 1, &|run| {
            let mesh = &scene.meshes[run.start];
            Some(Bvh::build(&mesh.positions, &mesh.triangles, quality))
        });
        let bvhs = bvhs.into_iter().flatten().collect::<Result<Vec<_>, _>>()?;
        let objects = scene.objects();
        let placed = map(objects.len(), 1, &|run| {
            Some(PlacedTree::new(&scene, &objects[run.start], quality))
        });
        let placed = placed.into_iter().flatten().collect::<Result<Vec<_>, _>>()?;
        let mut picker = Self {
            scene,
            objects,
            level,
            bvhs,
            placed,
            top: BoxTree::default(),
            middle: DVec3::ZERO,
        };
        let boxes: Vec<[DVec3; 2]> =
            (0..picker.objects.len()).map(|object| picker.tree(object).world_box()).collect();
        let all = boxes
            .iter()
            .filter(|bounds| is_valid(bounds))
            .fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], bounds| {
                [low.min(bounds[0]), high.max(bounds[1])]
            });
        picker.middle = if is_valid(&all) { all[0] * 0.5 + all[1] * 0.5 } else { DVec3::ZERO };
        let middle = picker.middle;
        let boxes: Vec<_> = boxes
            .into_iter()
            .map(|bounds| is_valid(&bounds).then(|| rounded(bounds, middle)))
            .collect();
        picker.top = BoxTree::build(&boxes, Quality::Fast)?;
        Ok(picker)
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// The objects; hits give their indices.
    #[must_use]
    pub fn objects(&self) -> &[Object] {
        &self.objects
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
        self.bvhs.iter().map(Bvh::memory).sum::<usize>()
            + self.placed.iter().map(baked).sum::<usize>()
    }

    pub(crate) fn mesh(&self, object: usize) -> &Mesh {
        &self.scene.meshes[self.objects[object].mesh.index()]
    }

    pub(crate) fn tree(&self, object: usize) -> ObjectTree<'_> {
        let placed = &self.placed[object];
        let (bvh, positions) = match &placed.baked {
            Some(baked) => (&baked.bvh, &baked.positions),
            None => (&self.bvhs[placed.mesh], &self.scene.meshes[placed.mesh].positions),
        };
        ObjectTree {
            bvh,
            positions,
            world_from_tree: &placed.world_from_tree,
            tree_from_world: &placed.tree_from_world,
            of_mesh: placed.baked.is_none(),
        }
    }

    pub(crate) fn rays(&self, object: usize) -> MeshRays<'_> {
        let tree = self.tree(object);
        MeshRays::with_level(tree.bvh, tree.positions, self.level)
    }
}

impl PlacedTree {
    fn new(scene: &Scene, object: &Object, quality: Quality) -> Result<Self, TooManyForTree> {
        let mesh = &scene.meshes[object.mesh.index()];
        let world_from_tree = *object.world_from_mesh * DMat4::from_translation(mesh.origin);
        let tree_from_world = world_from_tree.inverse();
        let of = |world_from_tree, tree_from_world, baked| Self {
            mesh: object.mesh.index(),
            world_from_tree,
            tree_from_world,
            baked,
        };
        if tree_from_world.is_finite() && stretch(&world_from_tree, &tree_from_world) < MAX_STRETCH
        {
            return Ok(of(world_from_tree, tree_from_world, None));
        }
        let middle = world_from_tree.w_axis.truncate();
        let middle = if middle.is_finite() { middle } else { DVec3::ZERO };
        let mut positions = vec![[0.0; 3]; mesh.positions.len()];
        fill(&mut positions, 1 << 12, &|start, run| {
            for (place, &[x, y, z]) in run.iter_mut().zip(&mesh.positions[start..]) {
                let position = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
                let position = world_from_tree.transform_point3(position);
                *place = (position - middle).as_vec3().to_array();
            }
        });
        let bvh = Bvh::build(&positions, &mesh.triangles, quality)?;
        let shift = DMat4::from_translation(middle);
        let back = DMat4::from_translation(-middle);
        Ok(of(shift, back, Some(Box::new(BakedTree { bvh, positions }))))
    }
}

/// An upper bound of a transform's anisotropy: the product of its norm and its inverse's, over 3, the
/// value of a uniformly scaled rotation.
fn stretch(matrix: &DMat4, inverse: &DMat4) -> f64 {
    let norm = |matrix: &DMat4| {
        let DMat3 { x_axis, y_axis, z_axis } = DMat3::from_mat4(*matrix);
        (x_axis.length_squared() + y_axis.length_squared() + z_axis.length_squared()).sqrt()
    };
    norm(matrix) * norm(inverse) / 3.0
}

impl ObjectTree<'_> {
    /// The world-space bounds of the tree's box.
    fn world_box(&self) -> [DVec3; 2] {
        let Some([low, high]) = self.bvh.bounds() else {
            return [DVec3::INFINITY, DVec3::NEG_INFINITY];
        };
        let mut bounds = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        for corner in 0..8 {
            let at =
                |axis: usize| f64::from(if corner >> axis & 1 == 0 { low } else { high }[axis]);
            let place = self.world_from_tree.transform_point3(DVec3::new(at(0), at(1), at(2)));
            bounds = [bounds[0].min(place), bounds[1].max(place)];
        }
        bounds
    }
}
