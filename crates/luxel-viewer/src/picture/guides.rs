//! Guides: ground grid, world axes, bounding boxes and normals, as world-space lines.

use crate::picture::Line;
use crate::selection::Selection;
use crate::theme::{AXES, Theme};
use luxel::scene::{Bounds, DMat3, DMat4, DVec3, Mesh, Object, Scene};
use std::collections::BTreeSet;

/// The guides that are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Guides {
    pub(crate) grid: bool,
    pub(crate) axes: bool,
    pub(crate) boxes: bool,
    pub(crate) normals: bool,
}

/// Cells of the grid on each side of its centre.
const CELLS: i32 = 20;
/// Every so many lines of the grid are emphasised.
const MAJOR_EVERY: i32 = 10;
/// A normal's length, as a fraction of the scene's diagonal.
const NORMAL_LENGTH: f64 = 0.015;
/// The most normals that are shown; of more, every n-th.
const MAX_NORMALS: usize = 40_000;

/// The scene as guides need it.
pub(crate) struct GuideScene<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) objects: &'a [Object],
    pub(crate) selection: &'a Selection,
    pub(crate) bounds: Bounds,
    pub(crate) up: DVec3,
}

impl Guides {
    /// Whether any guide is shown.
    pub(crate) fn is_any(self) -> bool {
        self != Self::default()
    }

    /// The lines of all guides that are shown.
    pub(crate) fn lines(self, scene: &GuideScene<'_>, theme: &Theme) -> Vec<Line> {
        let mut lines = Vec::new();
        if scene.bounds.is_empty() {
            return lines;
        }
        if self.grid {
            grid(scene, theme, &mut lines);
        }
        if self.axes {
            axes(scene, &mut lines);
        }
        if self.boxes {
            boxes(scene, theme, &mut lines);
        }
        if self.normals {
            normals(scene, theme, &mut lines);
        }
        lines
    }
}

fn diagonal(bounds: &Bounds) -> f64 {
    (bounds.max - bounds.min).length().max(1e-12)
}

/// The size of a grid cell: 1, 2 or 5 times a power of ten, so that the scene spans about half of the
/// grid.
fn cell_size(diagonal: f64) -> f64 {
    let wanted = diagonal / f64::from(CELLS);
    // By decimal digits, so that the result is the same on all platforms.
    let text = format!("{wanted:e}");
    let power = text.split_once('e').and_then(|(_, power)| format!("1e{power}").parse().ok());
    let power: f64 = power.unwrap_or(1.0);
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|step| step * power)
        .find(|step| *step >= wanted)
        .unwrap_or(wanted)
}

/// Two orthogonal axes of the ground plane.
fn ground_axes(up: DVec3) -> [DVec3; 2] {
    let a = if up.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let a = (a - up * a.dot(up)).normalize_or(DVec3::X);
    [a, up.cross(a)]
}

/// A grid below the scene, centred on it, that fades out.
fn grid(scene: &GuideScene<'_>, theme: &Theme, lines: &mut Vec<Line>) {
    let bounds = &scene.bounds;
    let cell = cell_size(diagonal(bounds));
    let [a, b] = ground_axes(scene.up);
    let floor = bounds.corners().into_iter().map(|corner| corner.dot(scene.up));
    let floor = floor.fold(f64::INFINITY, f64::min);
    // Lines lie at multiples of the cell size in world space.
    let centre = bounds.centre();
    let snapped = |axis: DVec3| (centre.dot(axis) / cell).round();
    let (middle_a, middle_b) = (snapped(a), snapped(b));
    let point = |along_a: f64, along_b: f64| {
        a * ((middle_a + along_a) * cell) + b * ((middle_b + along_b) * cell) + scene.up * floor
    };
    let reach = f64::from(CELLS);
    let fade = |x: f64, y: f64| (1.0 - (x * x + y * y).sqrt() / reach).max(0.0);
    for across in -CELLS..=CELLS {
        for along in -CELLS..CELLS {
            let (across_f, along_f) = (f64::from(across), f64::from(along));
            let left = fade(across_f, along_f + 0.5);
            if left <= 0.0 {
                continue;
            }
            for (is_a, middle) in [(true, middle_b), (false, middle_a)] {
                let is_major = (middle + across_f) % f64::from(MAJOR_EVERY) == 0.0;
                let opacity = left * if is_major { 0.75 } else { 0.4 };
                let ends = if is_a {
                    [point(along_f, across_f), point(along_f + 1.0, across_f)]
                } else {
                    [point(across_f, along_f), point(across_f, along_f + 1.0)]
                };
                lines.push(Line { ends, color: theme.grid, opacity: opacity as f32, width: 1.0 });
            }
        }
    }
}

/// The world's axes from the origin.
fn axes(scene: &GuideScene<'_>, lines: &mut Vec<Line>) {
    let length = diagonal(&scene.bounds) * 0.75;
    for (axis, color) in [DVec3::X, DVec3::Y, DVec3::Z].into_iter().zip(AXES) {
        let line = |to: f64, opacity, width| Line {
            ends: [DVec3::ZERO, axis * to],
            color,
            opacity,
            width,
        };
        lines.push(line(length, 1.0, 1.75));
        // Negative half-axes are fainter.
        lines.push(line(-length, 0.35, 1.0));
    }
}

/// The bounding box of each object, in object space.
fn boxes(scene: &GuideScene<'_>, theme: &Theme, lines: &mut Vec<Line>) {
    let shown = (0..scene.objects.len()).filter(|at| !scene.selection.hidden().contains(at));
    for at in shown {
        let object = &scene.objects[at];
        let bounds = scene.scene.meshes.bounds_of(object.mesh, &DMat4::IDENTITY);
        if bounds.is_empty() {
            continue;
        }
        let is_selected = scene.selection.selected().contains(&at);
        let (color, opacity) = if is_selected { (theme.accent, 1.0) } else { (theme.quiet, 0.8) };
        let corners =
            bounds.corners().map(|corner| object.world_from_mesh.matrix().transform_point3(corner));
        for from in 0..8_usize {
            for axis in 0..3 {
                let to = from | 1 << axis;
                if to != from {
                    let ends = [corners[from], corners[to]];
                    lines.push(Line { ends, color, opacity, width: 1.25 });
                }
            }
        }
    }
}

/// The normals of the selected objects; without a selection, of all visible ones.
fn normals(scene: &GuideScene<'_>, theme: &Theme, lines: &mut Vec<Line>) {
    let (selected, hidden) = (scene.selection.selected(), scene.selection.hidden());
    let shown: BTreeSet<usize> = (0..scene.objects.len())
        .filter(|at| if selected.is_empty() { !hidden.contains(at) } else { selected.contains(at) })
        .collect();
    let mesh_of = |at: &usize| &scene.scene.meshes[scene.objects[*at].mesh.index()];
    let count: usize = shown.iter().map(|at| mesh_of(at).normals.len()).sum();
    let every = count.div_ceil(MAX_NORMALS).max(1);
    let length = diagonal(&scene.bounds) * NORMAL_LENGTH;
    for at in &shown {
        let (mesh, world_from_mesh) = (mesh_of(at), scene.objects[*at].world_from_mesh.matrix());
        // The inverse transpose keeps normals perpendicular under non-uniform scaling.
        let turned = DMat3::from_mat4(world_from_mesh).inverse().transpose();
        for (place, normal) in normal_positions(mesh).into_iter().step_by(every) {
            let from = world_from_mesh.transform_point3(place);
            let way = (turned * normal).normalize_or_zero();
            if way == DVec3::ZERO || !way.is_finite() {
                continue;
            }
            let ends = [from, from + way * length];
            lines.push(Line { ends, color: theme.vectors[0], opacity: 0.9, width: 1.0 });
        }
    }
}

/// Each normal of a mesh once, with its position.
fn normal_positions(mesh: &Mesh) -> Vec<(DVec3, DVec3)> {
    let mut is_seen = vec![false; mesh.normals.len()];
    let mut normal_positions = Vec::new();
    for (corners, attributes) in mesh.triangles.iter().zip(mesh.attribute_corners()) {
        for (&corner, &attribute) in corners.iter().zip(attributes) {
            let (Some(normal), Some(seen)) =
                (mesh.normals.get(attribute as usize), is_seen.get_mut(attribute as usize))
            else {
                continue;
            };
            if !std::mem::replace(seen, true) {
                let [x, y, z] = normal.map(f64::from);
                normal_positions.push((mesh.position(corner), DVec3::new(x, y, z)));
            }
        }
    }
    normal_positions
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::theme::DARK;
    use luxel::scene::demos;

    fn lines(guides: Guides, change: impl FnOnce(&mut Selection)) -> (Vec<Line>, Bounds) {
        let scene = demos::demo("spheres").unwrap();
        let (objects, bounds) = (scene.objects(), scene.bounds());
        let mut selection = Selection::default();
        change(&mut selection);
        let scene = GuideScene {
            scene: &scene,
            objects: &objects,
            selection: &selection,
            bounds,
            up: scene.up,
        };
        (guides.lines(&scene, &DARK), bounds)
    }

    #[test]
    fn the_grid_lies_below_the_scene_at_multiples_of_its_cell_and_exceeds_it() {
        let (lines, bounds) = lines(Guides { grid: true, ..Guides::default() }, |_| {});
        let cell = lines[0].ends[0].distance(lines[0].ends[1]);
        let mut reach: f64 = 0.0;
        for end in lines.iter().flat_map(|line| line.ends) {
            assert!((end.y - bounds.min.y).abs() < 1e-9);
            for along in [end.x / cell, end.z / cell] {
                assert!((along - along.round()).abs() < 1e-6, "{end}");
            }
            reach = reach.max(end.distance(bounds.centre()));
        }
        assert!(reach > diagonal(&bounds) * 0.5, "{reach}");
    }

    #[test]
    fn cells_are_round_numbers_near_a_twentieth() {
        for (diagonal, expected) in
            [(1.0, 0.05), (20.0, 1.0), (21.0, 2.0), (3e-4, 2e-5), (7e6, 5e5)]
        {
            let cell = cell_size(diagonal);
            assert!((cell / expected - 1.0).abs() < 1e-9, "{diagonal}: {cell}");
        }
    }

    #[test]
    fn a_box_has_twelve_edges_and_encloses_its_object() {
        let guides = Guides { boxes: true, ..Guides::default() };
        let (all, _) = lines(guides, |_| {});
        let (fewer, _) = lines(guides, |selection| selection.toggle_shown(0));
        assert_eq!(all.len() % 12, 0);
        assert_eq!(all.len() - fewer.len(), 12);
    }

    #[test]
    fn normals_point_away_from_the_selected_surface() {
        use crate::selection::SelectMode;
        let guides = Guides { normals: true, ..Guides::default() };
        let (all, _) = lines(guides, |_| {});
        let (one, _) = lines(guides, |selection| selection.select([0], SelectMode::Replace));
        assert!(!one.is_empty() && one.len() < all.len());
        // The first sphere's normals point away from its centre.
        let bounds = one.iter().fold(Bounds::EMPTY, |mut bounds, line| {
            bounds.include(line.ends[0]);
            bounds
        });
        for line in &one {
            let out = (line.ends[0] - bounds.centre()).normalize();
            let way = (line.ends[1] - line.ends[0]).normalize();
            assert!(out.dot(way) > 0.95, "{out} {way}");
        }
    }
}
