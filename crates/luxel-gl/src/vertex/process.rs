//! Vertices through transform and lighting.
