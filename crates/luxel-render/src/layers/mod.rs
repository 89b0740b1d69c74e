//! Layers: what the picture is made of, one to three values a pixel, taken at the pixel's centre and
//! never averaged.
//!
//! All layers come from one pass over one visibility, sixteen pixels at a time: the code that shades
//! runs with a witness that keeps what it hears, and layers are written from that. Where a picture has one
//! sample a pixel and nothing that blends, it comes from the same pass. Where surfaces blend, terms of light
//! take a pass of their own, over all layers.

mod blended;
mod elsewhere;
mod pass;
mod passes;
mod planes;
mod sample;
mod witness;
