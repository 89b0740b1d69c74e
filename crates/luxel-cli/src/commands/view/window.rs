//! `luxel view` in a window.

use super::line::line;
use super::loading::write;
use super::{ViewCommand, keys, saved};
use crate::console::Console;
use crate::failure::Failure;
use crate::{model, navigation, output, surface, view};
use clap::Command;
use luxel_viewer::{LoadProgress, Options, Outcome, ViewerError};
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

impl ViewCommand {
    /// Runs the viewer in a window. `words` is the whole command line, `program` its definition.
    pub(super) fn in_window(
        self,
        console: Console,
        words: &[OsString],
        program: Command,
    ) -> Result<(), Failure> {
        let words = words.to_vec();
        let files: Vec<_> = std::iter::once(&self.input.model).chain(&self.more).collect();
        for file in &files {
            self.check_model(file, console)?;
        }
        let files = files.into_iter().cloned().collect();
        let record = self.record.as_ref().map(PathBuf::from);
        if let Some(path) = &record {
            output::check_writable(path, "--record")?;
        }
        let most = self.view.execution.max_memory;
        let replay = self.replay.as_ref().map(|path| navigation::read_log(path, most));
        let (restyle, shading) = (surface::restyle(&self.view.material), self.view.shading.clone());
        let options = Options {
            files,
            size: self.view.frame.size,
            mode: self.mode,
            record,
            replay: replay.transpose()?.map(|(log, _)| log),
            theme: self.theme(),
            keys: keys::keys(self.keys.as_deref())?,
            execution: view::execution(&self.view.execution),
            write: Box::new(write),
            print: Box::new(move |file, seen| {
                let line = line(&program, &words, file, seen);
                // The reader may be gone; the window stays open.
                let _ = output::print(&format!("{line}\n"));
                line
            }),
            save: Box::new(move |file, showing| {
                let (path, text) = saved::saved(file, showing, restyle.clone(), &shading)?;
                write(&path, text.as_bytes())?;
                Ok(path.display().to_string())
            }),
            on_interrupt: Box::new(output::on_interrupt),
            notice: Box::new(move |what| console.notice(what)),
            detail: Box::new(move |what| console.detail(what)),
        };
        // The error of the loading thread.
        let failure = Arc::new(Mutex::new(None));
        let kept = Arc::clone(&failure);
        let load = move |file: &OsStr, progress: &LoadProgress| {
            self.load(file, console, progress).map_err(|failure| {
                let what = failure.lines().join("; ");
                *kept.lock().unwrap_or_else(PoisonError::into_inner) = Some(failure);
                what
            })
        };
        match luxel_viewer::run(load, options) {
            Ok(Outcome::Closed) => Ok(()),
            Ok(Outcome::NotLoaded) => {
                let failure = failure.lock().unwrap_or_else(PoisonError::into_inner).take();
                failure.map_or(Ok(()), Err)
            }
            Ok(Outcome::Interrupted) => Err(Failure::Interrupted),
            Err(error @ ViewerError::Record(_)) => {
                Err(Failure::work(error.to_string(), "choose another file with --record"))
            }
            Err(error @ ViewerError::NoDisplay(_)) => Err(Failure::work(
                error.to_string(),
                "`luxel view --terminal` and `luxel render` need no display; or set DISPLAY",
            )),
            Err(error) => Err(Failure::work(error.to_string(), "")),
        }
    }

    /// Fails before a window opens if the file is missing or a folder.
    fn check_model(&self, model: &OsStr, console: Console) -> Result<(), Failure> {
        let is_file = model != "-" && !model.to_string_lossy().starts_with("demo:");
        if is_file && !std::fs::metadata(model).is_ok_and(|there| !there.is_dir()) {
            let input = self.input(model);
            return model::load_with_progress(&input, &self.view.execution, console, None)
                .map(|_| ());
        }
        Ok(())
    }
}
