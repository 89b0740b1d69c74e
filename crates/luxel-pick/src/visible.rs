//! What is seen in a region: objects with the pixels they own, from a frame that has been drawn, or
//! from what is drawn of the region alone.

use crate::drawing::{Pixels, Shown};
use crate::region::Region;
use crate::surface_hit::Element;
use crate::view::PickView;
use crate::window::PhysicalPosition;
use luxel_parallel::map;
use luxel_scene::Size;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

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
    /// The objects that own pixels of a region, by the fill rule of frames, in their order: those
    /// whose centres lie inside.
    #[must_use]
    pub fn visible_in(&self, region: &Region) -> Vec<VisibleHit> {
        let pixels = pixels_of(self.size(), region);
        let all = Mutex::new(Counts::new());
        let of_tile = |shown: &mut dyn Iterator<Item = Shown>| {
            let mut counts = Counts::new();
            for Shown { pixel: [x, y], instance, .. } in shown {
                let PhysicalPosition { x, y } = PhysicalPosition::centre_of(x, y);
                if region.contains(x, y) {
                    *counts.entry(self.placed.instances()[instance].object).or_default() += 1;
                }
            }
            add(&mut all.lock().unwrap_or_else(PoisonError::into_inner), counts);
        };
        match self.drawn(&pixels, &of_tile) {
            Ok(()) => hits_of(all.into_inner().unwrap_or_else(PoisonError::into_inner)),
            // So many that a frame can't number them can still be asked for.
            Err(_) => counted(self.size(), region, |x, y| {
                self.owner_at(PhysicalPosition::centre_of(x, y)).map(|(object, _)| object)
            }),
        }
    }

    /// What every pixel shows, to be asked again and again.
    #[must_use]
    pub fn visible_ids(&self) -> VisibleIds {
        let Size { width, height } = self.size();
        let count = width as usize * height as usize;
        let all = Mutex::new((vec![NOTHING; count], vec![NOTHING; count]));
        let set = |shown: &[([u32; 2], usize, Element)]| {
            let (objects, triangles) = &mut *all.lock().unwrap_or_else(PoisonError::into_inner);
            for &([x, y], object, element) in shown {
                let at = y as usize * width as usize + x as usize;
                objects[at] = object as u32;
                if let Element::Triangle(triangle) = element {
                    triangles[at] = triangle;
                }
            }
        };
        let of_tile = |shown: &mut dyn Iterator<Item = Shown>| {
            let element = |shown: Shown| {
                let (object, element) = self.element_of(shown.instance, shown.triangle);
                (shown.pixel, object, element)
            };
            set(&shown.map(element).collect::<Vec<_>>());
        };
        if self.drawn(&[0..width, 0..height], &of_tile).is_err() {
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

/// Rows that one thread takes at a time.
const ROWS: usize = 4;

/// Pixels by object.
type Counts = BTreeMap<usize, u64>;

fn add(all: &mut Counts, more: Counts) {
    for (object, pixels) in more {
        *all.entry(object).or_default() += pixels;
    }
}

fn hits_of(counts: Counts) -> Vec<VisibleHit> {
    counts.into_iter().map(|(object, pixels)| VisibleHit { object, pixels }).collect()
}

/// The pixels of the window that a region may have centres in.
fn pixels_of(size: Size, region: &Region) -> Pixels {
    let [left, top, right, bottom] = region.bounds();
    let pixels = |from: f64, to: f64, side: u32| {
        let side = f64::from(side);
        (from.floor().clamp(0.0, side) as u32)..(to.ceil().clamp(0.0, side) as u32)
    };
    [pixels(left, right, size.width), pixels(top, bottom, size.height)]
}

/// Counts the pixels of a region whose centres show something.
fn counted(
    size: Size,
    region: &Region,
    object: impl Fn(u32, u32) -> Option<usize> + Sync,
) -> Vec<VisibleHit> {
    let [columns, rows] = pixels_of(size, region);
    let of_rows = map(rows.len(), ROWS, &|run| {
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
        add(&mut all, counts);
    }
    hits_of(all)
}
