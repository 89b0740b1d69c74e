//! A view drawn: the scene before the camera, tiles and the threads that draw them.

mod crop;
mod error;
mod finished_tile;
mod frame_needs;
mod frame_setup;
mod picture;
mod renderer;
mod tile_drawing;
mod tile_shading;
mod tiles;
mod workers;

pub use error::{MAX_SIDE, RenderError};
pub use picture::{Picture, Stages, Subdivision};
pub use renderer::{Prepared, Renderer};
pub use tile_drawing::TileDrawing;

pub(crate) use frame_needs::FrameNeeds;
pub(crate) use frame_setup::{ambient, placed_lights};
pub(crate) use renderer::lights_with_terms;
pub(crate) use tile_shading::{AHEAD, ALL_BLOCKS, Worker, look_ahead};
pub(crate) use tiles::{
    Bands, NEVER, TilePixels, TileWork, for_tiles, place_in_tile, put_block, unless_stopped,
};
pub(crate) use workers::BusyWorker;
