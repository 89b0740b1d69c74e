//! The vectors of one light, drawn in the plane of N and L: there their angles are true. What
//! leaves that plane is drawn where it falls onto it, shortened and dashed.

use super::escape::escaped;
use crate::equation::{LightEntry, ShadingPoint, highlight_vector};
use std::fmt::Write;

/// Units of the drawing.
const WIDTH: f64 = 260.0;
const HEIGHT: f64 = 148.0;
/// Where a vector points into the surface.
const HEIGHT_BELOW: f64 = 232.0;
const MIDDLE: f64 = 130.0;
const GROUND: f64 = 128.0;
/// A unit vector in the plane.
const LENGTH: f64 = 92.0;
/// A vector that is at least so long in the plane lies in it, to the eye.
const IN_PLANE: f64 = 0.995;

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn wide(vector: [f32; 3]) -> Vector {
    vector.map(f64::from)
}

fn unit(vector: Vector) -> Option<Vector> {
    let length = dot(vector, vector).sqrt();
    (length > 1e-6).then(|| vector.map(|side| side / length))
}

/// The angle between unit vectors, in degrees.
fn degrees(a: Vector, b: Vector) -> f64 {
    libm::acos(dot(a, b).clamp(-1.0, 1.0)).to_degrees()
}

/// The component of a vector perpendicular to another.
fn across(vector: Vector, axis: Vector) -> Vector {
    let along = dot(vector, axis);
    std::array::from_fn(|side| vector[side] - along * axis[side])
}

/// The direction in the surface that goes towards the light: else away from the eye, else any.
fn tangent(normal: Vector, to_light: Vector, view: Vector) -> Vector {
    let flattest = if normal[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    unit(across(to_light, normal))
        .or_else(|| unit(across(view.map(|side| -side), normal)))
        .or_else(|| unit(across(flattest, normal)))
        .unwrap_or(flattest)
}

/// The vectors of a light as a figure; nothing for a light at the surface itself.
pub(crate) fn of_light(point: &ShadingPoint<'_>, entry: &LightEntry<'_>) -> String {
    let light = entry.light;
    let (Some(n), Some(l), Some(v)) = (
        unit(wide(point.normal)),
        unit(wide(light.terms.to_light.lane(0))),
        unit(wide(point.view)),
    ) else {
        return String::new();
    };
    let highlight =
        highlight_vector(point, light).and_then(|(name, vector)| Some((name, unit(wide(vector))?)));
    let t = tangent(n, l, v);
    let angle = degrees(n, l);
    let mut facts = format!("N to L {angle:.1}°, N to V {:.1}°", degrees(n, v));
    match highlight {
        Some(("R", r)) => {
            let _ = write!(facts, ", R to V {:.1}°", degrees(r, v));
        }
        Some((name, h)) => {
            let _ = write!(facts, ", N to {name} {:.1}°", degrees(n, h));
        }
        None => {}
    }
    let name = escaped(&light.name);
    let dark = if entry.why_not.is_some() { " class=\"dark\"" } else { "" };
    let drawn = [Some(l), Some(v), highlight.map(|(_, vector)| vector)];
    let below = drawn.into_iter().flatten().any(|vector| dot(vector, n) < -0.05);
    let height = if below { HEIGHT_BELOW } else { HEIGHT };
    let mut text = format!(
        "<figure{dark}><svg viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" \
         aria-label=\"Vectors of the light {name}: {facts}\">\n"
    );
    ground(&mut text);
    arrow(&mut text, "n", "N", n, [t, n]);
    arrow(&mut text, "l", "L", l, [t, n]);
    if let Some((name, vector)) = highlight {
        arrow(&mut text, "r", name, vector, [t, n]);
    }
    arrow(&mut text, "v", "V", v, [t, n]);
    arc(&mut text, angle);
    let _ =
        write!(text, "<circle class=\"point\" cx=\"{MIDDLE}\" cy=\"{GROUND}\" r=\"3\"/>\n</svg>");
    let mut outside = Vec::new();
    for (name, vector) in [("V", v)].into_iter().chain(highlight) {
        let out = 90.0 - degrees(vector, cross(n, t));
        if length_in_plane(vector, [t, n]) < IN_PLANE {
            outside.push(format!("{name} leaves the plane by {:.1}°", out.abs()));
        }
    }
    let outside =
        if outside.is_empty() { String::new() } else { format!("; {}", outside.join(", ")) };
    let _ = writeln!(
        text,
        "<figcaption><strong>{name}</strong> {facts}{outside}</figcaption></figure>"
    );
    text
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length_in_plane(vector: Vector, [t, n]: [Vector; 2]) -> f64 {
    let (right, up) = (dot(vector, t), dot(vector, n));
    (right * right + up * up).sqrt()
}

/// The surface, cut: a line with the inside hatched.
fn ground(text: &mut String) {
    let (left, right) = (18.0, WIDTH - 18.0);
    let _ = writeln!(
        text,
        "<line class=\"ground\" x1=\"{left}\" y1=\"{GROUND}\" x2=\"{right}\" y2=\"{GROUND}\"/>"
    );
    let mut path = String::new();
    let mut x = left + 10.0;
    while x <= right {
        let _ = write!(path, "M{x} {GROUND}l-8 8");
        x += 10.0;
    }
    let _ = writeln!(text, "<path class=\"hatch\" d=\"{path}\"/>");
}

/// The angle between N and L, with its number.
fn arc(text: &mut String, degrees: f64) {
    const RADIUS: f64 = 34.0;
    if degrees < 4.0 {
        return;
    }
    let at = |degrees: f64, radius: f64| {
        let radians = degrees.to_radians();
        // Light comes from the left.
        (MIDDLE - libm::sin(radians) * radius, GROUND - libm::cos(radians) * radius)
    };
    let (x, y) = at(degrees, RADIUS);
    let top = GROUND - RADIUS;
    let (tx, ty) = at(degrees / 2.0, RADIUS + 15.0);
    let _ = writeln!(
        text,
        "<path class=\"arc\" d=\"M{MIDDLE} {top}A{RADIUS} {RADIUS} 0 0 0 {x:.1} {y:.1}\"/>\
         <text class=\"axis\" x=\"{tx:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{degrees:.0}°</text>",
        ty + 3.0
    );
}

/// A unit vector as it falls onto the plane.
fn arrow(text: &mut String, class: &str, name: &str, vector: Vector, plane: [Vector; 2]) {
    let [t, n] = plane;
    let (left, up) = (dot(vector, t), dot(vector, n));
    let (x, y) = (MIDDLE - left * LENGTH, GROUND - up * LENGTH);
    let length = length_in_plane(vector, plane);
    let dashed = if length < IN_PLANE { " stroke-dasharray=\"5 4\"" } else { "" };
    let _ = write!(
        text,
        "<g class=\"vector {class}\"><line x1=\"{MIDDLE}\" y1=\"{GROUND}\" x2=\"{x:.1}\" y2=\"{y:.1}\"{dashed}/>"
    );
    // The head, and the name beyond it; straight at the eye there is neither direction nor head.
    let (dx, dy) = if length > 0.02 { (-left / length, -up / length) } else { (0.0, -1.0) };
    let wing = |side: f64| (x - 9.0 * dx - side * 4.0 * dy, y - 9.0 * dy + side * 4.0 * dx);
    let ((ax, ay), (bx, by)) = (wing(1.0), wing(-1.0));
    let _ = write!(text, "<path d=\"M{x:.1} {y:.1}L{ax:.1} {ay:.1}L{bx:.1} {by:.1}z\"/>");
    let (tx, ty) = (x + 12.0 * dx, y + 12.0 * dy + 4.0);
    let _ = writeln!(
        text,
        "<text x=\"{tx:.1}\" y=\"{ty:.1}\" text-anchor=\"middle\">{name}</text></g>"
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn in_the_plane_of_n_and_l_angles_are_true() {
        let n = [0.0, 0.0, 1.0];
        let l = unit([1.0, 2.0, 2.0]).unwrap();
        let plane = [tangent(n, l, [0.0, 1.0, 0.0]), n];
        assert!((length_in_plane(l, plane) - 1.0).abs() < 1e-12);
        assert!((dot(l, plane[0]) - (1.0 - dot(l, n) * dot(l, n)).sqrt()).abs() < 1e-12);
        // A perpendicular vector has no length there.
        assert!(length_in_plane(cross(plane[0], n), plane) < 1e-12);
    }

    #[test]
    fn the_plane_is_one_even_where_light_falls_straight() {
        let n = [0.0, 1.0, 0.0];
        for view in [n, [0.6, 0.8, 0.0]] {
            let t = tangent(n, n, view);
            assert!((dot(t, t) - 1.0).abs() < 1e-12 && dot(t, n).abs() < 1e-12);
        }
    }
}
