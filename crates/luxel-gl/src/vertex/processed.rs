//! What becomes of vertices: places in clip and window coordinates, colours.

use crate::limits::TEXTURE_UNITS;
use crate::state::attributes::Viewport;
use crate::state::current::RasterPosition;
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

/// From clip coordinates to the window, in steps of 1/256 pixel and of 2^-24 of depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct WindowScale {
    /// Half the viewport's sides.
    pub(crate) half: [f32; 2],
    /// The viewport's middle.
    pub(crate) centre: [f32; 2],
    /// Half the range of depths, and its middle.
    pub(crate) depth: [f32; 2],
}

impl WindowScale {
    pub(crate) fn new(viewport: &Viewport, largest_depth: f32) -> Self {
        let steps = luxel_math::SUBPIXELS as f32;
        let area = viewport.area;
        let half = [area.width, area.height].map(|side| side as f32 * 0.5 * steps);
        let centre = [area.x as f32 * steps + half[0], area.y as f32 * steps + half[1]];
        let (near, far) = (viewport.near, viewport.far);
        let largest = f64::from(largest_depth);
        let depth = [(far - near) * 0.5 * largest, (far + near) * 0.5 * largest];
        Self { half, centre, depth: depth.map(|value| value as f32) }
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
}

impl Processed {
    /// Makes room for so many vertices in the lists that there are.
    pub(crate) fn reserve(&mut self, count: usize) {
        fn room<T>(list: &mut Vec<T>, count: usize) {
            if !list.is_empty() {
                list.reserve_exact(count.saturating_sub(list.len()));
            }
        }
        room(&mut self.clip, count);
        room(&mut self.codes, count);
        room(&mut self.window, count);
        room(&mut self.eye, count);
        room(&mut self.fog_coord, count);
        for list in self.colors.iter_mut().chain(&mut self.secondary).chain(&mut self.tex_coords) {
            room(list, count);
        }
    }

    /// Appends the vertices of the next run.
    pub(crate) fn append(&mut self, other: &mut Self) {
        self.clip.append(&mut other.clip);
        self.codes.append(&mut other.codes);
        self.window.append(&mut other.window);
        self.eye.append(&mut other.eye);
        for side in 0..2 {
            self.colors[side].append(&mut other.colors[side]);
            self.secondary[side].append(&mut other.secondary[side]);
        }
        self.fog_coord.append(&mut other.fog_coord);
        for (own, others) in self.tex_coords.iter_mut().zip(&mut other.tex_coords) {
            own.append(others);
        }
        self.edge_flags.append(&mut other.edge_flags);
    }

    /// The primary colour of a vertex on a side: 0 is the front.
    pub(crate) fn color(&self, side: usize, vertex: usize) -> [f32; 4] {
        let colors = &self.colors[side];
        if colors.is_empty() { self.colors[0][vertex] } else { colors[vertex] }
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
