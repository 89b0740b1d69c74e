//! Texels at a place: faces of cubes, level of detail, filters, comparisons (OpenGL 1.5, sections 3.8.5 to 3.8.9 and
//! 3.8.14).
//!
//! Wrapping, weights and the choice of levels are luxel-scene's; here are texels of all formats, in one, two and three
//! dimensions. A line of texels is an image of one row, which weighs itself alone.

use super::fetch::Fetch;
use super::footprint::Footprint;
use crate::enums as gl;
use crate::texture::{BaseFormat, SampledTexture, Target};
use luxel_math::elementary::log2;
use luxel_math::{LANES, Lanes, Mask, Simd, f32x16};
use luxel_scene::Filter;
use luxel_scene::texture::addressing::{nearest_texel, neighbouring_texels, texel_position};
use luxel_scene::texture::level_of_detail::{
    Detail, LevelFilters, LevelSource, mix, squared_length,
};

/// The texel of a texture, filtered, for the lanes whose bit is set; as
/// [`InternalFormat::canonical`](crate::texture::InternalFormat::canonical) has it. `lod_bias` is the unit's and the
/// texture's together.
#[inline(never)]
pub(super) fn sample<S: Simd>(
    texture: &SampledTexture,
    lod_bias: f32,
    footprint: &Footprint<f32x16<S>>,
    lanes: u32,
) -> [f32x16<S>; 4] {
    let simd = footprint.at[0];
    simd.vectorized(
        #[inline(always)]
        || {
            let texel = of_faces(texture, lod_bias, footprint, lanes);
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

/// Table 3.21: the face that a direction meets, and the texel there; other textures are their one face.
///
/// All textures take the same loop, since a second copy of what samples would double the code.
#[inline(always)]
fn of_faces<S: Simd>(
    texture: &SampledTexture,
    lod_bias: f32,
    footprint: &Footprint<f32x16<S>>,
    lanes: u32,
) -> [f32x16<S>; 4] {
    let [x, y, z] = footprint.at;
    let simd = x;
    let largest_x = y.abs().less_or_equal(x.abs()) & z.abs().less_or_equal(x.abs());
    let largest_y = !largest_x & z.abs().less_or_equal(y.abs());
    let axes = [largest_x, largest_y, !largest_x & !largest_y];
    let is_cube = texture.target == Target::Cube;
    let mut texel = [simd.zero(); 4];
    for face in 0..if is_cube { 6 } else { 1 } {
        let mut here = lanes;
        let place = if is_cube {
            let axis = face / 2;
            let negative = [x, y, z][axis].less(simd.zero());
            let meets = axes[axis] & if face % 2 == 1 { negative } else { !negative };
            here &= meets.bits();
            if here == 0 {
                continue;
            }
            footprint.on_face(face)
        } else {
            footprint.on_image(texture.target.dimensions())
        };
        let of_face = of_face(texture, face, lod_bias, &place, here);
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
fn of_face<S: Simd>(
    texture: &SampledTexture,
    face: usize,
    lod_bias: f32,
    place: &Footprint<f32x16<S>>,
    lanes: u32,
) -> [f32x16<S>; 4] {
    let simd = place.at[0];
    let levels = &texture.faces[face];
    let dimensions = texture.target.dimensions();
    let source = FaceAt { texture, face, at: place.at };
    let SampledTexture { magnify, minify, .. } = *texture;
    let detail = if texture.between.is_none() && magnify == minify {
        Detail::of_base(simd, [magnify, minify], 0)
    } else {
        let [width, height, depth] = levels[0].inner_size(dimensions);
        let size = [
            simd.constant(width as f32),
            simd.constant(height as f32),
            simd.constant(depth as f32),
        ];
        let [right, above] = place.per_pixel;
        let longer = squared_length(right, size).maximum(squared_length(above, size));
        let longer = longer.maximum(simd.constant(1e-30));
        let bias = lod_bias.clamp(-crate::limits::LOD_BIAS, crate::limits::LOD_BIAS);
        let level = simd.constant(0.5) * log2(longer) + simd.constant(bias);
        // The lower limit first, as the specification orders the cases.
        let level = level
            .maximum(simd.constant(texture.least_lod))
            .minimum(simd.constant(texture.largest_lod));
        match texture.between {
            Some(between) => {
                let filters = LevelFilters { magnify, minify, between };
                Detail::new(level, filters, (levels.len() - 1) as u32, lanes)
            }
            None => {
                let magnified = level.less_or_equal(simd.zero()).bits() & lanes;
                Detail::of_base(simd, [magnify, minify], magnified)
            }
        }
    };
    detail.value(simd, &source, lanes)
}

/// A face of a texture at a place.
struct FaceAt<'t, N> {
    texture: &'t SampledTexture,
    face: usize,
    /// The third coordinate is also what depths are compared with.
    at: [N; 3],
}

impl<S: Simd> LevelSource<f32x16<S>, 4> for FaceAt<'_, f32x16<S>> {
    #[inline(always)]
    fn filtered(&self, level: u32, filter: Filter, lanes: u32) -> [f32x16<S>; 4] {
        let simd = self.at[0];
        let Some(image) = self.texture.faces[self.face].get(level as usize) else {
            return [simd.zero(); 4];
        };
        let dimensions = self.texture.target.dimensions();
        let inner = image.inner_size(dimensions);
        let mut numbers = [[[0; LANES]; 2]; 3];
        let mut fractions = [simd.zero(); 3];
        for axis in 0..dimensions {
            let size = simd.constant(inner[axis] as f32);
            let addressing = self.texture.addressing[axis];
            let position = texel_position(self.at[axis], size, addressing);
            let [first, second] = &mut numbers[axis];
            match filter {
                Filter::Nearest => nearest_texel(position, size, addressing).store_whole(first, 0),
                Filter::Linear => {
                    fractions[axis] =
                        neighbouring_texels(position, size, addressing, [first, second]);
                }
            }
        }
        let fetch = Fetch::new(self.texture, image, inner);
        let count = if filter == Filter::Nearest { 1 } else { 1 << dimensions };
        let mut corners = [[simd.zero(); 4]; 8];
        for (corner, texel) in corners[..count].iter_mut().enumerate() {
            *texel = self.compared(fetch.texels(simd.simd, &numbers, corner, lanes));
        }
        // Neighbours along s, then along t, then along r.
        let mut left = count;
        let mut axis = 0;
        while left > 1 {
            left /= 2;
            for at in 0..left {
                corners[at] = mix(corners[2 * at], corners[2 * at + 1], fractions[axis]);
            }
            axis += 1;
        }
        corners[0]
    }
}

impl<N: Lanes> FaceAt<'_, N> {
    /// 1 where the reference compares with the depth, 0 elsewhere: before filters, so that edges of shadows are smooth.
    #[inline(always)]
    fn compared(&self, texel: [N; 4]) -> [N; 4] {
        let Some(func) = self.texture.compare else { return texel };
        let depth = texel[0];
        let one = depth.one();
        let reference = self.at[2].clamped(0.0, 1.0);
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
