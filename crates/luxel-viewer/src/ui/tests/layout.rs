//! What stands in the window: nothing is cut off, names keep their ends, numbers and symbols are written
//! one way.

use super::super::panels::{Side, Tab};
use super::*;
use crate::render::ExplainedPixel;
use egui::Shape;
use luxel::lighting::{K_D, LightKindDescription, Reflection};
use luxel::render::{At, Execution, Renderer, Unseen};
use luxel::scene::DVec3;

/// The smallest window that everything must fit in.
const SMALL: (u32, u32) = (800, 600);
/// A name whose end tells it apart.
const LONG: &str =
    "an/exported/part/of a name that is much too long for any panel/number_0042.gltf";

/// A text in the window: where it stands, and where it is visible.
struct Text {
    text: String,
    rect: Rect,
    clip: Rect,
}

impl Stage {
    /// The texts of the next pass.
    fn texts(&mut self, name: &str, events: Vec<Event>) -> Vec<Text> {
        let points = vec2(self.size.width as f32, self.size.height as f32) / self.scale;
        let before = self.ui.context.input(|input| input.time);
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(egui::Pos2::ZERO, points)),
            // Tooltips wait.
            time: Some(before + 1.0),
            events,
            ..RawInput::default()
        };
        let status =
            Status { name: name.to_owned(), is_chosen: true, triangles: 4242, ..Status::default() };
        let (context, mut commands) = (self.ui.context.clone(), Vec::new());
        let output = context.run(input, |context| {
            self.ui.lay_out(context, Some(&mut self.session), &status, &mut commands);
        });
        let mut texts = Vec::new();
        for shape in output.shapes {
            collect(shape.shape, shape.clip_rect, &mut texts);
        }
        texts
    }

    /// A scene whose names are too long, with everything that can be edited, and an explained pixel.
    fn crowded(size: (u32, u32)) -> Self {
        let mut scene = demos::demo("teapot").unwrap();
        for node in &mut scene.nodes {
            node.name = LONG.into();
        }
        for material in &mut scene.materials {
            material.name = LONG.into();
            let parts = vec![(Reflection::Phong, 0.25), (Reflection::Lambert, 0.75)];
            material.constants.reflection = Reflection::mixed(parts);
        }
        let mut stage = Self::of(scene, size);
        let at = stage.session.add_light(LightKindDescription::by_name("spot").unwrap());
        stage.session.change_display(|display| display.rename(at, LONG));
        stage.session.selection.select([0], crate::selection::SelectMode::Replace);
        stage.session.selection.hovered = Some(0);
        stage.session.edit_materials(|all| all.edit(0).set_parameter(&K_D, 0.75));
        stage.ui.panels.chosen_light = Some(at);
        let view = stage.session.view();
        let scene = Arc::clone(&stage.session.model.scene);
        let renderer = Renderer::new(scene, &Execution::default()).unwrap();
        let pixel = [view.size.width * 2 / 5, view.size.height / 2];
        let explanation = renderer.explain(&view, At::Pixel(pixel)).unwrap();
        let unseen = Unseen::new(&renderer, &view, &explanation).unwrap();
        let explained = ExplainedPixel { explanation, unseen };
        assert!(explained.surface().is_some());
        stage.ui.panels.set_explanation(Some(Box::new(explained)));
        stage
    }
}

fn collect(shape: Shape, clip: Rect, texts: &mut Vec<Text>) {
    match shape {
        Shape::Vec(shapes) => shapes.into_iter().for_each(|shape| collect(shape, clip, texts)),
        Shape::Text(text) => {
            // Labels of a row that wraps begin at its left; only their letters tell where they stand.
            let rect = text.galley.mesh_bounds.translate(text.pos.to_vec2());
            if !rect.is_positive() {
                return;
            }
            let job = &text.galley.job;
            // A mark tells powers from digits.
            let part = |section: &egui::text::LayoutSection| {
                let (size, line) = (section.format.font_id.size, section.format.line_height);
                let is_raised = line.is_some_and(|line| line > size);
                let mark = if is_raised { "\u{2191}" } else { "" };
                format!("{mark}{}", &job.text[section.byte_range.clone()])
            };
            let text = job.sections.iter().map(part).collect();
            texts.push(Text { text, rect, clip });
        }
        _ => {}
    }
}

/// The texts of every panel, of the help, the dialog, a comparison and a measurement, with their names.
fn all_texts(size: (u32, u32)) -> Vec<(String, Vec<Text>)> {
    let mut all = Vec::new();
    let mut add = |name: String, stage: &mut Stage| {
        stage.texts(LONG, Vec::new());
        all.push((name, stage.texts(LONG, Vec::new())));
    };
    let mut stage = Stage::crowded(size);
    for tab in [Tab::Light, Tab::Explain, Tab::View] {
        stage.ui.panels.tab = tab;
        for side in [Side::Tree, Side::Settings] {
            stage.ui.panels.unfolded = Some(side);
            add(format!("{tab:?}, {side:?}"), &mut stage);
        }
    }
    stage.session.toggle_comparison();
    let layer = luxel::render::Layer::Light(LONG.to_owned());
    stage.session.change_display(|display| display.layer = Some(layer));
    add("two looks".to_owned(), &mut stage);
    stage.session.toggle_comparison();
    stage.ui.panels.is_shown = false;
    let from = stage.session.measurement.with_point(Some(DVec3::new(-0.123_456, 0.2, 0.0)));
    stage.session.measurement = from.with_point(Some(DVec3::new(0.345_678, -0.1, 0.9)));
    add("a measurement".to_owned(), &mut stage);
    stage.ui.shows_help = true;
    add("help".to_owned(), &mut stage);
    stage.ui.shows_help = false;
    stage.ui.dialog = Some(PathCompletion::beside("demo:plane".as_ref()));
    add("dialog".to_owned(), &mut stage);
    all
}

#[test]
fn nothing_is_cut_off_in_a_small_window_but_what_scrolls() {
    for size in [SMALL, (640, 480), (920, 600)] {
        let window = Rect::from_min_size(egui::Pos2::ZERO, vec2(size.0 as f32, size.1 as f32));
        for (name, texts) in all_texts(size) {
            assert!(texts.len() > 5, "{name}");
            for Text { text, rect, clip } in texts {
                let seen = clip.intersect(window).expand(1.0);
                let is_across =
                    seen.x_range().contains(rect.left()) && seen.x_range().contains(rect.right());
                if text.ends_with(LONG) && clip.height() < 30.0 {
                    // A text field.
                    continue;
                }
                // A scroll area's lines lie beyond its edges until they are scrolled to.
                let scrolls = clip.height() < window.height() - 40.0;
                let is_down = scrolls
                    || (seen.y_range().contains(rect.top())
                        && seen.y_range().contains(rect.bottom()));
                assert!(
                    is_across && is_down,
                    "{size:?}, {name}: `{text}` at {rect:?}, visible in {clip:?}"
                );
            }
        }
    }
}

#[test]
fn long_names_keep_their_end_and_are_whole_in_a_tooltip() {
    let end = "0042.gltf";
    let mut shortened = 0;
    for (name, texts) in all_texts(SMALL) {
        for Text { text, .. } in &texts {
            // Those of a comparison end in samples.
            if text.contains('\u{2026}') && !text.ends_with("les") {
                assert!(text.contains(end), "{name}: `{text}` has lost its end");
                shortened += 1;
            }
        }
    }
    assert!(shortened > 10, "{shortened}");
    for (tab, side) in [(Tab::Light, Side::Settings), (Tab::Light, Side::Tree)] {
        let mut stage = Stage::crowded(SMALL);
        (stage.ui.panels.tab, stage.ui.panels.unfolded) = (tab, Some(side));
        stage.texts(LONG, Vec::new());
        let texts = stage.texts(LONG, Vec::new());
        let names = texts.iter().filter(|one| one.text.contains('\u{2026}'));
        for place in names.filter(|one| one.clip.contains_rect(one.rect)).map(|one| one.rect) {
            // Neither handles in the picture, nor sentences of the status line.
            if place.left() > 200.0 && (place.right() < 490.0 || place.top() > 570.0) {
                continue;
            }
            stage.texts(LONG, vec![Event::PointerMoved(place.center())]);
            stage.texts(LONG, Vec::new());
            let texts = stage.texts(LONG, Vec::new());
            assert!(texts.iter().any(|one| one.text == LONG), "{side:?}: no tooltip at {place:?}");
        }
    }
}

#[test]
fn numbers_have_four_digits_and_one_minus_everywhere() {
    for (name, texts) in all_texts(SMALL) {
        for Text { text, .. } in texts.iter().filter(|one| !one.text.contains("0042")) {
            assert!(!text.contains('\u{2212}'), "{name}: another minus in `{text}`");
            let is_number = |letter: char| letter.is_ascii_digit() || letter == '.';
            for number in text.split(|letter| !is_number(letter)).filter(|one| one.contains('.')) {
                let digits = number.trim_start_matches(['0', '.']).replace('.', "");
                assert!(digits.len() <= 4, "{name}: {number} in `{text}`");
            }
        }
    }
}

#[test]
fn symbols_have_lowered_letters_and_a_tooltip_that_explains_them() {
    for (name, texts) in all_texts(SMALL) {
        for Text { text, .. } in texts.iter().filter(|one| !one.text.contains("0042")) {
            let path = text.contains('/');
            assert!(path || !text.contains(['_', '^']), "{name}: `{text}` is not laid out");
        }
    }
    let mut stage = Stage::crowded((800, 2400));
    for (tab, symbol, meaning) in [
        (Tab::Light, "Id", "Id: the light's intensity"),
        (Tab::Light, "c1 c2 c3", "c2: the part of 1 / attenuation that grows with d"),
        (Tab::Light, "ka", "ka: how much ambient light"),
        (Tab::Light, "Od", "Od: the surface's diffuse colour"),
        (Tab::Explain, "Oa", "Oa: the surface's ambient colour"),
        (Tab::Explain, "\u{3c1}d", "\u{3c1}d: diffuse reflection"),
    ] {
        (stage.ui.panels.tab, stage.ui.panels.unfolded) = (tab, Some(Side::Settings));
        stage.texts(LONG, Vec::new());
        let texts = stage.texts(LONG, Vec::new());
        let place = texts.iter().find(|one| one.text == symbol);
        let place = place.unwrap_or_else(|| panic!("no {symbol}")).rect.center();
        stage.texts(LONG, vec![Event::PointerMoved(place)]);
        stage.texts(LONG, Vec::new());
        let texts = stage.texts(LONG, Vec::new());
        let all: Vec<_> = texts.iter().map(|one| &one.text).collect();
        let is_there = all.iter().any(|text| text.starts_with(meaning));
        assert!(is_there, "{symbol} at {place} has no tooltip: {all:?}");
    }
}

#[test]
fn the_status_line_says_what_space_does() {
    let mut stage = Stage::crowded(SMALL);
    let line = |stage: &mut Stage| {
        stage.texts(LONG, Vec::new());
        let texts = stage.texts(LONG, Vec::new());
        let found = texts.into_iter().find(|one| one.text.starts_with("Space "));
        found.map(|one| one.text).unwrap_or_default()
    };
    stage.ui.panels.is_shown = false;
    assert_eq!(line(&mut stage), "Space explains the pixel    Tab panels    h help");
    stage.ui.panels.toggle_explanation();
    assert!(line(&mut stage).starts_with("Space hides the explanation"));
    stage.ui.shows_help = true;
    assert!(line(&mut stage).starts_with("Space scrolls the help"));
}

#[test]
fn the_free_part_of_the_window_is_what_panels_leave() {
    for size in [SMALL, (640, 480), (480, 300), (1280, 800)] {
        for scale in [1.0, 2.0] {
            let mut stage = Stage::new("plane", size);
            stage.scale = scale;
            for is_shown in [false, true] {
                for unfolded in [None, Some(Side::Tree), Some(Side::Settings)] {
                    (stage.ui.panels.is_shown, stage.ui.panels.unfolded) = (is_shown, unfolded);
                    stage.pass(Vec::new());
                    stage.pass(Vec::new());
                    stage.pass(Vec::new());
                    let free = stage.ui.context.available_rect();
                    let part = stage.ui.free_part(stage.size, scale);
                    let (left, top) = (part.left as f32, part.top as f32);
                    let part_size = vec2(part.size.width as f32, part.size.height as f32);
                    let found =
                        Rect::from_min_size(egui::pos2(left, top) / scale, part_size / scale);
                    let is_same = (found.min - free.min).abs().max_elem() <= 1.0
                        && (found.max - free.max).abs().max_elem() <= 1.0;
                    assert!(is_same, "{size:?}, {unfolded:?}: {found:?} instead of {free:?}");
                }
            }
        }
    }
}
