//! Materials of a scene: constants of reflection with the textures that vary them.

use crate::{Name, TextureId};
use luxel_lighting::Material;
use luxel_math::Lanes;

/// A material: the constants of the equation, and the textures that modulate them, which most of a file of
/// very many materials lack.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SceneMaterial {
    /// Its name.
    pub name: Name,
    /// The constants.
    pub constants: Material,
    /// Alpha of the whole surface: the base colour's alpha, or MTL's `d`.
    pub opacity: f32,
    /// The use of alpha.
    pub alpha_mode: AlphaMode,
    /// Which sides are drawn.
    pub sides: Sides,
    /// Whether the mesh's vertex colours multiply O_d and the opacity.
    pub vertex_colors: bool,
    /// Times O_d; its alpha times the opacity (glTF base colour, MTL `map_Kd`).
    pub base_color: Option<Box<TextureUse>>,
    /// Metalness from blue, roughness from green.
    pub metallic_roughness: Option<Box<TextureUse>>,
    /// Normals in tangent space; `strength` scales x and y.
    pub normal: Option<Box<TextureUse>>,
    /// Times the ambient and environment terms, from red; `strength` is how far it goes.
    pub occlusion: Option<Box<TextureUse>>,
    /// Times the emission.
    pub emission: Option<Box<TextureUse>>,
    /// Times O_s (MTL `map_Ks`).
    pub specular: Option<Box<TextureUse>>,
    /// Times O_a (MTL `map_Ka`).
    pub ambient: Option<Box<TextureUse>>,
    /// Times the opacity, from red (MTL `map_d`).
    pub opacity_map: Option<Box<TextureUse>>,
}

/// How a material samples a texture.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TextureUse {
    /// The texture.
    pub texture: TextureId,
    /// Which set of texture coordinates: 0 or 1.
    pub uv_set: u8,
    /// (u', v') = (m0 u + m1 v + m2, m3 u + m4 v + m5) (glTF `KHR_texture_transform`).
    pub transform: [f32; 6],
    /// How strongly the texture acts (normal scale, occlusion strength); 1 by default.
    pub strength: f32,
}

impl TextureUse {
    /// A texture over the first set of coordinates, as they are.
    #[must_use]
    pub const fn new(texture: TextureId) -> Self {
        Self { texture, uv_set: 0, transform: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0], strength: 1.0 }
    }

    /// Texture coordinates after the use's own transform.
    #[must_use]
    #[inline(always)]
    pub fn transformed<N: Lanes>(&self, [u, v]: [N; 2]) -> [N; 2] {
        let [a, b, c, d, e, f] = self.transform;
        [
            u.constant(a) * u + u.constant(b) * v + u.constant(c),
            u.constant(d) * u + u.constant(e) * v + u.constant(f),
        ]
    }

    /// A difference of texture coordinates after the use's own transform.
    #[must_use]
    #[inline(always)]
    pub fn transformed_step<N: Lanes>(&self, [u, v]: [N; 2]) -> [N; 2] {
        let [a, b, _, d, e, _] = self.transform;
        [u.constant(a) * u + u.constant(b) * v, u.constant(d) * u + u.constant(e) * v]
    }
}

/// The use of a surface's alpha.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum AlphaMode {
    /// Nothing.
    #[default]
    Opaque,
    /// Texels below the cutoff are holes.
    Mask {
        /// Alpha below this is not drawn.
        cutoff: f32,
    },
    /// The surface is transparent.
    Blend,
}

/// Which sides of a face are drawn when culling is left to the material.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Sides {
    /// Both: formats that don't say, and glTF's double-sided materials.
    #[default]
    Both,
    /// The front only.
    Front,
}

impl Default for SceneMaterial {
    fn default() -> Self {
        Self {
            name: "default".into(),
            constants: Material::default(),
            opacity: 1.0,
            alpha_mode: AlphaMode::Opaque,
            sides: Sides::Both,
            vertex_colors: true,
            base_color: None,
            metallic_roughness: None,
            normal: None,
            occlusion: None,
            emission: None,
            specular: None,
            ambient: None,
            opacity_map: None,
        }
    }
}

impl SceneMaterial {
    /// All its textures.
    pub fn textures(&self) -> impl Iterator<Item = &TextureUse> {
        let textures = [
            &self.base_color,
            &self.metallic_roughness,
            &self.normal,
            &self.occlusion,
            &self.emission,
            &self.specular,
            &self.ambient,
            &self.opacity_map,
        ];
        textures.into_iter().flatten().map(Box::as_ref)
    }

    /// All its textures, for changing which they are.
    pub fn textures_mut(&mut self) -> impl Iterator<Item = &mut TextureUse> {
        let textures = [
            &mut self.base_color,
            &mut self.metallic_roughness,
            &mut self.normal,
            &mut self.occlusion,
            &mut self.emission,
            &mut self.specular,
            &mut self.ambient,
            &mut self.opacity_map,
        ];
        textures.into_iter().flatten().map(Box::as_mut)
    }
}
