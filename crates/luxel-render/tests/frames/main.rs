//! Frames against what must come out: analytic colours, golden bytes, every way of running.

#![allow(clippy::unwrap_used, reason = "a frame that can't be drawn fails the test")]

mod determinism;
mod display;
mod environment;
mod feedback;
mod golden;
mod interpolation;
mod layers;
mod layers_of_terms;
mod ledger;
mod light;
mod scenes;
mod sections;
mod shading;
mod strokes;
mod svg_painter;
mod transparency;
mod vectors;
