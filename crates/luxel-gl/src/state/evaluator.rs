//! Evaluators: control points of curves and surfaces, and grids over their domains (OpenGL 1.5, section 5.1).

use crate::enums as gl;
use crate::limits::EVALUATOR_ORDER;

/// Kinds of values that a map has: colours, indices, normals, four of texture coordinates, two of vertices.
pub(crate) const KINDS: usize = 9;

/// Components of each kind.
const COMPONENTS: [usize; KINDS] = [4, 1, 3, 1, 2, 3, 4, 3, 4];

/// Which map: dimensions from 1 on, and the kind of its values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct MapTarget {
    pub(crate) dimensions: usize,
    pub(crate) kind: usize,
}

impl MapTarget {
    /// The map of a name; `None` if there is none.
    pub(crate) fn named(name: u32) -> Option<Self> {
        [gl::MAP1_COLOR_4, gl::MAP2_COLOR_4].into_iter().zip(1..).find_map(|(first, dimensions)| {
            let kind = name.wrapping_sub(first) as usize;
            (kind < KINDS).then_some(Self { dimensions, kind })
        })
    }

    /// Components of a point.
    pub(crate) fn components(self) -> usize {
        COMPONENTS[self.kind]
    }

    /// Numbers from the first to the last of control points with strides and orders; 0 for values that are in error.
    pub(crate) fn length(self, stride: [i32; 2], order: [i32; 2]) -> usize {
        let mut length = self.components();
        for axis in 0..self.dimensions {
            let is_order = (1..=EVALUATOR_ORDER).contains(&order[axis]);
            let Ok(stride) = usize::try_from(stride[axis]) else { return 0 };
            if !is_order || stride < self.components() {
                return 0;
            }
            length = length.saturating_add((order[axis] as usize - 1).saturating_mul(stride));
        }
        length
    }
}

/// The control points of one map.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Map {
    /// One more than the degree, in u and v.
    pub(crate) order: [usize; 2],
    /// From and to, in u and v.
    pub(crate) domain: [[f64; 2]; 2],
    /// Points along v within those along u; what a kind lacks of four components is 0 and, last, 1.
    pub(crate) points: Vec<[f64; 4]>,
}

/// All maps.
#[derive(Clone, Debug)]
pub(crate) struct Maps {
    maps: Vec<Map>,
}

impl Default for Maps {
    fn default() -> Self {
        let point = |kind: usize| match kind {
            0 | 1 => [1.0; 4],
            2 => [0.0, 0.0, 1.0, 1.0],
            _ => [0.0, 0.0, 0.0, 1.0],
        };
        let map = |number: usize| Map {
            order: [1; 2],
            domain: [[0.0, 1.0]; 2],
            points: vec![point(number % KINDS)],
        };
        Self { maps: (0..2 * KINDS).map(map).collect() }
    }
}

impl Maps {
    pub(crate) fn get(&self, target: MapTarget) -> &Map {
        &self.maps[(target.dimensions - 1) * KINDS + target.kind]
    }

    pub(crate) fn set(&mut self, target: MapTarget, map: Map) {
        self.maps[(target.dimensions - 1) * KINDS + target.kind] = map;
    }
}

/// One axis of a grid: steps, and the domain that they part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GridAxis {
    pub(crate) steps: i32,
    pub(crate) domain: [f32; 2],
}

impl Default for GridAxis {
    fn default() -> Self {
        Self { steps: 1, domain: [0.0, 1.0] }
    }
}

impl GridAxis {
    /// The coordinate of a step; the first and the last one exactly.
    pub(crate) fn at(&self, step: i32) -> f32 {
        let [from, to] = self.domain;
        if step == 0 {
            from
        } else if step == self.steps {
            to
        } else {
            step as f32 * ((to - from) / self.steps as f32) + from
        }
    }
}

/// The grids of one and of two dimensions: what `GL_EVAL_BIT` saves beside enables.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Grids {
    pub(crate) one: GridAxis,
    pub(crate) two: [GridAxis; 2],
}
