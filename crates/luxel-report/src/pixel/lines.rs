//! The ledger as lines for a panel: the same terms as the text, in less room.

use crate::equation::{
    Factor, Interpolation, LightEntry, PartTerm, ShadingPoint, Term, TermKind, factor_text,
    highlight_vector, in_the_way, interpolation_text, point_terms, reach, shading_points,
    symbol_text,
};
use crate::words::{color, number};
use luxel_render::ExplainedSurface;

/// A line of the lighting equation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LedgerLine {
    /// The heading of the lines that follow: a corner or a light.
    Heading {
        /// Its name.
        name: String,
        /// Facts, one a line: weight, cosines, distance and attenuation.
        facts: Vec<String>,
    },
    /// A term of the sum I, or a factor of one.
    Term {
        /// The kind.
        kind: TermKind,
        /// Its name.
        name: String,
        /// The factors of the product: `f`, `I_d`, `k_d`, `O_d`, `max(N.L, 0)`.
        factors: Vec<LedgerFactor>,
        /// Linear red, green, blue.
        value: [f32; 3],
        /// Whether it is a part of a factor of a later term (of a mix of reflection models), and so
        /// no addend of the sum.
        is_part: bool,
    },
    /// Why a light adds nothing.
    Note(String),
    /// The sum of the terms above.
    Sum {
        /// [`TermKind::Sum`], or [`TermKind::Fog`] for the light that fog lets through.
        kind: TermKind,
        /// Its name.
        name: String,
        /// Linear red, green, blue.
        value: [f32; 3],
        /// How it was clamped, interpolated or fogged; may be empty.
        note: String,
    },
}

/// A factor of a product.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LedgerFactor {
    /// As the equation writes it.
    pub symbol: String,
    /// What it means: a line that begins with the symbol.
    pub meaning: &'static str,
    /// Its value.
    pub number: String,
}

/// The lighting equation of a surface with its numbers filled in, line by line.
#[must_use]
pub fn ledger_lines(surface: &ExplainedSurface) -> Vec<LedgerLine> {
    let mut lines = Vec::new();
    let points = shading_points(surface);
    for (at, point) in points.iter().enumerate() {
        if let Some((weight, _)) = point.share {
            let name = match points.len() {
                1 => "computed elsewhere".to_owned(),
                _ => format!("corner {} of {}", at + 1, points.len()),
            };
            let facts = vec![format!("weighs {}", number(weight))];
            lines.push(LedgerLine::Heading { name, facts });
        }
        point_lines(&mut lines, point);
    }
    let Interpolation { parts, texture } = Interpolation::of(surface, &points);
    let note = if parts.is_empty() { String::new() } else { interpolation_text(&parts, texture) };
    lines.push(sum("I", TermKind::Sum, surface.sum, note));
    if let Some((factor, fog)) = surface.fog {
        let note = format!(
            "s I + (1 - s) I_dc = {} I + {} x {}, {} away",
            number(factor),
            number(1.0 - factor),
            color(fog),
            number(surface.z),
        );
        lines.push(sum("I' in fog", TermKind::Fog, surface.color, note));
    }
    lines
}

fn sum(name: &str, kind: TermKind, value: [f32; 3], note: String) -> LedgerLine {
    LedgerLine::Sum { kind, name: name.to_owned(), value, note }
}

/// The terms at one point.
fn point_lines(lines: &mut Vec<LedgerLine>, point: &ShadingPoint<'_>) {
    let at_point = point_terms(point);
    lines.extend(at_point.own.iter().map(|one| term(one, None)));
    for light in &at_point.lights {
        light_lines(lines, light, point);
    }
    lines.extend(at_point.mirrors.iter().map(part));
    lines.extend(at_point.environment.iter().map(|one| term(one, None)));
    if let Some((_, light)) = point.share {
        let note = if light == point.sum { "" } else { "clamped to 0..1" };
        lines.push(sum("light here", TermKind::Sum, light, note.to_owned()));
    }
}

fn light_lines(lines: &mut Vec<LedgerLine>, entry: &LightEntry<'_>, point: &ShadingPoint<'_>) {
    let light = entry.light;
    let mut facts = vec![format!("N.L = {}", number(light.terms.n_dot_l))];
    if let (Some((name, _)), None) = (highlight_vector(point, light), &entry.why_not)
        && let Some(cosine) = light.terms.specular_cosine
    {
        let pair = if name.starts_with('R') { "R.V" } else { "N.H" };
        facts[0] += &format!("   {pair} = {}", number(cosine));
    }
    facts.extend(reach(light));
    let name = format!("{}, {}", light.name, light.light.kind.name());
    lines.push(LedgerLine::Heading { name, facts });
    lines.extend(entry.parts.iter().map(part));
    lines.extend(entry.terms.iter().map(|one| term(one, None)));
    lines.extend(in_the_way(light).map(LedgerLine::Note));
    if let Some(why) = &entry.why_not {
        let what = if entry.terms.is_empty() { "no" } else { "no other" };
        lines.push(LedgerLine::Note(format!("adds {what} light: {why}")));
    }
}

/// A part of a mix: a factor of a term that follows.
fn part(PartTerm { of, term: one }: &PartTerm) -> LedgerLine {
    term(one, Some(of.text))
}

fn term(term: &Term, part_of: Option<&str>) -> LedgerLine {
    let factor = |factor: &Factor| LedgerFactor {
        symbol: symbol_text(factor),
        meaning: factor.symbol().meaning,
        number: factor_text(factor),
    };
    let name = part_of.map_or_else(|| term.name.to_owned(), |of| format!("{} in {of}", term.name));
    LedgerLine::Term {
        kind: term.kind,
        name,
        factors: term.factors.iter().map(factor).collect(),
        value: term.value,
        is_part: part_of.is_some(),
    }
}
