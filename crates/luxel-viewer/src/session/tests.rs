use super::*;
use crate::projection::WindowPart;
use luxel::lighting::{K_D, Tone};
use luxel::navigation::{Gesture, Log};
use luxel::scene::{DVec2, demos};
use std::sync::Arc;

const SIZE: Size = Size { width: 640, height: 360 };

fn session(records: bool) -> Session {
    let scene = demos::demo("plane").unwrap();
    let view = luxel::default_view(&scene, SIZE);
    let model = Model::fitted(scene, view);
    Session::new(model, SIZE, Mode::RollingBall, records)
}

#[test]
fn a_recording_replays_bit_identically_from_any_start() {
    let mut recorded = session(true);
    let at = DVec2::new(300.0, 200.0);
    recorded.navigate(Event::Grab { gesture: Gesture::Turn, at, point: None }, 0.25);
    recorded.navigate(Event::Drag { at: at + DVec2::new(40.0, -7.0) }, 0.016);
    recorded.navigate(Event::Release, 0.016);
    recorded.toggle_lens(0.5);
    recorded.fit(WindowPart::whole(SIZE), 0.1);
    recorded.navigate(Event::Wait, 0.07);
    recorded.resize(Size { width: 800, height: 300 });
    recorded.navigate(Event::Wheel { notches: 2.0, at, point: None }, 0.01);
    let log: Log = recorded.log().unwrap().parse().unwrap();
    let mut played = session(false);
    played.navigate(Event::Tap { command: "orbit-up".parse().unwrap(), steps: 5.0 }, 0.0);
    for entry in &log.entries {
        played.play(entry);
    }
    assert_eq!(played.camera(), recorded.camera());
    assert_eq!(played.settings.size, recorded.settings.size);
}

#[test]
fn an_orthographic_lens_and_back_restores_the_camera() {
    let mut session = session(false);
    let before = session.camera();
    session.toggle_lens(0.0);
    assert!(session.camera().projection.is_orthographic());
    session.toggle_lens(0.0);
    let after = session.camera();
    assert!(after.view_from_world.abs_diff_eq(before.view_from_world, 1e-9));
    assert_eq!(after.projection.lens, before.projection.lens);
}

#[test]
fn selected_objects_are_fitted_else_the_visible_ones() {
    use crate::selection::SelectMode;
    let scene = demos::demo("spheres").unwrap();
    let view = luxel::default_view(&scene, SIZE);
    let model = Model::fitted(scene, view);
    let mut session = Session::new(model, SIZE, Mode::Turntable, false);
    let centre = session.bounds(1).centre();
    session.selection.select([1], SelectMode::Replace);
    session.fit_selected(WindowPart::whole(SIZE), 0.0);
    session.navigate(Event::Wait, 10.0);
    assert!(session.state.pivot().abs_diff_eq(centre, 1e-9));
    session.selection.isolate(session.objects.len());
    session.selection.select(None, SelectMode::Replace);
    session.fit(WindowPart::whole(SIZE), 0.0);
    session.navigate(Event::Wait, 10.0);
    assert!(!session.state.pivot().abs_diff_eq(centre, 1e-3));
    session.fit_selected(WindowPart::whole(SIZE), 0.0);
    session.navigate(Event::Wait, 10.0);
    assert!(session.state.pivot().abs_diff_eq(centre, 1e-9));
}

#[test]
fn a_reloaded_model_keeps_camera_edits_and_selection_where_they_still_apply() {
    use crate::selection::SelectMode;
    let mut session = session(false);
    let first = session.model.clone();
    session.navigate(Event::Tap { command: "orbit-up".parse().unwrap(), steps: 5.0 }, 0.0);
    session.change_display(|display| {
        display.view_mut().samples = 16;
        display.view_mut().lights[0].light.scale(0.5);
        display.set_enabled(1, false);
    });
    session.edit_materials(|overrides| overrides.edit(0).set_parameter(&K_D, 0.5));
    session.selection.select([1], SelectMode::Replace);
    let (place, view) = (session.state.view_from_world(), session.view());
    session.reload(first.clone());
    assert_eq!(session.state.view_from_world(), place);
    assert_eq!(session.view().lights, view.lights);
    assert_eq!((session.view().samples, session.selection.selected().len()), (16, 1));
    assert!(session.material_overrides().is_changed(0));
    // Larger, with other lights and one object fewer.
    let mut scene = (*first.scene).clone();
    for mesh in &mut scene.meshes {
        mesh.positions.iter_mut().flatten().for_each(|part| *part *= 3.0);
    }
    let last = scene.objects().pop().unwrap();
    scene.nodes[last.node.index()].mesh = None;
    let mut other = Model { scene: Arc::new(scene), ..first };
    other.view.lights.truncate(1);
    session.reload(other.clone());
    assert_eq!(session.view().lights, other.view.lights);
    assert_eq!(session.state.view_from_world(), place);
    assert!(session.selection.selected().is_empty());
    assert_eq!(session.settings.bounds, other.scene.bounds());
}

#[test]
fn lights_that_are_off_are_not_drawn() {
    let mut session = session(false);
    let all = session.view().lights;
    assert_eq!(session.changed_lights(), None);
    session.change_display(|display| display.set_enabled(0, false));
    assert_eq!(session.view().lights, all[1..]);
    assert_eq!(session.changed_lights().as_deref(), Some(&all[1..]));
}

#[test]
fn changed_lights_are_given_in_coordinates_that_need_no_scene() {
    let mut session = session(false);
    let node = luxel::scene::NodeId(0);
    let pose = session.light_spaces().world_pose(&session.view().lights[0]);
    session
        .change_display(|display| display.view_mut().lights[0].placement = Placement::Node(node));
    session.set_light_pose(0, pose);
    session.change_display(|display| display.view_mut().lights[0].light.scale(2.0));
    let lights = session.changed_lights().unwrap();
    assert_eq!(lights[0].placement, Placement::World);
    let again = session.light_spaces().world_pose(&lights[0]);
    assert!(again.direction.abs_diff_eq(pose.direction, 1e-12));
    assert!(!session.is_environment_changed() && !session.has_surface_changes());
    session.edit_materials(|overrides| overrides.edit(0).set_parameter(&K_D, 0.25));
    assert!(session.has_surface_changes());
}

#[test]
fn compared_settings_keep_their_sides_and_the_panels_edit_one() {
    let mut session = session(false);
    let samples = |session: &Session| {
        session.render_jobs().iter().map(|job| job.view.samples).collect::<Vec<_>>()
    };
    let set = |session: &mut Session, samples| {
        session.change_display(|display| display.view_mut().samples = samples);
    };
    set(&mut session, 8);
    session.toggle_comparison();
    set(&mut session, 1);
    assert_eq!(samples(&session), [8, 1]);
    session.set_active_side(false);
    set(&mut session, 16);
    assert_eq!(samples(&session), [16, 1]);
    let of = |session: &Session, x| session.view_at(x).samples;
    assert_eq!((of(&session, 10.0), of(&session, 600.0)), (16, 1));
    let before = session.revision();
    session.set_active_side(true);
    assert_eq!((samples(&session), session.revision()), (vec![16, 1], before));
    session.toggle_comparison();
    assert_eq!(samples(&session), [1]);
}

#[test]
fn fixed_planes_stay_valid() {
    let mut session = session(false);
    for planes in [[Some(1e6), None], [None, Some(1e-6)], [Some(0.5), Some(9.0)]] {
        session.model.planes = planes;
        let Projection { near, far, .. } = session.camera().projection;
        assert!(near > 0.0 && near < far, "{planes:?}: {near} {far}");
    }
}

#[test]
fn the_exposure_is_metered_when_a_model_is_loaded_and_when_it_is_asked_for() {
    let mut session = session(false);
    assert_eq!((session.view().exposure, session.display().is_auto_exposed), (0.0, true));
    // A brighter light makes the picture brighter.
    session.change_display(|display| display.view_mut().lights[0].light.diffuse = [1024.0; 3]);
    assert_eq!(session.view().exposure, 0.0);
    session.expose_automatically();
    assert_eq!(session.view().exposure, -10.0);
    assert!(session.display().summary().contains("exposure -10"));

    // A new version of the file has its own; a tone curve is the user's for all files.
    let mut model = session.model.clone();
    model.view.lights[0].light.diffuse = [64.0; 3];
    model.view.exposure = -6.0;
    session.reload(model.clone());
    assert_eq!(session.view().exposure, -6.0);
    session.change_display(|display| {
        display.view_mut().exposure = 1.5;
        display.view_mut().tone = Tone::Agx;
        display.is_auto_exposed = false;
    });
    let mut other = model.clone();
    other.view.lights[0].light.diffuse = [32.0; 3];
    other.view.exposure = -5.0;
    session.reload(other.clone());
    assert_eq!(session.view().exposure, 1.5, "the user's own stays");
    let mut next = Session::new(other, SIZE, Mode::RollingBall, false);
    next.copy_display_from(&session);
    assert_eq!((next.view().exposure, next.view().tone), (-5.0, Tone::Agx));
}
