//! Evaluators: `glMap`, `glMapGrid`, `glEvalCoord`, `glEvalPoint`, `glEvalMesh` (OpenGL 1.5, section 5.1).

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::limits::STREAM_VERTICES;
use crate::objects::list::Command;
use crate::objects::map_calls::MapCall;
use crate::state::current::Current;
use crate::state::evaluator::{GridAxis, Map, MapTarget};
use crate::vertex::{VertexSource, Vertices, evaluator};
use std::borrow::Cow;

/// A value of an evaluator: a vertex, and what goes with it.
#[derive(Clone, Copy, Debug, Default)]
struct Evaluated {
    color: Option<[f32; 4]>,
    normal: Option<[f32; 3]>,
    tex_coord: Option<[f32; 4]>,
    vertex: Option<[f32; 4]>,
}

impl Context {
    /// `glMap1`: control points of a curve, `stride` numbers from one to the next.
    pub fn map_1(
        &mut self,
        target: u32,
        domain: [f64; 2],
        stride: i32,
        order: i32,
        points: &[f64],
    ) {
        self.map(&MapCall {
            target,
            dimensions: 1,
            domain: [domain, [0.0, 1.0]],
            stride: [stride, 0],
            order: [order, 1],
            points: points.into(),
        });
    }

    /// `glMap2`: control points of a surface; domains, strides and orders of u and v.
    pub fn map_2(
        &mut self,
        target: u32,
        domain: [[f64; 2]; 2],
        stride: [i32; 2],
        order: [i32; 2],
        points: &[f64],
    ) {
        self.map(&MapCall { target, dimensions: 2, domain, stride, order, points: points.into() });
    }

    pub(super) fn map(&mut self, call: &MapCall) {
        compile!(self, Command::Map(Box::new(call.clone())));
        outside_begin!(self);
        let Some(target) =
            MapTarget::named(call.target).filter(|of| of.dimensions == call.dimensions)
        else {
            self.error.set(gl::INVALID_ENUM);
            return;
        };
        let used = &call.domain[..call.dimensions];
        let is_domain = used.iter().all(|[from, to]| from != to && (to - from).is_finite());
        let length = target.length(call.stride, call.order);
        demand!(self, is_domain && length > 0, gl::INVALID_VALUE);
        demand!(self, self.state.active_texture == 0, gl::INVALID_OPERATION);
        let order = call.order.map(|order| order as usize);
        let stride = call.stride.map(|stride| stride as usize);
        let components = target.components();
        let mut points = Vec::with_capacity(order[0] * order[1]);
        for u in 0..order[0] {
            for v in 0..order[1] {
                let mut point = [0.0, 0.0, 0.0, 1.0];
                for (axis, value) in point[..components].iter_mut().enumerate() {
                    let place = u * stride[0] + v * stride[1] + axis;
                    *value = call.points.get(place).copied().unwrap_or(0.0);
                }
                points.push(point);
            }
        }
        self.maps.set(target, Map { order, domain: call.domain, points });
    }

    /// `glMapGrid1`: steps that part a domain.
    pub fn map_grid_1(&mut self, steps: i32, domain: [f32; 2]) {
        compile!(self, Command::MapGrid1(steps, domain));
        outside_begin!(self);
        demand!(self, steps >= 1, gl::INVALID_VALUE);
        self.state.grids.one = GridAxis { steps, domain };
    }

    /// `glMapGrid2`: steps and domains of u and v.
    pub fn map_grid_2(&mut self, steps: [i32; 2], domain: [[f32; 2]; 2]) {
        compile!(self, Command::MapGrid2(steps, domain));
        outside_begin!(self);
        demand!(self, steps.iter().all(|steps| *steps >= 1), gl::INVALID_VALUE);
        self.state.grids.two =
            [0, 1].map(|axis| GridAxis { steps: steps[axis], domain: domain[axis] });
    }

    /// What the enabled maps of one or two dimensions are at a place.
    fn evaluated(&self, place: [f32; 2], dimensions: usize) -> Evaluated {
        let first = if dimensions == 1 { gl::MAP1_COLOR_4 } else { gl::MAP2_COLOR_4 };
        let enabled = |kind: u32| self.state.enables.get(first + kind, 0) == Some(true);
        let place = place.map(f64::from);
        let map = |kind: u32| self.maps.get(MapTarget { dimensions, kind: kind as usize });
        let value = |kind: u32| {
            if dimensions == 1 {
                (evaluator::value_1(map(kind), place[0]), [[0.0; 4]; 2])
            } else {
                evaluator::value_2(map(kind), place)
            }
        };
        let narrow = |value: [f64; 4]| value.map(|value| value as f32);
        // Of several kinds the one of most components counts.
        let last_of = |kinds: std::ops::Range<u32>| kinds.rev().find(|kind| enabled(*kind));
        let mut evaluated = Evaluated {
            color: enabled(0).then(|| narrow(value(0).0)),
            normal: enabled(2).then(|| {
                let [x, y, z, _] = narrow(value(2).0);
                [x, y, z]
            }),
            tex_coord: last_of(3..7).map(|kind| narrow(value(kind).0)),
            vertex: None,
        };
        if let Some(kind) = last_of(7..9) {
            let (vertex, slopes) = value(kind);
            evaluated.vertex = Some(narrow(vertex));
            if dimensions == 2 && self.state.enables.has(gl::AUTO_NORMAL) {
                evaluated.normal = Some(evaluator::normal(vertex, slopes, map(kind).domain));
            }
        }
        evaluated
    }

    /// A vertex of the enabled maps between `glBegin` and `glEnd`; elsewhere it has no effect.
    fn evaluate(&mut self, place: [f32; 2], dimensions: usize) {
        if !self.stream.is_open() {
            return;
        }
        if self.stream.vertices.len() < STREAM_VERTICES {
            let evaluated = self.evaluated(place, dimensions);
            append(&mut self.stream.vertices, &evaluated, &self.state.current);
        } else {
            self.error.set(gl::OUT_OF_MEMORY);
        }
    }

    /// `glEvalCoord1`
    pub fn eval_coord_1(&mut self, u: f32) {
        compile!(self, Command::EvalCoord1(u));
        self.evaluate([u, 0.0], 1);
    }

    /// `glEvalCoord2`
    pub fn eval_coord_2(&mut self, place: [f32; 2]) {
        compile!(self, Command::EvalCoord2(place));
        self.evaluate(place, 2);
    }

    /// `glEvalPoint1`: at a step of the grid.
    pub fn eval_point_1(&mut self, step: i32) {
        compile!(self, Command::EvalPoint1(step));
        self.evaluate([self.state.grids.one.at(step), 0.0], 1);
    }

    /// `glEvalPoint2`: at steps of the grid.
    pub fn eval_point_2(&mut self, steps: [i32; 2]) {
        compile!(self, Command::EvalPoint2(steps));
        self.evaluate(self.on_grid(steps), 2);
    }

    fn on_grid(&self, [i, j]: [i32; 2]) -> [f32; 2] {
        let [u, v] = &self.state.grids.two;
        [u.at(i), v.at(j)]
    }

    /// Draws vertices of maps.
    fn draw_evaluated(
        &mut self,
        mode: u32,
        dimensions: usize,
        places: impl Iterator<Item = [f32; 2]>,
    ) {
        let mut vertices = Vertices::default();
        vertices.restart(&self.state.current);
        for place in places {
            append(&mut vertices, &self.evaluated(place, dimensions), &self.state.current);
        }
        self.draw_vertices(VertexSource::Run(mode, Cow::Owned(vertices)));
    }

    /// `glEvalMesh1`: points, or a line, of a run of the grid. `GL_INVALID_ENUM` for other modes, `GL_OUT_OF_MEMORY`
    /// for more vertices than a stream has.
    pub fn eval_mesh_1(&mut self, mode: u32, [first, last]: [i32; 2]) {
        compile!(self, Command::EvalMesh1(mode, [first, last]));
        outside_begin!(self);
        let primitive = match mode {
            gl::POINT => gl::POINTS,
            gl::LINE => gl::LINE_STRIP,
            _ => return self.error.set(gl::INVALID_ENUM),
        };
        let count = i64::from(last) - i64::from(first) + 1;
        demand!(self, count <= STREAM_VERTICES as i64, gl::OUT_OF_MEMORY);
        let grid = self.state.grids.one;
        self.draw_evaluated(primitive, 1, (first..=last).map(|step| [grid.at(step), 0.0]));
    }

    /// `glEvalMesh2`: points, lines along both axes, or strips of quadrilaterals, of a part of the grid.
    pub fn eval_mesh_2(&mut self, mode: u32, [i1, i2]: [i32; 2], [j1, j2]: [i32; 2]) {
        compile!(self, Command::EvalMesh2(mode, Box::new([i1, i2, j1, j2])));
        outside_begin!(self);
        demand!(self, matches!(mode, gl::POINT | gl::LINE | gl::FILL), gl::INVALID_ENUM);
        let length = |from: i32, to: i32| (i128::from(to) - i128::from(from) + 1).max(0);
        let count = length(i1, i2) * length(j1, j2);
        demand!(self, count <= STREAM_VERTICES as i128, gl::OUT_OF_MEMORY);
        if count == 0 {
            return;
        }
        let [u, v] = self.state.grids.two;
        match mode {
            gl::POINT => {
                let places = (j1..=j2).flat_map(|j| (i1..=i2).map(move |i| [u.at(i), v.at(j)]));
                self.draw_evaluated(gl::POINTS, 2, places);
            }
            gl::LINE => {
                for j in j1..=j2 {
                    let places = (i1..=i2).map(|i| [u.at(i), v.at(j)]);
                    self.draw_evaluated(gl::LINE_STRIP, 2, places);
                }
                for i in i1..=i2 {
                    let places = (j1..=j2).map(|j| [u.at(i), v.at(j)]);
                    self.draw_evaluated(gl::LINE_STRIP, 2, places);
                }
            }
            _ => {
                for j in j1..j2 {
                    let places =
                        (i1..=i2).flat_map(|i| [[u.at(i), v.at(j)], [u.at(i), v.at(j + 1)]]);
                    self.draw_evaluated(gl::QUAD_STRIP, 2, places);
                }
            }
        }
    }

    /// `glGetMap`: `GL_COEFF`, `GL_ORDER` or `GL_DOMAIN` of a map.
    pub fn get_map(&mut self, target: u32, query: u32) -> Option<Vec<f64>> {
        outside_begin!(self, None);
        let values = MapTarget::named(target).and_then(|target| {
            let map = self.maps.get(target);
            Some(match query {
                gl::COEFF => {
                    let of = |point: &[f64; 4]| point[..target.components()].to_vec();
                    map.points.iter().flat_map(of).collect()
                }
                gl::ORDER => {
                    map.order[..target.dimensions].iter().map(|order| *order as f64).collect()
                }
                gl::DOMAIN => map.domain[..target.dimensions].concat(),
                _ => return None,
            })
        });
        if values.is_none() {
            self.error.set(gl::INVALID_ENUM);
        }
        values
    }
}

/// Appends a value of maps; attributes that no map has are the current ones, and stay as they are.
fn append(vertices: &mut Vertices, evaluated: &Evaluated, current: &Current) {
    let Some(vertex) = evaluated.vertex else { return };
    vertices.set_color(evaluated.color.unwrap_or(current.color));
    vertices.set_normal(evaluated.normal.unwrap_or(current.normal));
    vertices.set_tex_coord(0, evaluated.tex_coord.unwrap_or(current.tex_coords[0]));
    vertices.push(vertex);
    vertices.set_color(current.color);
    vertices.set_normal(current.normal);
    vertices.set_tex_coord(0, current.tex_coords[0]);
}
