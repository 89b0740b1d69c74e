//! From samples to the attributes of the surfaces that they see.

mod batch;
mod fragments;

pub(crate) use batch::{Batch, nearest_sample};
pub(crate) use fragments::{Fragments, SHARED, Wanted, put_material};
