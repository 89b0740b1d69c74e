//! Smooth polygons to pieces (OpenGL 1.5, section 3.5).

use super::build::PieceBuilder;
use super::outline::Outline;
use super::pieces::Shade;
use super::placement::{area, slope_of};
use super::shape::Shape;
use crate::vertex::codes;
use luxel_visibility::{CullFaces, Triangle, WindowVertex};

impl PieceBuilder<'_> {
    /// A filled polygon whose alphas are multiplied by the part of each pixel that it covers; `false`, with nothing done, if
    /// it isn't convex. Its triangles share its outline, so that no diagonal is seen; where planes clip it each has its own.
    pub(super) fn smooth_polygon(
        &mut self,
        corners: &[u32],
        (flat, side): (Option<u32>, usize),
        provoking: u32,
    ) -> bool {
        let state = self.state;
        let side = state.color_side(side) as u8;
        let fans: Vec<[usize; 3]> = state.fans(&self.batch.vertices, corners, provoking).collect();
        let shade = |fan: [usize; 3]| Shade { corners: fan.map(|at| corners[at]), flat, side };
        let not_whole = codes::OUTSIDE & !codes::SIDES | codes::NOT_HELD | codes::NOT_FINITE;
        if corners.iter().all(|vertex| self.codes(*vertex) & not_whole == 0) {
            let about = fans.first().map_or(0, |fan| fan[0]);
            let place = |at: usize| self.window(corners[(about + at) % corners.len()]);
            let window: Vec<WindowVertex> = (0..corners.len()).map(place).collect();
            let Some((outline, numbers)) = Outline::new(&window) else { return false };
            let outline = self.pieces.put_outline(outline);
            for (place, fan) in numbers.into_iter().map(|number| fans[number]).enumerate() {
                let shade = shade(fan);
                let window = shade.corners.map(|corner| self.window(corner));
                self.smooth_piece((outline, place as u32), &window, shade);
            }
            return true;
        }
        for fan in fans {
            let shade = shade(fan);
            if self.is_out_of_sight(shade.corners) {
                continue;
            }
            let window = self.clipped(shade.corners);
            if let Some((outline, numbers)) = Outline::new(&window) {
                let outline = self.pieces.put_outline(outline);
                // All of its triangles have the same colours and depths.
                for place in 0..numbers.len() {
                    self.smooth_piece((outline, place as u32), &window, shade);
                }
            }
        }
        true
    }

    /// The pixels of an outline that one of its triangles colours, with depths in the plane of a polygon.
    fn smooth_piece(&mut self, outline: (u32, u32), window: &[WindowVertex], shade: Shade) {
        // The largest triangle has the plane with the fewest errors.
        let size = |pair: &[WindowVertex]| area([window[0], pair[0], pair[1]]).abs();
        let pairs = window[1..].windows(2);
        let Some(largest) = pairs.max_by(|a, b| size(a).total_cmp(&size(b))) else { return };
        let largest = [window[0], largest[0], largest[1]];
        let Some(triangle) = Triangle::new(largest, CullFaces::None) else { return };
        let offset =
            self.state.offsets[2].map(|[factor, units]| [factor, units, slope_of(&triangle)]);
        let (outline, number) = outline;
        let depth = triangle.depth;
        let shape = Shape::Smooth { outline, triangle: number, depth };
        self.put(shape, shade, offset, depth.high);
    }
}
