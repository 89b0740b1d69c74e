//! luxel in WebAssembly: models that turn under the hand, and pixels that explain themselves.
//!
//! Pictures have the same bytes as those of the program. Nothing is fetched and nothing is sent. What JavaScript
//! sees is here; `package/` wraps it in workers and types.
//!
//! Structured answers are texts of JSON, with the keys of the program's `--json`.

#![deny(missing_docs)]
#![forbid(unsafe_code)]

mod answers;
mod describe;
mod drawer;
mod error;
mod handles;
mod model;
mod motion;
mod questions;
mod view;
mod vocabulary;

#[cfg(feature = "split")]
pub use answers::link_answers;
pub use drawer::Drawer;
pub use model::Model;
pub use questions::CheckedModel;
pub use view::ModelView;
