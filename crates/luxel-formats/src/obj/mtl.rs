//! MTL: the materials of OBJ files (Wavefront, "MTL material format", 1995).

use super::lines::Lines;
use crate::text::{Words, integer, shown, single};
use crate::warnings::Warnings;

/// A material as written; missing statements are `None`.
#[derive(Debug, Default)]
pub(super) struct Definition {
    pub(super) ambient: Option<[f32; 3]>,
    pub(super) diffuse: Option<[f32; 3]>,
    pub(super) specular: Option<[f32; 3]>,
    pub(super) emission: Option<[f32; 3]>,
    pub(super) shininess: Option<f32>,
    /// `d`
    pub(super) opacity: Option<f32>,
    /// `Tr`
    pub(super) transparency: Option<f32>,
    /// From -1 to 2; numbers beyond are like these.
    pub(super) illumination: Option<i8>,
    /// `None` without any.
    pub(super) maps: Option<Box<Maps>>,
}

/// The textures of a material.
#[derive(Debug, Default)]
pub(super) struct Maps {
    pub(super) ambient: Option<Map>,
    pub(super) diffuse: Option<Map>,
    pub(super) specular: Option<Map>,
    pub(super) emission: Option<Map>,
    pub(super) opacity: Option<Map>,
    /// `map_Bump` or `bump`: heights, though many files put normal maps here.
    pub(super) bump: Option<Map>,
    /// `norm`
    pub(super) normal: Option<Map>,
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

/// Reads a library: `put` gets its materials with their names, in order. Invalid statements are ignored,
/// with a warning.
pub(super) fn read(
    bytes: &[u8],
    file: &str,
    warnings: &mut Warnings,
    put: &mut dyn FnMut(&[u8], Definition),
) {
    let mut current: Option<(Vec<u8>, Definition)> = None;
    let mut lines = Lines::new(bytes);
    while let Some(line) = lines.next() {
        let mut words = Words::new(&line);
        let Some(keyword) = words.next() else { continue };
        if keyword == b"newmtl" {
            let name = words.rest().to_vec();
            if let Some((name, before)) = current.replace((name, Definition::default())) {
                put(&name, before);
            }
        } else if let Some((_, definition)) = &mut current
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
    if let Some((name, last)) = current {
        put(&name, last);
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
            b"illum" => {
                let number = words.clone().next().and_then(integer);
                set(&mut self.illumination, number.map(|number| number.clamp(-1, 2) as i8))
            }
            b"map_ka" => set(&mut self.maps().ambient, map(words)),
            b"map_kd" => set(&mut self.maps().diffuse, map(words)),
            b"map_ks" => set(&mut self.maps().specular, map(words)),
            b"map_ke" => set(&mut self.maps().emission, map(words)),
            b"map_d" => set(&mut self.maps().opacity, map(words)),
            b"map_bump" | b"bump" => set(&mut self.maps().bump, map(words)),
            b"norm" | b"map_kn" => set(&mut self.maps().normal, map(words)),
            // Transmission, refraction, reflection maps, and extensions of other programs.
            _ => true,
        }
    }

    fn maps(&mut self) -> &mut Maps {
        self.maps.get_or_insert_default()
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
fn map(mut words: Words<'_>) -> Option<Map> {
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
    Some(map)
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
