//! The lab of problems, one file each.

pub(crate) mod chalk;
pub(crate) mod mach;
pub(crate) mod normals;
pub(crate) mod perspective;
pub(crate) mod rolling;
pub(crate) mod seam;
pub(crate) mod shadow;
pub(crate) mod silhouette;
pub(crate) mod unnormalised;
