//! Display settings, and the comparison of two of them.

mod comparison;
mod settings;

pub(crate) use comparison::Comparison;
pub(crate) use settings::{DisplaySettings, is_of_light, layer_name};
