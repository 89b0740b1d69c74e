//! Examines the meshes of a scene one by one, and sums up what is found.

use crate::cure;
use crate::drift;
use crate::faces;
use crate::finding::{Finding, Kind};
use crate::folds;
use crate::gaps::{self, Gaps};
use crate::highlight;
use crate::lost;
use crate::normals;
use crate::report::{Report, Setup, Spot, place};
use crate::severity::Pictures;
use crate::silhouette::{self, Sight};
use crate::surface::{Edges, HalfEdge, RUN, Surface, half_edge_of};
use crate::winding;
use luxel_parallel::gather;
use luxel_render::{Interpolation, View};
use luxel_scene::{DVec3, Mesh, NormalSource, Object, Scene};

/// What one mesh adds to a finding.
struct Found {
    kind: Kind,
    count: u64,
    severity: Option<f32>,
    pixels: Option<f32>,
    spots: Vec<Spot>,
}

/// Looks for everything that spoils the shading of a scene.
///
/// The scene is as its file has it, normals not yet computed. Findings of a mesh that several objects
/// show are reported once, at the first of them, but for its outlines.
#[must_use]
pub fn check(scene: &Scene, setup: &Setup) -> Report {
    let mut all: Vec<(u32, Object, Found)> = Vec::new();
    let mut is_known = vec![false; scene.meshes.len()];
    for (number, object) in scene.objects().into_iter().enumerate() {
        let mesh = &scene.meshes[object.mesh.index()];
        if mesh.triangles.is_empty() {
            continue;
        }
        let is_first = !std::mem::replace(&mut is_known[object.mesh.index()], true);
        let found = Examination::of(mesh, scene, setup).run(&object, is_first);
        all.extend(found.into_iter().map(|found| (number as u32, object.clone(), found)));
    }
    let mut report = Report { findings: Vec::new(), spots: Vec::new() };
    for kind in Kind::ALL {
        let mut finding =
            Finding { kind, count: 0, severity: None, pixels: None, places: Vec::new() };
        for (number, object, found) in all.iter().filter(|(_, _, found)| found.kind == kind) {
            let larger = |one: Option<f32>, other: Option<f32>| match (one, other) {
                (Some(one), Some(other)) => Some(one.max(other)),
                (one, other) => one.or(other),
            };
            finding.count += found.count;
            finding.severity = larger(finding.severity, found.severity);
            finding.pixels = larger(finding.pixels, found.pixels);
            let mesh = &scene.meshes[object.mesh.index()];
            let left = Setup::MOST_PLACES.saturating_sub(finding.places.len());
            let told = found.spots.iter().take(left);
            finding.places.extend(told.map(|spot| place(*number, object, mesh, *spot)));
            report.spots.extend(found.spots.iter().map(|spot| (kind, *number, *spot)));
        }
        if finding.count > 0 {
            report.findings.push(finding);
        }
    }
    lost::measure(&mut report, scene, setup);
    report
}

/// A mesh with all that several questions need.
struct Examination<'a> {
    mesh: &'a Mesh,
    scene: &'a Scene,
    setup: &'a Setup,
    surface: Surface<'a>,
    /// The mesh as it is drawn: with the normals that the file lacks.
    drawn: Mesh,
    /// Its normals, corner by corner.
    normals: Vec<[DVec3; 3]>,
    has_file_normals: bool,
    found: Vec<Found>,
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
            self.found.push(Found { kind, count, severity, pixels: None, spots });
        }
    }

    fn run(mut self, object: &Object, is_first: bool) -> Vec<Found> {
        let degenerate = faces::degenerate(&self.surface);
        let mut is_left_out = vec![false; self.surface.triangles.len()];
        degenerate.iter().for_each(|&triangle| is_left_out[triangle as usize] = true);
        let (duplicates, backs) = faces::duplicates(&self.surface, self.scene, &is_left_out);
        for &triangle in duplicates.iter().chain(&backs) {
            is_left_out[triangle as usize] = true;
        }
        let edges = Edges::of(&self.surface, &is_left_out);
        if is_first {
            self.examine(&edges, degenerate, duplicates, &mut is_left_out);
        }
        self.in_view(object, &edges, &is_left_out);
        self.found
    }

    fn examine(
        &mut self,
        edges: &Edges,
        degenerate: Vec<u32>,
        duplicates: Vec<u32>,
        is_left_out: &mut [bool],
    ) {
        let file_normals = self.has_file_normals.then_some(&self.normals[..]);
        let winding = winding::examine(&self.surface, edges, is_left_out, file_normals);
        let boundary = edges.boundary();
        let gaps = gaps::find(&self.surface, &boundary);
        let non_manifold: Vec<HalfEdge> =
            edges.iter().filter(|edge| edge.len() > 2).map(|edge| half_edge_of(edge[0])).collect();
        let slivers = faces::slivers(&self.surface, &self.normals, is_left_out);
        // What is wound wrongly has wrong normals for that reason.
        let mut is_told = is_left_out.to_vec();
        for &triangle in winding.inconsistent.iter().chain(&winding.flipped) {
            is_told[triangle as usize] = true;
        }
        self.leave_out_normal_maps(&mut is_told);
        let normals = normals::examine(&self.surface, &self.drawn, &self.normals, &is_told);
        for &triangle in &normals.unrepresentative {
            is_told[triangle as usize] = true;
        }
        let folds = folds::hidden(&self.surface, edges, &self.normals, &is_told);
        let vertices = if self.mesh.normals.is_empty() {
            normals::seams(&self.surface, &self.normals)
        } else {
            Vec::new()
        };
        let faults = normals::faults(self.mesh);
        let highlights = self.missed_highlights(is_left_out);

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

    /// Attribute vertices as spots, each with the first triangle that it is at.
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

    /// Positions as spots, each with the first triangle that it is at.
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

    /// Where a normal map has the last word, vertex normals are only what it is relative to.
    fn leave_out_normal_maps(&self, is_left_out: &mut [bool]) {
        for part in &self.mesh.parts {
            let material = self.scene.materials.get(part.material.index());
            let run = part.first as usize..(part.first + part.count) as usize;
            if material.is_some_and(|material| material.normal.is_some())
                && let Some(run) = is_left_out.get_mut(run)
            {
                run.fill(true);
            }
        }
    }

    /// Triangles that can lose a highlight, with what they lose.
    fn missed_highlights(&self, is_left_out: &[bool]) -> Vec<(u32, f32)> {
        let mut found = Vec::new();
        if !lost::lights_vertices(self.setup.view.shading.mode) {
            return found;
        }
        for part in &self.mesh.parts {
            let Some(material) = self.scene.materials.get(part.material.index()) else { continue };
            let last = (part.first + part.count).min(is_left_out.len() as u32);
            let first = part.first as usize;
            let count = (last as usize).saturating_sub(first);
            found.append(&mut gather(count, RUN, &|run, found| {
                let run = first + run.start..first + run.end;
                for triangle in run.filter(|&triangle| !is_left_out[triangle]) {
                    let loss = highlight::loss(&self.normals[triangle], material);
                    if loss >= Setup::LEAST_HIGHLIGHT {
                        found.push((triangle as u32, loss));
                    }
                }
            }));
        }
        found
    }

    /// What an object looks like in the view.
    fn in_view(&mut self, object: &Object, edges: &Edges, is_left_out: &[bool]) {
        let View { camera, size, shading, .. } = &self.setup.view;
        let sight = Sight::new(camera, *size, &object.world_from_mesh, self.mesh.origin);
        if shading.interpolation != Interpolation::Perspective {
            let drifts = drift::drifts(&self.surface, is_left_out, &sight, Setup::LEAST_DRIFT);
            let pixels = drifts.iter().map(|(_, pixels)| *pixels).fold(0.0, f64::max);
            let spots = drifts.iter().map(|(triangle, _)| Spot::Triangle(*triangle)).collect();
            self.add(Kind::ScreenDrift, None, spots);
            if let Some(found) = self.found.last_mut().filter(|f| f.kind == Kind::ScreenDrift) {
                found.pixels = Some(pixels as f32);
            }
        }
        let facets =
            silhouette::facets(&self.surface, edges, &self.normals, &sight, Setup::LEAST_OUTLINE);
        let pixels = facets.iter().map(|facet| facet.pixels).fold(0.0, f64::max);
        if !facets.is_empty() {
            self.found.push(Found {
                kind: Kind::FacetedSilhouette,
                count: facets.len() as u64,
                severity: None,
                pixels: Some(pixels as f32),
                spots: facets.iter().map(|facet| Spot::Edge(facet.half_edge)).collect(),
            });
        }
    }
}

/// Draws a mesh as it is, once, and cured, as often as there is something to cure.
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
