//! The formats through the public interface.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod fixture;
mod ledger;
mod picks;
