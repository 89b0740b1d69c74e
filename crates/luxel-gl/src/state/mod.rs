//! The state of a context, by the groups of the specification's tables (OpenGL 1.5, section 6.2).

pub(crate) mod arrays;
pub(crate) mod attributes;
pub(crate) mod current;
pub(crate) mod enables;
pub(crate) mod evaluator;
pub(crate) mod fragment;
pub(crate) mod light;
pub(crate) mod material;
pub(crate) mod matrices;
pub(crate) mod pixel;
pub(crate) mod polygon;
pub(crate) mod texgen;
pub(crate) mod texture_unit;
pub(crate) mod transfer;
pub(crate) mod window;

pub(crate) use attributes::Attributes;
