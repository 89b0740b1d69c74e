//! The formats of a report.

use super::report::Report;
use super::{html, json, latex, text};
use serde_json::Value;

impl Report<'_> {
    /// The ledger as plain text: the lighting equation with its numbers filled in.
    #[must_use]
    pub fn to_text(&self) -> String {
        text::page(self, false)
    }

    /// The text with colours, as escape sequences of ANSI terminals with 24-bit colour.
    #[must_use]
    pub fn to_colored_text(&self) -> String {
        text::page(self, true)
    }

    /// The ledger as a JSON document; its `Display` writes one line. Numbers have all their digits, so
    /// that they read back exactly and add up: emission, `scene_ambient`, the terms of the lights and
    /// `environment` give `sum`, fog gives `color`, weighted colours give `linear`, and those `rgba8`.
    ///
    /// Without [`with_unseen`](Self::with_unseen), `behind`, `culled` and `nearest` are null.
    #[must_use]
    pub fn to_json(&self) -> Value {
        json::document(self)
    }

    /// The ledger as a fragment of LaTeX, for a document with amsmath: the equation with its symbols,
    /// then with this pixel's numbers. Names are escaped.
    #[must_use]
    pub fn to_latex(&self) -> String {
        latex::fragment(self)
    }

    /// The ledger as a page of HTML: one file without scripts and without references, with the terms
    /// as bars, the vectors of each light, and the pictures of [`with_pictures`](Self::with_pictures).
    /// Names are escaped.
    #[must_use]
    pub fn to_html(&self) -> String {
        html::page(self)
    }
}
