//! `luxel gallery`: its files, and that its commands reproduce its images.

use crate::program::Folder;
use std::collections::BTreeSet;
use std::fs;

/// The red, green and blue of a PNG.
fn colors(bytes: &[u8]) -> Vec<[u8; 3]> {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let channels = info.color_type.samples();
    pixels.chunks_exact(channels).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

#[test]
fn every_command_of_the_gallery_reproduces_its_image() {
    let folder = Folder::new();
    let told = folder.run(["gallery", "-o", "book", "--json"]).json();
    let written: BTreeSet<_> = fs::read_dir(folder.path("book"))
        .unwrap()
        .map(|entry| format!("book/{}", entry.unwrap().file_name().into_string().unwrap()))
        .collect();
    let files = told["files"].as_array().unwrap();
    let files: BTreeSet<_> =
        files.iter().map(|file| file["file"].as_str().unwrap().to_owned()).collect();
    assert_eq!(files, written);
    assert!(told["pairs"].as_array().unwrap().len() >= 9);

    let commands = told["commands"].as_array().unwrap();
    assert!(commands.len() >= 20);
    for picture in commands {
        let words: Vec<_> = picture["command"]
            .as_array()
            .unwrap()
            .iter()
            .map(|word| word.as_str().unwrap())
            .collect();
        assert_eq!(words[0], "luxel");
        let file = picture["file"].as_str().unwrap();
        folder.run(&words[1..]).done();
        let [kept, drawn] =
            [format!("book/{file}"), file.to_owned()].map(|name| folder.read(&name));
        assert!(colors(&kept) == colors(&drawn), "{words:?} draws something else than {file}");
    }
}

#[test]
fn a_gallery_without_a_writable_folder_is_an_error() {
    let folder = Folder::new();
    folder.write("file", "");
    folder.run(["gallery", "-o", "file"]).failed(1, "is not a folder");
    folder.run(["gallery", "-o", "no/such"]).failed(1, "there is no folder no");
    folder.run(["gallery", "-o", "-"]).failed(2, "name a folder");
    folder.run(["gallery"]).failed(2, "--output");
    assert_eq!(folder.files(), ["file"]);
}

#[test]
fn check_finds_the_t_junctions_of_the_lab_and_none_in_its_cure() {
    let folder = Folder::new();
    let count = |demo: &str| {
        let run = folder.run(["check", demo, "--json"]);
        let report: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
        let findings = report["findings"].as_array().unwrap().clone();
        let of_kind = findings.iter().find(|finding| finding["kind"] == "t-junction");
        of_kind.map_or(0, |finding| finding["count"].as_u64().unwrap())
    };
    assert_eq!(count("demo:lab-t-junction"), 7);
    assert_eq!(count("demo:lab-t-junction-cured"), 0);
}
