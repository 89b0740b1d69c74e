//! Writes scene files that read back value by value.
//!
//! Numbers have the fewest digits that parse to the same number.

use super::document::{Document, in_file_order};
use super::keys::{MATERIAL, MATERIALS, MODELS, OVERRIDES, Section};
use crate::memory::Memory;
use crate::values::{FieldValue, degrees, light_fields, reflection_text};
use crate::{Error, Limits, SettingValue};
use glam::DVec3;
use luxel_lighting::{Environment, Fog, FogLaw, parameters};
use luxel_scene::{
    Background, EnvironmentChoice, Lens, Placement, Restyle, SceneCamera, SceneLight,
};
use std::fmt::Write as _;
use toml::de::DeValue;

/// The content of a scene file to write.
#[derive(Clone, Debug)]
pub struct SceneText<'a> {
    /// The models and their materials.
    pub models: SceneModels<'a>,
    /// Further changes to surfaces, applied after all others.
    pub changes: Vec<SurfaceChange>,
    /// The up direction.
    pub up: DVec3,
    /// I_a: the scene's ambient light.
    pub ambient: [f32; 3],
    /// The environment; the file has no key for `None`.
    pub environment: Option<EnvironmentChoice>,
    /// The path of the environment's picture from the file, if it is one.
    pub environment_file: Option<&'a str>,
    /// What lies behind everything.
    pub background: Background,
    /// Depth cueing.
    pub fog: Option<Fog>,
    /// The lights, each with the path of its node, if it has one.
    pub lights: Vec<(SceneLight, Vec<String>)>,
    /// The cameras; those attached to nodes are left out.
    pub cameras: Vec<SceneCamera>,
    /// Settings of the rendering program, for `[render]`.
    pub settings: Vec<(String, SettingValue)>,
}

/// The source of a scene file's models.
#[derive(Clone, Debug)]
pub enum SceneModels<'a> {
    /// One file in the scene file's folder or below it, or `demo:NAME`. Its first node is named
    /// after the file, without extension.
    One(&'a str),
    /// Copies the models and materials of another scene file.
    AsIn(&'a [u8]),
}

/// A change to the surfaces that match.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceChange {
    /// The path of the objects; `None` for all.
    pub object: Option<Vec<String>>,
    /// The material's name in the model; `None` for all.
    pub surface: Option<String>,
    /// The change.
    pub restyle: Restyle,
}

impl SceneText<'_> {
    /// The text of the file.
    ///
    /// # Errors
    /// [`Error`] if the scene file whose models it copies is not valid.
    pub fn write(&self) -> Result<String, Error> {
        let mut page = Page::default();
        page.line("format", "\"luxel-scene\"");
        page.line("version", "1");
        page.line("up", &vector(self.up));
        page.line("ambient", &color(self.ambient));
        if let Some(named) = self.environment.as_ref().and_then(EnvironmentChoice::named) {
            page.line("environment", &quoted(named.name()));
        } else if let Some(EnvironmentChoice::Always(Environment::Constant(light))) =
            &self.environment
        {
            page.line("environment", &color(*light));
        } else if let Some((name, map)) =
            self.environment_file.zip(self.environment.as_ref().and_then(EnvironmentChoice::map))
        {
            page.line("environment", &quoted(name));
            if map.rotation_degrees() != 0.0 {
                page.line("environment_rotation", &map.rotation_degrees().to_string());
            }
        }
        match self.background {
            Background::Flat(color) => {
                let [r, g, b, alpha] = color.map(single);
                page.line("background", &format!("[{r}, {g}, {b}, {alpha}]"));
            }
            Background::Studio => page.line("background", &quoted(Background::STUDIO)),
        }
        self.models(&mut page)?;
        for (light, node) in &self.lights {
            page.table("[[lights]]");
            write_light(&mut page, light, node);
        }
        for camera in self.cameras.iter().filter(|camera| camera.node.is_none()) {
            page.table("[[cameras]]");
            write_camera(&mut page, camera);
        }
        if let Some(fog) = &self.fog {
            page.table("[fog]");
            write_fog(&mut page, fog);
        }
        if !self.settings.is_empty() {
            page.table("[render]");
            for (name, value) in &self.settings {
                page.line(name, &setting(value));
            }
        }
        Ok(page.text)
    }

    /// Writes models and their materials.
    fn models(&self, page: &mut Page) -> Result<(), Error> {
        let mut names = Vec::new();
        match &self.models {
            SceneModels::One(source) => {
                page.table("[[models]]");
                page.line("source", &quoted(source));
            }
            SceneModels::AsIn(bytes) => {
                let limits = Limits::default();
                let document = Document::parse(bytes, &Memory::new(&limits))?;
                document.root()?;
                for section in [&MODELS, &MATERIAL, &MATERIALS] {
                    copy(&document, section, page)?;
                }
                for table in document.tables(&MATERIALS)? {
                    names.push(table.text("name")?.unwrap_or_default().to_owned());
                }
                copy(&document, &OVERRIDES, page)?;
            }
        }
        let mut chosen = Vec::new();
        for (at, change) in self.changes.iter().enumerate() {
            let surface = change.surface.as_deref();
            let object = change.object.as_ref().and_then(|path| path.last());
            let wanted = surface.or(object.map(String::as_str)).unwrap_or("surface");
            let numbered = (at + 2..).map(|number| format!("{wanted} {number}"));
            let name = std::iter::once(wanted.to_owned())
                .chain(numbered)
                .find(|name| !names.contains(name))
                .unwrap_or_default();
            page.table("[[materials]]");
            page.line("name", &quoted(&name));
            write_restyle(page, &change.restyle);
            names.push(name.clone());
            chosen.push(name);
        }
        for (change, name) in self.changes.iter().zip(chosen) {
            page.table("[[overrides]]");
            page.line("material", &quoted(&name));
            if let Some(path) = &change.object {
                page.line("object", &list(path));
            }
            if let Some(surface) = &change.surface {
                page.line("surface", &quoted(surface));
            }
        }
        Ok(())
    }
}

/// The text of a file as it grows.
#[derive(Default)]
struct Page {
    text: String,
}

impl Page {
    fn table(&mut self, head: &str) {
        // Writing to a string can't fail.
        let _ = write!(self.text, "\n{head}\n");
    }

    fn line(&mut self, key: &str, value: &str) {
        let _ = writeln!(self.text, "{key} = {value}");
    }
}

/// Copies a section of another file, in any TOML spelling.
fn copy(document: &Document<'_>, section: &'static Section, page: &mut Page) -> Result<(), Error> {
    for table in document.tables(section)? {
        let Section { name, repeated, .. } = section;
        page.table(&if *repeated { format!("[[{name}]]") } else { format!("[{name}]") });
        for (key, value) in table.values() {
            page.line(key, &as_toml(value));
        }
    }
    Ok(())
}

/// A value as TOML, on one line.
fn as_toml(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => quoted(text),
        DeValue::Integer(number) if number.radix() == 10 => number.as_str().to_owned(),
        DeValue::Integer(number) => i128::from_str_radix(number.as_str(), number.radix())
            .map_or_else(|_| number.as_str().to_owned(), |number| number.to_string()),
        DeValue::Float(number) => number.as_str().to_owned(),
        DeValue::Boolean(on) => on.to_string(),
        DeValue::Datetime(date) => date.to_string(),
        DeValue::Array(items) => {
            let items: Vec<_> = items.iter().map(|item| as_toml(item.get_ref())).collect();
            format!("[{}]", items.join(", "))
        }
        DeValue::Table(table) => {
            let entries: Vec<_> = in_file_order(table)
                .into_iter()
                .map(|(key, value)| {
                    format!("{} = {}", quoted(key.get_ref()), as_toml(value.get_ref()))
                })
                .collect();
            format!("{{ {} }}", entries.join(", "))
        }
    }
}

fn write_light(page: &mut Page, light: &SceneLight, node: &[String]) {
    page.line("kind", &quoted(light.light.kind.name()));
    page.line("name", &quoted(&light.name));
    match light.placement {
        Placement::World => {}
        Placement::Camera => page.line("in", "\"camera\""),
        Placement::Node(_) => page.line("node", &list(node)),
    }
    for (key, value) in light_fields(light) {
        let text = match value {
            FieldValue::Vector(value) => vector(value),
            FieldValue::Color(value) => color(value),
            FieldValue::Degrees(value) => number(value),
            FieldValue::Number(value) => single(value),
        };
        page.line(key, &text);
    }
}

fn write_camera(page: &mut Page, camera: &SceneCamera) {
    page.line("name", &quoted(&camera.name));
    let numbers = camera.view_from_node.to_cols_array().map(number);
    page.line("view-matrix", &format!("[{}]", numbers.join(", ")));
    match camera.lens {
        Lens::Perspective { fov_y_radians } => page.line("fov", &number(degrees(fov_y_radians))),
        Lens::Orthographic { height } => page.line("ortho", &number(height)),
        Lens::Intrinsics { fx, fy, cx, cy } => {
            page.line("intrinsics", &format!("[{}]", [fx, fy, cx, cy].map(number).join(", ")));
        }
    }
}

fn write_fog(page: &mut Page, fog: &Fog) {
    match fog.law {
        FogLaw::DepthCue { near, far, front, back } => {
            for (key, value) in [("near", near), ("far", far), ("front", front), ("back", back)] {
                page.line(key, &single(value));
            }
        }
        FogLaw::Exponential { density } => {
            page.line("law", "\"exp\"");
            page.line("density", &single(density));
        }
        FogLaw::ExponentialSquared { density } => {
            page.line("law", "\"exp2\"");
            page.line("density", &single(density));
        }
    }
    page.line("color", &color(fog.color));
}

fn write_restyle(page: &mut Page, restyle: &Restyle) {
    let Restyle { color: diffuse, ambient, specular, emission, reflection, .. } = restyle;
    let colors =
        [("color", diffuse), ("ambient", ambient), ("specular", specular), ("emission", emission)];
    for (key, value) in colors {
        if let Some(value) = value {
            page.line(key, &color(*value));
        }
    }
    if let Some(reflection) = reflection {
        page.line("reflection", &quoted(&reflection_text(reflection)));
    }
    let numbers = parameters().map(|one| (one.name, restyle.parameter(one)));
    for (key, value) in numbers.chain([("opacity", restyle.opacity)]) {
        if let Some(value) = value {
            page.line(key, &single(value));
        }
    }
}

fn setting(value: &SettingValue) -> String {
    match value {
        SettingValue::Switch(on) => on.to_string(),
        SettingValue::One(text) => {
            // Numbers are plain.
            let is_number = text.parse::<f64>().is_ok_and(f64::is_finite)
                && text.bytes().all(|byte| byte.is_ascii_digit() || b"-.".contains(&byte))
                && !text.starts_with('.')
                && !text.ends_with('.');
            if is_number { text.clone() } else { quoted(text) }
        }
        SettingValue::Many(items) => list(items),
    }
}

fn list(items: &[String]) -> String {
    let items: Vec<_> = items.iter().map(|item| quoted(item)).collect();
    format!("[{}]", items.join(", "))
}

/// A basic string.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            letter if letter.is_control() => {
                let _ = write!(out, "\\u{:04X}", letter as u32);
            }
            letter => out.push(letter),
        }
    }
    out.push('"');
    out
}

fn vector(vector: DVec3) -> String {
    format!("[{}]", vector.to_array().map(number).join(", "))
}

fn color(color: [f32; 3]) -> String {
    format!("[{}]", color.map(single).join(", "))
}

/// A number that reads back as this one.
fn number(value: f64) -> String {
    let plain = value.to_string();
    // Longer digits are not more readable.
    if plain.len() > 24 { format!("{value:e}") } else { plain }
}

/// A number that reads back, through double precision, as this one.
fn single(value: f32) -> String {
    let plain = value.to_string();
    let text = if plain.len() > 16 { format!("{value:e}") } else { plain };
    let is_same = text.parse::<f64>().is_ok_and(|wide| wide as f32 == value);
    if is_same { text } else { number(f64::from(value)) }
}

#[cfg(test)]
mod tests;
