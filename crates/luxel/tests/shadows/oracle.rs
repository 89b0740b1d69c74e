//! Rays to all triangles, in `f64`.

use luxel::scene::{DVec3, Scene};

/// A triangle of a scene in world space.
pub(crate) struct Facet {
    object: usize,
    triangle: u32,
    pub(crate) corners: [DVec3; 3],
    /// The unit normal, and the unit vectors from each edge inwards; `None` if all corners are in a line.
    frame: Option<(DVec3, [DVec3; 3])>,
}

impl Facet {
    fn new(object: usize, triangle: u32, corners: [DVec3; 3]) -> Self {
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).try_normalize();
        let inwards =
            |normal: DVec3| [b - a, c - b, a - c].map(|edge| normal.cross(edge).normalize());
        Self { object, triangle, corners, frame: normal.map(|normal| (normal, inwards(normal))) }
    }

    /// Whether it is a triangle of an object.
    pub(crate) fn is(&self, object: usize, triangle: Option<u32>) -> bool {
        self.object == object && Some(self.triangle) == triangle
    }

    /// How clearly a ray meets it: the distance to it, and by how much it lies within (negative: outside), as a length.
    pub(crate) fn meeting(&self, origin: DVec3, direction: DVec3) -> Option<(f64, f64)> {
        let (normal, [of_ab, of_bc, of_ca]) = self.frame?;
        let along = normal.dot(direction);
        if along.abs() < 1e-12 {
            return None;
        }
        let [a, b, c] = self.corners;
        let t = normal.dot(a - origin) / along;
        let place = origin + direction * t;
        let inside = (place - a).dot(of_ab).min((place - b).dot(of_bc)).min((place - c).dot(of_ca));
        // What a shift of the ray makes of it where it meets the plane at a flat angle.
        Some((t, inside * along.abs()))
    }
}

/// All triangles of a scene.
pub(crate) fn triangles(scene: &Scene) -> Vec<Facet> {
    let of = |(number, object): (usize, luxel::scene::Object)| {
        let mesh = &scene.meshes[object.mesh.index()];
        (0..)
            .zip(&mesh.triangles)
            .map(move |(triangle, corners)| {
                let place = |vertex| {
                    object.world_from_mesh.matrix().transform_point3(mesh.position(vertex))
                };
                Facet::new(number, triangle, corners.map(place))
            })
            .collect::<Vec<_>>()
    };
    scene.objects().into_iter().enumerate().flat_map(of).collect()
}

/// The openness of a place by rays to all triangles, in `f64`, from 24 x 24 parts of the hemisphere of equal
/// weight about the normal; directions below the plane that faces the eye are mirrored at it.
pub(crate) fn reference(
    all: &[Facet],
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
        let blocks = |facet: &Facet| {
            facet.meeting(place, direction).is_some_and(|(t, inside)| t > margin && inside > 0.0)
        };
        open += f64::from(u8::from(!all.iter().any(blocks)));
    }
    open / (SIDE * SIDE) as f64
}
