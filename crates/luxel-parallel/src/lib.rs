//! Work on all threads, in runs of a fixed length.
//!
//! A run is some thousands of elements that one thread takes at a time. Its length is the caller's
//! and fixed, and what runs give is put together in their order, so that nothing depends on how many
//! threads there are or which was first. Threads are those of the current pool of `rayon`.
//!
//! | function | what comes out |
//! | --- | --- |
//! | [`fill`] | a slice, written run by run |
//! | [`gather`] | a list: what each run appends, one run after the other |
//! | [`map`] | one value of each run, in order |
//! | [`any`], [`first`] | whether something is there, and where |
//! | [`each`], [`tasks`] | nothing: work on pieces that are ready, on numbers |
//! | [`join`] | two things done side by side |
//! | [`Memo`] | a value computed when first needed |
//! | [`pool`], [`install`] | threads of one's own, and what is done by them |
//! | [`take_part`], [`limit_threads`] | how many threads do what is done outside of pools |
//! | [`sort_u32`], [`sort_u64`], [`sort_u128`] | keys in order |
//!
//! What is done with a run is a `&dyn Fn`: the loop over its elements is the caller's own code,
//! compiled there, while the handing out of runs is compiled once, here. An iterator of `rayon`
//! costs the compiler two to three thousand lines of LLVM's language each, most of them the same.
//!
//! ```
//! let mut squares = vec![0; 100_000];
//! luxel_parallel::fill(&mut squares, 1 << 12, &|start, run| {
//!     for (number, square) in (start..).zip(run) {
//!         *square = number * number;
//!     }
//! });
//! let even = luxel_parallel::gather(squares.len(), 1 << 12, &|run, found| {
//!     found.extend(run.filter(|&number| squares[number] % 2 == 0));
//! });
//! assert_eq!(even.len(), 50_000);
//! ```

#![forbid(unsafe_code)]

mod memo;
#[cfg_attr(target_family = "wasm", path = "single_thread.rs")]
mod pool;
mod run;
mod sort;
mod thread;

pub use memo::Memo;
pub use pool::{ThreadPool, install, install_while, limit_threads, pool, take_part, threads};
pub use run::{any, each, each_from_outside, fill, first, gather, map};
pub use sort::{sort_u32, sort_u64, sort_u128};
pub use thread::{join, tasks};

/// The examples of `README.md`.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
