//! Blended triangles in layers, and triangles with holes.

use crate::oracle::{self, Hit};
use crate::random::{cases, scene};
use crate::scene::{Picture, Scene, Submitted, best, no_holes};
use luxel_visibility::{Coverage, TILE, TriangleId};
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
        let mut hits = oracle::hits(scene, position);
        hits.retain(|hit| {
            let may_have_holes = hit.coverage != Coverage::Opaque;
            !(with_holes && may_have_holes && is_hole(hit.submitted, position))
        });
        let (blended, solid): (Vec<_>, Vec<_>) =
            hits.into_iter().partition(|hit| hit.coverage == Coverage::Blended);
        let wall = opaque.seen[number];
        prop_assert_eq!(oracle::fault(wall, &solid), None, "opaque at {:?}", position);
        let seen: Vec<_> = layers.iter().map(|layer| layer.seen[number]).collect();
        let is_blended =
            |seen: &Seen| seen.is_some_and(|of| coverage(scene, of.1) == Coverage::Blended);
        let peeled = seen.iter().take_while(|seen| is_blended(seen)).count();
        // Tiles with fewer layers keep nothing of the later ones.
        let (peeled, behind) = seen.split_at(peeled);
        prop_assert!(
            behind.iter().all(|&seen| seen == wall || seen.is_none()),
            "at {:?}",
            position
        );
        let peeled: Vec<_> = peeled.iter().flatten().copied().collect();
        most = most.max(peeled.len());
        let fault = fault_of_layers(&peeled, wall, &blended);
        prop_assert_eq!(fault, None, "layers at {:?}", position);
    }
    prop_assert_eq!(layers.len(), most);
    Ok(())
}

type Seen = Option<(f32, Submitted)>;

/// What is wrong with the blended triangles that are peeled off before the wall, nearest first.
fn fault_of_layers(peeled: &[(f32, Submitted)], wall: Seen, blended: &[Hit]) -> Option<String> {
    for &(depth, submitted) in peeled {
        let hit = blended.iter().find(|hit| hit.submitted == submitted);
        if !hit.is_some_and(|hit| hit.has(depth)) {
            return Some(format!("the depth {depth} of {submitted:?}, which is {hit:?}"));
        }
    }
    // Equally near ones in the order of submission.
    let in_order = |a: (f32, Submitted), b: (f32, Submitted)| a.0 > b.0 || a.0 == b.0 && a.1 < b.1;
    let to_the_wall: Vec<_> = peeled.iter().copied().chain(wall).collect();
    if !to_the_wall.windows(2).all(|pair| in_order(pair[0], pair[1])) {
        return Some(format!("the order of {to_the_wall:?}"));
    }
    let is_missing = |hit: &&Hit| {
        peeled.iter().all(|of| of.1 != hit.submitted)
            && wall.is_none_or(|(depth, _)| hit.is_before(depth))
    };
    blended.iter().find(is_missing).map(|hit| format!("{hit:?} is missing"))
}

const ALL: &[Coverage] = &[Coverage::Opaque, Coverage::Cutout, Coverage::Blended];

proptest! {
    #![proptest_config(cases(120))]

    #[test]
    fn layers_are_peeled_off_in_the_order_of_depth_and_submission(scene in scene(ALL, 24)) {
        check(&scene, false)?;
    }

    #[test]
    fn what_covers_a_sample_is_what_is_peeled_off_there(
        scene in scene(&[Coverage::Blended], 24),
        with_holes in any::<bool>(),
    ) {
        let built = scene.build();
        let frame = built.frame(best());
        let submitted = |id: TriangleId| {
            let of = frame.triangle(id).unwrap();
            (of.instance, of.triangle)
        };
        let hole = |id: TriangleId, position: [i32; 2]| with_holes && is_hole(submitted(id), position);
        let layers = Picture::layers(&frame, best(), &hole);
        let [across, _] = frame.tiles();
        for (number, position) in scene.sample_positions() {
            let peeled = layers.iter().map_while(|layer| layer.seen[number]).map(|(_, of)| of);
            let [column, row] = position.map(|steps| (steps / 256 / TILE) as usize);
            let covering = frame.blended_at(row * across + column, position, &hole);
            let covering: Vec<_> = covering.into_iter().map(submitted).collect();
            prop_assert_eq!(covering, peeled.collect::<Vec<_>>(), "at {:?}", position);
        }
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
