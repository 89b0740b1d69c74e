//! What fuzzing has kept of logs.

#[path = "../../../../fuzz/entries/event_log.rs"]
mod event_log;

#[test]
fn no_log_of_the_corpus_panics_or_reads_back_otherwise() {
    luxel_testing::corpus::each_file("event_log", event_log::event_log);
}
