//! Places of a piece that are lit together, one a lane, and compared with the light between its corners.

use super::texel_light::TexelLight;
use luxel_lighting::{Display, PictureEncoding};
use luxel_math::{
    LANES, Lanes, Level, Rgb, Simd, SplitLanes, dispatch_long, elementary, f32x16, prelude::*,
};

/// A place by its barycentrics.
pub(super) type Place = [f32; 3];

/// The light of a triangle's places.
pub(crate) trait PlaceLight {
    /// The light at each lane's place, by its barycentrics in the triangle. Lanes outside `lanes` are unspecified.
    fn light<N: Lanes>(&self, place: [N; 3], lanes: u32) -> TexelLight<N>;
}

/// How light is compared.
#[derive(Clone, Copy)]
pub(crate) struct Comparison<'a> {
    pub(crate) level: Level,
    /// Exposure and tone curve, if they change anything.
    pub(crate) display: Option<Display>,
    pub(crate) encoding: PictureEncoding,
    /// The texels under which light is compared.
    pub(crate) texels: &'a [f32],
}

/// Up to sixteen places of one piece.
pub(super) struct Tries {
    /// The light of the piece's corners.
    corners: [TexelLight; 3],
    /// How many places there are.
    count: usize,
    /// Barycentrics in the piece.
    weights: [[f32; LANES]; 3],
    /// Barycentrics in the triangle.
    places: [[f32; LANES]; 3],
    lights: [[[f32; LANES]; 3]; 3],
    /// In steps of 8 bits.
    errors: [f32; LANES],
}

impl Tries {
    pub(super) fn new() -> Self {
        Self {
            corners: [TexelLight::untextured([0.0; 3]); 3],
            count: 0,
            weights: [[0.0; LANES]; 3],
            places: [[0.0; LANES]; 3],
            lights: [[[0.0; LANES]; 3]; 3],
            errors: [0.0; LANES],
        }
    }

    /// Starts with the places of another piece, whose corners have this light.
    pub(super) fn begin(&mut self, corners: [TexelLight; 3]) {
        (self.corners, self.count) = (corners, 0);
    }

    /// The light of one place. What was there before is forgotten.
    pub(super) fn light_alone(
        &mut self,
        place: Place,
        light: &impl PlaceLight,
        how: &Comparison<'_>,
    ) -> TexelLight {
        self.begin([TexelLight::untextured([0.0; 3]); 3]);
        self.push([1.0, 0.0, 0.0], place);
        self.compare(light, how);
        self.light(0)
    }

    /// How many places there are.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// Adds a place, by its weights in the piece and in the triangle.
    pub(super) fn push(&mut self, weights: [f32; 3], place: Place) {
        let lane = self.count % LANES;
        for corner in 0..3 {
            self.weights[corner][lane] = weights[corner];
            self.places[corner][lane] = place[corner];
        }
        self.count += 1;
    }

    /// Lights the places and compares their light with what the corners interpolate to. Then there are none.
    pub(super) fn compare(&mut self, light: &impl PlaceLight, how: &Comparison<'_>) {
        if self.count > 0 {
            let mut compared = Compared { tries: self, light, how };
            dispatch_long!(how.level, simd => compare_lanes(simd, &mut compared));
        }
        self.count = 0;
    }

    /// How far the light of a place that was compared last, by its number, was from the interpolated, in steps of
    /// 8 bits.
    pub(super) fn error(&self, number: usize) -> f32 {
        self.errors[number % LANES]
    }

    /// The light of a place that was compared last.
    pub(super) fn light(&self, number: usize) -> TexelLight {
        TexelLight(self.lights.map(|term| term.map(|channel| channel[number % LANES])))
    }
}

/// Outlined: one copy per SIMD level.
#[inline(never)]
fn compare_lanes<S: Simd, L: PlaceLight>(simd: S, compared: &mut Compared<'_, L>) {
    let simd = f32x16::splat(simd, 0.0);
    simd.vectorized(
        #[inline(always)]
        || simd.in_parts(compared),
    );
}

struct Compared<'a, L> {
    tries: &'a mut Tries,
    light: &'a L,
    how: &'a Comparison<'a>,
}

impl<L: PlaceLight> SplitLanes for Compared<'_, L> {
    #[inline(always)]
    fn part<N: Lanes>(&mut self, simd: N, first: usize) {
        if first >= self.tries.count {
            return;
        }
        let Self { tries, light, how } = self;
        let there = u32::MAX >> (32 - tries.count.min(LANES));
        let lanes = there >> first & simd.all_lanes();
        let lit = light.light(columns(simd, &tries.places, first), lanes);
        let [a, b, c] = &tries.corners;
        let weights = columns(simd, &tries.weights, first);
        let interpolated = TexelLight::mixed([a, b, c], weights);
        let mut error = simd.zero();
        for &texel in how.texels {
            let texel = [simd.constant(texel); 3];
            let lit = steps(how, lit.at(texel));
            let interpolated = steps(how, interpolated.at(texel));
            for channel in 0..3 {
                error = (lit[channel] - interpolated[channel]).abs().maximum(error);
            }
        }
        error.store(&mut tries.errors, first);
        for (term, lanes) in tries.lights.iter_mut().zip(lit.0) {
            for (channel, lanes) in term.iter_mut().zip(lanes) {
                lanes.store(channel, first);
            }
        }
    }
}

#[inline(always)]
fn columns<N: Lanes>(simd: N, [a, b, c]: &[[f32; LANES]; 3], first: usize) -> [N; 3] {
    [simd.load(a, first), simd.load(b, first), simd.load(c, first)]
}

/// Light as it is shown, in steps of 8 bits. Light beyond 1 counts: a texel may darken it, and so may other samples
/// of the pixel.
#[inline(always)]
fn steps<N: Lanes>(how: &Comparison<'_>, [r, g, b]: [N; 3]) -> [N; 3] {
    let light = Rgb::new(r, g, b);
    let Rgb { r, g, b } = match &how.display {
        Some(display) => display.shown(light),
        None => light,
    };
    let whole = r.constant(255.0);
    [
        whole * encoded_beyond(how.encoding, r),
        whole * encoded_beyond(how.encoding, g),
        whole * encoded_beyond(how.encoding, b),
    ]
}

/// encode(clamp(v, 0, 1)), to about a hundredth of a step of 8 bits.
#[cfg(feature = "vectors")]
pub(crate) fn encoded(encoding: PictureEncoding, light: f32) -> f32 {
    encoded_beyond(encoding, light.min(1.0))
}

/// The same curve, which goes on beyond 1.
#[inline(always)]
fn encoded_beyond<N: Lanes>(encoding: PictureEncoding, light: N) -> N {
    let light = light.positive_part();
    match encoding {
        PictureEncoding::None => light,
        PictureEncoding::Srgb => {
            let power = elementary::power(light, light.constant(1.0 / 2.4));
            let curve = light.constant(1.055) * power - light.constant(0.055);
            let line = light.constant(12.92) * light;
            line.select(light.less_or_equal(light.constant(0.003_130_8)), curve)
        }
    }
}

/// The light of a function of places, for tests.
#[cfg(test)]
pub(super) struct EachPlace<F>(pub(super) F);

#[cfg(test)]
impl<F: Fn(Place) -> [f32; 3]> PlaceLight for EachPlace<F> {
    fn light<N: Lanes>(&self, place: [N; 3], lanes: u32) -> TexelLight<N> {
        let mut light = [place[0].zero(); 3];
        for lane in luxel_math::lanes_of(lanes) {
            let own = (self.0)(place.map(|weights| weights.lane(lane)));
            for (lanes, own) in light.iter_mut().zip(own) {
                *lanes = lanes.with_lane(lane, own);
            }
        }
        TexelLight::untextured(light)
    }
}
