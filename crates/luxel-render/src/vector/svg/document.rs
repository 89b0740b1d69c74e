//! The document: the background, and what is painted in the silhouette.

use super::paint::{Area, Silhouette};
use super::path;
use super::web::Color;
use crate::resolve::bytes_of;
use luxel_lighting::PictureEncoding;
use luxel_view::{Background, View};
use std::fmt::Write;

/// How wide the lines along outlines are, in pixels: half of it lies outside, and a pixel is up to 1.4
/// across.
const RIM: u32 = 3;

/// A document being written.
#[derive(Default)]
pub(super) struct Document {
    rims: String,
    areas: String,
    /// How many paths there are, and how many of them are opaque areas.
    pub(super) paths: usize,
    opaque: usize,
}

impl Document {
    /// Paints an area over all that is there.
    pub(super) fn area(&mut self, area: &Area) {
        let data = path::data(&area.outlines, true);
        if data.is_empty() {
            return;
        }
        let alpha = area.color[3] / 255.0;
        let rgb = hex(bytes(area.color));
        let _ = write!(self.areas, "<path fill=\"{rgb}\"");
        opacity(&mut self.areas, alpha);
        let _ = writeln!(self.areas, " d=\"{data}\"/>");
        self.paths += 1;
        self.opaque += usize::from(PictureEncoding::None.byte(alpha) == 255);
        let data = path::data(&area.rims, false);
        if !data.is_empty() {
            let _ = writeln!(self.rims, "<path stroke=\"{rgb}\" d=\"{data}\"/>");
        }
    }

    /// The text; areas are cut out by a silhouette if there are several, or else by themselves.
    pub(super) fn finish(self, view: &View, silhouette: &Silhouette) -> String {
        let Self { rims, areas, opaque, .. } = self;
        let mut text = head(view);
        let shape = path::data(&silhouette.opaque, true);
        if opaque < 2 || shape.is_empty() {
            text.push_str(&areas);
        } else {
            // What lets light through is neither cut nor filled.
            let glass = path::data(&silhouette.glass, true);
            let (width, height) = (view.size.width, view.size.height);
            let id = name(&shape);
            let _ = write!(
                text,
                "<mask id=\"{id}\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\" width=\"{width}\" \
                 height=\"{height}\"><path fill=\"#fff\" d=\"{shape}\"/>"
            );
            if !glass.is_empty() {
                let _ = write!(
                    text,
                    "<path fill=\"#fff\" stroke=\"#fff\" stroke-width=\"{RIM}\" d=\"{glass}\"/>"
                );
            }
            let below = hex(bytes(silhouette.color));
            let _ = write!(
                text,
                "</mask>\n<g mask=\"url(#{id})\">\n<path fill=\"{below}\" d=\"{shape}\"/>\n<g \
                 fill=\"none\" stroke-width=\"{RIM}\" stroke-linecap=\"round\" \
                 stroke-linejoin=\"round\">\n{rims}</g>\n{areas}</g>\n"
            );
        }
        text.push_str("</svg>\n");
        text
    }
}

/// A name that differs where shapes do, as pages hold several documents in one space of names: by
/// Fowler, Noll and Vo.
fn name(shape: &str) -> String {
    let hash = shape.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    });
    format!("s{hash:016x}")
}

fn bytes(color: Color) -> [u8; 3] {
    [0, 1, 2].map(|channel| color[channel].round() as u8)
}

/// The beginning of the document, with the background.
fn head(view: &View) -> String {
    let (width, height) = (view.size.width, view.size.height);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n"
    );
    let bytes = |down: f32| bytes_of(view.background.color(down), view.encoding);
    let [r, g, b, alpha] = bytes(0.0);
    let fill = match view.background {
        Background::Flat(_) => hex([r, g, b]),
        Background::Studio => {
            text.push_str("<linearGradient id=\"studio\" x2=\"0\" y2=\"1\">\n");
            for stop in 0..=STOPS {
                let down = f32::from(stop) / f32::from(STOPS);
                let [r, g, b, _] = bytes(down);
                let _ =
                    writeln!(text, "<stop offset=\"{down}\" stop-color=\"{}\"/>", hex([r, g, b]));
            }
            text.push_str("</linearGradient>\n");
            "url(#studio)".to_owned()
        }
    };
    if alpha > 0 {
        let _ = write!(text, "<rect width=\"{width}\" height=\"{height}\" fill=\"{fill}\"");
        opacity(&mut text, view.background.color(0.0)[3].clamp(0.0, 1.0));
        text.push_str("/>\n");
    }
    text
}

/// The steps of a gradient in linear light, which programs mix in sRGB between them.
const STOPS: u8 = 4;

/// The attribute of what isn't opaque.
fn opacity(text: &mut String, alpha: f32) {
    if PictureEncoding::None.byte(alpha) < 255 {
        text.push_str(" fill-opacity=\"");
        path::number(text, (f64::from(alpha) * 100.0).round() as i64);
        text.push('"');
    }
}

/// A colour as short as can be.
fn hex(rgb: [u8; 3]) -> String {
    if rgb.iter().all(|byte| byte / 16 == byte % 16) {
        let [r, g, b] = rgb.map(|byte| byte % 16);
        format!("#{r:x}{g:x}{b:x}")
    } else {
        let [r, g, b] = rgb;
        format!("#{r:02x}{g:02x}{b:02x}")
    }
}
