//! Overlays in the picture: axes, light handles, vectors, measurement, comparison, help, loading.

mod axes;
mod comparison;
mod help;
mod light_handles;
mod loading;
mod measurement;
mod vectors;

pub(crate) use axes::axes;
pub(crate) use comparison::{difference_scale, divider};
pub(crate) use help::{help, help_scroll_step};
pub(crate) use light_handles::{Grab, light_handles};
pub(crate) use loading::{PendingModel, loading_bar, open_hint};
pub(crate) use measurement::measurement;
pub(crate) use vectors::vectors;
