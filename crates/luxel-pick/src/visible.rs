//! What is seen in a region: objects with the pixels they own, from a frame that has been drawn, or
//! asked pixel by pixel.

use crate::region::Region;
use crate::told::Element;
use crate::view::PickView;
use luxel_scene::Size;
use rayon::prelude::*;

/// An object and how many pixels show it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VisibleHit {
    /// The object, by its place in [`Picker::objects`](crate::Picker::objects).
    pub object: usize,
    /// Pixels whose centre it owns.
    pub pixels: u64,
}

/// What each pixel of a drawn frame shows: a pick is one look into memory.
#[derive(Clone, Debug, PartialEq)]
pub struct VisibleIds {
    size: Size,
    objects: Vec<u32>,
    triangles: Vec<u32>,
}

/// What stands for nothing among ids.
pub const NOTHING: u32 = u32::MAX;

impl VisibleIds {
    /// Takes the objects and triangles of a frame's pixels, row by row from the top, as the layers
    /// `object` and `triangle` hold them (4294967295 where nothing is); `None` if they don't fill
    /// the size. Any renderer's will do.
    #[must_use]
    pub fn new(size: Size, objects: Vec<u32>, triangles: Vec<u32>) -> Option<Self> {
        let pixels = size.width as usize * size.height as usize;
        (objects.len() == pixels && triangles.len() == pixels).then_some(Self {
            size,
            objects,
            triangles,
        })
    }

    /// Object and triangle of a pixel; the triangle is `None` for points and lines. `None` outside
    /// of the window and where nothing is.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> Option<(usize, Option<u32>)> {
        if x >= self.size.width || y >= self.size.height {
            return None;
        }
        let at = y as usize * self.size.width as usize + x as usize;
        let object = self.objects[at];
        let triangle = self.triangles[at];
        (object != NOTHING).then(|| (object as usize, (triangle != NOTHING).then_some(triangle)))
    }

    /// The objects seen in a region, in their order.
    #[must_use]
    pub fn in_region(&self, region: &Region) -> Vec<VisibleHit> {
        counted(self.size, region, |x, y| self.at(x, y).map(|(object, _)| object))
    }
}

impl PickView<'_> {
    /// The objects that own pixels of a region, by the fill rule of frames, in their order.
    #[must_use]
    pub fn visible_in(&self, region: &Region) -> Vec<VisibleHit> {
        counted(self.size, region, |x, y| {
            self.owner_at(f64::from(x) + 0.5, f64::from(y) + 0.5).map(|(object, _)| object)
        })
    }

    /// What every pixel shows, to be asked again and again.
    #[must_use]
    pub fn visible_ids(&self) -> VisibleIds {
        let Size { width, height } = self.size;
        let pixels: Vec<(u32, u32)> = (0..u64::from(width) * u64::from(height))
            .into_par_iter()
            .map(|at| {
                let [x, y] = [at % u64::from(width), at / u64::from(width)];
                match self.owner_at(x as f64 + 0.5, y as f64 + 0.5) {
                    Some((object, Element::Triangle(triangle))) => (object as u32, triangle),
                    Some((object, _)) => (object as u32, NOTHING),
                    None => (NOTHING, NOTHING),
                }
            })
            .collect();
        let (objects, triangles) = pixels.into_iter().unzip();
        VisibleIds { size: self.size, objects, triangles }
    }
}

/// Counts the pixels of a region whose centres show something.
fn counted(
    size: Size,
    region: &Region,
    object: impl Fn(u32, u32) -> Option<usize> + Sync,
) -> Vec<VisibleHit> {
    let [left, top, right, bottom] = region.bounds();
    let pixels = |from: f64, to: f64, side: u32| {
        let side = f64::from(side);
        (from.floor().clamp(0.0, side) as u32)..(to.ceil().clamp(0.0, side) as u32)
    };
    let columns = pixels(left, right, size.width);
    let rows = pixels(top, bottom, size.height);
    let of_row = |y: u32| {
        let mut seen = std::collections::BTreeMap::new();
        for x in columns.clone() {
            if region.contains(f64::from(x) + 0.5, f64::from(y) + 0.5)
                && let Some(object) = object(x, y)
            {
                *seen.entry(object).or_insert(0_u64) += 1;
            }
        }
        seen
    };
    let seen = rows.into_par_iter().map(of_row).reduce(std::collections::BTreeMap::new, |a, b| {
        let mut sum = a;
        for (object, pixels) in b {
            *sum.entry(object).or_insert(0) += pixels;
        }
        sum
    });
    seen.into_iter().map(|(object, pixels)| VisibleHit { object, pixels }).collect()
}
