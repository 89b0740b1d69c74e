//! `KEY=VALUE:...` fields, from one string or from a table.

/// Keys and values; parsers take each field once.
#[derive(Clone, Debug, Default)]
pub struct Fields<'a> {
    /// Fields not yet taken, in order.
    left: Vec<(&'a str, &'a str)>,
}

/// An error in one field, or in their combination.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}{message}", key.as_deref().map_or_else(String::new, |key| format!("{key}: ")))]
pub struct FieldError {
    /// The field with the wrong value; `None` if several are at fault.
    pub key: Option<String>,
    /// A description of valid values.
    pub message: String,
}

impl FieldError {
    /// An error that concerns no single field.
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { key: None, message: message.into() }
    }
}

impl<'a> Fields<'a> {
    /// Parses fields from one string.
    ///
    /// # Errors
    /// A field without a value, or a duplicate field.
    pub fn parse(text: &'a str) -> Result<Self, FieldError> {
        let mut left: Vec<(&str, &str)> = Vec::new();
        for field in text.split(':') {
            let (key, value) = field
                .split_once('=')
                .ok_or_else(|| FieldError::new(format!("`{field}` has no value: use KEY=VALUE")))?;
            if left.iter().any(|(known, _)| *known == key) {
                return Err(FieldError::new(format!("`{key}` is given twice")));
            }
            left.push((key, value));
        }
        Ok(Self { left })
    }

    /// Removes a field, if present, and parses its value.
    pub(crate) fn take<T>(
        &mut self,
        key: &str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> Result<Option<T>, FieldError> {
        let Some(place) = self.left.iter().position(|(known, _)| *known == key) else {
            return Ok(None);
        };
        let (_, value) = self.left.remove(place);
        let at_key = |message| FieldError { key: Some(key.to_owned()), message };
        parse(value).map(Some).map_err(at_key)
    }

    /// The key of the first field that no parser took.
    pub(crate) fn unknown_key(&self) -> Option<&'a str> {
        self.left.first().map(|(key, _)| *key)
    }
}

impl<'a> FromIterator<(&'a str, &'a str)> for Fields<'a> {
    /// Fields from a table, whose keys are unique.
    fn from_iter<I: IntoIterator<Item = (&'a str, &'a str)>>(pairs: I) -> Self {
        Self { left: pairs.into_iter().collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::values::finite;

    #[test]
    fn a_field_is_taken_once() {
        let mut fields = Fields::parse("a=1:b=2").unwrap();
        assert_eq!(fields.take("b", finite), Ok(Some(2.0)));
        assert_eq!(fields.take("b", finite), Ok(None));
        assert_eq!(fields.unknown_key(), Some("a"));
    }

    #[test]
    fn errors_name_the_field() {
        let mut fields = Fields::parse("near=x").unwrap();
        let error = fields.take("near", finite).unwrap_err();
        assert_eq!(error.to_string(), "near: `x` is not a number");
        for text in ["", "a", "a=1:", "a=1:a=2"] {
            assert!(Fields::parse(text).is_err(), "{text}");
        }
    }
}
