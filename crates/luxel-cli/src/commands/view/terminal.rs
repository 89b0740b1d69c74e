//! `luxel view --terminal`.

use super::loading::write;
use super::{GraphicsName, ViewCommand, keys};
use crate::console::Console;
use crate::failure::Failure;
use crate::{output, view};
use luxel_viewer::{
    Graphics, GraphicsChoice, LoadProgress, TerminalOptions, ViewerError, leave_terminal,
    view_in_terminal,
};

impl ViewCommand {
    /// Runs the viewer in the terminal.
    pub(super) fn in_terminal(&self, console: Console) -> Result<(), Failure> {
        let keys = keys::keys(self.keys.as_deref())?;
        let graphics = match self.graphics {
            GraphicsName::Auto => GraphicsChoice::Auto,
            GraphicsName::Kitty => GraphicsChoice::Only(Graphics::Kitty),
            GraphicsName::Iterm2 => GraphicsChoice::Only(Graphics::Iterm2),
            GraphicsName::Sixel => GraphicsChoice::Only(Graphics::Sixel),
            GraphicsName::Blocks => GraphicsChoice::Only(Graphics::Blocks),
        };
        let file = &self.input.model;
        let model = self.load(file, console, &LoadProgress::default())?;
        if let Some(note) = &model.exposure_note {
            console.notice(note);
        }
        let options = TerminalOptions {
            file: file.clone(),
            mode: self.mode,
            keys,
            theme: self.theme(),
            graphics,
            execution: view::execution(&self.view.execution),
            write: Box::new(write),
        };
        output::on_interrupt(Box::new(|| {
            leave_terminal();
            false
        }));
        view_in_terminal(model, &options).map_err(|error| match error {
            ViewerError::NoTerminal(_) => Failure::work(
                error.to_string(),
                "run it in a terminal, or draw a file with `luxel render`",
            ),
            error => Failure::work(error.to_string(), ""),
        })
    }
}
