//! The outermost of many points: exact maxima over all drawn points of objects, of which a search
//! looks at few.
//!
//! A maximum doesn't depend on the order of its points. So points may be left out once it is
//! certain that none of them reaches the best value so far, and the result has the same bits as a
//! walk over all points: those that may reach it are transformed and measured as a walk does it.
//!
//! Each [`Measure`] is searched for itself, from the place where a similar one was highest.
//! Searching several measures at once would open the nodes that any of them needs.

mod cut;
mod measure;

pub(crate) use measure::{Along, Coordinate, Slope};

use crate::point_tree::{LEAF, PointTree, WIDTH};
use crate::{Bounds, Mesh, SharedAxes};
use cut::Cut;
use glam::{DMat4, DVec3};
use measure::Measure;

/// Where a maximum was found: a good place to begin the search for a similar one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    object: usize,
    leaf: usize,
}

/// Points in a local space.
#[derive(Debug)]
pub(crate) struct Extremes<'a> {
    objects: Vec<Object<'a>>,
    /// Points of no mesh.
    single: Vec<DVec3>,
}

#[derive(Debug)]
struct Object<'a> {
    mesh: &'a Mesh,
    tree: &'a PointTree,
    target_from_mesh: SharedAxes,
    /// The largest terms of its points' coordinates.
    magnitudes: DVec3,
    /// The largest coordinates of its points in the mesh.
    largest: DVec3,
}

impl<'a> Extremes<'a> {
    /// The drawn points of objects: of each its mesh, the mesh's tree, and the matrix to the common
    /// space.
    pub(crate) fn of_objects(
        objects: impl Iterator<Item = (&'a Mesh, &'a PointTree, DMat4)>,
    ) -> Self {
        let mut last = SharedAxes::new(&DMat4::IDENTITY);
        let drawn = objects.filter(|(_, tree, _)| tree.len() > 0);
        let objects = drawn.map(|(mesh, tree, target_from_mesh)| {
            let [low, high] = tree.bounds();
            let along = |axis: usize| f64::from(low[axis].abs().max(high[axis].abs()));
            let largest = DVec3::new(along(0), along(1), along(2));
            let with_origin = largest + mesh.origin.abs();
            let [x, y, z, translation] =
                [0, 1, 2, 3].map(|column| target_from_mesh.col(column).truncate().abs());
            let magnitudes =
                x * with_origin.x + y * with_origin.y + z * with_origin.z + translation;
            last = SharedAxes::new(&target_from_mesh).sharing(&last);
            Object { mesh, tree, target_from_mesh: last.clone(), magnitudes, largest }
        });
        Self { objects: objects.collect(), single: Vec::new() }
    }

    /// Points that are in the common space already.
    pub(crate) fn of_points(single: Vec<DVec3>) -> Self {
        Self { objects: Vec::new(), single }
    }

    /// The bounds of all points; `places` learns where they are highest and lowest along each axis.
    pub(crate) fn bounds(&self, places: &mut [Option<Place>; 6]) -> Bounds {
        let mut highest = |axis: usize, sign: f64, place: usize| {
            // Transformed zeros are positive, unless the translation has a negative zero, which
            // products of matrices don't have. Adding zero makes the opposite of a zero positive,
            // too.
            sign * self.highest(Coordinate { axis, sign }, &mut places[place]).0 + 0.0
        };
        let max = DVec3::new(highest(0, 1.0, 0), highest(1, 1.0, 2), highest(2, 1.0, 4));
        let min = DVec3::new(highest(0, -1.0, 1), highest(1, -1.0, 3), highest(2, -1.0, 5));
        Bounds { min, max }
    }

    /// The highest value of a measure: (-infinity, 0) if nothing is higher. The search begins at
    /// `place`, and leaves there where the highest value is.
    pub(crate) fn highest(&self, measure: impl Measure, place: &mut Option<Place>) -> (f64, f64) {
        let mut search = Search {
            measure,
            best: (f64::NEG_INFINITY, 0.0),
            place: *place,
            room: [[0.0; 3]; LEAF],
        };
        for &point in &self.single {
            let value = measure.at(point);
            if is_higher(value, search.best) {
                search.best = value;
            }
        }
        if let Some(Place { object, leaf }) = *place {
            let cut = Cut::new(&measure, search.best.0, &self.objects[object]);
            search.open_leaf(&self.objects[object], Place { object, leaf }, &cut);
        }
        for (number, object) in self.objects.iter().enumerate() {
            search.open_object(object, number);
        }
        *place = search.place;
        search.best
    }
}

fn is_higher(value: (f64, f64), than: (f64, f64)) -> bool {
    value.0 > than.0 || value.0 == than.0 && value.1 > than.1
}

/// The child that reaches farthest, among those with a set bit.
fn farthest(reaches: &[f32; WIDTH], among: u32) -> usize {
    let (mut farthest, mut highest) = (among.trailing_zeros() as usize, f32::NEG_INFINITY);
    for (child, &reach) in reaches.iter().enumerate() {
        if among >> child & 1 == 1 && reach > highest {
            (farthest, highest) = (child, reach);
        }
    }
    farthest
}

/// A search under way.
struct Search<M> {
    measure: M,
    best: (f64, f64),
    place: Option<Place>,
    /// For the points of a leaf.
    room: [[f32; 3]; LEAF],
}

impl<M: Measure> Search<M> {
    fn open_object(&mut self, object: &Object<'_>, number: usize) {
        let mut cut = Cut::new(&self.measure, self.best.0, object);
        let [low, high] = object.tree.bounds();
        if !cut.is_reached(cut.reach_of(low, high)) {
            return;
        }
        match object.tree.levels().len() {
            0 => self.open_leaf(object, Place { object: number, leaf: 0 }, &cut),
            levels => {
                self.open_node(object, levels - 1, Place { object: number, leaf: 0 }, &mut cut);
            }
        }
    }

    /// Opens a node of a level: the child that reaches farthest, then the others that still count.
    fn open_node(&mut self, object: &Object<'_>, level: usize, node: Place, cut: &mut Cut) {
        let Place { object: number, leaf: index } = node;
        let node = &object.tree.levels()[level][index];
        let reaches = cut.reaches_of(node);
        let mut best = cut.best;
        let mut left = cut.reached(&reaches) & ((1 << node.children) - 1);
        let mut next = farthest(&reaches, left);
        while left != 0 {
            left &= !(1 << next);
            let child = Place { object: number, leaf: WIDTH * index + next };
            if level == 0 {
                self.open_leaf(object, child, cut);
            } else {
                self.open_node(object, level - 1, child, cut);
            }
            if cut.best != self.best.0 {
                *cut = Cut::new(&self.measure, self.best.0, object);
            }
            if cut.best != best {
                best = cut.best;
                left &= cut.reached(&cut.reaches_of(node));
            }
            next = left.trailing_zeros() as usize;
        }
    }

    fn open_leaf(&mut self, object: &Object<'_>, place: Place, cut: &Cut) {
        let points = object.tree.leaf(object.mesh, place.leaf, &mut self.room);
        let counts = |point: [f32; 3]| cut.is_reached(cut.reach_of(point, point));
        // Without a branch for each point: most leaves have none that counts.
        if !points.iter().fold(false, |any, &point| any | counts(point)) {
            return;
        }
        let target_from_mesh = object.target_from_mesh.matrix();
        for &[x, y, z] in points.iter().filter(|point| counts(**point)) {
            let position = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
            let point = target_from_mesh.transform_point3(object.mesh.origin + position);
            let value = self.measure.at(point);
            if is_higher(value, self.best) {
                (self.best, self.place) = (value, Some(place));
            }
        }
    }
}
