//! Many rays at once: those of neighbours share their way through a tree.

use crate::scene_rays::SceneRays;
use crate::world_ray::{RebasedRay, WorldHit, WorldRay, centre_and_radius};
use glam::DVec3;
use luxel_bvh::{Ray, RayHit};
use luxel_parallel::fill;

/// Rays per task.
const RUN: usize = 1024;

/// Up to so many objects are each asked for all rays of a run; among more, each ray finds its own.
///
/// A camera's rays through 1, 4, 8, 12 and 32 objects take 0.74, 0.69, 0.71, 1.10 and 1.82 of the time that they
/// take alone, scattered ones 0.91, 0.82, 0.92, 1.41 and 2.14 (`benches/batches.rs`, AVX-512).
const FEW: usize = 8;

impl SceneRays {
    /// [`SceneRays::closest`] of each of many rays, on all threads of the current pool. Consecutive rays that
    /// run close together, as those of a tile of pixels, share their tests.
    #[must_use]
    pub fn closest_of_each(&self, rays: &[WorldRay]) -> Vec<Option<WorldHit>> {
        let mut hits = vec![None; rays.len()];
        fill(&mut hits, RUN, &|start, hits| {
            let rays = &rays[start..start + hits.len()];
            if self.objects().len() > FEW {
                for (hit, ray) in hits.iter_mut().zip(rays) {
                    *hit = self.closest(ray);
                }
                return;
            }
            let mut run = Run::default();
            for object in 0..self.objects().len() {
                run.take(self, rays, object);
                run.hits.resize(run.rays.len(), None);
                self.rays(object).closest_of_few(&run.rays, &mut run.hits);
                // A loop of its own: corners are scattered in memory, and the processor waits for several at
                // once.
                run.corners.clear();
                let found = run.hits.iter().flatten();
                run.corners.extend(found.map(|hit| self.local_corners(object, hit.triangle)));
                let mut corners = run.corners.iter();
                for ((number, near), found) in run.near.iter().zip(&run.hits) {
                    let Some(found) = found else { continue };
                    let Some(corners) = corners.next() else { break };
                    let hit = &mut hits[*number];
                    let new = self.refined_on(*corners, &rays[*number], object, near, found);
                    // Of equally close ones the first object's stays.
                    if let Some(new) = new
                        && hit.is_none_or(|hit| new.t < hit.t)
                    {
                        *hit = Some(new);
                    }
                }
            }
        });
        hits
    }

    /// [`SceneRays::any`] of each of many rays, on all threads of the current pool. Consecutive rays that
    /// run close together, as those from one light to a tile of pixels, share their tests.
    #[must_use]
    pub fn any_of_each(&self, rays: &[WorldRay]) -> Vec<bool> {
        let mut hits = vec![false; rays.len()];
        fill(&mut hits, RUN, &|start, hits| {
            let rays = &rays[start..start + hits.len()];
            if self.objects().len() > FEW {
                for (hit, ray) in hits.iter_mut().zip(rays) {
                    *hit = self.any(ray);
                }
                return;
            }
            let mut run = Run::default();
            let mut found = Vec::new();
            for object in 0..self.objects().len() {
                run.take(self, rays, object);
                found.resize(run.rays.len(), false);
                self.rays(object).any_of_few(&run.rays, &mut found);
                for ((number, _), found) in run.near.iter().zip(&found) {
                    hits[*number] |= found;
                }
            }
        });
        hits
    }
}

/// The rays of a run that come near one object.
#[derive(Default)]
struct Run {
    /// In the coordinates of the object's tree.
    rays: Vec<Ray>,
    /// The place of each among all of the run, and how it was brought there.
    near: Vec<(usize, RebasedRay)>,
    hits: Vec<Option<RayHit>>,
    /// Of each hit's triangle, in its mesh's own space.
    corners: Vec<[DVec3; 3]>,
}

impl Run {
    fn take(&mut self, scene: &SceneRays, rays: &[WorldRay], object: usize) {
        self.rays.clear();
        self.near.clear();
        let tree = scene.tree(object);
        let Some(bounds) = tree.bvh.bounds() else { return };
        let sphere = centre_and_radius(bounds);
        for (number, ray) in rays.iter().enumerate().filter(|(_, ray)| ray.is_valid()) {
            let origin = tree.tree_from_world.transform_point3(ray.origin);
            let direction = tree.tree_from_world.transform_vector3(ray.direction);
            if let Some(near) = RebasedRay::near(origin, direction, ray.range, sphere) {
                self.rays.push(near.ray);
                self.near.push((number, near));
            }
        }
    }
}
