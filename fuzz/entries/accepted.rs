//! What holds for everything that a reader accepts.

use luxel_formats::{Format, Limits, read};
use luxel_scene::Scene;

/// Small enough for a lying count to be found before memory runs out.
pub(crate) const LIMITS: Limits =
    Limits { max_memory: 64 << 20, max_depth: 64, progress: None, files: None, given: None };

/// Reads bytes; whatever is accepted must hold together.
pub(crate) fn check(bytes: &[u8], format: Format) {
    if let Ok(loaded) = read(bytes, format, "stem", None, &LIMITS) {
        check_scene(&loaded.scene);
    }
}

/// A scene holds together: every index has its target, every corner its attributes.
pub(crate) fn check_scene(scene: &Scene) {
    for node in &scene.nodes {
        assert!(node.mesh.is_none_or(|mesh| mesh.index() < scene.meshes.len()));
        assert!(node.parent.is_none_or(|parent| parent.index() < scene.nodes.len()));
    }
    for mesh in &scene.meshes {
        let positions = mesh.positions.len();
        let corners = mesh.triangles.as_flattened();
        assert!(corners.iter().all(|&corner| (corner as usize) < positions));
        let finite = |corner: &u32| mesh.positions[*corner as usize].iter().all(|v| v.is_finite());
        assert!(corners.iter().all(finite));
        assert_eq!(mesh.attribute_corners().len(), mesh.triangles.len());
        let attributes = mesh.attribute_corners().as_flattened();
        let holds =
            |count: usize| count == 0 || attributes.iter().all(|&corner| (corner as usize) < count);
        assert!(holds(mesh.normals.len()) && holds(mesh.tangents.len()));
        assert!(holds(mesh.colors.len()) && mesh.uvs.iter().all(|uvs| holds(uvs.len())));
        assert!(mesh.polygons.as_ref().is_none_or(|list| list.len() == mesh.triangles.len()));
        let groups = mesh.smoothing_groups.as_ref();
        assert!(groups.is_none_or(|list| list.len() == mesh.triangles.len()));
        let mut first = 0;
        for part in &mesh.parts {
            assert_eq!(part.first, first);
            assert!(part.material.index() < scene.materials.len());
            first += part.count;
        }
        assert_eq!(first as usize, mesh.triangles.len());
        let ends = mesh.lines.iter().flat_map(|lines| lines.segments.as_flattened());
        let points = mesh.points.iter().flat_map(|points| &points.indices);
        assert!(ends.chain(points).all(|&index| (index as usize) < positions));
    }
    let _ = scene.bounds();
}
