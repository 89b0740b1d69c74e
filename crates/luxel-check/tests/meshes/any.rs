//! Meshes of all sorts.

use crate::made::setup;
use luxel_check::{Kind, check};
use proptest::prelude::*;

use crate::made::scene_of;
use luxel_scene::Mesh;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10))]

    /// Checking any mesh terminates, with the same result twice.
    #[test]
    fn checking_any_mesh_gives_the_same_result_twice(
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

/// Twenty thousand triangles that share nothing but one corner: each is near all others there.
#[test]
fn a_star_is_checked_without_comparing_all_its_rays() {
    let mut mesh = Mesh { positions: vec![[0.0; 3]], ..Mesh::default() };
    for ray in 0..20_000_u32 {
        let angle = ray as f32 * 1e-4;
        let end = |turn: f32| [libm::cosf(angle + turn), libm::sinf(angle + turn), angle];
        let first = mesh.positions.len() as u32;
        mesh.positions.extend([end(0.0), end(4e-5)]);
        mesh.triangles.push([0, first, first + 1]);
    }
    let scene = scene_of(mesh);
    let _ = check(&scene, &setup(&scene)).marked(&scene);
}
