//! MTL: the materials of OBJ files (Wavefront, "MTL material format", 1995).

use super::lines::Lines;
use crate::text::{Words, integer, shown, single};
use crate::warnings::Warnings;

/// A material as written; missing statements are `None`.
#[derive(Debug, Default)]
pub(super) struct Definition {
    pub(super) name: Vec<u8>,
    pub(super) ambient: Option<[f32; 3]>,
    pub(super) diffuse: Option<[f32; 3]>,
    pub(super) specular: Option<[f32; 3]>,
    pub(super) emission: Option<[f32; 3]>,
    pub(super) shininess: Option<f32>,
    /// `d`
    pub(super) opacity: Option<f32>,
    /// `Tr`
    pub(super) transparency: Option<f32>,
    pub(super) illumination: Option<i64>,
    pub(super) ambient_map: Option<Box<Map>>,
    pub(super) diffuse_map: Option<Box<Map>>,
    pub(super) specular_map: Option<Box<Map>>,
    pub(super) emission_map: Option<Box<Map>>,
    pub(super) opacity_map: Option<Box<Map>>,
    /// `map_Bump` or `bump`: heights, though many files put normal maps here.
    pub(super) bump_map: Option<Box<Map>>,
    /// `norm`
    pub(super) normal_map: Option<Box<Map>>,
}

/// A texture with its options.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Map {
    /// The file name, spaces included.
    pub(super) name: String,
    /// `-s`
    pub(super) scale: [f32; 2],
    /// `-o`
    pub(super) offset: [f32; 2],
    /// `-clamp on`
    pub(super) clamp: bool,
    /// `-bm`
    pub(super) strength: f32,
}

/// Reads a library: `put` gets its materials in order. Invalid statements are ignored, with a warning.
pub(super) fn read(
    bytes: &[u8],
    file: &str,
    warnings: &mut Warnings,
    put: &mut dyn FnMut(Definition),
) {
    let mut current: Option<Definition> = None;
    let mut lines = Lines::new(bytes);
    while let Some(line) = lines.next() {
        let mut words = Words::new(&line);
        let Some(keyword) = words.next() else { continue };
        if keyword == b"newmtl" {
            let name = words.rest().to_vec();
            if let Some(before) = current.replace(Definition { name, ..Definition::default() }) {
                put(before);
            }
        } else if let Some(definition) = &mut current
            && !definition.statement(keyword, words.clone())
        {
            let line = lines.number;
            let rest = shown(words.rest());
            warnings.push(format!(
                "{file}:{line}: `{} {rest}` is not valid and is ignored",
                shown(keyword)
            ));
        }
    }
    if let Some(last) = current {
        put(last);
    }
}

impl Definition {
    /// Whether the statement is valid, or is one that luxel doesn't render.
    fn statement(&mut self, keyword: &[u8], words: Words<'_>) -> bool {
        fn set<T>(place: &mut Option<T>, value: Option<T>) -> bool {
            let is_some = value.is_some();
            *place = value.or(place.take());
            is_some
        }
        let lower = keyword.to_ascii_lowercase();
        match lower.as_slice() {
            b"ka" => set(&mut self.ambient, color(words)),
            b"kd" => set(&mut self.diffuse, color(words)),
            b"ks" => set(&mut self.specular, color(words)),
            b"ke" => set(&mut self.emission, color(words)),
            b"ns" => set(&mut self.shininess, value(words)),
            b"d" => set(&mut self.opacity, value(words)),
            b"tr" => set(&mut self.transparency, value(words)),
            b"illum" => set(&mut self.illumination, words.clone().next().and_then(integer)),
            b"map_ka" => set(&mut self.ambient_map, map(words)),
            b"map_kd" => set(&mut self.diffuse_map, map(words)),
            b"map_ks" => set(&mut self.specular_map, map(words)),
            b"map_ke" => set(&mut self.emission_map, map(words)),
            b"map_d" => set(&mut self.opacity_map, map(words)),
            b"map_bump" | b"bump" => set(&mut self.bump_map, map(words)),
            b"norm" | b"map_kn" => set(&mut self.normal_map, map(words)),
            // Transmission, refraction, reflection maps, and extensions of other programs.
            _ => true,
        }
    }
}

/// One number for all three, or three; CIE colours and spectra aren't read.
fn color(mut words: Words<'_>) -> Option<[f32; 3]> {
    let red = intensity(words.next()?)?;
    let Some(green) = words.next() else { return Some([red; 3]) };
    Some([red, intensity(green)?, intensity(words.next()?)?])
}

fn intensity(word: &[u8]) -> Option<f32> {
    single(word).filter(|value| value.is_finite()).map(|value| value.max(0.0))
}

/// The first number; options such as `-halo` may precede it.
fn value(words: Words<'_>) -> Option<f32> {
    words.into_iter().find(|word| word.first() != Some(&b'-')).and_then(intensity)
}

/// Options, then a file name that may have spaces.
fn map(mut words: Words<'_>) -> Option<Box<Map>> {
    let mut map =
        Map { name: String::new(), scale: [1.0; 2], offset: [0.0; 2], clamp: false, strength: 1.0 };
    loop {
        let mut ahead = words.clone();
        let option = ahead.next()?.to_ascii_lowercase();
        match option.as_slice() {
            b"-s" => read_pair(&mut ahead, &mut map.scale),
            b"-o" => read_pair(&mut ahead, &mut map.offset),
            b"-t" => read_pair(&mut ahead, &mut [0.0; 2]),
            b"-clamp" => map.clamp = ahead.next()? == b"on",
            b"-bm" => map.strength = intensity(ahead.next()?)?,
            b"-mm" => {
                ahead.next();
                ahead.next();
            }
            b"-blendu" | b"-blendv" | b"-boost" | b"-cc" | b"-imfchan" | b"-texres" | b"-type" => {
                ahead.next();
            }
            _ => break,
        }
        words = ahead;
    }
    map.name = String::from_utf8_lossy(words.rest()).into_owned();
    Some(Box::new(map))
}

/// One to three numbers, of which two count; missing ones keep their defaults.
fn read_pair(words: &mut Words<'_>, pair: &mut [f32; 2]) {
    for index in 0..3 {
        let mut ahead = words.clone();
        let value = ahead.next().and_then(single).filter(|value| value.is_finite());
        let Some(value) = value else { return };
        if let Some(place) = pair.get_mut(index) {
            *place = value;
        }
        *words = ahead;
    }
}
