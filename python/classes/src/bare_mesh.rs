//! What meshes were before their normals were computed: checks look at files as they are.

use luxel::scene::{Mesh, MeshId, Scene, Section};

/// The attributes of a mesh without normals of its own, which computing them splits.
pub(crate) struct BareMesh {
    mesh: MeshId,
    attribute_corners: Option<Vec<[u32; 3]>>,
    normals: Vec<[f32; 3]>,
    tangents: Vec<[f32; 4]>,
    uvs: [Vec<[f32; 2]>; 2],
    colors: Vec<[f32; 4]>,
    sections: Vec<Section>,
}

/// The meshes of a scene that lack normals, which most files of that kind do together with all other attributes.
pub(crate) fn bare_meshes(scene: &Scene) -> Vec<BareMesh> {
    let lacks_normals = |mesh: &Mesh| {
        let highest = mesh.attribute_corners().as_flattened().iter().max();
        highest.is_some_and(|&highest| highest as usize >= mesh.normals.len())
    };
    let all = scene.meshes.iter().enumerate();
    let bare = all.filter(|(_, mesh)| lacks_normals(mesh)).map(|(number, mesh)| BareMesh {
        mesh: MeshId(number as u32),
        attribute_corners: mesh.attribute_corners.clone(),
        normals: mesh.normals.clone(),
        tangents: mesh.tangents.clone(),
        uvs: mesh.uvs.clone(),
        colors: mesh.colors.clone(),
        sections: mesh.sections.clone(),
    });
    bare.collect()
}

/// The scene as the file had it.
pub(crate) fn without_computed_normals(scene: &Scene, bare: &[BareMesh]) -> Scene {
    let mut scene = scene.clone();
    for bare in bare {
        let mesh = &mut scene.meshes[bare.mesh.index()];
        mesh.attribute_corners.clone_from(&bare.attribute_corners);
        mesh.normals.clone_from(&bare.normals);
        mesh.tangents.clone_from(&bare.tangents);
        mesh.uvs.clone_from(&bare.uvs);
        mesh.colors.clone_from(&bare.colors);
        mesh.sections.clone_from(&bare.sections);
    }
    scene
}
