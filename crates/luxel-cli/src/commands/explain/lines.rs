//! The ledger as the lines of a window's panel: the same rows as the text, in less room.

use super::equation::{
    Factor, LightRows, LitPlace, PartRow, Role, Row, color, highlight_vector, lit_places, number,
    reach,
};
use super::rows::rows;
use super::text::{factor_text, mixture_text, symbol_text};
use super::words::{Mixture, kind_name};
use luxel::render::ExplainedSurface;
use luxel_viewer::{LedgerLine, TermKind};

/// The lighting equation of a surface's place with its numbers filled in.
pub(crate) fn lines(surface: &ExplainedSurface) -> Vec<LedgerLine> {
    let mut lines = Vec::new();
    let places = lit_places(surface);
    for (at, place) in places.iter().enumerate() {
        if let Some((weight, _)) = place.share {
            let name = match places.len() {
                1 => "computed elsewhere".to_owned(),
                _ => format!("corner {} of {}", at + 1, places.len()),
            };
            let facts = vec![format!("weighs {}", number(weight))];
            lines.push(LedgerLine::About { name, facts });
        }
        lit(&mut lines, place);
    }
    let Mixture { parts, texture } = Mixture::of(surface, &places);
    let note = if parts.is_empty() { String::new() } else { mixture_text(&parts, texture) };
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

/// The terms of one place.
fn lit(lines: &mut Vec<LedgerLine>, place: &LitPlace<'_>) {
    let rows = rows(place);
    lines.extend(rows.own.iter().map(|row| term(row, None)));
    for light in &rows.lights {
        of_light(lines, light, place);
    }
    lines.extend(rows.mirrors.iter().map(part));
    lines.extend(rows.environment.iter().map(|row| term(row, None)));
    if let Some((_, light)) = place.share {
        let note = if light == place.sum { "" } else { "clamped to 0..1" };
        lines.push(sum("light here", TermKind::Sum, light, note.to_owned()));
    }
}

fn of_light(lines: &mut Vec<LedgerLine>, told: &LightRows<'_>, place: &LitPlace<'_>) {
    let light = told.light;
    let mut facts = vec![format!("N.L = {}", number(light.terms.n_dot_l))];
    if let (Some((name, _)), None) = (highlight_vector(place, light), &told.why_not)
        && let Some(cosine) = light.terms.specular_cosine
    {
        let pair = if name.starts_with('R') { "R.V" } else { "N.H" };
        facts[0] += &format!("   {pair} = {}", number(cosine));
    }
    facts.extend(reach(light));
    let name = format!("{}, {}", light.name, kind_name(&light.light));
    lines.push(LedgerLine::About { name, facts });
    lines.extend(told.parts.iter().map(part));
    lines.extend(told.rows.iter().map(|row| term(row, None)));
    if let Some(why) = &told.why_not {
        let what = if told.rows.is_empty() { "no" } else { "no other" };
        lines.push(LedgerLine::Nothing(format!("adds {what} light: {why}")));
    }
}

/// A part of a mix: a factor of a term that follows.
fn part(PartRow { of, row }: &PartRow) -> LedgerLine {
    term(row, Some(of.text))
}

fn term(row: &Row, part_of: Option<&str>) -> LedgerLine {
    let words = |of: fn(&Factor) -> String, between: &str| {
        row.factors.iter().map(of).collect::<Vec<_>>().join(between)
    };
    let name = part_of.map_or_else(|| row.name.to_owned(), |of| format!("{} in {of}", row.name));
    LedgerLine::Term {
        kind: kind(row.role),
        name,
        symbols: words(symbol_text, " "),
        numbers: words(factor_text, " x "),
        value: row.value,
        is_part: part_of.is_some(),
    }
}

fn kind(role: Role) -> TermKind {
    match role {
        Role::Ambient => TermKind::Ambient,
        Role::Diffuse => TermKind::Diffuse,
        Role::Specular => TermKind::Specular,
        Role::Emission => TermKind::Emission,
        Role::Environment => TermKind::Environment,
        Role::Fog => TermKind::Fog,
        Role::Sum => TermKind::Sum,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::lighting::Reflection;
    use luxel::render::{At, Execution, Renderer, Seen, ShadingMode, View};
    use luxel::scene::{Size, demos};

    fn told(change: impl Fn(&mut View, &mut luxel::scene::Scene)) -> Vec<LedgerLine> {
        let mut scene = demos::demo("teapot").unwrap();
        let mut view = luxel::default_view(&scene, Size { width: 96, height: 54 });
        change(&mut view, &mut scene);
        let renderer = Renderer::new(&scene, &Execution::default()).unwrap();
        let explanation = renderer.explain(&view, At::Pixel([48, 30])).unwrap();
        lines(explanation.samples[0].seen.iter().find_map(Seen::surface).unwrap())
    }

    fn plus(terms: impl Iterator<Item = [f32; 3]>) -> [f32; 3] {
        terms.fold([0.0; 3], |sum, one| std::array::from_fn(|at| sum[at] + one[at]))
    }

    #[test]
    fn the_terms_of_a_panel_add_up_to_its_sum() {
        let mixed = [(Reflection::Microfacet, 0.6), (Reflection::Mirror, 0.4)];
        for reflection in
            [Reflection::BlinnPhong, Reflection::Phong, Reflection::mixed(mixed.to_vec())]
        {
            let lines = told(|_, scene| {
                scene.materials[0].constants.reflection = reflection.clone();
            });
            let terms = lines.iter().filter_map(|line| match line {
                LedgerLine::Term { value, is_part: false, .. } => Some(*value),
                _ => None,
            });
            let Some(LedgerLine::Sum { value, .. }) = lines.last() else { panic!("no sum") };
            let sum = plus(terms);
            assert!(sum.iter().zip(value).all(|(a, b)| (a - b).abs() < 1e-5), "{sum:?} {value:?}");
            assert!(value.iter().any(|part| *part > 0.05));
        }
    }

    #[test]
    fn light_of_corners_is_told_corner_by_corner() {
        let lines = told(|view, _| view.shading.mode = ShadingMode::Gouraud);
        let corners = lines.iter().filter(
            |line| matches!(line, LedgerLine::About { name, .. } if name.starts_with("corner ")),
        );
        assert_eq!(corners.count(), 3);
    }
}
