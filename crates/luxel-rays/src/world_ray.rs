//! Rays and hits in world space.

use glam::DVec3;
use luxel_bvh::Ray;

/// A world-space ray: all points `origin + t * direction` with t within `range`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldRay {
    /// The point at t = 0.
    pub origin: DVec3,
    /// The direction, of any length but 0; t counts in units of this length.
    pub direction: DVec3,
    /// The smallest t, not below 0, and the largest, which may be infinite.
    pub range: [f64; 2],
}

/// Where a ray hits a triangle of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldHit {
    /// The distance along the ray, in units of the direction's length.
    pub t: f64,
    /// The object, by its index in [`SceneRays::objects`](crate::SceneRays::objects).
    pub object: usize,
    /// The triangle's number in the object; [`SceneRays::in_body`](crate::SceneRays::in_body) finds it in a mesh.
    pub triangle: u32,
    /// Barycentric coordinates: the weights of the triangle's corners.
    pub barycentric: [f64; 3],
    /// The position in world space.
    pub position: DVec3,
}

impl WorldRay {
    /// An infinite ray.
    #[must_use]
    pub const fn new(origin: DVec3, direction: DVec3) -> Self {
        Self { origin, direction, range: [0.0, f64::INFINITY] }
    }

    pub(crate) fn is_valid(&self) -> bool {
        self.origin.is_finite()
            && self.direction.is_finite()
            && self.direction != DVec3::ZERO
            && self.range[0] >= 0.0
            && self.range[1] >= self.range[0]
    }
}

/// A ray in `f32`: its origin moved close to a box, and the mapping of its t to world space.
#[derive(Clone, Copy, Debug)]
pub struct RebasedRay {
    /// The ray, with a direction of unit length.
    pub ray: Ray,
    /// t of the world = `start + scale * t`.
    pub start: f64,
    /// The world's t over the ray's.
    pub scale: f64,
}

impl RebasedRay {
    /// From a ray in a box's own coordinates; `None` if it misses the box's bounding sphere.
    #[must_use]
    pub fn new(
        origin: DVec3,
        direction: DVec3,
        range: [f64; 2],
        bounds: [[f32; 3]; 2],
    ) -> Option<Self> {
        Self::near(origin, direction, range, centre_and_radius(bounds))
    }

    /// [`RebasedRay::new`] from the box's bounding sphere.
    #[inline]
    pub(crate) fn near(
        origin: DVec3,
        direction: DVec3,
        range: [f64; 2],
        (centre, radius): (DVec3, f64),
    ) -> Option<Self> {
        let length = direction.length();
        let unit = direction / length;
        if range[0] == 0.0 && (origin - centre).length_squared() <= radius * radius {
            // Rays that begin inside are as near as they can be: those of shadows all do.
            let ray = Ray {
                origin: origin.as_vec3().to_array(),
                direction: unit.as_vec3().to_array(),
                range: [0.0, ((range[1] * length) as f32).next_up()],
            };
            return Some(Self { ray, start: 0.0, scale: 1.0 / length });
        }
        let along = (centre - origin).dot(unit);
        let aside = (origin + unit * along - centre).length_squared();
        // Twice the radius: squares of large distances round.
        let is_near = aside <= 4.0 * radius * radius;
        let enter = (along - 2.0 * radius).max(range[0] * length);
        let leave = (along + 2.0 * radius).min(range[1] * length);
        let hits = is_near && enter <= leave;
        if !hits {
            return None;
        }
        let start = origin + unit * enter;
        let ray = Ray {
            origin: start.as_vec3().to_array(),
            direction: unit.as_vec3().to_array(),
            range: [0.0, ((leave - enter) as f32).next_up()],
        };
        Some(Self { ray, start: enter / length, scale: 1.0 / length })
    }
}

/// The sphere around a box, a little larger.
pub(crate) fn centre_and_radius([low, high]: [[f32; 3]; 2]) -> (DVec3, f64) {
    let corner =
        |corner: [f32; 3]| DVec3::new(corner[0].into(), corner[1].into(), corner[2].into());
    let (low, high) = (corner(low), corner(high));
    let centre = low * 0.5 + high * 0.5;
    let radius = (high - low).length() * 0.500_001 + centre.length() * 1e-6 + f64::MIN_POSITIVE;
    (centre, radius)
}
