//! The state that decides how primitives become pieces: faces, modes, sizes, offsets, planes of the user.

use crate::enums as gl;
use crate::state::Attributes;
use crate::vertex::{Processed, WindowScale, codes};

/// What decides how primitives become pieces.
#[derive(Clone, Debug)]
pub(crate) struct DrawState {
    pub(super) flat: bool,
    pub(super) two_side: bool,
    /// Whether front faces run counter-clockwise in the window, as [`WindowScale`] has it.
    pub(super) front_is_counter_clockwise: bool,
    /// Which sides are left out: front, back.
    pub(super) culled: [bool; 2],
    /// How the sides are drawn.
    pub(super) modes: [u32; 2],
    /// Factor and units, for points, lines and filled polygons.
    pub(super) offsets: [Option<[f32; 2]>; 3],
    pub(super) point_size: f32,
    pub(super) point_limits: [f32; 2],
    pub(super) attenuation: [f32; 3],
    /// The width of lines, within its limits.
    pub(super) line_size: f32,
    /// Whether points, lines and polygons are smooth.
    pub(super) smooth: [bool; 3],
    /// Enabled planes of the user, by numbers of bits, in eye coordinates.
    pub(super) planes: Vec<(u32, [f64; 4])>,
    pub(super) scale: WindowScale,
    /// Whether polygons are split at the provoking vertex rather than at the first one.
    pub(super) splits_at_provoking: bool,
}

impl DrawState {
    /// The state of a draw; whether that comes from a display list.
    pub(crate) fn new(state: &Attributes, scale: WindowScale, is_listed: bool) -> Self {
        let has = |name: u32| state.enables.has(name);
        let polygons = &state.polygons;
        let culls = |side: u32| {
            has(gl::CULL_FACE) && (polygons.cull == side || polygons.cull == gl::FRONT_AND_BACK)
        };
        let offset =
            |name: u32| has(name).then_some([polygons.offset_factor, polygons.offset_units]);
        let enabled = (0..8_u32).filter(|number| state.enables.planes() >> number & 1 == 1);
        Self {
            flat: state.lights.shade_model == gl::FLAT,
            two_side: has(gl::LIGHTING) && state.lights.model.two_side,
            front_is_counter_clockwise: (polygons.front == gl::CCW)
                != state.transform.clip.upper_left,
            culled: [culls(gl::FRONT), culls(gl::BACK)],
            modes: polygons.modes,
            offsets: [
                offset(gl::POLYGON_OFFSET_POINT),
                offset(gl::POLYGON_OFFSET_LINE),
                offset(gl::POLYGON_OFFSET_FILL),
            ],
            point_size: state.points.size,
            point_limits: [state.points.least, state.points.largest],
            attenuation: state.points.attenuation,
            line_size: state.lines.width.clamp(1.0, crate::limits::LARGEST_SIZE),
            smooth: [gl::POINT_SMOOTH, gl::LINE_SMOOTH, gl::POLYGON_SMOOTH].map(has),
            planes: enabled
                .map(|number| (number, state.transform.planes[number as usize]))
                .collect(),
            scale,
            splits_at_provoking: is_listed || has(gl::POLYGON_SMOOTH),
        }
    }

    /// The triangles of a polygon of those vertices, each by the numbers of its corners. The diagonals are free
    /// (section 3.5); these are those of Mesa's drivers, so that lit quads look the same: of lists, of smooth polygons and
    /// of those that are clipped from the provoking vertex, of others from the first. A triangle has none and keeps the order
    /// of its corners, on which the last digits of its depths depend.
    pub(super) fn fans(
        &self,
        vertices: &Processed,
        corners: &[u32],
        provoking: u32,
    ) -> impl Iterator<Item = [usize; 3]> + use<> {
        let count = corners.len();
        let outside = |corner: &u32| vertices.codes[*corner as usize] & codes::OUTSIDE != 0;
        let at_provoking = count > 3 && (self.splits_at_provoking || corners.iter().any(outside));
        let about = if at_provoking { provoking } else { corners[0] };
        let first = corners.iter().position(|corner| *corner == about).unwrap_or(0);
        (first + 1..first + count - 1)
            .map(move |second| [first, second % count, (second + 1) % count])
    }

    /// Whether eye coordinates are needed.
    pub(crate) fn needs_eye(&self) -> bool {
        !self.planes.is_empty() || self.attenuation != [1.0, 0.0, 0.0]
    }

    /// Whether a polygon of that area, positive where it runs counter-clockwise in the window, faces the viewer: 0 is
    /// the front, 1 the back.
    pub(crate) fn side(&self, area: f64) -> usize {
        usize::from((area > 0.0) != self.front_is_counter_clockwise)
    }

    pub(crate) fn is_culled(&self, side: usize) -> bool {
        self.culled[side]
    }

    /// How a side is drawn.
    pub(crate) fn mode(&self, side: usize) -> u32 {
        self.modes[side]
    }

    pub(crate) fn is_flat(&self) -> bool {
        self.flat
    }

    pub(crate) fn scale(&self) -> &WindowScale {
        &self.scale
    }

    /// The user's planes in eye coordinates.
    pub(crate) fn planes(&self) -> &[(u32, [f64; 4])] {
        &self.planes
    }

    /// Which colours a side has.
    pub(crate) fn color_side(&self, side: usize) -> usize {
        if self.two_side { side } else { 0 }
    }
}

/// A size of points or width of lines in whole pixels (sections 3.3 and 3.4.2).
pub(super) fn whole_size(size: f32) -> i32 {
    (size.clamp(1.0, crate::limits::LARGEST_SIZE) + 0.5) as i32
}
