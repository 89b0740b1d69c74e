//! Vertices through transform and lighting, sixteen at a time (OpenGL 1.5, sections 2.10 to 2.13).
//!
//! Lighting is luxel's equation with the eye at the origin, in eye coordinates. A normal that nobody brings to unit
//! length scales what it reflects, as the specification's formula has it: |N| the diffuse and |N|^n the specular term.

use super::light_setup::{LightSetup, SeparateSums, material};
use super::matrix_rows::MatrixRows;
use super::processed::{Processed, WindowScale, codes};
use super::stream::{Sides, Stream};
use super::texgen::{CoordinateSetup, VertexPlace};
use crate::enums as gl;
use crate::limits::CLIP_PLANES;
use crate::state::Attributes;
use crate::state::material::{ColorMaterial, SurfaceMaterial};
use crate::state::matrices::Matrices;
use luxel_lighting::{
    Coefficients, LightingEnvironment, Occlusion, Reflectance, Silent, SurfacePoint, lit_by,
};
use luxel_math::{
    LANES, Lanes, Level, Mask, Rgb, Simd, Vec3, dispatch_long, elementary, f32x16, prelude::*,
};
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

/// What vertices are processed by: the state of one draw.
#[derive(Debug)]
pub(crate) struct VertexProcessor {
    eye_from_object: MatrixRows,
    clip_from_object: MatrixRows,
    /// The inverse transpose of the modelview matrix.
    normal: MatrixRows,
    normal_length: NormalLength,
    scale: WindowScale,
    lighting: Option<LightSetup>,
    color_material: Option<ColorMaterial>,
    /// Whether secondary colours are summed (`GL_COLOR_SUM`).
    color_sum: bool,
    /// The user's planes that are enabled, with their numbers.
    planes: Vec<(u32, [f32; 4])>,
    /// Whether fog takes coordinates of its own rather than distances; `None` without fog.
    fog_from_coordinates: Option<bool>,
    needs_eye: bool,
    /// Of the units whose texture coordinates are needed.
    textures: Vec<CoordinateSetup>,
}

impl VertexProcessor {
    pub(crate) fn new(state: &Attributes, matrices: &Matrices, scale: WindowScale) -> Self {
        let enables = &state.enables;
        let modelview = matrices.modelview.top;
        let inverse = modelview.inverse();
        let sound = inverse.is_finite();
        let normal = if sound { inverse.transpose() } else { modelview };
        let normal_length = if enables.has(gl::NORMALIZE) {
            NormalLength::Unit
        } else if enables.has(gl::RESCALE_NORMAL) {
            let third = inverse.row(2).truncate().length();
            let factor = if sound && third > 0.0 { 1.0 / third } else { 1.0 };
            NormalLength::Scaled(factor as f32)
        } else {
            NormalLength::Kept
        };
        let planes = (0..CLIP_PLANES as u32).filter(|number| enables.planes() >> number & 1 == 1);
        let plane = |number: u32| state.transform.planes[number as usize].map(|value| value as f32);
        Self {
            eye_from_object: MatrixRows::new(&modelview),
            clip_from_object: MatrixRows::new(&matrices.clip_from_object()),
            normal: MatrixRows::new(&normal),
            normal_length,
            scale,
            lighting: enables.has(gl::LIGHTING).then(|| LightSetup::new(state)),
            color_material: enables.has(gl::COLOR_MATERIAL).then_some(state.color_material),
            color_sum: enables.has(gl::COLOR_SUM),
            planes: planes.map(|number| (number, plane(number))).collect(),
            fog_from_coordinates: enables.has(gl::FOG).then_some(state.fog.source == gl::FOG_COORD),
            needs_eye: enables.planes() != 0,
            textures: Vec::new(),
        }
    }

    /// The same, also with eye coordinates where they are needed.
    pub(crate) fn with_eye(mut self, needed: bool) -> Self {
        self.needs_eye |= needed;
        self
    }

    /// The same, also with the texture coordinates of some units, a bit each.
    pub(crate) fn with_textures(
        mut self,
        state: &Attributes,
        matrices: &Matrices,
        units: u32,
    ) -> Self {
        self.textures = CoordinateSetup::of_units(state, matrices, units);
        self
    }

    /// Where clip coordinates lie in the window.
    pub(crate) fn scale(&self) -> WindowScale {
        self.scale
    }

    /// All vertices of a stream.
    pub(crate) fn process(&self, stream: &Stream, level: Level) -> Processed {
        let mut all = Processed::default();
        let runs = luxel_parallel::map(stream.len(), RUN, &|run| {
            let mut processed = Processed::default();
            dispatch_long!(level, simd => self.run(simd, stream, run.clone(), &mut processed));
            processed
        });
        for mut run in runs {
            if all.clip.is_empty() {
                all = run;
                all.reserve(stream.len());
            } else {
                all.append(&mut run);
            }
        }
        if stream.edge_flag.varies() {
            all.edge_flags = (0..stream.len()).map(|vertex| stream.edge_flag.of(vertex)).collect();
        } else if !stream.edge_flag.of(0) {
            all.edge_flags = vec![false; stream.len()];
        }
        all
    }

    #[inline(always)]
    fn run<S: Simd>(&self, simd: S, stream: &Stream, run: Range<usize>, out: &mut Processed) {
        let mut first = run.start;
        while first < run.end {
            let count = LANES.min(run.end - first);
            let lanes = f32x16::splat(simd, 0.0);
            self.sixteen(lanes, stream, first, count, out);
            first += count;
        }
    }

    /// `count` vertices from `first` on; `simd` selects the lane type.
    #[inline(always)]
    fn sixteen<N: Lanes>(
        &self,
        simd: N,
        stream: &Stream,
        first: usize,
        count: usize,
        out: &mut Processed,
    ) {
        // Lanes beyond the last vertex repeat it.
        let at = |lane: usize| first + lane.min(count - 1);
        let position = load4(
            simd,
            #[inline(always)]
            |lane| stream.positions[at(lane)],
        );
        let clip = self.clip_from_object.times(position);
        store(&clip, count, &mut out.clip);
        let (window, held) = self.window(clip);
        let mut codes = self.codes(clip, held);
        out.window.extend_from_slice(&window[..count]);
        let lit = self.lighting.is_some();
        let needs_eye = self.needs_eye
            || lit
            || self.fog_from_coordinates == Some(false)
            || self.textures.iter().any(CoordinateSetup::needs_eye);
        let eye = if needs_eye { self.eye_from_object.times(position) } else { position };
        if self.needs_eye {
            store(&eye, count, &mut out.eye);
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
        out.codes.extend_from_slice(&codes[..count]);
        match self.fog_from_coordinates {
            Some(true) => {
                out.fog_coord.extend((0..count).map(|at| stream.fog_coord.of(first + at)));
            }
            Some(false) => {
                let mut distances = [0.0; LANES];
                eye[2].abs().store(&mut distances, 0);
                out.fog_coord.extend_from_slice(&distances[..count]);
            }
            None => {}
        }
        if !self.textures.is_empty() {
            let mut place =
                VertexPlace { object: position, eye, normal: Vec3::splat(simd, [0.0; 3]) };
            if self.textures.iter().any(CoordinateSetup::needs_normal) {
                let (unit, length) = self.loaded_normal(simd, stream, first, count);
                place.normal = length.map_or(unit, |length| unit * length);
            }
            for setup in &self.textures {
                let given = load4(
                    simd,
                    #[inline(always)]
                    |lane| stream.tex_coord_of(setup.unit, at(lane)),
                );
                let coordinates = setup.coordinates(&place, given);
                store(&coordinates, count, &mut out.tex_coords[setup.unit]);
            }
        }
        let Some(lighting) = &self.lighting else {
            let color = load4(
                simd,
                #[inline(always)]
                |lane| stream.color.of(at(lane)),
            );
            store(&clamped(color), count, &mut out.colors[0]);
            if self.color_sum {
                let secondary = load4(
                    simd,
                    #[inline(always)]
                    |lane| {
                        let [r, g, b] = stream.secondary.of(at(lane));
                        [r, g, b, 0.0]
                    },
                );
                store(&clamped(secondary), count, &mut out.secondary[0]);
            }
            return;
        };
        let (normal, length) = self.loaded_normal(simd, stream, first, count);
        let sides = 1 + usize::from(lighting.two_side);
        let one_material =
            !(stream.material.varies() || self.color_material.is_some() && stream.color.varies());
        for side in 0..sides {
            let normal = if side == 0 { normal } else { -normal };
            let point = surface_point(eye, normal, lighting.local_viewer);
            let mut lanes = [SurfaceMaterial::default(); LANES];
            if one_material {
                lanes[0] = self.material_of(stream, first, side);
            } else {
                for (lane, of) in lanes.iter_mut().enumerate() {
                    *of = self.material_of(stream, at(lane), side);
                }
            }
            let lit = if one_material {
                self.lit(lighting, &point, &lanes, true, length)
            } else {
                self.lit(lighting, &point, &lanes, false, length)
            };
            let alpha = if one_material {
                simd.constant(lanes[0].diffuse[3])
            } else {
                simd.each_lane(|lane| lanes[lane].diffuse[3])
            };
            let Rgb { r, g, b } = lit.primary;
            store(&clamped([r, g, b, alpha]), count, &mut out.colors[side]);
            if lighting.separate {
                let Rgb { r, g, b } = lit.specular;
                store(&clamped([r, g, b, simd.zero()]), count, &mut out.secondary[side]);
            }
        }
    }

    /// Normals of vertices: see [`normal`](Self::normal).
    #[inline(always)]
    fn loaded_normal<N: Lanes>(
        &self,
        simd: N,
        stream: &Stream,
        first: usize,
        count: usize,
    ) -> (Vec3<N>, Option<N>) {
        let [x, y, z, _] = load4(
            simd,
            #[inline(always)]
            |lane| {
                let [x, y, z] = stream.normal.of(first + lane.min(count - 1));
                [x, y, z, 0.0]
            },
        );
        self.normal([x, y, z])
    }

    /// A vertex's material: what was set, and what its colour drives.
    #[inline(always)]
    fn material_of(&self, stream: &Stream, vertex: usize, side: usize) -> SurfaceMaterial {
        let mut sides: Sides = stream.materials[stream.material.of(vertex) as usize];
        if let Some(color_material) = self.color_material {
            color_material.apply(stream.color.of(vertex), &mut sides);
        }
        sides[side]
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

    /// The light of sixteen vertices, whose materials are all that of the first lane if `uniform`.
    #[inline(always)]
    fn lit<N: Lanes>(
        &self,
        lighting: &LightSetup,
        point: &SurfacePoint<N>,
        materials: &[SurfaceMaterial; LANES],
        uniform: bool,
        length: Option<N>,
    ) -> SeparateSums<N> {
        let simd = point.depth;
        // Vertices of one exponent are lit together: nearly always all of them.
        let mut left = simd.all_lanes();
        let mut sums = SeparateSums::new(simd);
        while left != 0 {
            let leader = left.trailing_zeros() as usize & (LANES - 1);
            let shininess = materials[leader].shininess;
            let mut together = left;
            if !uniform {
                for (lane, other) in materials.iter().enumerate() {
                    together &= !(u32::from(other.shininess != shininess) << lane);
                }
            }
            left &= !together;
            let lit = self.lit_with(lighting, point, materials, leader, uniform, length);
            let mask = simd.mask_of(together);
            sums.primary = lit.primary.select(mask, sums.primary);
            sums.specular = lit.specular.select(mask, sums.specular);
        }
        sums
    }

    #[inline(always)]
    fn lit_with<N: Lanes>(
        &self,
        lighting: &LightSetup,
        point: &SurfacePoint<N>,
        materials: &[SurfaceMaterial; LANES],
        leader: usize,
        uniform: bool,
        length: Option<N>,
    ) -> SeparateSums<N> {
        let simd = point.depth;
        let material = material(&materials[leader]);
        let mut reflectance = Reflectance::of(simd, &material);
        if !uniform {
            reflectance.ambient = color_lanes(simd, &materials.map(|side| side.ambient));
            reflectance.diffuse = color_lanes(simd, &materials.map(|side| side.diffuse));
            reflectance.specular = color_lanes(simd, &materials.map(|side| side.specular));
            reflectance.emission = color_lanes(simd, &materials.map(|side| side.emission));
        }
        if let Some(length) = length {
            reflectance.diffuse = reflectance.diffuse * length;
            let power = elementary::power(length, simd.constant(material.shininess));
            reflectance.specular = reflectance.specular * power;
        }
        let coefficients = Coefficients::new(&reflectance, &material);
        let environment = LightingEnvironment::new(
            &lighting.lights,
            lighting.scene_ambient,
            &lighting.environment,
            None,
        );
        let reflection = &material.reflection;
        let mut sums = SeparateSums::new(simd);
        if lighting.separate {
            lit_by(point, &coefficients, reflection, &environment, Occlusion::NONE, &mut sums);
        } else {
            sums.primary = lit_by(
                point,
                &coefficients,
                reflection,
                &environment,
                Occlusion::NONE,
                &mut Silent,
            );
        }
        sums
    }

    /// Where sixteen vertices lie in the window, and which of them have a place there.
    #[inline(always)]
    fn window<N: Lanes>(&self, [x, y, z, w]: [N; 4]) -> ([WindowVertex; LANES], u32) {
        let WindowScale { half, centre, depth } = self.scale;
        let mut held = w.zero().less(w);
        let (across, within) = held_at(x, w, half[0], centre[0]);
        held = held & within;
        let (up, within) = held_at(y, w, half[1], centre[1]);
        held = held & within;
        let depths = z / w * w.constant(depth[0]) + w.constant(depth[1]);
        let [mut xs, mut ys, mut zs] = [[0.0; LANES]; 3];
        across.store(&mut xs, 0);
        up.store(&mut ys, 0);
        depths.store(&mut zs, 0);
        let mut vertices = [WindowVertex::default(); LANES];
        for (lane, vertex) in vertices.iter_mut().enumerate() {
            *vertex = WindowVertex { x: xs[lane] as i32, y: ys[lane] as i32, z: zs[lane] };
        }
        (vertices, held.bits())
    }

    /// Clip codes of sixteen vertices.
    #[inline(always)]
    fn codes<N: Lanes>(&self, [x, y, z, w]: [N; 4], held: u32) -> [u16; LANES] {
        let mut all = [0; LANES];
        spread(x.less(-w).bits(), 0, &mut all);
        spread(w.less(x).bits(), 1, &mut all);
        spread(y.less(-w).bits(), 2, &mut all);
        spread(w.less(y).bits(), 3, &mut all);
        spread(z.less(-w).bits(), 4, &mut all);
        spread(w.less(z).bits(), 5, &mut all);
        let not_finite = !(finite(x) & finite(y) & finite(z) & finite(w)).bits();
        spread(not_finite, codes::NOT_FINITE.trailing_zeros(), &mut all);
        spread(!held, codes::NOT_HELD.trailing_zeros(), &mut all);
        all
    }
}

/// The point that is lit: the vertex by its w, and the direction to the eye, along z unless the viewer is local.
#[inline(always)]
fn surface_point<N: Lanes>(
    [x, y, z, w]: [N; 4],
    normal: Vec3<N>,
    local_viewer: bool,
) -> SurfacePoint<N> {
    let at_infinity = w.equal(w.zero());
    let scale = w.one() / w.one().select(at_infinity, w);
    let position = Vec3::new(x * scale, y * scale, z * scale);
    let view = if local_viewer {
        (-position).normalized_or_zero()
    } else {
        Vec3::splat(w, [0.0, 0.0, 1.0])
    };
    SurfacePoint { position, normal, view, depth: w.zero() }
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

/// Vectors of all lanes, from `of(lane)`; `simd` selects the lane type. Mark the closure `#[inline(always)]`.
#[inline(always)]
fn load4<N: Lanes>(simd: N, of: impl Fn(usize) -> [f32; 4]) -> [N; 4] {
    let mut columns = [[0.0; LANES]; 4];
    for lane in 0..LANES {
        let [x, y, z, w] = of(lane);
        columns[0][lane] = x;
        columns[1][lane] = y;
        columns[2][lane] = z;
        columns[3][lane] = w;
    }
    [
        simd.load(&columns[0], 0),
        simd.load(&columns[1], 0),
        simd.load(&columns[2], 0),
        simd.load(&columns[3], 0),
    ]
}

/// Colours of all lanes.
#[inline(always)]
fn color_lanes<N: Lanes>(simd: N, colors: &[[f32; 4]; LANES]) -> Rgb<N> {
    let [r, g, b, _] = load4(
        simd,
        #[inline(always)]
        |lane| colors[lane],
    );
    Rgb::new(r, g, b)
}

/// Appends the first lanes as vectors.
#[inline(always)]
fn store<N: Lanes>(values: &[N; 4], count: usize, out: &mut Vec<[f32; 4]>) {
    let mut columns = [[0.0; LANES]; 4];
    values[0].store(&mut columns[0], 0);
    values[1].store(&mut columns[1], 0);
    values[2].store(&mut columns[2], 0);
    values[3].store(&mut columns[3], 0);
    let mut rows = [[0.0; 4]; LANES];
    for lane in 0..LANES {
        rows[lane] = [columns[0][lane], columns[1][lane], columns[2][lane], columns[3][lane]];
    }
    out.extend_from_slice(&rows[..count]);
}
