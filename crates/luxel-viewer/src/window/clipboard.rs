//! The system's clipboard, for text.

use arboard::Clipboard as System;

/// The clipboard, opened when first used. On X11 this program serves its contents, so it lives as long as
/// the window; then a clipboard manager takes over, if there is one.
#[derive(Default)]
pub(crate) struct Clipboard(Option<System>);

impl Clipboard {
    /// Copies a text; the error is for the user.
    pub(crate) fn put(&mut self, text: &str) -> Result<(), String> {
        self.system()?.set_text(text).map_err(|error| error.to_string())
    }

    /// The clipboard's text, if it holds any.
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
