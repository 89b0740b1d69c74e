//! The ledger of a pixel: what [`Renderer::explain`](crate::Renderer::explain) answers.
//!
//! All numbers are those that made the pixel, bit for bit, so that it can be made again from them:
//!
//! 1. Where light was computed at the pixel, `sum` = ((emission + scene_ambient) + each light's
//!    ambient, then diffuse, then specular, light by light) + environment, from left to right in
//!    `f32`. Where it was computed elsewhere, the same holds for the `sum` of each place in
//!    `evaluated_at`; `light` is that clamped to 0..1 (or as it is), and the pixel's `sum` = (the
//!    places' light x weight, from left to right) x `texture`. (Along edges and rows of polygons,
//!    weights are products, and right to rounding.)
//! 2. `color` = s sum + (1 - s) I_dc where there is fog, else `sum`. `display` is `color` after the
//!    explanation's exposure and tone curve; a background's is its colour.
//! 3. An entry that sees several surfaces gathers them nearest first: light += t alpha display,
//!    t *= 1 - alpha, from light = 0 and t = 1. Its `alpha` is 1 - t and its `display` light / alpha.
//!    Its `color` is the same of their colours.
//! 4. The pixel, if no sample sees several surfaces, is the entries' sum of display (weight alpha),
//!    divided by the sum of weight alpha, which is its alpha. An entry alone is the pixel. If any
//!    sample does, it is the sum over the samples, by number, of light / N, divided by the sum of
//!    (1 - t) / N.
//! 5. `rgba8` is [`PictureEncoding::byte`](luxel_lighting::PictureEncoding::byte) of it.

use luxel_lighting::{
    Cone, DiffuseTerms, Display, HighlightVector, Light, LightKind, LightTerms, Material,
    MirrorTerms, PartTerms, Reflectance, Reflection,
};

/// Why a pixel has its colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// The pixel: column and row.
    pub pixel: [u32; 2],
    /// The point that was asked about, in pixels, if it was one point.
    pub position: Option<[f64; 2]>,
    /// What the samples see: those that see the same are one entry.
    pub samples: Vec<ExplainedSample>,
    /// Exposure and tone curve: what makes `display` of `color`.
    pub display: Display,
    /// The pixel's colour (straight) and alpha as shown, linear, before clamping.
    pub linear: [f32; 4],
    /// The pixel's bytes: red, green, blue, alpha.
    pub rgba8: [u8; 4],
}

/// Samples that see the same surfaces.
#[derive(Clone, Debug, PartialEq)]
pub struct ExplainedSample {
    /// Their share of the pixel's samples.
    pub weight: f32,
    /// The samples, by number.
    pub covers: Vec<u8>,
    /// Where one of them lies in the window, in pixels: the one that is lit, if it is among them.
    pub at: [f64; 2],
    /// What they see, nearest first: transparent surfaces, then what is opaque or the background.
    pub seen: Vec<Seen>,
    /// The colour of all that is seen (straight, not multiplied by alpha), before exposure and tone curve.
    pub color: [f32; 3],
    /// The same, after them: what the pixel is the mean of.
    pub display: [f32; 3],
    /// How much of what lies behind is covered.
    pub alpha: f32,
}

/// What a sample sees.
#[derive(Clone, Debug, PartialEq)]
pub enum Seen {
    /// Nothing.
    Background {
        /// Its colour (straight), under the ground if there is one.
        color: [f32; 3],
        /// Its alpha.
        alpha: f32,
        /// What is seen of the ground.
        ground: Option<Box<ExplainedGround>>,
    },
    /// A surface.
    Surface(Box<ExplainedSurface>),
}

/// The ground at a sample: black with `alpha`, over the background.
///
/// With A = `alpha` + (1 - `alpha`) `behind[3]`, a sample shows the colour (1 - `alpha`) `behind[3]` / A times
/// `behind`'s, and A is its alpha.
#[derive(Clone, Debug, PartialEq)]
pub struct ExplainedGround {
    /// The place, in world space.
    pub position: [f64; 3],
    /// The background behind it: straight colour and alpha.
    pub behind: [f32; 4],
    /// Openness.
    pub openness: f32,
    /// I_a of the scene, ambient lights included.
    pub ambient_light: [f32; 3],
    /// The reflected ambient light.
    pub scene_ambient: [f32; 3],
    /// What each directional, point and spot light adds, in the order of the view.
    pub lights: Vec<ExplainedLight>,
    /// I: the light of a white, matt ground.
    pub light: [f32; 3],
    /// I_0: the same without the model.
    pub unoccluded: [f32; 3],
    /// s of the fog; 1 without.
    pub fog: f32,
    /// D = s (1 - Y(I) / Y(I_0)), Y the luminance.
    pub darkness: f32,
    /// D over an opaque background, and over a transparent one of a picture in sRGB 1 - encode(1 - D), as
    /// programs mix pictures in the bytes of sRGB; between them by `behind[3]`.
    pub alpha: f32,
}

/// A surface at a sample, with every term of its light.
#[derive(Clone, Debug, PartialEq)]
pub struct ExplainedSurface {
    /// The object, by its place among [`Renderer::objects`](crate::Renderer::objects).
    pub object: usize,
    /// Its name.
    pub name: String,
    /// The triangle, by its number in the object; `None` for points and lines.
    pub triangle: Option<u32>,
    /// The weights of its corners.
    pub barycentric: [f32; 3],
    /// Where light was computed, if not here: the terms below are then those of these places by
    /// their weights (as much as clamping leaves, times the texture), each light's factors their
    /// means, and the material is that of the heaviest.
    pub evaluated_at: Vec<EvaluatedAt>,
    /// The texture of the base colour where it multiplies light that was computed elsewhere; else 1.
    pub texture: [f32; 3],
    /// The place, in world space.
    pub position: [f64; 3],
    /// N: the normal that was lit, of unit length, in world space.
    pub normal: [f32; 3],
    /// V: towards the eye, of unit length, in world space.
    pub view: [f32; 3],
    /// The distance from the eye along the viewing axis.
    pub z: f32,
    /// Texture coordinates of the first set.
    pub uv: Option<[f32; 2]>,
    /// Openness, if the view asks for ambient occlusion: a factor of the ambient terms and of the
    /// environment.
    pub openness: Option<f32>,
    /// What the surface reflects.
    pub material: ExplainedMaterial,
    /// I_a of the scene, ambient lights included.
    pub ambient_light: [f32; 3],
    /// What each directional, point and spot light adds, in the order of the view.
    pub lights: Vec<ExplainedLight>,
    /// The emitted light.
    pub emission: [f32; 3],
    /// I_a k_a O_a
    pub scene_ambient: [f32; 3],
    /// The reflected environment, mirrored and diffuse.
    pub environment: [f32; 3],
    /// What the parts of the model mirror, by their place in the mix; empty where light is
    /// interpolated between other places.
    pub mirrors: Vec<(usize, MirrorTerms<f32>)>,
    /// The diffuse part of the environment's term, if the environment is a map.
    pub environment_diffuse: Option<[f32; 3]>,
    /// What the parts of the model reflect of it to all sides, as `mirrors`.
    pub diffused: Vec<(usize, DiffuseTerms<f32>)>,
    /// The sum of all terms.
    pub sum: [f32; 3],
    /// s and I_dc, where there is fog.
    pub fog: Option<(f32, [f32; 3])>,
    /// The sum, after fog.
    pub color: [f32; 3],
    /// The colour, after exposure and tone curve.
    pub display: [f32; 3],
    /// How much of what lies behind is covered.
    pub alpha: f32,
}

/// A place where light was computed that pixels elsewhere show.
#[derive(Clone, Debug, PartialEq)]
pub struct EvaluatedAt {
    /// Its part in the pixel's light.
    pub weight: f32,
    /// The place, in world space.
    pub position: [f64; 3],
    /// N
    pub normal: [f32; 3],
    /// V
    pub view: [f32; 3],
    /// What the surface reflects there.
    pub reflectance: Reflectance<f32>,
    /// What each light adds.
    pub lights: Vec<ExplainedLight>,
    /// The emitted light.
    pub emission: [f32; 3],
    /// I_a k_a O_a
    pub scene_ambient: [f32; 3],
    /// The reflected environment, mirrored and diffuse.
    pub environment: [f32; 3],
    /// What the parts of the model mirror, by their place in the mix; empty where light is
    /// interpolated between other places.
    pub mirrors: Vec<(usize, MirrorTerms<f32>)>,
    /// The diffuse part of the environment's term, if the environment is a map.
    pub environment_diffuse: Option<[f32; 3]>,
    /// What the parts of the model reflect of it to all sides, as `mirrors`.
    pub diffused: Vec<(usize, DiffuseTerms<f32>)>,
    /// The sum of all terms.
    pub sum: [f32; 3],
    /// The sum as it is interpolated: clamped, unless the view says otherwise.
    pub light: [f32; 3],
}

/// A material at a sample.
#[derive(Clone, Debug, PartialEq)]
pub struct ExplainedMaterial {
    /// Its name.
    pub name: String,
    /// The constants, k_a, k_d, k_s and the model among them.
    pub constants: Material,
    /// What textures and vertex colours made of the others.
    pub reflectance: Reflectance<f32>,
}

/// One light's terms at a sample.
#[derive(Clone, Debug, PartialEq)]
pub struct ExplainedLight {
    /// Its name.
    pub name: String,
    /// Its kind and intensities.
    pub light: Light,
    /// Where it stands, in world space; of a directional light it means nothing.
    pub position: [f64; 3],
    /// The direction in which its light travels, of unit length, in world space; of a point light
    /// it means nothing.
    pub direction: [f32; 3],
    /// What the parts of the model of reflection make of it, by their place in the mix; empty where
    /// light is interpolated between other places.
    pub parts: Vec<(usize, PartTerms<f32>)>,
    /// Factors and products.
    pub terms: LightTerms<f32>,
    /// What keeps the light away, if the view asks for shadows.
    pub shadow: Option<ExplainedShadow>,
}

/// What keeps a light away from a place. Its V, the product of the terminator's factor and of what comes
/// along the ray, is [`LightTerms::visibility`].
#[derive(Clone, Debug, PartialEq)]
pub struct ExplainedShadow {
    /// The factor of [`luxel_lighting::terminator`]; 1 where it does nothing.
    pub terminator: f32,
    /// How far the ray's origin is moved from its triangle towards the curved surface that the triangle stands
    /// for, as [`luxel_rays::SceneRays::terminator_offset`] has it; 0 where that does nothing.
    pub raised: f64,
    /// Origin and direction of the ray to the light, the first of several, in world space; `None` where N.L <= 0,
    /// where the terminator's factor is 0, and of points and lines: then no ray is traced.
    pub ray: Option<[[f64; 3]; 2]>,
    /// The objects in the way, nearest to the surface first.
    pub blocked_by: Vec<BlockedBy>,
}

impl ExplainedShadow {
    /// Where no ray is traced.
    pub(super) const NO_RAY: Self =
        Self { terminator: 1.0, raised: 0.0, ray: None, blocked_by: Vec::new() };
}

/// An object in the way of a light.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockedBy {
    /// The object, by its place among [`Renderer::objects`](crate::Renderer::objects).
    pub object: usize,
    /// Its name.
    pub name: String,
    /// The triangle of it that the ray meets first.
    pub triangle: u32,
    /// The distance from the surface to that triangle.
    pub distance: f64,
    /// The part of the light that the object keeps.
    pub share: f32,
}

/// Why a light adds nothing to the diffuse and the specular term.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unlit {
    /// N.L <= 0: the light stands behind the surface.
    Behind,
    /// The surface lies outside of the cone.
    OutsideCone {
        /// The cosine of the angle between the cone's axis and the way to the surface.
        cos_angle: f32,
        /// The cosine of the cone's half-angle.
        cos_cutoff: f32,
    },
    /// The surface lies beyond the light's range.
    OutOfRange {
        /// How far the surface is.
        distance: f32,
        /// Where the light ends.
        range: f32,
    },
    /// The light stands at the surface itself.
    AtTheSurface,
    /// Something stands between the surface and the light.
    Shadowed,
    /// The surface turns away from the light, though the normal of its normal map doesn't.
    BeyondTerminator,
    /// The light has no intensity for reflection.
    Dark,
    /// The surface reflects nothing of its colour.
    Absorbed,
}

impl ExplainedSample {
    /// An entry for one sample.
    pub(crate) fn new(sample: u8, seen: Vec<Seen>) -> Self {
        let mut entry = Self {
            weight: 0.0,
            covers: vec![sample],
            at: [0.0; 2],
            seen,
            color: [0.0; 3],
            display: [0.0; 3],
            alpha: 0.0,
        };
        if let [only] = &*entry.seen {
            (entry.color, entry.display, entry.alpha) =
                (only.color(), only.display(), only.alpha());
        } else {
            let (light, through) = entry.gathered();
            entry.alpha = 1.0 - through;
            let divisor = if entry.alpha > 0.0 { entry.alpha } else { 1.0 };
            entry.display = light.map(|channel| channel / divisor);
            let (light, _) = entry.gathered_by(Seen::color);
            entry.color = light.map(|channel| channel / divisor);
        }
        entry
    }

    /// The light of all that is seen, as shown, times alpha, and how much of what lies behind still comes
    /// through.
    #[must_use]
    pub fn gathered(&self) -> ([f32; 3], f32) {
        self.gathered_by(Seen::display)
    }

    fn gathered_by(&self, of: fn(&Seen) -> [f32; 3]) -> ([f32; 3], f32) {
        let (mut light, mut through) = ([0.0; 3], 1.0);
        for seen in &self.seen {
            crate::resolve::put_behind(&mut light, &mut through, of(seen), seen.alpha());
        }
        (light, through)
    }
}

impl Seen {
    /// What goes to the eye of it, not multiplied by alpha.
    #[must_use]
    pub fn color(&self) -> [f32; 3] {
        match self {
            Self::Background { color, .. } => *color,
            Self::Surface(surface) => surface.color,
        }
    }

    /// The same, after exposure and tone curve.
    #[must_use]
    pub fn display(&self) -> [f32; 3] {
        match self {
            Self::Background { color, .. } => *color,
            Self::Surface(surface) => surface.display,
        }
    }

    /// How much of what lies behind it covers.
    #[must_use]
    pub fn alpha(&self) -> f32 {
        match self {
            Self::Background { alpha, .. } => *alpha,
            Self::Surface(surface) => surface.alpha,
        }
    }

    /// The surface, if it is one.
    #[must_use]
    pub fn surface(&self) -> Option<&ExplainedSurface> {
        match self {
            Self::Background { .. } => None,
            Self::Surface(surface) => Some(surface),
        }
    }
}

impl ExplainedLight {
    /// The vector that the highlight goes by, with its name, for a surface of a model of reflection
    /// with N and V: R = 2 (N.L) N - L (Phong), H = (L + V) / |L + V| (Blinn, microfacets).
    #[must_use]
    pub fn highlight(
        &self,
        reflection: &Reflection,
        normal: [f32; 3],
        view: [f32; 3],
    ) -> Option<(&'static str, [f32; 3])> {
        let to_light = self.terms.to_light.lane(0);
        match reflection.model()?.highlight? {
            HighlightVector::Reflected => {
                let twice = 2.0 * self.terms.n_dot_l;
                Some(("R", [0, 1, 2].map(|axis| twice * normal[axis] - to_light[axis])))
            }
            HighlightVector::Halfway => {
                let sum = [0, 1, 2].map(|axis| to_light[axis] + view[axis]);
                let length = sum.iter().map(|side| side * side).sum::<f32>().sqrt();
                Some(("H", sum.map(|side| if length > 0.0 { side / length } else { 0.0 })))
            }
        }
    }

    /// Why the light adds no diffuse and no specular term; `None` if it adds one.
    #[must_use]
    pub fn unlit(&self) -> Option<Unlit> {
        let LightTerms {
            distance, attenuation, spot, n_dot_l, diffuse, specular, visibility, ..
        } = &self.terms;
        let black = [0.0; 3];
        if diffuse.lane(0) != black || specular.lane(0) != black {
            return None;
        }
        let Light { kind, diffuse, specular, attenuation: law, .. } = &self.light;
        Some(match (kind, law.range) {
            _ if *distance == Some(0.0) => Unlit::AtTheSurface,
            _ if *diffuse == black && *specular == black => Unlit::Dark,
            _ if *n_dot_l <= 0.0 => Unlit::Behind,
            (LightKind::Spot(cone), _) if *spot == 0.0 => Unlit::OutsideCone {
                cos_angle: -self.cos_to_axis(),
                cos_cutoff: match *cone {
                    Cone::Exponent { cos_cutoff, .. } => cos_cutoff,
                    Cone::Smooth { cos_outer, .. } => cos_outer,
                },
            },
            (_, Some(range)) if *attenuation == 0.0 => {
                Unlit::OutOfRange { distance: distance.unwrap_or_default(), range }
            }
            _ if self.shadow.as_ref().is_some_and(|shadow| shadow.terminator == 0.0) => {
                Unlit::BeyondTerminator
            }
            _ if *visibility == Some(0.0) => Unlit::Shadowed,
            _ => Unlit::Absorbed,
        })
    }

    /// The cosine of the angle between L and the direction of the light.
    fn cos_to_axis(&self) -> f32 {
        let [x, y, z] = self.terms.to_light.lane(0);
        let [a, b, c] = self.direction;
        x * a + y * b + z * c
    }
}
