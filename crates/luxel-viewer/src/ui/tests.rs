//! Tests that every control works by keyboard.

use super::panels::{Side, Tab};
use super::*;
use crate::model::Model;
use crate::theme::DARK;
use egui::{Event, Id, Key, Modifiers};
use luxel::lighting::{LightKind, LightKindDescription};
use luxel::navigation::{Mode, StandardView};
use luxel::scene::{Restyle, demos};
use std::sync::Arc;

fn kind(name: &str) -> &'static LightKindDescription {
    LightKindDescription::by_name(name).unwrap()
}

/// The user interface without a window.
struct Stage {
    ui: Ui,
    session: Session,
    size: Size,
    scale: f32,
    pixels: Vec<u32>,
    commands: Vec<UiCommand>,
}

impl Stage {
    fn new(demo: &str, (width, height): (u32, u32)) -> Self {
        let scene = demos::demo(demo).unwrap();
        let size = Size { width, height };
        let view = luxel::default_view(&scene, size);
        let (up, pivot) = (scene.up, scene.bounds().centre());
        let model = Model { scene: Arc::new(scene), view, up, pivot, planes: [None; 2] };
        let session = Session::new(model, size, Mode::Turntable, false);
        let mut ui = Ui::new(&DARK, Keys::default());
        (ui.panels.is_shown, ui.panels.is_narrow) = (true, false);
        Self { ui, session, size, scale: 1.0, pixels: Vec::new(), commands: Vec::new() }
    }

    fn pass(&mut self, events: Vec<Event>) {
        self.ui.events = events;
        self.pixels = vec![0x0020_2428; self.size.width as usize * self.size.height as usize];
        let status = Status { name: "a model".to_owned(), is_chosen: true, ..Status::default() };
        let size = (self.size, self.scale);
        let shown = self.ui.show(Some(&mut self.session), &status, size, &mut self.pixels);
        self.commands.extend(shown.0);
    }

    fn press_with(&mut self, key: Key, modifiers: Modifiers) {
        self.ui.modifiers = modifiers;
        let event =
            |pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
        self.pass(vec![event(true), event(false)]);
        self.ui.modifiers = Modifiers::NONE;
        self.pass(Vec::new());
    }

    fn press(&mut self, key: Key) {
        self.press_with(key, Modifiers::NONE);
    }

    fn focused(&self) -> Option<Id> {
        self.ui.context.memory(egui::Memory::focused)
    }

    fn focus(&mut self, id: Option<Id>) {
        self.ui.context.memory_mut(|memory| match (id, memory.focused()) {
            (Some(id), _) => memory.request_focus(id),
            (None, Some(id)) => memory.surrender_focus(id),
            (None, None) => {}
        });
        self.pass(Vec::new());
    }

    /// All controls that the pointer can press or drag.
    fn controls(&self) -> Vec<(Id, Rect)> {
        self.ui.context.viewport(|viewport| {
            let widgets = viewport.prev_pass.widgets.layers().flat_map(|(_, widgets)| widgets);
            let is_control = |widget: &&egui::WidgetRect| {
                let sense = widget.sense;
                widget.enabled
                    && (sense.senses_click() || sense.senses_drag())
                    && widget.interact_rect.is_positive()
            };
            widgets.filter(is_control).map(|widget| (widget.id, widget.rect)).collect()
        })
    }

    /// The controls that Tab focuses, in order; asserts that each is in view and shows its focus.
    fn walk(&mut self, name: &str) -> Vec<Id> {
        let mut stops = Vec::new();
        self.focus(None);
        for _ in 0..2000 {
            self.press(Key::Tab);
            let Some(id) = self.focused() else { continue };
            if stops.contains(&id) {
                return stops;
            }
            stops.push(id);
            // Lets scrolling settle.
            self.pass(Vec::new());
            self.pass(Vec::new());
            let rect = self.ui.context.read_response(id).unwrap().rect;
            assert!(self.window().contains_rect(rect), "{name}: {id:?} is out of view at {rect:?}");
            let lit = self.pixels.clone();
            self.focus(None);
            let is_shown = self.differs(&lit, rect.expand(6.0));
            assert!(is_shown, "{name}: {id:?} at {rect:?} doesn't show its focus");
            self.focus(Some(id));
        }
        panic!("{name}: Tab never cycles: {}", stops.len())
    }

    /// The window without the status line, in points.
    fn window(&self) -> Rect {
        let size = vec2(self.size.width as f32, self.size.height as f32) / self.scale;
        Rect::from_min_size(egui::Pos2::ZERO, size - vec2(0.0, 28.0)).expand(0.5)
    }

    /// Whether pixels differ from the present ones within a rectangle.
    fn differs(&self, pixels: &[u32], within: Rect) -> bool {
        let within = within.intersect(self.window().shrink(0.5));
        let (left, right) = (within.left() as usize, within.right() as usize);
        let mut rows = within.top() as usize..within.bottom() as usize;
        let width = self.size.width as usize;
        rows.any(|y| {
            let row = y * width + left..y * width + right;
            pixels[row.clone()] != self.pixels[row]
        })
    }
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
    stage.focus(None);
    stage.press(Key::Tab);
    while stage
        .focused()
        .is_none_or(|id| stage.ui.context.read_response(id).unwrap().rect.width() < 100.0)
    {
        stage.press(Key::Tab);
    }
    stage.pass(vec![Event::Text(wanted.to_uppercase())]);
    assert_eq!(stage.ui.panels.search, wanted.to_uppercase());
    let matching = (0..count).filter(|one| stage.session.path(*one).contains(&wanted)).count();
    let left = stage.walk("what was found").len();
    assert_eq!(all - left, 2 * (count - matching), "{wanted}");
}

#[test]
fn windows_of_any_size_are_laid_out() {
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
            }
        }
        stage.session.toggle_difference();
        stage.ui.dialog = Some(PathCompletion::beside("demo:plane".as_ref()));
        stage.pass(Vec::new());
        stage.pass(Vec::new());
    }
}
