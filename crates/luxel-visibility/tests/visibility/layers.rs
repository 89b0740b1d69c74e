//! Blended triangles in layers, and triangles with holes.

use crate::oracle;
use crate::random::{cases, scene};
use crate::scene::{Picture, Scene, Submitted, best, no_holes};
use luxel_visibility::{Coverage, TriangleId};
use proptest::prelude::*;

/// Some holes: about a third of all samples, by triangle and place.
fn is_hole((instance, triangle): Submitted, [x, y]: [i32; 2]) -> bool {
    let mixed = (x / 32).wrapping_mul(0x2545_f491) ^ (y / 32).wrapping_mul(0x3c6e_f372);
    (mixed as u32 ^ triangle.wrapping_mul(0x9e37_79b9) ^ instance as u32) >> 3 & 3 == 0
}

fn coverage(scene: &Scene, (instance, triangle): Submitted) -> Coverage {
    scene.instances[instance].triangles[triangle as usize].1.coverage
}

/// Checks the opaque picture and all layers against what the oracle finds at every sample.
fn check(scene: &Scene, with_holes: bool) -> Result<(), TestCaseError> {
    let built = scene.build();
    let frame = built.frame(best());
    let hole = |id: TriangleId, position: [i32; 2]| {
        let of = frame.triangle(id).unwrap();
        let submitted = (of.instance, of.triangle);
        assert_ne!(coverage(scene, submitted), Coverage::Opaque, "asked for holes in vain");
        with_holes && is_hole(submitted, position)
    };
    let opaque = Picture::with_holes(&frame, best(), &hole);
    let layers = Picture::layers(&frame, best(), &hole);
    let mut most = 0;
    for (number, position) in scene.sample_positions() {
        let mut hits = oracle::hits(scene, position, |_| true);
        hits.retain(|&(_, submitted)| {
            let may_have_holes = coverage(scene, submitted) != Coverage::Opaque;
            !(with_holes && may_have_holes && is_hole(submitted, position))
        });
        let solid =
            hits.iter().position(|&(_, submitted)| coverage(scene, submitted) != Coverage::Blended);
        let wall = solid.map(|place| hits[place]);
        prop_assert_eq!(opaque.seen[number], wall, "opaque at {:?}", position);
        let before = &hits[..solid.unwrap_or(hits.len())];
        most = most.max(before.len());
        for (depth, layer) in layers.iter().enumerate() {
            let expected = before.get(depth).copied().or(wall);
            // Tiles with fewer layers keep nothing of the later ones.
            let seen = layer.seen[number];
            let untouched = depth >= before.len() && seen.is_none();
            prop_assert!(seen == expected || untouched, "layer {} at {:?}", depth, position);
        }
    }
    prop_assert_eq!(layers.len(), most);
    Ok(())
}

const ALL: &[Coverage] = &[Coverage::Opaque, Coverage::Cutout, Coverage::Blended];

proptest! {
    #![proptest_config(cases(120))]

    #[test]
    fn layers_are_peeled_off_in_the_order_of_depth_and_submission(scene in scene(ALL, 24)) {
        check(&scene, false)?;
    }

    #[test]
    fn through_holes_the_next_triangle_is_seen(scene in scene(ALL, 24)) {
        check(&scene, true)?;
    }
}

#[test]
fn an_opaque_scene_has_no_layers() {
    let scene = Scene::of([8, 8], 1, &[], luxel_visibility::PartUse::default());
    let built = scene.build();
    let frame = built.frame(best());
    assert!(!frame.has_blended());
    assert!(Picture::layers(&frame, best(), &no_holes).is_empty());
}
