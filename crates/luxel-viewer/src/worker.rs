//! The thread that draws, and those that read models, so that the window answers all the while.

use crate::loading::Loading;
use crate::model::Model;
use crate::probe::{Explained, Under, depths, explained, seen, under};
use crate::sheet::Sheet;
use luxel::pick::VisibleIds;
use luxel::render::{Execution, Prepared, Renderer, View};
use luxel::scene::{Camera, Scene, SceneMaterial, Size};
use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Instant;

/// What the threads have to say, and about the how manieth of the models that were asked for.
pub(crate) struct Said {
    pub(crate) about: u64,
    pub(crate) answer: Answer,
}

/// What there is to say.
pub(crate) enum Answer {
    /// A model is there, or why it isn't.
    Loaded(Result<Box<Ready>, String>),
    /// A picture.
    Drawn(Box<Drawn>),
    /// Which objects the last sharp picture shows.
    Seen(Option<Box<VisibleIds>>),
    /// Why a pixel has its colour; nothing, if it can't be told.
    Explained(Option<Box<Explained>>),
    /// The scene can't be drawn, or a view.
    Failed(String),
}

/// A model with what drawing has made ready of it.
pub(crate) struct Ready {
    pub(crate) model: Model,
    prepared: Prepared,
}

/// A picture of the scene.
pub(crate) struct Drawn {
    /// One, or two to be compared.
    pub(crate) pictures: Vec<Vec<[u8; 4]>>,
    pub(crate) camera: Camera,
    pub(crate) size: Size,
    /// Distances along the view, where they were asked for.
    pub(crate) depths: Option<Vec<f32>>,
    pub(crate) purpose: Purpose,
    /// Which objects it shows, where that was asked for or has come since.
    pub(crate) seen: Option<Box<VisibleIds>>,
    /// What it took.
    pub(crate) seconds: f64,
}

/// What a picture is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// To be seen while the camera moves.
    Moving,
    /// To be seen at rest.
    Sharp,
    /// To be kept as a file.
    File,
}

/// What is drawn otherwise than the file has it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Changes {
    /// Objects that are not there; their numbers are those in the whole scene.
    pub(crate) hidden: BTreeSet<usize>,
    /// All materials, if they are not the scene's own.
    pub(crate) materials: Option<Vec<SceneMaterial>>,
}

/// What is to be drawn.
#[derive(Clone, Debug)]
pub(crate) struct Order {
    /// One picture, or two to be compared; of one camera and size.
    pub(crate) sheets: Vec<Sheet>,
    pub(crate) purpose: Purpose,
    /// Whether which objects are seen is needed at once, as something is to be marked.
    pub(crate) is_marked: bool,
    /// Whether distances are needed, as lines are to be drawn between things.
    pub(crate) has_lines: bool,
}

/// What the thread that draws is asked for.
enum Request {
    /// Another scene instead, with its number.
    Show(u64, Arc<Scene>, Box<Prepared>),
    Draw(Box<Order>),
    /// What is not as in the file from now on.
    Change(Box<Changes>),
    Explain(Box<View>, [u32; 2]),
    Probe(Box<View>, [u32; 2], Sender<Option<Under>>),
}

/// Starts a thread that reads a file, as the how manieth model.
type Read = dyn Fn(u64, OsString, Loading) -> std::io::Result<()>;

/// The threads' other end. They end when this goes away.
pub(crate) struct Worker {
    requests: Sender<Request>,
    read: Box<Read>,
    /// How many models were asked for.
    asked: u64,
    /// The one that is being read, or was last.
    loading: Loading,
}

impl Worker {
    /// Loads the first file, and draws what it is asked for, one after the other. `say` wakes the
    /// window; once it says no, the threads end.
    ///
    /// # Errors
    /// The system's, if it gives no thread.
    pub(crate) fn start(
        load: impl Fn(&OsStr, &Loading) -> Result<Model, String> + Send + Sync + 'static,
        first: OsString,
        execution: Execution,
        say: impl Fn(Said) -> bool + Clone + Send + 'static,
    ) -> std::io::Result<Self> {
        let (requests, received) = channel();
        let load = Arc::new(load);
        let drawing = say.clone();
        std::thread::Builder::new().name("luxel-draw".to_owned()).spawn(move || {
            let mut next = None;
            loop {
                next = match next {
                    None => match received.recv() {
                        Ok(Request::Show(number, scene, prepared)) => {
                            Some(Shown { number, scene, prepared })
                        }
                        // There is nothing yet to be drawn.
                        Ok(_) => None,
                        Err(_) => return,
                    },
                    Some(shown) => match work_on(shown, &received, &drawing) {
                        None => return,
                        shown => shown,
                    },
                };
            }
        })?;
        let read = move |about, file: OsString, loading: Loading| {
            let (load, say) = (Arc::clone(&load), say.clone());
            let reading = std::thread::Builder::new().name("luxel-read".to_owned());
            let spawned = reading.spawn(move || {
                let loaded = load(&file, &loading).and_then(|model| {
                    if loading.is_stopped() {
                        return Err("it is not wanted any more".to_owned());
                    }
                    loading.is_whole();
                    let renderer = Renderer::new(Arc::clone(&model.scene), &execution);
                    let prepared = renderer.map_err(|error| error.to_string())?.into_prepared();
                    Ok(Box::new(Ready { model, prepared }))
                });
                if !loading.is_stopped() {
                    say(Said { about, answer: Answer::Loaded(loaded) });
                }
            });
            spawned.map(|_| ())
        };
        let read = Box::new(read);
        let mut worker = Self { requests, read, asked: 0, loading: Loading::default() };
        worker.load(first)?;
        Ok(worker)
    }

    /// Reads another file; what was being read is not wanted any more. If it can't be read, everything
    /// stays as it is.
    ///
    /// # Errors
    /// The system's, if it gives no thread.
    pub(crate) fn load(&mut self, file: OsString) -> std::io::Result<()> {
        self.stop();
        self.loading = Loading::default();
        (self.read)(self.asked, file, self.loading.clone())
    }

    /// What is being read is not wanted any more.
    pub(crate) fn stop(&mut self) {
        self.loading.stop();
        self.asked += 1;
    }

    /// The number of what is being read, or was last.
    pub(crate) fn asked(&self) -> u64 {
        self.asked
    }

    /// How far that has come.
    pub(crate) fn loading(&self) -> &Loading {
        &self.loading
    }

    /// From now on, this is drawn.
    pub(crate) fn show(&self, ready: Ready) -> Model {
        let Ready { model, prepared } = ready;
        let scene = Arc::clone(&model.scene);
        let _ = self.requests.send(Request::Show(self.asked, scene, Box::new(prepared)));
        model
    }

    /// Asks for a picture. One at a time: the window asks for the next when this one has come.
    pub(crate) fn draw(&self, order: Order) {
        // A thread that is gone has said why.
        let _ = self.requests.send(Request::Draw(Box::new(order)));
    }

    /// From now on, the scene is drawn with these changes.
    pub(crate) fn change(&self, changes: Changes) {
        let _ = self.requests.send(Request::Change(Box::new(changes)));
    }

    /// Asks why a pixel has its colour. One at a time, too.
    pub(crate) fn explain(&self, view: View, pixel: [u32; 2]) {
        let _ = self.requests.send(Request::Explain(Box::new(view), pixel));
    }

    /// Asks for what is under a pixel of a view.
    pub(crate) fn probe(&self, view: View, pixel: [u32; 2]) -> Receiver<Option<Under>> {
        let (answer, received) = channel();
        let _ = self.requests.send(Request::Probe(Box::new(view), pixel, answer));
        received
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.loading.stop();
    }
}

/// A scene that is drawn, and what is ready of it.
struct Shown {
    number: u64,
    scene: Arc<Scene>,
    prepared: Box<Prepared>,
}

/// Why drawing comes to an end.
enum End {
    /// The scene is to be drawn with other changes.
    Change(Box<Changes>),
    /// Another scene is to be drawn.
    Show(Shown),
    /// The window is gone.
    Gone,
}

/// Works on the scene as long as it is asked to, whatever is changed of it; the scene to go on with, if
/// there is one.
fn work_on(
    shown: Shown,
    requests: &Receiver<Request>,
    say: &impl Fn(Said) -> bool,
) -> Option<Shown> {
    let Shown { number: about, scene, prepared } = shown;
    let answer = |answer| say(Said { about, answer });
    let mut changes = Changes::default();
    // What is changed is changed in a copy, which is made when it is first needed.
    let mut copy: Option<Arc<Scene>> = None;
    // What the last renderer has made ready of the meshes, which stay the same.
    let mut prepared: Prepared = *prepared;
    loop {
        if changes == Changes::default() {
            copy = None;
        } else {
            let copy = copy.get_or_insert_with(|| Arc::clone(&scene));
            apply(&scene, &changes, Arc::make_mut(copy));
        }
        let renderer = Renderer::again(Arc::clone(copy.as_ref().unwrap_or(&scene)), prepared);
        let count = renderer.objects().len() + changes.hidden.len();
        let numbers: Vec<_> =
            (0..count).filter(|number| !changes.hidden.contains(number)).collect();
        match work(&renderer, &numbers, requests, &answer) {
            End::Change(others) => changes = *others,
            End::Show(shown) => return Some(shown),
            End::Gone => return None,
        }
        prepared = renderer.into_prepared();
    }
}

/// Changes a copy of the scene: takes the meshes of hidden objects from their nodes, gives the others
/// theirs, and all of them their materials.
fn apply(scene: &Scene, changes: &Changes, copy: &mut Scene) {
    for (number, object) in scene.objects().into_iter().enumerate() {
        let mesh = (!changes.hidden.contains(&number)).then_some(object.mesh);
        copy.nodes[object.node.index()].mesh = mesh;
    }
    copy.materials.clone_from(changes.materials.as_ref().unwrap_or(&scene.materials));
}

/// Draws what it is asked for, until there is another scene to draw or nobody to draw for.
fn work(
    renderer: &Renderer,
    numbers: &[usize],
    requests: &Receiver<Request>,
    answer: &impl Fn(Answer) -> bool,
) -> End {
    while let Ok(request) = requests.recv() {
        let is_heard = match request {
            Request::Show(number, scene, prepared) => {
                return End::Show(Shown { number, scene, prepared });
            }
            Request::Change(changes) => return End::Change(changes),
            Request::Draw(order) => draw(renderer, numbers, &order, answer),
            Request::Explain(view, pixel) => {
                let explained = explained(renderer, &view, pixel, numbers);
                answer(Answer::Explained(explained.map(Box::new)))
            }
            // Who has asked may not wait any more.
            Request::Probe(view, pixel, to) => {
                let found = under(renderer, &view, pixel)
                    .and_then(|found| Some(Under { object: *numbers.get(found.object)?, ..found }));
                let _ = to.send(found);
                true
            }
        };
        if !is_heard {
            return End::Gone;
        }
    }
    End::Gone
}

/// Draws what is asked for and hands it over; whether anyone has taken it.
fn draw(
    renderer: &Renderer,
    numbers: &[usize],
    order: &Order,
    answer: &impl Fn(Answer) -> bool,
) -> bool {
    let Some(Sheet { view, .. }) = order.sheets.first() else { return true };
    let start = Instant::now();
    let pictures: Result<Vec<_>, _> =
        order.sheets.iter().map(|sheet| sheet.draw(renderer)).collect();
    let pictures = match pictures {
        Ok(pictures) => pictures,
        Err(error) => return answer(Answer::Failed(error.to_string())),
    };
    let seen = || seen(renderer, view, numbers).map(Box::new);
    let drawn = Drawn {
        pictures,
        camera: view.camera,
        size: view.size,
        depths: if order.has_lines { depths(renderer, view) } else { None },
        purpose: order.purpose,
        seen: if order.is_marked { seen() } else { None },
        seconds: start.elapsed().as_secs_f64(),
    };
    let is_heard = answer(Answer::Drawn(Box::new(drawn)));
    // The picture first: nobody has pointed at anything in it yet.
    let is_to_come = order.purpose == Purpose::Sharp && !order.is_marked;
    is_heard && (!is_to_come || answer(Answer::Seen(seen())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::scene::demos;

    const SIZE: Size = Size { width: 96, height: 64 };

    /// What the thread answers to some requests, after the model itself.
    fn answers(scene: &Scene, requests: impl IntoIterator<Item = Request>) -> Vec<Answer> {
        let (to, received) = channel();
        for request in requests {
            to.send(request).unwrap();
        }
        drop(to);
        let answers = std::cell::RefCell::new(Vec::new());
        let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
        let prepared = Box::new(renderer.into_prepared());
        let shown = Shown { number: 7, scene: Arc::new(scene.clone()), prepared };
        let next = work_on(shown, &received, &|said| {
            assert_eq!(said.about, 7);
            answers.borrow_mut().push(said.answer);
            true
        });
        assert!(next.is_none());
        answers.into_inner()
    }

    fn order(view: &View, purpose: Purpose, is_marked: bool) -> Request {
        let sheets = vec![Sheet { view: view.clone(), layer: None }];
        Request::Draw(Box::new(Order { sheets, purpose, is_marked, has_lines: true }))
    }

    fn drawn(answer: &Answer) -> &Drawn {
        match answer {
            Answer::Drawn(drawn) => drawn,
            _ => panic!("another answer"),
        }
    }

    #[test]
    fn what_is_hidden_is_not_seen_the_others_keep_their_numbers_and_all_comes_back() {
        let scene = demos::demo("spheres").unwrap();
        let count = scene.objects().len();
        assert!(count > 2, "{count}");
        let view = luxel::default_view(&scene, SIZE);
        let draw = || order(&view, Purpose::Moving, true);
        let hide = |objects: &[usize]| {
            let hidden = objects.iter().copied().collect();
            Request::Change(Box::new(Changes { hidden, ..Changes::default() }))
        };
        let all: Vec<_> = (0..count).collect();
        let asked = [draw(), hide(&[0, 2]), draw(), hide(&all), draw(), hide(&[]), draw()];
        let answers = answers(&scene, asked);
        let [whole, part, nothing, again] = answers.as_slice() else { panic!("too few answers") };
        let objects = |answer: &Answer| {
            let seen = drawn(answer).seen.as_ref().unwrap();
            let all = (0..SIZE.height).flat_map(|y| (0..SIZE.width).map(move |x| (x, y)));
            all.filter_map(|(x, y)| Some(seen.at(x, y)?.0)).collect::<BTreeSet<_>>()
        };
        let seen = objects(whole);
        assert!(seen.contains(&0) && seen.contains(&1) && seen.contains(&2), "{seen:?}");
        let rest: BTreeSet<_> = seen.iter().copied().filter(|one| ![0, 2].contains(one)).collect();
        assert!(objects(part).is_superset(&rest) && !objects(part).contains(&0));
        assert!(!objects(part).contains(&2));
        assert!(objects(nothing).is_empty());
        assert_eq!(drawn(again).pictures, drawn(whole).pictures);
    }

    #[test]
    fn a_changed_material_is_drawn_as_a_scene_that_has_it_and_comes_back() {
        let scene = demos::demo("spheres").unwrap();
        let view = luxel::default_view(&scene, SIZE);
        let draw = || order(&view, Purpose::Moving, true);
        let mut other = scene.clone();
        other.materials[1].constants.diffuse = [0.9, 0.1, 0.1];
        let materials = Some(other.materials.clone());
        let dress = |hidden, materials| Request::Change(Box::new(Changes { hidden, materials }));
        let none = BTreeSet::new();
        let asked = [draw(), dress(none.clone(), materials), draw(), dress(none, None), draw()];
        let answers = answers(&scene, asked);
        let [plain, changed, again] = answers.as_slice() else { panic!("too few answers") };
        let renderer = Renderer::new(other, &Execution::default()).unwrap();
        assert_eq!(drawn(changed).pictures, [renderer.rgba8(&view).unwrap().pixels]);
        assert_ne!(drawn(changed).pictures, drawn(plain).pictures);
        assert_eq!(drawn(again).pictures, drawn(plain).pictures);
    }

    fn model(name: &OsStr) -> Result<Model, String> {
        let name = name.to_string_lossy();
        let scene = demos::demo(&name).ok_or_else(|| format!("{name}: no such file"))?;
        let view = luxel::default_view(&scene, SIZE);
        let (up, pivot) = (scene.up, luxel::scene::DVec3::ZERO);
        Ok(Model { scene: Arc::new(scene), view, up, pivot, planes: [None; 2] })
    }

    #[test]
    fn what_is_read_instead_is_shown_and_what_was_stopped_is_never_heard_of() {
        // A file that takes as long as somebody waits for it.
        let load = |file: &OsStr, loading: &Loading| {
            while file == "endless" && !loading.is_stopped() {
                std::thread::yield_now();
            }
            model(file)
        };
        let (to, said) = channel();
        let say = move |one| to.send(one).is_ok();
        let execution = Execution::default();
        let mut worker = Worker::start(load, "endless".into(), execution, say).unwrap();
        worker.load("gone".into()).unwrap();
        let Said { about, answer: Answer::Loaded(Err(what)) } = said.recv().unwrap() else {
            panic!("another answer")
        };
        assert_eq!((about, what.as_str()), (worker.asked(), "gone: no such file"));
        worker.load("endless".into()).unwrap();
        worker.stop();
        worker.load("plane".into()).unwrap();
        let Said { about, answer: Answer::Loaded(Ok(ready)) } = said.recv().unwrap() else {
            panic!("another answer")
        };
        assert_eq!(about, worker.asked());
        let view = worker.show(*ready).view;
        let sheets = vec![Sheet { view, layer: None }];
        let purpose = Purpose::Moving;
        worker.draw(Order { sheets, purpose, is_marked: false, has_lines: false });
        let Said { about: of, answer: Answer::Drawn(drawn) } = said.recv().unwrap() else {
            panic!("another answer")
        };
        assert_eq!((of, drawn.size), (about, SIZE));
    }

    #[test]
    fn objects_follow_a_sharp_picture_and_come_with_a_marked_one() {
        let scene = demos::demo("plane").unwrap();
        let view = luxel::default_view(&scene, SIZE);
        let draw = |purpose, marked| order(&view, purpose, marked);
        let answers = answers(
            &scene,
            [draw(Purpose::Sharp, false), draw(Purpose::Sharp, true), draw(Purpose::Moving, false)],
        );
        let [first, Answer::Seen(Some(seen)), second, third] = answers.as_slice() else {
            panic!("other answers")
        };
        assert!(drawn(first).seen.is_none() && drawn(third).seen.is_none());
        assert_eq!(drawn(second).seen.as_deref(), Some(&**seen));
    }
}
