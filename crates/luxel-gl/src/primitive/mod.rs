//! Primitives: assembled, culled, clipped.
