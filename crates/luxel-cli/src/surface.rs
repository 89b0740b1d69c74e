//! Applies the flags for materials and normals to a scene.

use crate::options::{MaterialOptions, NormalsChoice, ShadingOptions};
use luxel::scene::{DEFAULT_CREASE_DEGREES, NormalOptions, NormalSource, Restyle, Scene};

/// Applies the flags to all materials.
pub(crate) fn apply_material(options: &MaterialOptions, scene: &mut Scene) {
    let restyle = restyle(options);
    for material in &mut scene.materials {
        restyle.apply(material);
    }
}

/// The changes of materials by flags.
pub(crate) fn restyle(options: &MaterialOptions) -> Restyle {
    let mut restyle = Restyle {
        color: options.color,
        emission: options.emission,
        reflection: options.reflection.clone(),
        ..Restyle::default()
    };
    for (parameter, value) in options.shared.values.iter().chain(&options.own.values) {
        restyle.set_parameter(parameter, *value);
    }
    restyle
}

/// Computes normals as the flags specify, and tangents for normal maps.
pub(crate) fn apply_normals(options: &ShadingOptions, scene: &mut Scene) {
    scene.compute_normals(&normal_options(options));
    scene.compute_tangents();
}

/// The source of normals from the flags.
pub(crate) fn normal_options(options: &ShadingOptions) -> NormalOptions {
    let source = match options.normals {
        NormalsChoice::File => NormalSource::File,
        NormalsChoice::Mean => NormalSource::Mean,
        NormalsChoice::Area => NormalSource::Area,
        NormalsChoice::Angle => NormalSource::Angle,
        NormalsChoice::AreaAngle => NormalSource::AreaAngle,
    };
    let crease_radians = options.crease.unwrap_or(DEFAULT_CREASE_DEGREES).to_radians();
    NormalOptions { source, crease_radians }
}
