//! Writes results: to the standard output, and to files, atomically.

use crate::failure::{Failure, INTERRUPTED};
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, Once, PoisonError};

/// Prints text.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    print_bytes(text.as_bytes())
}

/// Prints bytes verbatim.
pub(crate) fn print_bytes(bytes: &[u8]) -> Result<(), Failure> {
    let mut output = io::stdout().lock();
    output
        .write_all(bytes)
        .and_then(|()| output.flush())
        .map_err(|error| Failure::standard_output(&error))
}

/// Prints a JSON document as one line.
pub(crate) fn print_json(document: &serde_json::Value) -> Result<(), Failure> {
    print(&format!("{document}\n"))
}

/// The file being written, which an interrupt must remove.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);
/// Runs on an interrupt; returns whether the program then exits by itself.
type OnInterrupt = Box<dyn FnOnce() -> bool + Send>;
static ON_INTERRUPT: Mutex<Option<OnInterrupt>> = Mutex::new(None);
static INTERRUPTS: Once = Once::new();

/// Writes a file under another name and renames it, so that it is complete or absent. An existing
/// pipe or device is written to directly.
pub(crate) fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let failure = |error: io::Error| Failure::writing(path, &error, "-o");
    match fs::metadata(path) {
        Ok(there) if !there.is_file() => {
            let mut file = OpenOptions::new().write(true).open(path).map_err(failure)?;
            return file.write_all(bytes).map_err(failure);
        }
        _ => {}
    }
    // Follows links: their target is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let unfinished = unfinished_name(&target);
    remove_on_interrupt(&unfinished);
    let written = OpenOptions::new()
        .write(true)
        .create_new(true)
        .open(&unfinished)
        .and_then(|mut file| file.write_all(bytes))
        .and_then(|()| fs::rename(&unfinished, &target));
    if written.is_err() {
        let _ = fs::remove_file(&unfinished);
    }
    *UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner) = None;
    written.map_err(failure)
}

/// Fails before any work if the folder of a flag's file is missing.
pub(crate) fn check_folder(path: &Path, flag: &str) -> Result<(), Failure> {
    if path.is_dir() {
        let remedy = format!("name a file in it with {flag}");
        return Err(Failure::work(format!("{}: is a folder", path.display()), remedy));
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => return Ok(()),
    };
    if folder.is_dir() {
        Ok(())
    } else {
        let what = format!("{}: there is no folder {}", path.display(), folder.display());
        Err(Failure::work(what, format!("create it, or choose another file with {flag}")))
    }
}

/// Fails before any work if a flag's file can't be written; changes nothing.
#[cfg(feature = "viewer")]
pub(crate) fn check_writable(path: &Path, flag: &str) -> Result<(), Failure> {
    check_folder(path, flag)?;
    if fs::metadata(path).is_ok_and(|there| !there.is_file()) {
        // Opening a pipe would wait for its reader.
        return Ok(());
    }
    let unfinished = unfinished_name(&fs::canonicalize(path).unwrap_or_else(|_| path.to_owned()));
    OpenOptions::new()
        .write(true)
        .create_new(true)
        .open(&unfinished)
        .and_then(|file| {
            drop(file);
            fs::remove_file(&unfinished)
        })
        .map_err(|error| Failure::writing(path, &error, flag))
}

/// A name in the same folder, so that renaming stays within one file system.
fn unfinished_name(path: &Path) -> PathBuf {
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    // WebAssembly has no process ids, and querying one aborts.
    let number = if cfg!(target_family = "wasm") { 0 } else { std::process::id() };
    name.push(format!(".{number}.part"));
    path.with_file_name(name)
}

fn remove_on_interrupt(unfinished: &Path) {
    *UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner) = Some(unfinished.to_owned());
    handle_interrupts();
}

/// Sets the handler of the next interrupt. If it returns true, the program exits by itself, and
/// only a second interrupt ends it at once.
#[cfg(feature = "viewer")]
pub(crate) fn on_interrupt(action: OnInterrupt) {
    *ON_INTERRUPT.lock().unwrap_or_else(PoisonError::into_inner) = Some(action);
    handle_interrupts();
}

fn handle_interrupts() {
    INTERRUPTS.call_once(|| {
        // Without a handler the system ends the program, which is right except for the unfinished
        // file and for terminals in raw mode.
        #[cfg(not(target_family = "wasm"))]
        let _ = ctrlc::set_handler(|| {
            let action = ON_INTERRUPT.lock().unwrap_or_else(PoisonError::into_inner).take();
            if action.is_some_and(|action| action()) {
                return;
            }
            if let Some(path) = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).take() {
                let _ = fs::remove_file(path);
            }
            #[expect(clippy::exit, reason = "an interrupt ends the program")]
            std::process::exit(INTERRUPTED.into());
        });
    });
}
