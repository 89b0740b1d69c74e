//! The formats of the ledger: each is well-formed, and all agree.

use crate::fixture::{ON_THE_TEAPOT, SIZE, explain, teapot, view, view_from};
use luxel_lighting::Reflection;
use luxel_render::{Cull, Execution, Renderer, Seen, ShadingMode, View};
use luxel_report::{Hint, LedgerLine, Pictures, Report, TermKind, ledger_lines};
use luxel_scene::{Scene, demos};
use serde_json::{Value, json};

/// A name that commands terminals, LaTeX and HTML.
const NASTY: &str = "<script>_$\\input{x}&\"'\u{6728}\x1b[2J";

/// The teapot under another name, lit at its corners.
fn nasty() -> (Scene, View) {
    let mut scene = teapot();
    for node in &mut scene.nodes {
        node.name = NASTY.into();
    }
    let mut view = view(&scene);
    view.lights[0].name = NASTY.to_owned();
    view.shading.mode = ShadingMode::Gouraud;
    (scene, view)
}

fn rgb(value: &Value) -> [f32; 3] {
    [0, 1, 2].map(|channel| value[channel].as_f64().unwrap() as f32)
}

fn plus(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [0, 1, 2].map(|channel| a[channel] + b[channel])
}

#[test]
fn json_reads_back_and_its_terms_add_up() {
    let scene = teapot();
    let view = view(&scene);
    let (explanation, unseen) = explain(&scene, &view, ON_THE_TEAPOT);
    let report = Report::new(&explanation, &scene, &view).with_unseen(&unseen);
    let line = report.to_json().to_string();
    assert!(!line.contains('\n'));
    let document: Value = serde_json::from_str(&line).unwrap();
    assert_eq!(document["pixel"], json!(ON_THE_TEAPOT));
    assert_eq!(document["rgba8"], json!(explanation.rgba8));
    let mut weights = 0.0;
    for sample in document["samples"].as_array().unwrap() {
        weights += sample["weight"].as_f64().unwrap();
        if sample["object"].is_null() {
            continue;
        }
        let mut sum = plus(rgb(&sample["emission"]), rgb(&sample["scene_ambient"]));
        for light in sample["lights"].as_array().unwrap() {
            for term in ["ambient", "diffuse", "specular"] {
                sum = plus(sum, rgb(&light[term]));
            }
        }
        assert_eq!(plus(sum, rgb(&sample["environment"])), rgb(&sample["sum"]));
        assert!(sample["behind"].is_array() && sample["culled"].is_array());
    }
    assert_eq!(weights, 1.0);
}

#[test]
fn what_is_not_given_is_null_and_not_empty() {
    let scene = teapot();
    let view = view(&scene);
    let (explanation, _) = explain(&scene, &view, ON_THE_TEAPOT);
    let report = Report::new(&explanation, &scene, &view);
    let document = report.to_json();
    assert!(document["samples"][0]["behind"].is_null() && document["nearest"].is_null());
    assert!(!report.to_text().contains("hidden"));
    assert!(!report.to_html().contains("<img"));
}

#[test]
fn text_has_no_colours_by_default() {
    let (scene, view) = nasty();
    let (explanation, unseen) = explain(&scene, &view, ON_THE_TEAPOT);
    let report = Report::new(&explanation, &scene, &view).with_unseen(&unseen).with_model(NASTY);
    let text = report.to_text();
    let is_plain = |character: char| !character.is_control() || character == '\n';
    assert!(text.chars().all(is_plain), "{text}");
    assert!(text.contains("corner 3 of 3 weighs"), "{text}");
    let colored = report.to_colored_text();
    assert!(colored.contains("\x1b[38;2;"));
    // Colours stand around the text and change none of it.
    let mut stripped = String::new();
    let mut pieces = colored.split('\x1b');
    stripped.push_str(pieces.next().unwrap());
    for piece in pieces {
        stripped.push_str(piece.split_once('m').unwrap().1);
    }
    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(words(&stripped), words(&text));
}

#[test]
fn latex_closes_what_it_opens() {
    for mode in [ShadingMode::Phong, ShadingMode::Gouraud, ShadingMode::Flat] {
        let (scene, mut view) = nasty();
        view.shading.mode = mode;
        let (explanation, unseen) = explain(&scene, &view, ON_THE_TEAPOT);
        let report =
            Report::new(&explanation, &scene, &view).with_unseen(&unseen).with_model(NASTY);
        let latex = report.to_latex();
        let count = |what: &str| latex.matches(what).count();
        assert_eq!(count("\\begin{align*}"), count("\\end{align*}"));
        assert_eq!(count("\\begin{cases}"), count("\\end{cases}"));
        assert_eq!(count("\\bigl"), count("\\bigr"));
        let mut depth = 0;
        let mut characters = latex.chars();
        while let Some(character) = characters.next() {
            match character {
                '\\' => {
                    characters.next();
                }
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
            }
            assert!(depth >= 0, "{latex}");
        }
        assert_eq!(depth, 0, "{latex}");
        assert!(latex.contains("\\textless{}script") && !latex.contains("\\input"), "{latex}");
        assert_eq!(latex.replace("\\$", "").matches('$').count() % 2, 0, "{latex}");
    }
}

/// Checks that tags are closed in order.
fn check_nesting(page: &str) {
    // Elements without an end tag.
    const VOID: [&str; 4] = ["meta", "img", "br", "!doctype"];
    let style = page.find("<style>").unwrap()..page.find("</style>").unwrap();
    let page = format!("{}{}", &page[..style.start], &page[style.end + "</style>".len()..]);
    let mut open = Vec::new();
    for tag in page.split('<').skip(1) {
        let (tag, _) = tag.split_once('>').unwrap();
        let name = tag.split_whitespace().next().unwrap();
        if let Some(name) = name.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "{open:?}");
        } else if !VOID.contains(&name) && !tag.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?}");
}

#[test]
fn html_is_well_formed_and_self_contained() {
    let (scene, view) = nasty();
    let (explanation, unseen) = explain(&scene, &view, ON_THE_TEAPOT);
    let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
    let pictures = Pictures::draw(&renderer, &view, explanation.pixel).unwrap();
    let report = Report::new(&explanation, &scene, &view)
        .with_unseen(&unseen)
        .with_model(NASTY)
        .with_pictures(&pictures);
    let page = report.to_html();
    check_nesting(&page);
    assert_eq!(page.matches("data:image/png;base64,").count(), 2);
    assert!(!page.contains("<script") && !page.contains("http"), "nothing from outside");
    assert!(page.contains("&lt;script&gt;_$\\input{x}&amp;&quot;&#39;\u{6728}"));
    assert!(Pictures::draw(&renderer, &view, [SIZE.width, 0]).is_err());
}

#[test]
fn all_formats_have_the_same_numbers() {
    let scene = teapot();
    let mut view = view(&scene);
    view.samples = 1;
    let (explanation, unseen) = explain(&scene, &view, ON_THE_TEAPOT);
    let report = Report::new(&explanation, &scene, &view).with_unseen(&unseen);
    let surface = explanation.samples[0].seen.iter().find_map(Seen::surface).unwrap();
    let sum = format!("{:.4}", surface.sum[1]);
    let [r, g, b, _] = explanation.rgba8;
    for (page, bytes) in [
        (report.to_text(), format!("{r} {g} {b}")),
        (report.to_latex(), format!("red {r}, green {g}, blue {b}")),
        (report.to_html(), format!("red {r}, green {g}, blue {b}")),
    ] {
        assert!(page.contains(&sum) && page.contains(&bytes), "{sum}, {bytes}:\n{page}");
    }
}

#[test]
fn hints_are_data_and_worded_by_the_caller() {
    let scene = demos::demo("plane").unwrap();
    // From below, the ground shows its back.
    let mut view = view_from(&scene, -0.5);
    view.cull = Cull::Back;
    let (explanation, unseen) = explain(&scene, &view, [SIZE.width / 2, SIZE.height / 2]);
    let report = Report::new(&explanation, &scene, &view).with_unseen(&unseen);
    assert_eq!(report.hints(), [Hint::ViewCullsBackFaces]);
    assert!(report.to_text().contains(Hint::ViewCullsBackFaces.text()));
    let reworded = report.with_hint_text(|_| "press B").to_text();
    assert!(reworded.contains("shows its back: press B"), "{reworded}");
    let without = Report::new(&explanation, &scene, &view);
    assert_eq!(without.hints(), []);
}

fn lines(change: impl Fn(&mut View, &mut Scene)) -> Vec<LedgerLine> {
    let mut scene = teapot();
    let mut view = view(&scene);
    change(&mut view, &mut scene);
    let (explanation, _) = explain(&scene, &view, ON_THE_TEAPOT);
    let surface = explanation.samples[0].seen.iter().find_map(Seen::surface).unwrap();
    ledger_lines(surface, &explanation.display)
}

#[test]
fn the_terms_of_a_panel_add_up_to_its_sum() {
    let mixed = [(Reflection::Microfacet, 0.6), (Reflection::Mirror, 0.4)];
    for reflection in [Reflection::BlinnPhong, Reflection::Phong, Reflection::mixed(mixed.to_vec())]
    {
        let lines = lines(|_, scene| {
            scene.materials[0].constants.reflection = reflection.clone();
        });
        let terms = lines.iter().filter_map(|line| match line {
            LedgerLine::Term { value, is_part: false, .. } => Some(*value),
            _ => None,
        });
        let Some(LedgerLine::Sum { value, kind: TermKind::Sum, .. }) = lines.last() else {
            panic!("no sum")
        };
        let sum = terms.fold([0.0; 3], plus);
        assert!(sum.iter().zip(value).all(|(a, b)| (a - b).abs() < 1e-5), "{sum:?} {value:?}");
        assert!(value.iter().any(|part| *part > 0.05));
    }
}

#[test]
fn light_evaluated_at_corners_has_a_heading_for_each() {
    let lines = lines(|view, _| view.shading.mode = ShadingMode::Gouraud);
    let corners = lines.iter().filter(
        |line| matches!(line, LedgerLine::Heading { name, .. } if name.starts_with("corner ")),
    );
    assert_eq!(corners.count(), 3);
}

#[test]
fn the_page_draws_the_way_to_a_light_up_to_what_is_in_it() {
    let scene = teapot();
    let view = view(&scene).with_shadows(true).with_ground(true);
    let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
    let (mut drawn, mut clear) = (0, 0);
    for pixel in
        (0..SIZE.height).step_by(6).flat_map(|y| (0..SIZE.width).step_by(8).map(move |x| [x, y]))
    {
        let (explanation, _) = explain(&scene, &view, pixel);
        let pictures = Pictures::draw(&renderer, &view, pixel).unwrap();
        let page = Report::new(&explanation, &scene, &view).with_pictures(&pictures).to_html();
        // What is first seen of the first sample that sees anything.
        let first = explanation.samples.iter().find_map(|entry| match &entry.seen[0] {
            Seen::Surface(surface) => Some(&surface.lights),
            Seen::Background { ground, .. } => ground.as_ref().map(|ground| &ground.lights),
        });
        let blocked = |light: &luxel_render::ExplainedLight| {
            light.shadow.as_ref().is_some_and(|shadow| !shadow.blocked_by.is_empty())
        };
        let rays = first.map_or(0, |lights| lights.iter().filter(|light| blocked(light)).count());
        assert_eq!(page.matches("is in its way</title>").count(), rays, "{pixel:?}");
        if rays == 0 {
            clear += 1;
            assert!(!page.contains("class=\"rays\""));
            continue;
        }
        drawn += 1;
        // It begins in the pixel.
        let line = page.split("class=\"ray\" x1=\"").nth(1).unwrap();
        let numbers: Vec<f64> =
            line.split('"').take(3).filter_map(|part| part.parse().ok()).collect();
        let off =
            (numbers[0] - f64::from(pixel[0]) - 0.5).hypot(numbers[1] - f64::from(pixel[1]) - 0.5);
        assert!(off < 1.0, "{pixel:?}: {numbers:?}");
    }
    assert!(drawn > 10 && clear > 10, "{drawn}, {clear}");
}
