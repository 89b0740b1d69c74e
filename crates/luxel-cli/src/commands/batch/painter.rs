//! Draws tasks: a model is read once, its views are drawn one after the other.

use super::flag_reader::FlagReader;
use super::task::{Shot, Task};
use crate::camera;
use crate::commands::render::PictureSettings;
use crate::drawing::{self, Content, Stopwatch};
use crate::failure::Failure;
use crate::model;
use crate::options::InputOptions;
use crate::scene_file::settings_of;
use crate::surface;
use crate::view;
use luxel::formats::values::Surroundings;
use luxel::formats::{FileList, Limits, ReadFile, Setting, SettingValue};
use luxel::render::Renderer;
use luxel::scene::Scene;
use luxel_batch::{
    Begun, Digest, DrawnFile, Finished, Input, KeyInput, TaskError, Work, WorkError, canonical,
    key, keys_of,
};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// How tasks are drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Execution {
    /// Threads of a task.
    pub(crate) threads: usize,
    /// The name of the instruction set.
    pub(crate) simd: &'static str,
    /// The memory limit.
    pub(crate) max_memory: u64,
}

/// Draws tasks of a list whose models are relative to a folder.
pub(crate) struct Painter {
    folder: PathBuf,
    flags: FlagReader,
    max_memory: u64,
    /// The task at work.
    begun: Option<Ready>,
    /// The model of the task before.
    last: Option<Model>,
}

/// A task whose model has been read.
struct Ready {
    task: Task,
    of_scene_file: Vec<Setting>,
    model: Model,
    stopwatch: Stopwatch,
}

/// A model with its renderer.
#[derive(Clone)]
struct Model {
    path: OsString,
    /// The settings that it was read and changed with.
    settings: String,
    files: Vec<ReadFile>,
    inputs: Vec<KeyInput>,
    scene: Arc<Scene>,
    renderer: Arc<Renderer>,
    warnings: Vec<String>,
}

impl Painter {
    pub(crate) fn new(folder: PathBuf, execution: Execution) -> Self {
        let Execution { threads, simd, max_memory } = execution;
        let flags = FlagReader::new(threads, simd, max_memory);
        Self { folder, flags, max_memory, begun: None, last: None }
    }

    /// The model's name: a demo's as it is, a file's in the folder of the list.
    fn model_path(&self, name: &str) -> OsString {
        // In the folder of work, messages have the name as the task has it.
        match name.starts_with("demo:") || self.folder == Path::new(".") {
            true => name.into(),
            false => self.folder.join(name).into_os_string(),
        }
    }

    /// The model of a task, that of the task before if it is the same.
    fn model(
        &mut self,
        path: OsString,
        settings: &PictureSettings,
        stopwatch: &mut Stopwatch,
    ) -> Result<Model, TaskError> {
        let PictureSettings { format, view: options, .. } = settings;
        let text = format!("{format:?} {:?} {:?}", options.material, options.shading);
        let is_same = |last: &Model| {
            let is_as_it_was = |file: &ReadFile| ReadFile::of(&file.path) == *file;
            last.path == path && last.settings == text && last.files.iter().all(is_as_it_was)
        };
        if let Some(last) = self.last.take_if(|last| is_same(last)) {
            return Ok(last);
        }
        self.last = None;
        let list = FileList::default();
        let limits =
            Limits { max_memory: self.max_memory, files: Some(list.clone()), ..Limits::default() };
        let input = InputOptions { model: path.clone(), format: *format };
        let mut read = model::read(&input, &limits).map_err(work_error)?;
        stopwatch.lap("read");
        if read.scene.is_empty() {
            return Err(work_error(model::nothing_to_draw(&input.name())));
        }
        let files = list.files();
        let inputs = key_inputs(&path, &files)?;
        stopwatch.lap("hash");
        surface::apply_material(&options.material, &mut read.scene);
        surface::apply_normals(&options.shading, &mut read.scene);
        stopwatch.lap("normals");
        let scene = Arc::new(read.scene);
        let execution = view::execution(&options.execution);
        let renderer = Renderer::new(Arc::clone(&scene), &execution)
            .map_err(|error| work_error(error.into()))?;
        stopwatch.lap("prepare");
        let renderer = Arc::new(renderer);
        Ok(Model { path, settings: text, files, inputs, scene, renderer, warnings: read.warnings })
    }

    /// Environments that are files, in the folder of the list.
    fn place_environments(&self, settings: &mut [Setting], files: &mut Vec<PathBuf>) {
        for setting in settings.iter_mut().filter(|setting| setting.name == "environment") {
            if let SettingValue::One(text) = &mut setting.value
                && let Ok(Surroundings::File(path)) = luxel::formats::values::surroundings(text)
            {
                let path = self.folder.join(path);
                *text = path.to_string_lossy().into_owned();
                files.push(path);
            }
        }
    }

    /// Draws the views of a shot; `number` counts those of the task.
    fn draw_shot(
        &mut self,
        ready: &mut Ready,
        shot: &Shot,
        number: &mut u32,
        put: &mut dyn FnMut(DrawnFile) -> io::Result<()>,
    ) -> Result<(), WorkError> {
        let Ready { task, of_scene_file, model, stopwatch } = ready;
        let settings = self.flags.read(&[of_scene_file, &task.settings, &shot.settings])?;
        let PictureSettings { view: options, edges, bits, .. } = &settings;
        let contents: Vec<Content> = task
            .layers
            .iter()
            .map(|layer| Content { bits: *bits, ..layer.content.clone() })
            .collect();
        drawing::check_memory(options.frame.size, &contents, self.max_memory)
            .map_err(work_error)?;
        let cameras =
            camera::turntable(&options.frame, &model.scene, shot.count).map_err(work_error)?;
        stopwatch.lap("camera");
        let mut exposure = None;
        for camera in cameras {
            let view = view::next_view(options, *edges, camera, &model.scene, &mut exposure);
            let (view, _) = view.map_err(work_error)?;
            stopwatch.lap("camera");
            let drawn = drawing::draw_all(&model.renderer, &view, &contents, stopwatch);
            for (layer, drawn) in task.layers.iter().zip(drawn.map_err(work_error)?) {
                let file = DrawnFile {
                    view: *number,
                    name: shot.name.clone(),
                    layer: layer.name.clone(),
                    file: format!("{number:03}.{}", layer.ending),
                    bytes: drawn.bytes,
                };
                put(file).map_err(WorkError::Output)?;
                stopwatch.lap("write");
            }
            *number += 1;
        }
        Ok(())
    }
}

impl Work for Painter {
    fn begin(&mut self, line: &str) -> Result<Begun, TaskError> {
        self.begun = None;
        let mut stopwatch = Stopwatch::start();
        let keys = keys_of(line)?;
        let mut task = Task::read(&keys, &self.flags)?;
        let path = self.model_path(&task.model);
        let format = task.format();
        let of_scene_file =
            settings_of(&path, format, Some(self.max_memory)).map_err(work_error)?;
        let mut environments = Vec::new();
        self.place_environments(&mut task.settings, &mut environments);
        for shot in &mut task.shots {
            self.place_environments(&mut shot.settings, &mut environments);
        }
        let settings = self.flags.read(&[&of_scene_file, &task.settings])?;
        stopwatch.lap("task");
        let model = self.model(path, &settings, &mut stopwatch)?;
        let mut inputs = model.inputs.clone();
        let mut files: Vec<PathBuf> = model.files.iter().map(|file| file.path.clone()).collect();
        for path in environments {
            inputs.push(KeyInput { name: "environment".to_owned(), digest: digest_of(&path)? });
            files.push(path);
        }
        let version = env!("CARGO_PKG_VERSION");
        let key = key(version, &canonical(&keys), &inputs);
        stopwatch.lap("hash");
        let inputs = files.iter().map(|path| self.input(path)).collect();
        self.begun = Some(Ready { task, of_scene_file, model, stopwatch });
        Ok(Begun { key, inputs })
    }

    fn finish(
        &mut self,
        put: &mut dyn FnMut(DrawnFile) -> io::Result<()>,
    ) -> Result<Finished, WorkError> {
        let Some(mut ready) = self.begun.take() else {
            return Err(TaskError::of_work("no task has begun").into());
        };
        let shots = std::mem::take(&mut ready.task.shots);
        let mut number = 0;
        for shot in &shots {
            self.draw_shot(&mut ready, shot, &mut number, put)?;
        }
        let ms = ready.stopwatch.milliseconds();
        let warnings = ready.model.warnings.clone();
        self.last = Some(ready.model);
        Ok(Finished { ms: BTreeMap::from_iter(ms), warnings })
    }
}

impl Painter {
    /// A file as logs know it: below the folder of the list by its path from there.
    fn input(&self, path: &Path) -> Input {
        let relative = path.strip_prefix(&self.folder).unwrap_or(path);
        Input::of(&self.folder, &relative.to_string_lossy())
    }
}

/// The digests of the files that a model is made of, each by its name beside the model.
fn key_inputs(model: &OsString, files: &[ReadFile]) -> Result<Vec<KeyInput>, TaskError> {
    let model = Path::new(model);
    if files.is_empty() {
        // A demo is what the program's version makes of its name.
        let name = model.to_string_lossy().into_owned();
        return Ok(vec![KeyInput { name, digest: None }]);
    }
    let folder = model.parent().unwrap_or(Path::new(""));
    // Links are resolved in the paths of files beside the model.
    let resolved = std::fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
    let name = |path: &Path| match path == model {
        // A model's own name tells its format.
        true => format!("model.{}", path.extension().unwrap_or_default().to_string_lossy()),
        false => {
            let beside = path.strip_prefix(folder).or_else(|_| path.strip_prefix(&resolved));
            beside.unwrap_or(path).to_string_lossy().into_owned()
        }
    };
    let input =
        |file: &ReadFile| Ok(KeyInput { name: name(&file.path), digest: digest_of(&file.path)? });
    files.iter().map(input).collect()
}

/// The digest of a file; `None` if it isn't there.
fn digest_of(path: &Path) -> Result<Option<Digest>, TaskError> {
    let digest = File::open(path).and_then(Digest::of_reader);
    match digest {
        Ok((digest, _)) => Ok(Some(digest)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(TaskError::of_work(format!("{}: {error}", path.display()))),
    }
}

/// A failure in one line.
fn work_error(failure: Failure) -> TaskError {
    match &failure {
        // What is said of flags of a line is said of keys of a task.
        Failure::Usage(what) => TaskError::in_list(what.clone()),
        _ => TaskError::of_work(failure.lines().join("; ")),
    }
}

impl From<Failure> for WorkError {
    fn from(failure: Failure) -> Self {
        work_error(failure).into()
    }
}
