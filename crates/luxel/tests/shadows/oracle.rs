//! Rays to all triangles, in `f64`.

use luxel::scene::{DVec3, Scene};

/// All triangles of a scene in world space, with the objects that they belong to.
pub(crate) fn triangles(scene: &Scene) -> Vec<(usize, u32, [DVec3; 3])> {
    let of = |(number, object): (usize, luxel::scene::Object)| {
        let mesh = &scene.meshes[object.mesh.index()];
        (0..)
            .zip(&mesh.triangles)
            .map(move |(triangle, corners)| {
                let place = |vertex| object.world_from_mesh.transform_point3(mesh.position(vertex));
                (number, triangle, corners.map(place))
            })
            .collect::<Vec<_>>()
    };
    scene.objects().into_iter().enumerate().flat_map(of).collect()
}

/// How clearly a ray meets a triangle: the distance to it, and by how much it lies within (negative:
/// outside), as a length.
pub(crate) fn meeting(
    origin: DVec3,
    direction: DVec3,
    [a, b, c]: [DVec3; 3],
) -> Option<(f64, f64)> {
    let normal = (b - a).cross(c - a).try_normalize()?;
    let along = normal.dot(direction);
    if along.abs() < 1e-12 {
        return None;
    }
    let t = normal.dot(a - origin) / along;
    let place = origin + direction * t;
    let inside = [(a, b), (b, c), (c, a)].map(|(from, to)| {
        let inwards = normal.cross(to - from).try_normalize();
        inwards.map_or(f64::NEG_INFINITY, |inwards| (place - from).dot(inwards))
    });
    // What a shift of the ray makes of it where it meets the plane at a flat angle.
    Some((t, inside.into_iter().fold(f64::INFINITY, f64::min) * along.abs()))
}

/// The openness of a place by rays to all triangles, in `f64`, from 24 x 24 parts of the hemisphere of equal
/// weight about the normal; directions below the plane that faces the eye are mirrored at it.
pub(crate) fn reference(
    all: &[(usize, u32, [DVec3; 3])],
    place: DVec3,
    [normal, facing]: [DVec3; 2],
    margin: f64,
) -> f64 {
    const SIDE: usize = 24;
    let (tangent, bitangent) = normal.any_orthonormal_pair();
    let mut open = 0.0;
    for cell in 0..SIDE * SIDE {
        let [u, v] = [cell / SIDE, cell % SIDE].map(|at| (at as f64 + 0.5) / SIDE as f64);
        let (sine, cosine) = libm::sincos(std::f64::consts::TAU * v);
        let direction =
            (tangent * cosine + bitangent * sine) * u.sqrt() + normal * (1.0 - u).sqrt();
        let direction = direction - 2.0 * direction.dot(facing).min(0.0) * facing;
        let blocks = |corners: [DVec3; 3]| {
            meeting(place, direction, corners).is_some_and(|(t, inside)| t > margin && inside > 0.0)
        };
        open += f64::from(u8::from(!all.iter().any(|(.., corners)| blocks(*corners))));
    }
    open / (SIDE * SIDE) as f64
}
