//! What samples show that see no surface, where that differs from place to place.

mod ground;

pub(crate) use ground::Ground;

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

    /// The colour (straight) and alpha at a position of the window, in pixels.
    pub(crate) fn color(&self, position: [f64; 2]) -> [f32; 4] {
        let behind = self.behind_ground(position);
        let ground = self.ground.as_ref().and_then(|ground| ground.sample(position));
        ground.map_or(behind, |ground| ground.over(behind))
    }

    /// The same without the ground.
    pub(crate) fn behind_ground(&self, [_, y]: [f64; 2]) -> [f32; 4] {
        let color = self.background.color((y / self.height) as f32);
        if color[3] > 0.0 { color } else { [0.0; 4] }
    }

    /// Puts the colour and alpha of those samples of a batch whose bit is set.
    #[cold]
    #[inline(never)]
    pub(crate) fn put(
        &self,
        lanes: u32,
        position: &dyn Fn(usize) -> [f64; 2],
        colors: &mut [[f32; LANES]; 4],
    ) {
        for lane in lanes_of(lanes) {
            let color = self.color(position(lane));
            for (channel, value) in colors.iter_mut().zip(color) {
                channel[lane] = value;
            }
        }
    }
}
