//! Plots and diagrams as SVG, in the colours of the page, in dark and in light.

use luxel::scene::Size;
use std::fmt::Write;

/// A drawing; coordinates are pixels from the upper left.
pub(crate) struct Svg {
    pub(crate) size: Size,
    body: String,
}

/// A colour of a series, by its meaning in luxel's other images. Each is a class of the
/// style sheet, which knows it in dark and in light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ink {
    Text,
    Quiet,
    Line,
    Amber,
    Blue,
    Pink,
    Teal,
    Violet,
    Orange,
}

impl Ink {
    /// Distinguishable colours of lines, in order.
    pub(crate) const SERIES: [Self; 6] =
        [Self::Blue, Self::Amber, Self::Pink, Self::Teal, Self::Violet, Self::Orange];

    fn class(self) -> &'static str {
        match self {
            Self::Text => "t",
            Self::Quiet => "q",
            Self::Line => "l",
            Self::Amber => "a",
            Self::Blue => "b",
            Self::Pink => "p",
            Self::Teal => "e",
            Self::Violet => "v",
            Self::Orange => "o",
        }
    }
}

/// The alignment of a text to its position.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// Each colour, in light and in dark; all have a contrast of at least 4.5 : 1 to the panel.
const STYLE: &str = "\
text{font:13px system-ui,-apple-system,'Segoe UI',Roboto,sans-serif}\
.n{font:11px ui-monospace,'SF Mono',Menlo,Consolas,monospace}\
.s{fill:none;stroke-linejoin:round;stroke-linecap:round}\
.f{stroke:none}.g{fill:#fbfaf7}\
.t{color:#24262a}.q{color:#63656a}.l{color:#c9c4b9}.a{color:#875900}.b{color:#2f6a95}\
.p{color:#a04c74}.e{color:#2b6f67}.v{color:#77559b}.o{color:#9d5430}\
.s{stroke:currentColor}.f,text{fill:currentColor}\
@media(prefers-color-scheme:dark){.g{fill:#1b1d21}\
.t{color:#e8e6e1}.q{color:#9a9c9f}.l{color:#3d4148}.a{color:#f2b84b}.b{color:#5aa9e6}\
.p{color:#f27fb2}.e{color:#6fd3c7}.v{color:#c9a2f2}.o{color:#f28f5a}}";

impl Svg {
    pub(crate) fn new(width: u32, height: u32) -> Self {
        Self { size: Size { width, height }, body: String::new() }
    }

    /// A line through points.
    pub(crate) fn line(&mut self, ink: Ink, width: f64, points: &[[f64; 2]]) {
        self.path(ink, width, points, "");
    }

    /// A dashed line through points.
    pub(crate) fn dashed(&mut self, ink: Ink, width: f64, points: &[[f64; 2]]) {
        self.path(ink, width, points, " stroke-dasharray=\"4 4\"");
    }

    fn path(&mut self, ink: Ink, width: f64, points: &[[f64; 2]], more: &str) {
        let [class, data] = [ink.class().to_owned(), path(points)];
        let _ = writeln!(
            self.body,
            "<path class=\"s {class}\" stroke-width=\"{}\"{more} d=\"{data}\"/>",
            number(width)
        );
    }

    /// A filled area; `opacity` from 0 to 1.
    pub(crate) fn area(&mut self, ink: Ink, opacity: f64, points: &[[f64; 2]]) {
        let _ = writeln!(
            self.body,
            "<path class=\"f {}\" opacity=\"{}\" d=\"{}Z\"/>",
            ink.class(),
            number(opacity),
            path(points)
        );
    }

    /// A filled disc.
    pub(crate) fn dot(&mut self, ink: Ink, radius: f64, [x, y]: [f64; 2]) {
        let [x, y, r] = [x, y, radius].map(number);
        let class = ink.class();
        let _ =
            writeln!(self.body, "<circle class=\"f {class}\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>");
    }

    /// An arrow from one place to another.
    pub(crate) fn arrow(&mut self, ink: Ink, width: f64, from: [f64; 2], to: [f64; 2]) {
        let way = [to[0] - from[0], to[1] - from[1]];
        let length = libm::hypot(way[0], way[1]).max(1e-9);
        let unit = way.map(|part| part / length);
        let head = (3.0 + 2.0 * width).min(length);
        let back = [to[0] - unit[0] * head, to[1] - unit[1] * head];
        let aside = [-unit[1] * head * 0.4, unit[0] * head * 0.4];
        self.line(ink, width, &[from, back]);
        self.area(
            ink,
            1.0,
            &[
                to,
                [back[0] + aside[0], back[1] + aside[1]],
                [back[0] - aside[0], back[1] - aside[1]],
            ],
        );
    }

    /// A word or two.
    pub(crate) fn text(&mut self, ink: Ink, anchor: Anchor, at: [f64; 2], text: &str) {
        self.words(ink.class(), anchor, at, text);
    }

    /// A number.
    pub(crate) fn note(&mut self, ink: Ink, anchor: Anchor, at: [f64; 2], text: &str) {
        self.words(&format!("n {}", ink.class()), anchor, at, text);
    }

    fn words(&mut self, class: &str, anchor: Anchor, [x, y]: [f64; 2], text: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let [x, y] = [x, y].map(number);
        let text = escaped(text);
        let _ = writeln!(
            self.body,
            "<text class=\"{class}\" x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\">{text}</text>"
        );
    }

    /// The file; `title` describes the drawing.
    pub(crate) fn finish(self, title: &str) -> Vec<u8> {
        let Size { width, height } = self.size;
        let (body, title) = (self.body, escaped(title));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" role=\"img\">\n<title>{title}</title>\n\
             <style>{STYLE}</style>\n<rect class=\"g\" width=\"{width}\" height=\"{height}\" \
             rx=\"4\"/>\n{body}</svg>\n"
        )
        .into_bytes()
    }
}

/// Coordinates in tenths of a pixel.
fn number(value: f64) -> String {
    let text = format!("{value:.1}");
    match text.strip_suffix(".0") {
        // Not "-0".
        Some("-0") => "0".to_owned(),
        Some(whole) => whole.to_owned(),
        None if value.abs() < 0.95 => format!("{value:.2}"),
        None => text,
    }
}

fn path(points: &[[f64; 2]]) -> String {
    let mut data = String::new();
    for (place, point) in points.iter().enumerate() {
        let [x, y] = point.map(number);
        let _ = write!(data, "{}{x} {y}", if place == 0 { 'M' } else { 'L' });
    }
    data
}

/// A text as XML and HTML take it.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A rectangle of a drawing in which x and y have a scale.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axes {
    /// Left, top, right, bottom in pixels.
    pub(crate) frame: [f64; 4],
    /// The values at left and right.
    pub(crate) x: [f64; 2],
    /// The values at bottom and top.
    pub(crate) y: [f64; 2],
}

impl Axes {
    /// Where values lie.
    pub(crate) fn at(&self, x: f64, y: f64) -> [f64; 2] {
        let [left, top, right, bottom] = self.frame;
        let part = |value: f64, [from, to]: [f64; 2]| (value - from) / (to - from);
        [
            left + (right - left) * part(x, self.x),
            bottom + (top - bottom) * part(y, self.y).clamp(-0.02, 1.02),
        ]
    }

    /// A curve through values.
    pub(crate) fn curve(&self, svg: &mut Svg, ink: Ink, width: f64, values: &[[f64; 2]]) {
        let points: Vec<_> = values.iter().map(|&[x, y]| self.at(x, y)).collect();
        svg.line(ink, width, &points);
    }

    /// The left and the lower axis with ticks and names.
    pub(crate) fn draw(
        &self,
        svg: &mut Svg,
        x_ticks: &[(f64, &str)],
        y_ticks: &[(f64, &str)],
        [x_name, y_name]: [&str; 2],
    ) {
        let [left, top, right, bottom] = self.frame;
        svg.line(Ink::Line, 1.0, &[[left, top], [left, bottom], [right, bottom]]);
        for (value, name) in x_ticks {
            let [x, _] = self.at(*value, self.y[0]);
            svg.line(Ink::Line, 1.0, &[[x, bottom], [x, bottom + 4.0]]);
            svg.note(Ink::Quiet, Anchor::Middle, [x, bottom + 16.0], name);
        }
        for (value, name) in y_ticks {
            let [_, y] = self.at(self.x[0], *value);
            svg.line(Ink::Line, 1.0, &[[left - 4.0, y], [left, y]]);
            svg.note(Ink::Quiet, Anchor::End, [left - 7.0, y + 4.0], name);
        }
        if !x_name.is_empty() {
            svg.text(Ink::Quiet, Anchor::End, [right, bottom + 32.0], x_name);
        }
        svg.text(Ink::Quiet, Anchor::Start, [left - 4.0, top - 9.0], y_name);
    }
}
