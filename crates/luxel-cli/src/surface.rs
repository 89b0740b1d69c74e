//! What the flags make of a scene's surfaces: materials and normals.

use crate::options::{MaterialOptions, NormalsChoice, ShadingOptions};
use luxel::scene::{
    DEFAULT_CREASE_DEGREES, Mesh, NormalOptions, NormalSource, Scene, SceneMaterial,
};

/// Replaces what the flags name, on all materials.
pub(crate) fn apply_material(options: &MaterialOptions, scene: &mut Scene) {
    for material in &mut scene.materials {
        restyle(options, material);
    }
    if options.color.is_some() {
        for mesh in &mut scene.meshes {
            forget_colors(mesh);
        }
    }
}

fn restyle(options: &MaterialOptions, material: &mut SceneMaterial) {
    let MaterialOptions { color, ka, kd, ks, shininess, emission, reflection } = options;
    let constants = &mut material.constants;
    if let Some(color) = *color {
        constants.diffuse = color;
        constants.ambient = None;
        material.base_color = None;
        material.ambient = None;
    }
    if let Some(emission) = *emission {
        constants.emission = emission;
        material.emission = None;
    }
    constants.k_a = ka.unwrap_or(constants.k_a);
    constants.k_d = kd.unwrap_or(constants.k_d);
    constants.k_s = ks.unwrap_or(constants.k_s);
    constants.shininess = shininess.unwrap_or(constants.shininess);
    if let Some(reflection) = reflection {
        constants.reflection = reflection.clone();
    }
}

fn forget_colors(mesh: &mut Mesh) {
    mesh.colors = Vec::new();
}

/// Gives every mesh the normals that the flags ask for, and tangents where normal maps need them.
pub(crate) fn apply_normals(options: &ShadingOptions, scene: &mut Scene) {
    let source = match options.normals {
        NormalsChoice::File => NormalSource::File,
        NormalsChoice::Mean => NormalSource::Mean,
        NormalsChoice::Area => NormalSource::Area,
        NormalsChoice::Angle => NormalSource::Angle,
        NormalsChoice::AreaAngle => NormalSource::AreaAngle,
    };
    let crease_radians = options.crease.unwrap_or(DEFAULT_CREASE_DEGREES).to_radians();
    scene.compute_normals(&NormalOptions { source, crease_radians });
    scene.compute_tangents();
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::lighting::Reflection;
    use luxel::scene::{TextureId, TextureUse};

    fn nothing() -> MaterialOptions {
        MaterialOptions {
            color: None,
            ka: None,
            kd: None,
            ks: None,
            shininess: None,
            emission: None,
            reflection: None,
        }
    }

    #[test]
    fn without_flags_a_material_stays_as_it_is() {
        let mut material = SceneMaterial::default();
        restyle(&nothing(), &mut material);
        assert_eq!(material, SceneMaterial::default());
    }

    #[test]
    fn a_colour_replaces_textures_and_vertex_colours() {
        let mut scene = Scene::default();
        let textured = SceneMaterial {
            base_color: Some(TextureUse::new(TextureId(0))),
            ..SceneMaterial::default()
        };
        scene.materials.push(textured);
        scene.meshes.push(Mesh { colors: vec![[1.0; 4]], ..Mesh::default() });
        let options = MaterialOptions { color: Some([0.1, 0.2, 0.3]), ..nothing() };
        apply_material(&options, &mut scene);
        assert_eq!(scene.materials[0].constants.diffuse, [0.1, 0.2, 0.3]);
        assert_eq!(scene.materials[0].constants.ambient, None, "ambient is the diffuse colour");
        assert_eq!(scene.materials[0].base_color, None);
        assert!(scene.meshes[0].colors.is_empty());
    }

    #[test]
    fn constants_are_replaced_one_by_one() {
        let mut material = SceneMaterial::default();
        let options = MaterialOptions {
            ks: Some(0.7),
            shininess: Some(99.0),
            reflection: Some(Reflection::Phong),
            ..nothing()
        };
        restyle(&options, &mut material);
        assert_eq!(material.constants.k_s, 0.7);
        assert_eq!(material.constants.shininess, 99.0);
        assert_eq!(material.constants.k_d, 1.0);
        assert_eq!(material.constants.reflection, Reflection::Phong);
    }
}
