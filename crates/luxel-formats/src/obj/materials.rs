//! Converts MTL statements into materials.
//!
//! MTL has the terms of the lighting equation; missing statements get the defaults of materials
//! without a file. Beyond that:
//! - `illum 0` is unlit, 1 has no highlight, all others are Blinn-Phong.
//! - `Kd` left out beside a `map_Kd` is white, and so for the other colours and their maps.
//! - `Ka` with `map_Kd` but without `map_Ka`: the ambient colour is `Ka` times the diffuse texture,
//!   or textured objects would lose their texture in the shade.
//! - `Ns 0` has no highlight: exporters write it for "none", and (N.H)^0 would be a highlight over
//!   the whole lit side.
//! - `Tr 1` without `d` is opaque, because MeshLab and others write opacity there, and nobody
//!   describes an invisible material.
//! - A diffuse texture with alpha, or a `map_d`, makes holes if its alpha is all but black and
//!   white, and blends otherwise.

use super::definitions::Definitions;
use super::document::NONE;
use super::mtl::{self, Definition, Map, Maps};
use crate::files::Refusal;
use crate::image;
use crate::memory::Memory;
use crate::text::shown;
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Format, Limits, Place, Warning, files};
use luxel_lighting::Reflection;
use luxel_scene::{
    AlphaMode, Encoding, Image, MaterialId, Sampler, SceneMaterial, Texture, TextureId, TextureUse,
    Wrap,
};
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Bytes that a texel takes with its mipmaps.
const BYTES_PER_TEXEL: u64 = 6;

/// The materials of the scene, built on first use.
pub(super) struct Materials<'a> {
    folder: Option<&'a Path>,
    memory: Memory<'a>,
    /// By the file's number.
    names: &'a [&'a [u8]],
    definitions: Definitions,
    pub(super) list: Vec<SceneMaterial>,
    pub(super) textures: Vec<Texture>,
    /// The numbers of built materials or [`NONE`], by the file's number and by whether they are for vertices with
    /// colours; last that of elements without one.
    made: Vec<[u32; 2]>,
    loaded: HashMap<(String, Use, bool), TextureId>,
}

/// The use of an image, which decides how its texels are decoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Use {
    Color,
    Opacity,
    Normal,
}

impl<'a> Materials<'a> {
    /// Reads the libraries; `names` are the materials by the file's numbers.
    pub(super) fn read(
        libraries: &[&[u8]],
        names: &'a [&'a [u8]],
        folder: Option<&'a Path>,
        limits: &'a Limits,
        warnings: &mut Warnings,
    ) -> Result<Self, Error> {
        let mut definitions = Definitions::new(names.len());
        let numbers: HashMap<&[u8], usize> = names.iter().copied().zip(0..).collect();
        let mut files = Libraries { folder, memory: Memory::new(limits), seen: HashSet::new() };
        for line in libraries {
            for (name, bytes) in files.of_line(line, warnings)? {
                mtl::read(&bytes, &name, warnings, &mut |name, definition| {
                    // The first definition wins: libraries are searched in order.
                    if let Some(&number) = numbers.get(name) {
                        definitions.put(number, definition);
                    }
                });
            }
        }
        Ok(Self {
            folder,
            memory: files.memory,
            names,
            definitions,
            list: Vec::new(),
            textures: Vec::new(),
            made: vec![[NONE; 2]; names.len() + 1],
            loaded: HashMap::new(),
        })
    }

    /// A material of the file, for a mesh with or without vertex colours.
    pub(super) fn get(
        &mut self,
        number: u32,
        is_colored: bool,
        warnings: &mut Warnings,
    ) -> Result<MaterialId, Error> {
        let number = (number as usize).min(self.names.len());
        let made = self.made[number][usize::from(is_colored)];
        if made != NONE {
            return Ok(MaterialId(made));
        }
        let name = self.names.get(number).copied();
        let definition = self.definitions.take(number);
        let mut material = match (&definition, name) {
            (Some(definition), _) => self.make(definition, number, warnings)?,
            (None, name) => {
                if let Some(name) = name {
                    let name = shown(name);
                    warnings
                        .push(format!("no library has the material `{name}`: a default is used"));
                }
                SceneMaterial::default()
            }
        };
        if let Some(name) = name {
            material.name = shown(name).into();
        }
        if definition.is_none() && is_colored {
            // The vertex colour replaces the material's.
            material.constants.diffuse = [1.0; 3];
        }
        let id = MaterialId(self.list.len() as u32);
        self.list.push(material);
        let made = &mut self.made[number];
        made[usize::from(is_colored)] = id.0;
        if definition.is_some() {
            *made = [id.0; 2];
        }
        Ok(id)
    }

    fn make(
        &mut self,
        definition: &Definition,
        number: usize,
        warnings: &mut Warnings,
    ) -> Result<SceneMaterial, Error> {
        let none = Maps::default();
        let maps = definition.maps.as_deref().unwrap_or(&none);
        let mut material = SceneMaterial::default();
        let constants = &mut material.constants;
        let or_white = |color: Option<[f32; 3]>, map: &Option<Map>| {
            color.or_else(|| map.as_ref().map(|_| [1.0; 3]))
        };
        if let Some(diffuse) = or_white(definition.diffuse, &maps.diffuse) {
            constants.diffuse = diffuse;
        }
        constants.ambient = or_white(definition.ambient, &maps.ambient);
        if let Some(specular) = or_white(definition.specular, &maps.specular) {
            constants.specular = specular;
            constants.k_s = 1.0;
        }
        if let Some(emission) = or_white(definition.emission, &maps.emission) {
            constants.emission = emission;
        }
        if let Some(shininess) = definition.shininess {
            constants.shininess = shininess;
        }
        constants.reflection = match definition.illumination {
            Some(0) => Reflection::Unlit,
            Some(1) => Reflection::Lambert,
            _ => Reflection::BlinnPhong,
        };
        if definition.illumination == Some(1) || definition.shininess == Some(0.0) {
            constants.k_s = 0.0;
        }
        let transparency = definition.transparency.filter(|&transparency| transparency < 1.0);
        material.opacity =
            definition.opacity.or(transparency.map(|tr| 1.0 - tr)).unwrap_or(1.0).min(1.0);
        if material.opacity < 1.0 {
            material.alpha_mode = AlphaMode::Blend;
        }
        self.set_maps(maps, number, &mut material, warnings)?;
        if maps.ambient.is_none() && definition.ambient.is_some() {
            material.ambient.clone_from(&material.base_color);
        }
        Ok(material)
    }

    fn set_maps(
        &mut self,
        maps: &Maps,
        number: usize,
        material: &mut SceneMaterial,
        warnings: &mut Warnings,
    ) -> Result<(), Error> {
        let mut get = |map: &Option<Map>, used: Use| -> Result<_, Error> {
            map.as_ref().map(|map| self.texture(map, used, warnings).map(Box::new)).transpose()
        };
        material.base_color = get(&maps.diffuse, Use::Color)?;
        material.specular = get(&maps.specular, Use::Color)?;
        material.emission = get(&maps.emission, Use::Color)?;
        material.opacity_map = get(&maps.opacity, Use::Opacity)?;
        material.normal = get(&maps.normal, Use::Normal)?;
        material.ambient = get(&maps.ambient, Use::Color)?;
        let bump = get(&maps.bump, Use::Normal)?;
        if let Some(bump) = bump.filter(|_| material.normal.is_none()) {
            if is_normal_map(self.level(&bump)) {
                material.normal = Some(bump);
            } else {
                let name = self.names.get(number).map(|name| shown(name)).unwrap_or_default();
                warnings.push(format!(
                    "material `{name}`: bump maps of heights are ignored: use a normal map (`norm`)"
                ));
            }
        }
        let alpha = |texel: &[u8; 4]| texel[3];
        let red = |texel: &[u8; 4]| texel[0];
        let of_color = material.base_color.as_ref().map(|used| alpha_mode(self.level(used), alpha));
        let of_map = material.opacity_map.as_ref().map(|used| alpha_mode(self.level(used), red));
        for mode in [of_color, of_map].into_iter().flatten() {
            material.alpha_mode = match (material.alpha_mode, mode) {
                (AlphaMode::Blend, _) | (_, AlphaMode::Opaque) => material.alpha_mode,
                _ => mode,
            };
        }
        Ok(())
    }

    fn level(&self, used: &TextureUse) -> &[[u8; 4]] {
        let texture = self.textures.get(used.texture.index());
        texture.and_then(|texture| texture.image.levels.first()).map_or(&[], |level| &level.texels)
    }

    /// Loads a texture, or a placeholder for one that is missing or damaged.
    fn texture(
        &mut self,
        map: &Map,
        used: Use,
        warnings: &mut Warnings,
    ) -> Result<TextureUse, Error> {
        let key = (map.name.clone(), used, map.clamp);
        let texture = if let Some(loaded) = self.loaded.get(&key) {
            *loaded
        } else {
            let image = match files::referenced(self.folder, &map.name, self.memory.given()) {
                Ok(path) => self.image(&path, &map.name, used),
                Err(refusal) => Err(missing("texture", refusal)?),
            };
            let image = image.unwrap_or_else(|warning| {
                warnings.push(warning.at(format_args!("texture `{}`", map.name)));
                match used {
                    Use::Color => Image::stand_in(map.name.clone()),
                    // A placeholder would be opaque and flat, so these are dropped.
                    Use::Opacity => one_texel(&map.name, [255; 4]),
                    Use::Normal => one_texel(&map.name, [128, 128, 255, 255]),
                }
            });
            let mut sampler = Sampler::trilinear();
            if map.clamp {
                sampler.wrap_u = Wrap::ClampToEdge;
                sampler.wrap_v = Wrap::ClampToEdge;
            }
            let id = TextureId(self.textures.len() as u32);
            self.textures.push(Texture { image: Arc::new(image), sampler });
            self.loaded.insert(key, id);
            id
        };
        let ([su, sv], [ou, ov]) = (map.scale, map.offset);
        // MTL's v' = sv v + ov points up, ours down.
        let transform = [su, 0.0, ou, 0.0, sv, 1.0 - sv - ov];
        Ok(TextureUse { transform, strength: map.strength, ..TextureUse::new(texture) })
    }

    fn image(&self, path: &Path, name: &str, used: Use) -> Result<Image, Warning> {
        let limits = self.memory.left();
        let bytes = files::read_file(path, &limits).map_err(|error| Warning::from(error.kind))?;
        let encoding = if used == Use::Color { Encoding::Srgb } else { Encoding::Linear };
        let mut image = image::decode(name, &bytes, encoding, &limits)?;
        let texels = image.levels[0].texels.len() as u64;
        let taken = self.memory.take("the textures", texels, BYTES_PER_TEXEL, Place::File);
        taken.map_err(|error| Warning::from(error.kind))?;
        if used == Use::Opacity && image.levels[0].texels.iter().any(|texel| texel[3] < 255) {
            // An image with alpha that is used as opacity map gives its alpha.
            for texel in image.levels.iter_mut().flat_map(|level| &mut level.texels) {
                texel[0] = texel[3];
            }
        }
        Ok(image)
    }
}

/// The warning of something that is not there; the error of something else than a regular file in the
/// model's folder.
fn missing(what: &str, refusal: Refusal) -> Result<Warning, Error> {
    if refusal.is_there {
        let message = format!("{what} {}", refusal.message);
        return Err(Error::at(Place::File, ErrorKind::Reference(message)));
    }
    Ok(refusal.message.into())
}

fn one_texel(name: &str, texel: [u8; 4]) -> Image {
    Image::new(name, Encoding::Linear, 1, 1, vec![texel])
}

/// Material libraries, each read once however often it is named.
struct Libraries<'a> {
    folder: Option<&'a Path>,
    memory: Memory<'a>,
    seen: HashSet<PathBuf>,
}

/// What became of a name after `mtllib`.
enum Library {
    Read(Vec<u8>),
    /// Another line has named the same file.
    Known,
}

impl Libraries<'_> {
    /// The files that a `mtllib` line names: one whose name has spaces, or several.
    fn of_line(
        &mut self,
        line: &[u8],
        warnings: &mut Warnings,
    ) -> Result<Vec<(String, Vec<u8>)>, Error> {
        let whole = String::from_utf8_lossy(line).into_owned();
        let names: Vec<_> = whole.split_ascii_whitespace().collect();
        let mut read = |name: &str, warns: bool| -> Result<_, Error> {
            let library = match files::referenced(self.folder, name, self.memory.given()) {
                Ok(path) => self.read(path),
                Err(refusal) => Err(missing("library", refusal)?),
            };
            Ok(match library {
                Ok(library) => Some((name.to_owned(), library)),
                Err(warning) => {
                    if warns {
                        let what = "its materials are left out";
                        warnings.push(warning.at(format_args!("library `{name}`: {what}")));
                    }
                    None
                }
            })
        };
        let mut found = Vec::from_iter(read(&whole, names.len() < 2)?);
        if found.is_empty() && names.len() > 1 {
            for name in names {
                found.extend(read(name, true)?);
            }
        }
        let files = found.into_iter().filter_map(|(name, library)| match library {
            Library::Read(bytes) => Some((name, bytes)),
            Library::Known => None,
        });
        Ok(files.collect())
    }

    fn read(&mut self, path: PathBuf) -> Result<Library, Warning> {
        if self.seen.contains(&path) {
            return Ok(Library::Known);
        }
        let because = |error: Error| Warning::from(error.kind);
        let read = files::read_file(&path, &self.memory.left()).map(Cow::into_owned);
        let bytes = read.map_err(because)?;
        let taken = self.memory.take("the libraries", bytes.len() as u64, 1, Place::File);
        taken.map_err(because)?;
        Format::Obj.check_not_utf16(&bytes).map_err(because)?;
        self.seen.insert(path);
        Ok(Library::Read(bytes))
    }
}

/// The use of an image's alpha: none if opaque everywhere, a mask if nearly black and white.
fn alpha_mode(texels: &[[u8; 4]], alpha: impl Fn(&[u8; 4]) -> u8) -> AlphaMode {
    let below = |limit: u8| texels.iter().filter(|texel| alpha(texel) < limit).count();
    let (low, partly, not_full) = (below(16), below(240), below(255));
    if not_full == 0 {
        AlphaMode::Opaque
    } else if (partly - low) * 20 <= texels.len() && low > 0 {
        AlphaMode::Mask { cutoff: 0.5 }
    } else {
        AlphaMode::Blend
    }
}

/// Whether the texels are normals in tangent space: on average, (128, 128, 255) or nearly.
fn is_normal_map(texels: &[[u8; 4]]) -> bool {
    let count = texels.len().max(1) as u64;
    let sum = |channel: usize| texels.iter().map(|texel| u64::from(texel[channel])).sum::<u64>();
    let [red, green, blue] = [0, 1, 2].map(|channel| sum(channel) / count);
    (108..=148).contains(&red) && (108..=148).contains(&green) && blue > 190
}
