//! The ledger as text: the lighting equation with its numbers filled in.

use super::Told;
use super::equation::{
    Factor, LightRows, LitPlace, PartRow, Role, Row, color, highlight_vector, lit_places, number,
    reach,
};
use super::rows::rows;
use super::words::{
    Mixture, coordinate, encoded, kind_name, material, nearest, part_of, place_name, share,
    surface_path, why_not_seen,
};
use crate::console::printable;
use luxel::lighting::PictureEncoding;
use luxel::render::{ExplainedSample, ExplainedSurface, Explanation, Seen};

/// Columns of the names of terms.
const NAMES: usize = 14;
/// Columns of a term's red, green or blue.
const VALUE: usize = 9;

/// The whole page.
pub(super) fn page(told: &Told<'_>, colored: bool) -> String {
    let mut page = Page { text: String::new(), colored };
    page.tell(told);
    page.text
}

struct Page {
    text: String,
    colored: bool,
}

/// Quiet text.
const QUIET: [u8; 3] = [154, 156, 159];

/// The colour of a kind of term, the same wherever terms are shown.
fn role_color(role: Role) -> [u8; 3] {
    match role {
        Role::Ambient => [0x7d, 0x8c, 0xa3],
        Role::Diffuse => [0x5a, 0xa9, 0xe6],
        Role::Specular => [0xf2, 0xf2, 0xf2],
        Role::Emission => [0xf2, 0x8f, 0x5a],
        Role::Environment => [0xc9, 0xa2, 0xf2],
        Role::Fog => [0xa3, 0xb5, 0xa6],
        Role::Sum => [0xf2, 0xb8, 0x4b],
    }
}

impl Page {
    fn line(&mut self, text: &str) {
        self.text.push_str(text.trim_end());
        self.text.push('\n');
    }

    fn painted(&self, text: &str, [r, g, b]: [u8; 3]) -> String {
        if self.colored { format!("\x1b[38;2;{r};{g};{b}m{text}\x1b[0m") } else { text.to_owned() }
    }

    fn quiet(&self, text: &str) -> String {
        self.painted(text, QUIET)
    }

    fn bold(&self, text: &str) -> String {
        if self.colored { format!("\x1b[1m{text}\x1b[0m") } else { text.to_owned() }
    }

    /// A patch of a colour, on a terminal.
    fn patch(&self, [r, g, b]: [u8; 3]) -> String {
        if self.colored { format!("\x1b[48;2;{r};{g};{b}m    \x1b[0m ") } else { String::new() }
    }

    fn tell(&mut self, told: &Told<'_>) {
        let Explanation { pixel: [x, y], position, samples, rgba8, .. } = told.explanation;
        let [r, g, b, alpha] = *rgba8;
        let place = match position {
            Some([x, y]) => format!("point ({x}, {y})"),
            None => format!("pixel ({x}, {y})"),
        };
        let head = self.bold(&format!("{place} of {}", printable(&told.model)));
        let patch = self.patch([r, g, b]);
        self.line(&format!("{head}   {patch}#{r:02x}{g:02x}{b:02x}   {r} {g} {b}, alpha {alpha}"));
        for (place, entry) in samples.iter().enumerate() {
            self.line("");
            self.sample(entry, told);
            for (label, sentence) in why_not_seen(place, told) {
                let sentence = printable(&sentence);
                self.line(&self.quiet(&format!("  {label:NAMES$}{sentence}")));
            }
        }
        if let Some(nearest) = nearest(told) {
            self.line(&self.quiet(&format!("  {}", printable(&nearest))));
        }
        self.line("");
        self.pixel(told);
    }

    fn sample(&mut self, entry: &ExplainedSample, told: &Told<'_>) {
        let share = share(entry);
        let layers = entry.seen.len();
        for (number, seen) in entry.seen.iter().enumerate() {
            let which = match (number, layers) {
                (0, 1) => format!("{share} sees"),
                (0, _) => format!("{share} sees first"),
                _ => "and behind it".to_owned(),
            };
            match seen {
                Seen::Background { color: behind, alpha } => {
                    let text = format!("the background, {}, alpha {}", color(*behind), alpha);
                    self.line(&format!("{which} {text}"));
                }
                Seen::Surface(surface) => {
                    self.surface(&which, surface, told);
                    if layers > 1 {
                        let alpha = number_of(surface.alpha);
                        self.line(&format!("  {:NAMES$}{alpha}", "alpha"));
                    }
                }
            }
        }
        if layers > 1 {
            let all = format!("  {:NAMES$}", "together");
            let text = self.painted(&(all + &values(entry.color)), role_color(Role::Sum));
            self.line(&format!("{text}  alpha {}", number_of(entry.alpha)));
        }
    }

    fn surface(&mut self, which: &str, surface: &ExplainedSurface, told: &Told<'_>) {
        let name = printable(&surface_path(surface, told.scene));
        let triangle = part_of(surface.triangle);
        self.line(&format!("{which} {triangle}{}", self.bold(&name)));
        let [a, b, c] = surface.barycentric.map(number_of);
        let [x, y, z] = surface.position.map(|side| number(side as f32));
        let place = format!("({x}, {y}, {z})");
        self.line(
            &self.quiet(&format!("  {:NAMES$}{place}   corners weigh {a}, {b}, {c}", "place")),
        );
        let vectors = format!("N = {}   V = {}", vector(surface.normal), vector(surface.view));
        self.line(&self.quiet(&format!("  {:NAMES$}{vectors}", "vectors")));
        let material = material(surface);
        self.line(&self.quiet(&format!("  {:NAMES$}{}", "material", printable(&material))));
        self.line(&self.quiet(&format!(
            "  {:NAMES$}{:>VALUE$}{:>VALUE$}{:>VALUE$}",
            "", "red", "green", "blue"
        )));
        let places = lit_places(surface);
        for (at, place) in places.iter().enumerate() {
            if let Some((weight, _)) = place.share {
                let name = self.bold(&place_name(at, places.len(), told));
                let (n, v) = (vector(place.normal), vector(place.view));
                self.line(&format!("  {name} weighs {}   N = {n}   V = {v}", number(weight)));
            }
            self.lit(place);
        }
        let Mixture { parts, texture } = Mixture::of(surface, &places);
        let note = if parts.is_empty() { String::new() } else { mixture_text(&parts, texture) };
        self.total("= I", surface.sum, Role::Sum, &note);
        if let Some((factor, fog)) = surface.fog {
            let note = format!(
                "s I + (1 - s) I_dc = {} I + {} x {}, {} away",
                number(factor),
                number(1.0 - factor),
                color(fog),
                number(surface.z),
            );
            self.total("= I' in fog", surface.color, Role::Fog, &note);
        }
    }

    /// The terms of one place.
    fn lit(&mut self, place: &LitPlace<'_>) {
        let rows = rows(place);
        for row in &rows.own {
            self.row(row, "");
        }
        for light in &rows.lights {
            self.light(light, place);
        }
        self.parts(&rows.mirrors);
        if let Some(environment) = &rows.environment {
            self.row(environment, "");
        }
        if let Some((_, light)) = place.share {
            let clamped = if light == place.sum { "" } else { "clamped to 0..1" };
            self.total("= light here", light, Role::Sum, clamped);
        }
    }

    fn light(&mut self, told: &LightRows<'_>, place: &LitPlace<'_>) {
        let light = told.light;
        let mut head = format!(
            "  {} ({})   N.L = {}   L = {}",
            self.bold(&printable(&light.name)),
            kind_name(&light.light),
            number(light.terms.n_dot_l),
            vector(light.terms.to_light.lane(0)),
        );
        if let Some((name, highlight)) = highlight_vector(place, light)
            && told.why_not.is_none()
        {
            head += &format!("   {name} = {}", vector(highlight));
        }
        if let Some(reach) = reach(light) {
            head += &format!("   {reach}");
        }
        self.line(&head);
        self.parts(&told.parts);
        for row in &told.rows {
            self.row(row, "  ");
        }
        if let Some(why) = &told.why_not {
            let why = self.quiet(&format!(
                "    adds {} light: {why}",
                if told.rows.is_empty() { "no" } else { "no other" }
            ));
            self.line(&why);
        }
    }

    /// The parts of a mix, in quiet: only their sums are terms.
    fn parts(&mut self, parts: &[PartRow]) {
        for PartRow { of, row } in parts {
            let name = format!("    {:width$}", row.name, width = NAMES - 2);
            let symbols: Vec<_> = row.factors.iter().map(symbol_text).collect();
            let numbers: Vec<_> = row.factors.iter().map(factor_text).collect();
            let symbols = format!("in {}: {}", of.text, symbols.join(" "));
            self.line(&self.quiet(&format!("{name}{}  {symbols}", values(row.value))));
            let numbers = format!("  = {}", numbers.join(" x "));
            self.line(&self.quiet(&format!("  {:width$}{numbers}", "", width = NAMES + 3 * VALUE)));
        }
    }

    fn row(&mut self, row: &Row, indent: &str) {
        let name = format!("  {indent}{:width$}", row.name, width = NAMES - indent.len());
        let told = self.painted(&(name + &values(row.value)), role_color(row.role));
        let symbols: Vec<_> = row.factors.iter().map(symbol_text).collect();
        let numbers: Vec<_> = row.factors.iter().map(factor_text).collect();
        let product = format!("  = {}", numbers.join(" x "));
        self.line(&format!("{told}  = {}", symbols.join(" ")));
        self.line(&self.quiet(&format!("  {:width$}{product}", "", width = NAMES + 3 * VALUE)));
    }

    fn total(&mut self, name: &str, value: [f32; 3], role: Role, note: &str) {
        let text = format!("  {name:NAMES$}{}", values(value));
        let text = self.painted(&text, role_color(role));
        let note = if note.is_empty() { String::new() } else { self.quiet(&format!("  {note}")) };
        self.line(&format!("{text}{note}"));
    }

    /// From the entries to the bytes.
    fn pixel(&mut self, told: &Told<'_>) {
        let Explanation { samples, linear: [r, g, b, alpha], rgba8, .. } = told.explanation;
        if samples.len() > 1 {
            let parts: Vec<_> = samples
                .iter()
                .map(|entry| {
                    let (weight, alpha) = (entry.weight, entry.alpha);
                    let cover = if alpha == 1.0 {
                        String::new()
                    } else {
                        format!(" x {}", number_of(alpha))
                    };
                    format!("{weight}{cover} {}", color(entry.color))
                })
                .collect();
            self.line(&format!("{:width$}{}", "mixed", parts.join(" + "), width = NAMES + 2));
        }
        let text = format!("{:width$}{}", "pixel", values([*r, *g, *b]), width = NAMES + 2);
        let shown = self.painted(&text, role_color(Role::Sum));
        let curve = match told.view.encoding {
            PictureEncoding::Srgb => "clamped to 0..1, then through the curve of sRGB",
            PictureEncoding::None => "clamped to 0..1",
        };
        let [byte_r, byte_g, byte_b, byte_alpha] = rgba8;
        self.line(&format!("{shown}  alpha {}", number_of(*alpha)));
        let steps = [*r, *g, *b].map(|value| encoded(value, told.view.encoding));
        let steps = steps.map(|step| format!("{step:>VALUE$.2}")).concat();
        let text = format!("{:width$}{steps}", "times 255", width = NAMES + 2);
        self.line(&format!("{text}  {}", self.quiet(curve)));
        let bytes = [byte_r, byte_g, byte_b].map(|byte| format!("{byte:>VALUE$}")).concat();
        let text = format!("{:width$}{bytes}", "rounded", width = NAMES + 2);
        self.line(&format!("{text}  alpha {byte_alpha}"));
    }
}

/// How light comes from the places where it was computed.
pub(super) fn mixture_text(parts: &[(f32, [f32; 3])], texture: Option<[f32; 3]>) -> String {
    let parts: Vec<_> = parts
        .iter()
        .map(|(weight, light)| format!("{} x {}", number(*weight), color(*light)))
        .collect();
    match texture {
        Some(texture) => format!("({}) x texture {}", parts.join(" + "), color(texture)),
        None => parts.join(" + "),
    }
}

pub(super) fn symbol_text(factor: &Factor) -> String {
    let text = factor.symbol().text;
    match factor {
        Factor::Cosine(..) => format!("max({text}, 0)"),
        Factor::Power(..) => format!("max({text}, 0)^n"),
        _ => text.to_owned(),
    }
}

pub(super) fn factor_text(factor: &Factor) -> String {
    match factor {
        Factor::Number(_, value) => number(*value),
        Factor::Color(_, value) => color(*value),
        Factor::Cosine(_, value) => number(value.max(0.0)),
        Factor::Power(_, value, n) => format!("{}^{}", number(value.max(0.0)), number(*n)),
    }
}

fn vector(vector: [f32; 3]) -> String {
    let [x, y, z] = vector.map(coordinate);
    format!("({x}, {y}, {z})")
}

/// Red, green and blue in their columns.
fn values(color: [f32; 3]) -> String {
    color.map(|value| format!("{:>VALUE$}", number_of(value))).concat()
}

/// A number of about 1, in a column.
fn number_of(value: f32) -> String {
    if value == 0.0 || (1e-4..1e4).contains(&value.abs()) {
        format!("{value:.4}")
    } else {
        format!("{value:.1e}")
    }
}
