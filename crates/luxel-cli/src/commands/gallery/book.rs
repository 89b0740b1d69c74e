//! Builds and writes the gallery.

use super::GalleryCommand;
use crate::console::Console;
use crate::failure::Failure;
use crate::output;
use crate::progress::Progress;
use crate::view;
use luxel_gallery::{Error, File, Gallery, Pair, Reproduced};
use serde_json::{Value, json};
use std::fs;
use std::io;
use std::path::Path;

impl GalleryCommand {
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        if self.output == "-" {
            let message = "a gallery has many files: name a folder with -o";
            return Err(Failure::Usage(message.to_owned()));
        }
        let folder = Path::new(&self.output);
        check(folder)?;
        self.execution.take_part();
        let bar = Progress::new(console, Gallery::STEPS, "chapters");
        let gallery = Gallery::make(&view::execution(&self.execution), || bar.step())
            .map_err(|error| Failure::work(error.to_string(), ""))?;
        bar.finish();
        if !folder.is_dir() {
            fs::create_dir(folder).map_err(|error| Failure::writing(folder, &error, "-o"))?;
        }
        // The page comes last, so that all its images exist when it does.
        for file in gallery.files.iter().rev() {
            output::write_file(&folder.join(&file.name), &file.bytes)?;
        }
        let page = folder.join("index.html");
        console.detail(&format!("{} files, start at {}", gallery.files.len(), page.display()));
        if self.json {
            output::print_json(&to_json(&gallery, folder))?;
        }
        Ok(())
    }
}

/// Fails before any work if the folder can't be written.
fn check(folder: &Path) -> Result<(), Failure> {
    match fs::metadata(folder) {
        Ok(there) if there.is_dir() => Ok(()),
        Ok(_) => {
            let what = format!("{}: is not a folder", folder.display());
            Err(Failure::work(what, "choose another folder with -o"))
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => output::check_folder(folder, "-o"),
        Err(error) => Err(Failure::writing(folder, &error, "-o")),
    }
}

fn to_json(gallery: &Gallery, folder: &Path) -> Value {
    let file = |file: &File| {
        let path = folder.join(&file.name);
        json!({ "file": path.to_string_lossy(), "bytes": file.bytes.len() })
    };
    let drawn = |picture: &Reproduced| json!({ "file": picture.file, "command": picture.command });
    let error = |error: &Error| json!({ "largest": error.largest, "mean": error.mean });
    let pair = |pair: &Pair| {
        // An error of 0 has no ratio.
        let [largest, mean] = pair.times_better().map(|times| times.is_finite().then_some(times));
        json!({
            "name": pair.name,
            "measure": pair.measure,
            "problem": error(&pair.problem),
            "cure": error(&pair.cure),
            "times_better": { "largest": largest, "mean": mean },
            "enough": pair.is_enough(),
            "because": if pair.is_enough() { None } else { pair.because },
        })
    };
    json!({
        "page": folder.join("index.html").to_string_lossy(),
        "files": gallery.files.iter().map(file).collect::<Vec<_>>(),
        "pairs": gallery.pairs.iter().map(pair).collect::<Vec<_>>(),
        "commands": gallery.reproduced.iter().map(drawn).collect::<Vec<_>>(),
    })
}
