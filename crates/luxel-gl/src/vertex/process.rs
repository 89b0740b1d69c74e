//! Vertices through transform and lighting, sixteen at a time (OpenGL 1.5, sections 2.10 to 2.13).

use super::columns::{load_rows, store};
use super::light_vertices::{LitPlace, VertexLighting};
use super::materials::Materials;
use super::matrix_rows::MatrixRows;
use super::processed::{Lists, Processed, ProcessedRun, WindowScale, codes};
use super::texgen::{CoordinateSetup, VertexPlace};
use super::used::UsedVertices;
use super::view::VertexView;
use crate::enums as gl;
use crate::limits::CLIP_PLANES;
use crate::state::Attributes;
use crate::state::matrices::Matrices;
use glam::DMat4;
use luxel_math::{LANES, Lanes, Level, Mask, Rgb, Vec3, dispatch_long, f32x16, prelude::*};
use luxel_visibility::{GUARD_BAND, WindowVertex, snap};
use std::ops::Range;

/// Vertices that one thread takes at a time.
const RUN: usize = 4096;

/// How normals get their length.
#[derive(Clone, Copy, Debug, PartialEq)]
enum NormalLength {
    Kept,
    /// By one factor for all (`GL_RESCALE_NORMAL`).
    Scaled(f32),
    /// To 1 each (`GL_NORMALIZE`).
    Unit,
}

/// What a draw takes of its vertices, beside their clip coordinates.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Needs {
    /// Where they lie in the window, and which have no place there ([`codes::NOT_HELD`]).
    pub(crate) window: bool,
    /// Eye coordinates.
    pub(crate) eye: bool,
    /// Colours, and what fog takes.
    pub(crate) colors: bool,
    /// Texture coordinates of some units, a bit each.
    pub(crate) textures: u32,
}

/// What is written of a draw's vertices: their places, which decide what is drawn; colours and what else fragments
/// take.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Pass<'u> {
    Both,
    Places,
    /// After their places, of those alone that are used.
    Shades(&'u UsedVertices),
}

impl Pass<'_> {
    /// The first one, and the only one unless others take note of what is used.
    pub(crate) fn first(used: Option<&UsedVertices>) -> Self {
        if used.is_some() { Self::Places } else { Self::Both }
    }

    fn writes_places(&self) -> bool {
        !matches!(self, Self::Shades(_))
    }

    /// Whether sixteen vertices are shaded, the first of which is the first of a group.
    #[inline]
    fn shades(&self, first: usize) -> bool {
        match self {
            Self::Both => true,
            Self::Places => false,
            Self::Shades(used) => used.has(first),
        }
    }
}

/// What vertices are processed by: the state of one draw.
#[derive(Debug)]
pub(crate) struct VertexProcessor {
    eye_from_object: MatrixRows,
    clip_from_object: MatrixRows,
    /// The inverse transpose of the modelview matrix.
    normal: MatrixRows,
    normal_length: NormalLength,
    scale: WindowScale,
    lighting: Option<VertexLighting>,
    /// Whether secondary colours are summed (`GL_COLOR_SUM`).
    color_sum: bool,
    /// The user's planes that are enabled, with their numbers.
    planes: Vec<(u32, [f32; 4])>,
    /// Whether fog takes coordinates of its own rather than distances; `None` without fog.
    fog_from_coordinates: Option<bool>,
    needs: Needs,
    /// Of the units whose texture coordinates are needed.
    textures: Vec<CoordinateSetup>,
}

impl VertexProcessor {
    pub(crate) fn new(
        state: &Attributes,
        matrices: &Matrices,
        scale: WindowScale,
        mut needs: Needs,
    ) -> Self {
        let enables = &state.enables;
        let planes = (0..CLIP_PLANES as u32).filter(|number| enables.planes() >> number & 1 == 1);
        let plane = |number: u32| state.transform.planes[number as usize].map(|value| value as f32);
        needs.eye |= enables.planes() != 0;
        let is_lit = needs.colors && enables.has(gl::LIGHTING);
        let textures = CoordinateSetup::of_units(state, matrices, needs.textures);
        let needs_normal = is_lit || textures.iter().any(CoordinateSetup::needs_normal);
        let modelview = matrices.modelview.top;
        let (normal, normal_length) =
            if needs_normal { normals(state, &modelview) } else { (modelview, NormalLength::Unit) };
        Self {
            eye_from_object: MatrixRows::new(&modelview),
            clip_from_object: MatrixRows::new(&matrices.clip_from_object()),
            normal: MatrixRows::new(&normal),
            normal_length,
            scale,
            lighting: is_lit.then(|| VertexLighting::new(state)),
            color_sum: enables.has(gl::COLOR_SUM),
            planes: planes.map(|number| (number, plane(number))).collect(),
            fog_from_coordinates: (needs.colors && enables.has(gl::FOG))
                .then_some(state.fog.source == gl::FOG_COORD),
            needs,
            textures,
        }
    }

    /// Whether vertices are lit.
    pub(crate) fn lights(&self) -> bool {
        self.lighting.is_some()
    }

    /// The lists that vertices are written to.
    pub(crate) fn lists(&self) -> Lists {
        let lit = self.lighting.as_ref();
        let sides = lit.map_or(1, VertexLighting::sides);
        let separate = lit.map_or(self.color_sum, VertexLighting::is_separate);
        let textures = self.textures.iter().fold(0, |units, setup| units | 1 << setup.unit);
        Lists {
            window: self.needs.window,
            eye: self.needs.eye,
            colors: if self.needs.colors { sides } else { 0 },
            secondary: if self.needs.colors && separate { sides } else { 0 },
            fog_coord: self.fog_from_coordinates.is_some(),
            textures,
        }
    }

    /// Writes what becomes of the vertices of a draw.
    pub(crate) fn process(
        &self,
        (vertices, materials): (&VertexView<'_>, &Materials),
        pass: Pass<'_>,
        level: Level,
        processed: &mut Processed,
    ) {
        if pass.writes_places() {
            processed.resize(vertices.len(), &self.lists());
            processed.put_edge_flags(vertices);
        }
        let runs = processed.runs(RUN);
        luxel_parallel::each(runs.into_iter(), &|mut run: ProcessedRun<'_>| {
            dispatch_long!(level, simd => {
                let lanes = f32x16::splat(simd, 0.0);
                self.run(lanes, (vertices, materials), pass, &mut run);
            });
        });
    }

    /// A run of vertices; `simd` selects the lane type.
    #[inline(always)]
    fn run<N: Lanes>(
        &self,
        simd: N,
        from: (&VertexView<'_>, &Materials),
        pass: Pass<'_>,
        out: &mut ProcessedRun<'_>,
    ) {
        let count = out.clip.len();
        for start in (0..count).step_by(LANES) {
            let sixteen = start..count.min(start + LANES);
            let position = load_rows(simd, from.0.positions, out.first + start, sixteen.len());
            if pass.writes_places() {
                self.place(position, sixteen.clone(), out);
            }
            if pass.shades(out.first + start) {
                self.shade(position, from, sixteen, out);
            }
        }
    }

    /// Where up to sixteen vertices of a run lie.
    #[inline(always)]
    fn place<N: Lanes>(&self, position: [N; 4], run: Range<usize>, out: &mut ProcessedRun<'_>) {
        let simd = position[0];
        let clip = self.clip_from_object.times(position);
        store(&clip, &mut out.clip[run.clone()]);
        let held = match self.needs.window {
            true => self.window(clip, &mut out.window[run.clone()]),
            false => u32::MAX,
        };
        let mut codes = self.codes(clip, held);
        if self.needs.eye {
            let eye = self.eye_from_object.times(position);
            store(&eye, &mut out.eye[run.clone()]);
            for &(number, [a, b, c, d]) in &self.planes {
                let [x, y, z, w] = eye;
                let distance = x * simd.constant(a)
                    + y * simd.constant(b)
                    + z * simd.constant(c)
                    + w * simd.constant(d);
                let beyond = distance.less(simd.zero()).bits();
                spread(beyond, codes::FIRST_PLANE + number, &mut codes);
            }
        }
        let count = run.len();
        out.codes[run].copy_from_slice(&codes[..count]);
    }

    /// What fragments take of up to sixteen vertices of a run.
    #[inline(always)]
    fn shade<N: Lanes>(
        &self,
        position: [N; 4],
        (vertices, materials): (&VertexView<'_>, &Materials),
        run: Range<usize>,
        out: &mut ProcessedRun<'_>,
    ) {
        let simd = position[0];
        let (first, count) = (out.first + run.start, run.len());
        // Lanes beyond the last vertex repeat it.
        let at = |lane: usize| first + lane.min(count - 1);
        let needs_eye = self.lighting.is_some()
            || self.fog_from_coordinates == Some(false)
            || self.textures.iter().any(CoordinateSetup::needs_eye);
        let eye = if needs_eye { self.eye_from_object.times(position) } else { position };
        match self.fog_from_coordinates {
            Some(true) => {
                for (lane, coordinate) in out.fog_coord[run.clone()].iter_mut().enumerate() {
                    *coordinate = vertices.fog_coord.of(first + lane);
                }
            }
            Some(false) => {
                let mut distances = [0.0; LANES];
                eye[2].abs().store(&mut distances, 0);
                out.fog_coord[run.clone()].copy_from_slice(&distances[..count]);
            }
            None => {}
        }
        if !self.textures.is_empty() {
            let mut place =
                VertexPlace { object: position, eye, normal: Vec3::splat(simd, [0.0; 3]) };
            if self.textures.iter().any(CoordinateSetup::needs_normal) {
                let (unit, length) = self.normal(vertices.normal.lanes(simd, first, count));
                place.normal = length.map_or(unit, |length| unit * length);
            }
            for setup in &self.textures {
                let given = vertices.tex_coords[setup.unit].lanes(simd, first, count);
                let coordinates = setup.coordinates(&place, given);
                store(&coordinates, &mut out.tex_coords[setup.unit][run.clone()]);
            }
        }
        if !self.needs.colors {
            return;
        }
        let Some(lighting) = &self.lighting else {
            let color = vertices.color.lanes(simd, first, count);
            store(&clamped(color), &mut out.colors[0][run.clone()]);
            if self.color_sum {
                let [r, g, b] = vertices.secondary.lanes(simd, first, count);
                store(&clamped([r, g, b, simd.zero()]), &mut out.secondary[0][run]);
            }
            return;
        };
        let (normal, length) = self.normal(vertices.normal.lanes(simd, first, count));
        let place = LitPlace { eye, normal, length };
        for side in 0..lighting.sides() {
            let lit = lighting.lit(&place, side, (vertices, materials), at);
            let Rgb { r, g, b } = lit.sums.primary;
            store(&clamped([r, g, b, lit.alpha]), &mut out.colors[side][run.clone()]);
            if lighting.is_separate() {
                let Rgb { r, g, b } = lit.sums.specular;
                store(&clamped([r, g, b, simd.zero()]), &mut out.secondary[side][run.clone()]);
            }
        }
    }

    /// The normal in eye coordinates, of unit length; and what length it has by the specification, `None` for 1.
    #[inline(always)]
    fn normal<N: Lanes>(&self, normal: [N; 3]) -> (Vec3<N>, Option<N>) {
        let [x, y, z] = self.normal.times_direction(normal);
        let vector = Vec3::new(x, y, z);
        let unit = vector.normalized_or_zero();
        match self.normal_length {
            NormalLength::Unit => (unit, None),
            NormalLength::Scaled(factor) => (unit, Some(vector.length() * x.constant(factor))),
            NormalLength::Kept => (unit, Some(vector.length())),
        }
    }

    /// Writes where vertices lie in the window; which of them have a place there.
    #[inline(always)]
    fn window<N: Lanes>(&self, [x, y, z, w]: [N; 4], out: &mut [WindowVertex]) -> u32 {
        let WindowScale { half, centre, depth, .. } = self.scale;
        let mut held = w.zero().less(w);
        let (across, within) = held_at(x, w, half[0], centre[0]);
        held = held & within;
        let (up, within) = held_at(y, w, half[1], centre[1]);
        held = held & within;
        let depths = z / w * w.constant(depth[0]) + w.constant(depth[1]);
        let ([mut xs, mut ys], mut zs) = ([[0; LANES]; 2], [0.0; LANES]);
        across.store_whole(&mut xs, 0);
        up.store_whole(&mut ys, 0);
        depths.store(&mut zs, 0);
        for (lane, vertex) in out.iter_mut().enumerate().take(LANES) {
            let [x, y] = [xs[lane], ys[lane]].map(u32::cast_signed);
            *vertex = WindowVertex { x, y, z: zs[lane] };
        }
        held.bits()
    }

    /// Clip codes of sixteen vertices.
    #[inline(always)]
    fn codes<N: Lanes>(&self, [x, y, z, w]: [N; 4], held: u32) -> [u16; LANES] {
        let mut all = [0; LANES];
        spread(x.less(-w).bits(), 0, &mut all);
        spread(w.less(x).bits(), 1, &mut all);
        spread(y.less(-w).bits(), 2, &mut all);
        spread(w.less(y).bits(), 3, &mut all);
        spread(z.less(w * w.constant(self.scale.nearest)).bits(), 4, &mut all);
        spread(w.less(z).bits(), 5, &mut all);
        let not_finite = !(finite(x) & finite(y) & finite(z) & finite(w)).bits();
        spread(not_finite, codes::NOT_FINITE.trailing_zeros(), &mut all);
        spread(!held, codes::NOT_HELD.trailing_zeros(), &mut all);
        all
    }
}

/// What takes normals to eye coordinates, and how they get their length there.
fn normals(state: &Attributes, modelview: &DMat4) -> (DMat4, NormalLength) {
    let inverse = modelview.inverse();
    let sound = inverse.is_finite();
    let normal = if sound { inverse.transpose() } else { *modelview };
    let length = if state.enables.has(gl::NORMALIZE) {
        NormalLength::Unit
    } else if state.enables.has(gl::RESCALE_NORMAL) {
        let third = inverse.row(2).truncate().length();
        let factor = if sound && third > 0.0 { 1.0 / third } else { 1.0 };
        NormalLength::Scaled(factor as f32)
    } else {
        NormalLength::Kept
    };
    (normal, length)
}

/// Puts a bit for each lane into the codes.
#[inline(always)]
fn spread(lanes: u32, bit: u32, codes: &mut [u16; LANES]) {
    if lanes & 0xffff != 0 {
        for (lane, code) in codes.iter_mut().enumerate() {
            *code |= ((lanes >> lane & 1) as u16) << bit;
        }
    }
}

/// Where a coordinate lies in the window, in steps of 1/256 pixel, and whether that is within the guard band.
#[inline(always)]
fn held_at<N: Lanes>(value: N, w: N, half: f32, centre: f32) -> (N, N::Mask) {
    let at = snap(value * w.constant(half), w, centre);
    let guard = GUARD_BAND as f32;
    let above = w.constant(centre - guard).less_or_equal(at);
    (at, above & at.less_or_equal(w.constant(centre + guard)))
}

#[inline(always)]
fn finite<N: Lanes>(value: N) -> N::Mask {
    value.abs().less_or_equal(value.constant(f32::MAX))
}

/// Within 0 and 1.
#[inline(always)]
fn clamped<N: Lanes>([r, g, b, a]: [N; 4]) -> [N; 4] {
    [r.clamped(0.0, 1.0), g.clamped(0.0, 1.0), b.clamped(0.0, 1.0), a.clamped(0.0, 1.0)]
}
