//! A task: a model, its views, and the layers of each.

use super::flag_reader::{FlagReader, Of};
use super::layers::{TaskLayer, layers};
use luxel::formats::{Format, Setting, SettingValue};
use luxel_batch::TaskError;
use serde_json::{Map, Value};

/// The most views of a task, which are in memory at the same time; their pictures aren't.
const MOST_VIEWS: usize = 100_000;

/// A task of a list.
#[derive(Debug)]
pub(crate) struct Task {
    /// The model, as the task names it.
    pub(crate) model: String,
    /// Settings for all views.
    pub(crate) settings: Vec<Setting>,
    /// The views, in order.
    pub(crate) shots: Vec<Shot>,
    /// The files of each view.
    pub(crate) layers: Vec<TaskLayer>,
}

/// A view of a task, or the views of an orbit.
#[derive(Debug)]
pub(crate) struct Shot {
    /// Settings that override the task's.
    pub(crate) settings: Vec<Setting>,
    /// The view's name.
    pub(crate) name: Option<String>,
    /// How many views; more than one turn about the target.
    pub(crate) count: u32,
}

impl Task {
    /// The model's format, if the task names it.
    pub(crate) fn format(&self) -> Option<Format> {
        let format = self.settings.iter().find(|setting| setting.name == "format")?;
        match &format.value {
            SettingValue::One(name) => name.parse().ok(),
            _ => None,
        }
    }

    /// The task of the keys of a line.
    ///
    /// # Errors
    /// [`TaskError`] that names the key.
    pub(crate) fn read(keys: &Map<String, Value>, flags: &FlagReader) -> Result<Self, TaskError> {
        let refuse = |message: &str| Err(TaskError::in_list(message));
        let others = ["id", "model", "views", "orbit", "layers"];
        let settings = flags.settings(keys, Of::Task, &others)?;
        let model = match keys.get("model") {
            Some(Value::String(model)) if model == "-" => {
                return refuse("`model`: a task can't read the standard input");
            }
            Some(Value::String(model)) if !model.is_empty() => model.clone(),
            Some(_) => return refuse("`model` must be a string: a file, or demo:NAME"),
            None => return refuse("`model` is missing: give a file, or demo:NAME"),
        };
        let mut shots = Vec::new();
        match keys.get("views") {
            None | Some(Value::Null) => {}
            Some(Value::Array(views)) if !views.is_empty() => {
                for (number, view) in views.iter().enumerate() {
                    let in_view = |error: TaskError| {
                        TaskError::in_list(format!("`views`, number {number}: {}", error.text))
                    };
                    shots.push(view_of(view, flags).map_err(in_view)?);
                }
            }
            Some(_) => return refuse("`views` must be a list of objects, one a view"),
        }
        match keys.get("orbit") {
            None | Some(Value::Null) => {}
            Some(Value::Object(orbit)) => {
                let in_orbit =
                    |error: TaskError| TaskError::in_list(format!("`orbit`: {}", error.text));
                shots.push(orbit_of(orbit, flags).map_err(in_orbit)?);
            }
            Some(_) => return refuse("`orbit` must be an object: {\"count\": 12}"),
        }
        if shots.is_empty() {
            shots.push(Shot { settings: Vec::new(), name: None, count: 1 });
        }
        let views: usize = shots.iter().map(|shot| shot.count as usize).sum();
        if views > MOST_VIEWS {
            return refuse(&format!("a task has at most {MOST_VIEWS} views, not {views}"));
        }
        Ok(Self { model, settings, shots, layers: layers(keys.get("layers"))? })
    }
}

fn view_of(view: &Value, flags: &FlagReader) -> Result<Shot, TaskError> {
    let Value::Object(keys) = view else {
        return Err(TaskError::in_list("a view is an object: {\"azimuth\": 30}"));
    };
    let name = match keys.get("name") {
        None | Some(Value::Null) => None,
        Some(Value::String(name)) => Some(name.clone()),
        Some(_) => return Err(TaskError::in_list("`name` must be a string")),
    };
    Ok(Shot { settings: flags.settings(keys, Of::View, &["name"])?, name, count: 1 })
}

fn orbit_of(keys: &Map<String, Value>, flags: &FlagReader) -> Result<Shot, TaskError> {
    let count =
        keys.get("count").and_then(Value::as_u64).and_then(|count| u32::try_from(count).ok());
    let Some(count @ 1..) = count else {
        return Err(TaskError::in_list("`count` must be a whole number of views, at least 1"));
    };
    Ok(Shot { settings: flags.settings(keys, Of::View, &["count"])?, name: None, count })
}
