//! The ledger as LaTeX: the equation with its symbols, then with this pixel's numbers.

use super::report::Report;
use super::sentences::{encoded, nearest, part_of, point_name, share, surface_path, why_not_seen};
use crate::equation::{
    Factor, Interpolation, LightEntry, PartTerm, ShadingPoint, Term, ground_facts,
    highlight_vector, in_the_way, point_terms, shading_points,
};
use crate::words::{capital, coordinate, model_name, number};
use luxel_lighting::{Attenuation, Display, LightKind, PictureEncoding, Tone};
use luxel_render::{ExplainedLight, ExplainedSample, ExplainedSurface, Explanation, Seen};
use std::fmt::Write;

/// A fragment for a document with amsmath.
pub(crate) fn fragment(report: &Report<'_>) -> String {
    let mut page = Page { text: String::new() };
    page.whole(report);
    page.text
}

struct Page {
    text: String,
}

impl Page {
    fn line(&mut self, text: &str) {
        self.text.push_str(text);
        self.text.push('\n');
    }

    /// Plain text that begins a paragraph.
    fn paragraph(&mut self, text: &str) {
        self.line(&format!("\\par\\smallskip {text}"));
    }

    /// Lines of one display, each aligned at its `&`.
    fn display(&mut self, lines: &[String]) {
        if lines.is_empty() {
            return;
        }
        self.line("\\begin{align*}");
        self.line(&lines.join(" \\\\\n"));
        self.line("\\end{align*}");
    }

    fn whole(&mut self, report: &Report<'_>) {
        let Explanation { pixel: [x, y], position, samples, rgba8: [r, g, b, alpha], .. } =
            report.explanation;
        let place = match position {
            Some([x, y]) => format!("Point ({x}, {y})"),
            None => format!("Pixel ({x}, {y})"),
        };
        self.line("% The light of one pixel, as luxel computed it. Needs \\usepackage{amsmath}.");
        self.line("% Products of colours go channel by channel: red, green, blue.");
        self.line(
            "\\begingroup\\small\\setlength{\\parindent}{0pt}\\raggedright\\allowdisplaybreaks",
        );
        self.line(&format!(
            "\\textbf{{{place} of \\texttt{{{}}}}}: red {r}, green {g}, blue {b}, alpha {alpha}.",
            escaped(report.model)
        ));
        for (index, entry) in samples.iter().enumerate() {
            self.sample(entry, report);
            for (_, sentence) in why_not_seen(index, report) {
                self.paragraph(&format!("Not seen: {}.", escaped(&sentence)));
            }
        }
        if let Some(nearest) = nearest(report) {
            self.paragraph(&format!("Here {}.", escaped(&nearest)));
        }
        self.pixel(report);
        self.line("\\par\\endgroup");
    }

    fn sample(&mut self, entry: &ExplainedSample, report: &Report<'_>) {
        let layers = entry.seen.len();
        for (depth, seen) in entry.seen.iter().enumerate() {
            let which = match (depth, layers) {
                (0, 1) => format!("{} sees", share(entry)),
                (0, _) => format!("{} sees first", share(entry)),
                _ => "and behind it".to_owned(),
            };
            match seen {
                Seen::Background { color: behind, alpha, ground } => {
                    let which = capital(&which);
                    let (behind, alpha) = (color(*behind), math(*alpha));
                    let what = if ground.is_some() { "the ground" } else { "the background" };
                    self.paragraph(&format!("{which} {what} ${behind}$, alpha ${alpha}$."));
                    for (label, fact) in ground.iter().flat_map(|ground| ground_facts(ground)) {
                        let (label, fact) = (escaped(&capital(&label)), escaped(&fact));
                        self.paragraph(&format!("{label}: {fact}."));
                    }
                }
                Seen::Surface(surface) => self.surface(&which, surface, report),
            }
        }
        if layers > 1 {
            let mut through = 1.0;
            let mut parts = Vec::new();
            for seen in &entry.seen {
                let (part, shown) = (seen.alpha(), color(seen.display()));
                parts.push(format!("{} \\cdot {} \\cdot {shown}", math(through), math(part)));
                through *= 1.0 - part;
            }
            self.paragraph("Together, $t_k$ being what comes through all that lies before:");
            let (sum, alpha) = (parts.join("\\\\\n&\\quad + "), math(entry.alpha));
            self.display(&[
                "\\alpha &= 1 - \\prod_k (1 - \\alpha_k) = ".to_owned() + &alpha,
                "C &= \\frac{1}{\\alpha} \\sum_k t_k\\, \\alpha_k\\, C_k".to_owned(),
                format!("\\alpha\\, C &= {sum}"),
                format!("C &= {}", color(entry.display)),
            ]);
        }
    }

    fn surface(&mut self, which: &str, surface: &ExplainedSurface, report: &Report<'_>) {
        let path = escaped(&surface_path(surface, report.scene));
        let part = part_of(surface.triangle);
        let model = escaped(&model_name(&surface.material.constants.reflection));
        let which = capital(which);
        self.paragraph(&format!("{which} {part}\\emph{{{path}}}, lit by the model {model}."));
        let points = shading_points(surface);
        let [x, y, z] = surface.position.map(|side| math(side as f32));
        let (n, v) = (vector(surface.normal), vector(surface.view));
        self.paragraph(&format!(
            "$P = ({x},\\, {y},\\, {z})$, $\\mathbf N = {n}$, $\\mathbf V = {v}$."
        ));
        for (at, point) in points.iter().enumerate() {
            if let Some((weight, _)) = point.share {
                let (n, v) = (vector(point.normal), vector(point.view));
                let name = point_name(at, points.len(), report);
                self.paragraph(&format!(
                    "\\textbf{{{name}}} weighs ${}$: $\\mathbf N = {n}$, $\\mathbf V = {v}$.",
                    math(weight)
                ));
            }
            self.point(point);
        }
        let Interpolation { parts, texture } = Interpolation::of(surface, &points);
        if !parts.is_empty() {
            let parts: Vec<_> = parts
                .iter()
                .map(|(weight, light)| format!("{} \\cdot {}", math(*weight), color(*light)))
                .collect();
            let sum = parts.join(" \\\\\n&\\quad + ");
            let mut lines = vec!["I &= \\sum_k w_k I_k".to_owned(), format!("&= {sum}")];
            if let Some(texture) = texture {
                lines[0] = "I &= T \\sum_k w_k I_k".to_owned();
                lines[1] = format!("&= {} \\cdot \\bigl({sum}\\bigr)", color(texture));
            }
            lines.push(format!("&= {}", color(surface.sum)));
            self.paragraph("Interpolated:");
            self.display(&lines);
        }
        if let Some((factor, fog)) = surface.fog {
            self.paragraph(&format!("Fog, ${}$ away along the view:", math(surface.z)));
            let shown = color(surface.color);
            self.display(&[
                "I' &= s\\, I + (1 - s)\\, I_{dc}".to_owned(),
                format!(
                    "&= {} \\cdot {} + {} \\cdot {}",
                    math(factor),
                    color(surface.sum),
                    math(1.0 - factor),
                    color(fog)
                ),
                format!("&= {shown}"),
            ]);
        }
        self.shown(surface, &report.explanation.display);
    }

    /// Exposure and tone curve.
    fn shown(&mut self, surface: &ExplainedSurface, display: &Display) {
        if display.is_identity() {
            return;
        }
        let light = if surface.fog.is_some() { "I'" } else { "I" };
        let exposed = match display.factor() {
            1.0 => light.to_owned(),
            _ => format!("2^{{{}}} {light}", math(display.ev())),
        };
        let curve = display.tone().name();
        let (symbols, text) = match display.tone() {
            Tone::None => (exposed, "As shown, exposed:".to_owned()),
            _ => (format!("T({exposed})"), format!("As shown, by the tone curve {curve}:")),
        };
        self.paragraph(&text);
        self.display(&[format!("C &= {symbols}"), format!("&= {}", color(surface.display))]);
    }

    /// The equation at one point: symbols, numbers, terms, their sum.
    fn point(&mut self, point: &ShadingPoint<'_>) {
        let at_point = point_terms(point);
        // Each term with the number of its light, and its name.
        let own = at_point.own.iter().map(|term| (term, None, term.name.to_owned()));
        let of_lights = at_point.lights.iter().enumerate().flat_map(|(at, light)| {
            light.terms.iter().map(move |term| {
                (term, Some(at + 1), format!("{} of {}", term.name, escaped(&light.light.name)))
            })
        });
        let environment =
            at_point.environment.iter().map(|term| (term, None, term.name.to_owned()));
        let terms: Vec<(&Term, Option<usize>, String)> =
            own.chain(of_lights).chain(environment).collect();
        for (at, light) in at_point.lights.iter().enumerate() {
            self.light(at + 1, light, point);
            self.parts(&light.parts, Some(at + 1));
        }
        self.parts(&at_point.mirrors, None);
        let lines = |first: &str, of: &dyn Fn(&Term, Option<usize>) -> String, names: bool| {
            let line = |(at, (term, light, name)): (usize, &(&Term, Option<usize>, String))| {
                let sign = if at == 0 { first } else { "&\\quad + " };
                let name = if names { format!(" && \\text{{{name}}}") } else { String::new() };
                format!("{sign}{}{name}", of(term, *light))
            };
            terms.iter().enumerate().map(line).collect::<Vec<_>>()
        };
        let mut all = lines("I &= ", &symbols, true);
        all.extend(lines("&= ", &|term, _| numbers(term), false));
        all.extend(lines("&= ", &|term, _| color(term.value), false));
        all.push(format!("&= {}", color(point.sum)));
        if let Some((_, light)) = point.share
            && light != point.sum
        {
            all.push(format!("&\\to {} \\quad\\text{{clamped}}", color(light)));
        }
        self.display(&all);
    }

    /// The parts of a mix: each sum that is a factor, as symbols, numbers and value.
    fn parts(&mut self, parts: &[PartTerm], light: Option<usize>) {
        for same in parts.chunk_by(|one, other| one.of == other.of) {
            let sum = |of: &dyn Fn(&Term) -> String| {
                let terms: Vec<_> = same.iter().map(|part| of(&part.term)).collect();
                terms.join(" \\\\\n&\\quad + ")
            };
            let name = match light {
                Some(at) => numbered(same[0].of.latex, at),
                None => same[0].of.latex.to_owned(),
            };
            let value = same.iter().fold([0.0_f32; 3], |sum, part| {
                [0, 1, 2].map(|channel| sum[channel] + part.term.value[channel])
            });
            self.display(&[
                format!("{name} &= {}", sum(&|term| symbols(term, light))),
                format!("&= {}", sum(&numbers)),
                format!("&= {}", color(value)),
            ]);
        }
    }

    fn light(&mut self, at: usize, entry: &LightEntry<'_>, point: &ShadingPoint<'_>) {
        let light = entry.light;
        let terms = &light.terms;
        let mut text = format!(
            "Light {at}, \\emph{{{}}} ({}): $\\mathbf L_{{{at}}} = {}$, $\\mathbf N\\cdot\\mathbf L_{{{at}}} = {}$",
            escaped(&light.name),
            light.light.kind.name(),
            vector(terms.to_light.lane(0)),
            math(terms.n_dot_l),
        );
        if let Some((name, highlight)) = highlight_vector(point, light) {
            let _ = write!(text, ", $\\mathbf {name}_{{{at}}} = {}$", vector(highlight));
        }
        if let Some(reach) = reach(at, light) {
            let _ = write!(text, ", {reach}");
        }
        if let Some(blocked) = in_the_way(light) {
            let _ = write!(text, "; {}", escaped(&blocked));
        }
        if let Some(why) = &entry.why_not {
            let what = if entry.terms.is_empty() { "no" } else { "no other" };
            let _ = write!(text, "; it adds {what} light: {}", escaped(why));
        }
        self.paragraph(&(text + "."));
    }

    /// From the entries to the bytes.
    fn pixel(&mut self, report: &Report<'_>) {
        let Explanation { samples, linear: [r, g, b, alpha], rgba8, .. } = report.explanation;
        if samples.len() > 1 {
            let part = |entry: &ExplainedSample| {
                let (weight, alpha) = (math(entry.weight), math(entry.alpha));
                format!("{weight} \\cdot {alpha} \\cdot {}", color(entry.display))
            };
            let parts: Vec<_> = samples.iter().map(part).collect();
            self.paragraph("The pixel, by the samples' weights:");
            self.display(&[
                "C &= \\frac{\\sum_j w_j\\, \\alpha_j\\, C_j}{\\sum_j w_j\\, \\alpha_j}".to_owned(),
                format!(
                    "&= \\frac{{1}}{{{}}} \\bigl({}",
                    math(*alpha),
                    parts.join("\\\\\n&\\quad + ")
                ) + "\\bigr)",
                format!("&= {}", color([*r, *g, *b])),
            ]);
        }
        self.paragraph("As bytes:");
        let mut lines = Vec::new();
        if report.view.encoding == PictureEncoding::Srgb {
            lines.push(
                "E(v) &= \\begin{cases} 12.92\\, v & v \\le 0.0031308 \\\\ \
                 1.055\\, v^{1/2.4} - 0.055 & \\text{else} \\end{cases}"
                    .to_owned(),
            );
        } else {
            lines.push("E(v) &= v".to_owned());
        }
        for ((name, value), byte) in [("R", r), ("G", g), ("B", b)].into_iter().zip(rgba8) {
            lines.push(format!(
                "{name} &= \\operatorname{{round}}\\bigl(255\\, E(\\min(\\max({}, 0), 1))\\bigr) = \
                 \\operatorname{{round}}({:.2}) = {byte}",
                math(*value),
                encoded(*value, report.view.encoding),
            ));
        }
        let byte_alpha = rgba8[3];
        lines.push(format!(
            "A &= \\operatorname{{round}}(255 \\cdot {}) = {byte_alpha}",
            math(*alpha)
        ));
        self.display(&lines);
    }
}

/// f as attenuation and cone, of lights that have a position.
fn reach(at: usize, light: &ExplainedLight) -> Option<String> {
    let terms = &light.terms;
    let distance = terms.distance?;
    let mut text = format!("$d_{{{at}}} = {}$", math(distance));
    let mut factors = Vec::new();
    let law = light.light.attenuation;
    if law != Attenuation::NONE {
        let [c1, c2, c3] = law.coefficients.map(math);
        let mut law_text = format!("\\frac{{1}}{{{c1} + {c2} d + {c3} d^2}}");
        if law.limit < Attenuation::NO_LIMIT {
            law_text = format!("\\min\\bigl({law_text}, {}\\bigr)", math(law.limit));
        }
        if let Some(range) = law.range {
            let _ = write!(law_text, "\\bigl(1 - (d / {})^4\\bigr)", math(range));
        }
        let _ = write!(text, ", attenuation ${law_text} = {}$", math(terms.attenuation));
        factors.push(math(terms.attenuation));
    }
    if matches!(light.light.kind, LightKind::Spot(_)) {
        let _ = write!(text, ", cone ${}$", math(terms.spot));
        factors.push(math(terms.spot));
    }
    if factors.len() > 1 {
        let f = math(terms.attenuation * terms.spot);
        let _ = write!(text, ", $f_{{{at}}} = {} = {f}$", factors.join(" \\cdot "));
    }
    Some(text)
}

/// A product by its symbols, those of a light with its number.
fn symbols(term: &Term, light: Option<usize>) -> String {
    let symbol = |factor: &Factor| {
        let symbol = factor.symbol().latex;
        let symbol = match light {
            None => symbol.to_owned(),
            Some(at) => numbered(symbol, at),
        };
        match factor {
            Factor::Cosine(..) => format!("\\max({symbol}, 0)"),
            Factor::Power(..) => format!("\\max({symbol}, 0)^n"),
            _ => symbol,
        }
    };
    term.factors.iter().map(symbol).collect::<Vec<_>>().join("\\, ")
}

/// A symbol with the number of its light.
fn numbered(symbol: &str, at: usize) -> String {
    if symbol == "f" {
        return format!("f_{{{at}}}");
    }
    for (start, letter) in [("I_", "I"), ("\\rho_", "\\rho")] {
        if let Some(which) = symbol.strip_prefix(start) {
            return format!("{letter}_{{{which},{at}}}");
        }
    }
    let mut text = symbol.to_owned();
    for vector in ["\\mathbf L", "\\mathbf R", "\\mathbf H"] {
        text = text.replace(vector, &format!("{vector}_{{{at}}}"));
    }
    text
}

/// A product by its numbers.
fn numbers(term: &Term) -> String {
    let one = |factor: &Factor| match factor {
        Factor::Number(_, value) => math(*value),
        Factor::Color(_, value) => color(*value),
        Factor::Cosine(_, value) => math(value.max(0.0)),
        Factor::Power(_, value, n) => format!("{}^{{{}}}", math(value.max(0.0)), math(*n)),
    };
    term.factors.iter().map(one).collect::<Vec<_>>().join(" \\cdot ")
}

/// A number in math mode.
fn math(value: f32) -> String {
    let text = number(value);
    match text.split_once('e') {
        Some((digits, power)) => format!("{digits} \\times 10^{{{power}}}"),
        None => text,
    }
}

/// A colour: one number where its three are equal.
fn color([r, g, b]: [f32; 3]) -> String {
    if r == g && g == b {
        math(r)
    } else {
        format!("({},\\, {},\\, {})", math(r), math(g), math(b))
    }
}

fn vector(vector: [f32; 3]) -> String {
    let [x, y, z] = vector.map(coordinate);
    format!("({x},\\, {y},\\, {z})")
}

/// Letters beyond ASCII that every LaTeX sets without packages.
const KNOWN: &str = "ÀÁÂÃÄÅÆÇÈÉÊËÌÍÎÏÑÒÓÔÕÖØÙÚÛÜÝßàáâãäåæçèéêëìíîïñòóôõöøùúûüýÿ";

/// A name as text: special characters of LaTeX are escaped, characters that plain LaTeX can't set
/// appear as code points.
fn escaped(name: &str) -> String {
    let mut text = String::with_capacity(name.len());
    for character in name.chars() {
        match character {
            '\\' => text.push_str("\\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => {
                text.push('\\');
                text.push(character);
            }
            '~' => text.push_str("\\textasciitilde{}"),
            '^' => text.push_str("\\textasciicircum{}"),
            '<' => text.push_str("\\textless{}"),
            '>' => text.push_str("\\textgreater{}"),
            '|' => text.push_str("\\textbar{}"),
            '"' => text.push_str("\\textquotedblright{}"),
            // Not joined into dashes and quotes.
            '-' | '`' | '\'' | ',' => {
                text.push(character);
                text.push_str("{}");
            }
            ' '..='~' => text.push(character),
            _ if KNOWN.contains(character) => text.push(character),
            _ => {
                let _ = write!(text, "[U+{:04X}]", u32::from(character));
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_commands_nothing() {
        assert_eq!(escaped("a_b\\input{x}%$"), "a\\_b\\textbackslash{}input\\{x\\}\\%\\$");
        assert_eq!(escaped("ü 木\n"), "ü [U+6728][U+000A]");
        assert_eq!(escaped("--``"), "-{}-{}`{}`{}");
    }

    #[test]
    fn powers_of_ten_are_set_as_such() {
        assert_eq!(math(2.5e-7), "2.5 \\times 10^{-7}");
        assert_eq!(color([0.5; 3]), "0.5");
        assert_eq!(color([0.5, 0.0, 1.0]), "(0.5,\\, 0,\\, 1)");
    }

    #[test]
    fn symbols_of_a_light_have_its_number() {
        assert_eq!(numbered("f", 2), "f_{2}");
        assert_eq!(numbered("I_d", 2), "I_{d,2}");
        let turned = numbered("\\mathbf R\\cdot\\mathbf V", 3);
        assert_eq!(turned, "\\mathbf R_{3}\\cdot\\mathbf V");
    }
}
