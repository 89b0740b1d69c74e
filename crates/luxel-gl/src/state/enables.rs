//! What `glEnable` switches, in one table.

use crate::enums as gl;
use crate::limits::{CLIP_PLANES, LIGHTS, TEXTURE_UNITS};
use crate::texture::Target;

/// Names capabilities, a bit each in that order, with the bits of `glPushAttrib` that save them beside `GL_ENABLE_BIT`.
macro_rules! capabilities {
    ($($name:ident $group:ident,)*) => {
        const TABLE: &[(u32, u32)] = &[$((gl::$name, gl::$group)),*];

        /// The bit of a capability; a constant for a name that is one.
        #[inline(always)]
        const fn bit_in_table(name: u32) -> Option<u32> {
            let bit = 0;
            $(
                if name == gl::$name {
                    return Some(bit);
                }
                let bit = bit + 1;
            )*
            let _ = bit;
            None
        }
    };
}

capabilities! {
    LIGHTING LIGHTING_BIT,
    COLOR_MATERIAL LIGHTING_BIT,
    DEPTH_TEST DEPTH_BUFFER_BIT,
    CULL_FACE POLYGON_BIT,
    NORMALIZE TRANSFORM_BIT,
    RESCALE_NORMAL TRANSFORM_BIT,
    SCISSOR_TEST SCISSOR_BIT,
    STENCIL_TEST STENCIL_BUFFER_BIT,
    ALPHA_TEST COLOR_BUFFER_BIT,
    BLEND COLOR_BUFFER_BIT,
    COLOR_LOGIC_OP COLOR_BUFFER_BIT,
    INDEX_LOGIC_OP COLOR_BUFFER_BIT,
    DITHER COLOR_BUFFER_BIT,
    FOG FOG_BIT,
    COLOR_SUM FOG_BIT,
    LINE_SMOOTH LINE_BIT,
    LINE_STIPPLE LINE_BIT,
    POINT_SMOOTH POINT_BIT,
    POLYGON_SMOOTH POLYGON_BIT,
    POLYGON_STIPPLE POLYGON_BIT,
    POLYGON_OFFSET_POINT POLYGON_BIT,
    POLYGON_OFFSET_LINE POLYGON_BIT,
    POLYGON_OFFSET_FILL POLYGON_BIT,
    MULTISAMPLE MULTISAMPLE_BIT,
    SAMPLE_ALPHA_TO_COVERAGE MULTISAMPLE_BIT,
    SAMPLE_ALPHA_TO_ONE MULTISAMPLE_BIT,
    SAMPLE_COVERAGE MULTISAMPLE_BIT,
    AUTO_NORMAL EVAL_BIT,
}

/// Bit of the first light, of the first plane and of the first evaluator.
const FIRST_LIGHT: u32 = TABLE.len() as u32;
const FIRST_PLANE: u32 = FIRST_LIGHT + LIGHTS as u32;
const FIRST_MAP1: u32 = FIRST_PLANE + CLIP_PLANES as u32;
const FIRST_MAP2: u32 = FIRST_MAP1 + MAPS;
const MAPS: u32 = 9;
const _: () = assert!(FIRST_MAP2 + MAPS <= u64::BITS, "all are bits of one word");

/// What is enabled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Enables {
    bits: u64,
    /// Of each texture unit: targets and coordinates that are generated.
    pub(crate) textures: [u8; TEXTURE_UNITS],
}

/// A capability: which bit of what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Capability {
    /// Of the context.
    Global(u32),
    /// Of the active texture unit.
    Texture(u8),
}

impl Capability {
    /// The capability with a name; `None` if there is none.
    pub(crate) fn named(name: u32) -> Option<Self> {
        let run = |first: u32, count: usize, bit: u32| {
            let number = name.wrapping_sub(first);
            (number < count as u32).then_some(Self::Global(bit + number))
        };
        bit_in_table(name)
            .map(Self::Global)
            .or_else(|| run(gl::LIGHT0, LIGHTS, FIRST_LIGHT))
            .or_else(|| run(gl::CLIP_PLANE0, CLIP_PLANES, FIRST_PLANE))
            .or_else(|| run(gl::MAP1_COLOR_4, MAPS as usize, FIRST_MAP1))
            .or_else(|| run(gl::MAP2_COLOR_4, MAPS as usize, FIRST_MAP2))
            .or(match name {
                gl::TEXTURE_1D => Some(Self::Texture(0)),
                gl::TEXTURE_2D => Some(Self::Texture(1)),
                gl::TEXTURE_3D => Some(Self::Texture(2)),
                gl::TEXTURE_CUBE_MAP => Some(Self::Texture(3)),
                gl::TEXTURE_GEN_S => Some(Self::Texture(4)),
                gl::TEXTURE_GEN_T => Some(Self::Texture(5)),
                gl::TEXTURE_GEN_R => Some(Self::Texture(6)),
                gl::TEXTURE_GEN_Q => Some(Self::Texture(7)),
                _ => None,
            })
    }
}

impl Default for Enables {
    fn default() -> Self {
        let mut enables = Self { bits: 0, textures: [0; TEXTURE_UNITS] };
        enables.set(gl::DITHER, true, 0);
        enables.set(gl::MULTISAMPLE, true, 0);
        enables
    }
}

impl Enables {
    /// Whether a capability is enabled; `None` if there is none of that name.
    pub(crate) fn get(&self, name: u32, unit: usize) -> Option<bool> {
        Some(match Capability::named(name)? {
            Capability::Global(bit) => self.bits >> bit & 1 == 1,
            Capability::Texture(bit) => self.textures[unit] >> bit & 1 == 1,
        })
    }

    /// Whether one of the capabilities that have one name each is enabled.
    #[inline(always)]
    pub(crate) fn has(&self, name: u32) -> bool {
        bit_in_table(name).is_some_and(|bit| self.bits >> bit & 1 == 1)
    }

    /// Whether secondary colours are added to the primary ones (section 3.9).
    pub(crate) fn sums_colors(&self) -> bool {
        self.has(gl::COLOR_SUM) || self.has(gl::LIGHTING)
    }

    /// Whether light `number` is enabled.
    pub(crate) fn light(&self, number: usize) -> bool {
        self.bits >> (FIRST_LIGHT + number as u32) & 1 == 1
    }

    /// The planes that are enabled, a bit each.
    pub(crate) fn planes(&self) -> u32 {
        (self.bits >> FIRST_PLANE) as u32 & ((1 << CLIP_PLANES) - 1)
    }

    /// Whether a unit generates coordinate `axis`: 0 for s to 3 for q.
    pub(crate) fn generates(&self, unit: usize, axis: usize) -> bool {
        self.textures[unit] >> (4 + axis) & 1 == 1
    }

    /// Which of a unit's targets is the one that counts: the one of most dimensions, cubes before all
    /// (section 3.8.15).
    pub(crate) fn texture_target(&self, unit: usize) -> Option<Target> {
        Target::ALL.into_iter().rev().find(|target| self.textures[unit] >> *target as u8 & 1 == 1)
    }

    /// Switches a capability; whether there is one of that name.
    pub(crate) fn set(&mut self, name: u32, on: bool, unit: usize) -> bool {
        match Capability::named(name) {
            Some(Capability::Global(bit)) => {
                self.bits = self.bits & !(1 << bit) | u64::from(on) << bit;
            }
            Some(Capability::Texture(bit)) => {
                let bits = &mut self.textures[unit];
                *bits = *bits & !(1 << bit) | u8::from(on) << bit;
            }
            None => return false,
        }
        true
    }

    /// Takes over from `saved` what `glPopAttrib` restores for a mask.
    pub(crate) fn restore(&mut self, saved: &Self, mask: u32) {
        let mut restored = 0_u64;
        let every = mask & gl::ENABLE_BIT != 0;
        for (bit, (_, group)) in TABLE.iter().enumerate() {
            if every || mask & group != 0 {
                restored |= 1 << bit;
            }
        }
        let mut run = |first: u32, count: u32, group: u32| {
            if every || mask & group != 0 {
                restored |= ((1 << count) - 1) << first;
            }
        };
        run(FIRST_LIGHT, LIGHTS as u32, gl::LIGHTING_BIT);
        run(FIRST_PLANE, CLIP_PLANES as u32, gl::TRANSFORM_BIT);
        run(FIRST_MAP1, 2 * MAPS, gl::EVAL_BIT);
        self.bits = self.bits & !restored | saved.bits & restored;
        if every || mask & gl::TEXTURE_BIT != 0 {
            self.textures = saved.textures;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_6_2_dithering_and_multisampling_alone_are_enabled_at_first() {
        let enables = Enables::default();
        for (name, _) in TABLE {
            assert_eq!(enables.has(*name), [gl::DITHER, gl::MULTISAMPLE].contains(name));
        }
        assert_eq!(enables.get(gl::TEXTURE_2D, 3), Some(false));
        assert_eq!(enables.get(gl::RGBA, 0), None);
    }

    #[test]
    fn section_6_1_13_a_group_restores_its_own_capabilities_and_no_others() {
        let saved = Enables::default();
        let mut enables = saved;
        for name in [gl::LIGHT0 + 3, gl::LIGHTING, gl::BLEND, gl::CLIP_PLANE0 + 1] {
            assert!(enables.set(name, true, 0));
        }
        enables.restore(&saved, gl::LIGHTING_BIT);
        assert!(!enables.light(3) && !enables.has(gl::LIGHTING));
        assert!(enables.has(gl::BLEND) && enables.planes() == 2);
        enables.restore(&saved, gl::ENABLE_BIT);
        assert!(!enables.has(gl::BLEND) && enables.planes() == 0);
    }
}
