//! Builds a scene piece by piece.

use crate::{
    Camera, CameraId, DMat4, DVec3, Lens, MaterialId, Mesh, MeshId, Node, NodeId, Placement, Scene,
    SceneCamera, SceneLight, SceneMaterial,
};
use luxel_lighting::{Attenuation, Light, LightKind, Material};

/// A linear colour from its sRGB code, `0xRRGGBB` (IEC 61966-2-1).
pub(super) fn srgb(code: u32) -> [f32; 3] {
    [16, 8, 0].map(|shift| {
        let value = f64::from(code >> shift & 0xff) / 255.0;
        let linear =
            if value <= 0.040_45 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) };
        linear as f32
    })
}

/// A scene being made.
#[derive(Default)]
pub(super) struct SceneBuilder {
    pub(super) scene: Scene,
}

impl SceneBuilder {
    /// Adds a material.
    pub(super) fn material(&mut self, name: &str, constants: Material) -> MaterialId {
        let material = SceneMaterial { name: name.into(), constants, ..SceneMaterial::default() };
        self.scene.materials.push(material);
        MaterialId(self.scene.materials.len() as u32 - 1)
    }

    /// Adds a mesh with a single material.
    pub(super) fn mesh(&mut self, mut mesh: Mesh, material: MaterialId) -> MeshId {
        for part in &mut mesh.parts {
            part.material = material;
        }
        self.scene.meshes.push(mesh);
        MeshId(self.scene.meshes.len() as u32 - 1)
    }

    /// Adds a node without a mesh, which others hang on.
    pub(super) fn group(
        &mut self,
        name: &str,
        parent: Option<NodeId>,
        parent_from_node: DMat4,
    ) -> NodeId {
        self.node(Node::root(name, None).at(parent, parent_from_node))
    }

    /// Adds a node that shows a mesh.
    pub(super) fn object(
        &mut self,
        name: &str,
        parent: NodeId,
        parent_from_node: DMat4,
        mesh: MeshId,
    ) -> NodeId {
        self.node(Node::root(name, Some(mesh)).at(Some(parent), parent_from_node))
    }

    fn node(&mut self, node: Node) -> NodeId {
        self.scene.nodes.push(node);
        NodeId(self.scene.nodes.len() as u32 - 1)
    }

    /// Adds ambient light.
    pub(super) fn ambient(&mut self, color: [f32; 3]) {
        self.light("ambient", Light::ambient(color), DVec3::ZERO, DVec3::NEG_Y);
    }

    /// Adds light from far away that travels along `direction`.
    pub(super) fn sun(&mut self, name: &str, direction: DVec3, color: [f32; 3]) {
        let light = Light::new(LightKind::Directional, color);
        self.light(name, light, DVec3::ZERO, direction);
    }

    /// Adds a lamp at a place.
    pub(super) fn lamp(
        &mut self,
        name: &str,
        position: DVec3,
        color: [f32; 3],
        attenuation: [f32; 3],
    ) {
        let light = Light {
            attenuation: Attenuation::new(attenuation),
            ..Light::new(LightKind::Point, color)
        };
        self.light(name, light, position, DVec3::NEG_Y);
    }

    fn light(&mut self, name: &str, light: Light, position: DVec3, direction: DVec3) {
        let placement = Placement::World;
        let name = name.into();
        self.scene.lights.push(SceneLight { name, light, placement, position, direction });
    }

    /// Adds a camera at `eye` that looks at `target`, with its own node.
    pub(super) fn camera(
        &mut self,
        parent: NodeId,
        eye: DVec3,
        target: DVec3,
        fov_y_degrees: f64,
    ) -> CameraId {
        let world_from_view = Camera::look_at(eye, target, DVec3::Y).inverse();
        let node = self.group("camera", Some(parent), world_from_view);
        let lens = Lens::Perspective { fov_y_radians: fov_y_degrees.to_radians() };
        self.scene.cameras.push(SceneCamera {
            name: "camera".into(),
            node: Some(node),
            view_from_node: DMat4::IDENTITY,
            lens,
            planes: None,
        });
        CameraId(self.scene.cameras.len() as u32 - 1)
    }
}
