//! Every control works by keyboard.

use super::super::panels::{Side, Tab};
use super::*;
use luxel::lighting::{LightKind, LightKindDescription};
use luxel::navigation::StandardView;
use luxel::scene::Restyle;

fn kind(name: &str) -> &'static LightKindDescription {
    LightKindDescription::by_name(name).unwrap()
}

/// Window sizes with room for both panels, but not for their whole length; and for one.
const WIDE: (u32, u32) = (920, 480);
const NARROW: (u32, u32) = (480, 400);

/// All panels with all kinds of controls.
fn stages() -> Vec<(String, Stage)> {
    let mut stages = Vec::new();
    for tab in [Tab::Light, Tab::Explain, Tab::View] {
        let mut stage = Stage::new("spheres", WIDE);
        stage.ui.panels.tab = tab;
        stages.push((format!("{tab:?}"), stage));
    }
    let mut spot = Stage::new("teapot", WIDE);
    spot.ui.panels.chosen_light = Some(spot.session.add_light(kind("spot")));
    stages.push(("a spot".to_owned(), spot));
    for side in [Side::Tree, Side::Settings] {
        let mut stage = Stage::new("spheres", NARROW);
        stage.ui.panels.unfolded = Some(side);
        stages.push((format!("{side:?} alone"), stage));
    }
    let mut compared = Stage::new("plane", WIDE);
    compared.ui.panels.tab = Tab::View;
    compared.session.toggle_comparison();
    stages.push(("two looks".to_owned(), compared));
    stages
}

#[test]
fn every_control_is_reached_by_tab_in_view_and_shows_its_focus() {
    for (name, mut stage) in stages() {
        stage.pass(Vec::new());
        stage.pass(Vec::new());
        let controls = stage.controls();
        let stops = stage.walk(&name);
        assert!(stops.len() > 6, "{name}: {}", stops.len());
        for (id, rect) in controls {
            // Scroll bars follow keyboard focus.
            let is_bar = rect.width() < 12.0 && rect.height() > 60.0;
            assert!(
                is_bar || stops.contains(&id),
                "{name}: focus never reaches {id:?} at {rect:?}"
            );
        }
    }
}

#[test]
fn keys_press_the_axes_and_move_light_handles_and_the_divider() {
    let mut stage = Stage::new("plane", WIDE);
    stage.session.add_light(kind("point"));
    stage.pass(Vec::new());
    let stops = stage.walk("light");
    let (others, knobs) = stops.split_at(stops.len() - 6);
    for knob in knobs {
        stage.focus(Some(*knob));
        stage.press(Key::Space);
        stage.press(Key::Enter);
    }
    let is_view = |command: &UiCommand, view: StandardView| *command == UiCommand::View(view);
    for view in [StandardView::Front, StandardView::Left, StandardView::Bottom] {
        let count = stage.commands.iter().filter(|command| is_view(command, view)).count();
        assert_eq!((count, stage.commands.len()), (2, 12), "{view:?}");
    }
    // The others lie in the picture, between the panels.
    let place = |stage: &Stage, id: Id| stage.ui.context.read_response(id).map(|one| one.rect);
    let free = 250.0..620.0;
    let is_handle = |id: &&Id| place(&stage, **id).is_some_and(|rect| free.contains(&rect.left()));
    let handles: Vec<Id> = others.iter().filter(is_handle).copied().collect();
    let lights = stage.session.view().lights;
    let placed = lights.iter().filter(|light| light.light.kind != LightKind::Ambient);
    assert_eq!(handles.len(), placed.count());
    for id in handles {
        stage.focus(Some(id));
        let (from, before) = (place(&stage, id).unwrap(), stage.session.view().lights);
        stage.press(Key::ArrowRight);
        stage.press(Key::ArrowUp);
        stage.pass(Vec::new());
        let after = stage.session.view().lights;
        let changed = before.iter().zip(&after).filter(|(a, b)| a != b).count();
        assert_eq!((changed, stage.focused()), (1, Some(id)));
        let way = place(&stage, id).unwrap().center() - from.center();
        assert!(way.x > 4.0 && way.y < -4.0, "{way}");
    }
    stage.session.toggle_comparison();
    stage.focus(None);
    let before = stage.session.comparison().unwrap().divider;
    let stops = stage.walk("two looks");
    let tall = |id: &&Id| place(&stage, **id).is_some_and(|rect| rect.height() > 300.0);
    let line = *stops.iter().find(tall).unwrap();
    stage.focus(Some(line));
    stage.press(Key::ArrowLeft);
    assert!(stage.session.comparison().unwrap().divider < before - 0.01);
}

#[test]
fn every_constant_of_a_reflection_model_is_changed_by_its_slider() {
    for (model, used) in [
        ("unlit", &["k_d", "opacity"][..]),
        ("lambert", &["k_a", "k_d", "opacity"]),
        ("oren-nayar", &["k_a", "k_d", "roughness", "opacity"]),
        ("phong", &["k_a", "k_d", "k_s", "n", "opacity"]),
        ("blinn-phong", &["k_a", "k_d", "k_s", "n", "opacity"]),
        ("toon", &["k_a", "k_d", "k_s", "n", "steps", "opacity"]),
        ("microfacet", &["k_a", "k_d", "k_s", "roughness", "metallic", "opacity"]),
        ("mirror", &["k_a", "k_s", "opacity"]),
        ("retro", &["k_a", "k_d", "k_s", "n", "opacity"]),
    ] {
        // High enough for the whole panel.
        let mut stage = Stage::new("teapot", (920, 2000));
        let at = stage.session.material_uses.iter().position(|uses| *uses > 0).unwrap();
        let reflection = luxel::formats::values::reflection(model).unwrap();
        let mut half =
            Restyle { reflection: Some(reflection), opacity: Some(0.5), ..Restyle::default() };
        for parameter in luxel::lighting::SHARED {
            half.set_parameter(parameter, if parameter.name == "shininess" { 9.0 } else { 0.5 });
        }
        stage.session.edit_materials(|overrides| *overrides.edit(at) = half);
        let values = |stage: &Stage| {
            let material =
                stage.session.material_overrides().material(&stage.session.model.scene, at);
            let of = material.constants;
            [
                ("k_a", of.k_a),
                ("k_d", of.k_d),
                ("k_s", of.k_s),
                ("n", of.shininess),
                ("roughness", of.roughness),
                ("metallic", of.metallic),
                ("steps", of.reflection.own("toon-steps").unwrap_or_default()),
                ("opacity", material.opacity),
            ]
        };
        stage.pass(Vec::new());
        stage.pass(Vec::new());
        let mut changed = Vec::new();
        for (id, _) in stage.controls() {
            stage.focus(Some(id));
            let before = values(&stage);
            stage.press(Key::ArrowRight);
            let after = values(&stage);
            let others = before.into_iter().zip(after).filter(|(before, after)| before != after);
            let others: Vec<_> =
                others.map(|((name, before), (_, after))| (name, after > before)).collect();
            assert!(others.len() < 2, "{model}: one slider changes {others:?}");
            changed.extend(others);
        }
        changed.dedup();
        let wanted: Vec<_> = used.iter().map(|name| (*name, true)).collect();
        assert_eq!(changed, wanted, "{model}");
    }
}

#[test]
fn the_tree_is_searched_by_typing_and_all_rows_are_reached() {
    let mut stage = Stage::new("spheres", NARROW);
    stage.ui.panels.unfolded = Some(Side::Tree);
    stage.ui.panels.wants_focus = true;
    stage.pass(Vec::new());
    let count = stage.session.objects.len();
    let all = stage.walk("the tree").len();
    // An eye and a name for each object, visible or not; the field, icons and axes.
    assert!(all > 2 * count, "{all} for {count} objects");
    let named = |stage: &Stage, object: usize| {
        stage.session.path(object).rsplit(" / ").next().unwrap_or_default().to_owned()
    };
    let wanted = named(&stage, count - 1);
    stage.focus_search();
    stage.pass(vec![Event::Text(wanted.to_uppercase())]);
    assert_eq!(stage.ui.panels.search, wanted.to_uppercase());
    let matching = (0..count).filter(|one| stage.session.path(*one).contains(&wanted)).count();
    let left = stage.walk("what was found").len();
    assert_eq!(all - left, 2 * (count - matching), "{wanted}");
}

#[test]
fn windows_of_any_size_are_laid_out_and_painted() {
    for size in [(1, 1), (1, 900), (3000, 20), (80, 60), (899, 30)] {
        let mut stage = Stage::new("plane", size);
        stage.session.toggle_comparison();
        stage.session.add_light(kind("spot"));
        for tab in [Tab::Light, Tab::Explain, Tab::View] {
            stage.ui.panels.tab = tab;
            for unfolded in [None, Some(Side::Tree), Some(Side::Settings)] {
                (stage.ui.panels.unfolded, stage.ui.shows_help) = (unfolded, unfolded.is_none());
                stage.pass(Vec::new());
                stage.pass(Vec::new());
                let _ = stage.pixels();
            }
        }
        stage.session.toggle_difference();
        stage.ui.dialog = Some(PathCompletion::beside("demo:plane".as_ref()));
        stage.pass(Vec::new());
        stage.pass(Vec::new());
        let _ = stage.pixels();
    }
}

#[test]
fn letters_typed_while_a_frame_is_drawn_are_not_lost_to_a_key_or_click_after_them() {
    let escape = |modifiers| Event::Key {
        key: Key::Escape,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    };
    let press = Event::PointerButton {
        pos: egui::pos2(200.0, 200.0),
        button: egui::PointerButton::Primary,
        pressed: true,
        modifiers: Modifiers::NONE,
    };
    for after in [escape(Modifiers::NONE), press] {
        let mut stage = Stage::new("spheres", NARROW);
        stage.ui.panels.unfolded = Some(Side::Tree);
        stage.ui.panels.wants_focus = true;
        stage.pass(Vec::new());
        stage.focus_search();
        stage.pass(vec![Event::Text("mo".to_owned())]);
        stage.pass(vec![Event::Text("on".to_owned()), after.clone()]);
        assert_eq!(stage.ui.panels.search, "moon", "before {after:?}");
    }
}
