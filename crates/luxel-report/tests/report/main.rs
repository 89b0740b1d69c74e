//! The formats through the public interface.

#![allow(clippy::unwrap_used, reason = "what fails here is a failed test")]

mod fixture;
mod ledger;
mod picks;
