//! Light as a function of the texel that colours it.

/// The light of a place for any texel t of the base colour: c_0 + c_1 t + c_2 t^2, each channel by
/// itself.
///
/// Light doesn't scale with the base colour as a whole: a dielectric's highlight has its own colour. But
/// no reflection model goes beyond the second degree in O_d, which only microfacets between dielectric
/// and metal reach (O_d times a Fresnel term that O_d takes part in). Three values thus give it for all
/// texels, and interpolating coefficients interpolates the light of every texel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TexelLight([[f32; 3]; 3]);

impl TexelLight {
    /// Texels at which light is compared where a texture colours it.
    pub(crate) const TEXELS: &[f32] = &[0.0, 0.5, 1.0];
    /// The only texel that counts where there is no texture.
    pub(crate) const WHITE: &[f32] = &[1.0];

    /// Light that no texture colours.
    pub(crate) fn untextured(light: [f32; 3]) -> Self {
        Self([light, [0.0; 3], [0.0; 3]])
    }

    /// From the light at the texels 0, 1/2 and 1.
    pub(crate) fn through([black, gray, white]: [[f32; 3]; 3]) -> Self {
        let each = |of: fn([f32; 3]) -> f32| -> [f32; 3] {
            std::array::from_fn(|at| of([black[at], gray[at], white[at]]))
        };
        Self([
            black,
            each(|[black, gray, white]| 4.0 * gray - 3.0 * black - white),
            each(|[black, gray, white]| 2.0 * (black + white - 2.0 * gray)),
        ])
    }

    /// The light under a texel.
    pub(crate) fn at(&self, texel: [f32; 3]) -> [f32; 3] {
        let [c0, c1, c2] = self.0;
        std::array::from_fn(|at| c0[at] + (c1[at] + c2[at] * texel[at]) * texel[at])
    }

    /// Between three places, by their weights.
    pub(crate) fn mixed([a, b, c]: [&Self; 3], [u, v, w]: [f32; 3]) -> Self {
        let term = |degree: usize| -> [f32; 3] {
            std::array::from_fn(|at| {
                a.0[degree][at] * u + b.0[degree][at] * v + c.0[degree][at] * w
            })
        };
        Self([term(0), term(1), term(2)])
    }
}
