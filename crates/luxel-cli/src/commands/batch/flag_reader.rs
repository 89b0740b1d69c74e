//! The settings of a task as flags of `luxel render`, read by the flags' own parsers.

use crate::commands::render::{PictureSettings, RenderCommand};
use crate::scene_file::flags::ON_THE_LINE;
use crate::scene_file::{value_error, words};
use clap::error::ErrorKind as UsageKind;
use clap::{Arg, Args, Command, FromArgMatches};
use luxel::formats::values::nearest;
use luxel::formats::{Place, Setting, SettingValue};
use luxel::lighting::parameters;
use luxel_batch::TaskError;
use serde_json::{Map, Value};
use std::collections::HashMap;
use std::ffi::OsString;

/// Flags that change the model rather than a view of it, besides those of reflection parameters.
const OF_THE_MODEL: [&str; 6] = ["format", "color", "emission", "reflection", "normals", "crease"];

/// Flags with another key in a task.
const ELSEWHERE: [(&str, &str); 3] = [
    ("layer", "write `layers`, a list"),
    ("turntable", "write `orbit`: {\"count\": ..}"),
    ("format", "write `format` in the task, not in a view"),
];

/// Lines that have been read before: more would take too much memory.
const MOST_READ: usize = 4096;

/// Which object of a task holds settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Of {
    /// The task.
    Task,
    /// One of its views, or its orbit.
    View,
}

/// Reads settings.
pub(crate) struct FlagReader {
    render: Command,
    /// Flags of all tasks.
    common: Vec<OsString>,
    /// What lines of flags mean: tasks of a list have most of them in common.
    read: HashMap<Vec<OsString>, PictureSettings>,
    /// The flags that exclude a flag.
    excluded: HashMap<String, Vec<String>>,
}

impl FlagReader {
    /// Reads settings for tasks with these execution options.
    pub(crate) fn new(threads: usize, simd: &str, max_memory: u64) -> Self {
        let mut render = RenderCommand::augment_args(Command::new("render"));
        render.build();
        let common = vec![
            format!("--max-memory={max_memory}").into(),
            format!("--threads={threads}").into(),
            format!("--simd={simd}").into(),
        ];
        Self { render, common, read: HashMap::new(), excluded: HashMap::new() }
    }

    /// The settings among the keys of an object; `others` are its keys that aren't settings.
    ///
    /// # Errors
    /// [`TaskError`] that names the key.
    pub(crate) fn settings(
        &self,
        keys: &Map<String, Value>,
        of: Of,
        others: &[&str],
    ) -> Result<Vec<Setting>, TaskError> {
        let mut settings: Vec<Setting> = Vec::new();
        for (key, value) in keys {
            if others.contains(&key.as_str()) || value.is_null() {
                continue;
            }
            let name = key.replace('_', "-");
            let arg = self.arg(key, &name, of, others).map_err(TaskError::in_list)?;
            if settings.iter().any(|setting| setting.name == name) {
                return Err(TaskError::in_list(format!("`{key}` is there twice")));
            }
            let at_value = |message| TaskError::in_list(format!("`{key}`: {message}"));
            let value = setting_value(value).map_err(at_value)?;
            let setting = Setting { name, place: Place::File, value, value_place: Place::File };
            words(&setting, arg).map_err(at_value)?;
            settings.push(setting);
        }
        Ok(settings)
    }

    /// The flag of a key.
    fn arg(&self, key: &str, name: &str, of: Of, others: &[&str]) -> Result<&Arg, String> {
        if ON_THE_LINE.contains(&name) && name != "format" {
            return Err(format!("`{key}` is not a setting of a task: it is for the command line"));
        }
        if of == Of::View && is_of_the_model(name) {
            return Err(format!("`{key}` changes the model: write it in the task, not in a view"));
        }
        let elsewhere = ELSEWHERE.iter().filter(|_| name != "format" || of == Of::View);
        if let Some((_, instead)) = elsewhere.into_iter().find(|(flag, _)| *flag == name) {
            return Err(format!("`{key}` is not a setting of a task: {instead}"));
        }
        if let Some(arg) = self.flag(name) {
            return Ok(arg);
        }
        let is_key = |flag: &&str| {
            let is_setting = !ON_THE_LINE.contains(flag)
                && ELSEWHERE.iter().all(|(other, _)| other != flag)
                && !(of == Of::View && is_of_the_model(flag));
            is_setting || (*flag == "format" && of == Of::Task)
        };
        let flags = self.render.get_arguments().filter_map(Arg::get_long).filter(is_key);
        let known: Vec<String> = flags
            .map(|flag| flag.replace('-', "_"))
            .chain(others.iter().map(|&key| key.to_owned()))
            .collect();
        let written = name.replace('-', "_");
        Err(match nearest(&written, known.iter().map(String::as_str)) {
            Some(meant) => format!("`{key}` is unknown: did you mean `{meant}`?"),
            None => format!("`{key}` is unknown: use {}", known.join(", ")),
        })
    }

    fn flag(&self, name: &str) -> Option<&Arg> {
        self.render.get_arguments().find(|arg| arg.get_long() == Some(name))
    }

    /// The settings of a picture: of several lists, each overrides those before it, and drops of them
    /// what it conflicts with.
    ///
    /// # Errors
    /// [`TaskError`] if a value is wrong, or two settings of a list exclude each other.
    pub(crate) fn read(&mut self, lists: &[&[Setting]]) -> Result<PictureSettings, TaskError> {
        let mut kept: Vec<&Setting> = Vec::new();
        for list in lists.iter().rev() {
            let mut of_list = Vec::new();
            for setting in *list {
                if !kept.iter().any(|above| self.overrides(&above.name, &setting.name)) {
                    of_list.push(setting);
                }
            }
            of_list.append(&mut kept);
            kept = of_list;
        }
        let mut line: Vec<OsString> = vec!["render".into(), "--output=x.png".into()];
        line.extend(self.common.iter().cloned());
        for setting in &kept {
            line.extend(
                self.flag(&setting.name)
                    .and_then(|arg| words(setting, arg).ok())
                    .into_iter()
                    .flatten(),
            );
        }
        if let Some(known) = self.read.get(&line) {
            return Ok(known.clone());
        }
        let matches = self.render.try_get_matches_from_mut(&line);
        let read = matches.and_then(|matches| RenderCommand::from_arg_matches(&matches));
        let settings = match read {
            Ok(read) => read.into_settings(),
            Err(error) => return Err(self.explained(&kept, &error)),
        };
        if self.read.len() == MOST_READ {
            self.read.clear();
        }
        self.read.insert(line, settings.clone());
        Ok(settings)
    }

    /// Whether a setting drops another one below it.
    fn overrides(&mut self, above: &str, below: &str) -> bool {
        if above == below {
            return true;
        }
        for name in [above, below] {
            if !self.excluded.contains_key(name) {
                let excluded = self.flag(name).map(|arg| self.render.get_arg_conflicts_with(arg));
                let names = excluded.unwrap_or_default().into_iter().filter_map(Arg::get_long);
                let names = names.map(str::to_owned).collect();
                self.excluded.insert(name.to_owned(), names);
            }
        }
        let excludes = |one: &str, other: &str| {
            self.excluded.get(one).is_some_and(|names| names.iter().any(|name| name == other))
        };
        excludes(above, below) || excludes(below, above)
    }

    /// The error of a line, with the key that caused it.
    fn explained(&mut self, settings: &[&Setting], error: &clap::Error) -> TaskError {
        for setting in settings {
            let mut line: Vec<OsString> = vec!["render".into(), "--output=x.png".into()];
            let Some(arg) = self.flag(&setting.name) else { continue };
            line.extend(words(setting, arg).unwrap_or_default());
            if let Err(error) = self.render.try_get_matches_from_mut(&line)
                && let Some(message) = value_error(&error)
            {
                let key = setting.name.replace('-', "_");
                return TaskError::in_list(format!("`{key}`: {message}"));
            }
        }
        if error.kind() == UsageKind::ArgumentConflict {
            for (place, one) in settings.iter().enumerate() {
                for other in &settings[..place] {
                    if self.overrides(&one.name, &other.name) {
                        let [one, other] =
                            [other, one].map(|setting| setting.name.replace('-', "_"));
                        return TaskError::in_list(format!(
                            "`{one}` and `{other}` exclude each other"
                        ));
                    }
                }
            }
        }
        let text = error.to_string();
        let what = text.lines().next().unwrap_or_default().trim_start_matches("error: ");
        TaskError::in_list(what)
    }
}

/// Whether a flag changes the model rather than a view of it.
pub(crate) fn is_of_the_model(name: &str) -> bool {
    OF_THE_MODEL.contains(&name) || parameters().any(|parameter| parameter.name == name)
}

/// A JSON value as that of a setting.
fn setting_value(value: &Value) -> Result<SettingValue, String> {
    let text = |value: &Value| match value {
        Value::String(text) => Ok(text.clone()),
        Value::Number(number) => Ok(number.to_string()),
        _ => Err("expected a number, a string, or a list of them".to_owned()),
    };
    match value {
        Value::Bool(on) => Ok(SettingValue::Switch(*on)),
        Value::Array(values) => {
            values.iter().map(text).collect::<Result<_, _>>().map(SettingValue::Many)
        }
        one => text(one).map(SettingValue::One),
    }
}
