//! Vertices that are about to be drawn, wherever they are kept.

use super::columns::load_rows;
use super::fetch::Fetched;
use crate::limits::TEXTURE_UNITS;
use crate::state::current::Current;
use luxel_math::Lanes;

/// Vertices with all attributes; what isn't kept with them is what is current.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VertexView<'a> {
    pub(super) positions: &'a [[f32; 4]],
    pub(super) color: Values<'a, [f32; 4]>,
    pub(super) secondary: Values<'a, [f32; 3]>,
    pub(super) normal: Values<'a, [f32; 3]>,
    pub(super) fog_coord: Values<'a, f32>,
    pub(super) edge_flag: Values<'a, bool>,
    /// By unit.
    pub(super) tex_coords: [Values<'a, [f32; 4]>; TEXTURE_UNITS],
}

impl VertexView<'_> {
    /// How many vertices there are.
    pub(crate) fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }
}

/// One attribute: a value for each vertex, or one for all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Values<'a, T> {
    /// The value of all where there are no others.
    pub(super) of_all: T,
    pub(super) of_each: Option<&'a [T]>,
}

impl<'a, T: Copy> Values<'a, T> {
    /// Whether vertices have values of their own.
    #[inline]
    pub(super) fn varies(&self) -> bool {
        self.of_each.is_some()
    }

    /// The value of a vertex.
    #[inline(always)]
    pub(super) fn of(&self, vertex: usize) -> T {
        self.of_each.map_or(self.of_all, |values| values[vertex])
    }

    fn new(of_each: Option<&'a Vec<T>>, of_all: T) -> Self {
        Self { of_all, of_each: of_each.map(Vec::as_slice) }
    }
}

impl<const K: usize> Values<'_, [f32; K]> {
    /// The values of `count` vertices from `first` on, in lanes.
    #[inline(always)]
    pub(super) fn lanes<N: Lanes>(&self, simd: N, first: usize, count: usize) -> [N; K] {
        if let Some(values) = self.of_each {
            return load_rows(simd, values, first, count);
        }
        let mut lanes = [simd; K];
        for (lane, value) in lanes.iter_mut().zip(self.of_all) {
            *lane = simd.constant(value);
        }
        lanes
    }
}

impl Fetched {
    /// The vertices of arrays.
    pub(crate) fn view(&self, current: &Current) -> VertexView<'_> {
        let of_unit = |unit: usize| self.tex_coords.get(unit).and_then(Option::as_ref);
        VertexView {
            positions: &self.positions,
            color: Values::new(self.colors.as_ref(), current.color),
            secondary: Values::new(self.secondary.as_ref(), current.secondary),
            normal: Values::new(self.normals.as_ref(), current.normal),
            fog_coord: Values::new(self.fog_coords.as_ref(), current.fog_coord),
            edge_flag: Values::new(self.edge_flags.as_ref(), current.edge_flag),
            tex_coords: std::array::from_fn(|unit| {
                Values::new(of_unit(unit), current.tex_coords[unit])
            }),
        }
    }
}
