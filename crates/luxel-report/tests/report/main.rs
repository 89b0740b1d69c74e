//! The formats through the public interface.

mod fixture;
mod ledger;
mod picks;
