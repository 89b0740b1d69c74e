//! Surfaces of revolution about the y axis: a profile, turned.

use super::FINEST;
use super::builder::{MeshBuilder, SurfacePoint};
use crate::Mesh;
use glam::{DVec2, DVec3};

/// A sphere of `columns` x `rows` quadrilaterals along longitude (3 to [`FINEST`]) and latitude
/// (2 to [`FINEST`]), with triangles at the poles.
///
/// The texture is a plate carrée map: its middle faces +Z, its upper edge is the pole at +Y.
#[must_use]
pub fn sphere(radius: f64, columns: u32, rows: u32) -> Mesh {
    let rows = rows.clamp(2, FINEST);
    let profile = (0..=rows).map(|row| {
        // Half a turn from the upper pole to the lower one.
        let direction = of_turn(row, 2 * rows);
        let (normal, v) = (DVec2::new(direction.y, direction.x), f64::from(row) / f64::from(rows));
        ProfilePoint { place: normal * radius, normal, v }
    });
    revolved(&[profile.collect()], columns)
}

/// A torus: a tube of `tube_radius` round a ring of `ring_radius` in the plane y = 0, of `columns`
/// quadrilaterals along the ring and `rows` round the tube (3 to [`FINEST`] each).
#[must_use]
pub fn torus(ring_radius: f64, tube_radius: f64, columns: u32, rows: u32) -> Mesh {
    let rows = rows.clamp(3, FINEST);
    let profile = (0..=rows).map(|row| {
        // From the innermost circle over the top, outside, and back below.
        let direction = of_turn(row, rows);
        let (normal, v) = (DVec2::new(-direction.x, direction.y), f64::from(row) / f64::from(rows));
        ProfilePoint { place: DVec2::new(ring_radius, 0.0) + normal * tube_radius, normal, v }
    });
    revolved(&[profile.collect()], columns)
}

/// A cylinder along y with flat ends, `columns` faces round (3 to [`FINEST`]).
#[must_use]
pub fn cylinder(radius: f64, height: f64, columns: u32) -> Mesh {
    let half = height * 0.5;
    let straight = |from: DVec2, to: DVec2, normal: DVec2| {
        vec![
            ProfilePoint { place: from, normal, v: 0.0 },
            ProfilePoint { place: to, normal, v: 1.0 },
        ]
    };
    let (top, bottom) = (DVec2::new(radius, half), DVec2::new(radius, -half));
    let profiles = [
        straight(DVec2::new(0.0, half), top, DVec2::Y),
        straight(top, bottom, DVec2::X),
        straight(bottom, DVec2::new(0.0, -half), DVec2::NEG_Y),
    ];
    revolved(&profiles, columns)
}

/// A cone along y with its apex above and a flat base, `columns` faces round and `rows` from the
/// apex to the base (1 to [`FINEST`]); more rows shade the apex more finely.
#[must_use]
pub fn cone(radius: f64, height: f64, columns: u32, rows: u32) -> Mesh {
    let rows = rows.clamp(1, FINEST);
    let half = height * 0.5;
    // Perpendicular to the slope, which falls by `height` over `radius`.
    let normal = DVec2::new(height, radius);
    let slope = (0..=rows).map(|row| {
        let v = f64::from(row) / f64::from(rows);
        ProfilePoint { place: DVec2::new(radius * v, half - height * v), normal, v }
    });
    let base = [(radius, 0.0), (0.0, 1.0)].map(|(r, v)| ProfilePoint {
        place: DVec2::new(r, -half),
        normal: DVec2::NEG_Y,
        v,
    });
    revolved(&[slope.collect(), base.to_vec()], columns)
}

/// A point of a profile: x is the distance from the axis, y the height.
#[derive(Clone, Copy)]
struct ProfilePoint {
    place: DVec2,
    /// Outwards, of any length but 0.
    normal: DVec2,
    v: f64,
}

/// Turns profiles, which run downwards seen from their front, about the axis.
fn revolved(profiles: &[Vec<ProfilePoint>], columns: u32) -> Mesh {
    let columns = columns.clamp(3, FINEST);
    let mut builder = MeshBuilder::default();
    for profile in profiles {
        builder.grid(columns, profile.len() as u32 - 1, |column, row| {
            let ProfilePoint { place, normal, v } = profile[row as usize];
            let pole = place.x == 0.0;
            // At a pole the vertex belongs to the triangle between two columns.
            let (steps, turn) =
                if pole { (2 * columns, 2 * column + 1) } else { (columns, column) };
            // The seam is at the back; from there, seen from outside, to the right.
            let back = of_turn(turn % steps, steps);
            let radial = DVec3::new(-back.y, 0.0, -back.x);
            SurfacePoint {
                position: radial * place.x + DVec3::Y * place.y,
                normal: radial * normal.x + DVec3::Y * normal.y,
                uv: DVec2::new(f64::from(turn) / f64::from(steps), v),
            }
        });
    }
    builder.finish()
}

/// The cosine and sine of `step` of `steps` equal parts of a turn.
///
/// Quarter turns are exact and the four quarters have the same digits, so that circles close and
/// poles are points.
fn of_turn(step: u32, steps: u32) -> DVec2 {
    let fourfold = 4 * u64::from(step % steps);
    let quarter = fourfold / u64::from(steps);
    let rest = (fourfold % u64::from(steps)) as f64 / f64::from(steps);
    let (sin, cos) = libm::sincos(rest * std::f64::consts::FRAC_PI_2);
    match quarter {
        0 => DVec2::new(cos, sin),
        1 => DVec2::new(-sin, cos),
        2 => DVec2::new(-cos, -sin),
        _ => DVec2::new(sin, -cos),
    }
}
