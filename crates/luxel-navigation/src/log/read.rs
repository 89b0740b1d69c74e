//! Reads logs.

use super::{Change, Entry, LOG_VERSION, Log, NAME};
use crate::event::{Event, UnknownName};
use crate::settings::Number;
use crate::state::is_rigid;
use glam::{DMat4, DVec2, DVec3};
use luxel_scene::{Bounds, Lens, Size};
use std::str::{FromStr, SplitWhitespace};

/// An error in a log, with its line, counted from 1.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {kind}")]
pub struct LogError {
    /// The line.
    pub line: usize,
    /// The kind of error.
    pub kind: LogErrorKind,
}

/// A kind of error in a log.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LogErrorKind {
    /// The first line isn't `luxel-navigation 1`.
    #[error("a log begins with `{NAME} {LOG_VERSION}`")]
    NoLog,
    /// An unknown version.
    #[error("version `{0}` is not known: this program reads version {LOG_VERSION}")]
    Version(String),
    /// An unknown event.
    #[error("there is no event `{0}`")]
    UnknownEvent(String),
    /// An unknown name.
    #[error(transparent)]
    UnknownName(#[from] UnknownName),
    /// Words are missing.
    #[error("here ends the line, but {0} is missing")]
    Missing(&'static str),
    /// Superfluous words.
    #[error("`{0}` is too much")]
    TooMuch(String),
    /// Not a finite number.
    #[error("`{0}` is not a finite number")]
    NoNumber(String),
    /// A number out of range.
    #[error("{what} can't be {value}")]
    OutOfRange {
        /// The number.
        what: &'static str,
        /// The value as written.
        value: String,
    },
    /// A matrix with scale, shear or mirror.
    #[error("the matrix is not a rotation and translation, column by column")]
    NotRigid,
}

impl FromStr for Log {
    type Err = LogError;

    fn from_str(text: &str) -> Result<Self, LogError> {
        Self::with_lines(text).map(|(log, _)| log)
    }
}

impl Log {
    /// Reads a log, with the line of each entry, counted from 1.
    ///
    /// # Errors
    /// [`LogError`] for the first invalid line.
    pub fn with_lines(text: &str) -> Result<(Self, Vec<usize>), LogError> {
        let at = |line: usize| move |kind| LogError { line, kind };
        let mut lines = text.lines().enumerate().map(|(line, text)| (line + 1, words(text)));
        let mut lines = lines.by_ref().filter(|(_, words)| words.clone().next().is_some());
        let (line, mut first) = lines.next().ok_or(LogErrorKind::NoLog).map_err(at(1))?;
        version(&mut first).map_err(at(line))?;
        let mut log = Self::default();
        let mut numbers = Vec::new();
        for (line, words) in lines {
            log.entries.push(entry(words).map_err(at(line))?);
            numbers.push(line);
        }
        Ok((log, numbers))
    }
}

impl FromStr for Entry {
    type Err = LogErrorKind;

    fn from_str(line: &str) -> Result<Self, LogErrorKind> {
        entry(words(line))
    }
}

/// The words of a line up to a comment.
fn words(line: &str) -> SplitWhitespace<'_> {
    line.split('#').next().unwrap_or_default().split_whitespace()
}

fn version(words: &mut SplitWhitespace<'_>) -> Result<(), LogErrorKind> {
    if words.next() != Some(NAME) {
        return Err(LogErrorKind::NoLog);
    }
    let version = words.next().ok_or(LogErrorKind::NoLog)?;
    if version.parse() != Ok(LOG_VERSION) {
        return Err(LogErrorKind::Version(version.to_owned()));
    }
    end(words)
}

fn entry(mut words: SplitWhitespace<'_>) -> Result<Entry, LogErrorKind> {
    let mut first = word(&mut words, "an event")?;
    if first == "set" {
        let change = change(&mut words)?;
        end(&mut words)?;
        return Ok(Entry::Set(change));
    }
    let mut seconds = 0.0;
    if let Some(written) = first.strip_prefix('+') {
        seconds = finite(written)?;
        if seconds < 0.0 {
            return Err(out_of_range("time", written));
        }
        first = word(&mut words, "an event")?;
    }
    let event = event(first, &mut words)?;
    end(&mut words)?;
    // Negative zero would be written without a time.
    Ok(Entry::Event { seconds: seconds + 0.0, event })
}

fn change(words: &mut SplitWhitespace<'_>) -> Result<Change, LogErrorKind> {
    let name = word(words, "the setting's name")?;
    Ok(match name {
        "size" => {
            Change::Size(Size { width: side(words, "a width")?, height: side(words, "a height")? })
        }
        "lens" => Change::Lens(lens(words)?),
        "up" => {
            let up = vector(words, "an axis")?;
            if up == DVec3::ZERO {
                return Err(out_of_range("an axis", "0 0 0"));
            }
            Change::Up(up)
        }
        "bounds" => Change::Bounds(bounds(words)?),
        _ => {
            let number = Number::ALL.iter().find(|number| number.name() == name).copied();
            let number = number.ok_or_else(|| {
                let known = ["size", "lens", "up", "bounds"].into_iter();
                let known = known.chain(Number::ALL.iter().map(|number| number.name()));
                UnknownName { what: "setting", name: name.to_owned(), known: known.collect() }
            })?;
            let written = word(words, "a number")?;
            let value = finite(written)?;
            if !number.allows(value) {
                return Err(out_of_range(number.name(), written));
            }
            Change::Number(number, value)
        }
    })
}

fn lens(words: &mut SplitWhitespace<'_>) -> Result<Lens, LogErrorKind> {
    match word(words, "the lens's name")? {
        "perspective" => {
            let written = word(words, "an angle of view")?;
            let fov_y_radians = finite(written)?;
            if fov_y_radians > 0.0 && fov_y_radians < std::f64::consts::PI {
                Ok(Lens::Perspective { fov_y_radians })
            } else {
                Err(out_of_range("an angle of view in radians", written))
            }
        }
        "orthographic" => Ok(Lens::Orthographic { height: positive(words, "a height")? }),
        "intrinsics" => Ok(Lens::Intrinsics {
            fx: positive(words, "a focal length")?,
            fy: positive(words, "a focal length")?,
            cx: number(words, "the principal point")?,
            cy: number(words, "the principal point")?,
        }),
        name => Err(LogErrorKind::UnknownName(UnknownName {
            what: "lens",
            name: name.to_owned(),
            known: vec!["perspective", "orthographic", "intrinsics"],
        })),
    }
}

fn event(name: &str, words: &mut SplitWhitespace<'_>) -> Result<Event, LogErrorKind> {
    Ok(match name {
        "wait" => Event::Wait,
        "mode" => Event::Mode(word(words, "the mode's name")?.parse()?),
        "grab" => {
            let gesture = word(words, "turn, pan or zoom")?.parse()?;
            Event::Grab { gesture, at: place(words)?, point: point(words)? }
        }
        "drag" => Event::Drag { at: place(words)? },
        "release" => Event::Release,
        "wheel" => {
            let notches = number(words, "how many notches")?;
            Event::Wheel { notches, at: place(words)?, point: point(words)? }
        }
        "press" => Event::Press(word(words, "the command")?.parse()?),
        "lift" => Event::Lift(word(words, "the command")?.parse()?),
        "tap" => {
            let command = word(words, "the command")?.parse()?;
            let steps = words.next().map_or(Ok(1.0), finite)?;
            Event::Tap { command, steps }
        }
        "pivot" => Event::Pivot(vector(words, "a point")?),
        "view" => Event::View(word(words, "the view's name")?.parse()?),
        "fit" if words.clone().next().is_none() => Event::Fit(None),
        "fit" => Event::Fit(Some(bounds(words)?)),
        "level" => Event::Level,
        "go" => {
            let view_from_world = matrix(words)?;
            let pivot = vector(words, "the pivot")?;
            let written = word(words, "the scale")?;
            let scale = finite(written)?;
            if scale <= 0.0 {
                return Err(out_of_range("the scale", written));
            }
            Event::Go { view_from_world, pivot, scale }
        }
        "place" => Event::Place(matrix(words)?),
        _ => return Err(LogErrorKind::UnknownEvent(name.to_owned())),
    })
}

fn word<'a>(words: &mut SplitWhitespace<'a>, what: &'static str) -> Result<&'a str, LogErrorKind> {
    words.next().ok_or(LogErrorKind::Missing(what))
}

fn end(words: &mut SplitWhitespace<'_>) -> Result<(), LogErrorKind> {
    words.next().map_or(Ok(()), |word| Err(LogErrorKind::TooMuch(word.to_owned())))
}

fn finite(word: &str) -> Result<f64, LogErrorKind> {
    let number: Option<f64> = word.parse().ok();
    let finite = number.filter(|number| number.is_finite());
    finite.ok_or_else(|| LogErrorKind::NoNumber(word.to_owned()))
}

fn number(words: &mut SplitWhitespace<'_>, what: &'static str) -> Result<f64, LogErrorKind> {
    finite(word(words, what)?)
}

fn positive(words: &mut SplitWhitespace<'_>, what: &'static str) -> Result<f64, LogErrorKind> {
    let written = word(words, what)?;
    let value = finite(written)?;
    if value > 0.0 { Ok(value) } else { Err(out_of_range(what, written)) }
}

fn side(words: &mut SplitWhitespace<'_>, what: &'static str) -> Result<u32, LogErrorKind> {
    let written = word(words, what)?;
    written.parse().ok().filter(|&side| side > 0).ok_or_else(|| out_of_range(what, written))
}

fn place(words: &mut SplitWhitespace<'_>) -> Result<DVec2, LogErrorKind> {
    Ok(DVec2::new(number(words, "a place's x")?, number(words, "a place's y")?))
}

/// An optional `on X Y Z`.
fn point(words: &mut SplitWhitespace<'_>) -> Result<Option<DVec3>, LogErrorKind> {
    match words.next() {
        None => Ok(None),
        Some("on") => vector(words, "the point").map(Some),
        Some(other) => Err(LogErrorKind::TooMuch(other.to_owned())),
    }
}

fn vector(words: &mut SplitWhitespace<'_>, what: &'static str) -> Result<DVec3, LogErrorKind> {
    Ok(DVec3::new(number(words, what)?, number(words, what)?, number(words, what)?))
}

fn bounds(words: &mut SplitWhitespace<'_>) -> Result<Bounds, LogErrorKind> {
    let min = vector(words, "a corner of the box")?;
    let max = vector(words, "a corner of the box")?;
    if min.cmple(max).all() {
        Ok(Bounds { min, max })
    } else {
        Err(out_of_range("a box", "upside down"))
    }
}

fn matrix(words: &mut SplitWhitespace<'_>) -> Result<DMat4, LogErrorKind> {
    let mut columns = [0.0; 16];
    for value in &mut columns {
        *value = number(words, "one of the matrix's 16 numbers")?;
    }
    let matrix = DMat4::from_cols_array(&columns);
    if is_rigid(&matrix) { Ok(matrix) } else { Err(LogErrorKind::NotRigid) }
}

fn out_of_range(what: &'static str, value: &str) -> LogErrorKind {
    LogErrorKind::OutOfRange { what, value: value.to_owned() }
}
