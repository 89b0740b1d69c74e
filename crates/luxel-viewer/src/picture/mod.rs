//! From rendered frames to the window's pixels: composition, differences, lines and outlines over the
//! picture, screenshots.

mod compose;
mod difference;
mod guides;
mod lines;
mod outline;
mod screenshot;

pub(crate) use compose::{compose, compose_empty};
pub(crate) use difference::{DIFFERENCE_SCALE, PictureDifference, difference_map, join_columns};
pub(crate) use guides::{GuideScene, Guides};
pub(crate) use lines::{Depths, Line, draw_lines};
pub(crate) use outline::{OutlinedIds, draw_outlines};
pub(crate) use screenshot::{rgba_of, save_png};
