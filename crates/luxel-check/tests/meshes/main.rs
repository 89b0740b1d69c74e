//! For each kind of finding a mesh with a known number of them, and its twin without.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod any;
mod made;

mod twins;
