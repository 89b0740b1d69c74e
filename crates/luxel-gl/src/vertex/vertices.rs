//! Vertices as commands give them: positions, and the attributes that were current at each.

use super::column::{Bits, Column};
use super::view::{Values, VertexView};
use crate::limits::TEXTURE_UNITS;
use crate::state::current::Current;

/// A run of vertices. In a display list attributes may be unknown that nobody has set before a vertex.
#[derive(Clone, Debug, Default)]
pub(crate) struct Vertices {
    pub(crate) positions: Vec<[f32; 4]>,
    pub(crate) color: Column<[f32; 4]>,
    pub(crate) secondary: Column<[f32; 3]>,
    pub(crate) normal: Column<[f32; 3]>,
    pub(crate) fog_coord: Column<f32>,
    pub(crate) edge_flag: Column<bool>,
    /// Of the units up to the last one that has any.
    tex_coords: Vec<Column<[f32; 4]>>,
    /// The attributes that vary, a bit each.
    varying: u32,
    /// Whether an attribute was set.
    has_attributes: bool,
}

/// Bits of attributes; units follow from `UNITS` on.
const COLOR: u32 = 1;
const SECONDARY: u32 = 2;
const NORMAL: u32 = 4;
const FOG_COORD: u32 = 8;
const EDGE_FLAG: u32 = 16;
const UNITS: u32 = 5;

/// Does the same to every attribute.
macro_rules! each_column {
    ($vertices:ident, $column:ident => $work:expr) => {
        let $column = &mut $vertices.color;
        $work;
        let $column = &mut $vertices.secondary;
        $work;
        let $column = &mut $vertices.normal;
        $work;
        let $column = &mut $vertices.fog_coord;
        $work;
        let $column = &mut $vertices.edge_flag;
        $work;
        for $column in &mut $vertices.tex_coords {
            $work;
        }
    };
}

impl Vertices {
    /// Begins a run anew, with what is current.
    pub(crate) fn restart(&mut self, current: &Current) {
        self.positions.clear();
        self.varying = 0;
        self.has_attributes = true;
        self.color.restart(current.color);
        self.secondary.restart(current.secondary);
        self.normal.restart(current.normal);
        self.fog_coord.restart(current.fog_coord);
        self.edge_flag.restart(current.edge_flag);
        self.tex_coords.resize_with(TEXTURE_UNITS, Column::default);
        for (column, coordinates) in self.tex_coords.iter_mut().zip(current.tex_coords) {
            column.restart(coordinates);
        }
    }

    /// How many vertices there are.
    #[inline]
    pub(crate) fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// Whether there are neither vertices nor attributes.
    pub(crate) fn is_untouched(&self) -> bool {
        self.is_empty() && !self.has_attributes
    }

    /// Appends a vertex, in the usual case: no other attribute than the normal varies, and there is room for it below a
    /// limit. False in others, and nothing is done.
    #[inline(always)]
    pub(crate) fn push_usual(&mut self, position: [f32; 4], limit: usize) -> bool {
        let room = self.positions.capacity().min(limit);
        if self.positions.len() >= room || self.varying & !NORMAL != 0 {
            return false;
        }
        self.positions.push(position);
        self.normal.push();
        true
    }

    /// Appends a vertex with the attributes of now.
    pub(crate) fn push(&mut self, position: [f32; 4]) {
        self.positions.push(position);
        if self.varying != 0 {
            self.push_attributes();
        }
    }

    fn push_attributes(&mut self) {
        self.normal.push();
        if self.varying == NORMAL {
            return;
        }
        self.color.push();
        self.secondary.push();
        self.fog_coord.push();
        self.edge_flag.push();
        for unit in luxel_math::lanes_of(self.varying >> UNITS) {
            self.tex_coords[unit].push();
        }
    }

    /// Finds out which attributes vary.
    fn note_varying(&mut self) {
        let columns = [
            self.color.varies(),
            self.secondary.varies(),
            self.normal.varies(),
            self.fog_coord.varies(),
            self.edge_flag.varies(),
        ];
        let units = self.tex_coords.iter().map(Column::varies);
        let all = columns.into_iter().chain(units).enumerate();
        self.varying = all.fold(0, |bits, (at, varies)| bits | u32::from(varies) << at);
    }

    #[inline]
    pub(crate) fn set_color(&mut self, color: [f32; 4]) {
        self.color.set(color, self.positions.len());
        if self.color.varies() {
            self.varying |= COLOR;
        }
        self.has_attributes = true;
    }

    pub(crate) fn set_secondary(&mut self, color: [f32; 3]) {
        self.secondary.set(color, self.positions.len());
        if self.secondary.varies() {
            self.varying |= SECONDARY;
        }
        self.has_attributes = true;
    }

    #[inline]
    pub(crate) fn set_normal(&mut self, normal: [f32; 3]) {
        self.normal.set(normal, self.positions.len());
        if self.normal.varies() {
            self.varying |= NORMAL;
        }
        self.has_attributes = true;
    }

    pub(crate) fn set_fog_coord(&mut self, coordinate: f32) {
        self.fog_coord.set(coordinate, self.positions.len());
        if self.fog_coord.varies() {
            self.varying |= FOG_COORD;
        }
        self.has_attributes = true;
    }

    pub(crate) fn set_edge_flag(&mut self, flag: bool) {
        self.edge_flag.set(flag, self.positions.len());
        if self.edge_flag.varies() {
            self.varying |= EDGE_FLAG;
        }
        self.has_attributes = true;
    }

    #[inline]
    pub(crate) fn set_tex_coord(&mut self, unit: usize, coordinates: [f32; 4]) {
        if unit >= self.tex_coords.len() {
            self.tex_coords.resize_with(unit + 1, Column::default);
        }
        let column = &mut self.tex_coords[unit];
        column.set(coordinates, self.positions.len());
        self.varying |= u32::from(column.varies()) << (UNITS + unit as u32);
        self.has_attributes = true;
    }

    /// Appends the vertices of a display list, and takes its attributes: what it hasn't set is what these have.
    pub(crate) fn append(&mut self, other: &Self) {
        let (count, more) = (self.len(), other.len());
        self.positions.extend_from_slice(&other.positions);
        self.color.append(count, &other.color, more);
        self.secondary.append(count, &other.secondary, more);
        self.normal.append(count, &other.normal, more);
        self.fog_coord.append(count, &other.fog_coord, more);
        self.edge_flag.append(count, &other.edge_flag, more);
        let unset = Column::default();
        for (unit, own) in self.tex_coords.iter_mut().enumerate() {
            own.append(count, other.tex_coords.get(unit).unwrap_or(&unset), more);
        }
        self.note_varying();
    }

    /// Takes the attributes of a display list that has no vertices for these.
    pub(crate) fn take_attributes(&mut self, other: &Self) {
        let count = self.len();
        self.color.take(count, &other.color);
        self.secondary.take(count, &other.secondary);
        self.normal.take(count, &other.normal);
        self.fog_coord.take(count, &other.fog_coord);
        self.edge_flag.take(count, &other.edge_flag);
        for (own, other) in self.tex_coords.iter_mut().zip(&other.tex_coords) {
            own.take(count, other);
        }
        self.note_varying();
    }

    /// Puts the attributes of now, as far as they have been set, into what is current.
    pub(crate) fn put_current(&self, current: &mut Current) {
        fn put<T: Copy>(column: &Column<T>, current: &mut T) {
            if let Some(now) = column.now() {
                *current = now;
            }
        }
        put(&self.color, &mut current.color);
        put(&self.secondary, &mut current.secondary);
        put(&self.normal, &mut current.normal);
        put(&self.fog_coord, &mut current.fog_coord);
        put(&self.edge_flag, &mut current.edge_flag);
        for (column, coordinates) in self.tex_coords.iter().zip(&mut current.tex_coords) {
            put(column, coordinates);
        }
    }

    /// Whether all attributes of a display list's vertices are known, or none of a kind.
    pub(super) fn is_known(&self) -> bool {
        self.color.is_known()
            && self.secondary.is_known()
            && self.normal.is_known()
            && self.fog_coord.is_known()
            && self.edge_flag.is_known()
            && self.tex_coords.iter().all(Column::is_known)
    }

    /// Whether two vertices are the same down to each bit.
    #[inline]
    pub(super) fn are_alike(&self, a: usize, b: usize) -> bool {
        self.positions[a].are_alike(&self.positions[b])
            && self.normal.are_alike(a, b)
            && self.color.are_alike(a, b)
            && self.secondary.are_alike(a, b)
            && self.fog_coord.are_alike(a, b)
            && self.edge_flag.are_alike(a, b)
            && self.tex_coords.iter().all(|column| column.are_alike(a, b))
    }

    /// Some vertices by their numbers, in any order. Attributes must be known, or none of a kind.
    pub(crate) fn gathered(&self, places: &[u32]) -> Self {
        Self {
            positions: places.iter().map(|&place| self.positions[place as usize]).collect(),
            color: self.color.gathered(places),
            secondary: self.secondary.gathered(places),
            normal: self.normal.gathered(places),
            fog_coord: self.fog_coord.gathered(places),
            edge_flag: self.edge_flag.gathered(places),
            tex_coords: self.tex_coords.iter().map(|column| column.gathered(places)).collect(),
            varying: self.varying,
            has_attributes: self.has_attributes,
        }
    }

    /// The vertices; attributes that the run itself has not set, as a display list's may be, are what is current.
    pub(crate) fn view(&self, current: &Current) -> VertexView<'_> {
        let of_unit = |unit: usize| {
            let now = current.tex_coords[unit];
            self.tex_coords
                .get(unit)
                .map_or(Values { of_all: now, of_each: None }, |column| column.view(now))
        };
        VertexView {
            positions: &self.positions,
            color: self.color.view(current.color),
            secondary: self.secondary.view(current.secondary),
            normal: self.normal.view(current.normal),
            fog_coord: self.fog_coord.view(current.fog_coord),
            edge_flag: self.edge_flag.view(current.edge_flag),
            tex_coords: std::array::from_fn(of_unit),
        }
    }

    /// Forgets all vertices and attributes, but not the room for them.
    pub(crate) fn clear(&mut self) {
        self.positions.clear();
        each_column!(self, column => column.clear());
        (self.varying, self.has_attributes) = (0, false);
    }

    /// Bytes that it has room for.
    pub(crate) fn bytes(&self) -> usize {
        self.positions.capacity() * size_of::<[f32; 4]>()
            + self.color.bytes()
            + self.secondary.bytes()
            + self.normal.bytes()
            + self.fog_coord.bytes()
            + self.edge_flag.bytes()
            + self.tex_coords.iter().map(Column::bytes).sum::<usize>()
    }

    /// Keeps the first vertices.
    pub(crate) fn truncate(&mut self, count: usize) {
        self.positions.truncate(count);
        each_column!(self, column => column.truncate(count));
    }

    /// Drops the first vertices.
    pub(crate) fn drop_first(&mut self, count: usize) {
        self.positions.drain(..count);
        each_column!(self, column => column.drop_first(count));
    }

    /// Gives back room that nobody needs.
    pub(crate) fn shrink(&mut self) {
        self.positions.shrink_to_fit();
        each_column!(self, column => column.shrink());
    }
}
