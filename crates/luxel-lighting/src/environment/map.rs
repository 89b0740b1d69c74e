//! A picture of the light all around, prepared for lookups by direction and roughness.

use super::blur::{self, Pyramid};
use super::harmonics::Harmonics;
use super::octahedron::{self, Square};
use super::resample;
use crate::light::bounded;
use libm::sincos;
use luxel_math::{LANES, Lanes, Rgb, Vec3};
use std::fmt;
use std::sync::Arc;

/// A picture of the light from all directions, equirectangular: longitude across, latitude down.
#[derive(Clone, Debug, PartialEq)]
pub struct EquirectangularImage {
    /// Texels across.
    pub width: u32,
    /// Texels down.
    pub height: u32,
    /// Linear red, green and blue, not negative; rows from the zenith to the nadir.
    pub light: Vec<[f32; 3]>,
}

/// An [`EquirectangularImage`] prepared for lookups by direction and roughness.
///
/// It keeps squares of the octahedral map: the picture itself, and ten blurred for roughnesses of 0.1 to 1;
/// and the light of matt surfaces as nine spherical harmonics. +Y is up.
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EnvironmentMap {
    name: String,
    /// By roughness, in steps of 1 / [`STEPS`].
    squares: Vec<Square>,
    harmonics: Harmonics,
    mean: [f32; 3],
}

/// Steps of roughness.
const STEPS: usize = 10;
/// Texels a side of the squares of roughnesses above 0, if the picture has as many: a quarter of the lobe's
/// width or less each.
const SIDES: [usize; STEPS] = [256, 128, 128, 64, 64, 64, 64, 64, 64, 64];
/// The fewest and most texels a side of the picture's own square.
const LEAST_SIDE: u32 = 64;
const MOST_SIDE: u32 = 2048;

/// Texels a side of the square of a picture: a square of half the picture's width has about its texels.
fn side_of(width: u32) -> u32 {
    let half = width.min(2 * MOST_SIDE).div_ceil(2);
    half.next_power_of_two().clamp(LEAST_SIDE, MOST_SIDE)
}

impl EnvironmentMap {
    /// Bytes that [`Self::new`] takes at most for a picture of this size, the picture's own included.
    #[must_use]
    pub fn bytes_needed(width: u32, height: u32) -> u64 {
        let side = u64::from(side_of(width));
        let picture = (u64::from(width) * u64::from(height)).saturating_mul(12);
        let squares = Square::bytes(side) + Square::bytes(256) * 2;
        // Cells are summed up in quarters.
        picture.saturating_add(side * side * 16 * 2 + blur::bytes(side) + squares)
    }

    /// Prepares a picture; its `name` is what users know it by. Values beyond 1e10 count as that, NaN as 0;
    /// texels that are missing are black.
    ///
    /// The result doesn't depend on the number of threads.
    #[must_use]
    pub fn new(name: impl Into<String>, mut image: EquirectangularImage) -> Self {
        image.width = image.width.max(1);
        image.height = image.height.max(1);
        image.light.resize(image.width as usize * image.height as usize, [0.0; 3]);
        luxel_parallel::fill(&mut image.light, 1 << 14, &|_, run| {
            for light in run {
                *light = bounded(*light).map(|channel| channel.max(0.0));
            }
        });
        let side = side_of(image.width) as usize;
        let cells = resample::cells(&image, side);
        drop(image);
        let pyramid = Pyramid::new(&cells);
        let (harmonics, mean) = Harmonics::new(&pyramid);
        let mut light = vec![[0.0; 3]; side * side];
        for (light, [r, g, b, area]) in light.iter_mut().zip(cells.sums) {
            *light = [r, g, b].map(|channel| channel / area.max(f32::MIN_POSITIVE));
        }
        let mut squares = vec![Square::new(side, &light)];
        for (step, most) in SIDES.into_iter().enumerate() {
            let side = side.min(most);
            let roughness = (step + 1) as f32 / STEPS as f32;
            squares.push(Square::new(side, &pyramid.blurred(side, roughness)));
        }
        Self { name: name.into(), squares, harmonics, mean }
    }

    /// What users know it by: as a rule, the path of its file.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The mean of the light from all around.
    #[must_use]
    pub fn mean(&self) -> [f32; 3] {
        self.mean
    }

    /// Whether it is one that [`new`](Self::new) may have made; what comes from elsewhere could lack texels.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.squares.len() == STEPS + 1 && self.squares.iter().all(Square::is_whole)
    }

    /// The light at a place of the square, blurred for `step` tenths of roughness.
    #[inline]
    fn light(&self, place: [f32; 2], step: f32) -> [f32; 4] {
        let number = (step as usize).min(STEPS);
        let Some(square) = self.squares.get(number) else { return [0.0; 4] };
        let mut light = square.at(place);
        let fraction = step - number as f32;
        if fraction > 0.0
            && let Some(next) = self.squares.get(number + 1)
        {
            let rougher = next.at(place);
            for channel in 0..4 {
                light[channel] += (rougher[channel] - light[channel]) * fraction;
            }
        }
        light
    }
}

impl fmt::Debug for EnvironmentMap {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, mean, .. } = self;
        formatter.debug_struct("EnvironmentMap").field("name", name).field("mean", mean).finish()
    }
}

/// An [`EnvironmentMap`] as it stands in a world: about its up axis, turned.
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct OrientedMap {
    map: Arc<EnvironmentMap>,
    /// The world's right, up and front.
    frame: [[f64; 3]; 3],
    rotation_degrees: f64,
    /// The map's X, Y and Z in the world.
    axes: [[f32; 3]; 3],
}

impl OrientedMap {
    /// A map in a world whose `frame` is right, up and front, of unit length and perpendicular: with +Y up these are
    /// +X, +Y and +Z. It is turned about up, counterclockwise as seen from above.
    ///
    /// The picture's middle column is on the right, and the front three quarters of the way across, as in
    /// three.js and, with +Z up and -Y in front, in Blender.
    #[must_use]
    pub fn new(map: Arc<EnvironmentMap>, frame: [[f64; 3]; 3], rotation_degrees: f64) -> Self {
        let (sine, cosine) = sine_and_cosine(rotation_degrees);
        let [right, up, front] = frame;
        let sum = |a: f64, b: f64| [0, 1, 2].map(|axis| (a * right[axis] + b * front[axis]) as f32);
        let axes = [sum(cosine, -sine), up.map(|axis| axis as f32), sum(sine, cosine)];
        Self { map, frame, rotation_degrees, axes }
    }

    /// The same, turned otherwise.
    #[must_use]
    pub fn turned(&self, rotation_degrees: f64) -> Self {
        Self::new(Arc::clone(&self.map), self.frame, rotation_degrees)
    }

    /// The map.
    #[must_use]
    pub fn map(&self) -> &Arc<EnvironmentMap> {
        &self.map
    }

    /// The world's right, up and front.
    #[must_use]
    pub fn frame(&self) -> [[f64; 3]; 3] {
        self.frame
    }

    /// How far it is turned about up, counterclockwise as seen from above.
    #[must_use]
    pub fn rotation_degrees(&self) -> f64 {
        self.rotation_degrees
    }

    /// A direction of the world in the map's own space.
    #[inline(always)]
    fn local<N: Lanes>(&self, direction: Vec3<N>) -> Vec3<N> {
        let [x, y, z] = self.axes;
        let simd = direction.x;
        Vec3::new(
            direction.dot(Vec3::splat(simd, x)),
            direction.dot(Vec3::splat(simd, y)),
            direction.dot(Vec3::splat(simd, z)),
        )
    }

    /// The light from a direction, averaged over the lobe of a surface of this perceptual roughness.
    ///
    /// Outlined, one copy per SIMD level, as it is long. Places are found in lanes, and their texels fetched one
    /// lane after the other, as those of textures.
    #[inline(never)]
    pub(super) fn radiance<N: Lanes>(&self, direction: Vec3<N>, roughness: N) -> Rgb<N> {
        roughness.vectorized(
            #[inline(always)]
            || {
                let simd = roughness;
                let [u, v] = octahedron::place(self.local(direction));
                let step = roughness.clamped(0.0, 1.0) * simd.constant(STEPS as f32);
                let (mut us, mut vs, mut steps) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
                u.store(&mut us, 0);
                v.store(&mut vs, 0);
                step.store(&mut steps, 0);
                let (mut r, mut g, mut b) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
                simd.visit(
                    simd.all_lanes(),
                    #[inline(always)]
                    |lane| {
                        [r[lane], g[lane], b[lane], _] =
                            self.map.light([us[lane], vs[lane]], steps[lane]);
                    },
                );
                Rgb::new(simd.load(&r, 0), simd.load(&g, 0), simd.load(&b, 0))
            },
        )
    }

    /// The light of a white matt surface with this normal: irradiance over pi.
    #[inline(always)]
    pub(crate) fn irradiance<N: Lanes>(&self, normal: Vec3<N>) -> Rgb<N> {
        self.map.harmonics.at(self.local(normal))
    }
}

/// The same map, not another one with the same light, in the same orientation.
impl PartialEq for OrientedMap {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.map, &other.map) && self.axes == other.axes
    }
}

impl fmt::Debug for OrientedMap {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { map, rotation_degrees, axes, .. } = self;
        let mut text = formatter.debug_struct("OrientedMap");
        text.field("map", map).field("rotation_degrees", rotation_degrees).field("axes", axes);
        text.finish()
    }
}

/// Exact for quarter turns.
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    let degrees = if degrees.is_finite() { degrees.rem_euclid(360.0) } else { 0.0 };
    let quarters = (degrees / 90.0).floor();
    let (sine, cosine) = sincos((degrees - 90.0 * quarters).to_radians());
    match quarters as u32 % 4 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}
