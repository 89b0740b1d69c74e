//! The commands of the Khronos registry: prototypes, aliases, and which are of OpenGL 1.5.

use crate::types::{CType, rust_name};
use std::collections::{BTreeMap, BTreeSet};

/// A parameter of a command.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name in Rust.
    pub name: String,
    /// Its type.
    pub kind: CType,
}

/// The prototype of a command.
#[derive(Clone, Debug)]
pub struct Prototype {
    /// Parameters, in order.
    pub parameters: Vec<Parameter>,
    /// What it returns; `None` for `void`.
    pub result: Option<CType>,
    /// The command that the registry says is the same.
    pub alias: Option<String>,
}

/// All commands of the registry.
pub struct Registry {
    /// Of commands that are not exported, some have types of other interfaces.
    commands: BTreeMap<String, Result<Prototype, String>>,
    core: BTreeSet<String>,
}

impl Registry {
    /// Reads `gl.xml`.
    pub fn read(xml: &[u8]) -> Result<Self, String> {
        let text = std::str::from_utf8(xml).map_err(|error| format!("gl.xml: {error}"))?;
        let document =
            roxmltree::Document::parse(text).map_err(|error| format!("gl.xml: {error}"))?;
        let root = document.root_element();
        let mut commands = BTreeMap::new();
        let lists = root.children().filter(|node| node.has_tag_name("commands"));
        for node in
            lists.flat_map(|list| list.children()).filter(|node| node.has_tag_name("command"))
        {
            let (name, prototype) = command(node);
            commands.insert(name, prototype);
        }
        let mut core = BTreeSet::new();
        for feature in root.children().filter(|node| node.has_tag_name("feature")) {
            let number: f64 =
                feature.attribute("number").and_then(|text| text.parse().ok()).unwrap_or(9.0);
            if feature.attribute("api") == Some("gl") && number <= 1.5 {
                let required = feature.descendants().filter(|node| node.has_tag_name("command"));
                core.extend(required.filter_map(|node| node.attribute("name")).map(str::to_owned));
            }
        }
        Ok(Self { commands, core })
    }

    /// The prototype of `name`.
    pub fn prototype(&self, name: &str) -> Result<&Prototype, String> {
        match self.commands.get(name) {
            Some(Ok(prototype)) => Ok(prototype),
            Some(Err(message)) => Err(format!("{name}: {message}")),
            None => Err(format!("{name} is not in the registry")),
        }
    }

    /// Whether `name` is a command of OpenGL 1.5.
    pub fn is_core(&self, name: &str) -> bool {
        self.core.contains(name)
    }

    /// The command that `name` stands for: itself, or what its aliases lead to, as far as `wanted` holds of it.
    pub fn resolve(&self, name: &str, wanted: impl Fn(&str) -> bool) -> Option<String> {
        let mut seen = BTreeSet::new();
        let mut name = name.to_owned();
        while seen.insert(name.clone()) {
            if wanted(&name) {
                return Some(name);
            }
            name = self.prototype(&name).ok()?.alias.clone()?;
        }
        None
    }
}

/// The name and the prototype of a `command` element.
fn command(node: roxmltree::Node<'_, '_>) -> (String, Result<Prototype, String>) {
    let mut children = node.children().filter(|child| child.has_tag_name("proto"));
    let declared = children.next().map(declaration).unwrap_or_default();
    (declared.0, prototype(node, &declared.1))
}

fn prototype(node: roxmltree::Node<'_, '_>, result: &str) -> Result<Prototype, String> {
    let mut parameters = Vec::new();
    for child in node.children().filter(|child| child.has_tag_name("param")) {
        let (name, kind) = declaration(child);
        let kind = CType::parse(&kind)?.ok_or_else(|| format!("{name} has no type"))?;
        parameters.push(Parameter { name: rust_name(&name), kind });
    }
    let alias = node.children().find(|child| child.has_tag_name("alias"));
    let alias = alias.and_then(|alias| alias.attribute("name")).map(str::to_owned);
    Ok(Prototype { parameters, result: CType::parse(result)?, alias })
}

/// The name and the C type of a `proto` or `param` element.
fn declaration(node: roxmltree::Node<'_, '_>) -> (String, String) {
    let mut name = String::new();
    let mut kind = String::new();
    for child in node.children() {
        let text: String = child
            .descendants()
            .filter(roxmltree::Node::is_text)
            .filter_map(|node| node.text())
            .collect();
        if child.has_tag_name("name") { name = text } else { kind.push_str(&text) }
    }
    (name, kind)
}
