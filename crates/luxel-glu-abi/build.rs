//! The library's name for the dynamic linker, and when it looks up OpenGL: at the first call, since programs may load
//! OpenGL after GLU. References to functions of GLU mean the library's own.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|system| system == "linux") {
        println!("cargo::rustc-cdylib-link-arg=-Wl,-soname,libGLU.so.1");
        println!("cargo::rustc-cdylib-link-arg=-Wl,-z,lazy");
        println!("cargo::rustc-cdylib-link-arg=-Wl,-Bsymbolic");
    }
}
