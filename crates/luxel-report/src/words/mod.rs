//! How numbers and names are written, in all formats alike.

mod names;
mod number;
mod printable;

pub(crate) use names::{capital, model_name};
pub use number::number;
pub(crate) use number::{color, coordinate, in_column, vector};
pub use printable::printable;
