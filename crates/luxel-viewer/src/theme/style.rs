//! Type and spacing of the window's panels.

use super::{DARK, LIGHT, Theme};
use crate::number::number;
use egui::style::NumberFormatter;
use egui::{Context, CornerRadius, FontFamily, FontId, Stroke, Style, TextStyle, Visuals};

/// The theme of a layout.
pub(crate) fn of(context: &Context) -> &'static Theme {
    if context.style().visuals.dark_mode { &DARK } else { &LIGHT }
}

impl Theme {
    /// Text of 13 points, notes of 11; spacing in steps of 4 points; no animations.
    pub(crate) fn style(&self) -> Style {
        let mut style = Style::default();
        let font = |size, family| FontId::new(size, family);
        style.text_styles = [
            (TextStyle::Heading, font(13.0, FontFamily::Proportional)),
            (TextStyle::Body, font(13.0, FontFamily::Proportional)),
            (TextStyle::Button, font(13.0, FontFamily::Proportional)),
            (TextStyle::Small, font(11.0, FontFamily::Proportional)),
            (TextStyle::Monospace, font(12.0, FontFamily::Monospace)),
        ]
        .into();
        style.spacing.item_spacing = egui::vec2(8.0, 4.0);
        style.spacing.button_padding = egui::vec2(8.0, 4.0);
        style.spacing.interact_size.y = 24.0;
        style.animation_time = 0.0;
        style.scroll_animation = egui::style::ScrollAnimation::none();
        // Labels aren't controls.
        style.interaction.selectable_labels = false;
        // Bars cover nothing.
        style.spacing.scroll.floating_allocated_width = 8.0;
        // In fields and beside sliders.
        style.number_formatter = NumberFormatter::new(|value, _| number(value));
        style.visuals = self.visuals();
        style
    }

    fn visuals(&self) -> Visuals {
        let mut visuals = if self.is_dark { Visuals::dark() } else { Visuals::light() };
        visuals.panel_fill = self.panel;
        visuals.window_fill = self.panel;
        visuals.window_stroke = Stroke::new(1.0, self.line);
        visuals.extreme_bg_color = self.field;
        visuals.override_text_color = Some(self.text);
        visuals.selection.bg_fill = self.accent.gamma_multiply(0.28);
        visuals.selection.stroke = Stroke::new(1.0, self.accent);
        visuals.window_shadow = egui::Shadow::NONE;
        visuals.popup_shadow = egui::Shadow::NONE;
        visuals.window_corner_radius = CornerRadius::same(4);
        visuals.menu_corner_radius = CornerRadius::same(4);
        visuals.slider_trailing_fill = true;
        let widgets = &mut visuals.widgets;
        for widget in [
            &mut widgets.noninteractive,
            &mut widgets.inactive,
            &mut widgets.hovered,
            &mut widgets.active,
            &mut widgets.open,
        ] {
            widget.corner_radius = CornerRadius::same(4);
            widget.expansion = 0.0;
        }
        widgets.noninteractive.bg_stroke = Stroke::new(1.0, self.line);
        widgets.inactive.weak_bg_fill = self.button;
        widgets.inactive.bg_fill = self.button;
        widgets.hovered.weak_bg_fill = self.line;
        widgets.hovered.bg_fill = self.line;
        widgets.hovered.bg_stroke = Stroke::NONE;
        widgets.active.weak_bg_fill = self.line;
        widgets.active.bg_fill = self.line;
        // Marks keyboard focus.
        widgets.active.bg_stroke = Stroke::new(1.0, self.accent);
        widgets.open.weak_bg_fill = self.line;
        visuals
    }
}
