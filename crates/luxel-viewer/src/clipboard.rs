//! The system's clipboard, for lines of text.

use arboard::Clipboard as System;

/// The clipboard, once it is needed. On X11 what was put into it is handed out by this program, so this
/// lives as long as the window; at its end a clipboard manager takes over, where there is one.
#[derive(Default)]
pub(crate) struct Clipboard(Option<System>);

impl Clipboard {
    /// Puts a text into it; answers with what went wrong, for the user.
    pub(crate) fn put(&mut self, text: &str) -> Result<(), String> {
        self.system()?.set_text(text).map_err(|error| error.to_string())
    }

    /// The text that is in it, if there is one.
    pub(crate) fn text(&mut self) -> Option<String> {
        self.system().ok()?.get_text().ok()
    }

    fn system(&mut self) -> Result<&mut System, String> {
        match &mut self.0 {
            Some(system) => Ok(system),
            none => Ok(none.insert(System::new().map_err(|error| error.to_string())?)),
        }
    }
}
