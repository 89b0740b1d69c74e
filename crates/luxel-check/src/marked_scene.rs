//! A scene that shows findings: the model in grey, its faults in colours.

use crate::finding::Kind;
use crate::report::{Report, Spot};
use luxel_lighting::{Material, PictureEncoding, Reflection};
use luxel_scene::{
    Lines, MaterialId, Mesh, MeshId, Node, Part, Points, Scene, SceneMaterial, Sides,
};

/// The model's grey, dark enough for contrast.
const GREY: [f32; 3] = [0.16, 0.165, 0.17];

impl Kind {
    /// The colour of the kind's marks: linear red, green, blue.
    #[must_use]
    pub const fn color(self) -> [f32; 3] {
        match self {
            Self::DegenerateFace => [0.95, 0.15, 0.75],
            Self::DuplicateFace => [0.55, 0.2, 0.95],
            Self::InconsistentWinding => [0.95, 0.06, 0.04],
            Self::FlippedWinding => [0.95, 0.3, 0.02],
            Self::OneSidedSurface => [0.95, 0.53, 0.87],
            Self::NonManifoldEdge => [0.1, 0.35, 0.95],
            Self::TJunction => [0.95, 0.75, 0.05],
            Self::Crack => [0.02, 0.85, 0.85],
            Self::DuplicateVertex => [0.95, 0.95, 0.95],
            Self::UndefinedNormal => [0.95, 0.25, 0.25],
            Self::NonUnitNormal => [0.6, 0.95, 0.1],
            Self::NormalBehindFace => [0.02, 0.85, 0.02],
            Self::UnrepresentativeNormals => [0.1, 0.45, 0.12],
            Self::HiddenFold => [0.3, 0.95, 0.5],
            Self::Sliver => [0.7, 0.42, 0.22],
            Self::MissedHighlight => [0.95, 0.95, 0.55],
            Self::ScreenDrift => [0.5, 0.3, 0.03],
            Self::FacetedSilhouette => [0.35, 0.75, 0.95],
        }
    }

    /// The colour of the kind's marks in a picture: sRGB, 8 bits.
    #[must_use]
    pub fn rgb8(self) -> [u8; 3] {
        self.color().map(|light| PictureEncoding::Srgb.byte(light))
    }
}

impl Report {
    /// The scene in grey, with findings in the colours of their kinds: triangles filled, edges as lines,
    /// vertices as points. Where kinds overlap, the first one of [`Kind::ALL`] is visible.
    #[must_use]
    pub fn marked(&self, scene: &Scene) -> Scene {
        self.marked_only(scene, &Kind::ALL)
    }

    /// As [`Report::marked`], for some kinds only.
    #[must_use]
    pub fn marked_only(&self, scene: &Scene, only: &[Kind]) -> Scene {
        let scene = &*scene.separated();
        let mut marked = Scene {
            nodes: Vec::new(),
            meshes: scene.meshes.clone(),
            materials: scene.materials.iter().map(|material| grey(material.sides)).collect(),
            lights: Vec::new(),
            environment: None,
            ..scene.clone()
        };
        for mesh in &mut marked.meshes {
            mesh.colors = Vec::new();
        }
        let first_material = marked.materials.len() as u32;
        let kinds = Kind::ALL;
        marked.materials.extend(kinds.iter().map(|kind| mark(kind.color())));
        let objects = scene.objects();
        let mut marks: Vec<Node> = Vec::new();
        // Spots of the same kind and object are consecutive.
        let is_same = |one: &(Kind, u32, Spot), other: &(Kind, u32, Spot)| {
            (one.0, one.1) == (other.0, other.1)
        };
        for run in self.spots.chunk_by(is_same) {
            let (kind, index, _) = run[0];
            if !only.contains(&kind) {
                continue;
            }
            let object = &objects[index as usize];
            let number = kinds.iter().position(|other| *other == kind).unwrap_or_default();
            let material = MaterialId(first_material + number as u32);
            let spots: Vec<Spot> = run.iter().map(|(_, _, spot)| *spot).collect();
            marked.meshes.push(mark_mesh(&scene.meshes[object.mesh.index()], &spots, material));
            marks.push(Node {
                parent_from_node: object.world_from_mesh.clone(),
                ..Node::root(kind.name(), Some(MeshId(marked.meshes.len() as u32 - 1)))
            });
        }
        // At equal depth the first triangle is visible: marks precede the model.
        let shift = marks.len() as u32;
        marked.nodes = marks;
        marked.nodes.extend(scene.nodes.iter().map(|node| Node {
            parent: node.parent.map(|parent| luxel_scene::NodeId(parent.0 + shift)),
            ..node.clone()
        }));
        for camera in &mut marked.cameras {
            camera.node = camera.node.map(|node| luxel_scene::NodeId(node.0 + shift));
        }
        marked
    }
}

fn grey(sides: Sides) -> SceneMaterial {
    let constants = Material { diffuse: GREY, k_s: 0.0, ..Material::default() };
    SceneMaterial { constants, sides, ..SceneMaterial::default() }
}

fn mark(color: [f32; 3]) -> SceneMaterial {
    let constants =
        Material { diffuse: color, reflection: Reflection::Unlit, ..Material::default() };
    SceneMaterial { constants, ..SceneMaterial::default() }
}

/// The marks of a mesh.
fn mark_mesh(mesh: &Mesh, spots: &[Spot], material: MaterialId) -> Mesh {
    let mut triangles = Vec::new();
    let mut segments = Vec::new();
    let mut indices = Vec::new();
    for &spot in spots {
        match spot {
            Spot::Triangle(triangle) => {
                let [a, b, c] = mesh.triangles[triangle as usize];
                triangles.push([a, b, c]);
                // Edges make triangles without area visible.
                segments.extend([[a, b], [b, c], [c, a]]);
            }
            Spot::Edge(half_edge) => {
                let corners = mesh.triangles[(half_edge / 3) as usize];
                let k = (half_edge % 3) as usize;
                segments.push([corners[k], corners[(k + 1) % 3]]);
            }
            Spot::Vertex(position, _) => indices.push(position),
        }
    }
    let parts = vec![Part { first: 0, count: triangles.len() as u32, material }];
    let lines = if segments.is_empty() { Vec::new() } else { vec![Lines { segments, material }] };
    let points = if indices.is_empty() { Vec::new() } else { vec![Points { indices, material }] };
    Mesh {
        origin: mesh.origin,
        positions: mesh.positions.clone(),
        triangles,
        parts,
        points,
        lines,
        ..Mesh::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// L, a and b of CIE 1976, D65.
    fn lab([r, g, b]: [f32; 3]) -> [f32; 3] {
        let part = |row: [f32; 3], white: f32| {
            let value = (row[0] * r + row[1] * g + row[2] * b) / white;
            if value > 0.008_856 { libm::cbrtf(value) } else { 7.787 * value + 16.0 / 116.0 }
        };
        let x = part([0.4124, 0.3576, 0.1805], 0.9505);
        let y = part([0.2126, 0.7152, 0.0722], 1.0);
        let z = part([0.0193, 0.1192, 0.9505], 1.089);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    #[test]
    fn no_two_kinds_are_hard_to_tell_apart_by_colour() {
        for (at, kind) in Kind::ALL.into_iter().enumerate() {
            let own = lab(kind.color());
            // The model is lit, so that its grey reaches from dark to L = 53; rims are dark.
            assert!(own[0] > 54.0, "{kind:?} is too dark: {own:?}");
            for other in &Kind::ALL[..at] {
                let there = lab(other.color());
                let squared = [0, 1, 2].map(|at| (own[at] - there[at]) * (own[at] - there[at]));
                let apart = squared.into_iter().sum::<f32>().sqrt();
                assert!(apart > 24.0, "{kind:?} looks like {other:?}: {apart}");
            }
        }
    }
}
