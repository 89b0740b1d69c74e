//! Random triangles and scenes, of every sort that rasterizers get wrong.

use crate::scene::{Corner, DEPTHS, Placed, Scene};
use luxel_scene::Size;
use luxel_visibility::{Coverage, CullFaces, PartUse};
use proptest::prelude::*;

/// Triangles of a window with `size` pixels.
pub(crate) fn triangle(size: [u32; 2]) -> impl Strategy<Value = [Corner; 3]> {
    let [width, height] = size.map(|pixels| pixels as i32 * 256);
    // Few depths, so that ties are common.
    let depth = || prop_oneof![Just(DEPTHS / 2), (0..=4_u16).prop_map(|z| z * 256), 0..=DEPTHS];
    let inside = move || (-256..width + 256, -256..height + 256);
    let near = |reach: i32| (-reach..=reach, -reach..=reach);
    let about = move |reach: i32| {
        (inside(), near(reach), near(reach), near(reach))
            .prop_map(|((x, y), a, b, c)| [a, b, c].map(|(dx, dy)| [x + dx, y + dy]))
    };
    let far = 16_000 * 256;
    let anywhere = || (-far..=far, -far..=far).prop_map(|(x, y)| [x, y]);
    let on_centres = move || {
        (-2..size[0] as i32 + 2, -2..size[1] as i32 + 2)
            .prop_map(|(x, y)| [x * 256 + 128, y * 256 + 128])
    };
    let on_sixteenths =
        move || (-32..width / 16 + 32, -32..height / 16 + 32).prop_map(|(x, y)| [x * 16, y * 16]);
    let free = move || inside().prop_map(|(x, y)| [x, y]);
    let three = |corners: BoxedStrategy<[i32; 2]>| [corners.clone(), corners.clone(), corners];
    // A line's two ends, and a corner a few steps off it.
    let thin = (inside(), inside(), 0..=256_i32, near(3)).prop_map(|(p, q, at, off)| {
        let along = |p: i32, q: i32| p + (q - p) / 256 * at;
        [[p.0, p.1], [q.0, q.1], [along(p.0, q.0) + off.0, along(p.1, q.1) + off.1]]
    });
    let degenerate = (inside(), near(2000), 0..4_i32).prop_map(|((x, y), (dx, dy), times)| {
        [[x, y], [x + dx, y + dy], [x + times * dx, y + times * dy]]
    });
    let corners = prop_oneof![
        3 => about(200),
        3 => about(1500),
        3 => about(20_000),
        2 => three(on_centres().boxed()),
        2 => three(on_sixteenths().boxed()),
        2 => three(free().boxed()),
        2 => three(anywhere().boxed()),
        1 => [anywhere().boxed(), free().boxed(), free().boxed()],
        2 => thin,
        1 => degenerate,
    ];
    (corners, [depth(), depth(), depth()], any::<bool>()).prop_map(|(corners, depths, flat)| {
        std::array::from_fn(|corner| {
            let [x, y] = corners[corner];
            Corner { x, y, z: depths[if flat { 0 } else { corner }] }
        })
    })
}

/// How parts are drawn.
pub(crate) fn part(coverages: &'static [Coverage]) -> impl Strategy<Value = PartUse> {
    let culls = vec![CullFaces::None, CullFaces::Clockwise, CullFaces::CounterClockwise];
    (prop::sample::select(culls), prop::sample::select(coverages))
        .prop_map(|(cull, coverage)| PartUse { cull, coverage })
}

/// Scenes of some instances with `triangles` triangles at most each.
pub(crate) fn scene(
    coverages: &'static [Coverage],
    triangles: usize,
) -> impl Strategy<Value = Scene> {
    // The last has tiles enough for clusters of large triangles.
    let sizes = [[1, 1], [5, 3], [63, 17], [64, 64], [65, 66], [130, 20], [90, 75], [330, 260]];
    (prop::sample::select(sizes.to_vec()), prop::sample::select(vec![1, 1, 2, 4, 8, 16]))
        .prop_flat_map(move |(size, samples)| {
            // An oracle asks every triangle at every sample.
            let most = triangles.min(1 + 1_500_000 / (size[0] * size[1] * samples) as usize);
            let uses = prop::collection::vec(part(coverages), 1..3);
            let placed = (
                prop::collection::vec(triangle(size), 0..=most),
                uses,
                any::<bool>(),
                any::<bool>(),
            )
                .prop_map(|(corners, uses, shared, mirrored)| {
                    let run = corners.len().div_ceil(uses.len()).max(1);
                    let triangles = corners
                        .into_iter()
                        .enumerate()
                        .map(|(number, corners)| (corners, uses[number / run]))
                        .collect();
                    Placed { triangles, shared, mirrored }
                });
            prop::collection::vec(placed, 1..4).prop_map(move |instances| Scene {
                size: Size { width: size[0], height: size[1] },
                samples,
                instances,
            })
        })
}

/// How many cases a property is tried with. No files are left behind.
pub(crate) fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}
