//! Definitions of materials, packed: libraries may have millions, most of them with few statements.

use super::mtl::{Definition, Maps};
use std::collections::HashMap;

/// Definitions by the numbers of their materials.
pub(super) struct Definitions {
    /// Where the record of each material begins in `words`; 0 for those without one.
    starts: Vec<usize>,
    /// An unused word; then records of a word that says which fields follow, and the bits of their numbers.
    words: Vec<u32>,
    maps: HashMap<usize, Box<Maps>>,
}

/// Of the first word of a record, where `illum` stands: 0 for none, else its value and 2. Below are a bit for each
/// colour and each number.
const ILLUMINATION: u32 = 8;

impl Definitions {
    /// None, for so many materials.
    pub(super) fn new(count: usize) -> Self {
        Self { starts: vec![0; count], words: vec![0], maps: HashMap::new() }
    }

    /// Adds the definition of a material that has none yet.
    pub(super) fn put(&mut self, material: usize, definition: Definition) {
        let start = &mut self.starts[material];
        if *start != 0 {
            return;
        }
        let first = self.words.len();
        *start = first;
        let Definition {
            ambient,
            diffuse,
            specular,
            emission,
            shininess,
            opacity,
            transparency,
            illumination,
            maps,
        } = definition;
        self.words
            .push(illumination.map_or(0, |value| u32::from((value + 2) as u8)) << ILLUMINATION);
        for (bit, color) in (0..).zip([ambient, diffuse, specular, emission]) {
            if let Some(color) = color {
                self.words[first] |= 1 << bit;
                self.words.extend(color.map(f32::to_bits));
            }
        }
        for (bit, number) in (4..).zip([shininess, opacity, transparency]) {
            if let Some(number) = number {
                self.words[first] |= 1 << bit;
                self.words.push(number.to_bits());
            }
        }
        if let Some(maps) = maps {
            self.maps.insert(material, maps);
        }
    }

    /// Takes the definition of a material, which has none then.
    pub(super) fn take(&mut self, material: usize) -> Option<Definition> {
        let start =
            self.starts.get_mut(material).map(std::mem::take).filter(|&start| start != 0)?;
        let (&has, numbers) = self.words[start..].split_first()?;
        let mut numbers = numbers.iter().map(|&bits| f32::from_bits(bits));
        let mut next = |bit: u32| if has & 1 << bit == 0 { None } else { numbers.next() };
        let mut color = |bit| {
            let red = next(bit)?;
            Some([red, next(bit)?, next(bit)?])
        };
        let [ambient, diffuse, specular, emission] = [color(0), color(1), color(2), color(3)];
        let [shininess, opacity, transparency] = [next(4), next(5), next(6)];
        let illumination = (has >> ILLUMINATION) as i8;
        let illumination = (illumination != 0).then(|| illumination - 2);
        let maps = self.maps.remove(&material);
        Some(Definition {
            ambient,
            diffuse,
            specular,
            emission,
            shininess,
            opacity,
            transparency,
            illumination,
            maps,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn definition() -> impl Strategy<Value = Definition> {
        let color = || proptest::option::of(proptest::array::uniform3(any::<f32>()));
        let number = || proptest::option::of(any::<f32>());
        let colors = (color(), color(), color(), color());
        let numbers = (number(), number(), number(), proptest::option::of(-1..=2_i8));
        (colors, numbers, any::<bool>()).prop_map(|(colors, numbers, has_maps)| Definition {
            ambient: colors.0,
            diffuse: colors.1,
            specular: colors.2,
            emission: colors.3,
            shininess: numbers.0,
            opacity: numbers.1,
            transparency: numbers.2,
            illumination: numbers.3,
            maps: has_maps.then(Default::default),
        })
    }

    proptest! {
        #[test]
        fn definitions_come_back_as_they_were_put(all in proptest::collection::vec(proptest::option::of(definition()), 0..20)) {
            let expected: Vec<String> = all.iter().map(|one| format!("{one:?}")).collect();
            let count = all.len();
            let mut packed = Definitions::new(count);
            for (material, one) in all.into_iter().enumerate() {
                if let Some(one) = one {
                    packed.put(material, one);
                    // The first one counts.
                    packed.put(material, Definition { opacity: Some(0.25), ..Definition::default() });
                }
            }
            let back: Vec<String> = (0..count).map(|material| format!("{:?}", packed.take(material))).collect();
            prop_assert_eq!(back, expected);
            prop_assert!((0..=count).all(|material| packed.take(material).is_none()));
        }
    }
}
