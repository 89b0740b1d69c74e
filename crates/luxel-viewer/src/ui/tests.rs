//! Every control by the keyboard alone.

use super::*;
use crate::model::Model;
use crate::panels::{Side, Tab};
use crate::theme::DARK;
use egui::{Event, Id, Key, Modifiers};
use luxel::lighting::{LightKind, LightKindDescription};
use luxel::scene::{Restyle, demos};
use std::sync::Arc;

fn kind(name: &str) -> &'static LightKindDescription {
    LightKindDescription::by_name(name).unwrap()
}

/// The panels without a window.
struct Stage {
    ui: Ui,
    session: Session,
    size: Size,
    scale: f32,
    pixels: Vec<u32>,
    wishes: Vec<Wish>,
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
        (ui.shows_panels, ui.is_narrow) = (true, false);
        Self { ui, session, size, scale: 1.0, pixels: Vec::new(), wishes: Vec::new() }
    }

    fn pass(&mut self, events: Vec<Event>) {
        self.ui.events = events;
        self.pixels = vec![0x0020_2428; self.size.width as usize * self.size.height as usize];
        let status = Status { name: "a model".to_owned(), is_chosen: true, ..Status::default() };
        let size = (self.size, self.scale);
        let shown = self.ui.show(Some(&mut self.session), &status, size, &mut self.pixels);
        self.wishes.extend(shown.0);
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

    /// Where everything is that the pointer can press or slide.
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

    /// What Tab comes to, one after the other; each is in view, and shows that it has the keyboard.
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
            // What has been scrolled is seen.
            self.pass(Vec::new());
            self.pass(Vec::new());
            let rect = self.ui.context.read_response(id).unwrap().rect;
            assert!(self.window().contains_rect(rect), "{name}: {id:?} is out of view at {rect:?}");
            let lit = self.pixels.clone();
            self.focus(None);
            let is_shown = self.differs(&lit, rect.expand(6.0));
            assert!(is_shown, "{name}: {id:?} at {rect:?} shows nothing of having the keyboard");
            self.focus(Some(id));
        }
        panic!("{name}: Tab never comes round: {}", stops.len())
    }

    /// Where controls are, in points: all but the line below the picture.
    fn window(&self) -> Rect {
        let size = vec2(self.size.width as f32, self.size.height as f32) / self.scale;
        Rect::from_min_size(egui::Pos2::ZERO, size - vec2(0.0, 28.0)).expand(0.5)
    }

    /// Whether other pixels are another picture somewhere.
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

/// Room for both panels, but not for all of their length; and for one of them.
const WIDE: (u32, u32) = (920, 480);
const NARROW: (u32, u32) = (480, 400);

/// All panels, with all kinds of controls.
fn stages() -> Vec<(String, Stage)> {
    let mut stages = Vec::new();
    for tab in [Tab::Light, Tab::Explain, Tab::View] {
        let mut stage = Stage::new("spheres", WIDE);
        stage.ui.tab = tab;
        stages.push((format!("{tab:?}"), stage));
    }
    let mut spot = Stage::new("teapot", WIDE);
    spot.ui.chosen = Some(spot.session.add_light(kind("spot")));
    stages.push(("a spot".to_owned(), spot));
    for side in [Side::Tree, Side::Settings] {
        let mut stage = Stage::new("spheres", NARROW);
        stage.ui.unfolded = Some(side);
        stages.push((format!("{side:?} alone"), stage));
    }
    let mut compared = Stage::new("plane", WIDE);
    compared.ui.tab = Tab::View;
    compared.session.toggle_split();
    stages.push(("two looks".to_owned(), compared));
    stages
}

#[test]
fn every_control_is_reached_by_tab_in_view_and_shows_that_it_has_the_keyboard() {
    for (name, mut stage) in stages() {
        stage.pass(Vec::new());
        stage.pass(Vec::new());
        let controls = stage.controls();
        let stops = stage.walk(&name);
        assert!(stops.len() > 6, "{name}: {}", stops.len());
        for (id, rect) in controls {
            // Bars of what is scrolled follow the keyboard.
            let is_bar = rect.width() < 12.0 && rect.height() > 60.0;
            assert!(
                is_bar || stops.contains(&id),
                "{name}: the keyboard never comes to {id:?} at {rect:?}"
            );
        }
    }
}

#[test]
fn keys_press_the_axes_and_move_handles_of_lights_and_the_line_between_looks() {
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
    let is_view = |wish: &Wish, view: StandardView| *wish == Wish::View(view);
    for view in [StandardView::Front, StandardView::Left, StandardView::Bottom] {
        let count = stage.wishes.iter().filter(|wish| is_view(wish, view)).count();
        assert_eq!((count, stage.wishes.len()), (2, 12), "{view:?}");
    }
    // What is left of them stands in the picture, between the panels.
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
    stage.session.toggle_split();
    stage.focus(None);
    let before = stage.session.split().unwrap().at;
    let stops = stage.walk("two looks");
    let tall = |id: &&Id| place(&stage, **id).is_some_and(|rect| rect.height() > 300.0);
    let line = *stops.iter().find(tall).unwrap();
    stage.focus(Some(line));
    stage.press(Key::ArrowLeft);
    assert!(stage.session.split().unwrap().at < before - 0.01);
}

#[test]
fn every_constant_that_a_model_of_reflection_heeds_is_changed_by_its_slider() {
    for (model, heeded) in [
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
        // Room for all of the panel.
        let mut stage = Stage::new("teapot", (920, 2000));
        let at = stage.session.uses.iter().position(|uses| *uses > 0).unwrap();
        let reflection = luxel::formats::values::reflection(model).unwrap();
        let half = Restyle {
            reflection: Some(reflection),
            k_a: Some(0.5),
            k_d: Some(0.5),
            k_s: Some(0.5),
            shininess: Some(9.0),
            roughness: Some(0.5),
            metallic: Some(0.5),
            opacity: Some(0.5),
            ..Restyle::default()
        };
        stage.session.change_wardrobe(|wardrobe| *wardrobe.change(at) = half);
        let values = |stage: &Stage| {
            let worn = stage.session.wardrobe().worn(&stage.session.model.scene, at);
            let of = worn.constants;
            [
                ("k_a", of.k_a),
                ("k_d", of.k_d),
                ("k_s", of.k_s),
                ("n", of.shininess),
                ("roughness", of.roughness),
                ("metallic", of.metallic),
                ("steps", of.reflection.own("toon-steps").unwrap_or_default()),
                ("opacity", worn.opacity),
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
        let wanted: Vec<_> = heeded.iter().map(|name| (*name, true)).collect();
        assert_eq!(changed, wanted, "{model}");
    }
}

#[test]
fn the_tree_is_searched_by_typing_and_all_of_its_rows_are_come_to() {
    let mut stage = Stage::new("spheres", NARROW);
    stage.ui.unfolded = Some(Side::Tree);
    stage.ui.wants_focus = true;
    stage.pass(Vec::new());
    let count = stage.session.objects.len();
    let all = stage.walk("the tree").len();
    // An eye and a name of each, however many of them are seen at a time; the field, icons, axes.
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
    assert_eq!(stage.ui.search, wanted.to_uppercase());
    let matching = (0..count).filter(|one| stage.session.path(*one).contains(&wanted)).count();
    let left = stage.walk("what was found").len();
    assert_eq!(all - left, 2 * (count - matching), "{wanted}");
}

#[test]
fn windows_of_any_size_are_laid_out() {
    for size in [(1, 1), (1, 900), (3000, 20), (80, 60), (899, 30)] {
        let mut stage = Stage::new("plane", size);
        stage.session.toggle_split();
        stage.session.add_light(kind("spot"));
        for tab in [Tab::Light, Tab::Explain, Tab::View] {
            stage.ui.tab = tab;
            for unfolded in [None, Some(Side::Tree), Some(Side::Settings)] {
                (stage.ui.unfolded, stage.ui.shows_help) = (unfolded, unfolded.is_none());
                stage.pass(Vec::new());
                stage.pass(Vec::new());
            }
        }
        stage.session.toggle_difference();
        stage.ui.opener = Some(Opener::beside("demo:plane".as_ref()));
        stage.pass(Vec::new());
        stage.pass(Vec::new());
    }
}
