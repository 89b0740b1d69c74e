//! Nodes by their names and paths.

use super::document::Table;
use crate::Error;
use crate::values::nearest;
use luxel_scene::{NodeId, Scene};
use std::collections::BTreeMap;

/// The nodes of a scene by their names.
#[derive(Default)]
pub(super) struct Nodes {
    by_name: BTreeMap<String, Vec<NodeId>>,
}

impl Nodes {
    /// Lists the nodes from `first` on.
    pub(super) fn add(&mut self, scene: &Scene, first: usize) {
        for (index, node) in scene.nodes.iter().enumerate().skip(first) {
            self.by_name.entry(node.name.clone()).or_default().push(NodeId(index as u32));
        }
    }

    /// All nodes of this name, or whose path ends with these names.
    pub(super) fn all(&self, scene: &Scene, path: &[String]) -> Vec<NodeId> {
        let split: Vec<&str> = match path {
            // A name may hold a `/` itself.
            [name] if !self.by_name.contains_key(name) => name.split('/').collect(),
            names => names.iter().map(String::as_str).collect(),
        };
        let Some((last, above)) = split.split_last() else { return Vec::new() };
        let candidates = self.by_name.get(*last).map_or(&[][..], Vec::as_slice);
        let fits = |id: &&NodeId| {
            let mut next = scene.nodes[id.index()].parent;
            above.iter().rev().all(|name| {
                let Some(parent) = next.map(|parent| &scene.nodes[parent.index()]) else {
                    return false;
                };
                next = parent.parent;
                parent.name == **name
            })
        };
        candidates.iter().filter(fits).copied().collect()
    }

    /// The one node of this name or path.
    pub(super) fn find(
        &self,
        scene: &Scene,
        table: &Table<'_>,
        key: &str,
        path: &[String],
    ) -> Result<NodeId, Error> {
        let mut nodes = self.all(scene, path);
        // Who gives a whole path leaves no doubt.
        let names = path.iter().flat_map(|name| name.split('/')).count();
        let is_whole = |node: &&NodeId| scene.path(**node).len() == names;
        if let (Some(&node), true) =
            (nodes.iter().find(is_whole), nodes.iter().filter(is_whole).count() == 1)
        {
            nodes = vec![node];
        }
        match nodes[..] {
            [node] => Ok(node),
            [] => Err(table.error_at(key, self.missing(path))),
            [one, other, ..] => {
                let [one, other] = [one, other].map(|node| scene.path(node).join("/"));
                let message = format!(
                    "{key}: `{}` is both {one} and {other}: name the node above it too",
                    path.join("/")
                );
                Err(table.error_at(key, message))
            }
        }
    }

    /// The message for a name that no node has.
    pub(super) fn missing(&self, path: &[String]) -> String {
        let name = path.join("/");
        match nearest(&name, self.by_name.keys().map(String::as_str)) {
            Some(meant) => format!("there is no `{name}`: did you mean `{meant}`?"),
            None => format!("there is no `{name}` (`luxel info` lists the objects of a model)"),
        }
    }
}
