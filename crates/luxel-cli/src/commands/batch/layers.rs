//! The layers of a task: which files each view has.

use crate::drawing::{Content, Format};
use luxel::render::{Layer, PictureFormat};
use luxel_batch::TaskError;
use serde_json::Value;

/// The picture among layers.
const PICTURE: &str = "rgba";

/// The longest name of a layer in a file's name, in bytes: file systems take 255 for all of it.
const LONGEST: usize = 120;

/// A layer of a task.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TaskLayer {
    /// Its name.
    pub(crate) name: String,
    /// Layer and extension, as in the names of files.
    pub(crate) ending: String,
    /// The content of its files, but for the bits of a picture.
    pub(crate) content: Content,
}

impl TaskLayer {
    /// `rgba`, `z`, `object.png`: the name of a layer, and the extension if it isn't the usual one.
    fn parse(text: &str) -> Result<Self, String> {
        let (name, extension) = match text.rsplit_once('.') {
            Some((name, "svg")) if name.parse::<Layer>().is_ok() || name == PICTURE => {
                return Err(format!("`{text}`: layers are pixels: use png, exr, ppm or npy"));
            }
            // Names of lights may contain full stops.
            Some((name, extension)) => match extension.parse() {
                Ok(format) => (name, Some(format)),
                Err(_) => (text, None),
            },
            None => (text, None),
        };
        let (layers, usual) = if name == PICTURE {
            (Vec::new(), PictureFormat::Png)
        } else {
            let layer = name.parse::<Layer>();
            let layer = layer.map_err(|error| format!("`{text}`: {error}, or rgba"))?;
            (vec![layer], PictureFormat::Npy)
        };
        let format = extension.unwrap_or(usual);
        let ending = format!("{}.{}", file_name(name), format.extension());
        if ending.len() > LONGEST {
            return Err(format!("`{text}`: a name of so many bytes doesn't fit a file's name"));
        }
        let content = Content { layers, bits: 8, format: Format::Pixels(format) };
        Ok(Self { name: name.to_owned(), ending, content })
    }
}

/// A layer's name as part of a file's name: other bytes than of letters, digits, `_` and `-` become `%` and two
/// hexadecimal digits.
fn file_name(name: &str) -> String {
    let mut text = String::new();
    for byte in name.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'_' | b'-' => text.push(char::from(byte)),
            other => text.push_str(&format!("%{other:02X}")),
        }
    }
    text
}

/// The layers of a task's `layers`, by default the picture alone.
///
/// # Errors
/// [`TaskError`] that names the layer.
pub(crate) fn layers(value: Option<&Value>) -> Result<Vec<TaskLayer>, TaskError> {
    let usage = || TaskError::in_list("`layers`: use a list of names: [\"rgba\", \"z\"]");
    let names = match value {
        None | Some(Value::Null) => return parse(&[PICTURE]),
        Some(Value::Array(names)) if !names.is_empty() => names,
        Some(_) => return Err(usage()),
    };
    let names: Option<Vec<&str>> = names.iter().map(Value::as_str).collect();
    parse(&names.ok_or_else(usage)?)
}

fn parse(names: &[&str]) -> Result<Vec<TaskLayer>, TaskError> {
    let mut layers: Vec<TaskLayer> = Vec::new();
    for name in names {
        let layer = TaskLayer::parse(name)
            .map_err(|message| TaskError::in_list(format!("`layers`: {message}")))?;
        if layers.iter().any(|other| other.ending == layer.ending) {
            let message = format!("`layers`: `{name}` is there twice");
            return Err(TaskError::in_list(message));
        }
        layers.push(layer);
    }
    Ok(layers)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn endings(names: &[&str]) -> Vec<String> {
        parse(names).unwrap().into_iter().map(|layer| layer.ending).collect()
    }

    #[test]
    fn a_layer_has_its_usual_format_or_the_one_of_its_extension() {
        let names = ["rgba", "z", "object.png", "rgba.npy", "normal.exr", "light:a/b.c", "n_dot_l"];
        let expected = [
            "rgba.png",
            "z.npy",
            "object.png",
            "rgba.npy",
            "normal.exr",
            "light%3Aa%2Fb%2Ec.npy",
            "n_dot_l.npy",
        ];
        assert_eq!(endings(&names), expected);
        assert_eq!(layers(None).unwrap()[0].ending, "rgba.png");
    }

    #[test]
    fn unknown_layers_are_refused_by_name() {
        for (names, expected) in [
            (&["depht"][..], "`depht`"),
            (&["z.svg"], "png, exr, ppm or npy"),
            (&["z", "z.npy"], "`z.npy` is there twice"),
            (&[""], "``"),
        ] {
            let error = parse(names).unwrap_err();
            assert!(error.text.contains(expected), "{names:?}: {}", error.text);
        }
        for value in [serde_json::json!([]), serde_json::json!("z"), serde_json::json!([1])] {
            assert!(layers(Some(&value)).unwrap_err().text.contains("use a list"), "{value}");
        }
    }
}
