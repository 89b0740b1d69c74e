//! Which triangle each sample sees, against the oracle.

use crate::oracle;
use crate::random::{cases, scene};
use crate::scene::{Scene, best};
use luxel_visibility::Coverage;
use proptest::prelude::*;

fn check(scene: &Scene) -> Result<(), TestCaseError> {
    let picture = scene.build().draw(best());
    for (number, position) in scene.sample_positions() {
        let mut hits = oracle::hits(scene, position);
        hits.retain(|hit| hit.coverage != Coverage::Blended);
        let fault = oracle::fault(picture.seen[number], &hits);
        prop_assert_eq!(fault, None, "at {:?}", position);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn every_sample_sees_the_triangle_that_the_oracle_finds(
        scene in scene(&[Coverage::Opaque, Coverage::Cutout, Coverage::Blended], 40)
    ) {
        check(&scene)?;
    }
}

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn scenes_of_many_clusters_show_what_the_oracle_finds(scene in scene(&[Coverage::Opaque], 600)) {
        check(&scene)?;
    }
}
