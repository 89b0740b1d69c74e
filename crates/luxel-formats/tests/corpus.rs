//! What fuzzing has kept: every file of `fuzz/corpus` goes through the entry of its target.

#![cfg(all(
    feature = "gltf",
    feature = "draco",
    feature = "meshopt",
    feature = "obj",
    feature = "ply",
    feature = "stl",
    feature = "toml",
    feature = "png",
    feature = "jpeg",
    feature = "hdr",
    feature = "exr"
))]

#[path = "../../../fuzz/entries/formats.rs"]
mod formats;

use luxel_testing::corpus::each_file;

#[test]
fn no_file_of_the_corpus_makes_a_reader_panic() {
    each_file("stl", formats::stl);
    each_file("ply", formats::ply);
    each_file("obj", formats::obj);
    each_file("gltf", formats::gltf);
    each_file("scene", formats::scene);
    each_file("mtl", formats::mtl);
    each_file("image", formats::image);
    each_file("environment", formats::environment);
    each_file("draco", formats::draco);
    each_file("meshopt", formats::meshopt);
}
