//! The side panels: the tree of objects, and the tabs of settings.

mod controls;
mod explain;
mod light;
mod material;
mod tree;
mod view;

use super::UiCommand;
use super::focus;
use super::icons::{self, Icon};
use crate::keys::Keys;
use crate::render::ExplainedPixel;
use crate::session::Session;
use crate::theme;
use egui::{Context, Frame, Margin};
use luxel::report::{LedgerLine, ledger_lines};
use std::ops::Range;
pub(crate) use tree::tree;

/// A tab of the settings panel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tab {
    #[default]
    Light,
    Explain,
    View,
}

/// A side panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// The tree of objects.
    Tree,
    /// The tabs.
    Settings,
}

/// Which panels are shown: any, the tab, and the unfolded side of a narrow window.
pub(crate) type PanelLayout = (bool, Tab, Option<Side>);

/// The state of the panels.
#[derive(Debug)]
pub(crate) struct PanelState {
    pub(crate) is_shown: bool,
    /// The text of the tree's search field.
    pub(crate) search: String,
    /// The selected object that the tree last scrolled to.
    pub(crate) scrolled_to: Option<usize>,
    /// The visible range of the tree, in points.
    pub(crate) visible_rows: Range<f32>,
    pub(crate) tab: Tab,
    /// The unfolded panel of a narrow window.
    pub(crate) unfolded: Option<Side>,
    /// Whether the window is too narrow for both panels.
    pub(crate) is_narrow: bool,
    /// The light whose settings are open.
    pub(crate) chosen_light: Option<usize>,
    /// Whether the first control takes keyboard focus in the next pass.
    pub(crate) wants_focus: bool,
    /// The explanation of the pixel under the pointer.
    pub(crate) explanation: Option<Box<ExplainedPixel>>,
    /// The same as the lighting equation with its values.
    pub(crate) equation: Option<Vec<LedgerLine>>,
}

impl Default for PanelState {
    fn default() -> Self {
        Self {
            is_shown: false,
            search: String::new(),
            scrolled_to: None,
            visible_rows: 0.0..f32::MAX,
            tab: Tab::default(),
            unfolded: None,
            is_narrow: false,
            chosen_light: Some(0),
            wants_focus: false,
            explanation: None,
            equation: None,
        }
    }
}

impl PanelState {
    /// The layout, to be restored later.
    pub(crate) fn layout(&self) -> PanelLayout {
        (self.is_shown, self.tab, self.unfolded)
    }

    /// Restores a layout.
    pub(crate) fn set_layout(&mut self, layout: PanelLayout) {
        (self.is_shown, self.tab, self.unfolded) = layout;
    }

    /// Shows the explanation of the pixel under the pointer, or hides the panels.
    pub(crate) fn toggle_explanation(&mut self) {
        self.is_shown = !self.shows_explanation();
        self.tab = Tab::Explain;
        self.unfolded = self.is_shown.then_some(Side::Settings);
    }

    /// Folds the unfolded panel of a narrow window, else hides the panels; false if there are none.
    pub(crate) fn close_innermost(&mut self) -> bool {
        if self.is_narrow && self.is_shown && self.unfolded.take().is_some() {
            return true;
        }
        std::mem::take(&mut self.is_shown)
    }

    /// Shows the panels, and moves keyboard focus to their first control.
    pub(crate) fn focus_first(&mut self) {
        self.is_shown = true;
        self.wants_focus = true;
        self.unfolded.get_or_insert(Side::Settings);
    }

    /// Whether the tree is shown.
    pub(crate) fn shows_tree(&self) -> bool {
        self.is_shown && (!self.is_narrow || self.unfolded == Some(Side::Tree))
    }

    /// Whether the settings are shown.
    pub(crate) fn shows_settings(&self) -> bool {
        self.is_shown && (!self.is_narrow || self.unfolded == Some(Side::Settings))
    }

    /// Whether the explanation of a pixel is shown.
    pub(crate) fn shows_explanation(&self) -> bool {
        self.shows_settings() && self.tab == Tab::Explain
    }

    /// Replaces the explanation of the pixel under the pointer.
    pub(crate) fn set_explanation(&mut self, explanation: Option<Box<ExplainedPixel>>) {
        self.equation = explanation.as_ref().and_then(|pixel| {
            let display = &pixel.explanation.display;
            pixel.surface().map(|surface| ledger_lines(surface, display))
        });
        self.explanation = explanation;
    }
}

/// The panels' widths, in points, and the width of the picture that a narrow window keeps free.
const TREE_WIDTH: f32 = 240.0;
const SETTINGS_WIDTH: f32 = 288.0;
const FREE_WIDTH: f32 = 64.0;

/// The margins left and right of a panel's content.
const MARGINS: f32 = 24.0;
/// The width of the icons of a narrow window.
const FOLDED_WIDTH: f32 = icons::SIDE + 8.0;
/// In narrower windows panels fold to icons, and one unfolds at a time.
const ROOM_FOR_BOTH: f32 = 900.0;

impl PanelState {
    /// Folds the panels in a narrow window.
    pub(crate) fn fold_if_narrow(&mut self, window_width: f32) {
        self.is_narrow = window_width < ROOM_FOR_BOTH;
    }

    /// A panel's width, limited by the window's.
    fn width(&self, width: f32, window_width: f32) -> f32 {
        let folded = if self.is_narrow { FOLDED_WIDTH } else { 0.0 };
        width.min((window_width - folded - FREE_WIDTH).max(FREE_WIDTH))
    }

    /// What the panels cover of a window, from its left and from its right.
    pub(crate) fn covered(&self, window_width: f32) -> [f32; 2] {
        let tree = if self.shows_tree() { self.width(TREE_WIDTH, window_width) } else { 0.0 };
        let settings =
            if self.shows_settings() { self.width(SETTINGS_WIDTH, window_width) } else { 0.0 };
        if self.is_narrow {
            let folded = if self.is_shown { FOLDED_WIDTH } else { 0.0 };
            [0.0, folded + tree + settings]
        } else {
            [tree, settings]
        }
    }
}

fn frame(context: &Context) -> Frame {
    // The bars of scroll areas stand in the right margin.
    let margin = Margin { right: 4, ..Margin::same(12) };
    Frame::new().fill(theme::of(context).panel).inner_margin(margin)
}

/// The panels folded to icons at the right of a narrow window.
pub(crate) fn folded(state: &mut PanelState, context: &Context) {
    let frame = Frame::new().fill(theme::of(context).panel).inner_margin(Margin::same(4));
    let panel = egui::SidePanel::right("folded").frame(frame).show_separator_line(false);
    panel.resizable(false).exact_width(FOLDED_WIDTH).show(context, |panel| {
        panel.spacing_mut().item_spacing.y = 4.0;
        let all = [
            (Icon::Objects, "objects", None),
            (Icon::Light, "light", Some(Tab::Light)),
            (Icon::Explain, "explain", Some(Tab::Explain)),
            (Icon::View, "view", Some(Tab::View)),
        ];
        for (icon, name, tab) in all {
            let side = if tab.is_some() { Side::Settings } else { Side::Tree };
            let is_on = state.unfolded == Some(side) && tab.is_none_or(|tab| tab == state.tab);
            let button = icons::button(panel, icon, name, is_on);
            if icon == Icon::Objects
                && state.unfolded.is_none()
                && std::mem::take(&mut state.wants_focus)
            {
                button.request_focus();
            }
            if button.clicked() {
                state.unfolded = (!is_on).then_some(side);
                state.tab = tab.unwrap_or(state.tab);
            }
        }
    });
}

/// The tabs: light and materials, explanation, view.
pub(crate) fn settings(
    state: &mut PanelState,
    context: &Context,
    session: &mut Session,
    keys: &Keys,
    commands: &mut Vec<UiCommand>,
) {
    let panel = egui::SidePanel::right("settings").frame(frame(context)).show_separator_line(false);
    let width = state.width(SETTINGS_WIDTH, context.content_rect().width());
    panel.resizable(false).exact_width(width).show(context, |panel| {
        panel.horizontal(|panel| {
            let first = panel.selectable_value(&mut state.tab, Tab::Light, "Light");
            if std::mem::take(&mut state.wants_focus) {
                first.request_focus();
            }
            panel.selectable_value(&mut state.tab, Tab::Explain, "Explain");
            panel.selectable_value(&mut state.tab, Tab::View, "View");
        });
        panel.add_space(8.0);
        let area = focus::scrolled(panel).auto_shrink([false, false]);
        area.show(panel, |panel| {
            panel.set_max_width((width - MARGINS).max(0.0));
            match state.tab {
                Tab::Light => {
                    light::lights(panel, session, &mut state.chosen_light);
                    light::environment(panel, session);
                    material::materials(panel, session);
                }
                Tab::Explain => {
                    let equation = state.equation.as_deref();
                    explain::explanation(panel, session, state.explanation.as_deref(), equation);
                }
                Tab::View => view::view(panel, session, keys, commands),
            }
            focus::follow(panel);
        });
    });
}
