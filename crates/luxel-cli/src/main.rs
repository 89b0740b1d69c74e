//! The program `luxel`: see the library of this crate.

#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    luxel_cli::main()
}
