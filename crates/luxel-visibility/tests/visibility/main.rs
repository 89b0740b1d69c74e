//! The visibility buffer against outside truth: exact coverage, rays, and itself drawn otherwise.

mod coverage;
mod oracle;
mod random;
mod scene;
