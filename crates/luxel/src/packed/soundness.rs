//! What the renderer takes for granted of scenes: whatever is referred to is there.

use luxel_lighting::EnvironmentMap;
use luxel_scene::{EnvironmentChoice, Mesh, NodeId, Placement, Scene, TextureUse};

/// Checks all references.
///
/// # Errors
/// What refers to something missing.
pub(super) fn check(scene: &Scene) -> Result<(), String> {
    let must = |is_sound: bool, what: &str, number: usize| match is_sound {
        true => Ok(()),
        false => Err(format!("{what} {number}")),
    };
    for (number, mesh) in scene.meshes.iter().enumerate() {
        must(mesh_is_sound(mesh, scene.materials.len()), "mesh", number)?;
    }
    for (number, material) in scene.materials.iter().enumerate() {
        let uses = [
            &material.base_color,
            &material.metallic_roughness,
            &material.normal,
            &material.occlusion,
            &material.emission,
            &material.specular,
            &material.ambient,
            &material.opacity_map,
        ];
        let is_there =
            |used: &TextureUse| used.texture.index() < scene.textures.len() && used.uv_set < 2;
        let is_sound = uses.into_iter().flatten().all(|used| is_there(used));
        must(is_sound, "material", number)?;
    }
    for (number, node) in scene.nodes.iter().enumerate() {
        let mesh = node.mesh.map(|mesh| scene.meshes.get(mesh.index()));
        let section = match mesh {
            Some(Some(mesh)) if mesh.sections.is_empty() => node.section == 0,
            Some(Some(mesh)) => (node.section as usize) < mesh.sections.len(),
            Some(None) => false,
            None => true,
        };
        let parent = node.parent.is_none_or(|parent| parent.index() < scene.nodes.len());
        must(section && parent, "node", number)?;
    }
    must(is_acyclic(scene), "the parent of node", 0)?;
    let on = |node: Option<NodeId>| node.is_none_or(|node| node.index() < scene.nodes.len());
    for (number, camera) in scene.cameras.iter().enumerate() {
        must(on(camera.node), "camera", number)?;
    }
    for (number, light) in scene.lights.iter().enumerate() {
        let node = match light.placement {
            Placement::Node(node) => Some(node),
            Placement::World | Placement::Camera => None,
        };
        must(on(node), "light", number)?;
    }
    scene.environment.as_ref().map_or(Ok(()), check_environment)
}

/// Checks the map of an environment, if it has one.
///
/// # Errors
/// That it lacks texels.
pub(super) fn check_environment(environment: &EnvironmentChoice) -> Result<(), String> {
    environment.map().map_or(Ok(()), |map| check_map(map.map()))
}

/// Checks the map of an environment.
///
/// # Errors
/// That it lacks texels.
pub(super) fn check_map(map: &EnvironmentMap) -> Result<(), String> {
    if map.is_sound() { Ok(()) } else { Err("the environment's map".to_owned()) }
}

fn mesh_is_sound(mesh: &Mesh, materials: usize) -> bool {
    let positions = mesh.positions.len();
    let triangles = mesh.triangles.len();
    let corners = mesh.attribute_corners();
    let attributes = match mesh.attribute_corners {
        Some(_) => {
            let [first, second] = &mesh.uvs;
            let counts = [
                mesh.normals.len(),
                mesh.tangents.len(),
                first.len(),
                second.len(),
                mesh.colors.len(),
            ];
            counts.into_iter().max().unwrap_or_default()
        }
        None => positions,
    };
    let as_many = |count: usize| count == 0 || count == attributes;
    let below = |indices: &[[u32; 3]], count: usize| {
        indices.as_flattened().iter().all(|&index| (index as usize) < count)
    };
    let is_material = |material: luxel_scene::MaterialId| material.index() < materials;
    let mut next = 0;
    let parts = mesh.parts.iter().all(|part| {
        let follows = u64::from(part.first) == next;
        next += u64::from(part.count);
        follows && is_material(part.material)
    }) && next == triangles as u64;
    let points = mesh.points.iter().all(|points| {
        is_material(points.material) && points.indices.iter().all(|&at| (at as usize) < positions)
    });
    let lines = mesh.lines.iter().all(|lines| {
        let ends = lines.segments.as_flattened();
        is_material(lines.material) && ends.iter().all(|&at| (at as usize) < positions)
    });
    let finite = mesh.positions.as_flattened().iter().all(|number| number.is_finite());
    finite
        && mesh.origin.is_finite()
        && below(&mesh.triangles, positions)
        && corners.len() == triangles
        && below(corners, attributes)
        && as_many(mesh.normals.len())
        && as_many(mesh.tangents.len())
        && mesh.uvs.iter().all(|uvs| as_many(uvs.len()))
        && as_many(mesh.colors.len())
        && mesh.polygons.as_ref().is_none_or(|polygons| polygons.len() == triangles)
        && mesh.smoothing_groups.as_ref().is_none_or(|groups| groups.len() == triangles)
        && mesh.normal_faults.iter().all(|fault| (fault.position as usize) < positions)
        && parts
        && points
        && lines
        && sections_are_sound(mesh, attributes)
}

/// Whether the sections follow one another and end with the mesh.
fn sections_are_sound(mesh: &Mesh, attributes: usize) -> bool {
    let ends =
        |section: &luxel_scene::Section| [section.triangles, section.positions, section.attributes];
    let rising = mesh.sections.windows(2).all(|pair| {
        let [before, after] = [ends(&pair[0]), ends(&pair[1])];
        before.into_iter().zip(after).all(|(before, after)| before <= after)
    });
    let last = mesh.sections.last().map(ends);
    let whole = [mesh.triangles.len(), mesh.positions.len(), attributes].map(|count| count as u32);
    rising && last.is_none_or(|last| last == whole)
}

/// Whether every node has a root above it. Parents are listed.
fn is_acyclic(scene: &Scene) -> bool {
    let mut has_root = vec![false; scene.nodes.len()];
    let mut path = Vec::new();
    for start in 0..scene.nodes.len() {
        let mut at = Some(start);
        while let Some(node) = at.filter(|&node| !has_root[node]) {
            path.push(node);
            if path.len() > scene.nodes.len() {
                return false;
            }
            at = scene.nodes[node].parent.map(NodeId::index);
        }
        path.drain(..).for_each(|node| has_root[node] = true);
    }
    true
}
