//! How numbers and names are written, in all formats alike.

mod names;
mod number;
mod printable;

pub(crate) use names::{capital, model_name};
pub(crate) use number::{color, coordinate, in_column, number, vector};
pub use printable::printable;
