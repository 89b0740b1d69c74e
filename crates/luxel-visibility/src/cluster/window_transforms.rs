//! The transforms to the window of all instances.

use crate::types::WindowTransform;

/// Transforms to one window, whose middle all have alike. Those that follow one another and differ by their last column
/// alone, of many copies of a mesh that are turned and scaled alike, share the others.
pub(super) struct WindowTransforms {
    /// The first three columns, by rows, of those that differ from the transform before them there.
    axes: Vec<[[f32; 3]; 4]>,
    places: Vec<WindowPlace>,
    /// The window's middle.
    centre: [f32; 2],
}

/// A transform by what it has of its own.
struct WindowPlace {
    /// The place of its axes among all.
    axes: u32,
    /// The last column.
    origin: [f32; 4],
}

impl WindowTransforms {
    /// None yet, with room for so many.
    pub(super) fn with_capacity(count: usize) -> Self {
        Self { axes: Vec::new(), places: Vec::with_capacity(count), centre: [0.0; 2] }
    }

    pub(super) fn shrink_to_fit(&mut self) {
        self.axes.shrink_to_fit();
        self.places.shrink_to_fit();
    }

    pub(super) fn push(&mut self, transform: &WindowTransform) {
        let WindowTransform { rows, centre } = *transform;
        let axes = rows.map(|[x, y, z, _]| [x, y, z]);
        if self.axes.last().is_none_or(|last| bits(last) != bits(&axes)) {
            self.axes.push(axes);
        }
        let origin = rows.map(|row| row[3]);
        self.places.push(WindowPlace { axes: self.axes.len() as u32 - 1, origin });
        self.centre = centre;
    }

    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    #[inline]
    pub(super) fn get(&self, number: usize) -> WindowTransform {
        let WindowPlace { axes, origin } = &self.places[number];
        let axes = &self.axes[*axes as usize];
        let row = |row: usize| {
            let [x, y, z] = axes[row];
            [x, y, z, origin[row]]
        };
        WindowTransform { rows: [row(0), row(1), row(2), row(3)], centre: self.centre }
    }
}

fn bits(axes: &[[f32; 3]; 4]) -> [[u32; 3]; 4] {
    axes.map(|row| row.map(f32::to_bits))
}
