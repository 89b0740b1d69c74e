//! Textures: images, decoded once per encoding in use, with their samplers.

use super::buffers::{Buffers, item};
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Limits, Place, Warning, image};
use luxel_gltf::{Index, Sampler as FileSampler};
use luxel_scene::{
    Encoding, Filter, Image, Sampler, SceneMaterial, Texture, TextureId, TextureUse, Wrap,
};
use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

/// The textures that materials use.
pub(crate) struct Textures<'b, 'd> {
    buffers: &'b Buffers<'d>,
    /// Images by number and encoding, in the order of the first use.
    images: Vec<(Index, Encoding)>,
    /// For each texture, the index of its image above, and its sampler.
    textures: Vec<(usize, Sampler)>,
    /// Indices into the lists above, by image (and whether it is sRGB) and by texture.
    image_places: HashMap<(Index, bool), usize>,
    texture_places: HashMap<(usize, Option<Index>), TextureId>,
}

impl<'b, 'd> Textures<'b, 'd> {
    pub(crate) fn new(buffers: &'b Buffers<'d>) -> Self {
        Self {
            buffers,
            images: Vec::new(),
            textures: Vec::new(),
            image_places: HashMap::new(),
            texture_places: HashMap::new(),
        }
    }

    /// The texture `index` of the document, for values of an encoding; `None`, with a warning, if
    /// it has no image that luxel reads.
    pub(crate) fn get(
        &mut self,
        index: Index,
        encoding: Encoding,
        referrer: &dyn Fn() -> String,
        warnings: &mut Warnings,
    ) -> Result<Option<TextureId>, Error> {
        let document = self.buffers.document();
        let texture =
            item(&document.textures, index, "texture", &|| format!("{}/index", referrer()))?;
        let pointer = || format!("/textures/{index}");
        let Some(source) = texture.source else {
            warnings.push(format!("{}: left out: luxel can't read its image", pointer()));
            return Ok(None);
        };
        item(&document.images, source, "image", &|| format!("{}/source", pointer()))?;
        let sampler = match texture.sampler {
            Some(sampler) => {
                let pointer = || format!("{}/sampler", pointer());
                convert(item(&document.samplers, sampler, "sampler", &pointer)?)
            }
            None => Sampler::trilinear(),
        };
        let (images, textures) = (&mut self.images, &mut self.textures);
        let key = (source, encoding == Encoding::Srgb);
        let image = *self.image_places.entry(key).or_insert_with(|| {
            images.push((source, encoding));
            images.len() - 1
        });
        let key = (image, texture.sampler);
        Ok(Some(*self.texture_places.entry(key).or_insert_with(|| {
            textures.push((image, sampler));
            TextureId(textures.len() as u32 - 1)
        })))
    }

    /// Reads and decodes the images in parallel. A placeholder replaces a missing or damaged one; one that
    /// is not a regular file in the document's folder is an error.
    ///
    /// A placeholder shows where a colour is missing; as bumps or roughness it would mislead, so
    /// materials lose textures of those kinds.
    pub(crate) fn load(
        self,
        materials: &mut [SceneMaterial],
        warnings: &mut Warnings,
    ) -> Result<Vec<Texture>, Error> {
        let names: Vec<_> = self.images.iter().map(|&(index, _)| self.name(index)).collect();
        let decoded = self.decoded(&names)?;
        let failed: Vec<_> = decoded.iter().map(Result::is_err).collect();
        for material in materials {
            let parts =
                [&mut material.metallic_roughness, &mut material.normal, &mut material.occlusion];
            for part in parts {
                let is_lost = |usage: &mut Box<TextureUse>| {
                    let (image, _) = self.textures[usage.texture.index()];
                    failed[image]
                };
                part.take_if(is_lost);
            }
        }
        let named = self.images.iter().zip(names);
        let images: Vec<_> = named
            .zip(decoded)
            .map(|((&(index, _), name), decoded)| {
                Arc::new(decoded.unwrap_or_else(|warning| {
                    warnings
                        .push(warning.at(format_args!("/images/{index}: a placeholder is shown")));
                    Image::stand_in(name)
                }))
            })
            .collect();
        let textures = self.textures.iter();
        Ok(textures
            .map(|&(image, sampler)| Texture { image: Arc::clone(&images[image]), sampler })
            .collect())
    }

    /// Decodes the images in parallel, each within a share of the memory left. An image that
    /// exceeds its share is retried alone, so that the result doesn't depend on the thread count.
    fn decoded(&self, names: &[String]) -> Result<Vec<Result<Image, Warning>>, Error> {
        let memory = self.buffers.memory();
        let at_once = 4 * luxel_parallel::threads();
        let mut decoded = Vec::with_capacity(names.len());
        for (images, names) in self.images.chunks(at_once).zip(names.chunks(at_once)) {
            let left = memory.left();
            let share = Limits { max_memory: left.max_memory / images.len() as u64, ..left };
            let encoded = images.iter().map(|&(index, _)| self.encoded(index));
            let encoded = encoded.collect::<Result<Vec<_>, _>>()?;
            let decode = |limits: &Limits, name: &str, place: usize| {
                let bytes = encoded[place].as_ref().map_err(Clone::clone)?;
                image::decode(name, bytes, images[place].1, limits)
            };
            let first = luxel_parallel::map(names.len(), 1, &|run| {
                Some(decode(&share, &names[run.start], run.start))
            });
            for (place, (name, image)) in names.iter().zip(first.into_iter().flatten()).enumerate()
            {
                let image = image.or_else(|_| decode(&memory.left(), name, place));
                decoded.push(image.and_then(|image| {
                    let texels = image.levels.iter().map(|level| level.texels.len() as u64).sum();
                    let taken = memory.take("an image", texels, 4, Place::File);
                    taken.map(|()| image).map_err(|error| error.kind.into())
                }));
            }
        }
        Ok(decoded)
    }

    /// The name in the document, else that of the file, else the number.
    fn name(&self, index: Index) -> String {
        let image = &self.buffers.document().images[index as usize];
        let of_file = || image.uri.clone().filter(|uri| !uri.starts_with("data:"));
        let of_number = || format!("image_{index}");
        image
            .name
            .clone()
            .filter(|name| !name.is_empty())
            .or_else(of_file)
            .unwrap_or_else(of_number)
    }

    /// The bytes of an image file, or why a placeholder stands in for it.
    fn encoded(&self, index: Index) -> Result<Result<Cow<'_, [u8]>, Warning>, Error> {
        let image = &self.buffers.document().images[index as usize];
        let pointer = format!("/images/{index}");
        let bytes = match (&image.uri, image.buffer_view) {
            (Some(uri), _) => self.buffers.resource(uri, &format!("{pointer}/uri")).map(Cow::Owned),
            (None, Some(view)) => {
                self.buffers.view(view, &|| pointer.clone()).map(|view| Cow::Borrowed(view.bytes))
            }
            (None, None) => return Ok(Err("it has neither `uri` nor `bufferView`".into())),
        };
        match bytes {
            Err(error)
                if matches!(error.kind, ErrorKind::Reference(_)) && self.buffers.has_folder() =>
            {
                Err(error)
            }
            bytes => Ok(bytes.map_err(|error| Warning { hint: error.hint(), ..error.kind.into() })),
        }
    }
}

/// The sampler's settings; by default textures repeat, with the smoothest filter.
fn convert(sampler: &FileSampler) -> Sampler {
    let wrap = |code| match code {
        Some(33_071) => Wrap::ClampToEdge,
        Some(33_648) => Wrap::MirroredRepeat,
        _ => Wrap::Repeat,
    };
    let (minify, mipmap) = match sampler.min_filter {
        Some(9728) => (Filter::Nearest, None),
        Some(9729) => (Filter::Linear, None),
        Some(9984) => (Filter::Nearest, Some(Filter::Nearest)),
        Some(9985) => (Filter::Linear, Some(Filter::Nearest)),
        Some(9986) => (Filter::Nearest, Some(Filter::Linear)),
        _ => (Filter::Linear, Some(Filter::Linear)),
    };
    Sampler {
        wrap_u: wrap(sampler.wrap_s),
        wrap_v: wrap(sampler.wrap_t),
        magnify: if sampler.mag_filter == Some(9728) { Filter::Nearest } else { Filter::Linear },
        minify,
        mipmap,
    }
}
