//! The samples of the README and the docs: every command works, and prints what they show.
//!
//! A command is a line that begins with `$ ` or, in a block of `sh`, with `luxel`. Lines below a `$ ` are its
//! output; `...` stands for any lines. The files that commands read are written beside them: logs and scene
//! files from the same pages, and a small model.

use crate::program::{Folder, SQUARE_PLY};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A command of a page, with the output that the page shows.
struct Sample {
    /// The page and the line.
    place: String,
    command: String,
    output: Vec<String>,
}

/// A block of code of a page.
struct Block {
    language: String,
    /// Each line, with its number.
    lines: Vec<(usize, String)>,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn pages() -> Vec<PathBuf> {
    let docs = std::fs::read_dir(root().join("docs")).unwrap();
    let docs = docs.map(|entry| entry.unwrap().path());
    let is_page = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "md");
    let mut pages: Vec<_> = docs.filter(is_page).collect();
    pages.sort();
    pages.insert(0, root().join("README.md"));
    pages
}

fn blocks(page: &Path) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut is_open = false;
    for (line, text) in (1..).zip(std::fs::read_to_string(page).unwrap().lines()) {
        match text.strip_prefix("```") {
            Some(_) if is_open => is_open = false,
            Some(language) => {
                is_open = true;
                blocks.push(Block { language: language.to_owned(), lines: Vec::new() });
            }
            None if is_open => {
                blocks.last_mut().unwrap().lines.push((line, text.to_owned()));
            }
            None => {}
        }
    }
    blocks
}

fn samples() -> Vec<Sample> {
    let mut samples: Vec<Sample> = Vec::new();
    for page in pages() {
        let name = page.file_name().unwrap().to_string_lossy().into_owned();
        for Block { language, lines } in blocks(&page) {
            let before = samples.len();
            for (line, text) in lines {
                let command = match text.strip_prefix("$ ") {
                    Some(command) => Some(command),
                    None if language == "sh" && text.starts_with("luxel ") => Some(text.as_str()),
                    None => None,
                };
                if let Some(command) = command {
                    let (place, command) = (format!("{name}:{line}"), command.to_owned());
                    samples.push(Sample { place, command, output: Vec::new() });
                } else if language != "sh"
                    && let Some(sample) = samples.get_mut(before..).and_then(<[_]>::last_mut)
                {
                    sample.output.push(text);
                }
            }
        }
    }
    samples
}

/// Whether lines are those of a sample, in which `...` stands for any.
fn fits(sample: &[String], lines: &[&str]) -> bool {
    match sample {
        [] => lines.is_empty(),
        [dots, rest @ ..] if dots.trim() == "..." => {
            (0..=lines.len()).any(|skipped| fits(rest, &lines[skipped..]))
        }
        [first, rest @ ..] => lines.first() == Some(&first.as_str()) && fits(rest, &lines[1..]),
    }
}

/// The first block of a page that begins with a line.
fn block_of(page: &str, first_line: &str) -> String {
    let is_it = |block: &Block| block.lines.first().is_some_and(|(_, text)| text == first_line);
    let block = blocks(&root().join(page)).into_iter().find(is_it).unwrap();
    block.lines.into_iter().map(|(_, text)| text + "\n").collect()
}

/// The first block of a page in a language.
fn first_block(page: &str, language: &str) -> String {
    let mut blocks = blocks(&root().join(page)).into_iter();
    let block = blocks.find(|block| block.language == language).unwrap();
    block.lines.into_iter().map(|(_, text)| text + "\n").collect()
}

/// A GLB of one triangle across the middle of a view that fits it.
fn glb() -> Vec<u8> {
    let numbers: [f32; 9] = [-1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 0.0, 1.0, 0.0];
    let binary: Vec<u8> = numbers.into_iter().flat_map(f32::to_le_bytes).collect();
    let mut json = String::from(
        r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"byteLength":36}],
        "bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"count":3,
        "componentType":5126,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]}]}"#,
    );
    while json.len() % 4 != 0 {
        json.push(' ');
    }
    let chunk = |kind: &[u8; 4], bytes: &[u8]| {
        [&(bytes.len() as u32).to_le_bytes()[..], kind, bytes].concat()
    };
    let chunks = [chunk(b"JSON", json.as_bytes()), chunk(b"BIN\0", &binary)].concat();
    let length = (12 + chunks.len()) as u32;
    [b"glTF", &2_u32.to_le_bytes()[..], &length.to_le_bytes(), &chunks].concat()
}

#[cfg(unix)]
#[test]
fn every_sample_of_the_docs_runs_and_prints_what_it_shows() {
    let folder = Folder::new();
    folder.write("model.glb", glb());
    folder.write("part.stl", "solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid part\n");
    folder.write("model.ply", SQUARE_PLY);
    let corpus = root().join("fuzz/corpus/environment");
    folder.write("sky.hdr", std::fs::read(corpus.join("plain.hdr")).unwrap());
    folder.write("sky.exr", std::fs::read(corpus.join("zip-float.exr")).unwrap());
    folder.write("places", "640,360\n1,2\n");
    folder.write("hand.log", block_of("docs/navigation.md", "luxel-navigation 1"));
    folder.write("scene.toml", block_of("docs/scene-files.md", "format = \"luxel-scene\""));
    std::fs::create_dir(folder.path("models")).unwrap();
    folder.write("models/a.glb", glb());
    folder.write("models/b.ply", SQUARE_PLY);
    folder.write("tasks.jsonl", first_block("docs/batch.md", "json"));
    let program = Path::new(env!("CARGO_BIN_EXE_luxel")).parent().unwrap();
    let mut path = std::ffi::OsString::from(program);
    path.push(":");
    path.push(std::env::var_os("PATH").unwrap_or_default());
    let samples = samples();
    assert!(samples.len() > 20, "{} samples were found", samples.len());
    for Sample { place, command, output } in samples {
        let output: Vec<_> = output.into_iter().filter(|line| !line.is_empty()).collect();
        // A window needs a display, which tests never open.
        let opens_a_window = command.starts_with("luxel view");
        let run = Command::new("sh")
            .args(["-c", &command])
            .current_dir(folder.path("."))
            .env("PATH", &path)
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .stdin(Stdio::null())
            .output()
            .unwrap();
        let message = String::from_utf8_lossy(&run.stderr);
        let is_fine = match run.status.code() {
            Some(0) => true,
            // A check with findings.
            Some(3) => command.starts_with("luxel check"),
            Some(1) => opens_a_window && message.contains("window"),
            _ => false,
        };
        assert!(is_fine, "{place}: `{command}`: {message}");
        let printed = String::from_utf8(run.stdout).unwrap();
        let printed: Vec<_> = printed.lines().filter(|line| !line.is_empty()).collect();
        assert!(
            output.is_empty() || fits(&output, &printed),
            "{place}: `{command}` prints\n{}",
            printed.join("\n")
        );
    }
}
