//! What a renderer has made ready of meshes, kept for another scene that has the same ones.

use super::{Renderer, Workers};
use crate::polygons::Polygons;
use luxel_math::Level;
use luxel_parallel::{Memo, ThreadPool};
use luxel_rays::MeshTrees;
use luxel_scene::{CoplanarRanks, Object, Scene};
use luxel_visibility::{Clusters, Frames};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// What a renderer has made ready of its scene's meshes, with its threads.
pub struct Prepared {
    /// Of each mesh: how many triangles it has, and what was made of them.
    meshes: Vec<(usize, Clusters, Memo<Box<Polygons>>)>,
    /// The objects, and their ranks, if a view has needed them.
    ranks: (Arc<Vec<Object>>, Memo<CoplanarRanks>),
    /// The trees of all meshes, if a view has needed them.
    trees: Option<MeshTrees>,
    max_memory: u64,
    level: Level,
    pool: Option<ThreadPool>,
    clock: fn() -> Duration,
}

impl Renderer {
    /// Gives every object a mesh of its own.
    pub(super) fn separate(&mut self) {
        Arc::make_mut(&mut self.scene).separate();
        let scene = &self.scene;
        self.polygons_of_meshes = scene.meshes.iter().map(|_| Memo::new()).collect();
        self.clusters = self.install(|| clusters(scene, Frames::Many));
    }

    /// Lets go of the scene, and keeps what was made of its meshes.
    #[must_use]
    pub fn into_prepared(mut self) -> Prepared {
        let trees = self.take_trees();
        let counts = self.scene.meshes.iter().map(|mesh| mesh.triangles.len());
        let made = self.clusters.into_iter().zip(self.polygons_of_meshes);
        Prepared {
            meshes: counts.zip(made).map(|(count, (a, b))| (count, a, b)).collect(),
            ranks: (self.objects, self.ranks),
            trees,
            max_memory: self.max_memory,
            level: self.level,
            pool: self.pool,
            clock: self.clock,
        }
    }

    /// Makes a scene ready that has the same meshes as another one, which costs nothing then: its
    /// materials, and which nodes show which mesh, may be others. Meshes with another number of
    /// triangles are made ready anew; those with as many, but other ones, would be drawn wrongly.
    #[must_use]
    pub fn again(scene: impl Into<Arc<Scene>>, prepared: Prepared) -> Self {
        let scene = scene.into();
        let Prepared { meshes, ranks, trees, max_memory, level, pool, clock } = prepared;
        let mut renderer = Self {
            objects: scene.objects().into(),
            ranks: Memo::new(),
            clusters: Vec::new(),
            polygons_of_meshes: Vec::new(),
            rays: Memo::new(),
            kept_trees: Mutex::new(trees),
            max_memory,
            bounds: Memo::new(),
            lowest: Memo::new(),
            level,
            pool,
            clock,
            workers: Workers::default(),
            scene,
        };
        let scene = &renderer.scene;
        let is_same = |(mesh, (count, ..)): (&luxel_scene::Mesh, &(usize, Clusters, _))| {
            mesh.triangles.len() == *count
        };
        if scene.meshes.len() == meshes.len() && scene.meshes.iter().zip(&meshes).all(is_same) {
            for (_, clusters, polygons) in meshes {
                renderer.clusters.push(clusters);
                renderer.polygons_of_meshes.push(polygons);
            }
            let (objects, ranks) = ranks;
            if objects == renderer.objects {
                renderer.ranks = ranks;
            }
        } else {
            renderer.polygons_of_meshes = scene.meshes.iter().map(|_| Memo::new()).collect();
            renderer.clusters = renderer.install(|| clusters(scene, Frames::Many));
        }
        renderer
    }
}

/// The clusters of each mesh, by all threads.
pub(super) fn clusters(scene: &Scene, frames: Frames) -> Vec<Clusters> {
    let meshes = &scene.meshes;
    luxel_parallel::map(meshes.len(), 1, &|run| Clusters::new(&meshes[run.start], frames))
}
