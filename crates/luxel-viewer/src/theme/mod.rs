//! Colours of the viewer, type and spacing of the window: a dark and a light theme.

#[cfg(feature = "window")]
mod style;

use ecolor::Color32;
#[cfg(feature = "window")]
pub(crate) use style::of;

/// The colours of the viewer.
#[derive(Debug, PartialEq)]
pub(crate) struct Theme {
    /// Light text on dark panels.
    is_dark: bool,
    /// The background gradient behind the model, top and bottom: sRGB.
    pub(crate) background: [[u8; 3]; 2],
    pub(crate) panel: Color32,
    pub(crate) line: Color32,
    /// The ground grid.
    pub(crate) grid: Color32,
    pub(crate) text: Color32,
    pub(crate) quiet: Color32,
    /// Lights, selections, focus.
    pub(crate) accent: Color32,
    /// The accent as a text colour.
    pub(crate) heading: Color32,
    /// Text fields and slider tracks.
    pub(crate) field: Color32,
    button: Color32,
    /// Ambient, diffuse, specular, emission, environment.
    pub(crate) terms: [Color32; 5],
    /// N, L, V, R or H.
    pub(crate) vectors: [Color32; 4],
    /// The outline around overlay lines, for contrast with any colour.
    pub(crate) halo: Color32,
}

const fn rgb(hex: u32) -> Color32 {
    Color32::from_rgb((hex >> 16) as u8, (hex >> 8) as u8, hex as u8)
}

/// The dark theme.
pub(crate) static DARK: Theme = Theme {
    is_dark: true,
    background: [[0x23, 0x26, 0x2b], [0x15, 0x17, 0x1a]],
    panel: rgb(0x1b1d21),
    line: rgb(0x34383f),
    grid: rgb(0x6b7078),
    text: rgb(0xe8e6e1),
    quiet: rgb(0x9a9c9f),
    accent: rgb(0xf2b84b),
    heading: rgb(0xf2b84b),
    field: rgb(0x15171a),
    button: rgb(0x26292e),
    terms: [rgb(0x7d8ca3), rgb(0x5aa9e6), rgb(0xf2f2f2), rgb(0xf28f5a), rgb(0xa3b5a6)],
    vectors: [rgb(0x6fd3c7), rgb(0xf2b84b), rgb(0xc9a2f2), rgb(0xf27fb2)],
    halo: Color32::from_black_alpha(130),
};

/// The light theme: terms and vectors are darker by a third.
pub(crate) static LIGHT: Theme = Theme {
    is_dark: false,
    background: [[0xf4, 0xf2, 0xee], [0xde, 0xda, 0xd2]],
    panel: rgb(0xfbfaf7),
    line: rgb(0xd8d4cb),
    grid: rgb(0x9b968b),
    text: rgb(0x24262a),
    quiet: rgb(0x6c6e72),
    accent: rgb(0xb87400),
    // The accent itself has too little contrast for text.
    heading: rgb(0x8f5a00),
    field: rgb(0xeeece6),
    button: rgb(0xece9e2),
    terms: [rgb(0x535d6d), rgb(0x3c7199), rgb(0xa1a1a1), rgb(0xa15f3c), rgb(0x6d796f)],
    vectors: [rgb(0x4a8d85), rgb(0xa17b32), rgb(0x866ca1), rgb(0xa15577)],
    halo: Color32::from_rgba_premultiplied(150, 150, 150, 150),
};

/// x, y and z, in both themes.
pub(crate) const AXES: [Color32; 3] = [rgb(0xe5533d), rgb(0x6fb04a), rgb(0x4c82d8)];

/// The theme of a window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ThemeChoice {
    /// The system's theme, if known; else dark.
    #[default]
    Auto,
    /// Light text on dark panels.
    Dark,
    /// Dark text on light panels.
    Light,
}

impl ThemeChoice {
    /// Resolves the choice, given the system's preference.
    pub(crate) fn theme(self, system_is_light: Option<bool>) -> &'static Theme {
        match self {
            Self::Auto if system_is_light == Some(true) => &LIGHT,
            Self::Light => &LIGHT,
            Self::Auto | Self::Dark => &DARK,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// WCAG 2.1, section 1.4.3.
    fn contrast(a: Color32, b: Color32) -> f64 {
        let luminance = |color: Color32| {
            let [r, g, b, _] = ecolor::Rgba::from(color).to_array().map(f64::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn text_contrasts_with_its_background() {
        for theme in [&DARK, &LIGHT] {
            for text in [theme.text, theme.quiet, theme.heading] {
                for ground in [theme.panel, theme.field] {
                    let contrast = contrast(text, ground);
                    assert!(contrast >= 4.3, "{text:?} on {ground:?}: {contrast}");
                }
                assert!(contrast(text, theme.panel) >= 4.5, "{text:?}");
            }
        }
    }

    #[test]
    fn an_unknown_system_theme_gives_the_dark_theme() {
        assert_eq!(ThemeChoice::Auto.theme(None), &DARK);
        assert_eq!(ThemeChoice::Auto.theme(Some(true)), &LIGHT);
        assert_eq!(ThemeChoice::Dark.theme(Some(true)), &DARK);
        assert_eq!(ThemeChoice::Light.theme(None), &LIGHT);
    }
}
