//! Visible objects of a region with their pixel counts, from an id buffer or by rasterizing the region.

use crate::region::Region;
use crate::region_raster::{PixelOwner, Pixels};
use crate::surface_hit::Element;
use crate::view::PickView;
use crate::window::PhysicalPosition;
use luxel_parallel::map;
use luxel_scene::Size;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// An object with its visible pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VisibleHit {
    /// The object, by its index in [`Picker::objects`](crate::Picker::objects).
    pub object: usize,
    /// The number of pixels that show it at their centre.
    pub pixels: u64,
}

/// An id buffer: object and triangle of each pixel. A pick is one lookup.
#[derive(Clone, Debug, PartialEq)]
pub struct VisibleIds {
    size: Size,
    objects: Vec<u32>,
    triangles: Vec<u32>,
}

/// The id of the background, and of triangles of points and lines.
pub const NO_ID: u32 = u32::MAX;

impl VisibleIds {
    /// Takes the objects and triangles of pixels, row by row from the top, as in the layers `object` and
    /// `triangle` ([`NO_ID`] on the background); `None` if their lengths don't match the size. Ids may
    /// come from any renderer.
    #[must_use]
    pub fn new(size: Size, objects: Vec<u32>, triangles: Vec<u32>) -> Option<Self> {
        let pixels = size.width as usize * size.height as usize;
        (objects.len() == pixels && triangles.len() == pixels).then_some(Self {
            size,
            objects,
            triangles,
        })
    }

    /// Object and triangle of a pixel; the triangle is `None` for points and lines. `None` outside the
    /// window and on the background.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> Option<(usize, Option<u32>)> {
        if x >= self.size.width || y >= self.size.height {
            return None;
        }
        let at = y as usize * self.size.width as usize + x as usize;
        let object = self.objects[at];
        let triangle = self.triangles[at];
        (object != NO_ID).then(|| (object as usize, (triangle != NO_ID).then_some(triangle)))
    }

    /// The visible objects of a region, in order.
    #[must_use]
    pub fn in_region(&self, region: &Region) -> Vec<VisibleHit> {
        count_pixels(self.size, region, |x, y| self.at(x, y).map(|(object, _)| object))
    }
}

impl PickView<'_> {
    /// The objects visible at pixel centres of a region, by the fill rule of frames, in order.
    #[must_use]
    pub fn visible_in(&self, region: &Region) -> Vec<VisibleHit> {
        let pixels = pixels_of(self.size(), region);
        let all = Mutex::new(Counts::new());
        let of_tile = |owners: &mut dyn Iterator<Item = PixelOwner>| {
            let mut counts = Counts::new();
            for PixelOwner { pixel: [x, y], instance, triangle } in owners {
                let PhysicalPosition { x, y } = PhysicalPosition::centre_of(x, y);
                if region.contains(x, y) {
                    let (object, _) = self.element_of(instance, triangle);
                    *counts.entry(object).or_default() += 1;
                }
            }
            add_counts(&mut all.lock().unwrap_or_else(PoisonError::into_inner), counts);
        };
        match self.visit_visible(&pixels, &of_tile) {
            Ok(()) => hits(all.into_inner().unwrap_or_else(PoisonError::into_inner)),
            // Too many triangles for a frame: queries pixel by pixel.
            Err(_) => count_pixels(self.size(), region, |x, y| {
                self.owner_at(PhysicalPosition::centre_of(x, y)).map(|(object, _)| object)
            }),
        }
    }

    /// The id buffer of the whole view.
    #[must_use]
    pub fn visible_ids(&self) -> VisibleIds {
        let Size { width, height } = self.size();
        let count = width as usize * height as usize;
        let all = Mutex::new((vec![NO_ID; count], vec![NO_ID; count]));
        let set = |owners: &[([u32; 2], usize, Element)]| {
            let (objects, triangles) = &mut *all.lock().unwrap_or_else(PoisonError::into_inner);
            for &([x, y], object, element) in owners {
                let at = y as usize * width as usize + x as usize;
                objects[at] = object as u32;
                if let Element::Triangle(triangle) = element {
                    triangles[at] = triangle;
                }
            }
        };
        let of_tile = |owners: &mut dyn Iterator<Item = PixelOwner>| {
            let element = |owner: PixelOwner| {
                let (object, element) = self.element_of(owner.instance, owner.triangle);
                (owner.pixel, object, element)
            };
            set(&owners.map(element).collect::<Vec<_>>());
        };
        if self.visit_visible(&[0..width, 0..height], &of_tile).is_err() {
            for pixel @ [x, y] in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
                if let Some((object, element)) = self.owner_at(PhysicalPosition::centre_of(x, y)) {
                    set(&[(pixel, object, element)]);
                }
            }
        }
        let (objects, triangles) = all.into_inner().unwrap_or_else(PoisonError::into_inner);
        VisibleIds { size: self.size(), objects, triangles }
    }
}

/// Rows per task.
const ROWS_PER_TASK: usize = 4;

/// Pixel counts by object.
type Counts = BTreeMap<usize, u64>;

fn add_counts(all: &mut Counts, more: Counts) {
    for (object, pixels) in more {
        *all.entry(object).or_default() += pixels;
    }
}

fn hits(counts: Counts) -> Vec<VisibleHit> {
    counts.into_iter().map(|(object, pixels)| VisibleHit { object, pixels }).collect()
}

/// The pixels whose centres may lie in a region.
fn pixels_of(size: Size, region: &Region) -> Pixels {
    let [left, top, right, bottom] = region.bounds();
    let pixels = |from: f64, to: f64, side: u32| {
        let side = f64::from(side);
        (from.floor().clamp(0.0, side) as u32)..(to.ceil().clamp(0.0, side) as u32)
    };
    [pixels(left, right, size.width), pixels(top, bottom, size.height)]
}

/// Counts the pixels of a region by object, querying each centre.
fn count_pixels(
    size: Size,
    region: &Region,
    object: impl Fn(u32, u32) -> Option<usize> + Sync,
) -> Vec<VisibleHit> {
    let [columns, rows] = pixels_of(size, region);
    let of_rows = map(rows.len(), ROWS_PER_TASK, &|run| {
        let mut counts = Counts::new();
        for y in run.map(|row| rows.start + row as u32) {
            for x in columns.clone() {
                let centre = PhysicalPosition::centre_of(x, y);
                if region.contains(centre.x, centre.y)
                    && let Some(object) = object(x, y)
                {
                    *counts.entry(object).or_default() += 1;
                }
            }
        }
        counts
    });
    let mut all = Counts::new();
    for counts in of_rows {
        add_counts(&mut all, counts);
    }
    hits(all)
}
