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
    /// About the eye, along the world's axes.
    pub(crate) position: Vec3<N>,
    /// In world space, turned to the side that is seen; not of unit length.
    pub(crate) normal: Vec3<N>,
    /// What any of them has beside these.
    pub(crate) has: Attributes,
    /// That.
    extras: Extras<N>,
}

/// What only some surfaces have.
#[derive(Clone, Copy)]
struct Extras<N> {
    /// In world space, with the bitangent's sign; 0 where there is none.
    tangent: [N; 4],
    /// Two sets; 0 where there are none.
    uv: [Footprint<N>; 2],
    /// With alpha; white where there is none.
    color: [N; 4],
    /// What was computed elsewhere.
    light: Rgb<N>,
}

impl<N: Number> Extras<N> {
    #[inline(always)]
    fn nothing(like: N) -> Self {
        let zero = like.zero();
        Self {
            tangent: [zero; 4],
            uv: [[[zero; 2]; 3]; 2],
            color: [like.one(); 4],
            light: Rgb::black(like),
        }
    }
}

impl<N: Number> Varying<N> {
    /// Where nothing is seen; `like` tells only the kind of number.
    #[inline(always)]
    pub(crate) fn nothing(like: N) -> Self {
        Self {
            position: Vec3::splat(like, [0.0; 3]),
            normal: Vec3::splat(like, [0.0; 3]),
            has: Attributes::default(),
            extras: Extras::nothing(like),
        }
    }

    /// In world space, with the bitangent's sign; 0 where there is none.
    #[inline(always)]
    pub(crate) fn tangent(&self) -> [N; 4] {
        self.extras.tangent
    }

    /// Texture coordinates of a set; 0 where there are none.
    #[inline(always)]
    pub(crate) fn uv(&self, set: usize) -> Footprint<N> {
        self.extras.uv[set]
    }

    /// With alpha; white where there is none.
    #[inline(always)]
    pub(crate) fn color(&self) -> [N; 4] {
        self.extras.color
    }

    /// What was computed elsewhere.
    #[inline(always)]
    pub(crate) fn light(&self) -> Rgb<N> {
        self.extras.light
    }

    /// Takes places and normals where the mask is true.
    #[inline(always)]
    pub(crate) fn take_places(&mut self, position: Vec3<N>, normal: Vec3<N>, mask: N::Mask) {
        self.position = position.select(mask, self.position);
        self.normal = normal.select(mask, self.normal);
    }

    /// Takes one triangle's surface at some lanes: what its mesh `has`, and its corners' light if
    /// they bring it. Of places and normals, lanes of triangles yet to come may take theirs, too.
    #[inline(always)]
    pub(crate) fn take(
        &mut self,
        corners: &[Corner; 3],
        weights: &Weights<N>,
        has: Attributes,
        lights: bool,
        [lanes, or_more]: [u32; 2],
    ) {
        let mask = self.position.x.mask_of(or_more);
        let (position, normal) = places_at(corners, &weights.here);
        self.take_places(position, normal, mask);
        if lights || has != Attributes::default() {
            self.take_extras(corners, weights, has, lights, self.position.x.mask_of(lanes));
        }
    }

    #[inline(always)]
    fn take_extras(
        &mut self,
        [a, b, c]: &[Corner; 3],
        weights: &Weights<N>,
        has: Attributes,
        lights: bool,
        mask: N::Mask,
    ) {
        let here = &weights.here;
        self.has.join(has);
        let extras = &mut self.extras;
        for set in (0..2).filter(|&set| has.uvs[set]) {
            let corners = [&a.uv[set], &b.uv[set], &c.uv[set]];
            let [here, right, below] = &mut extras.uv[set];
            merge(here, mixed(corners, &weights.here), mask);
            merge(right, mixed(corners, &weights.right), mask);
            merge(below, mixed(corners, &weights.below), mask);
        }
        if has.tangents {
            let corners = [&a.tangent, &b.tangent, &c.tangent];
            merge(&mut extras.tangent, mixed(corners, here), mask);
        }
        if has.colors {
            merge(&mut extras.color, mixed([&a.color, &b.color, &c.color], here), mask);
        }
        if lights {
            let [r, g, b] = mixed([&a.light, &b.light, &c.light], here);
            extras.light = Rgb::new(r, g, b).select(mask, extras.light);
        }
    }

    /// Takes what a mesh `has` beside places and normals, a triangle for each lane, where the mask
    /// is true.
    #[inline(always)]
    pub(crate) fn take_gathered(
        &mut self,
        corners: &GatheredExtras,
        weights: &Weights<N>,
        has: Attributes,
        mask: N::Mask,
    ) {
        self.has.join(has);
        let extras = &mut self.extras;
        for set in (0..2).filter(|&set| has.uvs[set]) {
            let [at, at_right, at_below] = &mut extras.uv[set];
            merge(at, mixed_lanes(&corners.uvs[set], &weights.here), mask);
            merge(at_right, mixed_lanes(&corners.uvs[set], &weights.right), mask);
            merge(at_below, mixed_lanes(&corners.uvs[set], &weights.below), mask);
        }
        if has.tangents {
            merge(&mut extras.tangent, mixed_lanes(&corners.tangents, &weights.here), mask);
        }
        if has.colors {
            merge(&mut extras.color, mixed_lanes(&corners.colors, &weights.here), mask);
        }
    }

    /// Takes the surface of a single sample in one lane.
    pub(crate) fn take_lane(&mut self, lane: usize, one: &Varying<f32>) {
        let put = |into: &mut N, value: f32| *into = into.with_lane(lane, value);
        put(&mut self.position.x, one.position.x);
        put(&mut self.position.y, one.position.y);
        put(&mut self.position.z, one.position.z);
        put(&mut self.normal.x, one.normal.x);
        put(&mut self.normal.y, one.normal.y);
        put(&mut self.normal.z, one.normal.z);
        self.has.join(one.has);
        let Extras { tangent, uv, color, light } = one.extras;
        let extras = &mut self.extras;
        put(&mut extras.light.r, light.r);
        put(&mut extras.light.g, light.g);
        put(&mut extras.light.b, light.b);
        for (into, value) in extras.tangent.iter_mut().zip(tangent) {
            put(into, value);
        }
        for (into, value) in extras.color.iter_mut().zip(color) {
            put(into, value);
        }
        for (into, value) in
            extras.uv.iter_mut().flatten().flatten().zip(uv.iter().flatten().flatten())
        {
            put(into, *value);
        }
    }

    /// Takes the light of one lane.
    #[inline(always)]
    pub(crate) fn take_light(&mut self, lane: usize, [r, g, b]: [f32; 3]) {
        let light = &mut self.extras.light;
        light.r = light.r.with_lane(lane, r);
        light.g = light.g.with_lane(lane, g);
        light.b = light.b.with_lane(lane, b);
    }
}

impl Varying<f32> {
    /// A corner, or any place between corners.
    pub(crate) fn at(corner: &Corner, has: Attributes) -> Self {
        let [x, y, z] = corner.position;
        let [normal_x, normal_y, normal_z] = corner.normal;
        let [r, g, b] = corner.light;
        Self {
            position: Vec3::new(x, y, z),
            normal: Vec3::new(normal_x, normal_y, normal_z),
            has,
            extras: Extras {
                tangent: corner.tangent,
                // Textures by their finest level.
                uv: corner.uv.map(|uv| [uv; 3]),
                color: corner.color,
                light: Rgb::new(r, g, b),
            },
        }
    }
}

/// A value of so many components at three corners, for each lane's triangle.
pub(crate) type AtCorners<const C: usize> = [[[f32; LANES]; C]; 3];

/// What triangles have beside places and normals, lane by lane.
pub(crate) struct GatheredExtras {
    /// In world space.
    pub(crate) tangents: AtCorners<4>,
    pub(crate) uvs: [AtCorners<2>; 2],
    pub(crate) colors: AtCorners<4>,
}

/// Place and normal between a triangle's corners.
#[inline(always)]
pub(crate) fn places_at<N: Number>(
    [a, b, c]: &[Corner; 3],
    weights: &[N; 3],
) -> (Vec3<N>, Vec3<N>) {
    let [x, y, z] = mixed([&a.position, &b.position, &c.position], weights);
    let [across, up, towards] = mixed([&a.normal, &b.normal, &c.normal], weights);
    (Vec3::new(x, y, z), Vec3::new(across, up, towards))
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
fn mixed_lanes<const C: usize, N: Number>([a, b, c]: &AtCorners<C>, [u, v, w]: &[N; 3]) -> [N; C] {
    let mut mixed = [*u; C];
    for component in 0..C {
        mixed[component] = u.load(&a[component], 0) * *u
            + u.load(&b[component], 0) * *v
            + u.load(&c[component], 0) * *w;
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
