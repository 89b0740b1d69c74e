//! Writes results: to the standard output, and to files, atomically.

use crate::failure::{Failure, INTERRUPTED};
use serde::Serialize;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, Once, PoisonError};

/// Makes writes beyond the limit of `ulimit -f` fail, where the system would end the program.
pub(crate) fn outlive_file_limits() {
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, std::sync::Arc::default());
}

/// Prints text.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    print_bytes(text.as_bytes())
}

/// Prints bytes verbatim.
pub(crate) fn print_bytes(bytes: &[u8]) -> Result<(), Failure> {
    print_whole(bytes).map_err(|error| Failure::standard_output(&error))
}

/// Prints the content of a file, of which a part is worth nothing: also a reader that goes away, and a
/// standard output that was closed before the program began, are failures.
pub(crate) fn print_file(bytes: &[u8]) -> Result<(), Failure> {
    let failure = |what: &str| {
        Err(Failure::work(format!("standard output: {what}"), "write to a file with -o FILE"))
    };
    if is_output_closed() {
        return failure("it is closed");
    }
    match print_whole(bytes) {
        Ok(()) => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {
            failure("its reader closed it before the end")
        }
        Err(error) => Err(Failure::standard_output(&error)),
    }
}

fn print_whole(bytes: &[u8]) -> io::Result<()> {
    let mut output = io::stdout().lock();
    output.write_all(bytes)?;
    output.flush()
}

/// Whether the standard output was closed when the program began, as far as the system tells. Rust then
/// opens the null device in its place, for reading and writing; a shell opens it for writing only.
fn is_output_closed() -> bool {
    const READ_AND_WRITE: u32 = 2;
    let is_null = fs::read_link("/proc/self/fd/1").is_ok_and(|file| file == Path::new("/dev/null"));
    let access = || {
        let about = fs::read_to_string("/proc/self/fdinfo/1").ok()?;
        let flags = about.lines().find_map(|line| line.strip_prefix("flags:"))?;
        u32::from_str_radix(flags.trim(), 8).ok().map(|flags| flags & 3)
    };
    is_null && access() == Some(READ_AND_WRITE)
}

/// Prints a JSON document as one line.
pub(crate) fn print_json(document: &impl Serialize) -> Result<(), Failure> {
    let print = || {
        let mut output = BufWriter::new(io::stdout().lock());
        serde_json::to_writer(&mut output, document)?;
        output.write_all(b"\n")?;
        output.flush()
    };
    print().map_err(|error| Failure::standard_output(&error))
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
    remove_leftovers(&target);
    let unfinished = unfinished_name(&target);
    remove_on_interrupt(&unfinished);
    let written = write_new(&unfinished, &target, bytes);
    if written.is_err() {
        let _ = fs::remove_file(&unfinished);
    }
    *UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner) = None;
    written.map_err(failure)
}

/// Writes the unfinished file, with the permissions of the one that it replaces, and renames it.
fn write_new(unfinished: &Path, target: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(unfinished)?;
    // Tells the file of a run at work from what a killed one left; not all file systems have locks.
    let _ = file.try_lock();
    if let Ok(replaced) = fs::metadata(target) {
        file.set_permissions(replaced.permissions())?;
    }
    file.write_all(bytes)?;
    fs::rename(unfinished, target)
}

/// Removes the unfinished files of killed runs that were to become this one.
fn remove_leftovers(target: &Path) {
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty());
    let Ok(files) = fs::read_dir(folder.unwrap_or(Path::new("."))) else { return };
    let begin = beginning_of_unfinished(target);
    for file in files.filter_map(Result::ok) {
        let name = file.file_name();
        let name = name.as_encoded_bytes();
        let number = name
            .strip_prefix(begin.as_encoded_bytes())
            .and_then(|rest| rest.strip_suffix(UNFINISHED_END.as_bytes()));
        if number.is_none_or(|number| number.is_empty() || !number.iter().all(u8::is_ascii_digit)) {
            continue;
        }
        let is_at_work = File::open(file.path())
            .is_ok_and(|unfinished| matches!(unfinished.try_lock(), Err(TryLockError::WouldBlock)));
        if !is_at_work {
            let _ = fs::remove_file(file.path());
        }
    }
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
    let mut name = beginning_of_unfinished(path);
    // WebAssembly has no process ids, and querying one aborts.
    let number = if cfg!(target_family = "wasm") { 0 } else { std::process::id() };
    name.push(number.to_string());
    name.push(UNFINISHED_END);
    path.with_file_name(name)
}

/// What follows the number of the process in the name of an unfinished file.
const UNFINISHED_END: &str = ".part";

fn beginning_of_unfinished(path: &Path) -> OsString {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(".");
    name
}

fn remove_on_interrupt(unfinished: &Path) {
    *UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner) = Some(unfinished.to_owned());
    handle_interrupts();
}

/// Sets the handler of the next interrupt. If it returns true, the program exits by itself, and
/// only a second interrupt ends it at once.
#[cfg(feature = "terminal")]
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
