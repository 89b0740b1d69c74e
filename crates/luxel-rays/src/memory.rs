//! What preparing a scene for rays will take.

use crate::bodies::Bodies;
use crate::body_tree::{PlacedTree, Placement};
use crate::scene_rays::SceneRays;
use luxel_bvh::{Bvh, Quality};
use luxel_scene::{Mesh, Object, Part, Scene, SharedAxes, SharedMatrix, bodies};

impl SceneRays {
    /// An upper bound of the memory that [`SceneRays::of_objects`] takes beside the scene, in bytes,
    /// before anything of it is taken.
    #[must_use]
    pub fn bytes_needed(scene: &Scene, objects: &[Object], quality: Quality) -> u64 {
        let of_tree = |triangles| quality.bytes_needed(triangles) as u64 + size_of::<Bvh>() as u64;
        let is_separated = !Bodies::are_traceable(scene, objects);
        let of_mesh = |mesh: &Mesh| {
            if !is_separated {
                return of_tree(mesh.triangles.len());
            }
            // A section's mesh gets a tree of its own, and is a copy.
            let more = mesh.sections.len().saturating_sub(1) as u64 * of_tree(0);
            of_tree(mesh.triangles.len()) + more + bytes_of(mesh)
        };
        // The tree of a body with these triangles and positions, if it has one of its own, and its place in the tree
        // over all bodies, with its box.
        let of_body = |object: &Object, triangles: usize, positions: usize| {
            let mesh = &scene.meshes[object.mesh.index()];
            let placement = Placement::of(mesh, object);
            let of_matrix =
                if placement.shares_matrix_of(object) { 0 } else { SharedMatrix::BYTES };
            let placed = (size_of::<PlacedTree>() + SharedAxes::BYTES + of_matrix) as u64 + 80;
            if !placement.is_baked() {
                return placed;
            }
            placed + of_tree(triangles) + (size_of::<[f32; 3]>() * positions) as u64
        };
        let of_object = |object: &Object| {
            let own = scene.meshes[object.mesh.index()].range_of(object.section);
            of_body(object, own.triangles.len(), own.positions.len())
        };
        let of_whole = |object: &Object| {
            let mesh = &scene.meshes[object.mesh.index()];
            of_body(object, mesh.triangles.len(), mesh.positions.len())
        };
        let (bodies, count) = if is_separated {
            (objects.iter().map(of_object).sum::<u64>(), objects.len())
        } else {
            let firsts = bodies(objects).map(|body| &objects[body.start]);
            firsts.map(of_whole).fold((0, 0), |(sum, count), bytes| (sum + bytes, count + 1))
        };
        let meshes = scene.meshes.iter().map(of_mesh).sum::<u64>();
        meshes + bodies + of_tree(count) + size_of_val(objects) as u64
    }
}

/// The memory of a mesh's copy in sections.
fn bytes_of(mesh: &Mesh) -> u64 {
    let lists = size_of_val(&mesh.positions[..])
        + size_of_val(&mesh.triangles[..])
        + mesh.attribute_corners.as_deref().map_or(0, size_of_val)
        + size_of_val(&mesh.normals[..])
        + size_of_val(&mesh.normal_faults[..])
        + size_of_val(&mesh.tangents[..])
        + mesh.uvs.iter().map(|set| size_of_val(&set[..])).sum::<usize>()
        + size_of_val(&mesh.colors[..])
        + mesh.polygons.as_deref().map_or(0, size_of_val)
        + mesh.smoothing_groups.as_deref().map_or(0, size_of_val)
        + size_of_val(&mesh.parts[..]);
    // Lists of meshes grow to twice their length, beside the shorter list.
    let each = 3 * size_of::<Mesh>() + size_of::<Part>();
    (lists + each * mesh.sections.len().max(1)) as u64
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::{Duration, Instant};

    #[test]
    fn the_bound_of_many_meshes_takes_linear_time() {
        let meshes = vec![Mesh::default(); 400_000];
        let scene = Scene { meshes: meshes.into(), ..Scene::default() };
        let start = Instant::now();
        assert!(SceneRays::bytes_needed(&scene, &[], Quality::InOrder) > 400_000);
        // A look at all meshes for each of them takes minutes.
        assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
    }
}
