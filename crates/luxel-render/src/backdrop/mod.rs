//! What samples show that see no surface, where that differs from place to place.

mod ground;

pub(crate) use ground::Ground;

use crate::shadow::OcclusionLanes;
use luxel_lighting::Silent;
use luxel_math::prelude::*;
use luxel_math::{LANES, lanes_of};
use luxel_view::Background;

/// What lies behind all surfaces of a frame.
pub(crate) struct Backdrop<'a> {
    background: Background,
    /// The picture's height, in pixels.
    height: f64,
    /// What lies over the background.
    pub(crate) ground: Option<Ground<'a>>,
}

impl<'a> Backdrop<'a> {
    /// The backdrop of a picture this high; `None` if it is one colour.
    pub(crate) fn new(
        background: Background,
        height: u32,
        ground: Option<Ground<'a>>,
    ) -> Option<Self> {
        let is_flat = matches!(background, Background::Flat(_)) && ground.is_none();
        (!is_flat).then_some(Self { background, height: height.into(), ground })
    }

    /// The colour (straight) and alpha behind the ground at a position of the window, in pixels.
    pub(crate) fn behind_ground(&self, [_, y]: [f64; 2]) -> [f32; 4] {
        let color = self.background.color((y / self.height) as f32);
        if color[3] > 0.0 { color } else { [0.0; 4] }
    }

    /// Puts the colour and alpha of those of sixteen samples whose bit is set.
    ///
    /// Outlined: one copy per lane type.
    #[cold]
    #[inline(never)]
    pub(crate) fn put<N: Lanes>(
        &self,
        simd: N,
        lanes: u32,
        position: &dyn Fn(usize) -> [f64; 2],
        found: &mut OcclusionLanes,
        colors: &mut [[f32; LANES]; 4],
    ) {
        let mut darkness = [0.0; LANES];
        if let Some(ground) = &self.ground {
            simd.vectorized(
                #[inline(always)]
                || {
                    let seen = ground.seen(simd.zero(), lanes, position, found, &mut Silent);
                    seen.darkness.masked(simd.mask_of(seen.lanes)).store(&mut darkness, 0);
                },
            );
        }
        for lane in lanes_of(lanes) {
            let mut color = self.behind_ground(position(lane));
            if let Some(ground) = &self.ground
                && darkness[lane] > 0.0
            {
                color = ground.over(darkness[lane], color);
            }
            for (channel, value) in colors.iter_mut().zip(color) {
                channel[lane] = value;
            }
        }
    }
}
