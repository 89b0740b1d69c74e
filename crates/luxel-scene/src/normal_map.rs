//! Applies a normal map's texel to a normal.

use luxel_math::{Lanes, Vec3};

/// The unit normal n = x T + y B + z N with B = sign (N x T), where (x, y, z) is the texel brought
/// from 0..1 to -1..1 and x, y are scaled by the map's strength; N itself where that is 0.
#[inline(always)]
pub fn mapped_normal<N: Lanes>(
    normal: Vec3<N>,
    (tangent, sign): (Vec3<N>, N),
    [r, g, b]: [N; 3],
    strength: f32,
) -> Vec3<N> {
    let strength = r.constant(strength);
    let bitangent = normal.cross(tangent) * sign;
    let mapped =
        tangent * (signed(r) * strength) + bitangent * (signed(g) * strength) + normal * signed(b);
    let mapped = mapped.normalized_or_zero();
    let sound = r.zero().less(mapped.dot(mapped));
    mapped.select(sound, normal)
}

/// A texel's value as a signed number: 0..1 becomes -1..1.
#[inline(always)]
fn signed<N: Lanes>(value: N) -> N {
    value + value - value.one()
}
