//! The ledger as a page of HTML: one file without script, readable on a phone.

mod bar;
mod escape;
mod figure;
mod pictures;
mod rays;

use super::report::Report;
use super::sentences::{encoded, nearest, part_of, point_name, share, surface_path, why_not_seen};
use crate::equation::{
    Factor, Interpolation, LightEntry, PartTerm, ShadingPoint, Term, TermKind, clamp_range,
    ground_facts, highlight_vector, in_the_way, point_terms, reach, shading_points,
};
use crate::words::{capital, color, in_column, model_name, number, vector};
use escape::escaped;
use luxel_lighting::{Display, PictureEncoding, Tone};
use luxel_render::{ExplainedSample, ExplainedSurface, Explanation, Seen};
use std::fmt::{self, Write};

const STYLE: &str = include_str!("html/style.css");

/// The page.
pub(crate) fn page(report: &Report<'_>) -> String {
    let mut page = Page { text: String::new() };
    page.head(report);
    if let Some(pictures) = report.pictures {
        page.push(pictures::figures(pictures, report));
    }
    for (index, entry) in report.explanation.samples.iter().enumerate() {
        page.sample(index, entry, report);
    }
    page.pixel(report);
    page.push("</main>\n</html>\n");
    page.text
}

struct Page {
    text: String,
}

impl Page {
    fn push(&mut self, text: impl fmt::Display) {
        // Writing into a string can't fail.
        let _ = write!(self.text, "{text}");
    }

    fn head(&mut self, report: &Report<'_>) {
        let Explanation { pixel: [x, y], position, rgba8: [r, g, b, alpha], .. } =
            report.explanation;
        let place = match position {
            Some([x, y]) => format!("point {x}, {y}"),
            None => format!("pixel {x}, {y}"),
        };
        let model = escaped(report.model);
        self.push(format_args!(
            "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"dark light\">\n\
             <title>{place} of {model}, explained</title>\n<style>\n{STYLE}</style>\n<main>\n\
             <header>\n<div class=\"patch\"><i style=\"background:rgb({r} {g} {b} / {:.3})\"></i></div>\n\
             <div><h1>Why {place} of {model} has its colour</h1>\n\
             <p class=\"num\">#{r:02x}{g:02x}{b:02x} <span class=\"quiet\">red {r}, green {g}, blue {b}, \
             alpha {alpha}</span></p></div>\n</header>\n",
            f32::from(*alpha) / 255.0,
        ));
    }

    fn sample(&mut self, index: usize, entry: &ExplainedSample, report: &Report<'_>) {
        self.push("<section>\n");
        let layers = entry.seen.len();
        for (depth, seen) in entry.seen.iter().enumerate() {
            let which = match (depth, layers) {
                (0, 1) => format!("{} sees", share(entry)),
                (0, _) => format!("{} sees first", share(entry)),
                _ => "and behind it".to_owned(),
            };
            match seen {
                Seen::Background { color: behind, alpha, ground } => {
                    let what = if ground.is_some() { "the ground" } else { "the background" };
                    self.push(format_args!(
                        "<h2>{} {what}</h2>\n<p class=\"num\">{}, alpha {alpha}</p>\n",
                        capital(&which),
                        color(*behind)
                    ));
                    for (label, fact) in ground.iter().flat_map(|ground| ground_facts(ground)) {
                        let (label, fact) = (escaped(&capital(&label)), escaped(&fact));
                        self.push(format_args!("<p class=\"num\">{label}: {fact}</p>\n"));
                    }
                }
                Seen::Surface(surface) => {
                    self.surface(&which, surface, report);
                    if layers > 1 {
                        let alpha = number(surface.alpha);
                        self.push(format_args!("<p class=\"num\">alpha {alpha}</p>\n"));
                    }
                }
            }
        }
        if layers > 1 {
            self.push("<h3>Together</h3>\n<div class=\"rows\">\n");
            let note = format!("Σ t α C / α, t what comes through all before; α {}", entry.alpha);
            self.total("seen", entry.display, TermKind::Sum, &note);
            self.push("</div>\n");
        }
        let mut sentences = why_not_seen(index, report);
        sentences.extend(nearest(report).map(|text| ("empty", text)));
        if !sentences.is_empty() {
            self.push("<h3>Not visible here</h3>\n<dl>\n");
            for (label, text) in sentences {
                self.push(format_args!("<dt>{label}</dt><dd>{}</dd>\n", escaped(&text)));
            }
            self.push("</dl>\n");
        }
        self.push("</section>\n");
    }

    fn surface(&mut self, which: &str, surface: &ExplainedSurface, report: &Report<'_>) {
        let path = escaped(&surface_path(surface, report.scene));
        let part = part_of(surface.triangle);
        let [x, y, z] = surface.position.map(|side| number(side as f32));
        let [a, b, c] = surface.barycentric.map(number);
        let material = &surface.material;
        let name = match material.name.as_str() {
            "" => String::new(),
            name => format!("{}, ", escaped(name)),
        };
        self.push(format_args!(
            "<h2>{} {part}<em>{path}</em></h2>\n<p class=\"quiet\">at <span class=\"num\">({x}, {y}, \
             {z})</span>, its corners weighing <span class=\"num\">{a}, {b}, {c}</span>; material \
             {name}{}</p>\n",
            capital(which),
            model_name(&material.constants.reflection),
        ));
        self.push(bar::terms(surface, &report.explanation.display));
        let points = shading_points(surface);
        for (at, point) in points.iter().enumerate() {
            match point.share {
                None => self.point(point),
                Some((weight, _)) => {
                    let name = point_name(at, points.len(), report);
                    let open = if at == 0 { " open" } else { "" };
                    self.push(format_args!(
                        "<details{open}>\n<summary>Lit at {name}, which weighs <span \
                         class=\"num\">{}</span></summary>\n",
                        number(weight)
                    ));
                    self.point(point);
                    self.push("</details>\n");
                }
            }
        }
        self.ending(surface, &points, &report.explanation.display);
    }

    /// The later steps of the light: interpolation, fog, exposure and tone curve.
    fn ending(
        &mut self,
        surface: &ExplainedSurface,
        points: &[ShadingPoint<'_>],
        display: &Display,
    ) {
        let Interpolation { parts, texture } = Interpolation::of(surface, points);
        if parts.is_empty() && surface.fog.is_none() && display.is_identity() {
            return;
        }
        self.push("<div class=\"rows\">\n");
        if !parts.is_empty() {
            let parts: Vec<_> = parts
                .iter()
                .map(|(weight, light)| format!("{} × {}", number(*weight), color(*light)))
                .collect();
            let note = match texture {
                Some(texture) => format!("({}) × texture {}", parts.join(" + "), color(texture)),
                None => parts.join(" + "),
            };
            self.total("interpolated", surface.sum, TermKind::Sum, &note);
        }
        if let Some((factor, fog)) = surface.fog {
            let note = format!(
                "s I + (1 − s) I<sub>dc</sub> = {} × I + {} × {}, {} along the view",
                number(factor),
                number(1.0 - factor),
                color(fog),
                number(surface.z)
            );
            self.total("in fog", surface.color, TermKind::Fog, &note);
        }
        if !display.is_identity() {
            let light = if surface.fog.is_some() { "I′" } else { "I" };
            let mut steps = Vec::new();
            if display.factor() != 1.0 {
                let (ev, factor) = (number(display.ev()), number(display.factor()));
                steps.push(format!("2<sup>{ev}</sup> {light} = {factor} {light}"));
            }
            if display.tone() != Tone::None {
                steps.push(format!("the tone curve {}", display.tone().name()));
            }
            self.total("as shown", surface.display, TermKind::Sum, &steps.join(", then "));
        }
        self.push("</div>\n");
    }

    /// One point: figures, equation, lights.
    fn point(&mut self, point: &ShadingPoint<'_>) {
        let at_point = point_terms(point);
        if !at_point.lights.is_empty() {
            self.push("<div class=\"figures\">\n");
            for light in &at_point.lights {
                self.push(figure::of_light(point, light));
            }
            self.push("</div>\n");
        }
        self.push(
            "<div class=\"rows\">\n<div class=\"row quiet head\"><span>term</span><span>red</span>\
             <span>green</span><span>blue</span><span class=\"eq\">as a product</span></div>\n",
        );
        for term in &at_point.own {
            self.term(term);
        }
        for light in &at_point.lights {
            self.light(light, point);
        }
        self.parts(&at_point.mirrors);
        for environment in &at_point.environment {
            self.term(environment);
        }
        self.total("sum, I", point.sum, TermKind::Sum, "");
        if let Some((_, light)) = point.share
            && light != point.sum
        {
            let range = clamp_range(point.sum, light);
            let note = format!("to {range}, as light is interpolated here");
            self.total("clamped", light, TermKind::Sum, &note);
        }
        self.push("</div>\n");
    }

    fn light(&mut self, entry: &LightEntry<'_>, point: &ShadingPoint<'_>) {
        let light = entry.light;
        let mut facts = format!(
            "{}, <b>N</b>·<b>L</b> = {}, <b>L</b> = {}",
            light.light.kind.name(),
            number(light.terms.n_dot_l),
            vector(light.terms.to_light.lane(0))
        );
        if let Some((name, highlight)) = highlight_vector(point, light) {
            let _ = write!(facts, ", <b>{name}</b> = {}", vector(highlight));
        }
        if let Some(reach) = reach(light) {
            let _ = write!(facts, ", {reach}");
        }
        self.push(format_args!(
            "<div class=\"light\"><strong>{}</strong> <span class=\"quiet num\">{facts}</span>",
            escaped(&light.name)
        ));
        if let Some(blocked) = in_the_way(light) {
            self.push(format_args!("<p class=\"why\">{}.</p>", escaped(&capital(&blocked))));
        }
        if let Some(why) = &entry.why_not {
            let what = if entry.terms.is_empty() { "no" } else { "no other" };
            self.push(format_args!("<p class=\"why\">Adds {what} light: {}.</p>", escaped(why)));
        }
        self.push("</div>\n");
        self.parts(&entry.parts);
        for term in &entry.terms {
            self.term(term);
        }
    }

    /// The parts of a mix, in quiet: only their sums are terms.
    fn parts(&mut self, parts: &[PartTerm]) {
        for PartTerm { of, term } in parts {
            let [r, g, b] = term.value.map(in_column);
            let symbols: Vec<_> = term.factors.iter().map(symbol).collect();
            let numbers: Vec<_> = term.factors.iter().map(numbers).collect();
            self.push(format_args!(
                "<div class=\"row part\"><span>{}</span><span>{r}</span><span>{g}</span>\
                 <span>{b}</span><span class=\"eq\">in {}: {}<br>= {}</span></div>\n",
                term.name,
                of.html,
                symbols.join(" "),
                numbers.join(" × ")
            ));
        }
    }

    fn term(&mut self, term: &Term) {
        let symbols: Vec<_> = term.factors.iter().map(symbol).collect();
        let numbers: Vec<_> = term.factors.iter().map(numbers).collect();
        let equation = format!("= {}<br>= {}", symbols.join(" "), numbers.join(" × "));
        self.total(term.name, term.value, term.kind, &equation);
    }

    /// A row of the table: label, three channels, and derivation (HTML).
    fn total(&mut self, name: &str, value: [f32; 3], kind: TermKind, equation: &str) {
        let [r, g, b] = value.map(in_column);
        let total = if kind == TermKind::Sum { " total" } else { "" };
        self.push(format_args!(
            "<div class=\"row{total}\"><span><i class=\"{}\"></i>{name}</span><span>{r}</span>\
             <span>{g}</span><span>{b}</span><span class=\"eq\">{equation}</span></div>\n",
            kind.name()
        ));
    }

    /// From the entries to the bytes.
    fn pixel(&mut self, report: &Report<'_>) {
        let Explanation { samples, linear: [r, g, b, alpha], rgba8, .. } = report.explanation;
        self.push("<section>\n<h2>From light to bytes</h2>\n<div class=\"rows\">\n");
        let parts: Vec<_> = samples
            .iter()
            .map(|entry| {
                let cover = match entry.alpha {
                    1.0 => String::new(),
                    alpha => format!(" × {}", number(alpha)),
                };
                format!("{}{cover} × {}", entry.weight, color(entry.display))
            })
            .collect();
        let mixed = match (samples.len(), *alpha) {
            (1, _) => String::new(),
            (_, 1.0) => format!("= {}", parts.join(" + ")),
            (_, alpha) => format!("= ({}) / {}", parts.join(" + "), number(alpha)),
        };
        self.total("pixel", [*r, *g, *b], TermKind::Sum, &mixed);
        let curve = match report.view.encoding {
            PictureEncoding::Srgb => "clamped to 0..1, through the curve of sRGB, × 255",
            PictureEncoding::None => "clamped to 0..1, × 255",
        };
        let [x, y, z] = [*r, *g, *b].map(|value| encoded(value, report.view.encoding));
        let [red, green, blue, byte_alpha] = rgba8;
        self.push(format_args!(
            "<div class=\"row\"><span>encoded</span><span>{x:.2}</span><span>{y:.2}</span>\
             <span>{z:.2}</span><span class=\"eq\">{curve}</span></div>\n\
             <div class=\"row total\"><span>rounded</span><span>{red}</span><span>{green}</span>\
             <span>{blue}</span><span class=\"eq\">alpha {} × 255, rounded: {byte_alpha}</span></div>\n\
             </div>\n</section>\n",
            number(*alpha)
        ));
    }
}

fn symbol(factor: &Factor) -> String {
    let symbol = factor.symbol().html;
    match factor {
        Factor::Cosine(..) => format!("max({symbol}, 0)"),
        Factor::Power(..) => format!("max({symbol}, 0)<sup><i>n</i></sup>"),
        _ => symbol.to_owned(),
    }
}

fn numbers(factor: &Factor) -> String {
    match factor {
        Factor::Number(_, value) => number(*value),
        Factor::Color(_, value) => color(*value),
        Factor::Cosine(_, value) => number(value.max(0.0)),
        Factor::Power(_, value, n) => {
            format!("{}<sup>{}</sup>", number(value.max(0.0)), number(*n))
        }
    }
}
