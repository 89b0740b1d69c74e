//! Which clusters can be seen, where in the window they lie, and how near they come.
//!
//! A cluster's box goes through the very operations that its vertices go through, in the same
//! order, as intervals. Rounding is monotone, so the intervals hold every rounded value of every
//! vertex: bounds are exact, and nothing is ever culled that would have been drawn.

use super::cone_culler::ConeCuller;
use super::interval::Interval;
use crate::cluster::{BOUNDS_WORDS, CONE_WORDS, Clusters, Instance, Instances};
use crate::types::{GUARD_BAND, PartUse, WindowTransform};
use luxel_math::{LANES, Level, Simd, dispatch, f32x16, prelude::*};
use luxel_scene::{Projection, Size};
use std::ops::Range;

/// A cluster that may be seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct VisibleCluster {
    /// The cluster's number among those of all instances.
    pub(crate) cluster: u32,
    /// The pixels that it can cover: first and last column and row, inside the window.
    pub(crate) left: u16,
    pub(crate) top: u16,
    pub(crate) right: u16,
    pub(crate) bottom: u16,
    /// No sample of the cluster is nearer (reversed depth: larger) than this; infinite if clipped.
    pub(crate) nearest: f32,
    /// Whether its triangles need clipping.
    pub(crate) clipped: bool,
}

/// Finds clusters of back faces, and the parts that cull them.
#[derive(Clone, Copy)]
struct BackFaces<'a> {
    culler: &'a ConeCuller,
    /// How each part of the mesh is drawn.
    parts: &'a [PartUse],
}

impl BackFaces<'_> {
    fn are_left_out(&self, clusters: &Clusters, cluster: usize) -> bool {
        let part = clusters.headers[cluster].part as usize;
        self.parts[part].cull == self.culler.away()
    }
}

/// Groups of sixteen clusters of one instance.
struct Piece {
    instance: u32,
    groups: Range<u32>,
}

/// The groups of all instances, in pieces of at most this many.
const MOST_GROUPS: usize = 64;

fn pieces(instances: &Instances<'_>) -> Vec<Piece> {
    let shown = (0..instances.list.len()).filter(|&instance| !instances.list[instance].is_repeated);
    let groups_of = |instance: usize| instances.list[instance].clusters.count().div_ceil(LANES);
    let count = shown.clone().map(|instance| groups_of(instance).div_ceil(MOST_GROUPS)).sum();
    let mut pieces = Vec::with_capacity(count);
    for instance in shown {
        let groups = groups_of(instance);
        pieces.extend((0..groups).step_by(MOST_GROUPS).map(|start| Piece {
            instance: instance as u32,
            groups: start as u32..groups.min(start + MOST_GROUPS) as u32,
        }));
    }
    pieces
}

/// Runs of pieces that have about as many groups: of small instances, a run has many.
fn runs(pieces: &[Piece]) -> Vec<Range<usize>> {
    let mut runs = Vec::new();
    let (mut start, mut groups) = (0, 0);
    for (number, piece) in pieces.iter().enumerate() {
        groups += piece.groups.len();
        if groups >= MOST_GROUPS || number + 1 == pieces.len() {
            runs.push(start..number + 1);
            (start, groups) = (number + 1, 0);
        }
    }
    runs
}

/// The clusters of all instances that may be seen.
pub(crate) fn visible_clusters(
    instances: &Instances<'_>,
    projection: &Projection,
    size: Size,
    level: Level,
) -> impl Iterator<Item = VisibleCluster> {
    let pieces = pieces(instances);
    let runs = runs(&pieces);
    let visible: Vec<Vec<VisibleCluster>> = luxel_parallel::map(runs.len(), 1, &|run| {
        let mut visible = Vec::new();
        let mut culler = None;
        let mut culler_of = usize::MAX;
        for Piece { instance, groups } in &pieces[runs[run.start].clone()] {
            let instance = *instance as usize;
            let transform = instances.transform_of(instance);
            if transform != culler_of {
                let matrix = instances.list[instance].view_from_local.matrix();
                culler = ConeCuller::new(projection, size, &matrix);
                culler_of = transform;
            }
            let transform = instances.window_from_local(instance);
            let Instance { clusters, parts, .. } = &instances.list[instance];
            let first = instances.first_clusters[instance];
            let faces = culler.as_ref().map(|culler| BackFaces { culler, parts });
            let groups = groups.start as usize..groups.end as usize;
            let before = visible.len();
            let out = &mut visible;
            dispatch!(level, simd => cull_groups(simd, &transform, size, clusters, groups, first, faces, out));
            if clusters.has_repeated() {
                let repeated = |visible: &mut VisibleCluster| {
                    instances.is_cluster_repeated(instance, (visible.cluster - first) as usize)
                };
                visible.extract_if(before.., repeated).for_each(drop);
            }
        }
        visible
    });
    visible.into_iter().flatten()
}

/// Appends the clusters of these groups that may be seen.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "the state of a loop, which has one caller")]
fn cull_groups<S: Simd>(
    simd: S,
    transform: &WindowTransform,
    size: Size,
    clusters: &Clusters,
    groups: Range<usize>,
    first_cluster: u32,
    back_faces: Option<BackFaces<'_>>,
    out: &mut Vec<VisibleCluster>,
) {
    for group in groups {
        cull_group(simd, transform, size, clusters, group, first_cluster, back_faces, out);
    }
}

/// Appends the clusters of one group of sixteen that may be seen.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "the state of a loop, which has one caller")]
fn cull_group<S: Simd>(
    simd: S,
    transform: &WindowTransform,
    size: Size,
    clusters: &Clusters,
    group: usize,
    first_cluster: u32,
    back_faces: Option<BackFaces<'_>>,
    out: &mut Vec<VisibleCluster>,
) {
    let mut expanded = [0.0; BOUNDS_WORDS];
    let bounds = clusters.bounds_of_group(group, &mut expanded);
    let mut axes = [Interval { low: f32x16::splat(simd, 0.0), high: f32x16::splat(simd, 0.0) }; 3];
    for (axis, interval) in axes.iter_mut().enumerate() {
        interval.low = f32x16::from_slice(simd, &bounds[axis * LANES..(axis + 1) * LANES]);
        interval.high = f32x16::from_slice(simd, &bounds[(axis + 3) * LANES..(axis + 4) * LANES]);
    }
    let x = Interval::row_times(&transform.rows[0], &axes);
    let y = Interval::row_times(&transform.rows[1], &axes);
    let z = Interval::row_times(&transform.rows[2], &axes);
    let w = Interval::row_times(&transform.rows[3], &axes);
    let zero = w.low.zero();

    // Wholly before the near plane, beyond the far one, or on one side of the window. Two steps of
    // the grid more than half the window, as snapping may move a vertex inwards.
    let half_width = transform.centre[0] + 2.0;
    let half_height = transform.centre[1] + 2.0;
    let outside = (w.high - z.low).less(zero)
        | z.high.less(zero)
        | (x.high + w.high * half_width).less(zero)
        | zero.less(x.low - w.high * half_width)
        | (y.high + w.high * half_height).less(zero)
        | zero.less(y.low - w.high * half_height);

    // Where all vertices lie in front of the near plane, division gives the window's box. It is
    // unknown where numbers overflowed.
    let before_eye = zero.less(w.low) & zero.less_or_equal(w.low - z.high);
    let one = w.low.one();
    let safe_w =
        Interval { low: w.low.select(before_eye, one), high: w.high.select(before_eye, one) };
    let window_x = x.divided_by(safe_w).snapped(transform.centre[0]);
    let window_y = y.divided_by(safe_w).snapped(transform.centre[1]);
    let nearest = z.divided_by(safe_w).high;
    let known = before_eye
        & window_x.low.less_or_equal(window_x.high)
        & window_y.low.less_or_equal(window_y.high);

    let guard = GUARD_BAND as f32;
    let [centre_x, centre_y] = transform.centre;
    let whole = known
        & window_x.within(centre_x - guard, centre_x + guard)
        & window_y.within(centre_y - guard, centre_y + guard);
    // Points that clipping adds are computed otherwise than vertices, and may round otherwise.
    let slack = zero.select(whole, zero + 2.0);
    let (left, right, inside_x) = window_x.grown(slack).pixels(size.width);
    let (top, bottom, inside_y) = window_y.grown(slack).pixels(size.height);

    let seen = !outside & (!known | (inside_x & inside_y));
    let (seen, whole, known) = (seen.to_bitmask(), whole.to_bitmask(), known.to_bitmask());
    let cones = clusters.cones.get(group * CONE_WORDS..(group + 1) * CONE_WORDS);
    let backs = back_faces.zip(cones).map_or(0, |(faces, cones)| {
        faces.culler.sees_only_backs(simd, transform, bounds, cones, [w.low, w.high])
    });
    let first = group * LANES;
    for lane in 0..LANES.min(clusters.count() - first) {
        if seen >> lane & 1 == 0 {
            continue;
        }
        let is_whole = whole >> lane & 1 == 1;
        if is_whole
            && backs >> lane & 1 == 1
            && back_faces.is_some_and(|faces| faces.are_left_out(clusters, first + lane))
        {
            continue;
        }
        let mut visible = VisibleCluster {
            cluster: first_cluster + (first + lane) as u32,
            left: 0,
            top: 0,
            right: (size.width - 1) as u16,
            bottom: (size.height - 1) as u16,
            nearest: if is_whole { nearest[lane] } else { f32::INFINITY },
            clipped: !is_whole,
        };
        if known >> lane & 1 == 1 {
            visible.left = left[lane] as u16;
            visible.top = top[lane] as u16;
            visible.right = right[lane] as u16;
            visible.bottom = bottom[lane] as u16;
        }
        out.push(visible);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cluster::{Frames, TransientBlock};
    use crate::types::{Coverage, CullFaces, ViewFromLocal};
    use glam::{DMat4, DVec3};
    use luxel_math::{SUBPIXELS, SimdLevel, dispatch};
    use luxel_scene::{Camera, Lens, MaterialId, Mesh, Part, Projection};
    use proptest::prelude::*;

    const SIZE: Size = Size { width: 200, height: 120 };

    fn mesh(places: &[[f32; 3]], spread: f32) -> Mesh {
        let mut mesh = Mesh::default();
        for (number, [x, y, z]) in (0..).zip(places) {
            let corners =
                [[*x, *y, *z], [x + spread, *y, z - spread], [*x, y - spread, z + spread]];
            mesh.positions.extend(corners);
            mesh.triangles.push([3 * number, 3 * number + 1, 3 * number + 2]);
        }
        let count = mesh.triangles.len() as u32;
        mesh.parts.push(Part { first: 0, count, material: MaterialId(0) });
        mesh
    }

    proptest! {
        #[test]
        fn bounds_of_clusters_hold_every_vertex(
            places in prop::collection::vec([-3.0..3.0_f32, -3.0..3.0_f32, -3.0..3.0_f32], 1..120),
            spread in prop::sample::select(vec![1e-3_f32, 0.1, 2.0, 1e4]),
            eye in [-4.0..4.0, -4.0..4.0, -4.0..4.0],
            near in prop::sample::select(vec![1e-4, 0.1, 1.0]),
            height in prop::option::of(0.5..20.0),
            frames in prop::sample::select(vec![Frames::Many, Frames::One]),
        ) {
            let mesh = mesh(&places, spread);
            let clusters = Clusters::new(&mesh, frames);
            let mut transient = TransientBlock::new();
            let lens = match height {
                Some(height) => Lens::Orthographic { height },
                None => Lens::Perspective { fov_y_radians: 1.2 },
            };
            let projection = Projection { lens, near, far: 100.0 };
            let view: DMat4 = Camera::look_at(DVec3::from_array(eye), DVec3::ZERO, DVec3::Y);
            let transform = WindowTransform::new(&projection, SIZE, &view);
            let level = SimdLevel::Auto.resolve().unwrap();
            let mut visible = Vec::new();
            for group in 0..clusters.count().div_ceil(LANES) {
                dispatch!(level, simd =>
                    cull_group(simd, &transform, SIZE, &clusters, group, 0, None, &mut visible));
            }
            for cluster in 0..clusters.count() {
                let seen = visible.iter().find(|visible| visible.cluster == cluster as u32);
                let mut inside = false;
                for group in clusters.block(&mesh, cluster, &mut transient).vertices {
                    for lane in 0..LANES {
                        let position = [0, 1, 2].map(|axis| f32::from_bits(group[axis * LANES + lane]));
                        let vertex = transform.clip(position);
                        let held = transform.holds(vertex);
                        prop_assert!(held || seen.is_none_or(|seen| seen.clipped));
                        if !held {
                            continue;
                        }
                        let vertex = transform.window(vertex);
                        let pixel = [vertex.x, vertex.y].map(|steps| steps.div_euclid(SUBPIXELS));
                        let in_window = (0..SIZE.width as i32).contains(&pixel[0])
                            && (0..SIZE.height as i32).contains(&pixel[1]);
                        inside |= in_window && vertex.z >= 0.0;
                        if let Some(seen) = seen {
                            let [left, top, right, bottom] =
                                [seen.left, seen.top, seen.right, seen.bottom].map(i32::from);
                            let boxed = (left..=right).contains(&pixel[0])
                                && (top..=bottom).contains(&pixel[1]);
                            prop_assert!(boxed || !in_window, "{:?} outside of {:?}", vertex, seen);
                            prop_assert!(vertex.z <= seen.nearest, "{:?} before {:?}", vertex, seen);
                        }
                    }
                }
                prop_assert!(seen.is_some() || !inside, "cluster {} is seen", cluster);
            }
        }
    }

    #[test]
    fn clusters_that_repeat_the_one_before_are_left_out_where_nothing_shows_through() {
        let opaque = PartUse::default();
        let blended = PartUse { coverage: Coverage::Blended, ..opaque };
        let one_sided = PartUse { cull: CullFaces::CounterClockwise, ..opaque };
        // Each is a part, and a cluster, of its own: places of the triangle, and how it is drawn.
        let triangles = [
            (0.0, opaque),
            (0.0, opaque),
            (0.0, opaque),
            (0.0, one_sided),
            (0.0, one_sided),
            (0.0, blended),
            (0.0, blended),
            (0.5, opaque),
            (0.0, opaque),
            (0.0, opaque),
        ];
        let places = triangles.map(|(x, _)| [x, 0.0, 0.0]);
        let mut mesh = mesh(&places, 1.0);
        mesh.parts = (0..places.len() as u32)
            .map(|first| Part { first, count: 1, material: MaterialId(first) })
            .collect();
        let view_from_local = ViewFromLocal::new(
            &Camera::look_at(DVec3::new(0.0, 0.0, 9.0), DVec3::ZERO, DVec3::Y),
            DVec3::ZERO,
        );
        let lens = Lens::Perspective { fov_y_radians: 0.8 };
        let projection = Projection { lens, near: 0.1, far: 100.0 };
        let seen_with = |frames, ranks: &[(u32, u8)]| {
            let clusters = Clusters::new(&mesh, frames);
            let instance = Instance {
                mesh: &mesh,
                clusters: &clusters,
                view_from_local: &view_from_local,
                parts: triangles.iter().map(|(_, part)| *part).collect(),
                ranks,
                is_repeated: false,
            };
            let instances = Instances::new(vec![instance], &projection, SIZE).unwrap();
            let level = SimdLevel::Auto.resolve().unwrap();
            let visible = visible_clusters(&instances, &projection, SIZE, level);
            visible.map(|visible| visible.cluster).collect::<Vec<_>>()
        };
        for frames in [Frames::Many, Frames::One] {
            assert_eq!(seen_with(frames, &[]), [0, 3, 5, 6, 7, 8]);
            // The second is set back behind another object's triangle, and shows nowhere; the third isn't.
            assert_eq!(seen_with(frames, &[(1, 1)]), [0, 1, 2, 3, 5, 6, 7, 8]);
        }
    }

    #[test]
    fn clusters_that_turn_their_back_are_dropped_where_back_faces_are_left_out() {
        let mut mesh = luxel_scene::primitives::icosphere(1.0, 40);
        let count = mesh.triangles.len() as u32;
        mesh.parts = vec![Part { first: 0, count, material: MaterialId(0) }];
        let clusters = Clusters::new(&mesh, Frames::Many);
        let lens = Lens::Perspective { fov_y_radians: 0.8 };
        let projection = Projection { lens, near: 0.1, far: 10.0 };
        let size = Size { width: 640, height: 480 };
        let eye = DVec3::new(1.0, 2.0, 2.0);
        let view_from_mesh = Camera::look_at(eye, DVec3::ZERO, DVec3::Y);
        let transform = WindowTransform::new(&projection, size, &view_from_mesh);
        let culler = ConeCuller::new(&projection, size, &view_from_mesh).unwrap();
        let seen_with = |cull| {
            let parts = [PartUse { cull, ..PartUse::default() }];
            let faces = Some(BackFaces { culler: &culler, parts: &parts });
            let level = SimdLevel::Auto.resolve().unwrap();
            let mut visible = Vec::new();
            for group in 0..clusters.count().div_ceil(LANES) {
                dispatch!(level, simd => {
                    cull_group(simd, &transform, size, &clusters, group, 0, faces, &mut visible);
                });
            }
            let seen: Vec<_> = visible.iter().map(|visible| visible.cluster as usize).collect();
            seen
        };
        assert_eq!(seen_with(CullFaces::None).len(), clusters.count());
        assert_eq!(seen_with(CullFaces::CounterClockwise).len(), clusters.count());
        let seen = seen_with(CullFaces::Clockwise);
        let is_behind = |cluster: usize| {
            let block = clusters.kept(cluster).unwrap();
            (0..block.triangles.len()).all(|slot| {
                let [a, b, c] =
                    block.positions(slot).map(|corner| DVec3::from(corner.map(f64::from)));
                (b - a).cross(c - a).dot(a - eye) > 0.0
            })
        };
        for cluster in 0..clusters.count() {
            assert!(seen.contains(&cluster) || is_behind(cluster), "cluster {cluster} has faces");
        }
        // From three radii away two thirds of a sphere turn their back, less a rim as wide as a
        // cluster; what is dropped is less by what isn't known of normals between.
        let behind = (0..clusters.count()).filter(|&cluster| is_behind(cluster)).count();
        let dropped = clusters.count() - seen.len();
        assert!(dropped * 4 > behind * 3, "{dropped} of {behind} are dropped");
    }
}
