//! Frames against what must come out: analytic colours, golden bytes, every way of running.

mod determinism;
mod golden;
mod layers;
mod light;
mod scenes;
mod transparency;
