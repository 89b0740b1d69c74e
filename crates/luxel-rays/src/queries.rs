//! World-space rays through two levels: a tree over the bodies' boxes, and the trees of their meshes.
//!
//! World space is `f64`, trees are `f32`. Each ray is moved close to a box and traced there in `f32`; the
//! hit is then refined in `f64` on the triangle's plane.

use crate::ray_lanes::RayLanes;
use crate::scene_rays::SceneRays;
use crate::world_ray::{RebasedRay, WorldHit, WorldRay};
use glam::DVec3;
use luxel_bvh::{RayHit, SlabTest};
use luxel_math::lanes_of;

impl SceneRays {
    /// The closest hit of a ray, on either side of triangles; of equally close ones that of the first
    /// object's lowest triangle. `None` also for invalid rays.
    ///
    /// ```
    /// use luxel_rays::{SceneRays, WorldRay};
    /// use luxel_scene::{demos, DVec3};
    ///
    /// let rays = SceneRays::new(demos::demo("teapot").unwrap())?;
    /// let ray = WorldRay::new(DVec3::new(0.0, 1.0, 50.0), DVec3::NEG_Z);
    /// let hit = rays.closest(&ray).unwrap();
    /// assert!(hit.position.z > 0.0);
    /// # Ok::<(), luxel_rays::RaysError>(())
    /// ```
    #[must_use]
    pub fn closest(&self, ray: &WorldRay) -> Option<WorldHit> {
        let mut best: Option<WorldHit> = None;
        self.each_body(ray, |body, farthest| {
            let hit = self.ray_to_body(ray, body, |near| self.rays(body).closest(&near.ray));
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
        self.each_body(ray, |body, farthest| {
            any = any
                || self.rebased_ray(ray, body).is_some_and(|near| self.rays(body).any(&near.ray));
            if any { f64::NEG_INFINITY } else { farthest }
        });
        any
    }

    /// All hits of a ray, nearest first.
    #[must_use]
    pub fn all(&self, ray: &WorldRay) -> Vec<WorldHit> {
        let mut hits = Vec::new();
        self.each_body(ray, |body, farthest| {
            if let Some(near) = self.rebased_ray(ray, body) {
                let own = self.rays(body).all(&near.ray);
                hits.extend(own.iter().filter_map(|hit| self.refined(ray, body, &near, hit)));
            }
            farthest
        });
        hits.sort_by(|a, b| {
            a.t.total_cmp(&b.t).then((a.object, a.triangle).cmp(&(b.object, b.triangle)))
        });
        hits
    }

    /// Visits the bodies whose boxes a ray hits, near ones first; `visit` returns the farthest t that
    /// still counts.
    pub(crate) fn each_body(&self, ray: &WorldRay, mut visit: impl FnMut(usize, f64) -> f64) {
        let Some(bounds) = self.top.bounds().filter(|_| ray.is_valid()) else { return };
        if self.bodies() == 1 {
            // The body's own tree tests the same box.
            visit(0, ray.range[1]);
            return;
        }
        let origin = ray.origin - self.middle;
        let Some(near) = RebasedRay::new(origin, ray.direction, ray.range, bounds) else { return };
        // Slightly beyond `farthest`: distances in f32 and f64 differ by rounding.
        let within = |t: f64| ((t - near.start) / near.scale * (1.0 + 1e-5)) as f32;
        let mut farthest = ray.range[1];
        self.top.visit_along(self.level, &near.ray, |body| {
            farthest = visit(body as usize, farthest);
            within(farthest).next_up()
        });
    }

    /// Visits the bodies whose boxes any of some rays may hit: all of those that a line hits which is as
    /// thick as the rays spread. Returns whether they share a way; otherwise it visits none.
    pub(crate) fn each_body_near(
        &self,
        rays: impl Iterator<Item = WorldRay>,
        mut visit: impl FnMut(usize),
    ) -> bool {
        let Some(bounds) = self.top.bounds() else { return true };
        if self.bodies() == 1 {
            visit(0);
            return true;
        }
        let mut valid = rays.filter(WorldRay::is_valid);
        let Some(first) = valid.next() else { return true };
        let [mut origins, mut directions] = [[first.origin; 2], [first.direction; 2]];
        let mut range = first.range;
        let mut shortest = first.direction.length();
        for ray in valid {
            origins = [origins[0].min(ray.origin), origins[1].max(ray.origin)];
            directions = [directions[0].min(ray.direction), directions[1].max(ray.direction)];
            range = [range[0].min(ray.range[0]), range[1].max(ray.range[1])];
            shortest = shortest.min(ray.direction.length());
        }
        let middle = |[low, high]: [DVec3; 2]| (low + high) * 0.5;
        let spread = |[low, high]: [DVec3; 2]| (high - low) * 0.5;
        let (origin, direction) = (middle(origins) - self.middle, middle(directions));
        let length = direction.length();
        // Rays that go all ways, or pass by: each may hit anything.
        if spread(directions).length() > length {
            return false;
        }
        let Some(near) = RebasedRay::new(origin, direction, range, bounds).filter(|_| length > 0.0)
        else {
            return false;
        };
        // A unit of the line is `scale` of the rays' t; rounding of f32 is within a millionth.
        let growth = spread(directions) * (near.scale * (1.0 + 1e-6));
        let reach = spread(origins) + spread(directions) * near.start;
        let f32s = |vector: DVec3| vector.to_array().map(|side| (side as f32).next_up());
        let largest = std::array::from_fn(|axis| bounds[0][axis].abs().max(bounds[1][axis].abs()));
        // Beyond the box, no ray hits anything.
        let corner = |at: usize| DVec3::from_array(bounds[at].map(f64::from));
        let across = (corner(0) - corner(1)).length() + spread(origins).length();
        let reached = (origin - (corner(0) + corner(1)) * 0.5).length() + across;
        let farthest = range[1].min(reached / shortest) - near.start;
        let farthest = ((farthest / near.scale) as f32).next_up();
        let line = SlabTest::widening(
            near.ray.origin,
            near.ray.direction,
            [0.0, farthest],
            largest,
            f32s(reach),
            f32s(growth),
        );
        self.top.visit_within(self.level, &line, farthest, |body| visit(body as usize));
        true
    }

    /// Collects the bodies whose boxes meet the box around all of some rays: all that any of them may hit.
    pub(crate) fn bodies_around(&self, rays: &[RayLanes], bodies: &mut Vec<usize>) {
        bodies.clear();
        if self.bodies() == 1 {
            bodies.push(0);
            return;
        }
        let Some(bounds) = self.top.bounds() else { return };
        let [mut low, mut high] = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        for rays in rays {
            for lane in lanes_of(rays.lanes) {
                let WorldRay { origin, direction, range } = rays.ray(lane);
                let end = origin + direction * range[1];
                (low, high) = (low.min(origin).min(end), high.max(origin).max(end));
                // Of infinitely many times 0, nothing is known.
                if !end.is_finite() {
                    [low, high] = [DVec3::NEG_INFINITY, DVec3::INFINITY];
                }
            }
        }
        // What lies beyond the box around all boxes meets nothing.
        let corner = |at: usize| DVec3::from_array(bounds[at].map(f64::from));
        let low = (low - self.middle).max(corner(0));
        let high = (high - self.middle).min(corner(1));
        if !low.cmple(high).all() {
            return;
        }
        let (middle, reach) = (low * 0.5 + high * 0.5, high * 0.5 - low * 0.5);
        let reach = reach + reach.max(middle.abs()) * 1e-6;
        let largest = std::array::from_fn(|axis| bounds[0][axis].abs().max(bounds[1][axis].abs()));
        let f32s = |vector: DVec3| vector.to_array().map(|side| (side as f32).next_up());
        // A line so short that only its thickness counts.
        let origin = middle.as_vec3().to_array();
        let around = SlabTest::widening(origin, [1.0; 3], [0.0; 2], largest, f32s(reach), [0.0; 3]);
        self.top.visit_within(self.level, &around, 0.0, |body| bodies.push(body as usize));
    }

    /// A ray in the coordinates of a body's tree.
    pub(crate) fn rebased_ray(&self, ray: &WorldRay, body: usize) -> Option<RebasedRay> {
        let tree = self.tree(body);
        let origin = tree.tree_from_world.transform_point3(ray.origin);
        let direction = tree.tree_from_world.transform_vector3(ray.direction);
        RebasedRay::new(origin, direction, ray.range, tree.bvh.bounds()?)
    }

    fn ray_to_body(
        &self,
        ray: &WorldRay,
        body: usize,
        trace: impl Fn(&RebasedRay) -> Option<RayHit>,
    ) -> Option<WorldHit> {
        let near = self.rebased_ray(ray, body)?;
        self.refined(ray, body, &near, &trace(&near)?)
    }

    /// Refines a hit in `f64`, on the triangle's plane. A triangle seen edge-on keeps the result of
    /// `f32`.
    fn refined(
        &self,
        ray: &WorldRay,
        body: usize,
        near: &RebasedRay,
        hit: &RayHit,
    ) -> Option<WorldHit> {
        self.refined_on(self.local_corners(body, hit.triangle), ray, body, near, hit)
    }

    /// The corners of a triangle, in its mesh's own space.
    #[inline]
    pub(crate) fn local_corners(&self, body: usize, triangle: u32) -> [DVec3; 3] {
        let mesh = self.mesh(body);
        mesh.triangles[triangle as usize].map(|vertex| mesh.position(vertex))
    }

    /// [`Self::refined`], given the triangle's [`Self::local_corners`].
    pub(crate) fn refined_on(
        &self,
        corners: [DVec3; 3],
        ray: &WorldRay,
        body: usize,
        near: &RebasedRay,
        hit: &RayHit,
    ) -> Option<WorldHit> {
        let world_from_mesh = self.bodies.object(body).world_from_mesh.matrix();
        let [a, b, c] = corners.map(|corner| world_from_mesh.transform_point3(corner));
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
        (ray.range[0] <= t && t <= ray.range[1]).then(|| {
            let (object, triangle) = self.in_object(body, hit.triangle);
            WorldHit { t, object, triangle, barycentric, position }
        })
    }
}
