//! The transforms to the window of all instances.

use crate::types::WindowTransform;

/// Transforms to one window, each followed by those that differ from it by their last column alone: of many copies
/// of a mesh that are turned and scaled alike.
pub(super) struct WindowTransforms {
    /// Transforms that differ from the one before them by more.
    distinct: Vec<WindowTransform>,
    places: Vec<WindowPlace>,
}

/// A transform by what it has of its own.
struct WindowPlace {
    /// The transform that it shares the other columns with.
    like: u32,
    /// The last column.
    origin: [f32; 4],
}

impl WindowTransforms {
    /// None yet, with room for so many.
    pub(super) fn with_capacity(count: usize) -> Self {
        Self { distinct: Vec::new(), places: Vec::with_capacity(count) }
    }

    pub(super) fn shrink_to_fit(&mut self) {
        self.places.shrink_to_fit();
    }

    pub(super) fn push(&mut self, transform: WindowTransform) {
        let origin = transform.rows.map(|row| row[3]);
        if self.distinct.last().is_none_or(|last| axes(last) != axes(&transform)) {
            self.distinct.push(transform);
        }
        self.places.push(WindowPlace { like: self.distinct.len() as u32 - 1, origin });
    }

    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    #[inline]
    pub(super) fn get(&self, number: usize) -> WindowTransform {
        let WindowPlace { like, origin } = &self.places[number];
        let mut transform = self.distinct[*like as usize];
        for (row, origin) in transform.rows.iter_mut().zip(origin) {
            row[3] = *origin;
        }
        transform
    }
}

/// The bits of the first three columns.
fn axes(transform: &WindowTransform) -> [[u32; 3]; 4] {
    transform.rows.map(|[x, y, z, _]| [x, y, z].map(f32::to_bits))
}
