//! Colours, type and spacing of the window.

use egui::{Color32, CornerRadius, FontFamily, FontId, Stroke, Style, TextStyle, Visuals};

/// The ground behind the model, from the window's top to its bottom: sRGB.
pub(crate) const GROUND: [[u8; 3]; 2] = [[0x23, 0x26, 0x2b], [0x15, 0x17, 0x1a]];

pub(crate) const PANEL: Color32 = Color32::from_rgb(0x1b, 0x1d, 0x21);
pub(crate) const LINE: Color32 = Color32::from_rgb(0x34, 0x38, 0x3f);
pub(crate) const TEXT: Color32 = Color32::from_rgb(0xe8, 0xe6, 0xe1);
pub(crate) const QUIET: Color32 = Color32::from_rgb(0x9a, 0x9c, 0x9f);
pub(crate) const ACCENT: Color32 = Color32::from_rgb(0xf2, 0xb8, 0x4b);
/// x, y and z.
pub(crate) const AXES: [Color32; 3] = [
    Color32::from_rgb(0xe5, 0x53, 0x3d),
    Color32::from_rgb(0x6f, 0xb0, 0x4a),
    Color32::from_rgb(0x4c, 0x82, 0xd8),
];

/// Ambient, diffuse, specular, emission, environment.
pub(crate) const TERMS: [Color32; 5] = [
    Color32::from_rgb(0x7d, 0x8c, 0xa3),
    Color32::from_rgb(0x5a, 0xa9, 0xe6),
    Color32::from_rgb(0xf2, 0xf2, 0xf2),
    Color32::from_rgb(0xf2, 0x8f, 0x5a),
    Color32::from_rgb(0xa3, 0xb5, 0xa6),
];
/// N, L, V.
pub(crate) const VECTORS: [Color32; 3] = [
    Color32::from_rgb(0x6f, 0xd3, 0xc7),
    Color32::from_rgb(0xf2, 0xb8, 0x4b),
    Color32::from_rgb(0xc9, 0xa2, 0xf2),
];

/// Words in 13 points, notes in 11; steps of 4 points; nothing moves by itself.
pub(crate) fn style() -> Style {
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
    style.visuals = visuals();
    style
}

fn visuals() -> Visuals {
    let mut visuals = Visuals::dark();
    visuals.panel_fill = PANEL;
    visuals.window_fill = PANEL;
    visuals.window_stroke = Stroke::NONE;
    visuals.extreme_bg_color = Color32::from_rgb(0x15, 0x17, 0x1a);
    visuals.override_text_color = Some(TEXT);
    visuals.selection.bg_fill = ACCENT.gamma_multiply(0.28);
    visuals.selection.stroke = Stroke::new(1.0, ACCENT);
    visuals.window_shadow = egui::Shadow::NONE;
    visuals.popup_shadow = egui::Shadow::NONE;
    visuals.window_corner_radius = CornerRadius::same(4);
    visuals.menu_corner_radius = CornerRadius::same(4);
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
    widgets.noninteractive.bg_stroke = Stroke::new(1.0, LINE);
    widgets.inactive.weak_bg_fill = Color32::from_rgb(0x26, 0x29, 0x2e);
    widgets.inactive.bg_fill = Color32::from_rgb(0x26, 0x29, 0x2e);
    widgets.hovered.weak_bg_fill = LINE;
    widgets.hovered.bg_stroke = Stroke::NONE;
    widgets.active.weak_bg_fill = LINE;
    visuals
}
