//! Commands of the panels and overlays to the window.

use luxel::navigation::{Mode, StandardView};
use luxel::scene::Bounds;
use std::path::PathBuf;

/// A command to the window.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum UiCommand {
    /// Go to a standard view.
    View(StandardView),
    /// Fit bounds, or the whole scene, into view.
    Fit(Option<Bounds>),
    /// Set the navigation mode.
    Mode(Mode),
    /// Toggle between perspective and orthographic lens.
    ToggleLens,
    /// Copy the command line that draws the view.
    CopyCommand,
    /// Save a scene file.
    SaveScene,
    /// Open the dialog for a model.
    OpenDialog,
    /// Open a model.
    Open(PathBuf),
    /// Cancel loading.
    StopLoading,
    /// Copy a text to the clipboard.
    CopyText(String),
}
