//! Light that goes to the eye from what samples see. Light of pieces, and what is interpolated in the window, is there to
//! be studied: it is written for one sample at a time.

mod block;
mod colors;
mod display;
mod flat_light;
mod kept_points;
mod lit_triangle;
mod place_terms;
mod points;
mod screen_interpolation;
mod shadowed;
mod studied;
mod thread_cache;
mod triangle_terms;
mod whole_lanes;
mod whole_place;
mod witness;

pub(crate) use block::{all_fragments, geometry_of, shade, shade_together};
pub(crate) use display::displayed;
pub(crate) use lit_triangle::LitTriangle;
pub(crate) use place_terms::{LitPlace, MixedLight, MixedTerms, Term};
pub(crate) use points::point_of;
pub(crate) use shadowed::VisibleLights;
pub(crate) use studied::is_studied;
pub(crate) use thread_cache::ThreadCache;
pub(crate) use triangle_terms::{TriangleTerms, WantedTerms};
pub(crate) use witness::BlockWitness;
