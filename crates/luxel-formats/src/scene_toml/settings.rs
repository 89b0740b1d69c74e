//! `[render]`: what the flags of the command line would say, for whoever has these flags.

use super::document::{Document, as_text};
use super::keys::RENDER;
use crate::memory::Memory;
use crate::{Error, ErrorKind, Limits, Place};
use std::borrow::Cow;
use toml::de::DeValue;

/// A flag that a scene file gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The flag's name, without dashes.
    pub name: String,
    /// Where it is written.
    pub place: Place,
    /// What it says.
    pub value: SettingValue,
    /// Where that is written.
    pub value_place: Place,
}

/// What a scene file says about a flag.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SettingValue {
    /// The flag is given, or not.
    Switch(bool),
    /// One value, as it would be written after the flag.
    One(String),
    /// Several: numbers with commas between them, or values of a flag that may be repeated.
    Many(Vec<String>),
}

/// The settings of a scene file, in order: what its `[render]` says. What their names and values
/// mean is for the command line to know.
///
/// # Errors
/// [`Error`] with its line and column, if this is no scene file or `[render]` no table of values.
pub fn scene_settings(bytes: &[u8], limits: &Limits) -> Result<Vec<Setting>, Error> {
    let document = Document::parse(bytes, &Memory::new(limits))?;
    let setting = |entry: super::document::Entry<'_>| {
        let value = match entry.value {
            DeValue::Boolean(on) => Ok(SettingValue::Switch(*on)),
            DeValue::Array(items) => {
                let item = |item: &serde_spanned::Spanned<DeValue<'_>>| {
                    as_text(item.get_ref()).map(Cow::into_owned)
                };
                items.iter().map(item).collect::<Result<_, _>>().map(SettingValue::Many)
            }
            one => as_text(one).map(|text| SettingValue::One(text.into_owned())),
        };
        let name = entry.name.to_owned();
        let value = value.map_err(|message| {
            let message = format!("{name}: {message}");
            Error::at(entry.value_place.clone(), ErrorKind::Malformed(message))
        })?;
        Ok(Setting { name, place: entry.place, value, value_place: entry.value_place })
    };
    document.entries(RENDER)?.into_iter().map(setting).collect()
}
