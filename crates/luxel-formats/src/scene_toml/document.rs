//! Parses the text into tables, checks their keys, and records the place of every value.

use super::keys::{FORMAT, Key, RENDER, ROOT, Section, sections};
use crate::memory::Memory;
use crate::values::nearest;
use crate::{Error, ErrorKind, Format, Hint, Place};
use serde_spanned::Spanned;
use std::borrow::Cow;
use toml::de::{DeTable, DeValue};

/// Upper bound of memory per byte of text: the smallest value with its place,
/// divided by the shortest text of one.
const BYTES_PER_BYTE: u64 = 96;

/// A scene file with a valid header.
pub(super) struct Document<'a> {
    text: &'a str,
    root: Spanned<DeTable<'a>>,
}

/// A table of the file, with the section that lists its keys.
#[derive(Clone, Copy)]
pub(super) struct Table<'a> {
    text: &'a str,
    section: &'static Section,
    entries: &'a DeTable<'a>,
    start: usize,
}

fn malformed(text: &str, byte: usize, message: impl Into<String>) -> Error {
    Error::at(Place::in_text(text, byte), ErrorKind::Malformed(message.into()))
}

/// `` `coulor` is unknown: did you mean `color`? ``
fn unknown(name: &str, known: &[&'static str]) -> String {
    let rest = match nearest(name, known.iter().copied()) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None => format!("use {}", known.join(", ")),
    };
    format!("`{name}` is unknown here: {rest}")
}

impl<'a> Document<'a> {
    /// Parses the text and checks format and version.
    pub(super) fn parse(bytes: &'a [u8], memory: &Memory<'_>) -> Result<Self, Error> {
        Format::Toml.check_not_utf16(bytes)?;
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        memory.take("the scene file", bytes.len() as u64, BYTES_PER_BYTE, Place::File)?;
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let place = Place::Byte(error.valid_up_to() as u64);
            Error::at(place, ErrorKind::Malformed("a scene file must be UTF-8 text".to_owned()))
        })?;
        let root = DeTable::parse(text).map_err(|error| {
            let message = error.message().lines().next().unwrap_or_default();
            malformed(text, error.span().map_or(0, |span| span.start), message)
        })?;
        let document = Self { text, root };
        document.check_header()?;
        Ok(document)
    }

    fn check_header(&self) -> Result<(), Error> {
        let header = |name: &str| self.root.get_ref().get(name);
        let wrong = |message: String| Error::at(Place::File, ErrorKind::Unsupported(message));
        let form = format!("a scene file begins with format =  \"{FORMAT}\" and version = 1");
        match header("format") {
            Some(format) if format.get_ref().as_str() == Some(FORMAT) => {}
            Some(format) => return Err(malformed(self.text, format.span().start, form)),
            None => return Err(wrong(format!("this is not a scene file: {form}"))),
        }
        let Some(version) = header("version") else {
            return Err(wrong(format!("the version is missing: {form}")));
        };
        let number = version.get_ref().as_integer().map(ToString::to_string);
        match number.as_deref() {
            Some("1") => Ok(()),
            Some(other) => Err(malformed(
                self.text,
                version.span().start,
                format!("version {other} is not supported: use version 1, or a newer luxel"),
            )),
            None => Err(malformed(self.text, version.span().start, form)),
        }
    }

    /// The top-level keys; checks the names of tables.
    pub(super) fn root(&'a self) -> Result<Table<'a>, Error> {
        let sections = sections();
        let tables = sections.iter().map(|section| section.name).filter(|name| !name.is_empty());
        let mut known: Vec<&'static str> = tables.collect();
        known.push(RENDER);
        let root =
            Table { text: self.text, section: &ROOT, entries: self.root.get_ref(), start: 0 };
        root.check_keys(&known)?;
        Ok(root)
    }

    /// All tables of a section, in order.
    pub(super) fn tables(&'a self, section: &'static Section) -> Result<Vec<Table<'a>>, Error> {
        let Some(value) = self.root.get_ref().get(section.name) else { return Ok(Vec::new()) };
        let wrong = || {
            let Section { name, repeated, .. } = section;
            let form = if *repeated { format!("[[{name}]]") } else { format!("[{name}]") };
            malformed(self.text, value.span().start, format!("`{name}` is a table: write {form}"))
        };
        let table = |value: &'a Spanned<DeValue<'a>>| {
            let entries = value.get_ref().as_table().ok_or_else(wrong)?;
            Table::new(self.text, section, entries, value.span().start)
        };
        if !section.repeated {
            return Ok(vec![table(value)?]);
        }
        value.get_ref().as_array().ok_or_else(wrong)?.iter().map(table).collect()
    }

    /// A table whose keys the caller checks: each with its value, and the place of both.
    pub(super) fn entries(&'a self, name: &str) -> Result<Vec<Entry<'a>>, Error> {
        let Some(value) = self.root.get_ref().get(name) else { return Ok(Vec::new()) };
        let table = value.get_ref().as_table().ok_or_else(|| {
            malformed(self.text, value.span().start, format!("`{name}` is a table: write [{name}]"))
        })?;
        let entry = |(key, value): (&'a Spanned<Cow<'a, str>>, &'a Spanned<DeValue<'a>>)| Entry {
            name: key.get_ref(),
            place: Place::in_text(self.text, key.span().start),
            value: value.get_ref(),
            value_place: Place::in_text(self.text, value.span().start),
        };
        Ok(in_file_order(table).into_iter().map(entry).collect())
    }
}

/// A key with its value.
pub(super) struct Entry<'a> {
    pub(super) name: &'a str,
    pub(super) place: Place,
    pub(super) value: &'a DeValue<'a>,
    pub(super) value_place: Place,
}

impl<'a> Table<'a> {
    fn new(
        text: &'a str,
        section: &'static Section,
        entries: &'a DeTable<'a>,
        start: usize,
    ) -> Result<Self, Error> {
        let table = Self { text, section, entries, start };
        table.check_keys(&[])?;
        Ok(table)
    }

    /// Checks that every key is in the section or in `more`, and that no required key is missing.
    fn check_keys(&self, more: &[&'static str]) -> Result<(), Error> {
        let own = self.section.keys.iter().map(|key| key.name);
        let known: Vec<&'static str> = own.chain(more.iter().copied()).collect();
        let unknown_keys =
            self.entries.keys().filter(|key| !known.contains(&key.get_ref().as_ref()));
        if let Some(key) = unknown_keys.min_by_key(|key| key.span().start) {
            let message = unknown(key.get_ref(), &known);
            return Err(malformed(self.text, key.span().start, message));
        }
        let missing = |key: &&Key| key.required && self.get(key.name).is_none();
        match self.section.keys.iter().find(missing) {
            Some(key) => {
                let Key { name, example, .. } = key;
                Err(self
                    .error(format!("`{name}` is missing: write, for example, {name} = {example}")))
            }
            None => Ok(()),
        }
    }

    fn get(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        debug_assert!(
            self.section.keys.iter().any(|known| known.name == key),
            "`{key}` is not in the table of keys"
        );
        self.entries.get(key)
    }

    /// Whether the table has the key.
    pub(super) fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// An error of the table as a whole.
    pub(super) fn error(&self, message: impl Into<String>) -> Error {
        malformed(self.text, self.start, message)
    }

    /// An error of a value.
    pub(super) fn error_at(&self, key: &str, message: impl Into<String>) -> Error {
        let start = self.get(key).map_or(self.start, |value| value.span().start);
        malformed(self.text, start, message)
    }

    /// An error of a value that names an unknown thing, with a suggestion or a hint.
    pub(super) fn unknown_name<'n>(
        &self,
        key: &str,
        what: &str,
        name: &str,
        known: impl IntoIterator<Item = &'n str>,
    ) -> Error {
        let message = format!("there is no {what} `{name}`");
        match nearest(name, known) {
            Some(meant) => self.error_at(key, format!("{message}: did you mean `{meant}`?")),
            None => self.error_at(key, message).with_hint(Some(Hint::ListNames)),
        }
    }

    /// The place of a value.
    pub(super) fn place_of(&self, key: &str) -> Place {
        Place::in_text(self.text, self.get(key).map_or(self.start, |value| value.span().start))
    }

    /// A value, parsed from its text form.
    pub(super) fn value<T>(
        &self,
        key: &str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> Result<Option<T>, Error> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let parsed = as_text(value.get_ref()).and_then(|text| parse(&text));
        parsed.map(Some).map_err(|message| self.error_at(key, format!("{key}: {message}")))
    }

    /// A string.
    pub(super) fn text(&self, key: &str) -> Result<Option<&'a str>, Error> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let text = value.get_ref().as_str();
        text.map(Some).ok_or_else(|| self.error_at(key, format!("{key}: use a quoted string")))
    }

    /// `true` or `false`.
    pub(super) fn switch(&self, key: &str) -> Result<Option<bool>, Error> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let switch = value.get_ref().as_bool();
        switch.map(Some).ok_or_else(|| self.error_at(key, format!("{key}: use true or false")))
    }

    /// A name or a path: a string with `/` between names, or a list of names.
    pub(super) fn path(&self, key: &str) -> Result<Option<Vec<String>>, Error> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let names = match value.get_ref() {
            DeValue::String(text) => Some(vec![text.clone().into_owned()]),
            DeValue::Array(names) => {
                names.iter().map(|name| name.get_ref().as_str().map(str::to_owned)).collect()
            }
            _ => None,
        };
        match names {
            Some(names) if !names.is_empty() => Ok(Some(names)),
            _ => Err(self.error_at(key, format!("{key}: use a name, a path or a list of names"))),
        }
    }

    /// A table within this one.
    pub(super) fn table(
        &self,
        key: &str,
        section: &'static Section,
    ) -> Result<Option<Self>, Error> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let entries = value.get_ref().as_table().ok_or_else(|| {
            let keys: Vec<_> =
                section.keys.iter().map(|key| format!("{} = {}", key.name, key.example)).collect();
            self.error_at(key, format!("{key}: use {{ {} }}", keys.join(", ")))
        })?;
        Self::new(self.text, section, entries, value.span().start).map(Some)
    }

    /// All keys with their values, in order.
    pub(super) fn values(&self) -> Vec<(&'a str, &'a DeValue<'a>)> {
        let entries = in_file_order(self.entries).into_iter();
        entries.map(|(key, value)| (&**key.get_ref(), value.get_ref())).collect()
    }

    /// All keys but some, each with the text form of its value.
    pub(super) fn fields(&self, but: &[&str]) -> Result<Vec<(&'a str, String)>, Error> {
        let field = |(key, value): (&'a Spanned<Cow<'a, str>>, &'a Spanned<DeValue<'a>>)| {
            let name: &str = key.get_ref();
            let text = as_text(value.get_ref());
            let text = text.map_err(|message| self.error_at(name, format!("{name}: {message}")))?;
            Ok((name, text.into_owned()))
        };
        let entries = in_file_order(self.entries).into_iter();
        entries.filter(|(key, _)| !but.contains(&key.get_ref().as_ref())).map(field).collect()
    }
}

/// A key and its value.
type KeyAndValue<'t, 'a> = (&'t Spanned<Cow<'a, str>>, &'t Spanned<DeValue<'a>>);

/// The entries of a table in the order of the file.
pub(super) fn in_file_order<'t, 'a>(table: &'t DeTable<'a>) -> Vec<KeyAndValue<'t, 'a>> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}

/// The text form of a value: numbers as they are, lists with commas.
pub(super) fn as_text<'v>(value: &'v DeValue<'_>) -> Result<Cow<'v, str>, String> {
    match value {
        DeValue::String(text) => Ok(Cow::Borrowed(text)),
        DeValue::Integer(number) if number.radix() == 10 => Ok(Cow::Borrowed(number.as_str())),
        DeValue::Integer(number) => i128::from_str_radix(number.as_str(), number.radix())
            .map(|number| Cow::Owned(number.to_string()))
            .map_err(|_| "the number is too large".to_owned()),
        DeValue::Float(number) => Ok(Cow::Borrowed(number.as_str())),
        DeValue::Array(items) => {
            let flat = |item: &'v Spanned<DeValue<'_>>| match item.get_ref() {
                DeValue::Array(_) => Err("expected a number or a string, found a list".to_owned()),
                item => as_text(item),
            };
            let items: Vec<_> = items.iter().map(flat).collect::<Result<_, _>>()?;
            Ok(Cow::Owned(items.join(",")))
        }
        DeValue::Boolean(_) => Err("expected a number or a string, found a boolean".to_owned()),
        DeValue::Datetime(_) => Err("expected a number or a string, found a date".to_owned()),
        DeValue::Table(_) => Err("expected a number or a string, found a table".to_owned()),
    }
}
