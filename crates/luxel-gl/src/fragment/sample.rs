//! Texels at a place: faces of cubes, level of detail, filters, comparisons (OpenGL 1.5, sections 3.8.5 to 3.8.9 and
//! 3.8.14).
//!
//! Wrapping, weights and the choice of levels are luxel-scene's; here are texels of all formats, in one, two and three
//! dimensions. A line of texels is an image of one row, which weighs itself alone.

use crate::enums as gl;
use crate::texture::{BaseFormat, SampledTexture, Target, Texels, TextureImage};
use luxel_math::elementary::log2;
use luxel_math::{LANES, Lanes, Mask};
use luxel_scene::texture::addressing::{
    Addressing, nearest_texel, neighbouring_texels, texel_position,
};
use luxel_scene::texture::level_of_detail::{
    Detail, LevelFilters, LevelSource, mix, squared_length,
};
use luxel_scene::{Encoding, Filter};

/// s, t, r and q at the centre of a pixel, a pixel to the right and a pixel above.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Footprint<N> {
    pub(crate) centre: [N; 4],
    pub(crate) right: [N; 4],
    pub(crate) above: [N; 4],
}

/// Coordinates divided by q, and how they change from pixel to pixel.
struct Place<N> {
    at: [N; 3],
    per_pixel: [[N; 3]; 2],
}

impl<N: Lanes> Footprint<N> {
    #[inline(always)]
    fn divided(&self, dimensions: usize) -> Place<N> {
        let by_q = |[s, t, r, q]: [N; 4]| {
            let scale = q.one() / q;
            [s * scale, t * scale, r * scale]
        };
        let [at, right, above] = [self.centre, self.right, self.above].map(by_q);
        let change = |to: [N; 3]| {
            std::array::from_fn(|axis| {
                if axis < dimensions { to[axis] - at[axis] } else { at[axis].zero() }
            })
        };
        Place { at, per_pixel: [change(right), change(above)] }
    }
}

/// The texel of a texture, filtered, for the lanes whose bit is set; as
/// [`InternalFormat::canonical`](crate::texture::InternalFormat::canonical) has it. `lod_bias` is the unit's and the
/// texture's together.
#[inline(never)]
pub(super) fn sample<N: Lanes>(
    texture: &SampledTexture,
    lod_bias: f32,
    footprint: &Footprint<N>,
    lanes: u32,
) -> [N; 4] {
    let simd = footprint.centre[0];
    simd.vectorized(
        #[inline(always)]
        || {
            let texel = if texture.target == Target::Cube {
                of_cube(texture, lod_bias, footprint, lanes)
            } else {
                let place = footprint.divided(texture.target.dimensions());
                of_face(texture, 0, lod_bias, &place, lanes)
            };
            if texture.is_depth { of_depth(texture.base, texel) } else { texel }
        },
    )
}

/// A depth, or the outcome of its comparison, as the texture's mode makes it a colour.
#[inline(always)]
fn of_depth<N: Lanes>(base: BaseFormat, [value, ..]: [N; 4]) -> [N; 4] {
    let (zero, one) = (value.zero(), value.one());
    match base {
        BaseFormat::Alpha => [zero, zero, zero, value],
        BaseFormat::Intensity => [value; 4],
        _ => [value, value, value, one],
    }
}

/// Table 3.21: the face that a direction meets, and its place there.
#[inline(always)]
fn of_cube<N: Lanes>(
    texture: &SampledTexture,
    lod_bias: f32,
    footprint: &Footprint<N>,
    lanes: u32,
) -> [N; 4] {
    let [x, y, z, _] = footprint.centre;
    let simd = x;
    let (largest_x, largest_y) = (
        y.abs().less_or_equal(x.abs()) & z.abs().less_or_equal(x.abs()),
        z.abs().less_or_equal(y.abs()),
    );
    let negative = |value: N| value.less(value.zero());
    let axes = [largest_x, !largest_x & largest_y, !largest_x & !largest_y];
    let mut texel = [simd.zero(); 4];
    for face in 0..6 {
        let axis = face / 2;
        let is_negative = face % 2 == 1;
        let sign = negative([x, y, z][axis]);
        let here = axes[axis] & if is_negative { sign } else { !sign };
        let here = here.bits() & lanes;
        if here == 0 {
            continue;
        }
        let on_face = |[x, y, z, _]: [N; 4]| {
            let (s, t, major) = match face {
                0 => (-z, -y, x),
                1 => (z, -y, -x),
                2 => (x, z, y),
                3 => (x, -z, -y),
                4 => (x, -y, z),
                _ => (-x, -y, -z),
            };
            let half = s.constant(0.5);
            let scale = half / major;
            [s * scale + half, t * scale + half, s.zero()]
        };
        let at = on_face(footprint.centre);
        let change = |to: [N; 4]| {
            let to = on_face(to);
            [to[0] - at[0], to[1] - at[1], at[0].zero()]
        };
        let per_pixel = [change(footprint.right), change(footprint.above)];
        let of_face = of_face(texture, face, lod_bias, &Place { at, per_pixel }, here);
        let mask = simd.mask_of(here);
        for (texel, of_face) in texel.iter_mut().zip(of_face) {
            *texel = of_face.select(mask, *texel);
        }
    }
    texel
}

/// Section 3.8.8: lambda = log2(rho), with rho the longer of a pixel's two sides in texels of the base level, then
/// biased and clamped.
#[inline(always)]
fn of_face<N: Lanes>(
    texture: &SampledTexture,
    face: usize,
    lod_bias: f32,
    place: &Place<N>,
    lanes: u32,
) -> [N; 4] {
    let simd = place.at[0];
    let levels = &texture.faces[face];
    let dimensions = texture.target.dimensions();
    let size = levels[0].inner_size(dimensions).map(|side| simd.constant(side as f32));
    let [right, above] = place.per_pixel.map(|change| squared_length(change, size));
    let longer = right.maximum(above).maximum(simd.constant(1e-30));
    let bias = lod_bias.clamp(-crate::limits::LOD_BIAS, crate::limits::LOD_BIAS);
    let level = simd.constant(0.5) * log2(longer) + simd.constant(bias);
    // The lower limit first, as the specification orders the cases.
    let level =
        level.maximum(simd.constant(texture.least_lod)).minimum(simd.constant(texture.largest_lod));
    let reference = place.at[2];
    let source = FaceAt { texture, face, at: place.at, reference };
    let SampledTexture { magnify, minify, .. } = *texture;
    let detail = match texture.between {
        Some(between) => {
            let filters = LevelFilters { magnify, minify, between };
            Detail::new(level, filters, (levels.len() - 1) as u32, lanes)
        }
        None => {
            let magnified = level.less_or_equal(simd.zero()).bits() & lanes;
            Detail::of_base(simd, [magnify, minify], magnified)
        }
    };
    detail.value(simd, &source, lanes)
}

/// A face of a texture at a place.
struct FaceAt<'t, N> {
    texture: &'t SampledTexture,
    face: usize,
    at: [N; 3],
    /// What depths are compared with.
    reference: N,
}

impl<N: Lanes> LevelSource<N, 4> for FaceAt<'_, N> {
    #[inline(always)]
    fn filtered(&self, level: u32, filter: Filter, lanes: u32) -> [N; 4] {
        let simd = self.at[0];
        let Some(image) = self.texture.faces[self.face].get(level as usize) else {
            return [simd.zero(); 4];
        };
        let dimensions = self.texture.target.dimensions();
        let inner = image.inner_size(dimensions);
        let fetch = Fetch { image, inner, border: &self.texture.border };
        let size = inner.map(|side| simd.constant(side as f32));
        let mut numbers = [[[0; LANES]; 2]; 3];
        let mut fractions = [simd.zero(); 3];
        for axis in 0..dimensions {
            let addressing: Addressing = self.texture.addressing[axis];
            let position = texel_position(self.at[axis], size[axis], addressing);
            let [first, second] = &mut numbers[axis];
            match filter {
                Filter::Nearest => {
                    nearest_texel(position, size[axis], addressing).store_whole(first, 0);
                }
                Filter::Linear => {
                    fractions[axis] =
                        neighbouring_texels(position, size[axis], addressing, [first, second]);
                }
            }
        }
        let corner = |corner: usize| {
            let mut texels = [[0.0; LANES]; 4];
            simd.visit(
                lanes,
                #[inline(always)]
                |lane| {
                    let at = |axis: usize| numbers[axis][corner >> axis & 1][lane];
                    let texel = fetch.texel([at(0), at(1), at(2)]);
                    for (channel, value) in texels.iter_mut().zip(texel) {
                        channel[lane] = value;
                    }
                },
            );
            self.compared(texels.map(|channel| simd.load(&channel, 0)))
        };
        if filter == Filter::Nearest {
            return corner(0);
        }
        let row = |first: usize| mix(corner(first), corner(first + 1), fractions[0]);
        let plane = |first: usize| match dimensions {
            1 => row(first),
            _ => mix(row(first), row(first + 2), fractions[1]),
        };
        if dimensions == 3 { mix(plane(0), plane(4), fractions[2]) } else { plane(0) }
    }
}

impl<N: Lanes> FaceAt<'_, N> {
    /// 1 where the reference compares with the depth, 0 elsewhere: before filters, so that edges of shadows are smooth.
    #[inline(always)]
    fn compared(&self, texel: [N; 4]) -> [N; 4] {
        let Some(func) = self.texture.compare else { return texel };
        let depth = texel[0];
        let one = depth.one();
        let reference = self.reference.clamped(0.0, 1.0);
        let passes = match func {
            gl::NEVER => return [depth.zero(); 4],
            gl::ALWAYS => return [one; 4],
            gl::LESS => reference.less(depth),
            gl::EQUAL => reference.equal(depth),
            gl::GREATER => depth.less(reference),
            gl::GEQUAL => depth.less_or_equal(reference),
            gl::NOTEQUAL => !reference.equal(depth),
            _ => reference.less_or_equal(depth),
        };
        [one.masked(passes); 4]
    }
}

/// Reads texels of an image by their numbers, of which the last two of each axis are the border's.
struct Fetch<'t> {
    image: &'t TextureImage,
    inner: [u32; 3],
    border: &'t [f32; 4],
}

impl Fetch<'_> {
    #[inline(always)]
    fn texel(&self, mut at: [u32; 3]) -> [f32; 4] {
        let image = self.image;
        let inside = at[0] < self.inner[0] && at[1] < self.inner[1] && at[2] < self.inner[2];
        if image.border > 0 {
            for (place, size) in at.iter_mut().zip(self.inner).take(image_dimensions(image)) {
                *place = match place.checked_sub(size) {
                    None => *place + 1,
                    Some(0) => 0,
                    Some(_) => size + 1,
                };
            }
        } else if !inside {
            return *self.border;
        }
        let index = image.index(at);
        match &image.texels {
            Texels::Bytes(texels) => {
                let encoding = if image.format.srgb { Encoding::Srgb } else { Encoding::Linear };
                let [r, g, b, a] = texels[index];
                let color = [r, g, b].map(|byte| encoding.linear(byte));
                [color[0], color[1], color[2], Encoding::Linear.linear(a)]
            }
            Texels::Words(texels) => texels[index].map(|word| f32::from(word) / 65535.0),
            Texels::Depth(texels) => [texels[index]; 4],
        }
    }
}

/// How many axes of an image have a border: those that are longer than the inner image.
#[inline(always)]
fn image_dimensions(image: &TextureImage) -> usize {
    let dimensions = image.size.iter().rposition(|side| *side > 1);
    dimensions.map_or(1, |last| last + 1)
}
