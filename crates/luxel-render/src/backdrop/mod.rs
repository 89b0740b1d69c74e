//! What samples show that see no surface, where that differs from place to place.

mod ground;

pub(crate) use ground::Ground;

use crate::shadow::OcclusionLanes;
use luxel_lighting::{Display, Environment, Silent};
use luxel_math::prelude::*;
use luxel_math::{LANES, Vec3, lanes_of};
use luxel_view::Background;
use luxel_visibility::ViewRays;

/// The environment behind all surfaces, seen along the ray of each sample: of parallel rays, one direction.
pub(crate) struct Around {
    pub(crate) environment: Environment,
    pub(crate) rays: ViewRays,
    /// It is light, and shown as that of surfaces is.
    pub(crate) display: Display,
}

impl Around {
    /// The colour and alpha at a position of the window, in pixels.
    fn color(&self, position: [f64; 2]) -> [f32; 4] {
        let place = position.map(|at| at as f32);
        let (_, to_eye) = self.rays.unit_vectors(place, Vec3::splat(0.0, [0.0; 3]));
        let light = self.environment.radiance(-to_eye, 0.0);
        let [r, g, b] = self.display.shown(light).lane(0);
        [r, g, b, 1.0]
    }
}

/// What lies behind all surfaces of a frame.
pub(crate) struct Backdrop<'a> {
    background: Background,
    /// The environment instead, if it is to be seen and isn't dark.
    around: Option<Around>,
    /// The picture's height, in pixels.
    height: f64,
    /// What lies over the background.
    pub(crate) ground: Option<Ground<'a>>,
}

impl<'a> Backdrop<'a> {
    /// The backdrop of a picture this high; `None` if it is one colour.
    pub(crate) fn new(
        (background, around): (Background, Option<Around>),
        height: u32,
        ground: Option<Ground<'a>>,
    ) -> Option<Self> {
        let around = around.filter(|around| !around.environment.is_none());
        let is_flat =
            matches!(background, Background::Flat(_)) && around.is_none() && ground.is_none();
        (!is_flat).then_some(Self { background, around, height: height.into(), ground })
    }

    /// The colour (straight) and alpha behind the ground at a position of the window, in pixels.
    pub(crate) fn behind_ground(&self, position @ [_, y]: [f64; 2]) -> [f32; 4] {
        if let Some(around) = &self.around {
            return around.color(position);
        }
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
