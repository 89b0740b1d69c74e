//! Materials: metallic-roughness, unlit, and the older specular-glossiness
//! (glTF 2.0 specification, section 3.9).

use super::buffers::malformed;
use super::mesh::DefaultMaterials;
use super::textures::Textures;
use crate::Error;
use crate::warnings::Warnings;
use luxel_gltf::{Index, Material as FileMaterial, MetallicRoughness, TextureTransform};
use luxel_lighting::{Material, Reflection};
use luxel_scene::{AlphaMode, Encoding, Name, SceneMaterial, Sides, TextureUse};

/// The default cutoff of masks.
const DEFAULT_CUTOFF: f32 = 0.5;

/// The members that the kinds of texture object share.
struct Reference<'r> {
    index: Index,
    tex_coord: u32,
    transform: Option<&'r TextureTransform>,
    strength: f32,
}

/// A reference from any of the three kinds of texture object.
macro_rules! reference {
    ($info:expr, $strength:expr) => {
        Reference {
            index: $info.index,
            tex_coord: $info.tex_coord,
            transform: $info.extensions.transform.as_ref(),
            strength: $strength,
        }
    };
}

/// Converts material `index`.
pub(crate) fn convert(
    material: &FileMaterial,
    index: usize,
    textures: &mut Textures<'_, '_>,
    warnings: &mut Warnings,
) -> Result<SceneMaterial, Error> {
    let pointer = format!("/materials/{index}");
    let mut usage = |reference: Option<Reference<'_>>, part: &str, encoding| match reference {
        Some(reference) => {
            let pointer = format!("{pointer}/{part}");
            texture_use(&reference, encoding, &pointer, textures, warnings)
        }
        None => Ok(None),
    };
    let absent = MetallicRoughness::default();
    let surface = material.pbr_metallic_roughness.as_deref().unwrap_or(&absent);
    let base_color = usage(
        surface.base_color_texture.as_ref().map(|info| reference!(info, 1.0)),
        "pbrMetallicRoughness/baseColorTexture",
        Encoding::Srgb,
    )?;
    let metallic_roughness = usage(
        surface.metallic_roughness_texture.as_ref().map(|info| reference!(info, 1.0)),
        "pbrMetallicRoughness/metallicRoughnessTexture",
        Encoding::Linear,
    )?;
    let normal = usage(
        material.normal_texture.as_ref().map(|info| reference!(info, info.scale.unwrap_or(1.0))),
        "normalTexture",
        Encoding::Linear,
    )?;
    let occlusion = usage(
        material
            .occlusion_texture
            .as_ref()
            .map(|info| reference!(info, info.strength.unwrap_or(1.0))),
        "occlusionTexture",
        Encoding::Linear,
    )?;
    let emission = usage(
        material.emissive_texture.as_ref().map(|info| reference!(info, 1.0)),
        "emissiveTexture",
        Encoding::Srgb,
    )?;
    let emissive_strength = material
        .extensions
        .emissive_strength
        .as_ref()
        .map_or(1.0, |extension| extension.emissive_strength);
    let emissive = material.emissive_factor.unwrap_or([0.0; 3]);
    let [red, green, blue, opacity] = surface.base_color_factor;
    let mut converted = SceneMaterial {
        name: name(material, index),
        constants: Material {
            reflection: Reflection::Microfacet,
            diffuse: [red, green, blue],
            emission: emissive.map(|channel| channel * emissive_strength),
            k_s: 1.0,
            metallic: surface.metallic_factor,
            roughness: surface.roughness_factor,
            ..Material::default()
        },
        opacity,
        alpha_mode: alpha_mode(material, &pointer)?,
        sides: if material.double_sided { Sides::Both } else { Sides::Front },
        base_color,
        metallic_roughness,
        normal,
        occlusion,
        emission,
        ..SceneMaterial::default()
    };
    if let Some(extension) = &material.extensions.specular_glossiness {
        let [red, green, blue, opacity] = extension.diffuse_factor;
        converted.constants.diffuse = [red, green, blue];
        converted.opacity = opacity;
        converted.constants.metallic = 0.0;
        converted.constants.roughness = 1.0 - extension.glossiness_factor;
        converted.metallic_roughness = None;
        converted.base_color = usage(
            extension.diffuse_texture.as_ref().map(|info| reference!(info, 1.0)),
            "extensions/KHR_materials_pbrSpecularGlossiness/diffuseTexture",
            Encoding::Srgb,
        )?;
        warnings.push(format!(
            "{pointer}: KHR_materials_pbrSpecularGlossiness is shown by its diffuse colour and \
             glossiness; its specular colour is ignored"
        ));
    }
    if material.extensions.unlit.is_some() {
        converted.constants.reflection = Reflection::Unlit;
    }
    check(&converted, &pointer)?;
    Ok(converted)
}

/// The materials of primitives without one, in the order of first use.
pub(crate) fn defaults(used: &DefaultMaterials) -> Vec<SceneMaterial> {
    // One-sided as the format requires (section 3.9.6); colour and gloss are luxel's defaults.
    let plain = SceneMaterial { sides: Sides::Front, ..SceneMaterial::default() };
    let mut colored = plain.clone();
    colored.name = "vertex colors".into();
    colored.constants.diffuse = [1.0; 3];
    let mut requested: Vec<_> = used.used.into_iter().zip([plain, colored]).collect();
    requested.sort_by_key(|&(id, _)| id);
    requested.into_iter().filter(|(id, _)| id.is_some()).map(|(_, material)| material).collect()
}

fn name(material: &FileMaterial, index: usize) -> Name {
    let name = material.name.as_deref().filter(|name| !name.is_empty());
    name.map_or_else(|| format!("material_{index}").into(), Name::from)
}

fn alpha_mode(material: &FileMaterial, pointer: &str) -> Result<AlphaMode, Error> {
    match material.alpha_mode.as_deref() {
        None | Some("OPAQUE") => Ok(AlphaMode::Opaque),
        Some("BLEND") => Ok(AlphaMode::Blend),
        Some("MASK") => {
            Ok(AlphaMode::Mask { cutoff: material.alpha_cutoff.unwrap_or(DEFAULT_CUTOFF) })
        }
        Some(other) => {
            let message = format!("`{other}` is not an alpha mode: use OPAQUE, MASK or BLEND");
            Err(malformed(format!("{pointer}/alphaMode"), message))
        }
    }
}

/// A texture with its transform; `None` if its image can't be shown.
fn texture_use(
    reference: &Reference<'_>,
    encoding: Encoding,
    pointer: &str,
    textures: &mut Textures<'_, '_>,
    warnings: &mut Warnings,
) -> Result<Option<Box<TextureUse>>, Error> {
    let transform = reference.transform;
    let set = transform.and_then(|transform| transform.tex_coord).unwrap_or(reference.tex_coord);
    let texture = textures.get(reference.index, encoding, &|| pointer.to_owned(), warnings)?;
    let Some(uv_set) = u8::try_from(set).ok().filter(|&set| set < 2) else {
        warnings.push(format!(
            "{pointer}: left out: luxel reads TEXCOORD_0 and TEXCOORD_1, not TEXCOORD_{set}"
        ));
        return Ok(None);
    };
    let plain = |texture| TextureUse::new(texture).transform;
    let used = texture.map(|texture| TextureUse {
        texture,
        uv_set,
        transform: transform.map_or_else(|| plain(texture), matrix),
        strength: reference.strength,
    });
    Ok(used.map(Box::new))
}

/// Scale, then rotation (counter-clockwise in the image, whose v points down), then offset
/// (`KHR_texture_transform`).
fn matrix(transform: &TextureTransform) -> [f32; 6] {
    let (sine, cosine) = (libm::sin(transform.rotation), libm::cos(transform.rotation));
    let [scale_u, scale_v] = transform.scale;
    let [offset_u, offset_v] = transform.offset;
    [cosine * scale_u, sine * scale_v, offset_u, -sine * scale_u, cosine * scale_v, offset_v]
        .map(|entry| entry as f32)
}

/// JSON has no infinity, but its numbers may overflow `f32`.
fn check(material: &SceneMaterial, pointer: &str) -> Result<(), Error> {
    let constants = &material.constants;
    let cutoff = match material.alpha_mode {
        AlphaMode::Mask { cutoff } => cutoff,
        AlphaMode::Opaque | AlphaMode::Blend => 0.0,
    };
    let of_uses = material
        .textures()
        .flat_map(|usage| usage.transform.iter().copied().chain(std::iter::once(usage.strength)));
    let all_finite = [constants.metallic, constants.roughness, material.opacity, cutoff]
        .into_iter()
        .chain(constants.diffuse)
        .chain(constants.emission)
        .chain(of_uses)
        .all(f32::is_finite);
    if all_finite {
        return Ok(());
    }
    Err(malformed(pointer, "a number is too large"))
}
