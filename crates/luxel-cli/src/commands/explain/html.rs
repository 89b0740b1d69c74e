//! The ledger as a page of HTML: one file without script, readable on a phone.

mod bar;
mod figure;
mod pictures;

use super::Told;
use super::equation::{
    Factor, LightRows, LitPlace, PartRow, Role, Row, color, highlight_vector, lit_places,
    model_name, number, reach,
};
use super::rows::rows;
use super::words::{
    Mixture, capital, coordinate, encoded, kind_name, nearest, part_of, place_name, share,
    surface_path, why_not_seen,
};
use crate::console::printable;
use crate::failure::Failure;
use luxel::lighting::PictureEncoding;
use luxel::render::{ExplainedSample, ExplainedSurface, Explanation, Renderer, Seen};
use std::fmt::{Display, Write};

const STYLE: &str = include_str!("html/style.css");

/// The page.
///
/// # Errors
/// [`Failure`] if its pictures can't be drawn.
pub(super) fn page(told: &Told<'_>, renderer: &Renderer<'_>) -> Result<String, Failure> {
    let mut page = Page { text: String::new() };
    page.head(told);
    page.pictures(told, renderer)?;
    for (place, entry) in told.explanation.samples.iter().enumerate() {
        page.sample(place, entry, told);
    }
    page.pixel(told);
    page.push("</main>\n</html>\n");
    Ok(page.text)
}

/// Text as HTML shows it: names come from files, and a file must not write the page.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in printable(text).chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            other => safe.push(other),
        }
    }
    safe
}

/// The class that gives a kind of term its colour.
fn role_class(role: Role) -> &'static str {
    match role {
        Role::Ambient => "ambient",
        Role::Diffuse => "diffuse",
        Role::Specular => "specular",
        Role::Emission => "emission",
        Role::Environment => "environment",
        Role::Fog => "fog",
        Role::Sum => "sum",
    }
}

struct Page {
    text: String,
}

impl Page {
    fn push(&mut self, text: impl Display) {
        // Writing into a string can't fail.
        let _ = write!(self.text, "{text}");
    }

    fn head(&mut self, told: &Told<'_>) {
        let Explanation { pixel: [x, y], position, rgba8: [r, g, b, alpha], .. } = told.explanation;
        let place = match position {
            Some([x, y]) => format!("point {x}, {y}"),
            None => format!("pixel {x}, {y}"),
        };
        let model = escaped(&told.model);
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

    fn sample(&mut self, place: usize, entry: &ExplainedSample, told: &Told<'_>) {
        self.push("<section>\n");
        let layers = entry.seen.len();
        for (depth, seen) in entry.seen.iter().enumerate() {
            let which = match (depth, layers) {
                (0, 1) => format!("{} sees", share(entry)),
                (0, _) => format!("{} sees first", share(entry)),
                _ => "and behind it".to_owned(),
            };
            match seen {
                Seen::Background { color: behind, alpha } => self.push(format_args!(
                    "<h2>{} the background</h2>\n<p class=\"num\">{}, alpha {alpha}</p>\n",
                    capital(&which),
                    color(*behind)
                )),
                Seen::Surface(surface) => {
                    self.surface(&which, surface, told);
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
            self.total("seen", entry.color, Role::Sum, &note);
            self.push("</div>\n");
        }
        let mut sentences = why_not_seen(place, told);
        sentences.extend(nearest(told).map(|text| ("empty", text)));
        if !sentences.is_empty() {
            self.push("<h3>What isn’t seen here</h3>\n<dl>\n");
            for (label, text) in sentences {
                self.push(format_args!("<dt>{label}</dt><dd>{}</dd>\n", escaped(&text)));
            }
            self.push("</dl>\n");
        }
        self.push("</section>\n");
    }

    fn surface(&mut self, which: &str, surface: &ExplainedSurface, told: &Told<'_>) {
        let path = escaped(&surface_path(surface, told.scene));
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
        self.push(bar::terms(surface));
        let places = lit_places(surface);
        for (at, place) in places.iter().enumerate() {
            match place.share {
                None => self.place(place),
                Some((weight, _)) => {
                    let name = place_name(at, places.len(), told);
                    let open = if at == 0 { " open" } else { "" };
                    self.push(format_args!(
                        "<details{open}>\n<summary>Lit at {name}, which weighs <span \
                         class=\"num\">{}</span></summary>\n",
                        number(weight)
                    ));
                    self.place(place);
                    self.push("</details>\n");
                }
            }
        }
        self.ending(surface, &places);
    }

    /// What becomes of the light of the places: interpolated, in fog.
    fn ending(&mut self, surface: &ExplainedSurface, places: &[LitPlace<'_>]) {
        let Mixture { parts, texture } = Mixture::of(surface, places);
        if parts.is_empty() && surface.fog.is_none() {
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
            self.total("interpolated", surface.sum, Role::Sum, &note);
        }
        if let Some((factor, fog)) = surface.fog {
            let note = format!(
                "s I + (1 − s) I<sub>dc</sub> = {} × I + {} × {}, {} along the view",
                number(factor),
                number(1.0 - factor),
                color(fog),
                number(surface.z)
            );
            self.total("in fog", surface.color, Role::Fog, &note);
        }
        self.push("</div>\n");
    }

    /// One place: figures, equation, lights.
    fn place(&mut self, place: &LitPlace<'_>) {
        let told = rows(place);
        if !told.lights.is_empty() {
            self.push("<div class=\"figures\">\n");
            for light in &told.lights {
                self.push(figure::of_light(place, light));
            }
            self.push("</div>\n");
        }
        self.push(
            "<div class=\"rows\">\n<div class=\"row quiet head\"><span>term</span><span>red</span>\
             <span>green</span><span>blue</span><span class=\"eq\">as a product</span></div>\n",
        );
        for row in &told.own {
            self.row(row);
        }
        for light in &told.lights {
            self.light(light, place);
        }
        self.parts(&told.mirrors);
        if let Some(environment) = &told.environment {
            self.row(environment);
        }
        self.total("sum, I", place.sum, Role::Sum, "");
        if let Some((_, light)) = place.share
            && light != place.sum
        {
            self.total("clamped", light, Role::Sum, "to 0..1, as light is interpolated here");
        }
        self.push("</div>\n");
    }

    fn light(&mut self, told: &LightRows<'_>, place: &LitPlace<'_>) {
        let light = told.light;
        let mut facts = format!(
            "{}, <b>N</b>·<b>L</b> = {}, <b>L</b> = {}",
            kind_name(&light.light),
            number(light.terms.n_dot_l),
            vector(light.terms.to_light.lane(0))
        );
        if let Some((name, highlight)) = highlight_vector(place, light) {
            let _ = write!(facts, ", <b>{name}</b> = {}", vector(highlight));
        }
        if let Some(reach) = reach(light) {
            let _ = write!(facts, ", {reach}");
        }
        self.push(format_args!(
            "<div class=\"light\"><strong>{}</strong> <span class=\"quiet num\">{facts}</span>",
            escaped(&light.name)
        ));
        if let Some(why) = &told.why_not {
            let what = if told.rows.is_empty() { "no" } else { "no other" };
            self.push(format_args!("<p class=\"why\">Adds {what} light: {}.</p>", escaped(why)));
        }
        self.push("</div>\n");
        self.parts(&told.parts);
        for row in &told.rows {
            self.row(row);
        }
    }

    /// The parts of a mix, in quiet: only their sums are terms.
    fn parts(&mut self, parts: &[PartRow]) {
        for PartRow { of, row } in parts {
            let [r, g, b] = row.value.map(in_column);
            let symbols: Vec<_> = row.factors.iter().map(symbol).collect();
            let numbers: Vec<_> = row.factors.iter().map(numbers).collect();
            self.push(format_args!(
                "<div class=\"row part\"><span>{}</span><span>{r}</span><span>{g}</span>\
                 <span>{b}</span><span class=\"eq\">in {}: {}<br>= {}</span></div>\n",
                row.name,
                of.html,
                symbols.join(" "),
                numbers.join(" × ")
            ));
        }
    }

    fn row(&mut self, row: &Row) {
        let symbols: Vec<_> = row.factors.iter().map(symbol).collect();
        let numbers: Vec<_> = row.factors.iter().map(numbers).collect();
        let equation = format!("= {}<br>= {}", symbols.join(" "), numbers.join(" × "));
        self.total(row.name, row.value, row.role, &equation);
    }

    /// A line of the table: what it is, its three channels, and how it came about (HTML).
    fn total(&mut self, name: &str, value: [f32; 3], role: Role, equation: &str) {
        let [r, g, b] = value.map(in_column);
        let total = if role == Role::Sum { " total" } else { "" };
        self.push(format_args!(
            "<div class=\"row{total}\"><span><i class=\"{}\"></i>{name}</span><span>{r}</span>\
             <span>{g}</span><span>{b}</span><span class=\"eq\">{equation}</span></div>\n",
            role_class(role)
        ));
    }

    /// From the entries to the bytes.
    fn pixel(&mut self, told: &Told<'_>) {
        let Explanation { samples, linear: [r, g, b, alpha], rgba8, .. } = told.explanation;
        self.push("<section>\n<h2>From light to bytes</h2>\n<div class=\"rows\">\n");
        let parts: Vec<_> = samples
            .iter()
            .map(|entry| {
                let cover = match entry.alpha {
                    1.0 => String::new(),
                    alpha => format!(" × {}", number(alpha)),
                };
                format!("{}{cover} × {}", entry.weight, color(entry.color))
            })
            .collect();
        let mixed = match (samples.len(), *alpha) {
            (1, _) => String::new(),
            (_, 1.0) => format!("= {}", parts.join(" + ")),
            (_, alpha) => format!("= ({}) / {}", parts.join(" + "), number(alpha)),
        };
        self.total("pixel", [*r, *g, *b], Role::Sum, &mixed);
        let curve = match told.view.encoding {
            PictureEncoding::Srgb => "clamped to 0..1, through the curve of sRGB, × 255",
            PictureEncoding::None => "clamped to 0..1, × 255",
        };
        let [x, y, z] = [*r, *g, *b].map(|value| encoded(value, told.view.encoding));
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

fn vector(vector: [f32; 3]) -> String {
    let [x, y, z] = vector.map(coordinate);
    format!("({x}, {y}, {z})")
}

/// A number of about 1, in a column.
fn in_column(value: f32) -> String {
    if value == 0.0 || (1e-4..1e4).contains(&value.abs()) {
        format!("{value:.4}")
    } else {
        format!("{value:.1e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_writes_no_page() {
        assert_eq!(escaped("<b>\"a\" & 'b'\n"), "&lt;b&gt;&quot;a&quot; &amp; &#39;b&#39;\\n");
    }
}
