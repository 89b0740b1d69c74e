//! Plots as SVG, in the colours of luxel's picture book, in dark and in light.

use crate::timing::Cost;
use std::fmt::Write;

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 320.0;
/// Left, top, right, bottom of the axes; on the right is room for names.
const FRAME: [f64; 4] = [56.0, 44.0, 540.0, 268.0];

/// Each colour has a contrast of at least 4.5 : 1 to its ground.
const STYLE: &str = "\
text{font:13px system-ui,-apple-system,'Segoe UI',Roboto,sans-serif;fill:currentColor}\
.n{font:11px ui-monospace,'SF Mono',Menlo,Consolas,monospace}\
.s{fill:none;stroke:currentColor;stroke-linejoin:round;stroke-linecap:round}.f{fill:currentColor}\
.g{fill:#fbfaf7}.t{color:#24262a}.q{color:#63656a}.l{color:#c9c4b9}.a{color:#875900}.b{color:#2f6a95}\
.v{color:#77559b}\
@media(prefers-color-scheme:dark){.g{fill:#1b1d21}.t{color:#e8e6e1}.q{color:#9a9c9f}.l{color:#3d4148}\
.a{color:#f2b84b}.b{color:#5aa9e6}.v{color:#c9a2f2}}";

/// What lies below: its name, and where it is told.
pub struct Axis {
    pub name: &'static str,
    pub is_log: bool,
    pub ticks: Vec<(f64, String)>,
}

/// A curve, in the colour of a class.
pub struct Line {
    pub name: &'static str,
    pub color: char,
    pub values: Vec<(f64, f64)>,
}

/// A frame whose stages stand one after the other.
pub struct Bar {
    name: String,
    frame: f64,
    stages: [f64; 3],
}

impl Bar {
    /// Stages are added up over threads, which work beside one another; but for the first, which is told
    /// as time that passes.
    pub fn new(name: String, cost: &Cost, threads: f64) -> Self {
        let stages = [cost.bin, cost.visibility / threads, cost.shade / threads];
        Self { name, frame: cost.frame, stages }
    }
}

fn part(value: f64, [from, to]: [f64; 2], is_log: bool) -> f64 {
    if is_log {
        (value.max(from).ln() - from.ln()) / (to.ln() - from.ln())
    } else {
        (value - from) / (to - from)
    }
}

fn text(svg: &mut String, class: &str, anchor: &str, [x, y]: [f64; 2], words: &str) {
    let _ = writeln!(
        svg,
        "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{words}</text>"
    );
}

fn line(svg: &mut String, class: &str, width: f64, points: &[[f64; 2]]) {
    let points: Vec<_> = points.iter().map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
    let _ = writeln!(
        svg,
        "<path class=\"s {class}\" stroke-width=\"{width}\" d=\"M{}\"/>",
        points.join("L")
    );
}

fn finished(title: &str, height: f64, body: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" \
         height=\"{height}\" role=\"img\">\n<title>{title}</title>\n<style>{STYLE}</style>\n\
         <rect class=\"g\" width=\"{WIDTH}\" height=\"{height}\" rx=\"4\"/>\n{body}</svg>\n"
    )
}

/// Round numbers of milliseconds up to the most: by tens if they grow by factors.
fn round_numbers(least: f64, most: f64, is_log: bool) -> Vec<f64> {
    let decade = |value: f64| 10_f64.powf(value.log10().floor());
    if is_log {
        let mut ticks = vec![decade(least)];
        while ticks.last().is_some_and(|last| *last < most) {
            ticks.push(ticks.last().map_or(1.0, |last| (last * 1e4).round() * 1e-3));
        }
        return ticks;
    }
    let step = [1.0, 2.0, 5.0, 10.0].map(|part| part * decade(most / 3.0));
    let step = step.into_iter().find(|step| most / step <= 5.0).unwrap_or(most);
    (0..=(most / step).ceil() as u32).map(|count| f64::from(count) * step).collect()
}

fn number(value: f64) -> String {
    ((value * 1000.0).round() / 1000.0).to_string()
}

/// Curves over an axis; names stand at their ends.
pub fn lines(title: &str, axis: &Axis, is_log: bool, all: &[Line]) -> String {
    let [left, top, right, bottom] = FRAME;
    let values = || all.iter().flat_map(|line| &line.values);
    let most = values().map(|value| value.1).fold(0.0, f64::max);
    // What takes less than a tenth of a hundredth of the most is not told apart.
    let least = values().map(|value| value.1).fold(most, f64::min).max(most * 1e-3).max(0.01);
    let heights = round_numbers(least, most, is_log);
    let y_range = [heights[0], heights.last().copied().unwrap_or(most)];
    let x_range = match axis.is_log {
        true => [axis.ticks.first(), axis.ticks.last()].map(|tick| tick.map_or(1.0, |tick| tick.0)),
        false => [0.0, axis.ticks.last().map_or(1.0, |tick| tick.0)],
    };
    let at = |(x, y): (f64, f64)| {
        [
            left + (right - left) * part(x, x_range, axis.is_log),
            bottom + (top - bottom) * part(y, y_range, is_log),
        ]
    };
    let mut svg = String::new();
    text(&mut svg, "t", "start", [left - 40.0, 24.0], title);
    for height in heights {
        let [_, y] = at((x_range[1], height));
        line(&mut svg, "l", 1.0, &[[left - 4.0, y], [left, y]]);
        text(&mut svg, "n q", "end", [left - 7.0, y + 4.0], &number(height));
    }
    line(&mut svg, "l", 1.0, &[[left, top], [left, bottom], [right, bottom]]);
    for (value, name) in &axis.ticks {
        let [x, _] = at((*value, y_range[0]));
        line(&mut svg, "l", 1.0, &[[x, bottom], [x, bottom + 4.0]]);
        text(&mut svg, "n q", "middle", [x, bottom + 17.0], name);
    }
    text(&mut svg, "q", "end", [right, bottom + 36.0], axis.name);
    // Names do not lie on one another.
    let mut names: Vec<_> = all
        .iter()
        .map(|one| (at(one.values.last().copied().unwrap_or_default())[1] + 4.0, one))
        .collect();
    names.sort_by(|(one, _), (other, _)| one.total_cmp(other));
    // Nor below the axis: from the lowest upwards, then from the highest downwards.
    let mut below = bottom + 4.0;
    for (y, _) in names.iter_mut().rev() {
        *y = y.min(below);
        below = *y - 15.0;
    }
    for (y, one) in &names {
        let class = one.color.to_string();
        let points: Vec<_> = one.values.iter().map(|value| at(*value)).collect();
        line(&mut svg, &class, if one.name == "frame" { 2.5 } else { 1.75 }, &points);
        for [x, y] in points {
            let _ = writeln!(
                svg,
                "<circle class=\"f {class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.5\"/>"
            );
        }
        text(&mut svg, &class, "start", [right + 10.0, *y], one.name);
    }
    finished(title, HEIGHT, &svg)
}

/// Bars, one below the other, of stages side by side, with the frame's milliseconds behind.
pub fn bars(title: &str, rows: &[Bar]) -> String {
    const ROW: f64 = 32.0;
    let (left, right, top) = (96.0, 560.0, 68.0);
    let most = rows.iter().map(|row| row.frame.max(row.stages.iter().sum())).fold(0.0, f64::max);
    let scale = (right - left) / most;
    let mut svg = String::new();
    text(&mut svg, "t", "start", [16.0, 24.0], title);
    let mut x = left;
    for (name, class) in [("bin", "v"), ("visibility", "b"), ("shade", "a"), ("the rest", "l")] {
        let _ = writeln!(
            svg,
            "<rect class=\"f {class}\" x=\"{x}\" y=\"40\" width=\"10\" height=\"10\" rx=\"2\"/>"
        );
        let ink = if class == "l" { "q" } else { class };
        text(&mut svg, ink, "start", [x + 16.0, 49.5], name);
        x += 100.0;
    }
    for (row, y) in rows.iter().zip((0..).map(|at| top + ROW * f64::from(at))) {
        text(&mut svg, "t", "end", [left - 10.0, y + 15.0], &row.name);
        let mut x = left;
        for (stage, class) in row.stages.iter().zip(["v", "b", "a"]) {
            let width = stage * scale;
            let _ = writeln!(
                svg,
                "<rect class=\"f {class}\" x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"20\"/>"
            );
            x += width;
        }
        // What is no stage's: waiting, and the end of the slower thread.
        let end = x.max(left + row.frame * scale);
        let _ = writeln!(
            svg,
            "<rect class=\"f l\" x=\"{x:.1}\" y=\"{y:.1}\" width=\"{:.1}\" height=\"20\"/>",
            end - x
        );
        text(&mut svg, "n t", "start", [end + 8.0, y + 14.0], &format!("{:.1}", row.frame));
    }
    finished(title, top + ROW * rows.len() as f64 + 12.0, &svg)
}
