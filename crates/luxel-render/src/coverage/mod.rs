//! Where covered samples are nevertheless not hit, and how far they lie from edges.

mod alpha_test;
mod edges;

pub(crate) use alpha_test::AlphaTest;
pub(crate) use edges::{EdgeFlags, edge_distance};
