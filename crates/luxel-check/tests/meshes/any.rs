//! Meshes of all sorts.

use crate::made::setup;
use luxel_check::{Kind, check};
use proptest::prelude::*;

use crate::made::scene_of;
use luxel_scene::Mesh;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10))]

    /// Whatever a mesh is like, checking ends, and says the same again.
    #[test]
    fn any_mesh_is_checked_and_says_the_same_twice(
        positions in prop::collection::vec(prop::array::uniform3(-2..3_i8), 3..30),
        corners in prop::collection::vec(prop::array::uniform3(0..30_u32), 0..60),
        has_normals in any::<bool>(),
    ) {
        let count = positions.len() as u32;
        let positions: Vec<_> = positions.iter().map(|p| p.map(f32::from)).collect();
        let normals = if has_normals { positions.clone() } else { Vec::new() };
        let triangles = corners.iter().map(|c| c.map(|corner| corner % count)).collect();
        let scene = scene_of(Mesh { positions, triangles, normals, ..Mesh::default() });
        let setup = setup(&scene);
        let report = check(&scene, &setup);
        prop_assert_eq!(&report.findings, &check(&scene, &setup).findings);
        for finding in &report.findings {
            prop_assert!(finding.count > 0 && !finding.places.is_empty());
            prop_assert!(Kind::ALL.contains(&finding.kind));
        }
        let _ = report.marked(&scene);
    }
}
