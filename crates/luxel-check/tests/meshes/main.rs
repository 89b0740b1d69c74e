//! For each kind of finding a mesh with a known number of them, and its twin without.

#![allow(clippy::unwrap_used, reason = "what fails here is a failed test")]

mod any;
mod made;

mod twins;
