//! Families of commands that differ by width and type alone: `glVertex2s` to `glVertex4dv`.

use crate::registry::Prototype;
use serde::Deserialize;

/// A family, as `commands.toml` has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Family {
    /// What the names begin with.
    pub command: String,
    /// How many components the caller may give.
    pub widths: Vec<usize>,
    /// The types by their letters: `b s i ub us ui f d`.
    pub types: Vec<String>,
    /// The components that are not given: all of them, the last ones taken. One alone is a scalar.
    pub fill: Vec<String>,
    /// Integers are mapped onto [0, 1] or [-1, 1] by table 2.9, instead of taken as they are.
    #[serde(default)]
    pub normalized: bool,
    /// The components stay f64.
    #[serde(default)]
    pub double: bool,
    /// The call, with `{}` for the components.
    pub call: String,
}

impl Family {
    /// Names and calls of the family; `prototype` looks a command up.
    pub fn members<'a>(
        &self,
        prototype: impl Fn(&str) -> Result<&'a Prototype, String>,
    ) -> Result<Vec<(String, String)>, String> {
        let mut members = Vec::new();
        for width in &self.widths {
            for kind in &self.types {
                // A family of one width names it only where others of its kind have several.
                let bare = format!("{}{kind}", self.command);
                let scalar = match prototype(&bare) {
                    Ok(_) if self.widths.len() == 1 => bare,
                    _ => format!("{}{width}{kind}", self.command),
                };
                members.push((scalar.clone(), self.scalar(prototype(&scalar)?, *width, kind)?));
                let vector = format!("{scalar}v");
                members.push((vector.clone(), self.vector(prototype(&vector)?, *width, kind)?));
            }
        }
        Ok(members)
    }

    /// The call of a command that takes its components one by one.
    fn scalar(&self, prototype: &Prototype, width: usize, kind: &str) -> Result<String, String> {
        let first = prototype.parameters.len().checked_sub(width);
        let first =
            first.ok_or_else(|| format!("{} has fewer than {width} parameters", self.command))?;
        let names = prototype.parameters[first..].iter().map(|parameter| parameter.name.clone());
        Ok(self.call.replace("{}", &self.components(names, kind)?))
    }

    /// The call of a command that takes its components by address.
    fn vector(&self, prototype: &Prototype, width: usize, kind: &str) -> Result<String, String> {
        let last = prototype
            .parameters
            .last()
            .ok_or_else(|| format!("{}: no parameters", self.command))?;
        let names: Vec<String> =
            ["x", "y", "z", "w"][..width].iter().map(|&name| name.to_owned()).collect();
        let call = self.call.replace("{}", &self.components(names.iter().cloned(), kind)?);
        Ok(format!("let [{}] = array({})?; {call}", names.join(", "), last.name))
    }

    /// The components as the call takes them.
    fn components(
        &self,
        names: impl Iterator<Item = String>,
        kind: &str,
    ) -> Result<String, String> {
        let mut all = self.fill.clone();
        for (place, name) in names.enumerate() {
            all[place] = self.convert(&name, kind)?;
        }
        Ok(if all.len() == 1 { all.remove(0) } else { format!("[{}]", all.join(", ")) })
    }

    /// One component of the type `kind`.
    fn convert(&self, name: &str, kind: &str) -> Result<String, String> {
        Ok(match (kind, self.normalized, self.double) {
            ("f", _, false) | ("d", _, true) => name.to_owned(),
            ("d" | "i" | "ui", false, false) | ("d", true, false) => format!("{name} as f32"),
            ("s" | "ub" | "us" | "b", false, false) => format!("f32::from({name})"),
            ("f", _, true) => format!("f64::from({name})"),
            ("b", true, false) => format!("convert::byte({name})"),
            ("s", true, false) => format!("convert::short({name})"),
            ("i", true, false) => format!("convert::int({name})"),
            ("ub", true, false) => format!("convert::ubyte({name})"),
            ("us", true, false) => format!("convert::ushort({name})"),
            ("ui", true, false) => format!("convert::uint({name})"),
            _ => return Err(format!("{}: there is no conversion from {kind}", self.command)),
        })
    }
}
