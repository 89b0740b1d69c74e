//! Two display settings compared: side by side, or as the difference of their pictures.

use super::settings::DisplaySettings;

/// A comparison with the settings that the panels edit.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Comparison {
    /// The settings that the panels don't edit.
    pub(crate) other: DisplaySettings,
    /// Whether the panels edit the right side.
    pub(crate) is_right_active: bool,
    /// The dividing line, as a fraction of the window's width.
    pub(crate) divider: f32,
    /// Shows the difference instead of both sides.
    pub(crate) is_difference: bool,
}

impl Comparison {
    /// Compares the current settings with later edits of them, divided in the middle.
    pub(crate) fn new(display: &DisplaySettings) -> Self {
        Self { other: display.clone(), is_right_active: true, divider: 0.5, is_difference: false }
    }
}
