//! Vertex attributes: at a corner of a triangle, and interpolated for sixteen samples.

use crate::context::AttributeMask;
use luxel_math::{Lanes, Rgb, Vec3};

/// Texture coordinates at a sample, and how they change over a pixel to the right, and down.
pub(crate) type Footprint<N> = [[N; 2]; 3];

/// The surfaces that samples see.
#[derive(Clone, Copy)]
pub(crate) struct Attributes<N> {
    /// About the eye, along the world's axes; 0 where nobody needs it.
    pub(crate) position: Vec3<N>,
    /// In world space, turned to the side that is seen; not of unit length.
    pub(crate) normal: Vec3<N>,
    /// What was computed at the corners or at the corners of pieces, if light comes from there.
    pub(crate) light: Rgb<N>,
    /// Which of the following any of the surfaces has.
    pub(crate) has: AttributeMask,
    /// In world space, with the bitangent's sign; 0 where there is none.
    pub(crate) tangent: [N; 4],
    /// Two sets; 0 where there are none.
    pub(crate) uv: [Footprint<N>; 2],
    /// With alpha; white where there is none.
    pub(crate) color: [N; 4],
}

impl<N: Lanes> Attributes<N> {
    /// Where nothing is seen; `like` selects the lane type.
    #[inline(always)]
    pub(crate) fn nothing(simd: N) -> Self {
        let zero = simd.zero();
        Self {
            position: Vec3::splat(simd, [0.0; 3]),
            normal: Vec3::splat(simd, [0.0; 3]),
            light: Rgb::black(simd),
            has: AttributeMask::NONE,
            tangent: [zero; 4],
            uv: [[[zero; 2]; 3]; 2],
            color: [simd.one(); 4],
        }
    }

    /// At each lane's place between the corners of a triangle, by its weights, as [`Corner::weighted`] has it: what
    /// light depends on, without normal maps.
    #[inline(always)]
    pub(crate) fn between(corners: &[Corner; 3], weights: &[N; 3], has: AttributeMask) -> Self {
        let mut between = Self {
            position: vector_between(corners, |corner| &corner.position, weights),
            normal: vector_between(corners, |corner| &corner.normal, weights),
            has,
            ..Self::nothing(weights[0])
        };
        if has.has(AttributeMask::COLORS) {
            for (channel, lanes) in between.color.iter_mut().enumerate() {
                *lanes = number_between(corners, |corner| corner.color[channel], weights);
            }
        }
        for (set, uv) in between.uv.iter_mut().enumerate() {
            if has.has(AttributeMask::UVS[set]) {
                for (axis, lanes) in uv[0].iter_mut().enumerate() {
                    *lanes = number_between(corners, |corner| corner.uv[set][axis], weights);
                }
            }
        }
        between
    }

    /// Takes the attributes of a single sample in one lane.
    pub(crate) fn put_lane(&mut self, lane: usize, one: &Attributes<f32>) {
        let put = |into: &mut N, value: f32| *into = into.with_lane(lane, value);
        put(&mut self.position.x, one.position.x);
        put(&mut self.position.y, one.position.y);
        put(&mut self.position.z, one.position.z);
        put(&mut self.normal.x, one.normal.x);
        put(&mut self.normal.y, one.normal.y);
        put(&mut self.normal.z, one.normal.z);
        self.put_light(lane, one.light.lane(0));
        self.has = self.has.or(one.has);
        let own = self.tangent.iter_mut().chain(&mut self.color);
        for (into, &value) in own.zip(one.tangent.iter().chain(&one.color)) {
            put(into, value);
        }
        let uvs = self.uv.iter_mut().flatten().flatten();
        for (into, &value) in uvs.zip(one.uv.iter().flatten().flatten()) {
            put(into, value);
        }
    }

    /// Takes the light of one lane.
    #[inline(always)]
    pub(crate) fn put_light(&mut self, lane: usize, [r, g, b]: [f32; 3]) {
        self.light.r = self.light.r.with_lane(lane, r);
        self.light.g = self.light.g.with_lane(lane, g);
        self.light.b = self.light.b.with_lane(lane, b);
    }
}

/// A vector between corners.
#[inline(always)]
fn vector_between<N: Lanes>(
    corners: &[Corner; 3],
    of: impl Fn(&Corner) -> &[f32; 3],
    weights: &[N; 3],
) -> Vec3<N> {
    Vec3::new(
        number_between(corners, |corner| of(corner)[0], weights),
        number_between(corners, |corner| of(corner)[1], weights),
        number_between(corners, |corner| of(corner)[2], weights),
    )
}

#[inline(always)]
fn number_between<N: Lanes>(
    [a, b, c]: &[Corner; 3],
    of: impl Fn(&Corner) -> f32,
    [u, v, w]: &[N; 3],
) -> N {
    u.constant(of(a)) * *u + u.constant(of(b)) * *v + u.constant(of(c)) * *w
}

impl Attributes<f32> {
    /// A corner, or any place between corners. Textures are sampled there by their finest level.
    pub(crate) fn at(corner: &Corner, has: AttributeMask) -> Self {
        let [x, y, z] = corner.position;
        let [normal_x, normal_y, normal_z] = corner.normal;
        let [r, g, b] = corner.light;
        Self {
            position: Vec3::new(x, y, z),
            normal: Vec3::new(normal_x, normal_y, normal_z),
            light: Rgb::new(r, g, b),
            has,
            tangent: corner.tangent,
            uv: corner.uv.map(|uv| [uv, [0.0; 2], [0.0; 2]]),
            color: corner.color,
        }
    }
}

/// A corner of a triangle, or any place between corners.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    /// About the eye, along the world's axes.
    pub(crate) position: [f32; 3],
    /// Of unit length, in world space, turned to the side that is seen.
    pub(crate) normal: [f32; 3],
    /// Of unit length, in world space, with the bitangent's sign.
    pub(crate) tangent: [f32; 4],
    pub(crate) uv: [[f32; 2]; 2],
    /// White where the mesh has none.
    pub(crate) color: [f32; 4],
    /// What goes to the eye, where light is computed at corners.
    pub(crate) light: [f32; 3],
}

impl Corner {
    /// The place a part `t` of the way to another.
    pub(crate) fn mixed(&self, other: &Self, t: f32) -> Self {
        self.scaled(1.0 - t).plus(&other.scaled(t))
    }

    /// A place between three corners, by its weights.
    pub(crate) fn weighted([a, b, c]: &[Self; 3], [u, v, w]: [f32; 3]) -> Self {
        a.scaled(u).plus(&b.scaled(v)).plus(&c.scaled(w))
    }

    /// The mean of corners; `None` of none.
    pub(crate) fn mean(corners: &[Self]) -> Option<Self> {
        let share = 1.0 / corners.len() as f32;
        let (first, rest) = corners.split_first()?;
        let add = |sum: Self, corner: &Self| sum.plus(&corner.scaled(share));
        Some(rest.iter().fold(first.scaled(share), add))
    }

    fn scaled(&self, factor: f32) -> Self {
        Self {
            position: self.position.map(|value| value * factor),
            normal: self.normal.map(|value| value * factor),
            tangent: self.tangent.map(|value| value * factor),
            uv: self.uv.map(|set| set.map(|value| value * factor)),
            color: self.color.map(|value| value * factor),
            light: self.light.map(|value| value * factor),
        }
    }

    fn plus(&self, other: &Self) -> Self {
        fn sum<const N: usize>(a: [f32; N], b: [f32; N]) -> [f32; N] {
            std::array::from_fn(|at| a[at] + b[at])
        }
        Self {
            position: sum(self.position, other.position),
            normal: sum(self.normal, other.normal),
            tangent: sum(self.tangent, other.tangent),
            uv: [sum(self.uv[0], other.uv[0]), sum(self.uv[1], other.uv[1])],
            color: sum(self.color, other.color),
            light: sum(self.light, other.light),
        }
    }
}
