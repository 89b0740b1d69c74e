//! Looks up nodes by name and path.

use super::document::Table;
use crate::Error;
use luxel_scene::{NodeId, Scene};
use std::collections::BTreeMap;

/// The nodes of a scene by name.
#[derive(Default)]
pub(super) struct Nodes {
    by_name: BTreeMap<String, Vec<NodeId>>,
}

impl Nodes {
    /// Indexes the nodes from `first` on.
    pub(super) fn add(&mut self, scene: &Scene, first: usize) {
        for (index, node) in scene.nodes.iter().enumerate().skip(first) {
            self.by_name.entry(node.name.to_string()).or_default().push(NodeId(index as u32));
        }
    }

    /// All nodes with this name, or with a path that ends in these names.
    pub(super) fn all(&self, scene: &Scene, path: &[String]) -> Vec<NodeId> {
        let split: Vec<&str> = match path {
            // A name may contain a `/`.
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

    /// The only node with this name or path.
    pub(super) fn find(
        &self,
        scene: &Scene,
        table: &Table<'_>,
        key: &str,
        path: &[String],
    ) -> Result<NodeId, Error> {
        let mut nodes = self.all(scene, path);
        // A complete path is unambiguous.
        let names = path.iter().flat_map(|name| name.split('/')).count();
        let is_whole = |node: &&NodeId| scene.path(**node).len() == names;
        if let (Some(&node), true) =
            (nodes.iter().find(is_whole), nodes.iter().filter(is_whole).count() == 1)
        {
            nodes = vec![node];
        }
        match nodes[..] {
            [node] => Ok(node),
            [] => Err(self.missing(table, key, path)),
            [one, other, ..] => {
                let [one, other] = [one, other].map(|node| scene.path(node).join("/"));
                let message = format!(
                    "{key}: `{}` may be {one} or {other}: add the name of its parent",
                    path.join("/")
                );
                Err(table.error_at(key, message))
            }
        }
    }

    /// The error for an unknown node name.
    pub(super) fn missing(&self, table: &Table<'_>, key: &str, path: &[String]) -> Error {
        let known = self.by_name.keys().map(String::as_str);
        table.unknown_name(key, "node", &path.join("/"), known)
    }
}
