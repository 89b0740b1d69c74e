//! What becomes of vertices: places in clip and window coordinates, colours.

use super::view::VertexView;
use crate::depth::DepthKind;
use crate::limits::TEXTURE_UNITS;
use crate::state::current::RasterPosition;
use crate::state::window::WindowTransform;
use luxel_visibility::WindowVertex;

/// Bits of clip codes: a vertex lies beyond a plane of the clip volume.
pub(crate) mod codes {
    /// Beyond -w or w in x or y: a bit each.
    pub(crate) const SIDES: u16 = 0b1111;
    /// Before the near plane, z < -w.
    pub(crate) const NEAR: u16 = 1 << 4;
    /// Beyond the far plane, z > w.
    pub(crate) const FAR: u16 = 1 << 5;
    /// The first of the user's planes.
    pub(crate) const FIRST_PLANE: u32 = 6;
    /// A coordinate is not a number, or infinite: such primitives are left out.
    pub(crate) const NOT_FINITE: u16 = 1 << 14;
    /// The vertex lies outside of the guard band, or behind the eye: it has no place in the window.
    pub(crate) const NOT_HELD: u16 = 1 << 15;
    /// What takes a vertex out of the clip volume.
    pub(crate) const OUTSIDE: u16 = (1 << 14) - 1;
}

/// From clip coordinates to the window, in steps of 1/256 pixel and depths as their plane keeps them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct WindowScale {
    /// Half the viewport's sides; that along y is negative where y runs downwards.
    pub(crate) half: [f32; 2],
    /// The viewport's middle.
    pub(crate) centre: [f32; 2],
    /// What z / w is multiplied by, and what then is added, for the depth as a plane keeps it.
    pub(crate) depth: [f32; 2],
    /// z / w of the near plane.
    pub(crate) nearest: f32,
    /// How depths are kept.
    pub(crate) kind: DepthKind,
}

impl WindowScale {
    pub(crate) fn new(window: &WindowTransform, depths: DepthKind) -> Self {
        let steps = luxel_math::SUBPIXELS as f32;
        let WindowTransform { viewport, clip } = window;
        let area = viewport.area;
        let half = [area.width, area.height].map(|side| side as f32 * 0.5 * steps);
        let centre = [area.x as f32 * steps + half[0], area.y as f32 * steps + half[1]];
        let (near, far) = (viewport.near, viewport.far);
        let largest = f64::from(depths.largest());
        let depth = if clip.zero_to_one {
            [(far - near) * largest, near * largest]
        } else {
            [(far - near) * 0.5 * largest, (far + near) * 0.5 * largest]
        };
        Self {
            half: [half[0], half[1] * clip.up() as f32],
            centre,
            depth: depth.map(|value| value as f32),
            nearest: clip.nearest() as f32,
            kind: depths,
        }
    }

    /// The near plane in clip coordinates.
    pub(crate) fn near_plane(&self) -> [f64; 4] {
        [0.0, 0.0, 1.0, -f64::from(self.nearest)]
    }
}

/// Vertices after transform and lighting; lists that nobody needs are empty.
#[derive(Clone, Debug, Default)]
pub(crate) struct Processed {
    pub(crate) clip: Vec<[f32; 4]>,
    pub(crate) codes: Vec<u16>,
    /// Where they lie in the window, unless their code says [`codes::NOT_HELD`].
    pub(crate) window: Vec<WindowVertex>,
    /// In eye coordinates.
    pub(crate) eye: Vec<[f32; 4]>,
    /// Primary colours of front and back, within 0 and 1; of the back only if both are lit.
    pub(crate) colors: [Vec<[f32; 4]>; 2],
    /// Secondary colours of front and back.
    pub(crate) secondary: [Vec<[f32; 4]>; 2],
    pub(crate) fog_coord: Vec<f32>,
    /// Texture coordinates of each unit, after generation and matrix.
    pub(crate) tex_coords: [Vec<[f32; 4]>; TEXTURE_UNITS],
    /// Edge flags, if vertices have different ones.
    pub(crate) edge_flags: Vec<bool>,
    /// Which lists were needed last.
    pub(crate) lists: Lists,
}

/// Which lists of [`Processed`] there are, beside clip coordinates, codes and places in the window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Lists {
    pub(crate) window: bool,
    pub(crate) eye: bool,
    /// How many sides have primary colours, and how many secondary ones.
    pub(crate) colors: usize,
    pub(crate) secondary: usize,
    pub(crate) fog_coord: bool,
    /// The units with texture coordinates, a bit each.
    pub(crate) textures: u32,
}

impl Lists {
    /// Bytes of a vertex in all lists.
    pub(crate) fn bytes_of_vertex(&self) -> usize {
        let colors = self.colors + self.secondary + self.textures.count_ones() as usize;
        let of_four = 1 + usize::from(self.eye) + colors;
        of_four * size_of::<[f32; 4]>() + size_of::<WindowVertex>() + size_of::<(u16, f32, bool)>()
    }
}

/// A run of the lists of [`Processed`]; lists that nobody needs are empty.
#[derive(Debug, Default)]
pub(super) struct ProcessedRun<'a> {
    /// The first vertex.
    pub(super) first: usize,
    pub(super) clip: &'a mut [[f32; 4]],
    pub(super) codes: &'a mut [u16],
    pub(super) window: &'a mut [WindowVertex],
    pub(super) eye: &'a mut [[f32; 4]],
    pub(super) colors: [&'a mut [[f32; 4]]; 2],
    pub(super) secondary: [&'a mut [[f32; 4]]; 2],
    pub(super) fog_coord: &'a mut [f32],
    pub(super) tex_coords: [&'a mut [[f32; 4]]; TEXTURE_UNITS],
}

impl Processed {
    /// What corners of a primitive lie beyond, together; `None` if nothing of it is seen: all of them lie beyond one
    /// plane, or one isn't finite.
    #[inline]
    pub(crate) fn codes_if_seen(&self, corners: &[u32]) -> Option<u16> {
        let (all, any) = corners.iter().fold((u16::MAX, 0), |(all, any), corner| {
            let code = self.codes[*corner as usize];
            (all & code, any | code)
        });
        (all & codes::OUTSIDE == 0 && any & codes::NOT_FINITE == 0).then_some(any)
    }

    /// Gives the lists that are needed room for so many vertices, and empties the others. Values are to be written.
    pub(super) fn resize(&mut self, count: usize, lists: &Lists) {
        fn sized<T: Clone + Default>(list: &mut Vec<T>, count: usize, needed: bool) {
            list.resize(if needed { count } else { 0 }, T::default());
        }
        self.lists = *lists;
        sized(&mut self.clip, count, true);
        sized(&mut self.codes, count, true);
        sized(&mut self.window, count, lists.window);
        sized(&mut self.eye, count, lists.eye);
        for side in 0..2 {
            sized(&mut self.colors[side], count, side < lists.colors);
            sized(&mut self.secondary[side], count, side < lists.secondary);
        }
        sized(&mut self.fog_coord, count, lists.fog_coord);
        for (unit, list) in self.tex_coords.iter_mut().enumerate() {
            sized(list, count, lists.textures >> unit & 1 == 1);
        }
        self.edge_flags.clear();
    }

    /// Takes the edge flags of all vertices, if some are no edges.
    pub(super) fn put_edge_flags(&mut self, vertices: &VertexView<'_>) {
        let flags = &vertices.edge_flag;
        if flags.varies() {
            self.edge_flags.extend((0..vertices.len()).map(|vertex| flags.of(vertex)));
        } else if !flags.of(0) {
            self.edge_flags.resize(vertices.len(), false);
        }
    }

    /// Bytes of all lists, with the room for more.
    pub(crate) fn bytes(&self) -> usize {
        fn room<T>(list: &Vec<T>) -> usize {
            list.capacity() * size_of::<T>()
        }
        let colors = self.colors.iter().chain(&self.secondary).chain(&self.tex_coords);
        colors.chain([&self.clip, &self.eye]).map(room).sum::<usize>()
            + room(&self.codes)
            + room(&self.window)
            + room(&self.fog_coord)
            + room(&self.edge_flags)
    }

    /// The lists in runs of `length` vertices.
    pub(super) fn runs(&mut self, length: usize) -> Vec<ProcessedRun<'_>> {
        fn part<'a, T>(list: &mut &'a mut [T], length: usize) -> &'a mut [T] {
            let rest = std::mem::take(list);
            let (first, rest) = rest.split_at_mut(length.min(rest.len()));
            *list = rest;
            first
        }
        let mut rest = ProcessedRun {
            first: 0,
            clip: &mut self.clip,
            codes: &mut self.codes,
            window: &mut self.window,
            eye: &mut self.eye,
            colors: self.colors.each_mut().map(Vec::as_mut_slice),
            secondary: self.secondary.each_mut().map(Vec::as_mut_slice),
            fog_coord: &mut self.fog_coord,
            tex_coords: self.tex_coords.each_mut().map(Vec::as_mut_slice),
        };
        let mut runs = Vec::with_capacity(rest.clip.len().div_ceil(length));
        while !rest.clip.is_empty() {
            runs.push(ProcessedRun {
                first: rest.first,
                clip: part(&mut rest.clip, length),
                codes: part(&mut rest.codes, length),
                window: part(&mut rest.window, length),
                eye: part(&mut rest.eye, length),
                colors: rest.colors.each_mut().map(|list| part(list, length)),
                secondary: rest.secondary.each_mut().map(|list| part(list, length)),
                fog_coord: part(&mut rest.fog_coord, length),
                tex_coords: rest.tex_coords.each_mut().map(|list| part(list, length)),
            });
            rest.first += length;
        }
        runs
    }

    /// The primary colour of a vertex on a side: 0 is the front. Zeros if there are no colours.
    pub(crate) fn color(&self, side: usize, vertex: usize) -> [f32; 4] {
        let own = &self.colors[side];
        let colors = if own.is_empty() { &self.colors[0] } else { own };
        colors.get(vertex).copied().unwrap_or_default()
    }

    /// The secondary colour of a vertex; black if there is none.
    pub(crate) fn secondary(&self, side: usize, vertex: usize) -> [f32; 4] {
        let own = &self.secondary[side];
        let colors = if own.is_empty() { &self.secondary[0] } else { own };
        colors.get(vertex).copied().unwrap_or_default()
    }

    /// What is current at the raster position, as a vertex of its own; its secondary colour where colours are summed.
    pub(crate) fn at_raster(raster: &RasterPosition, sums_colors: bool) -> Self {
        let [r, g, b, _] = if sums_colors { raster.secondary } else { [0.0; 4] };
        let mut vertex = Self {
            clip: vec![[0.0, 0.0, 0.0, 1.0]],
            fog_coord: vec![raster.distance],
            ..Self::default()
        };
        vertex.colors[0].push(raster.color);
        vertex.secondary[0].push([r, g, b, 0.0]);
        for (of_unit, coordinates) in vertex.tex_coords.iter_mut().zip(raster.tex_coords) {
            of_unit.push(coordinates);
        }
        vertex
    }

    /// Whether the edge that begins at a vertex is one of the border.
    pub(crate) fn edge_flag(&self, vertex: usize) -> bool {
        self.edge_flags.get(vertex).copied().unwrap_or(true)
    }
}
