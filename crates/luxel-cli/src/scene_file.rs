//! Merges the `[render]` settings of a scene file into the command line.
//!
//! The keys of `[render]` are the flags of `luxel render`, and the flags' parsers read their
//! values: the settings are inserted into the command line, so that commands don't distinguish the
//! two. Flags on the command line override settings, and drop settings that they conflict with.

pub(crate) mod flags;
pub(crate) mod schema;

use crate::failure::Failure;
use crate::model;
use clap::error::{ContextKind, ContextValue, ErrorKind as UsageKind};
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command};
use flags::{Lookup, look_up};
use luxel::formats::{
    Error, ErrorKind, Format, Limits, Place, Setting, SettingValue, scene_settings,
};
use std::error::Error as _;
use std::ffi::{OsStr, OsString};
use std::path::Path;

/// The reason why no command runs.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// Clap's message: help, version, or an error in the command line.
    Line(Box<clap::Error>),
    /// The scene file is invalid.
    File(Failure),
}

impl From<clap::Error> for Refusal {
    fn from(error: clap::Error) -> Self {
        Self::Line(Box::new(error))
    }
}

/// The command and its flags, with the settings of the scene file, if the model is one: `model`, or that
/// of the line.
pub(crate) fn matches(
    of: fn() -> Command,
    line: &[OsString],
    model: Option<&OsStr>,
) -> Result<ArgMatches, Refusal> {
    let mut program = of();
    // Building adds the global flags to the commands.
    program.build();
    let matches = program.try_get_matches_from_mut(line)?;
    let settings = match matches.subcommand() {
        Some((name, given)) => {
            let model = model.or_else(|| model_of(name, given));
            model.map_or(Ok(Vec::new()), |name| settings(name, given)).map_err(Refusal::File)?
        }
        None => Vec::new(),
    };
    if settings.is_empty() {
        return Ok(matches);
    }
    let Some((name, given)) = matches.subcommand() else {
        return Ok(matches);
    };
    let file = model.or_else(|| model_of(name, given)).unwrap_or_default();
    let in_file = |error: Error| Refusal::File(error.in_file(file).into());
    let render = program.find_subcommand("render").unwrap_or(&program);
    check(&settings, render).map_err(in_file)?;
    let command = program.find_subcommand(name).unwrap_or(&program);
    let flags = settings.iter().flat_map(|setting| flags_for(setting, command, given));
    // Flags before the command take no values.
    let is_command = |word: &OsString| word == name;
    let after = line.iter().position(is_command).map_or(line.len(), |place| place + 1);
    let (before, behind) = line.split_at(after);
    let longer: Vec<OsString> =
        before.iter().cloned().chain(flags).chain(behind.iter().cloned()).collect();
    Ok(of().try_get_matches_from(longer)?)
}

/// The model whose settings count: the first one; none if `render` has several, as each has its own.
fn model_of<'m>(command: &str, given: &'m ArgMatches) -> Option<&'m OsStr> {
    let has_more = || given.try_get_many::<OsString>("more").is_ok_and(|more| more.is_some());
    let model = given.try_get_one::<OsString>("model").ok().flatten()?;
    (command != "render" || !has_more()).then_some(model.as_os_str())
}

/// The settings of the model, if it is a scene file. An unreadable file fails later, when it is
/// opened.
fn settings(name: &OsStr, given: &ArgMatches) -> Result<Vec<Setting>, Failure> {
    let format = given.try_get_one::<Format>("format").ok().flatten().copied();
    let max_memory = given.try_get_one::<u64>("max_memory").ok().flatten().copied();
    settings_of(name, format, max_memory)
}

/// The settings of a model of this name and format, if it is a scene file.
pub(crate) fn settings_of(
    name: &OsStr,
    format: Option<Format>,
    max_memory: Option<u64>,
) -> Result<Vec<Setting>, Failure> {
    let by_name =
        || Path::new(name).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    let is_scene_file = format.map_or_else(by_name, |format| format == Format::Toml);
    let is_any = format.is_none() && name == "-";
    if !is_scene_file && !is_any {
        return Ok(Vec::new());
    }
    let limits = max_memory
        .map_or_else(Limits::default, |max_memory| Limits { max_memory, ..Limits::default() });
    let Ok(bytes) = model::bytes_of(name, &limits) else { return Ok(Vec::new()) };
    if is_any && Format::of_bytes(&bytes) != Some(Format::Toml) {
        return Ok(Vec::new());
    }
    scene_settings(&bytes, &limits).map_err(|error| {
        let error = if name == "-" { error } else { error.in_file(name) };
        error.into()
    })
}

/// Checks the settings, each by itself and all together, against `luxel render` whatever the
/// command, so that a file is valid or invalid for all commands.
pub(crate) fn check(settings: &[Setting], render: &Command) -> Result<(), Error> {
    let mut all: Vec<OsString> = Vec::new();
    for setting in settings {
        let wrong = |place: &Place, message: String| {
            Error::at(place.clone(), ErrorKind::Malformed(message))
        };
        let arg = match look_up(&setting.name, render) {
            Lookup::Flag(arg) => arg,
            Lookup::Refused(message) => return Err(wrong(&setting.place, message)),
        };
        let at_value =
            |message: String| wrong(&setting.value_place, format!("{}: {message}", setting.name));
        let words = words(setting, arg).map_err(at_value)?;
        if let Err(error) = try_render(render, &words)
            && let Some(message) = value_error(&error)
        {
            return Err(at_value(message));
        }
        all.extend(words);
    }
    match try_render(render, &all) {
        Err(error) if error.kind() == UsageKind::ArgumentConflict => {
            let named = |kind| match error.get(kind) {
                Some(ContextValue::String(flag)) => named(settings, flag),
                Some(ContextValue::Strings(flags)) => {
                    flags.iter().find_map(|flag| named(settings, flag))
                }
                _ => None,
            };
            let pair = [named(ContextKind::InvalidArg), named(ContextKind::PriorArg)];
            let [Some(one), Some(other)] = pair else { return Ok(()) };
            let message = format!("`{}` and `{}` exclude each other", one.name, other.name);
            Err(Error::at(one.place.clone(), ErrorKind::Malformed(message)))
        }
        _ => Ok(()),
    }
}

/// The setting behind a flag in clap's notation, `--fov <DEG>`.
fn named<'s>(settings: &'s [Setting], flag: &str) -> Option<&'s Setting> {
    let name = flag.split([' ', '=']).next()?.trim_start_matches('-');
    settings.iter().find(|setting| setting.name == name)
}

/// Parses these flags as `luxel render` would.
fn try_render(render: &Command, words: &[OsString]) -> Result<(), clap::Error> {
    let line = ["render", "--output=x.png"].map(OsString::from).into_iter();
    let line = line.chain(words.iter().cloned());
    render.clone().no_binary_name(false).try_get_matches_from(line).map(|_| ())
}

/// The parser's message about a value; `None` if the error is another one.
pub(crate) fn value_error(error: &clap::Error) -> Option<String> {
    match error.kind() {
        UsageKind::ValueValidation => error.source().map(ToString::to_string),
        UsageKind::InvalidValue => {
            let Some(ContextValue::Strings(choices)) = error.get(ContextKind::ValidValue) else {
                return Some("not allowed here".to_owned());
            };
            Some(format!("use {}", choices.join(", ")))
        }
        UsageKind::UnknownArgument | UsageKind::TooManyValues | UsageKind::WrongNumberOfValues => {
            Some("not allowed here".to_owned())
        }
        _ => None,
    }
}

/// A setting as command line arguments.
pub(crate) fn words(setting: &Setting, arg: &Arg) -> Result<Vec<OsString>, String> {
    let name = &setting.name;
    let given = |value: &String| OsString::from(format!("--{name}={value}"));
    match (arg.get_action(), &setting.value) {
        (ArgAction::SetTrue, SettingValue::Switch(true)) => Ok(vec![format!("--{name}").into()]),
        (ArgAction::SetTrue, SettingValue::Switch(false)) => Ok(Vec::new()),
        (ArgAction::SetTrue, _) => Err("use true or false".to_owned()),
        (_, SettingValue::Switch(on)) if takes_no_value(arg) => {
            Ok(on.then(|| format!("--{name}").into()).into_iter().collect())
        }
        (_, SettingValue::Switch(_)) => {
            Err("expected a number or a string, found a boolean".to_owned())
        }
        (_, SettingValue::One(value)) => Ok(vec![given(value)]),
        (ArgAction::Append, SettingValue::Many(values)) => Ok(values.iter().map(given).collect()),
        (_, SettingValue::Many(values)) => Ok(vec![given(&values.join(","))]),
    }
}

/// Whether a flag may stand without a value.
fn takes_no_value(arg: &Arg) -> bool {
    arg.get_num_args().is_some_and(|count| count.min_values() == 0)
}

/// The arguments that a setting adds: none if the command line has the flag or a conflicting one,
/// or if the command has no such flag.
pub(crate) fn flags_for(setting: &Setting, command: &Command, given: &ArgMatches) -> Vec<OsString> {
    let on_line = |arg: &Arg| {
        let id = arg.get_id().as_str();
        given.try_contains_id(id).is_ok_and(|known| known)
            && given.value_source(id) == Some(ValueSource::CommandLine)
    };
    let has_name = |arg: &&Arg| arg.get_long() == Some(setting.name.as_str());
    let Some(arg) = command.get_arguments().find(has_name) else { return Vec::new() };
    let excludes = |one: &Arg, other: &Arg| {
        command.get_arg_conflicts_with(one).iter().any(|arg| arg.get_id() == other.get_id())
    };
    let is_overruled = command.get_arguments().filter(|other| on_line(other)).any(|other| {
        other.get_id() == arg.get_id() || excludes(arg, other) || excludes(other, arg)
    });
    if is_overruled { Vec::new() } else { words(setting, arg).unwrap_or_default() }
}
