//! The texture units that fragments of one draw go through.

use super::combine::combined;
use super::footprint::Footprint;
use super::sample::sample;
use crate::limits::TEXTURE_UNITS;
use crate::state::Attributes;
use crate::state::texture_unit::Environment;
use crate::texture::SampledTexture;
use luxel_math::{Lanes, Simd, f32x16};
use std::sync::Arc;

/// One enabled unit.
#[derive(Clone, Debug)]
pub(crate) struct Stage {
    pub(crate) unit: usize,
    pub(crate) texture: Arc<SampledTexture>,
    pub(crate) environment: Environment,
    /// The unit's and the texture's together.
    pub(crate) lod_bias: f32,
}

/// All enabled units, in order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TextureStages {
    pub(crate) stages: Vec<Stage>,
    /// Whether a secondary colour is added after texturing.
    pub(crate) secondary: bool,
}

impl PartialEq for Stage {
    /// Textures are compared by identity: changing one makes another.
    fn eq(&self, other: &Self) -> bool {
        self.unit == other.unit
            && Arc::ptr_eq(&self.texture, &other.texture)
            && self.environment == other.environment
            && self.lod_bias == other.lod_bias
    }
}

impl TextureStages {
    /// The stages of what is enabled; `None` if nothing is. `texture(unit)` is the unit's texture if it is enabled and
    /// complete.
    pub(crate) fn new(
        state: &Attributes,
        texture: impl Fn(usize) -> Option<Arc<SampledTexture>>,
        secondary: bool,
    ) -> Option<Self> {
        let stage = |unit: usize| {
            let texture = texture(unit)?;
            let of = &state.texture.units[unit];
            let lod_bias = of.lod_bias + texture.lod_bias;
            Some(Stage { unit, texture, environment: of.environment, lod_bias })
        };
        let stages: Vec<Stage> = (0..TEXTURE_UNITS).filter_map(stage).collect();
        (!stages.is_empty()).then_some(Self { stages, secondary })
    }

    /// The enabled units, a bit each.
    pub(crate) fn units(&self) -> u32 {
        self.stages.iter().fold(0, |units, stage| units | 1 << stage.unit)
    }

    /// Rows of eight numbers, twice, that a primitive has for textures: secondary colours, then coordinates of each
    /// stage.
    pub(crate) fn rows(&self) -> usize {
        1 + self.stages.len()
    }

    /// The colours after all environments, for the lanes whose bit is set. `footprint(stage)` is where a stage's texture
    /// is sampled; the closure is to be marked `#[inline(always)]`.
    #[inline(always)]
    pub(crate) fn apply<S: Simd>(
        &self,
        primary: [f32x16<S>; 4],
        footprint: impl Fn(usize) -> Footprint<f32x16<S>>,
        lanes: u32,
    ) -> [f32x16<S>; 4] {
        if let [stage] = &self.stages[..] {
            let texel = sample(&stage.texture, stage.lod_bias, &footprint(0), lanes);
            return combined(stage, texel, |_| texel, primary, primary);
        }
        let mut texels = [[primary[0].zero(); 4]; TEXTURE_UNITS];
        for (number, stage) in self.stages.iter().enumerate() {
            texels[stage.unit] = sample(&stage.texture, stage.lod_bias, &footprint(number), lanes);
        }
        let mut color = primary;
        for stage in &self.stages {
            let own = texels[stage.unit];
            color = combined(
                stage,
                own,
                #[inline(always)]
                |unit| texels[unit],
                primary,
                color,
            );
        }
        color
    }
}
