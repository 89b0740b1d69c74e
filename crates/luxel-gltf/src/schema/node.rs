//! Nodes, of which a document of a few megabytes may have a million: what most of them lack lies apart.

#![allow(missing_docs, reason = "the names are the specification's, which tells what they mean")]

use super::Index;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// A node, in 40 bytes where it has at most a name, a mesh and a translation.
#[derive(Debug, Default, Deserialize)]
#[serde(from = "NodeFields")]
pub struct Node {
    pub name: Option<Box<str>>,
    pub mesh: Option<Index>,
    pub translation: Option<Box<[f64; 3]>>,
    more: Option<Box<MoreOfNode>>,
}

/// What many nodes of large documents have none of.
#[derive(Debug, Default)]
pub struct MoreOfNode {
    pub children: Box<[Index]>,
    pub skin: Option<Index>,
    pub camera: Option<Index>,
    pub weights: Option<Box<[f64]>>,
    pub matrix: Option<Box<[f64; 16]>>,
    pub rotation: Option<Box<[f64; 4]>>,
    pub scale: Option<Box<[f64; 3]>>,
    pub extensions: NodeExtensions,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub struct NodeExtensions {
    #[serde(rename = "KHR_lights_punctual")]
    pub light: Option<NodeLight>,
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    pub instancing: Option<Box<Instancing>>,
}

#[derive(Debug, Deserialize)]
pub struct NodeLight {
    pub light: Index,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub struct Instancing {
    pub attributes: BTreeMap<String, Index>,
}

/// A node as the document has it.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct NodeFields {
    name: Option<Box<str>>,
    children: Box<[Index]>,
    mesh: Option<Index>,
    skin: Option<Index>,
    camera: Option<Index>,
    weights: Option<Box<[f64]>>,
    matrix: Option<Box<[f64; 16]>>,
    translation: Option<Box<[f64; 3]>>,
    rotation: Option<Box<[f64; 4]>>,
    scale: Option<Box<[f64; 3]>>,
    extensions: NodeExtensions,
}

impl From<NodeFields> for Node {
    fn from(fields: NodeFields) -> Self {
        let NodeFields { name, children, mesh, skin, camera, weights, .. } = fields;
        let NodeFields { matrix, translation, rotation, scale, extensions, .. } = fields;
        let has_more = !children.is_empty()
            || skin.is_some()
            || camera.is_some()
            || weights.is_some()
            || matrix.is_some()
            || rotation.is_some()
            || scale.is_some()
            || extensions.light.is_some()
            || extensions.instancing.is_some();
        let more = has_more.then(|| {
            let of_node =
                MoreOfNode { children, skin, camera, weights, matrix, rotation, scale, extensions };
            Box::new(of_node)
        });
        Self { name, mesh, translation, more }
    }
}

/// What a node without any of it has.
static NO_MORE: LazyLock<MoreOfNode> = LazyLock::new(MoreOfNode::default);

impl Node {
    /// What many nodes have none of.
    #[must_use]
    pub fn more(&self) -> &MoreOfNode {
        self.more.as_deref().unwrap_or(&NO_MORE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_nodes_of_ten_bytes_take_forty_million() {
        assert_eq!(size_of::<Node>(), 40);
    }
}
