//! Navigation through its API: guarantees of modes, logs with results computed by hand, logs that
//! read back.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]
#![allow(clippy::disallowed_methods, reason = "the measure may come from the platform")]

mod by_hand;
mod corpus;
mod format;
mod hand;
mod promises;
mod rolling_ball;
mod stage;
mod views;
