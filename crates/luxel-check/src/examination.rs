//! Examines the meshes of a scene and aggregates their findings.

use crate::cure;
use crate::faces;
use crate::finding::{Finding, Kind};
use crate::gaps::{self, Gaps};
use crate::hidden_folds;
use crate::highlight_loss;
use crate::missed_highlights;
use crate::normals;
use crate::report::{Report, Setup, Spot, place};
use crate::screen_drift;
use crate::severity::Pictures;
use crate::silhouette::{self, MeshView};
use crate::surface::{Edges, HalfEdge, RUN, Surface, half_edge_of};
use crate::winding;
use luxel_parallel::{gather, install};
use luxel_render::{Interpolation, View};
use luxel_scene::{DVec3, Mesh, NormalSource, Object, Scene};
use std::collections::HashSet;

/// The contribution of one mesh to a finding.
struct MeshFinding {
    kind: Kind,
    count: u64,
    severity: Option<f32>,
    pixels: Option<f32>,
    spots: Vec<Spot>,
}

/// Checks a scene for faults that spoil its shading.
///
/// The scene is as loaded, with normals not yet computed. Findings of a mesh with several objects are
/// reported once, at the first object, except for silhouettes.
#[must_use]
pub fn check(scene: &Scene, setup: &Setup) -> Report {
    let objects = scene.objects();
    let mut known = HashSet::new();
    let is_first: Vec<bool> =
        objects.iter().map(|object| known.insert((object.mesh, object.section))).collect();
    // On one thread of the pool, where what few triangles need goes without handing it over.
    let all: Vec<(u32, MeshFinding)> = install(None, || {
        gather(objects.len(), 1, &|run, all| {
            let object = &objects[run.start];
            let mesh = &*scene.mesh_of(object);
            if !mesh.triangles.is_empty() {
                let found = Examination::of(mesh, scene, setup).run(object, is_first[run.start]);
                all.extend(found.into_iter().map(|found| (run.start as u32, found)));
            }
        })
    });
    let mut report = Report { findings: Vec::new(), spots: Vec::new() };
    for kind in Kind::ALL {
        let mut finding =
            Finding { kind, count: 0, severity: None, pixels: None, places: Vec::new() };
        for (number, found) in all.iter().filter(|(_, found)| found.kind == kind) {
            let larger = |one: Option<f32>, other: Option<f32>| match (one, other) {
                (Some(one), Some(other)) => Some(one.max(other)),
                (one, other) => one.or(other),
            };
            finding.count += found.count;
            finding.severity = larger(finding.severity, found.severity);
            finding.pixels = larger(finding.pixels, found.pixels);
            let left = Setup::MOST_PLACES.saturating_sub(finding.places.len());
            if left > 0 {
                let object = &objects[*number as usize];
                let mesh = &*scene.mesh_of(object);
                let listed = found.spots.iter().take(left);
                finding.places.extend(listed.map(|spot| place(*number, object, mesh, *spot)));
            }
            report.spots.extend(found.spots.iter().map(|spot| (kind, *number, *spot)));
        }
        if finding.count > 0 {
            report.findings.push(finding);
        }
    }
    missed_highlights::measure(&mut report, scene, setup);
    report
}

/// A mesh with data that several examinations share.
struct Examination<'a> {
    mesh: &'a Mesh,
    scene: &'a Scene,
    setup: &'a Setup,
    surface: Surface<'a>,
    /// The mesh as rendered, with computed normals where the file has none.
    drawn: Mesh,
    /// Its normals by corner.
    normals: Vec<[DVec3; 3]>,
    has_file_normals: bool,
    found: Vec<MeshFinding>,
}

impl<'a> Examination<'a> {
    fn of(mesh: &'a Mesh, scene: &'a Scene, setup: &'a Setup) -> Self {
        let mut drawn = mesh.clone();
        drawn.compute_normals(&setup.normals);
        let normals = normals::of_corners(&drawn);
        let has_file_normals =
            !mesh.normals.is_empty() && setup.normals.source == NormalSource::File;
        let surface = Surface::of(mesh);
        Self { mesh, scene, setup, surface, drawn, normals, has_file_normals, found: Vec::new() }
    }

    fn add(&mut self, kind: Kind, severity: Option<f32>, spots: Vec<Spot>) {
        if !spots.is_empty() {
            let count = spots.len() as u64;
            self.found.push(MeshFinding { kind, count, severity, pixels: None, spots });
        }
    }

    fn run(mut self, object: &Object, is_first: bool) -> Vec<MeshFinding> {
        let degenerate = faces::degenerate(&self.surface);
        let mut is_excluded = vec![false; self.surface.triangles.len()];
        degenerate.iter().for_each(|&triangle| is_excluded[triangle as usize] = true);
        let (duplicates, backs) = faces::duplicates(&self.surface, self.scene, &is_excluded);
        for &triangle in duplicates.iter().chain(&backs) {
            is_excluded[triangle as usize] = true;
        }
        let edges = Edges::of(&self.surface, &is_excluded);
        if is_first {
            self.examine(&edges, degenerate, duplicates, &mut is_excluded);
        }
        self.in_view(object, &edges, &is_excluded);
        self.found
    }

    fn examine(
        &mut self,
        edges: &Edges,
        degenerate: Vec<u32>,
        duplicates: Vec<u32>,
        is_excluded: &mut [bool],
    ) {
        let file_normals = self.has_file_normals.then_some(&self.normals[..]);
        let winding = winding::examine(&self.surface, edges, is_excluded, file_normals);
        let boundary = edges.boundary();
        let gaps = gaps::find(&self.surface, &boundary);
        let non_manifold: Vec<HalfEdge> =
            edges.iter().filter(|edge| edge.len() > 2).map(|edge| half_edge_of(edge[0])).collect();
        let slivers = faces::slivers(&self.surface, &self.normals, is_excluded);
        // Wrong winding explains wrong normals.
        let mut is_told = is_excluded.to_vec();
        for &triangle in winding.inconsistent.iter().chain(&winding.flipped) {
            is_told[triangle as usize] = true;
        }
        self.exclude_normal_maps(&mut is_told);
        let normals = normals::examine(&self.surface, &self.drawn, &self.normals, &is_told);
        for &triangle in &normals.unrepresentative {
            is_told[triangle as usize] = true;
        }
        let folds = hidden_folds::hidden(&self.surface, edges, &self.normals, &is_told);
        let vertices = if self.mesh.normals.is_empty() {
            normals::seams(&self.surface, &self.normals)
        } else {
            Vec::new()
        };
        let faults = normals::faults(self.mesh);
        let highlights = self.missed_highlights(is_excluded);

        let triangles = |list: &[u32]| list.iter().map(|&t| Spot::Triangle(t)).collect::<Vec<_>>();
        let half_edges = |list: &[u32]| list.iter().map(|&e| Spot::Edge(e)).collect::<Vec<_>>();
        let mut measure = Measure { examination: self, before: None };
        let of_degenerate =
            measure.of(degenerate.is_empty(), || cure::without(self.mesh, &degenerate));
        let of_duplicates =
            measure.of(duplicates.is_empty(), || cure::without(self.mesh, &duplicates));
        let of_inconsistent = measure.of(winding.inconsistent.is_empty(), || {
            cure::reversed(self.mesh, &winding.inconsistent)
        });
        let of_flipped =
            measure.of(winding.flipped.is_empty(), || cure::reversed(self.mesh, &winding.flipped));
        let only_junctions = Gaps { t_junctions: gaps.t_junctions.clone(), cracks: Vec::new() };
        let of_junctions =
            measure.of(gaps.t_junctions.is_empty(), || cure::split(&self.surface, &only_junctions));
        let of_cracks = measure.of(gaps.cracks.is_empty(), || cure::closed(&self.surface, &gaps));
        let of_behind = measure.of(normals.behind.is_empty() || !self.has_file_normals, || {
            cure::without_normals(self.mesh, normals.behind.iter().map(|(vertex, _)| *vertex))
        });
        let of_unrepresentative = measure
            .of(normals.unrepresentative.is_empty() || !self.has_file_normals, || {
                cure::with_new_normals(self.mesh)
            });
        let of_folds = measure
            .of(folds.is_empty() || !self.has_file_normals, || cure::with_new_normals(self.mesh));

        self.add(Kind::DegenerateFace, of_degenerate, triangles(&degenerate));
        self.add(Kind::DuplicateFace, of_duplicates, triangles(&duplicates));
        self.add(Kind::InconsistentWinding, of_inconsistent, triangles(&winding.inconsistent));
        self.add(Kind::FlippedWinding, of_flipped, triangles(&winding.flipped));
        self.add(Kind::OneSidedSurface, None, half_edges(&winding.turnovers));
        self.add(Kind::NonManifoldEdge, None, half_edges(&non_manifold));
        let junctions = gaps.t_junctions.iter().map(|(at, edge)| Spot::Vertex(*at, edge / 3));
        self.add(Kind::TJunction, of_junctions, junctions.collect());
        let cracks: Vec<HalfEdge> = gaps.cracks.iter().map(|(edge, _)| *edge).collect();
        self.add(Kind::Crack, of_cracks, half_edges(&cracks));
        self.add(Kind::DuplicateVertex, None, self.vertices(&vertices, self.mesh));
        for (kind, undefined) in [(Kind::UndefinedNormal, true), (Kind::NonUnitNormal, false)] {
            let of_kind = faults.iter().filter(|fault| fault.undefined == undefined);
            let positions: Vec<u32> = of_kind.map(|fault| fault.position).collect();
            self.add(kind, None, self.positions(&positions));
        }
        let behind: Vec<Spot> = normals
            .behind
            .iter()
            .map(|&(vertex, triangle)| {
                let corners = self.drawn.attribute_corners()[triangle as usize];
                let k = corners.iter().position(|&corner| corner == vertex).unwrap_or(0);
                Spot::Vertex(self.mesh.triangles[triangle as usize][k], triangle)
            })
            .collect();
        self.add(Kind::NormalBehindFace, of_behind, behind);
        let unrepresentative = triangles(&normals.unrepresentative);
        self.add(Kind::UnrepresentativeNormals, of_unrepresentative, unrepresentative);
        self.add(Kind::HiddenFold, of_folds, half_edges(&folds));
        self.add(Kind::Sliver, None, triangles(&slivers));
        let highlights = highlights.iter().map(|(triangle, _)| Spot::Triangle(*triangle)).collect();
        self.add(Kind::MissedHighlight, None, highlights);
    }

    /// Attribute vertices as spots, each with the first triangle that uses it.
    fn vertices(&self, vertices: &[u32], mesh: &Mesh) -> Vec<Spot> {
        let mut spots: Vec<Option<Spot>> = vec![None; vertices.len()];
        for (triangle, corners) in mesh.attribute_corners().iter().enumerate() {
            for (k, corner) in corners.iter().enumerate() {
                if let Ok(at) = vertices.binary_search(corner) {
                    let position = mesh.triangles[triangle][k];
                    spots[at].get_or_insert(Spot::Vertex(position, triangle as u32));
                }
            }
        }
        spots.into_iter().flatten().collect()
    }

    /// Positions as spots, each with the first triangle that uses it.
    fn positions(&self, positions: &[u32]) -> Vec<Spot> {
        let mut spots: Vec<Option<Spot>> = vec![None; positions.len()];
        for (triangle, corners) in self.mesh.triangles.iter().enumerate() {
            for corner in corners {
                if let Ok(at) = positions.binary_search(corner) {
                    spots[at].get_or_insert(Spot::Vertex(*corner, triangle as u32));
                }
            }
        }
        spots.into_iter().flatten().collect()
    }

    /// Excludes triangles with a normal map: their vertex normals only define its frame.
    fn exclude_normal_maps(&self, is_excluded: &mut [bool]) {
        for part in &self.mesh.parts {
            let material = self.scene.materials.get(part.material.index());
            let run = part.first as usize..(part.first + part.count) as usize;
            if material.is_some_and(|material| material.normal.is_some())
                && let Some(run) = is_excluded.get_mut(run)
            {
                run.fill(true);
            }
        }
    }

    /// Triangles that can lose a highlight, with their loss.
    fn missed_highlights(&self, is_excluded: &[bool]) -> Vec<(u32, f32)> {
        let mut found = Vec::new();
        if !missed_highlights::lights_vertices(self.setup.view.shading.mode) {
            return found;
        }
        for part in &self.mesh.parts {
            let Some(material) = self.scene.materials.get(part.material.index()) else { continue };
            let last = (part.first + part.count).min(is_excluded.len() as u32);
            let first = part.first as usize;
            let count = (last as usize).saturating_sub(first);
            found.append(&mut gather(count, RUN, &|run, found| {
                let run = first + run.start..first + run.end;
                for triangle in run.filter(|&triangle| !is_excluded[triangle]) {
                    let loss = highlight_loss::loss(&self.normals[triangle], material);
                    if loss >= Setup::LEAST_HIGHLIGHT {
                        found.push((triangle as u32, loss));
                    }
                }
            }));
        }
        found
    }

    /// Examines an object in the view.
    fn in_view(&mut self, object: &Object, edges: &Edges, is_excluded: &[bool]) {
        let View { camera, size, shading, .. } = &self.setup.view;
        let view = MeshView::new(camera, *size, &object.world_from_mesh.matrix(), self.mesh.origin);
        if shading.interpolation != Interpolation::Perspective {
            let drifts =
                screen_drift::drifts(&self.surface, is_excluded, &view, Setup::LEAST_DRIFT);
            let pixels = drifts.iter().map(|(_, pixels)| *pixels).fold(0.0, f64::max);
            let spots = drifts.iter().map(|(triangle, _)| Spot::Triangle(*triangle)).collect();
            self.add(Kind::ScreenDrift, None, spots);
            if let Some(found) = self.found.last_mut().filter(|f| f.kind == Kind::ScreenDrift) {
                found.pixels = Some(pixels as f32);
            }
        }
        let facets =
            silhouette::facets(&self.surface, edges, &self.normals, &view, Setup::LEAST_OUTLINE);
        let pixels = facets.iter().map(|facet| facet.pixels).fold(0.0, f64::max);
        if !facets.is_empty() {
            self.found.push(MeshFinding {
                kind: Kind::FacetedSilhouette,
                count: facets.len() as u64,
                severity: None,
                pixels: Some(pixels as f32),
                spots: facets.iter().map(|facet| Spot::Edge(facet.half_edge)).collect(),
            });
        }
    }
}

/// Measures severities: renders a mesh as it is, once, and repaired, for each fault.
struct Measure<'e, 'a> {
    examination: &'e Examination<'a>,
    before: Option<Option<Pictures>>,
}

impl Measure<'_, '_> {
    fn of(&mut self, is_sound: bool, cured: impl FnOnce() -> Mesh) -> Option<f32> {
        if is_sound {
            return None;
        }
        let Examination { mesh, scene, setup, .. } = self.examination;
        let draw = |mesh: &Mesh| Pictures::of(mesh, scene, &setup.normals, &setup.execution);
        let before = self.before.get_or_insert_with(|| draw(mesh)).as_ref()?;
        Some(before.difference(&draw(&cured())?))
    }
}
