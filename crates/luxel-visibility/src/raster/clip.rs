//! Clipping against the near plane and the guard band (Sutherland and Hodgman 1974).
//!
//! The window's own sides need no clipping, since tiles only look at their own pixels; the far
//! plane needs none, since samples beyond it are rejected by depth. A new point is computed from
//! the edge's inside vertex to its outside one, so that two triangles that share the edge get the
//! same bits, whichever way round they run along it.

use crate::types::{ClipVertex, GUARD_BAND, WindowTransform, WindowVertex};
use luxel_math::SUBPIXELS;

/// Most corners that a triangle can have after five planes.
const MAX_CORNERS: usize = 3 + 5;

/// A corner of a polygon being clipped.
#[derive(Clone, Copy, Debug)]
struct Corner {
    x: f64,
    y: f64,
    z: f64,
    w: f64,
    /// Set for the triangle's own vertices, which must land where unclipped neighbours put them.
    own: Option<ClipVertex>,
    /// Whether an unclipped neighbour may have it: then no plane cuts it off.
    held: bool,
}

/// The planes, as functions that are not negative inside.
#[derive(Clone, Copy, Debug)]
enum Plane {
    Near,
    Left,
    Right,
    Top,
    Bottom,
}

impl Plane {
    const ALL: [Self; 5] = [Self::Near, Self::Left, Self::Right, Self::Top, Self::Bottom];

    fn distance(self, corner: &Corner) -> f64 {
        // Coordinates are about the window's middle, as the guard band is; one pixel stays for
        // rounding.
        let guard = f64::from(GUARD_BAND - SUBPIXELS);
        let distance = match self {
            Self::Near => corner.w - corner.z,
            Self::Left => corner.x + guard * corner.w,
            Self::Right => guard * corner.w - corner.x,
            Self::Top => corner.y + guard * corner.w,
            Self::Bottom => guard * corner.w - corner.y,
        };
        if corner.held { distance.max(0.0) } else { distance }
    }
}

/// A triangle's part inside near plane and guard band, as a convex polygon of window vertices.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ClippedPolygon {
    corners: [WindowVertex; MAX_CORNERS],
    count: usize,
}

impl ClippedPolygon {
    /// The fan of triangles that make up the polygon.
    pub(crate) fn triangles(&self) -> impl Iterator<Item = [WindowVertex; 3]> + '_ {
        (2..self.count).map(|last| [self.corners[0], self.corners[last - 1], self.corners[last]])
    }
}

/// Clips a triangle given in clip coordinates.
pub(crate) fn clip(triangle: [ClipVertex; 3], transform: &WindowTransform) -> ClippedPolygon {
    let corner = |vertex: ClipVertex| Corner {
        x: f64::from(vertex.x),
        y: f64::from(vertex.y),
        z: f64::from(vertex.z),
        w: f64::from(vertex.w),
        own: Some(vertex),
        held: transform.holds(vertex),
    };
    let mut polygon = [corner(triangle[0]); MAX_CORNERS];
    polygon[1] = corner(triangle[1]);
    polygon[2] = corner(triangle[2]);
    let mut count = 3;
    for plane in Plane::ALL {
        let source = polygon;
        let distances = source.map(|corner| plane.distance(&corner));
        let mut kept = 0;
        let mut keep = |corner: Corner| {
            // Rounding could make a polygon cross a plane more than twice; what exceeds the most
            // that exact arithmetic allows is a sliver of no area.
            if kept < MAX_CORNERS {
                polygon[kept] = corner;
                kept += 1;
            }
        };
        clip_by_plane(&source[..count], &distances[..count], between, &mut keep);
        count = kept;
    }
    let mut clipped = ClippedPolygon { corners: [WindowVertex::default(); MAX_CORNERS], count: 0 };
    for corner in &polygon[..count] {
        // A point of all planes at once may have w = 0; it bounds no area.
        if let Some(vertex) = window(corner, transform) {
            clipped.corners[clipped.count] = vertex;
            clipped.count += 1;
        }
    }
    clipped
}

/// Cuts a convex polygon at one plane: keeps the corners whose distance isn't negative, and the points where edges
/// leave (Sutherland and Hodgman 1974).
///
/// `between(inside, outside, t)` is the point inside + (outside - inside) t: always from the inside corner outwards,
/// so that polygons that share an edge share the point.
pub fn clip_by_plane<C: Copy>(
    polygon: &[C],
    distances: &[f64],
    between: impl Fn(&C, &C, f64) -> C,
    keep: &mut impl FnMut(C),
) {
    let count = polygon.len();
    for here in 0..count {
        let next = if here + 1 == count { 0 } else { here + 1 };
        let (inside, next_inside) = (distances[here] >= 0.0, distances[next] >= 0.0);
        if inside {
            keep(polygon[here]);
        }
        // NaN is neither inside nor outside.
        if inside && distances[next] < 0.0 || next_inside && distances[here] < 0.0 {
            let (from, to) = if inside { (here, next) } else { (next, here) };
            let t = distances[from] / (distances[from] - distances[to]);
            keep(between(&polygon[from], &polygon[to], t));
        }
    }
}

/// The point where an edge leaves: from its inside end towards its outside one.
fn between(inside: &Corner, outside: &Corner, t: f64) -> Corner {
    let mix = |inside: f64, outside: f64| inside + (outside - inside) * t;
    Corner {
        x: mix(inside.x, outside.x),
        y: mix(inside.y, outside.y),
        z: mix(inside.z, outside.z),
        w: mix(inside.w, outside.w),
        own: None,
        held: false,
    }
}

fn window(corner: &Corner, transform: &WindowTransform) -> Option<WindowVertex> {
    if corner.w.is_nan() || corner.w <= 0.0 {
        return None;
    }
    if let Some(own) = corner.own.filter(|_| corner.held) {
        return Some(transform.window(own));
    }
    let snap = |value: f64, centre: f32| {
        let limit = f64::from(GUARD_BAND);
        let about_centre = (value / corner.w).clamp(-limit, limit);
        (about_centre + f64::from(centre)).round_ties_even() as i32
    };
    let (x, y) = (snap(corner.x, transform.centre[0]), snap(corner.y, transform.centre[1]));
    // The near plane is depth 1: rounding must not carry a point past it.
    Some(WindowVertex { x, y, z: ((corner.z / corner.w) as f32).min(1.0) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Clip coordinates as they are, about the window's corner.
    const PLAIN: WindowTransform = WindowTransform {
        rows: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0; 4]],
        centre: [0.0; 2],
    };

    fn points(polygon: &ClippedPolygon) -> Vec<WindowVertex> {
        polygon.corners[..polygon.count].to_vec()
    }

    #[test]
    fn a_vertex_in_the_band_s_last_pixel_stays_where_unclipped_neighbours_have_it() {
        let edge = (GUARD_BAND - 10) as f32;
        let beyond = (GUARD_BAND + 5000) as f32;
        let vertex = |x, y| ClipVertex { x, y, z: 0.5, w: 1.0 };
        let clipped = clip([vertex(edge, 0.0), vertex(0.0, 7.0), vertex(9.0, beyond)], &PLAIN);
        let kept = [[GUARD_BAND - 10, 0], [0, 7]];
        for [x, y] in kept {
            assert!(points(&clipped).contains(&WindowVertex { x, y, z: 0.5 }), "{clipped:?}");
        }
    }

    /// Vertices inside and far outside, before and behind the eye.
    fn vertex() -> impl Strategy<Value = ClipVertex> {
        let place = prop_oneof![-2000.0..2000.0_f32, -1e8..1e8_f32];
        let depth = prop_oneof![-3.0..3.0_f32, 0.1..40.0_f32];
        (place.clone(), place, depth).prop_map(|(x, y, w)| ClipVertex {
            x: x * w.abs(),
            y: y * w.abs(),
            z: 0.1,
            w,
        })
    }

    proptest! {
        #[test]
        fn triangles_that_share_an_edge_share_the_points_where_it_leaves(
            ends in [vertex(), vertex()], others in [vertex(), vertex()],
        ) {
            // The edge alone, as a triangle without area.
            let edge = points(&clip([ends[0], ends[1], ends[1]], &PLAIN));
            for other in others {
                for corners in [[ends[0], ends[1], other], [other, ends[1], ends[0]]] {
                    let polygon = points(&clip(corners, &PLAIN));
                    prop_assert!(polygon.is_empty() || edge.iter().all(|p| polygon.contains(p)));
                }
            }
        }

        #[test]
        fn what_is_left_lies_within_band_and_depths(corners in [vertex(), vertex(), vertex()]) {
            for point in points(&clip(corners, &PLAIN)) {
                prop_assert!(point.x.abs() <= GUARD_BAND && point.y.abs() <= GUARD_BAND);
                prop_assert!((0.0..=1.0).contains(&point.z));
            }
        }
    }
}
