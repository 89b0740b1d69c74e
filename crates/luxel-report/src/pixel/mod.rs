//! The ledger of a pixel in each format.

mod formats;
mod hint;
mod html;
mod json;
mod latex;
mod lines;
mod pictures;
mod report;
mod sentences;
mod sums;
mod text;
mod vectors;

pub use hint::Hint;
pub use json::display_to_json;
pub use lines::{LedgerFactor, LedgerLine, ledger_lines};
pub use pictures::{Pictures, PicturesError};
pub use report::Report;
pub use sums::{luminance, term_sums};
pub use vectors::{LedgerVector, VectorKind, ledger_vectors};
