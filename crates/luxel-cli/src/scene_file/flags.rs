//! The flags of `luxel render` that are settings of `[render]`.

use clap::{Arg, Command};
use luxel::formats::values::nearest;
use luxel::lighting::parameters;
use std::borrow::Cow;

/// The result of looking up a key of `[render]`.
pub(crate) enum Lookup<'a> {
    /// It is this flag.
    Flag(&'a Arg),
    /// Not a setting: the reason, and the replacement.
    Refused(String),
}

/// Flags with another place in a scene file, besides those of reflection parameters.
pub(crate) const ELSEWHERE: [(&str, &str); 10] = [
    ("light", "[[lights]]"),
    ("fog", "[fog]"),
    ("ambient", "`ambient` at the top level"),
    ("environment", "`environment` at the top level"),
    ("environment-rotation", "`environment_rotation` at the top level"),
    ("background", "`background` at the top level"),
    ("up", "`up` at the top level"),
    ("color", "`color` in [material]"),
    ("emission", "`emission` in [material]"),
    ("reflection", "`reflection` in [material]"),
];

/// Flags of output and execution, which don't describe the scene.
pub(crate) const ON_THE_LINE: [&str; 13] = [
    "output",
    "output-format",
    "format",
    "json",
    "path",
    "fps",
    "threads",
    "simd",
    "max-memory",
    "quiet",
    "verbose",
    "help",
    "version",
];

/// The other place of a flag in a scene file.
fn elsewhere(name: &str) -> Option<Cow<'static, str>> {
    let listed = ELSEWHERE.iter().find(|(flag, _)| *flag == name);
    listed.map(|(_, place)| Cow::Borrowed(*place)).or_else(|| {
        let is_parameter = parameters().any(|parameter| parameter.name == name);
        is_parameter.then(|| Cow::Owned(format!("`{name}` in [material]")))
    })
}

/// Looks up a key of `[render]`.
pub(crate) fn look_up<'a>(name: &str, render: &'a Command) -> Lookup<'a> {
    if let Some(place) = elsewhere(name) {
        return Lookup::Refused(format!("`{name}` is not a setting: write {place}"));
    }
    if ON_THE_LINE.contains(&name) {
        let why = "a scene file has no settings of output and execution";
        return Lookup::Refused(format!("`{name}` is for the command line: {why}"));
    }
    if let Some(arg) = keys(render).find(|arg| arg.get_long() == Some(name)) {
        return Lookup::Flag(arg);
    }
    let known: Vec<&str> = keys(render).filter_map(Arg::get_long).collect();
    Lookup::Refused(match nearest(name, known.iter().copied()) {
        Some(meant) => format!("`{name}` is unknown here: did you mean `{meant}`?"),
        None => format!("`{name}` is unknown here: use {}", known.join(", ")),
    })
}

/// The flags that are settings of `[render]`, in the order of the options.
pub(crate) fn keys(render: &Command) -> impl Iterator<Item = &Arg> {
    let is_key = |name: &str| !ON_THE_LINE.contains(&name) && elsewhere(name).is_none();
    render.get_arguments().filter(move |arg| arg.get_long().is_some_and(is_key))
}
