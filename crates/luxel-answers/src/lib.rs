//! What picks are told as: JSON and text.
//!
//! The program asks for millions of them in one run, while the rest of its own code is called once;
//! so this is compiled apart from it, and optimised.

#![forbid(unsafe_code)]

mod answer;
mod printable;

pub use answer::{Answer, append_json, document, text};
pub use printable::printable;
