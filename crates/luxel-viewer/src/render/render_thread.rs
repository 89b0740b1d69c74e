//! The render thread: serves commands for one scene after the other.

use super::event::{
    FramePurpose, RenderRequest, RenderedFrame, SceneOverrides, SelectedObjects, WorkerEvent,
    WorkerMessage,
};
use super::job::RenderJob;
use super::pixel_query::{PixelHit, explain_pixel, hit_at_pixel, render_depths, visible_ids};
use luxel::render::{Prepared, Renderer, View};
use luxel::scene::Scene;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender};
use std::time::Instant;

/// A command to the render thread.
pub(super) enum Command {
    /// Replaces the scene.
    Show(Box<CurrentScene>),
    Render(Box<RenderRequest>),
    SetOverrides(Box<SceneOverrides>),
    Explain(Box<View>, [u32; 2]),
    Select(Box<View>, BTreeSet<usize>),
    HitAtPixel(Box<View>, [u32; 2], Sender<Option<PixelHit>>),
}

/// The scene being rendered, with the data that the renderer precomputes for it.
pub(super) struct CurrentScene {
    /// The model's number.
    pub(super) number: u64,
    pub(super) scene: Arc<Scene>,
    pub(super) prepared: Prepared,
}

/// Why serving commands ends.
enum Exit {
    /// The scene is to be rendered with other overrides.
    SetOverrides(Box<SceneOverrides>),
    /// Another scene is to be rendered.
    Show(Box<CurrentScene>),
    /// The window is gone.
    Disconnected,
}

/// Serves commands for a scene through all changes of its overrides. Returns the next scene; `None` if
/// the window is gone.
pub(super) fn render_scene(
    current: CurrentScene,
    commands: &Receiver<Command>,
    send: &impl Fn(WorkerMessage) -> bool,
) -> Option<CurrentScene> {
    let CurrentScene { number: model_number, scene, mut prepared } = current;
    let send = |event| send(WorkerMessage { model_number, event });
    let mut overrides = SceneOverrides::default();
    // Overrides are applied to a copy, which is made when first needed.
    let mut copy: Option<Arc<Scene>> = None;
    loop {
        if overrides == SceneOverrides::default() {
            copy = None;
        } else {
            let copy = copy.get_or_insert_with(|| Arc::clone(&scene));
            apply(&overrides, &scene, Arc::make_mut(copy));
        }
        // Meshes stay the same, and so do the data precomputed for them.
        let mut renderer = Renderer::again(Arc::clone(copy.as_ref().unwrap_or(&scene)), prepared);
        let count = renderer.objects().len() + overrides.hidden.len();
        let object_ids: Vec<_> =
            (0..count).filter(|object| !overrides.hidden.contains(object)).collect();
        match serve(&mut renderer, &object_ids, commands, &send) {
            Exit::SetOverrides(others) => overrides = *others,
            Exit::Show(next) => return Some(*next),
            Exit::Disconnected => return None,
        }
        prepared = renderer.into_prepared();
    }
}

/// Applies overrides to a copy of the scene: nodes of hidden objects lose their mesh, all others get
/// theirs back; materials are replaced.
fn apply(overrides: &SceneOverrides, scene: &Scene, copy: &mut Scene) {
    for (index, object) in scene.objects().into_iter().enumerate() {
        let mesh = (!overrides.hidden.contains(&index)).then_some(object.mesh);
        copy.nodes[object.node.index()].mesh = mesh;
    }
    copy.materials.clone_from(overrides.materials.as_ref().unwrap_or(&scene.materials));
}

/// Serves commands until one replaces the scene or its overrides. `object_ids` maps the renderer's
/// objects to those of the whole scene.
fn serve(
    renderer: &mut Renderer,
    object_ids: &[usize],
    commands: &Receiver<Command>,
    send: &impl Fn(WorkerEvent) -> bool,
) -> Exit {
    while let Ok(command) = commands.recv() {
        let is_received = match command {
            Command::Show(next) => return Exit::Show(next),
            Command::SetOverrides(overrides) => return Exit::SetOverrides(overrides),
            Command::Render(request) => render(renderer, object_ids, &request, send),
            Command::Explain(view, pixel) => {
                let explained = explain_pixel(renderer, &view, pixel, object_ids);
                send(WorkerEvent::Explained(explained.map(Box::new)))
            }
            Command::Select(view, selected) => {
                let selected = select(renderer, object_ids, &view, selected);
                send(WorkerEvent::SelectedObjects(selected))
            }
            // The window may have stopped waiting.
            Command::HitAtPixel(view, pixel, reply) => {
                let hit = hit_at_pixel(renderer, &view, pixel)
                    .and_then(|hit| Some(PixelHit { object: *object_ids.get(hit.object)?, ..hit }));
                let _ = reply.send(hit);
                true
            }
        };
        if !is_received {
            return Exit::Disconnected;
        }
    }
    Exit::Disconnected
}

/// The selected objects as if nothing else were in the scene.
fn select(
    renderer: &mut Renderer,
    object_ids: &[usize],
    view: &View,
    objects: BTreeSet<usize>,
) -> SelectedObjects {
    let ids: Vec<_> = object_ids.iter().copied().filter(|one| objects.contains(one)).collect();
    if ids.len() == object_ids.len() {
        return SelectedObjects { objects, visible: None };
    }
    renderer.draw_only(|at| object_ids.get(at).is_some_and(|one| objects.contains(one)));
    let visible = visible_ids(renderer, view, &ids).map(Box::new);
    renderer.draw_only(|_| true);
    SelectedObjects { objects, visible }
}

/// Renders a frame and sends it; false if the window is gone.
fn render(
    renderer: &mut Renderer,
    object_ids: &[usize],
    request: &RenderRequest,
    send: &impl Fn(WorkerEvent) -> bool,
) -> bool {
    let Some(RenderJob { view, .. }) = request.jobs.first() else { return true };
    let start = Instant::now();
    let drawn = |job: &RenderJob| job.render(renderer, &request.is_interrupted);
    let pictures: Result<Vec<Option<_>>, _> = request.jobs.iter().map(drawn).collect();
    let pictures = match pictures {
        Ok(pictures) => pictures,
        Err(error) => return send(WorkerEvent::Failed(error.to_string())),
    };
    let Some(pictures) = pictures.into_iter().collect() else {
        return send(WorkerEvent::Interrupted);
    };
    let needs_objects = !request.selected.is_empty();
    let visible = |renderer: &Renderer| visible_ids(renderer, view, object_ids).map(Box::new);
    let frame = RenderedFrame {
        pictures,
        camera: view.camera,
        size: view.size,
        depths: if request.needs_depths { render_depths(renderer, view) } else { None },
        purpose: request.purpose,
        visible: if needs_objects { visible(renderer) } else { None },
        selected: needs_objects
            .then(|| select(renderer, object_ids, view, request.selected.clone())),
        seconds: start.elapsed().as_secs_f64(),
    };
    let is_received = send(WorkerEvent::Rendered(Box::new(frame)));
    // The picture comes first: nobody has pointed at anything in it yet.
    let is_at_rest = matches!(request.purpose, FramePurpose::Refining | FramePurpose::Refined);
    let is_pending = is_at_rest && !needs_objects;
    is_received && (!is_pending || send(WorkerEvent::VisibleObjects(visible(renderer))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::pick::VisibleIds;
    use luxel::render::Execution;
    use luxel::scene::{Size, demos};
    use std::sync::mpsc::channel;

    const SIZE: Size = Size { width: 96, height: 64 };

    /// The events that answer some commands.
    fn events(scene: &Scene, commands: impl IntoIterator<Item = Command>) -> Vec<WorkerEvent> {
        let (to, received) = channel();
        for command in commands {
            to.send(command).unwrap();
        }
        drop(to);
        let events = std::cell::RefCell::new(Vec::new());
        let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
        let prepared = renderer.into_prepared();
        let current = CurrentScene { number: 7, scene: Arc::new(scene.clone()), prepared };
        let next = render_scene(current, &received, &|message| {
            assert_eq!(message.model_number, 7);
            events.borrow_mut().push(message.event);
            true
        });
        assert!(next.is_none());
        events.into_inner()
    }

    fn render_command(view: &View, purpose: FramePurpose, needs_objects: bool) -> Command {
        let jobs = vec![RenderJob { view: view.clone(), layer: None }];
        let selected = needs_objects.then_some(0).into_iter().collect();
        let is_interrupted = Arc::default();
        let request = RenderRequest { jobs, purpose, selected, needs_depths: true, is_interrupted };
        Command::Render(Box::new(request))
    }

    fn frame(event: &WorkerEvent) -> &RenderedFrame {
        match event {
            WorkerEvent::Rendered(frame) => frame,
            _ => panic!("another event"),
        }
    }

    #[test]
    fn hidden_objects_are_invisible_others_keep_their_indices_and_all_come_back() {
        let scene = demos::demo("spheres").unwrap();
        let count = scene.objects().len();
        assert!(count > 2, "{count}");
        let view = luxel::default_view(&scene, SIZE);
        let draw = || render_command(&view, FramePurpose::Interactive, true);
        let hide = |objects: &[usize]| {
            let hidden = objects.iter().copied().collect();
            Command::SetOverrides(Box::new(SceneOverrides { hidden, ..SceneOverrides::default() }))
        };
        let all: Vec<_> = (0..count).collect();
        let commands = [draw(), hide(&[0, 2]), draw(), hide(&all), draw(), hide(&[]), draw()];
        let events = events(&scene, commands);
        let [whole, part, nothing, again] = events.as_slice() else { panic!("too few events") };
        let objects = |event: &WorkerEvent| {
            let seen = frame(event).visible.as_ref().unwrap();
            let all = (0..SIZE.height).flat_map(|y| (0..SIZE.width).map(move |x| (x, y)));
            all.filter_map(|(x, y)| Some(seen.at(x, y)?.0)).collect::<BTreeSet<_>>()
        };
        let seen = objects(whole);
        assert!(seen.contains(&0) && seen.contains(&1) && seen.contains(&2), "{seen:?}");
        let rest: BTreeSet<_> = seen.iter().copied().filter(|one| ![0, 2].contains(one)).collect();
        assert!(objects(part).is_superset(&rest) && !objects(part).contains(&0));
        assert!(!objects(part).contains(&2));
        assert!(objects(nothing).is_empty());
        assert_eq!(frame(again).pictures, frame(whole).pictures);
    }

    #[test]
    fn a_changed_material_renders_as_a_scene_that_has_it_and_is_reverted() {
        let scene = demos::demo("spheres").unwrap();
        let view = luxel::default_view(&scene, SIZE);
        let draw = || render_command(&view, FramePurpose::Interactive, true);
        let mut other = scene.clone();
        other.materials[1].constants.diffuse = [0.9, 0.1, 0.1];
        let materials = Some(other.materials.clone());
        let change = |hidden, materials| {
            Command::SetOverrides(Box::new(SceneOverrides { hidden, materials }))
        };
        let none = BTreeSet::new();
        let commands =
            [draw(), change(none.clone(), materials), draw(), change(none, None), draw()];
        let events = events(&scene, commands);
        let [plain, changed, again] = events.as_slice() else { panic!("too few events") };
        let renderer = Renderer::new(other, &Execution::default()).unwrap();
        assert_eq!(frame(changed).pictures, [renderer.rgba8(&view).unwrap().pixels]);
        assert_ne!(frame(changed).pictures, frame(plain).pictures);
        assert_eq!(frame(again).pictures, frame(plain).pictures);
    }

    #[test]
    fn visible_objects_follow_a_refined_frame_or_come_with_it_on_request() {
        let scene = demos::demo("plane").unwrap();
        let view = luxel::default_view(&scene, SIZE);
        let draw = |purpose, needs_objects| render_command(&view, purpose, needs_objects);
        let events = events(
            &scene,
            [
                draw(FramePurpose::Refined, false),
                draw(FramePurpose::Refined, true),
                draw(FramePurpose::Interactive, false),
            ],
        );
        let [first, WorkerEvent::VisibleObjects(Some(visible)), second, third] = events.as_slice()
        else {
            panic!("other events")
        };
        assert!(frame(first).visible.is_none() && frame(third).visible.is_none());
        assert_eq!(frame(second).visible.as_deref(), Some(&**visible));
    }

    #[test]
    fn selected_objects_are_seen_through_what_stands_before_them() {
        let scene = demos::demo("cornell").unwrap();
        let view = luxel::default_view(&scene, SIZE);
        let draw = |purpose, needs_objects| render_command(&view, purpose, needs_objects);
        let count = scene.objects().len();
        let pixels = |ids: &VisibleIds, object: usize| {
            let all = (0..SIZE.height).flat_map(|y| (0..SIZE.width).map(move |x| (x, y)));
            all.filter(|(x, y)| ids.at(*x, *y).is_some_and(|(at, _)| at == object)).count()
        };
        let mut has_hidden = false;
        for object in 0..count {
            let only = BTreeSet::from([object]);
            let select = Command::Select(Box::new(view.clone()), only.clone());
            let events = events(&scene, [draw(FramePurpose::Refined, true), select]);
            let [whole, WorkerEvent::SelectedObjects(selected)] = events.as_slice() else {
                panic!("other events")
            };
            let (whole, alone) =
                (frame(whole).visible.as_ref().unwrap(), selected.visible.as_ref().unwrap());
            assert_eq!(selected.objects, only);
            assert!(pixels(alone, object) >= pixels(whole, object), "{object}");
            has_hidden |= pixels(alone, object) > pixels(whole, object);
            assert!((0..count).all(|other| other == object || pixels(alone, other) == 0));
        }
        assert!(has_hidden, "nothing stands before anything else");
        // The objects that are drawn come back.
        let select = Command::Select(Box::new(view.clone()), BTreeSet::from([1]));
        let purpose = FramePurpose::Interactive;
        let events = events(&scene, [draw(purpose, true), select, draw(purpose, true)]);
        assert_eq!(frame(&events[0]).pictures, frame(&events[2]).pictures);
        assert_eq!(frame(&events[0]).visible, frame(&events[2]).visible);
    }
}
