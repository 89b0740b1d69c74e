//! Light as a function of the texel that colours it.

use luxel_math::Lanes;

/// The light of a place for any texel t of the base colour: c_0 + c_1 t + c_2 t^2, each channel by
/// itself.
///
/// Light doesn't scale with the base colour as a whole: a dielectric's highlight has its own colour. But
/// no reflection model goes beyond the second degree in O_d, which only microfacets between dielectric
/// and metal reach (O_d times a Fresnel term that O_d takes part in). Three values thus give it for all
/// texels, and interpolating coefficients interpolates the light of every texel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TexelLight<N = f32>(pub(super) [[N; 3]; 3]);

impl TexelLight {
    /// Texels at which light is compared where a texture colours it.
    pub(crate) const TEXELS: &[f32] = &[0.0, 0.5, 1.0];
    /// The only texel that counts where there is no texture.
    pub(crate) const WHITE: &[f32] = &[1.0];
}

impl<N: Lanes> TexelLight<N> {
    /// Light that no texture colours.
    #[inline(always)]
    pub(crate) fn untextured(light: [N; 3]) -> Self {
        let zero = light[0].zero();
        Self([light, [zero; 3], [zero; 3]])
    }

    /// From the light at the texels 0, 1/2 and 1.
    #[inline(always)]
    pub(crate) fn through([black, gray, white]: [[N; 3]; 3]) -> Self {
        let simd = black[0];
        let (two, three, four) = (simd.constant(2.0), simd.constant(3.0), simd.constant(4.0));
        let mut terms = [black; 3];
        for at in 0..3 {
            let (black, gray, white) = (black[at], gray[at], white[at]);
            terms[1][at] = four * gray - three * black - white;
            terms[2][at] = two * (black + white - two * gray);
        }
        Self(terms)
    }

    /// The light under a texel.
    #[inline(always)]
    pub(crate) fn at(&self, texel: [N; 3]) -> [N; 3] {
        let [mut light, c1, c2] = self.0;
        for at in 0..3 {
            light[at] = light[at] + (c1[at] + c2[at] * texel[at]) * texel[at];
        }
        light
    }

    /// Between three places, by their weights.
    #[inline(always)]
    pub(crate) fn mixed([a, b, c]: [&TexelLight; 3], [u, v, w]: [N; 3]) -> Self {
        let mut terms = [[u; 3]; 3];
        for (degree, term) in terms.iter_mut().enumerate() {
            for (at, sum) in term.iter_mut().enumerate() {
                let [a, b, c] = [a.0[degree][at], b.0[degree][at], c.0[degree][at]];
                *sum = u.constant(a) * u + u.constant(b) * v + u.constant(c) * w;
            }
        }
        Self(terms)
    }
}
