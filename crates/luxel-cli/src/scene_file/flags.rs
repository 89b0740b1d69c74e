//! Which flags of `luxel render` may stand in `[render]`.

use clap::{Arg, Command};
use luxel::formats::values::nearest;
use luxel::lighting::parameters;
use std::borrow::Cow;

/// The result of looking up a key of `[render]`.
pub(crate) enum Lookup<'a> {
    /// It is this flag.
    Flag(&'a Arg),
    /// It may not stand there: why, and what to write instead.
    Refused(String),
}

/// Flags that stand elsewhere in a scene file, and where; so do those of parameters of reflection.
pub(crate) const ELSEWHERE: [(&str, &str); 9] = [
    ("light", "[[lights]]"),
    ("fog", "[fog]"),
    ("ambient", "`ambient` above all tables"),
    ("environment", "`environment` above all tables"),
    ("background", "`background` above all tables"),
    ("up", "`up` above all tables"),
    ("color", "`color` in [material]"),
    ("emission", "`emission` in [material]"),
    ("reflection", "`reflection` in [material]"),
];

/// Flags for the destination of results and for the execution; a file describes what to draw.
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

/// Where else in a scene file a flag stands.
fn elsewhere(name: &str) -> Option<Cow<'static, str>> {
    let listed = ELSEWHERE.iter().find(|(flag, _)| *flag == name);
    listed.map(|(_, place)| Cow::Borrowed(*place)).or_else(|| {
        let is_parameter = parameters().any(|parameter| parameter.name == name);
        is_parameter.then(|| Cow::Owned(format!("`{name}` in [material]")))
    })
}

/// Looks a key of `[render]` up.
pub(crate) fn look_up<'a>(name: &str, render: &'a Command) -> Lookup<'a> {
    if let Some(place) = elsewhere(name) {
        return Lookup::Refused(format!("`{name}` is no setting: write {place}"));
    }
    if ON_THE_LINE.contains(&name) {
        let why = "a file says what to draw, not where it goes and how it is done";
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

/// The flags that may stand in `[render]`, in the order of the table of options.
pub(crate) fn keys(render: &Command) -> impl Iterator<Item = &Arg> {
    let is_key = |name: &str| !ON_THE_LINE.contains(&name) && elsewhere(name).is_none();
    render.get_arguments().filter(move |arg| arg.get_long().is_some_and(is_key))
}
