//! What varies over triangles, mixed from their corners for sixteen samples.

use crate::triangles::{Attributes, Corner};
use luxel_math::{LANES, Number, Rgb, Vec3};

/// Barycentrics at a sample, and one pixel to the right and one below in the triangle's plane: how
/// textures learn what a pixel covers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weights<N> {
    pub(crate) here: [N; 3],
    pub(crate) right: [N; 3],
    pub(crate) below: [N; 3],
}

/// Texture coordinates at a sample, one pixel to the right and one below.
pub(crate) type Footprint<N> = [[N; 2]; 3];

/// The surfaces that samples see.
#[derive(Clone, Copy)]
pub(crate) struct Varying<N> {
    /// What any of them has beside a place and a normal.
    pub(crate) has: Attributes,
    /// About the eye, along the world's axes.
    pub(crate) position: Vec3<N>,
    /// In world space, turned to the side that is seen; not of unit length.
    pub(crate) normal: Vec3<N>,
    /// In world space, with the bitangent's sign; 0 where there is none.
    pub(crate) tangent: [N; 4],
    /// Two sets; 0 where there are none.
    pub(crate) uv: [Footprint<N>; 2],
    /// With alpha; white where there is none.
    pub(crate) color: [N; 4],
    /// What was computed elsewhere.
    pub(crate) light: Rgb<N>,
}

impl<N: Number> Varying<N> {
    /// Where nothing is seen; `like` tells only the kind of number.
    #[inline(always)]
    pub(crate) fn nothing(like: N) -> Self {
        let zero = like.zero();
        Self {
            has: Attributes::default(),
            position: Vec3::splat(like, [0.0; 3]),
            normal: Vec3::splat(like, [0.0; 3]),
            tangent: [zero; 4],
            uv: [[[zero; 2]; 3]; 2],
            color: [like.one(); 4],
            light: Rgb::black(like),
        }
    }

    /// Takes one triangle's surface where the mask is true: what its mesh `has`, and its corners'
    /// light if they bring it.
    #[inline(always)]
    pub(crate) fn take(
        &mut self,
        [a, b, c]: &[Corner; 3],
        weights: &Weights<N>,
        has: Attributes,
        lights: bool,
        mask: N::Mask,
    ) {
        let here = &weights.here;
        let [x, y, z] = mixed([&a.position, &b.position, &c.position], here);
        self.position = Vec3::new(x, y, z).select(mask, self.position);
        let [x, y, z] = mixed([&a.normal, &b.normal, &c.normal], here);
        self.normal = Vec3::new(x, y, z).select(mask, self.normal);
        self.has.join(has);
        for set in (0..2).filter(|&set| has.uvs[set]) {
            let corners = [&a.uv[set], &b.uv[set], &c.uv[set]];
            let [here, right, below] = &mut self.uv[set];
            merge(here, mixed(corners, &weights.here), mask);
            merge(right, mixed(corners, &weights.right), mask);
            merge(below, mixed(corners, &weights.below), mask);
        }
        if has.tangents {
            let corners = [&a.tangent, &b.tangent, &c.tangent];
            merge(&mut self.tangent, mixed(corners, here), mask);
        }
        if has.colors {
            merge(&mut self.color, mixed([&a.color, &b.color, &c.color], here), mask);
        }
        if lights {
            let [r, g, b] = mixed([&a.light, &b.light, &c.light], here);
            self.light = Rgb::new(r, g, b).select(mask, self.light);
        }
    }

    /// Takes the surface of a single sample in one lane.
    pub(crate) fn take_lane(&mut self, lane: usize, one: &Varying<f32>) {
        let Varying { has, position, normal, tangent, uv, color, light } = *one;
        self.has.join(has);
        let put = |into: &mut N, value: f32| *into = into.with_lane(lane, value);
        put(&mut self.position.x, position.x);
        put(&mut self.position.y, position.y);
        put(&mut self.position.z, position.z);
        put(&mut self.normal.x, normal.x);
        put(&mut self.normal.y, normal.y);
        put(&mut self.normal.z, normal.z);
        put(&mut self.light.r, light.r);
        put(&mut self.light.g, light.g);
        put(&mut self.light.b, light.b);
        for (into, value) in self.tangent.iter_mut().zip(tangent) {
            put(into, value);
        }
        for (into, value) in self.color.iter_mut().zip(color) {
            put(into, value);
        }
        for (into, value) in
            self.uv.iter_mut().flatten().flatten().zip(uv.iter().flatten().flatten())
        {
            put(into, *value);
        }
    }

    /// Takes the light of one lane.
    #[inline(always)]
    pub(crate) fn take_light(&mut self, lane: usize, [r, g, b]: [f32; 3]) {
        self.light.r = self.light.r.with_lane(lane, r);
        self.light.g = self.light.g.with_lane(lane, g);
        self.light.b = self.light.b.with_lane(lane, b);
    }
}

impl Varying<f32> {
    /// A corner, or any place between corners.
    pub(crate) fn at(corner: &Corner, has: Attributes) -> Self {
        let [x, y, z] = corner.position;
        let [normal_x, normal_y, normal_z] = corner.normal;
        let [r, g, b] = corner.light;
        Self {
            has,
            position: Vec3::new(x, y, z),
            normal: Vec3::new(normal_x, normal_y, normal_z),
            tangent: corner.tangent,
            // Textures by their finest level.
            uv: corner.uv.map(|uv| [uv; 3]),
            color: corner.color,
            light: Rgb::new(r, g, b),
        }
    }
}

/// Values of three corners, mixed by weights: one triangle for all lanes.
#[inline(always)]
fn mixed<const C: usize, N: Number>([a, b, c]: [&[f32; C]; 3], [u, v, w]: &[N; 3]) -> [N; C] {
    let mut mixed = [*u; C];
    for component in 0..C {
        mixed[component] = u.constant(a[component]) * *u
            + u.constant(b[component]) * *v
            + u.constant(c[component]) * *w;
    }
    mixed
}

/// Values of three corners by component, mixed by weights: a triangle for each lane.
#[inline(always)]
pub(crate) fn mixed_lanes<const C: usize, N: Number>(
    [a, b, c]: &[[[f32; LANES]; C]; 3],
    [u, v, w]: &[N; 3],
) -> [N; C] {
    let mut mixed = [*u; C];
    for component in 0..C {
        mixed[component] = u.of_lanes(&a[component]) * *u
            + u.of_lanes(&b[component]) * *v
            + u.of_lanes(&c[component]) * *w;
    }
    mixed
}

/// Takes new values where the mask is true.
#[inline(always)]
pub(crate) fn merge<const C: usize, N: Number>(values: &mut [N; C], new: [N; C], mask: N::Mask) {
    for component in 0..C {
        values[component] = new[component].select(mask, values[component]);
    }
}

/// The numbers of the bits set.
#[inline(always)]
pub(crate) fn lanes_of(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}
