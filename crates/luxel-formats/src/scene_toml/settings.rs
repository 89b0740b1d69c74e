//! `[render]`: settings of the rendering program.

use super::document::{Document, as_text};
use super::keys::RENDER;
use crate::memory::Memory;
use crate::{Error, ErrorKind, Limits, Place};
use std::borrow::Cow;
use toml::de::DeValue;

/// A setting of a scene file.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// Its name.
    pub name: String,
    /// The place of the key.
    pub place: Place,
    /// Its value.
    pub value: SettingValue,
    /// The place of the value.
    pub value_place: Place,
}

/// The value of a setting.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SettingValue {
    /// On or off.
    Switch(bool),
    /// One value, as text.
    One(String),
    /// Several: the numbers of a vector, or the values of a repeatable setting.
    Many(Vec<String>),
}

/// The settings in `[render]` of a scene file, in order. Names and values are not checked: that is
/// up to the program.
///
/// # Errors [`Error`] with its line and column, if this is not a scene file or `[render]` is not a
/// table of values.
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
