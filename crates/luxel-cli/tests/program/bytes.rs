//! Execution options never change a byte.

use crate::program::Folder;

/// All SIMD levels of the machine.
fn levels() -> Vec<&'static str> {
    luxel::math::SimdLevel::available().into_iter().map(luxel::math::SimdLevel::name).collect()
}

#[track_caller]
fn assert_same_bytes(line: &str) {
    let folder = Folder::new();
    let draw = |flags: &str| {
        folder.run(format!("render {line} -o - {flags}").split_whitespace()).done().stdout
    };
    let first = draw("--threads 1");
    assert!(!first.is_empty());
    for threads in [2, 7] {
        assert!(draw(&format!("--threads {threads}")) == first, "{line}: {threads} threads");
    }
    for level in levels() {
        assert!(draw(&format!("--simd {level}")) == first, "{line}: {level}");
    }
}

#[test]
fn threads_and_vectors_change_no_byte_of_a_picture() {
    for name in ["teapot", "spheres", "cornell", "plane"] {
        assert_same_bytes(&format!("demo:{name} --size 203x150"));
    }
}

#[test]
fn threads_and_vectors_change_no_byte_of_a_layer() {
    for layer in ["depth", "normal", "triangle", "barycentric"] {
        let flags = format!("--layer {layer} --output-format npy --size 131x97");
        assert_same_bytes(&format!("demo:plane {flags}"));
    }
}

#[test]
fn threads_and_vectors_change_no_byte_of_light_before_it_is_rounded() {
    assert_same_bytes("demo:spheres --output-format npy --size 131x97 --samples 8");
}
