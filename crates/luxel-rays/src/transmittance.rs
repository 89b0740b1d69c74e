//! How much light comes along a ray.

use crate::scene_rays::SceneRays;
use crate::world_ray::WorldRay;
use luxel_bvh::{Ray, RayHit};
use std::cell::RefCell;

thread_local! {
    static FEW: RefCell<Few> = RefCell::new(Few::default());
}

/// What [`SceneRays::transmittance_of_few`] keeps from call to call.
#[derive(Default)]
struct Few {
    /// The rays near one object, and their numbers.
    near: Vec<Ray>,
    numbers: Vec<usize>,
    hits: Vec<bool>,
}

/// A surface in the way of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocker {
    /// The object, by its index in [`SceneRays::objects`].
    pub object: usize,
    /// The triangle's index in the object's mesh.
    pub triangle: u32,
    /// The distance along the ray, in units of the direction's length.
    pub t: f64,
    /// How much of the light it keeps: 1 if it is opaque, more than 0 in any case.
    pub alpha: f32,
}

impl SceneRays {
    /// T: the part of light that comes along a ray. An opaque surface keeps all of it, a hole nothing, a
    /// blended one its alpha there: T = the product of 1 - alpha, nearest first.
    ///
    /// 1 for invalid rays, which meet nothing.
    #[must_use]
    pub fn transmittance(&self, ray: &WorldRay) -> f32 {
        let mut is_blocked = false;
        let mut weakening = Vec::new();
        self.each_object(ray, |object, farthest| {
            let Some(near) = self.rebased_ray(ray, object).filter(|_| !is_blocked) else {
                return farthest;
            };
            if self.is_opaque(object) {
                is_blocked = self.rays(object).any(&near.ray);
            } else {
                let before = weakening.len();
                let hits = self.rays(object).all(&near.ray);
                weakening.extend(hits.iter().filter_map(|hit| {
                    self.blocker(object, near.start + near.scale * f64::from(hit.t), hit)
                }));
                is_blocked = weakening[before..].iter().any(|blocker| blocker.alpha >= 1.0);
            }
            if is_blocked { f64::NEG_INFINITY } else { farthest }
        });
        if is_blocked {
            return 0.0;
        }
        sort(&mut weakening);
        weakening.iter().fold(1.0, |through, blocker| through * (1.0 - blocker.alpha))
    }

    /// [`SceneRays::transmittance`] of each of a few rays that run close together, on this thread.
    ///
    /// # Panics
    /// If `through` isn't as long as `rays`.
    pub fn transmittance_of_few(&self, rays: &[WorldRay], through: &mut [f32]) {
        assert_eq!(rays.len(), through.len(), "each ray has an answer");
        through.fill(1.0);
        FEW.with_borrow_mut(|Few { near, numbers, hits }| {
            self.each_object_near(rays, |object| {
                near.clear();
                numbers.clear();
                for (number, ray) in rays.iter().enumerate() {
                    if through[number] > 0.0
                        && let Some(rebased) = self.rebased_ray(ray, object)
                    {
                        near.push(rebased.ray);
                        numbers.push(number);
                    }
                }
                if self.is_opaque(object) {
                    hits.resize(near.len(), false);
                    self.rays(object).any_of_few(near, hits);
                    for (&number, is_hit) in numbers.iter().zip(&*hits) {
                        if *is_hit {
                            through[number] = 0.0;
                        }
                    }
                } else {
                    for &number in &*numbers {
                        through[number] = self.transmittance(&rays[number]);
                    }
                }
            });
        });
    }

    /// The surfaces in the way of a ray, nearest first: those that make [`SceneRays::transmittance`] less
    /// than 1, and those behind an opaque one.
    #[must_use]
    pub fn blockers(&self, ray: &WorldRay) -> Vec<Blocker> {
        let mut blockers = Vec::new();
        self.each_object(ray, |object, farthest| {
            if let Some(near) = self.rebased_ray(ray, object) {
                let hits = self.rays(object).all(&near.ray);
                blockers.extend(hits.iter().filter_map(|hit| {
                    self.blocker(object, near.start + near.scale * f64::from(hit.t), hit)
                }));
            }
            farthest
        });
        sort(&mut blockers);
        blockers
    }

    /// What a hit triangle keeps of the light; `None` where it has a hole.
    fn blocker(&self, object: usize, t: f64, hit: &RayHit) -> Option<Blocker> {
        let RayHit { triangle, barycentric, .. } = *hit;
        let mesh = self.mesh(object);
        let part = mesh.parts.partition_point(|part| part.first <= triangle).saturating_sub(1);
        let alpha = mesh.parts.get(part).map_or(1.0, |part| {
            let scene = self.scene();
            scene.opacity(mesh, triangle, barycentric, &scene.materials[part.material.index()])
        });
        (alpha > 0.0).then_some(Blocker { object, triangle, t, alpha })
    }
}

/// Nearest first; of equally near ones the first object's lowest triangle.
fn sort(blockers: &mut [Blocker]) {
    blockers.sort_by(|a, b| {
        a.t.total_cmp(&b.t).then((a.object, a.triangle).cmp(&(b.object, b.triangle)))
    });
}
