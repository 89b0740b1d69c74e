//! Batches of rays: coherent neighbours are traversed together.

use crate::scene_rays::SceneRays;
use crate::world_ray::{RebasedRay, WorldHit, WorldRay, centre_and_radius};
use luxel_bvh::Ray;
use luxel_parallel::fill;

/// Rays per task.
const RUN: usize = 1024;

/// With up to this many bodies, all rays of a run are traced against each body; with more, each ray is traced
/// alone.
///
/// A camera's rays through 1, 4, 8, 12 and 32 objects take 0.74, 0.69, 0.71, 1.10 and 1.82 times as long in runs as
/// alone, scattered rays 0.91, 0.82, 0.92, 1.41 and 2.14 times (`benches/batches.rs`, AVX-512).
const FEW: usize = 8;

impl SceneRays {
    /// [`SceneRays::closest`] for each of many rays, on all threads of the current pool. Consecutive rays that
    /// run close together, as those of a tile of pixels, share their tests.
    #[must_use]
    pub fn closest_of_each(&self, rays: &[WorldRay]) -> Vec<Option<WorldHit>> {
        self.in_runs(
            rays,
            |ray| self.closest(ray),
            |body, rays, run, hits| {
                let mut found = vec![None; run.rays.len()];
                self.rays(body).closest_of_few(&run.rays, &mut found);
                // A separate loop overlaps the cache misses of the scattered corners.
                let triangles = found.iter().flatten().map(|hit| hit.triangle);
                let corners: Vec<_> =
                    triangles.map(|triangle| self.local_corners(body, triangle)).collect();
                let found = run.near.iter().zip(&found);
                let found = found.filter_map(|(near, hit)| Some((near, hit.as_ref()?)));
                for (((number, near), found), corners) in found.zip(corners) {
                    let hit = &mut hits[*number];
                    // Ties keep the first body's hit.
                    if let Some(new) = self.refined_on(corners, &rays[*number], body, near, found)
                        && hit.is_none_or(|hit| new.t < hit.t)
                    {
                        *hit = Some(new);
                    }
                }
            },
        )
    }

    /// [`SceneRays::any`] for each of many rays, on all threads of the current pool. Consecutive rays that
    /// run close together, as those from one light to a tile of pixels, share their tests.
    #[must_use]
    pub fn any_of_each(&self, rays: &[WorldRay]) -> Vec<bool> {
        self.in_runs(
            rays,
            |ray| self.any(ray),
            |body, _, run, hits| {
                let mut found = vec![false; run.rays.len()];
                self.rays(body).any_of_few(&run.rays, &mut found);
                for ((number, _), found) in run.near.iter().zip(found) {
                    hits[*number] |= found;
                }
            },
        )
    }

    /// The answer for each ray. Among many bodies `alone` computes it; otherwise `against` updates the answers of a
    /// run for one body after the other.
    fn in_runs<T: Clone + Default + Send>(
        &self,
        rays: &[WorldRay],
        alone: impl Fn(&WorldRay) -> T + Sync,
        against: impl Fn(usize, &[WorldRay], &Run, &mut [T]) + Sync,
    ) -> Vec<T> {
        let mut answers = vec![T::default(); rays.len()];
        fill(&mut answers, RUN, &|start, answers| {
            let rays = &rays[start..start + answers.len()];
            if self.bodies() > FEW {
                for (answer, ray) in answers.iter_mut().zip(rays) {
                    *answer = alone(ray);
                }
                return;
            }
            let mut run = Run::default();
            for body in 0..self.bodies() {
                run.collect(self, rays, body);
                against(body, rays, &run, answers);
            }
        });
        answers
    }
}

/// The rays of a run that come near one body.
#[derive(Default)]
struct Run {
    /// In the coordinates of the body's tree.
    rays: Vec<Ray>,
    /// The index of each ray within the run, and the ray with its mapping back to world space.
    near: Vec<(usize, RebasedRay)>,
}

impl Run {
    /// Replaces the contents by the rays near a body.
    fn collect(&mut self, scene: &SceneRays, rays: &[WorldRay], body: usize) {
        self.rays.clear();
        self.near.clear();
        let tree = scene.tree(body);
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
