//! The trees of bodies, with their transforms.

use crate::world_ray::centre_and_radius;
use glam::{DMat3, DMat4, DVec3};
use luxel_bvh::{Bvh, Quality, TooManyForTree};
use luxel_parallel::{fill, map};
use luxel_scene::{Mesh, Object, Scene, SharedAxes, SharedMatrix};

/// The tree of a body, with its transforms.
pub(crate) struct PlacedTree {
    /// The object's own matrix, where the mesh's coordinates are about 0.
    pub(crate) world_from_tree: SharedMatrix,
    pub(crate) tree_from_world: SharedAxes,
    /// A tree in world coordinates, if the body's transform is singular or too anisotropic for rays to
    /// be transformed.
    pub(crate) baked: Option<Box<BakedTree>>,
}

pub(crate) struct BakedTree {
    pub(crate) bvh: Bvh,
    /// About `middle`, along the world's axes.
    pub(crate) positions: Vec<[f32; 3]>,
    middle: DVec3,
    pub(crate) sphere: Option<Sphere>,
}

/// The middle and the radius of a sphere around a tree; none around a tree over nothing.
pub(crate) type Sphere = (DVec3, f64);

pub(crate) fn sphere_around(bvh: &Bvh) -> Option<Sphere> {
    bvh.bounds().map(centre_and_radius)
}

/// A view of a body's tree.
#[derive(Clone, Copy, Debug)]
pub struct BodyTree<'p> {
    /// The tree.
    pub bvh: &'p Bvh,
    /// The positions of its triangles' corners.
    pub positions: &'p [[f32; 3]],
    /// From the tree's coordinates to the world's.
    pub world_from_tree: &'p SharedMatrix,
    /// From the world's coordinates to the tree's.
    pub tree_from_world: DMat4,
    /// Whether the tree's positions are the mesh's own.
    pub of_mesh: bool,
}

/// Stronger anisotropy, roughly the ratio of the longest axis to the shortest, costs transformed rays
/// their precision.
const MAX_STRETCH: f64 = 1e4;

/// Where an object's mesh is.
pub(crate) struct Placement {
    world_from_tree: SharedMatrix,
    tree_from_world: DMat4,
}

impl Placement {
    pub(crate) fn of(mesh: &Mesh, object: &Object) -> Self {
        let own = &object.world_from_mesh;
        let world_from_tree = own.matrix() * DMat4::from_translation(mesh.origin);
        let tree_from_world = world_from_tree.inverse();
        let world_from_tree = SharedMatrix::sharing(&world_from_tree, own);
        Self { world_from_tree, tree_from_world }
    }

    /// Whether it keeps no matrix of its own, but the object's.
    pub(crate) fn shares_matrix_of(&self, object: &Object) -> bool {
        self.world_from_tree.is_copy_of(&object.world_from_mesh)
    }

    /// Whether the object needs a tree in world coordinates.
    pub(crate) fn is_baked(&self) -> bool {
        let Self { world_from_tree, tree_from_world } = self;
        let is_even = || stretch(&world_from_tree.matrix(), tree_from_world) < MAX_STRETCH;
        !(tree_from_world.is_finite() && is_even())
    }
}

/// The trees of bodies. Bodies that follow one another with one mesh in one place share theirs.
pub(crate) struct PlacedTrees {
    trees: Vec<PlacedTree>,
    /// The place of each body's among them.
    of_bodies: Vec<u32>,
}

impl PlacedTrees {
    /// The trees of the objects, which stand for bodies, built on all threads of the current pool.
    pub(crate) fn new<'o>(
        scene: &Scene,
        bodies: impl ExactSizeIterator<Item = &'o Object>,
        quality: Quality,
    ) -> Result<Self, TooManyForTree> {
        // A list that grows leaves the memory of its shorter lengths behind.
        let mut trees = Vec::with_capacity(bodies.len());
        let mut of_bodies = Vec::with_capacity(bodies.len());
        let mut last: Option<&Object> = None;
        // The places of those that need a tree in world coordinates, and their meshes.
        let mut baked: Vec<(usize, &Mesh)> = Vec::new();
        for object in bodies {
            if !last.is_some_and(|last| object.repeats(last)) {
                let mesh = &scene.meshes[object.mesh.index()];
                let placement = Placement::of(mesh, object);
                if placement.is_baked() {
                    baked.push((trees.len(), mesh));
                }
                let tree = PlacedTree::new(placement, trees.last());
                trees.push(tree);
            }
            last = Some(object);
            of_bodies.push(trees.len() as u32 - 1);
        }
        trees.shrink_to_fit();
        let built = map(baked.len(), 1, &|run| {
            let (place, mesh) = baked[run.start];
            Some(BakedTree::new(mesh, &trees[place].world_from_tree.matrix(), quality))
        });
        for ((place, _), built) in baked.into_iter().zip(all(built)?) {
            trees[place].bake(built);
        }
        Ok(Self { trees, of_bodies })
    }

    /// The tree of a body.
    pub(crate) fn of_body(&self, body: usize) -> &PlacedTree {
        &self.trees[self.of_bodies[body] as usize]
    }

    /// All trees, each once.
    pub(crate) fn iter(&self) -> std::slice::Iter<'_, PlacedTree> {
        self.trees.iter()
    }
}

/// All trees that threads have built. Collected by `Result`, a list doesn't know how long it becomes, and takes up to
/// twice the memory.
pub(crate) fn all<T>(
    built: Vec<Option<Result<T, TooManyForTree>>>,
) -> Result<Vec<T>, TooManyForTree> {
    let mut trees = Vec::with_capacity(built.len());
    for tree in built.into_iter().flatten() {
        trees.push(tree?);
    }
    Ok(trees)
}

impl PlacedTree {
    /// With the mesh's own tree, and the axes of the body before it where they are the same.
    fn new(placement: Placement, before: Option<&Self>) -> Self {
        let Placement { world_from_tree, tree_from_world } = placement;
        let tree_from_world = SharedAxes::new(&tree_from_world);
        let tree_from_world = match before {
            Some(before) => tree_from_world.sharing(&before.tree_from_world),
            None => tree_from_world,
        };
        Self { world_from_tree, tree_from_world, baked: None }
    }

    /// Takes a tree in world coordinates instead.
    fn bake(&mut self, tree: BakedTree) {
        self.world_from_tree = DMat4::from_translation(tree.middle).into();
        self.tree_from_world = SharedAxes::new(&DMat4::from_translation(-tree.middle));
        self.baked = Some(Box::new(tree));
    }
}

impl BakedTree {
    fn new(mesh: &Mesh, world_from_tree: &DMat4, quality: Quality) -> Result<Self, TooManyForTree> {
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
        let sphere = sphere_around(&bvh);
        Ok(Self { bvh, positions, middle, sphere })
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

impl BodyTree<'_> {
    /// The world-space bounds of the tree's box.
    pub(crate) fn world_box(&self) -> [DVec3; 2] {
        let Some([low, high]) = self.bvh.bounds() else {
            return [DVec3::INFINITY, DVec3::NEG_INFINITY];
        };
        let mut bounds = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let world_from_tree = self.world_from_tree.matrix();
        for corner in 0..8 {
            let at =
                |axis: usize| f64::from(if corner >> axis & 1 == 0 { low } else { high }[axis]);
            let place = world_from_tree.transform_point3(DVec3::new(at(0), at(1), at(2)));
            bounds = [bounds[0].min(place), bounds[1].max(place)];
        }
        bounds
    }
}
