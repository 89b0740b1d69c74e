//! Navigation as its users meet it: what modes promise, logs with results found by hand, logs that
//! read back.

#![allow(clippy::unwrap_used, reason = "what fails here is a failed test")]
#![allow(clippy::disallowed_methods, reason = "the measure may come from the platform")]

mod by_hand;
mod format;
mod hand;
mod promises;
mod rolling_ball;
mod stage;
mod views;
