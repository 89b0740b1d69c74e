//! The ledger as text: the lighting equation with its numbers filled in.

use super::report::Report;
use super::sentences::{
    encoded, material, nearest, part_of, point_name, share, surface_path, why_not_seen,
};
use crate::equation::{
    Interpolation, LightEntry, PartTerm, ShadingPoint, Term, TermKind, clamp_range, display_text,
    factor_text, ground_facts, highlight_vector, in_the_way, interpolation_text, point_terms,
    reach, shading_points, symbol_text,
};
use crate::words::{color, in_column, number, printable, vector};
use luxel_lighting::PictureEncoding;
use luxel_render::{ExplainedSample, ExplainedSurface, Explanation, Seen};

/// Columns of the names of terms.
const NAMES: usize = 14;
/// Columns of a term's red, green or blue.
const VALUE: usize = 9;

/// The whole page.
pub(crate) fn page(report: &Report<'_>, colored: bool) -> String {
    let mut page = Page { text: String::new(), colored, ground: Vec::new() };
    page.whole(report);
    page.text
}

struct Page {
    text: String,
    colored: bool,
    /// What is written of the ground so far.
    ground: Vec<(String, String)>,
}

/// Quiet text.
const QUIET: [u8; 3] = [154, 156, 159];

/// The colour of a kind of term, the same wherever terms are shown.
fn kind_color(kind: TermKind) -> [u8; 3] {
    match kind {
        TermKind::Ambient => [0x7d, 0x8c, 0xa3],
        TermKind::Diffuse => [0x5a, 0xa9, 0xe6],
        TermKind::Specular => [0xf2, 0xf2, 0xf2],
        TermKind::Emission => [0xf2, 0x8f, 0x5a],
        TermKind::Environment => [0xc9, 0xa2, 0xf2],
        TermKind::Fog => [0xa3, 0xb5, 0xa6],
        TermKind::Sum => [0xf2, 0xb8, 0x4b],
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

    fn whole(&mut self, report: &Report<'_>) {
        let Explanation { pixel: [x, y], position, samples, rgba8, .. } = report.explanation;
        let [r, g, b, alpha] = *rgba8;
        let place = match position {
            Some([x, y]) => format!("point ({x}, {y})"),
            None => format!("pixel ({x}, {y})"),
        };
        let head = self.bold(&format!("{place} of {}", printable(report.model)));
        let patch = self.patch([r, g, b]);
        self.line(&format!("{head}   {patch}#{r:02x}{g:02x}{b:02x}   {r} {g} {b}, alpha {alpha}"));
        for (index, entry) in samples.iter().enumerate() {
            self.line("");
            self.sample(entry, report);
            for (label, sentence) in why_not_seen(index, report) {
                let sentence = printable(&sentence);
                self.line(&self.quiet(&format!("  {label:NAMES$}{sentence}")));
            }
        }
        if let Some(nearest) = nearest(report) {
            self.line(&self.quiet(&format!("  {}", printable(&nearest))));
        }
        self.line("");
        self.pixel(report);
    }

    fn sample(&mut self, entry: &ExplainedSample, report: &Report<'_>) {
        let share = share(entry);
        let layers = entry.seen.len();
        for (number, seen) in entry.seen.iter().enumerate() {
            let which = match (number, layers) {
                (0, 1) => format!("{share} sees"),
                (0, _) => format!("{share} sees first"),
                _ => "and behind it".to_owned(),
            };
            match seen {
                Seen::Background { color: behind, alpha, ground } => {
                    let what = if ground.is_some() { "the ground" } else { "the background" };
                    let text = format!("{what}, {}, alpha {}", color(*behind), alpha);
                    self.line(&format!("{which} {text}"));
                    for fact in ground.iter().flat_map(|ground| ground_facts(ground)) {
                        // What samples see alike stands with the first of them.
                        if self.ground.contains(&fact) {
                            continue;
                        }
                        let (label, text) = (printable(&fact.0), printable(&fact.1));
                        self.line(&self.quiet(&format!("  {label:NAMES$}{text}")));
                        self.ground.push(fact);
                    }
                }
                Seen::Surface(surface) => {
                    self.surface(&which, surface, report);
                    if layers > 1 {
                        let alpha = in_column(surface.alpha);
                        self.line(&format!("  {:NAMES$}{alpha}", "alpha"));
                    }
                }
            }
        }
        if layers > 1 {
            let all = format!("  {:NAMES$}", "together");
            let text = self.painted(&(all + &values(entry.display)), kind_color(TermKind::Sum));
            self.line(&format!("{text}  alpha {}", in_column(entry.alpha)));
        }
    }

    fn surface(&mut self, which: &str, surface: &ExplainedSurface, report: &Report<'_>) {
        let name = printable(&surface_path(surface, report.scene));
        let triangle = part_of(surface.triangle);
        self.line(&format!("{which} {triangle}{}", self.bold(&name)));
        let [a, b, c] = surface.barycentric.map(in_column);
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
        let points = shading_points(surface);
        for (at, point) in points.iter().enumerate() {
            if let Some((weight, _)) = point.share {
                let name = self.bold(&point_name(at, points.len(), report));
                let (n, v) = (vector(point.normal), vector(point.view));
                self.line(&format!("  {name} weighs {}   N = {n}   V = {v}", number(weight)));
            }
            self.point(point);
        }
        let Interpolation { parts, texture } = Interpolation::of(surface, &points);
        let note =
            if parts.is_empty() { String::new() } else { interpolation_text(&parts, texture) };
        self.total("= I", surface.sum, TermKind::Sum, &note);
        if let Some((factor, fog)) = surface.fog {
            let note = format!(
                "s I + (1 - s) I_dc = {} I + {} x {}, {} away",
                number(factor),
                number(1.0 - factor),
                color(fog),
                number(surface.z),
            );
            self.total("= I' in fog", surface.color, TermKind::Fog, &note);
        }
        let light = if surface.fog.is_some() { "I'" } else { "I" };
        if let Some(note) = display_text(&report.explanation.display, light) {
            self.total("= as shown", surface.display, TermKind::Sum, &note);
        }
    }

    /// The terms at one point.
    fn point(&mut self, point: &ShadingPoint<'_>) {
        let at_point = point_terms(point);
        for term in &at_point.own {
            self.term(term, "");
        }
        for light in &at_point.lights {
            self.light(light, point);
        }
        self.parts(&at_point.mirrors);
        for environment in &at_point.environment {
            self.term(environment, "");
        }
        if let Some((_, light)) = point.share {
            let clamped = match light == point.sum {
                true => String::new(),
                false => format!("clamped to {}", clamp_range(point.sum, light)),
            };
            self.total("= light here", light, TermKind::Sum, &clamped);
        }
    }

    fn light(&mut self, entry: &LightEntry<'_>, point: &ShadingPoint<'_>) {
        let light = entry.light;
        let mut head = format!(
            "  {} ({})   N.L = {}   L = {}",
            self.bold(&printable(&light.name)),
            light.light.kind.name(),
            number(light.terms.n_dot_l),
            vector(light.terms.to_light.lane(0)),
        );
        if let Some((name, highlight)) = highlight_vector(point, light)
            && entry.why_not.is_none()
        {
            head += &format!("   {name} = {}", vector(highlight));
        }
        if let Some(reach) = reach(light) {
            head += &format!("   {reach}");
        }
        self.line(&head);
        self.parts(&entry.parts);
        for term in &entry.terms {
            self.term(term, "  ");
        }
        if let Some(in_the_way) = in_the_way(light) {
            self.line(&self.quiet(&format!("    {}", printable(&in_the_way))));
        }
        if let Some(why) = &entry.why_not {
            let why = self.quiet(&format!(
                "    adds {} light: {why}",
                if entry.terms.is_empty() { "no" } else { "no other" }
            ));
            self.line(&why);
        }
    }

    /// The parts of a mix, in quiet: only their sums are terms.
    fn parts(&mut self, parts: &[PartTerm]) {
        for PartTerm { of, term } in parts {
            let name = format!("    {:width$}", term.name, width = NAMES - 2);
            let symbols: Vec<_> = term.factors.iter().map(symbol_text).collect();
            let numbers: Vec<_> = term.factors.iter().map(factor_text).collect();
            let symbols = format!("in {}: {}", of.text, symbols.join(" "));
            self.line(&self.quiet(&format!("{name}{}  {symbols}", values(term.value))));
            let numbers = format!("  = {}", numbers.join(" x "));
            self.line(&self.quiet(&format!("  {:width$}{numbers}", "", width = NAMES + 3 * VALUE)));
        }
    }

    fn term(&mut self, term: &Term, indent: &str) {
        let name = format!("  {indent}{:width$}", term.name, width = NAMES - indent.len());
        let sum = self.painted(&(name + &values(term.value)), kind_color(term.kind));
        let symbols: Vec<_> = term.factors.iter().map(symbol_text).collect();
        let numbers: Vec<_> = term.factors.iter().map(factor_text).collect();
        let product = format!("  = {}", numbers.join(" x "));
        self.line(&format!("{sum}  = {}", symbols.join(" ")));
        self.line(&self.quiet(&format!("  {:width$}{product}", "", width = NAMES + 3 * VALUE)));
    }

    fn total(&mut self, name: &str, value: [f32; 3], kind: TermKind, note: &str) {
        let text = format!("  {name:NAMES$}{}", values(value));
        let text = self.painted(&text, kind_color(kind));
        let note = if note.is_empty() { String::new() } else { self.quiet(&format!("  {note}")) };
        self.line(&format!("{text}{note}"));
    }

    /// From the entries to the bytes.
    fn pixel(&mut self, report: &Report<'_>) {
        let Explanation { samples, linear: [r, g, b, alpha], rgba8, .. } = report.explanation;
        if samples.len() > 1 {
            let parts: Vec<_> = samples
                .iter()
                .map(|entry| {
                    let (weight, alpha) = (entry.weight, entry.alpha);
                    let cover = if alpha == 1.0 {
                        String::new()
                    } else {
                        format!(" x {}", in_column(alpha))
                    };
                    format!("{weight}{cover} {}", color(entry.display))
                })
                .collect();
            self.line(&format!("{:width$}{}", "mixed", parts.join(" + "), width = NAMES + 2));
        }
        let text = format!("{:width$}{}", "pixel", values([*r, *g, *b]), width = NAMES + 2);
        let shown = self.painted(&text, kind_color(TermKind::Sum));
        let curve = match report.view.encoding {
            PictureEncoding::Srgb => "clamped to 0..1, then through the curve of sRGB",
            PictureEncoding::None => "clamped to 0..1",
        };
        let [byte_r, byte_g, byte_b, byte_alpha] = rgba8;
        self.line(&format!("{shown}  alpha {}", in_column(*alpha)));
        let steps = [*r, *g, *b].map(|value| encoded(value, report.view.encoding));
        let steps = steps.map(|step| format!("{step:>VALUE$.2}")).concat();
        let text = format!("{:width$}{steps}", "times 255", width = NAMES + 2);
        self.line(&format!("{text}  {}", self.quiet(curve)));
        let bytes = [byte_r, byte_g, byte_b].map(|byte| format!("{byte:>VALUE$}")).concat();
        let text = format!("{:width$}{bytes}", "rounded", width = NAMES + 2);
        self.line(&format!("{text}  alpha {byte_alpha}"));
    }
}

/// Red, green and blue in their columns.
fn values(color: [f32; 3]) -> String {
    color.map(|value| format!("{:>VALUE$}", in_column(value))).concat()
}
