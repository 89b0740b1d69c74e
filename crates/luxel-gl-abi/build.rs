//! The library's name for the dynamic linker, and whose functions its own references mean.
//!
//! Its own: a process may have another OpenGL with the same names, which the loader would otherwise prefer.
//! A build script, so that any `cargo build` makes a library that programs can be linked with: without the name
//! they would ask for the file that they were linked with.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "linux") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-soname,libOSMesa.so.8");
        println!("cargo::rustc-cdylib-link-arg=-Wl,-Bsymbolic");
    }
}
