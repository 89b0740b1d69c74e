//! What fuzzing has kept of command lines and key files.

#[path = "../../../../fuzz/entries/command_line.rs"]
mod command_line;
#[cfg(feature = "viewer")]
#[path = "../../../../fuzz/entries/key_file.rs"]
mod key_file;

use luxel_testing::corpus::each_file;

#[test]
fn no_command_line_of_the_corpus_panics() {
    each_file("command_line", command_line::command_line);
}

#[test]
#[cfg(feature = "viewer")]
fn no_key_file_of_the_corpus_panics() {
    each_file("key_file", key_file::key_file);
}
