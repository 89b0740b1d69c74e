//! World-space rays through two levels: a tree over the objects' boxes, and the trees of their meshes.
//!
//! World space is `f64`, trees are `f32`. Each ray is moved close to a box and traced there in `f32`; the
//! hit is then refined in `f64` on the triangle's plane.

use crate::picker::Picker;
use glam::DVec3;
use luxel_bvh::{Ray, RayHit};
use luxel_parallel::fill;

/// A world-space ray: all points `origin + t * direction` with t within `range`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldRay {
    /// The point at t = 0.
    pub origin: DVec3,
    /// The direction, of any length but 0; t counts in units of this length.
    pub direction: DVec3,
    /// The smallest t, not below 0, and the largest, which may be infinite.
    pub range: [f64; 2],
}

/// Where a ray hits a triangle of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldHit {
    /// The distance along the ray, in units of the direction's length.
    pub t: f64,
    /// The object, by its index in [`Picker::objects`].
    pub object: usize,
    /// The triangle's index in the object's mesh.
    pub triangle: u32,
    /// Barycentric coordinates: the weights of the triangle's corners.
    pub barycentric: [f64; 3],
    /// The position in world space.
    pub position: DVec3,
}

impl WorldRay {
    /// An infinite ray.
    #[must_use]
    pub const fn new(origin: DVec3, direction: DVec3) -> Self {
        Self { origin, direction, range: [0.0, f64::INFINITY] }
    }

    fn is_valid(&self) -> bool {
        self.origin.is_finite()
            && self.direction.is_finite()
            && self.direction != DVec3::ZERO
            && self.range[0] >= 0.0
            && self.range[1] >= self.range[0]
    }
}

/// A ray in `f32`: its origin moved close to a box, and the mapping of its t to world space.
pub(crate) struct RebasedRay {
    pub(crate) ray: Ray,
    /// t of the world = `start + scale * t`.
    pub(crate) start: f64,
    pub(crate) scale: f64,
}

impl RebasedRay {
    /// From a ray in a box's own coordinates; `None` if it misses the box's bounding sphere.
    pub(crate) fn new(
        origin: DVec3,
        direction: DVec3,
        range: [f64; 2],
        [low, high]: [[f32; 3]; 2],
    ) -> Option<Self> {
        let corner =
            |corner: [f32; 3]| DVec3::new(corner[0].into(), corner[1].into(), corner[2].into());
        let (low, high) = (corner(low), corner(high));
        let centre = low * 0.5 + high * 0.5;
        let radius = (high - low).length() * 0.500_001 + centre.length() * 1e-6 + f64::MIN_POSITIVE;
        let length = direction.length();
        let unit = direction / length;
        let along = (centre - origin).dot(unit);
        let aside = (origin + unit * along - centre).length_squared();
        // Twice the radius: squares of large distances round.
        let is_near = aside <= 4.0 * radius * radius;
        let enter = (along - 2.0 * radius).max(range[0] * length);
        let leave = (along + 2.0 * radius).min(range[1] * length);
        let hits = is_near && enter <= leave;
        if !hits {
            return None;
        }
        let start = origin + unit * enter;
        let ray = Ray {
            origin: start.as_vec3().to_array(),
            direction: unit.as_vec3().to_array(),
            range: [0.0, ((leave - enter) as f32).next_up()],
        };
        Some(Self { ray, start: enter / length, scale: 1.0 / length })
    }
}

impl Picker {
    /// The closest hit of a ray, on either side of triangles; of equally close ones that of the first
    /// object's lowest triangle. `None` also for invalid rays.
    ///
    /// ```
    /// use luxel_pick::{Picker, WorldRay};
    /// use luxel_scene::{demos, DVec3};
    ///
    /// let scene = demos::demo("teapot").unwrap();
    /// let picker = Picker::new(scene)?;
    /// let ray = WorldRay::new(DVec3::new(0.0, 1.0, 50.0), DVec3::NEG_Z);
    /// let hit = picker.closest(&ray).unwrap();
    /// assert!(hit.position.z > 0.0);
    /// # Ok::<(), luxel_pick::PickError>(())
    /// ```
    #[must_use]
    pub fn closest(&self, ray: &WorldRay) -> Option<WorldHit> {
        let mut best: Option<WorldHit> = None;
        self.each_object(ray, |object, farthest| {
            let hit = self.ray_to_object(ray, object, |near| self.rays(object).closest(&near.ray));
            if let Some(hit) = hit
                && best.is_none_or(|best| (hit.t, hit.object) < (best.t, best.object))
            {
                best = Some(hit);
                return hit.t;
            }
            farthest
        });
        best
    }

    /// Whether a ray hits anything within its range; ends at the first hit found.
    #[must_use]
    pub fn any(&self, ray: &WorldRay) -> bool {
        let mut any = false;
        self.each_object(ray, |object, farthest| {
            any = any
                || self
                    .rebased_ray(ray, object)
                    .is_some_and(|near| self.rays(object).any(&near.ray));
            if any { f64::NEG_INFINITY } else { farthest }
        });
        any
    }

    /// All hits of a ray, nearest first.
    #[must_use]
    pub fn all(&self, ray: &WorldRay) -> Vec<WorldHit> {
        let mut hits = Vec::new();
        self.each_object(ray, |object, farthest| {
            if let Some(near) = self.rebased_ray(ray, object) {
                let own = self.rays(object).all(&near.ray);
                hits.extend(own.iter().filter_map(|hit| self.refined(ray, object, &near, hit)));
            }
            farthest
        });
        hits.sort_by(|a, b| {
            a.t.total_cmp(&b.t).then((a.object, a.triangle).cmp(&(b.object, b.triangle)))
        });
        hits
    }

    /// The closest hit of each of many rays, on all threads of the current pool.
    #[must_use]
    pub fn closest_of_each(&self, rays: &[WorldRay]) -> Vec<Option<WorldHit>> {
        let mut hits = vec![None; rays.len()];
        fill(&mut hits, 256, &|start, hits| {
            for (hit, ray) in hits.iter_mut().zip(&rays[start..]) {
                *hit = self.closest(ray);
            }
        });
        hits
    }

    /// Visits the objects whose boxes a ray hits, near ones first; `visit` returns the farthest t that
    /// still counts.
    fn each_object(&self, ray: &WorldRay, mut visit: impl FnMut(usize, f64) -> f64) {
        let Some(bounds) = self.top.bounds().filter(|_| ray.is_valid()) else { return };
        let origin = ray.origin - self.middle;
        let Some(near) = RebasedRay::new(origin, ray.direction, ray.range, bounds) else { return };
        // Slightly beyond `farthest`: distances in f32 and f64 differ by rounding.
        let within = |t: f64| ((t - near.start) / near.scale * (1.0 + 1e-5)) as f32;
        let mut farthest = ray.range[1];
        self.top.visit_along(self.level, &near.ray, |object| {
            farthest = visit(object as usize, farthest);
            within(farthest).next_up()
        });
    }

    /// A ray in the coordinates of an object's tree.
    fn rebased_ray(&self, ray: &WorldRay, object: usize) -> Option<RebasedRay> {
        let tree = self.tree(object);
        let origin = tree.tree_from_world.transform_point3(ray.origin);
        let direction = tree.tree_from_world.transform_vector3(ray.direction);
        RebasedRay::new(origin, direction, ray.range, tree.bvh.bounds()?)
    }

    fn ray_to_object(
        &self,
        ray: &WorldRay,
        object: usize,
        trace: impl Fn(&RebasedRay) -> Option<RayHit>,
    ) -> Option<WorldHit> {
        let near = self.rebased_ray(ray, object)?;
        self.refined(ray, object, &near, &trace(&near)?)
    }

    /// Refines a hit in `f64`, on the triangle's plane. A triangle seen edge-on keeps the result of
    /// `f32`.
    fn refined(
        &self,
        ray: &WorldRay,
        object: usize,
        near: &RebasedRay,
        hit: &RayHit,
    ) -> Option<WorldHit> {
        let mesh = self.mesh(object);
        let world_from_mesh = &self.objects[object].world_from_mesh;
        let [a, b, c] = mesh.triangles[hit.triangle as usize]
            .map(|vertex| world_from_mesh.transform_point3(mesh.position(vertex)));
        let rough = near.start + near.scale * f64::from(hit.t);
        let (ab, ac) = (b - a, c - a);
        let p = ray.direction.cross(ac);
        let determinant = ab.dot(p);
        let to_origin = ray.origin - a;
        let q = to_origin.cross(ab);
        let (v, w) = (to_origin.dot(p) / determinant, ray.direction.dot(q) / determinant);
        let exact = ac.dot(q) / determinant;
        let slack = 1e-3;
        let inside = v >= -slack && w >= -slack && v + w <= 1.0 + slack;
        let (t, barycentric) = if inside && exact.is_finite() {
            // Rounding in f32 may have accepted a point just outside.
            let (v, w) = (v.clamp(0.0, 1.0), w.clamp(0.0, 1.0));
            let sum = (v + w).max(1.0);
            let (v, w) = (v / sum, w / sum);
            (exact, [1.0 - v - w, v, w])
        } else {
            (rough, hit.barycentric.map(f64::from))
        };
        let [u, v, w] = barycentric;
        let position = a * u + b * v + c * w;
        (ray.range[0] <= t && t <= ray.range[1]).then_some(WorldHit {
            t,
            object,
            triangle: hit.triangle,
            barycentric,
            position,
        })
    }
}
