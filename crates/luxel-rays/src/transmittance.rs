//! How much light comes along a ray.

use crate::body_tree::BodyTree;
use crate::ray_lanes::{RayLanes, Spread};
use crate::scene_rays::SceneRays;
use crate::world_ray::{RebasedRay, WorldRay};
use glam::DVec3;
use luxel_bvh::{Ray, RayColumns, RayHit};
use luxel_math::prelude::*;
use luxel_math::{LANES, dispatch_long, f32x16, lanes_of};
use std::cell::RefCell;
use std::cmp::Ordering;
use std::ops::ControlFlow;

thread_local! {
    static BATCH: RefCell<Batch> = RefCell::new(Batch::default());
}

/// What [`SceneRays::transmittance_of_lanes`] keeps from call to call.
#[derive(Default)]
struct Batch {
    /// The bodies near rays that go all ways, and those near any that light shines through.
    bodies: Vec<usize>,
    translucent: Vec<usize>,
    hits: BodyHits,
    /// What keeps a part of the light, and the place of its ray among all.
    blockers: Vec<(usize, Blocker)>,
}

/// Which rays hit a body.
#[derive(Default)]
struct BodyHits {
    /// The rays near the body, their numbers among all, and the lanes that hit it.
    columns: Vec<RayColumns>,
    numbers: Vec<u32>,
    lanes: Vec<u32>,
    /// The same one after the other, if they go all ways; their places among all, and which hit it.
    rows: Vec<Ray>,
    places: Vec<u32>,
    hits: Vec<bool>,
}

impl BodyHits {
    /// Visits the rays that hit: the number and the lane of each.
    #[inline]
    fn each(&self, mut visit: impl FnMut(usize, usize)) {
        for (&number, &lanes) in self.numbers.iter().zip(&self.lanes) {
            for lane in lanes_of(lanes) {
                visit(number as usize, lane);
            }
        }
        for (&place, is_hit) in self.places.iter().zip(&self.hits) {
            if *is_hit {
                visit(place as usize / LANES, place as usize % LANES);
            }
        }
    }
}

/// Up to so many bodies are each asked for all rays that go all ways; among more, each ray finds its own.
const FEW: usize = 8;

/// So many surfaces in the way of a batch are remembered, in less than 4 MB a thread; of more, each ray
/// remembers its own.
const MANY: usize = 1 << 16;

/// A surface in the way of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocker {
    /// The object, by its index in [`SceneRays::objects`].
    pub object: usize,
    /// The triangle's number in the object.
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
        self.each_body(ray, |body, farthest| {
            is_blocked = is_blocked
                || if self.is_opaque(body) {
                    self.rebased_ray(ray, body).is_some_and(|near| self.rays(body).any(&near.ray))
                } else {
                    self.is_blocked_by(body, ray, &mut |blocker| weakening.push(blocker))
                };
            if is_blocked { f64::NEG_INFINITY } else { farthest }
        });
        if is_blocked {
            return 0.0;
        }
        weakening.sort_by(nearest_first);
        weakening.iter().fold(1.0, |through, blocker| through * (1.0 - blocker.alpha))
    }

    /// [`SceneRays::transmittance`] of rays side by side, those of up to a few dozen neighbours, on this
    /// thread; 1 in lanes without a ray. `spread` decides how they are traced, not what they find.
    ///
    /// # Panics
    /// If `through` isn't as long as `rays`.
    pub fn transmittance_of_lanes(
        &self,
        rays: &[RayLanes],
        spread: Spread,
        through: &mut [[f32; LANES]],
    ) {
        assert_eq!(rays.len(), through.len(), "each ray has an answer");
        through.fill([1.0; LANES]);
        BATCH.with_borrow_mut(|batch| {
            let Batch { bodies, translucent, hits, blockers } = batch;
            translucent.clear();
            let mut take_light = |body| {
                if self.is_opaque(body) {
                    self.hits_of(body, (rays, spread), through, hits);
                    hits.each(|number, lane| through[number][lane] = 0.0);
                } else {
                    translucent.push(body);
                }
            };
            let is_shared = match spread {
                Spread::Narrow => {
                    self.each_body_near(rays.iter().flat_map(RayLanes::rays), take_light)
                }
                Spread::Wide => {
                    self.bodies_around(rays, bodies);
                    let is_few = bodies.len() <= FEW;
                    bodies.iter().filter(|_| is_few).for_each(|&body| take_light(body));
                    is_few
                }
            };
            // Opaque bodies came first: the rays that they block need no look at what keeps a part.
            if !is_shared || !self.weaken(translucent, (rays, spread), through, (hits, blockers)) {
                for (rays, through) in rays.iter().zip(through) {
                    for lane in lanes_of(rays.lanes) {
                        through[lane] = self.transmittance(&rays.ray(lane));
                    }
                }
            }
        });
    }

    /// Takes what translucent bodies keep from the light along rays. Returns whether it did: too many surfaces
    /// in the way aren't remembered.
    fn weaken(
        &self,
        bodies: &[usize],
        (rays, spread): (&[RayLanes], Spread),
        through: &mut [[f32; LANES]],
        (hits, blockers): (&mut BodyHits, &mut Vec<(usize, Blocker)>),
    ) -> bool {
        blockers.clear();
        for &body in bodies {
            self.hits_of(body, (rays, spread), through, hits);
            hits.each(|number, lane| {
                let place = number * LANES + lane;
                let weaken = &mut |blocker| {
                    if blockers.len() <= MANY {
                        blockers.push((place, blocker));
                    }
                };
                if self.is_blocked_by(body, &rays[number].ray(lane), weaken) {
                    through[number][lane] = 0.0;
                }
            });
            if blockers.len() > MANY {
                return false;
            }
        }
        blockers.sort_by(|(a, near), (b, far)| a.cmp(b).then(nearest_first(near, far)));
        for (place, blocker) in &*blockers {
            through[place / LANES][place % LANES] *= 1.0 - blocker.alpha;
        }
        true
    }

    /// Finds which of the rays that light is left of hit a body.
    fn hits_of(
        &self,
        body: usize,
        (rays, spread): (&[RayLanes], Spread),
        through: &[[f32; LANES]],
        hits: &mut BodyHits,
    ) {
        let BodyHits { columns, numbers, lanes, rows, places, hits } = hits;
        columns.clear();
        numbers.clear();
        lanes.clear();
        places.clear();
        let tree = self.tree(body);
        let Some(sphere) = self.sphere(body) else { return };
        dispatch_long!(self.level, simd => near_columns(simd, self, (body, &tree, sphere), (rays, through), (columns, numbers)));
        match spread {
            Spread::Narrow => {
                lanes.resize(columns.len(), 0);
                self.rays(body).any_of_columns(columns, lanes);
            }
            Spread::Wide => {
                rows.clear();
                dispatch_long!(self.level, simd => rows_of(simd, (columns, numbers), (rows, places)));
                hits.resize(rows.len(), false);
                self.rays(body).any_of_incoherent(rows, hits);
            }
        }
    }

    /// Whether one of a translucent body's surfaces keeps all light of a ray; `weaken` is called with those
    /// that keep a part, of a blocked ray not with all.
    fn is_blocked_by(&self, body: usize, ray: &WorldRay, weaken: &mut dyn FnMut(Blocker)) -> bool {
        let Some(near) = self.rebased_ray(ray, body) else { return false };
        let mut is_blocked = false;
        self.rays(body).each_hit(&near.ray, &mut |hit| {
            match self.blocker(body, &near, &hit) {
                Some(blocker) if blocker.alpha >= 1.0 => {
                    is_blocked = true;
                    return ControlFlow::Break(());
                }
                Some(blocker) => weaken(blocker),
                None => {}
            }
            ControlFlow::Continue(())
        });
        is_blocked
    }

    /// The surfaces in the way of a ray, nearest first: those that make [`SceneRays::transmittance`] less
    /// than 1, and those behind an opaque one.
    #[must_use]
    pub fn blockers(&self, ray: &WorldRay) -> Vec<Blocker> {
        let mut blockers = Vec::new();
        self.each_body(ray, |body, farthest| {
            if let Some(near) = self.rebased_ray(ray, body) {
                let hits = self.rays(body).all(&near.ray);
                blockers.extend(hits.iter().filter_map(|hit| self.blocker(body, &near, hit)));
            }
            farthest
        });
        blockers.sort_by(nearest_first);
        blockers
    }

    /// What a hit triangle keeps of the light; `None` where it has a hole.
    fn blocker(&self, body: usize, near: &RebasedRay, hit: &RayHit) -> Option<Blocker> {
        let RayHit { triangle, barycentric, .. } = *hit;
        let mesh = self.mesh(body);
        let part = mesh.parts.partition_point(|part| part.first <= triangle).saturating_sub(1);
        let alpha = mesh.parts.get(part).map_or(1.0, |part| {
            let scene = self.scene();
            scene.opacity(mesh, triangle, barycentric, &scene.materials[part.material.index()])
        });
        let (object, triangle) = self.in_object(body, triangle);
        let t = near.start + near.scale * f64::from(hit.t);
        (alpha > 0.0).then_some(Blocker { object, triangle, t, alpha })
    }
}

/// Collects the rays that light is left of and that come near a body, as columns in the coordinates of its
/// tree.
#[inline(always)]
fn near_columns<S: Simd>(
    simd: S,
    scene: &SceneRays,
    (body, tree, sphere): (usize, &BodyTree<'_>, (DVec3, f64)),
    (rays, through): (&[RayLanes], &[[f32; LANES]]),
    (near, numbers): (&mut Vec<RayColumns>, &mut Vec<u32>),
) {
    for (number, (rays, through)) in (0..).zip(rays.iter().zip(through)) {
        let lit = f32x16::splat(simd, 0.0).less(f32x16::simd_from(simd, *through)).bits();
        let left = rays.lanes & lit;
        if left == 0 {
            continue;
        }
        near.push(RayColumns::NONE);
        let Some(columns) = near.last_mut() else { return };
        let ([ox, oy, oz, dx, dy, dz, start, end], lanes) = rays.rebased(simd, tree, sphere);
        let [inside, outside] = lanes.map(|lanes| lanes & left);
        let [origin_x, origin_y, origin_z] = &mut columns.origin;
        let [along_x, along_y, along_z] = &mut columns.direction;
        let [nearest, farthest] = &mut columns.range;
        ox.store_slice(origin_x);
        oy.store_slice(origin_y);
        oz.store_slice(origin_z);
        dx.store_slice(along_x);
        dy.store_slice(along_y);
        dz.store_slice(along_z);
        start.store_slice(nearest);
        end.store_slice(farthest);
        columns.lanes = inside;
        for lane in lanes_of(outside) {
            if let Some(far) = scene.rebased_ray(&rays.ray(lane), body) {
                columns.put(lane, &far.ray);
            }
        }
        match columns.lanes {
            0 => _ = near.pop(),
            _ => numbers.push(number),
        }
    }
}

/// Rays in columns one after the other, and the place of each among all.
#[inline(always)]
fn rows_of<S: Simd>(
    simd: S,
    (columns, numbers): (&[RayColumns], &[u32]),
    (near, places): (&mut Vec<Ray>, &mut Vec<u32>),
) {
    let simd = f32x16::splat(simd, 0.0);
    for (columns, &number) in columns.iter().zip(numbers) {
        // Written to where they stay: a copy would wait for the rays that are still being stored.
        let begin = near.len();
        near.resize(begin + LANES, Ray::new([0.0; 3], [0.0; 3]));
        let Some(rows): Option<&mut [Ray; LANES]> = near.last_chunk_mut() else { return };
        let RayColumns { origin: [ox, oy, oz], direction: [dx, dy, dz], range, lanes } = columns;
        let [start, end] = range;
        let values = [
            simd.load(ox, 0),
            simd.load(oy, 0),
            simd.load(oz, 0),
            simd.load(dx, 0),
            simd.load(dy, 0),
            simd.load(dz, 0),
            simd.load(start, 0),
            simd.load(end, 0),
        ];
        Lanes::store_transposed(
            values,
            #[inline(always)]
            |lane, [ox, oy, oz, dx, dy, dz, start, end]| {
                let (origin, direction) = ([ox, oy, oz], [dx, dy, dz]);
                rows[lane % LANES] = Ray { origin, direction, range: [start, end] };
            },
        );
        let first = number * LANES as u32;
        if *lanes == simd.all_lanes() {
            places.extend(first..first + LANES as u32);
            continue;
        }
        let mut count = begin;
        for lane in lanes_of(*lanes) {
            near[count] = near[begin + lane];
            places.push(first + lane as u32);
            count += 1;
        }
        near.truncate(count);
    }
}

/// Nearest first; of equally near ones the first object's lowest triangle.
fn nearest_first(a: &Blocker, b: &Blocker) -> Ordering {
    a.t.total_cmp(&b.t).then((a.object, a.triangle).cmp(&(b.object, b.triangle)))
}
