//! Surfaces of different objects in one plane, and which of them is seen.
//!
//! Depths decide what is seen, and depths of surfaces in one plane differ by what rounding makes of
//! their corners: each wins somewhere, in a pattern that flickers ("z-fighting"). Here the first in the
//! file wins: a triangle in the plane of one of an earlier object that it overlaps gets a higher *rank*,
//! and frames and picks see it a little farther away, as `glPolygonOffset` does (OpenGL 2.1, section
//! 3.5.5).
//!
//! Most triangles meet no other object's. A grid of voxels finds those that may, and a table of the planes in
//! each voxel those of them whose plane is another object's, too. What is left is compared in pairs.

use crate::{Mesh, Object, Scene, SharedMatrix, bodies};
use glam::{DMat4, DVec3, DVec4};
use luxel_parallel::{gather, map, sort_u64};
use std::ops::Range;
use std::sync::Arc;

mod owners;
mod pairs;
mod voxels;

use owners::Owners;
use pairs::Pairs;
use voxels::Voxels;

/// The ranks of triangles that lie in the plane of an earlier object's.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CoplanarRanks {
    /// The first object of each [body](bodies) that has some, in ascending order, and its ranks.
    of_bodies: Vec<(usize, Ranks)>,
}

/// Numbers of triangles, in ascending order, and their ranks.
type Ranks = Arc<[(u32, u8)]>;

/// In deeper piles several triangles have the last rank.
const MOST_RANKS: u8 = 15;
/// Triangles a task.
const RUN: usize = 1 << 12;
/// What rounding to f32 may do to a coordinate, as a part of it, when a file is written and when its
/// transforms are.
const ROUNDING: f64 = 1.0 / (1 << 23) as f64;

impl CoplanarRanks {
    /// Finds the ranks of a scene's objects.
    #[must_use]
    pub fn of(scene: &Scene, objects: &[Object]) -> Self {
        let mut ranks = Self::default();
        if objects.len() < 2 {
            return ranks;
        }
        let boxes = map(scene.meshes.len(), 1, &|run| box_of(&scene.meshes[run.start]));
        let shown = || bodies(objects).filter(|body| !is_repeated(scene, objects, body));
        let bounds_of_object = |object: usize| {
            let Object { mesh, world_from_mesh, .. } = &objects[object];
            bounds_of(&boxes[mesh.index()], &world_from_mesh.matrix())
        };
        let around = shown()
            .map(|body| bounds_of_object(body.start))
            .reduce(|[low, high], other| [low.min(other[0]), high.max(other[1])]);
        let [low, high] = around.unwrap_or_default();
        let middle = (low + high) * 0.5;
        let mut bodies = Vec::with_capacity(shown().count());
        bodies.extend(shown().map(|body| Body::new((scene, objects), body, &middle)));
        let shared = shared_boxes(&bodies, &bounds_of_object);
        for (body, shared) in bodies.iter_mut().zip(shared) {
            body.shared = shared;
        }
        if bodies.iter().all(|body| body.shared.is_nowhere()) {
            return ranks;
        }
        let voxels = Voxels::new(&bodies, [low - middle, high - middle]);
        let candidates = candidates(&bodies, &voxels);
        let of_candidates = ranks_of(&candidates, &bodies, &voxels);
        let body_of = |(number, _): &(u32, u8)| candidates[*number as usize].body;
        // Candidates stand in the order of the scene.
        for own in of_candidates.chunk_by(|one, other| body_of(one) == body_of(other)) {
            let mut list = Vec::new();
            for &(number, rank) in own {
                let Candidate { triangle, count, .. } = candidates[number as usize];
                list.extend((triangle..triangle + count).map(|triangle| (triangle, rank)));
            }
            list.sort_unstable();
            let first = bodies[body_of(&own[0]) as usize].first as usize;
            ranks.add(scene, objects, first, &list.into());
        }
        ranks
    }

    /// Adds the ranks of a body, given by its first object, and of those that repeat it.
    fn add(&mut self, scene: &Scene, objects: &[Object], first: usize, list: &Ranks) {
        let mut next = first;
        loop {
            self.of_bodies.push((next, Arc::clone(list)));
            next += 1;
            if next == objects.len() || !is_repeated(scene, objects, &(next..next + 1)) {
                return;
            }
        }
    }

    /// The triangles of a body with a rank above 0: their numbers in its mesh, in ascending order, with
    /// their ranks. The body is given by its first object.
    #[must_use]
    pub fn of_body(&self, first_object: usize) -> &[(u32, u8)] {
        let found = self.of_bodies.binary_search_by_key(&first_object, |(first, _)| *first);
        found.map_or(&[], |place| &self.of_bodies[place].1)
    }
}

/// The rank of a triangle, by a list of [`CoplanarRanks::of_body`].
#[must_use]
#[inline]
pub fn rank_of(ranks: &[(u32, u8)], triangle: u32) -> u8 {
    if ranks.is_empty() {
        return 0;
    }
    let found = ranks.binary_search_by_key(&triangle, |(number, _)| *number);
    found.map_or(0, |at| ranks[at].1)
}

/// Whether a body is one object that repeats the object before it: it lies as far behind others as that one
/// does. Hundreds of thousands of instances in one place, a file of some megabytes, cost one of them.
fn is_repeated(scene: &Scene, objects: &[Object], body: &Range<usize>) -> bool {
    let own = &objects[body.start];
    body.len() == 1
        && scene.meshes[own.mesh.index()].sections.is_empty()
        && body.start.checked_sub(1).is_some_and(|before| own.repeats(&objects[before]))
}

/// Objects that are drawn as one, in their place.
struct Body<'a> {
    /// The first object, and how many there are.
    first: u32,
    count: u32,
    mesh: &'a Mesh,
    world_from_mesh: &'a SharedMatrix,
    /// The middle of the scene, which planes are about.
    middle: &'a DVec3,
    shared: Shared,
}

/// Where a body may meet other objects.
enum Shared {
    Everywhere,
    /// In these boxes.
    Within(Box<[[DVec3; 2]]>),
}

impl Shared {
    fn nowhere() -> Self {
        Self::Within([].into())
    }

    fn is_nowhere(&self) -> bool {
        matches!(self, Self::Within(boxes) if boxes.is_empty())
    }

    /// Whether a part of the body with this box may meet others.
    fn meets(&self, bounds: &[DVec3; 2]) -> bool {
        match self {
            Self::Everywhere => true,
            Self::Within(boxes) => boxes.iter().any(|shared| meet(shared, bounds)),
        }
    }
}

/// A triangle in the world.
struct Facet {
    /// About the middle of the scene.
    corners: [DVec3; 3],
    /// Of unit length.
    normal: DVec3,
    /// How far rounding may have moved its corners.
    error: f64,
    /// How far its normal may be off by that, in radians.
    tilt: f64,
}

impl<'a> Body<'a> {
    fn new(
        (scene, objects): (&'a Scene, &'a [Object]),
        body: Range<usize>,
        middle: &'a DVec3,
    ) -> Self {
        let Object { mesh, world_from_mesh, .. } = &objects[body.start];
        Self {
            first: body.start as u32,
            count: body.len() as u32,
            mesh: &scene.meshes[mesh.index()],
            world_from_mesh,
            middle,
            shared: Shared::nowhere(),
        }
    }

    /// The largest factor by which its place scales.
    fn scale(&self) -> f64 {
        let DMat4 { x_axis, y_axis, z_axis, .. } = self.world_from_mesh.matrix();
        [x_axis, y_axis, z_axis].map(DVec4::length).into_iter().fold(0.0, f64::max)
    }

    /// The corners of a triangle about the middle of the scene.
    #[inline]
    fn corners(&self, triangle: u32) -> [DVec3; 3] {
        let [a, b, c] = self.mesh.triangles[triangle as usize];
        let world_from_mesh = self.world_from_mesh.matrix();
        let place = |corner: u32| {
            world_from_mesh.transform_point3(self.mesh.position(corner)) - *self.middle
        };
        [place(a), place(b), place(c)]
    }

    /// The box of a triangle; `None` for one that meets no other object, or isn't finite.
    #[inline]
    fn shared_bounds(&self, [a, b, c]: &[DVec3; 3]) -> Option<[DVec3; 2]> {
        let bounds = [a.min(*b).min(*c), a.max(*b).max(*c)];
        (self.shared.meets(&bounds) && bounds[0].is_finite() && bounds[1].is_finite())
            .then_some(bounds)
    }

    /// `None` for a triangle without area.
    fn facet(&self, triangle: u32, corners: [DVec3; 3]) -> Option<Facet> {
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a);
        let area = normal.length();
        let longest = (b - a).length_squared().max((c - a).length_squared());
        let longest = longest.max((c - b).length_squared()).sqrt();
        let largest = self.mesh.triangles[triangle as usize]
            .map(|corner| self.mesh.position(corner).abs().max_element());
        let largest = largest.into_iter().fold(0.0, f64::max);
        let moved = self.world_from_mesh.matrix().w_axis.truncate().abs().max_element();
        let error = ROUNDING * (largest * self.scale() + moved);
        // Across its longest side it is area / longest high.
        let tilt = 2.0 * error * longest / area;
        let normal = normal / area;
        (normal.is_finite() && tilt < MOST_TILT).then_some(Facet { corners, normal, error, tilt })
    }

    /// The number of the object that a triangle belongs to.
    fn object(&self, triangle: u32) -> u32 {
        let (section, _) = self.mesh.section_of(triangle);
        if self.mesh.sections.is_empty() { self.first } else { self.first + section }
    }
}

/// A box around the box of a mesh, in the world: not the least one, but quickly found.
fn bounds_of([centre, half]: &[DVec3; 2], world_from_mesh: &DMat4) -> [DVec3; 2] {
    let DMat4 { x_axis, y_axis, z_axis, .. } = *world_from_mesh;
    let [x, y, z] = [x_axis, y_axis, z_axis].map(|axis| axis.truncate().abs());
    let half = x * half.x + y * half.y + z * half.z;
    let centre = world_from_mesh.transform_point3(*centre);
    [centre - half, centre + half]
}

/// The middle of a mesh's box, and half of its sides.
fn box_of(mesh: &Mesh) -> [DVec3; 2] {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for place in &mesh.positions {
        for axis in 0..3 {
            low[axis] = low[axis].min(place[axis]);
            high[axis] = high[axis].max(place[axis]);
        }
    }
    let [low, high] = [low, high].map(|corner| DVec3::from_array(corner.map(f64::from)));
    [mesh.origin + (low + high) * 0.5, (high - low) * 0.5]
}

/// Where each body may meet others: everywhere if objects within it may meet.
fn shared_boxes(
    bodies: &[Body<'_>],
    bounds_of_object: &dyn Fn(usize) -> [DVec3; 2],
) -> Vec<Shared> {
    // With room for rounding, as for a part of the coordinates here. Computed anew: kept in bodies, boxes would take as
    // much memory as all else of them.
    let grown = |body: &Body<'_>| {
        let [low, high] = bounds_of_object(body.first as usize).map(|corner| corner - *body.middle);
        let largest = (low.abs().max(high.abs()) + body.middle.abs()).max_element();
        let margin = 8.0 * ROUNDING * largest;
        [low - margin, high + margin]
    };
    let triangles: usize = bodies.iter().map(|body| body.mesh.triangles.len()).sum();
    // To compare two boxes takes less than a tenth of what looking at a triangle does.
    let compares = bodies.len() * bodies.len() <= 10 * triangles;
    let compared: Vec<[DVec3; 2]> =
        if compares { bodies.iter().map(grown).collect() } else { Vec::new() };
    let of_body = |(number, body): (usize, &Body<'_>)| {
        let own = grown(body);
        if !own[0].is_finite() || !own[1].is_finite() {
            return Shared::nowhere();
        }
        if !compares || body.count > 1 {
            return Shared::Everywhere;
        }
        let others = (0..compared.len()).filter(|other| *other != number);
        let shared = others.map(|other| &compared[other]).filter(|other| meet(&own, other));
        let shared: Vec<_> =
            shared.map(|other| [own[0].max(other[0]), own[1].min(other[1])]).collect();
        if shared.len() > MOST_SHARED { Shared::Everywhere } else { Shared::Within(shared.into()) }
    };
    bodies.iter().enumerate().map(of_body).collect()
}

/// A body with more of these boxes is taken to meet others everywhere.
const MOST_SHARED: usize = 8;

/// Whether two boxes have a point in common.
fn meet([low, high]: &[DVec3; 2], [other_low, other_high]: &[DVec3; 2]) -> bool {
    low.cmple(*other_high).all() && other_low.cmple(*high).all()
}

/// Planes of triangles that are known less well aren't compared.
const MOST_TILT: f64 = 0.01;

/// A triangle in a voxel with triangles of other objects, and those that follow it with the same corners.
struct Candidate {
    object: u32,
    body: u32,
    triangle: u32,
    /// How many triangles it stands for.
    count: u32,
}

impl Candidate {
    fn corners(&self, bodies: &[Body<'_>]) -> [DVec3; 3] {
        bodies[self.body as usize].corners(self.triangle)
    }

    /// `None` for a triangle without area.
    fn facet(&self, bodies: &[Body<'_>]) -> Option<Facet> {
        bodies[self.body as usize].facet(self.triangle, self.corners(bodies))
    }
}

/// Triangles of a body.
struct Piece {
    body: u32,
    triangles: Range<u32>,
}

/// The triangles of bodies, divided among tasks.
fn tasks(bodies: &[Body<'_>]) -> Vec<Vec<Piece>> {
    let mut tasks: Vec<Vec<Piece>> = Vec::new();
    let mut room = 0;
    for (number, body) in (0..).zip(bodies) {
        if body.shared.is_nowhere() {
            continue;
        }
        let count = body.mesh.triangles.len() as u32;
        for first in (0..count).step_by(RUN) {
            let triangles = first..count.min(first + RUN as u32);
            let length = triangles.len();
            let piece = Piece { body: number, triangles };
            match tasks.last_mut() {
                Some(task) if length <= room => task.push(piece),
                _ => {
                    tasks.push(vec![piece]);
                    room = RUN;
                }
            }
            room -= length;
        }
    }
    tasks
}

/// The candidates, in the order of the scene.
fn candidates(bodies: &[Body<'_>], voxels: &Voxels) -> Vec<Candidate> {
    let tasks = tasks(bodies);
    let owners = Owners::new(voxels.count());
    luxel_parallel::tasks(tasks.len(), &|task| {
        for Piece { body, triangles } in &tasks[task] {
            let body = &bodies[*body as usize];
            for triangle in triangles.clone() {
                if let Some(bounds) = body.shared_bounds(&body.corners(triangle)) {
                    let object = body.object(triangle);
                    voxels.visit(&bounds, &mut |voxel, _| owners.add(voxel, object));
                }
            }
        }
    });
    gather(tasks.len(), 1, &|run, found| {
        for Piece { body: number, triangles } in &tasks[run.start] {
            let body = &bodies[*number as usize];
            let mut last: Option<[DVec3; 3]> = None;
            for triangle in triangles.clone() {
                let corners = body.corners(triangle);
                if last == Some(corners) {
                    let repeated: Option<&mut Candidate> = found.last_mut();
                    repeated.into_iter().for_each(|candidate| candidate.count += 1);
                    continue;
                }
                let mut meets = false;
                if let Some(bounds) = body.shared_bounds(&corners) {
                    voxels.visit(&bounds, &mut |voxel, _| meets |= owners.are_several(voxel));
                }
                last = meets.then_some(corners);
                if meets {
                    let object = body.object(triangle);
                    found.push(Candidate { object, body: *number, triangle, count: 1 });
                }
            }
        }
    })
}

/// The planes of triangles that are other objects' planes, too: as keys, the plane's hash in the upper bits and the
/// number of the triangle in the lower, in ascending order. Planes with equal hashes are taken for one: their
/// triangles are compared in vain.
fn shared_planes(candidates: &[Candidate], bodies: &[Body<'_>], voxels: &Voxels) -> Vec<u64> {
    let mut keys = gather(candidates.len(), RUN, &|run, keys| {
        for number in run {
            let key = |plane: u64| u64::from(hash(plane)) << 32 | number as u64;
            if let Some(facet) = candidates[number].facet(bodies) {
                voxels.visit_planes(&facet, &mut |plane| keys.push(key(plane)));
            }
        }
    });
    let owners = Owners::new(2 * candidates.len());
    luxel_parallel::tasks(keys.len().div_ceil(RUN), &|run| {
        for &key in keys[run * RUN..].iter().take(RUN) {
            owners.add((key >> 32) as usize, candidates[key as u32 as usize].object);
        }
    });
    keys.retain(|&key| owners.are_several((key >> 32) as usize));
    sort_u64(&mut keys);
    keys
}

/// Multiplicative hashing (Knuth, volume 3, section 6.4) with the golden ratio.
const fn hash(plane: u64) -> u32 {
    (plane.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) as u32
}

/// The numbers of candidates of ranks above 0, with these.
fn ranks_of(candidates: &[Candidate], bodies: &[Body<'_>], voxels: &Voxels) -> Vec<(u32, u8)> {
    let keys = shared_planes(candidates, bodies, voxels);
    let in_planes: Vec<&[u64]> = keys.chunk_by(|one, other| one >> 32 == other >> 32).collect();
    let mut found: Vec<u64> = gather(in_planes.len(), 64, &|run, found| {
        for plane in &in_planes[run] {
            let object = |key: &u64| candidates[*key as u32 as usize].object;
            if plane.iter().any(|key| object(key) != object(&plane[0])) {
                let of_key = |key: &u64| {
                    let candidate = &candidates[*key as u32 as usize];
                    Some((*key as u32, candidate, candidate.facet(bodies)?))
                };
                let triangles: Vec<_> = plane.iter().filter_map(of_key).collect();
                let all: Vec<u32> = (0..triangles.len() as u32).collect();
                Pairs { triangles: &triangles, bodies, found }.of(&all);
            }
        }
    });
    // A triangle's rank is known before that of any later one.
    sort_u64(&mut found);
    found.dedup();
    let mut ranks = vec![0_u8; candidates.len()];
    for pair in found {
        let (later, earlier) = ((pair >> 32) as usize, pair as u32 as usize);
        let is_same = is_same([&candidates[later], &candidates[earlier]], bodies);
        let least = (ranks[earlier] + u8::from(!is_same)).min(MOST_RANKS);
        ranks[later] = ranks[later].max(least);
    }
    (0..).zip(ranks).filter(|(_, rank)| *rank > 0).collect()
}

/// Whether two triangles have the same corners in the same order and in the same place, so that their depths
/// are equal from wherever they are seen.
fn is_same([one, other]: [&Candidate; 2], bodies: &[Body<'_>]) -> bool {
    let [a, b] = [one, other].map(|candidate| &bodies[candidate.body as usize]);
    a.world_from_mesh == b.world_from_mesh
        && a.mesh.origin == b.mesh.origin
        && one.corners(bodies) == other.corners(bodies)
}
