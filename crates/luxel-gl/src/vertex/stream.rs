//! The stream of vertices between `glBegin` and `glEnd`.
//!
//! An attribute that nobody changes between vertices is kept once. The first change fills in its past, and from
//! then on each vertex has its own.

use super::fetch::Fetched;
use crate::limits::TEXTURE_UNITS;
use crate::state::current::Current;
use crate::state::material::SurfaceMaterial;

/// An attribute of all vertices of a stream.
#[derive(Clone, Debug)]
pub(crate) struct Varying<T> {
    /// The value of all vertices so far and of the next one, or of the next one alone.
    now: T,
    values: Vec<T>,
    varies: bool,
}

impl<T: Copy> Varying<T> {
    fn new(now: T) -> Self {
        Self { now, values: Vec::new(), varies: false }
    }

    /// Changes the value for the next vertex, of which `count` are already there.
    #[inline]
    pub(crate) fn set(&mut self, value: T, count: usize) {
        if !self.varies && count > 0 {
            self.varies = true;
            self.values.resize(count, self.now);
        }
        self.now = value;
    }

    #[inline]
    fn push(&mut self) {
        if self.varies {
            self.values.push(self.now);
        }
    }

    /// The value of a vertex.
    #[inline(always)]
    pub(crate) fn of(&self, vertex: usize) -> T {
        if self.varies { self.values[vertex] } else { self.now }
    }

    /// Takes values of all vertices, if there are any.
    fn replace(&mut self, values: Option<Vec<T>>) {
        if let Some(values) = values {
            self.values = values;
            self.varies = true;
        }
    }

    /// Whether vertices have values of their own.
    pub(crate) fn varies(&self) -> bool {
        self.varies
    }

    /// Keeps only the last vertices from `first` on.
    fn keep_from(&mut self, first: usize) {
        if self.varies {
            self.values.drain(..first);
        }
    }
}

/// Front and back material.
pub(crate) type Sides = [SurfaceMaterial; 2];

/// The vertices of one `glBegin`.
#[derive(Clone, Debug)]
pub(crate) struct Stream {
    pub(crate) mode: u32,
    pub(crate) positions: Vec<[f32; 4]>,
    pub(crate) color: Varying<[f32; 4]>,
    pub(crate) secondary: Varying<[f32; 3]>,
    pub(crate) normal: Varying<[f32; 3]>,
    /// Of unit 0.
    pub(crate) tex_coord: Varying<[f32; 4]>,
    /// Of the units from 1 on.
    more_tex_coords: [Varying<[f32; 4]>; TEXTURE_UNITS - 1],
    /// Whether one of these varies.
    more_vary: bool,
    pub(crate) fog_coord: Varying<f32>,
    pub(crate) edge_flag: Varying<bool>,
    /// Materials, in the order in which they were set; vertices have numbers of these.
    pub(crate) materials: Vec<Sides>,
    pub(crate) material: Varying<u32>,
    /// Whether earlier vertices of the same `glBegin` have been drawn.
    pub(crate) continued: bool,
}

impl Stream {
    pub(crate) fn new(mode: u32, current: &Current, materials: Sides) -> Self {
        Self {
            mode,
            positions: Vec::new(),
            color: Varying::new(current.color),
            secondary: Varying::new(current.secondary),
            normal: Varying::new(current.normal),
            tex_coord: Varying::new(current.tex_coords[0]),
            more_tex_coords: std::array::from_fn(|unit| Varying::new(current.tex_coords[unit + 1])),
            more_vary: false,
            fog_coord: Varying::new(current.fog_coord),
            edge_flag: Varying::new(current.edge_flag),
            materials: vec![materials],
            material: Varying::new(0),
            continued: false,
        }
    }

    /// The vertices of arrays; what has no array is what is current.
    pub(crate) fn of_arrays(
        mode: u32,
        current: &Current,
        materials: Sides,
        fetched: Fetched,
    ) -> Self {
        let mut stream = Self::new(mode, current, materials);
        stream.positions = fetched.positions;
        stream.normal.replace(fetched.normals);
        stream.color.replace(fetched.colors);
        stream.secondary.replace(fetched.secondary);
        stream.edge_flag.replace(fetched.edge_flags);
        stream.fog_coord.replace(fetched.fog_coords);
        let mut of_units = fetched.tex_coords.into_iter();
        if let Some(coordinates) = of_units.next() {
            stream.tex_coord.replace(coordinates);
        }
        for (coordinates, values) in stream.more_tex_coords.iter_mut().zip(of_units) {
            stream.more_vary |= values.is_some();
            coordinates.replace(values);
        }
        stream
    }

    /// How many vertices there are.
    #[inline]
    pub(crate) fn len(&self) -> usize {
        self.positions.len()
    }

    /// Appends a vertex with the current attributes.
    #[inline]
    pub(crate) fn push(&mut self, position: [f32; 4]) {
        self.positions.push(position);
        self.color.push();
        self.secondary.push();
        self.normal.push();
        self.tex_coord.push();
        if self.more_vary {
            for coordinates in &mut self.more_tex_coords {
                coordinates.push();
            }
        }
        self.fog_coord.push();
        self.edge_flag.push();
        self.material.push();
    }

    /// Changes a unit's texture coordinates for the next vertices.
    #[inline]
    pub(crate) fn set_tex_coord(&mut self, unit: usize, coordinates: [f32; 4]) {
        let count = self.positions.len();
        match unit.checked_sub(1) {
            None => self.tex_coord.set(coordinates, count),
            Some(place) => {
                self.more_tex_coords[place].set(coordinates, count);
                self.more_vary |= self.more_tex_coords[place].varies();
            }
        }
    }

    /// A vertex's texture coordinates of a unit.
    #[inline(always)]
    pub(crate) fn tex_coord_of(&self, unit: usize, vertex: usize) -> [f32; 4] {
        match unit.checked_sub(1) {
            None => self.tex_coord.of(vertex),
            Some(place) => self.more_tex_coords[place].of(vertex),
        }
    }

    /// Changes the material for the next vertices.
    pub(crate) fn set_materials(&mut self, sides: Sides) {
        if self.materials.last() == Some(&sides) {
            return;
        }
        if self.positions.is_empty() {
            self.materials = vec![sides];
            return;
        }
        self.materials.push(sides);
        self.material.set(self.materials.len() as u32 - 1, self.positions.len());
    }

    /// Forgets vertices that have been drawn, all before `first`.
    pub(crate) fn keep_from(&mut self, first: usize) {
        self.positions.drain(..first);
        self.color.keep_from(first);
        self.secondary.keep_from(first);
        self.normal.keep_from(first);
        self.tex_coord.keep_from(first);
        for coordinates in &mut self.more_tex_coords {
            coordinates.keep_from(first);
        }
        self.fog_coord.keep_from(first);
        self.edge_flag.keep_from(first);
        self.material.keep_from(first);
        self.continued = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enums as gl;

    #[test]
    fn section_2_7_each_vertex_keeps_the_values_that_were_current_when_it_came() {
        let mut stream = Stream::new(gl::POINTS, &Current::default(), Sides::default());
        stream.color.set([0.5; 4], stream.len());
        stream.push([0.0; 4]);
        stream.push([1.0; 4]);
        stream.color.set([0.25; 4], stream.len());
        stream.normal.set([1.0, 0.0, 0.0], stream.len());
        stream.push([2.0; 4]);
        let colors = [0, 1, 2].map(|vertex| stream.color.of(vertex)[0]);
        assert_eq!(colors, [0.5, 0.5, 0.25]);
        assert_eq!([stream.normal.of(0)[2], stream.normal.of(2)[0]], [1.0, 1.0]);
        assert!(!stream.edge_flag.varies());
    }
}
