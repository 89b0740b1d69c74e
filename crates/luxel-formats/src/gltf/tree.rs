//! The node hierarchy of the shown scene (glTF 2.0 specification, section 3.5).

use super::buffers::{item, malformed};
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Limits, Place};
use glam::{DMat4, DQuat, DVec3};
use luxel_gltf::{Document, Index, MoreOfNode, Node};
use luxel_scene::SharedMatrix;

/// The document's nodes, checked: each has one parent at most, and none is its own ancestor.
#[derive(Debug)]
pub(crate) struct Tree {
    /// Each node's transform to the world; none where all nodes are roots.
    world_from_nodes: Vec<SharedMatrix>,
    /// Each node's transform to its parent.
    pub(crate) parent_from_nodes: Vec<SharedMatrix>,
    /// The nodes of the shown scene, parents before children.
    pub(crate) shown: Vec<Shown>,
}

/// A node of the shown scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shown {
    /// Its number in the document.
    pub(crate) node: Index,
    /// Its parent's index in the list.
    pub(crate) parent: Option<u32>,
}

impl Tree {
    pub(crate) fn grow(
        document: &Document,
        limits: &Limits,
        warnings: &mut Warnings,
    ) -> Result<Self, Error> {
        let mut parents = parents(document)?;
        let order = parents_first(&parents, limits)?;
        let roots = roots(document, &parents, warnings)?;
        // A root of the scene has no parent, even if another node lists it as a child.
        for &root in &roots {
            parents[root as usize] = None;
        }
        let nodes = document.nodes.iter().enumerate();
        let mut last = SharedMatrix::default();
        let shared = |(index, node)| {
            last = SharedMatrix::sharing(&placement(node, index, warnings), &last);
            last.clone()
        };
        let parent_from_nodes: Vec<_> = nodes.map(shared).collect();
        let is_flat = parents.iter().all(Option::is_none);
        let mut world_from_nodes = if is_flat { Vec::new() } else { parent_from_nodes.clone() };
        for node in order {
            if let Some(parent) = parents[node as usize] {
                let node = node as usize;
                let parent = &world_from_nodes[parent as usize];
                let world_from_node = parent.matrix() * parent_from_nodes[node].matrix();
                world_from_nodes[node] = SharedMatrix::sharing(&world_from_node, parent);
            }
        }
        let shown = walk(document, &roots, &parents);
        let tree = Self { world_from_nodes, parent_from_nodes, shown };
        for &Shown { node, .. } in &tree.shown {
            if !tree.world_from_node(node).is_finite() {
                let message = "the node's world transform is not finite";
                return Err(malformed(format!("/nodes/{node}"), message));
            }
        }
        Ok(tree)
    }

    /// A node's transform to the world; a root's is that to its parent.
    pub(crate) fn world_from_node(&self, node: Index) -> DMat4 {
        let node = node as usize;
        self.world_from_nodes.get(node).unwrap_or_else(|| &self.parent_from_nodes[node]).matrix()
    }
}

/// The parent of each node.
fn parents(document: &Document) -> Result<Vec<Option<Index>>, Error> {
    let mut parents: Vec<Option<Index>> = vec![None; document.nodes.len()];
    for (index, node) in document.nodes.iter().enumerate() {
        for (place, &child) in node.more().children.iter().enumerate() {
            let pointer = || format!("/nodes/{index}/children/{place}");
            item(&document.nodes, child, "node", &pointer)?;
            if let Some(other) = parents[child as usize].replace(index as Index) {
                let message = format!(
                    "node {child} is already a child of node {other}: a node has at most one parent"
                );
                return Err(malformed(pointer(), message));
            }
        }
    }
    Ok(parents)
}

/// The roots of the default scene, else of the first, else of the document.
fn roots(
    document: &Document,
    parents: &[Option<Index>],
    warnings: &mut Warnings,
) -> Result<Vec<Index>, Error> {
    let index = document.scene.unwrap_or(0);
    if document.scenes.is_empty() && document.scene.is_none() {
        let all = (0..document.nodes.len() as Index).zip(parents);
        return Ok(all.filter(|(_, parent)| parent.is_none()).map(|(node, _)| node).collect());
    }
    let scene = item(&document.scenes, index, "scene", &|| "/scene".to_owned())?;
    let mut is_listed = vec![false; document.nodes.len()];
    let mut roots = Vec::new();
    for (place, &node) in scene.nodes.iter().enumerate() {
        let pointer = || format!("/scenes/{index}/nodes/{place}");
        item(&document.nodes, node, "node", &pointer)?;
        if std::mem::replace(&mut is_listed[node as usize], true) {
            warnings.push(format!("{}: node {node} is listed twice", pointer()));
        } else {
            roots.push(node);
        }
    }
    // A node listed beside its ancestor would be drawn twice.
    let covered = ancestors_listed(parents, &is_listed);
    roots.retain(|&root| {
        let is_covered = covered[root as usize];
        if is_covered {
            warnings
                .push(format!("/scenes/{index}/nodes: node {root} is below another listed node"));
        }
        !is_covered
    });
    Ok(roots)
}

/// Whether a strict ancestor of each node is listed.
fn ancestors_listed(parents: &[Option<Index>], is_listed: &[bool]) -> Vec<bool> {
    let mut known: Vec<Option<bool>> = vec![None; parents.len()];
    for start in 0..parents.len() {
        let mut chain = Vec::new();
        let mut next = start;
        let mut below_listed = loop {
            if let Some(known) = known[next] {
                break known || is_listed[next];
            }
            chain.push(next);
            match parents[next] {
                Some(parent) => next = parent as usize,
                None => break false,
            }
        };
        for &node in chain.iter().rev() {
            known[node] = Some(below_listed);
            below_listed |= is_listed[node];
        }
    }
    known.into_iter().map(Option::unwrap_or_default).collect()
}

/// All nodes, parents first; an error where there is a cycle or too deep a tree.
fn parents_first(parents: &[Option<Index>], limits: &Limits) -> Result<Vec<Index>, Error> {
    let mut depths: Vec<Option<u32>> = vec![None; parents.len()];
    let mut order = Vec::with_capacity(parents.len());
    let mut chain = Vec::new();
    for start in 0..parents.len() {
        let mut next = Some(start as Index);
        let mut depth = 0;
        while let Some(node) = next {
            if let Some(known) = depths[node as usize] {
                depth = known + 1;
                break;
            }
            // More steps up than nodes: the hierarchy has a cycle.
            if chain.len() >= parents.len() {
                let message = format!("node {node} is its own ancestor");
                return Err(malformed(format!("/nodes/{node}/children"), message));
            }
            chain.push(node);
            next = parents[node as usize];
        }
        for node in chain.drain(..).rev() {
            if depth >= limits.max_depth {
                let message = format!("nodes nest deeper than {} levels", limits.max_depth);
                let place = Place::Pointer(format!("/nodes/{node}"));
                return Err(Error::at(place, ErrorKind::Unsupported(message)));
            }
            depths[node as usize] = Some(depth);
            order.push(node);
            depth += 1;
        }
    }
    Ok(order)
}

/// The nodes of the scene in depth-first order.
fn walk(document: &Document, roots: &[Index], parents: &[Option<Index>]) -> Vec<Shown> {
    // Each is shown once, and lists that grow leave holes in the memory.
    let mut shown = Vec::with_capacity(document.nodes.len());
    let mut waiting = Vec::new();
    for &root in roots {
        waiting.push(Shown { node: root, parent: None });
        while let Some(next) = waiting.pop() {
            let parent = Some(shown.len() as u32);
            shown.push(next);
            let children = document.nodes[next.node as usize].more().children.iter().rev();
            // A child that is also a root is drawn as a root.
            let own = children.filter(|&&child| parents[child as usize] == Some(next.node));
            waiting.extend(own.map(|&node| Shown { node, parent }));
        }
    }
    shown
}

/// From a node to its parent: a matrix, or scale, then rotation, then translation.
fn placement(node: &Node, index: usize, warnings: &mut Warnings) -> DMat4 {
    let MoreOfNode { matrix, rotation, scale, .. } = node.more();
    if let Some(matrix) = matrix {
        return DMat4::from_cols_array(matrix);
    }
    let rotation = rotation.as_deref().copied().map_or(DQuat::IDENTITY, DQuat::from_array);
    // Exporters round: few quaternions have exactly unit length.
    let length = rotation.length();
    let rotation = if length > 0.0 && length.is_finite() {
        rotation / length
    } else {
        warnings.push(format!(
            "/nodes/{index}/rotation: the quaternion has length zero and is ignored"
        ));
        DQuat::IDENTITY
    };
    let scale = scale.as_deref().copied().map_or(DVec3::ONE, DVec3::from_array);
    let translation = node.translation.as_deref().copied().map_or(DVec3::ZERO, DVec3::from_array);
    DMat4::from_scale_rotation_translation(scale, rotation, translation)
}
