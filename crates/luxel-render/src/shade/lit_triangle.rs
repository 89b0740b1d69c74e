//! Triangles whose light is computed elsewhere than at their pixels, or which are interpolated in the
//! window: looked up and lit once, not for every sample.

use super::place_terms::{LitPlace, PlaceTerms};
use super::screen_interpolation::{InWindow, Outline};
use super::whole_place::WholePlaces;
use crate::context::{AttributeMask, LitAt, ShadingContext};
use crate::material::{Attributes, Corner, TriangleLight, light_at};
use crate::setup::PlacedCorners;
use crate::subdivision::{Asked, Comparison, Pieces, mixed};
use glam::DVec3;
use luxel_lighting::Silent;
use luxel_math::Vec3;
use luxel_scene::{Mesh, Size};
use luxel_view::{Interpolation, ShadingMode};
use luxel_visibility::{Forms, InstanceSpace, TriangleId, TriangleOf, interpolate_corners};
use std::sync::Arc;

/// Where the light of a triangle comes from, if not from its pixels or its corners.
#[derive(Clone)]
enum OwnLight {
    None,
    /// From the polygon's centroid.
    Whole(Box<Corner>),
    /// From the corners of smaller triangles.
    Pieces(Arc<Pieces>),
}

/// A triangle with everything that interpolation wants.
#[derive(Clone)]
pub(crate) struct LitTriangle {
    id: TriangleId,
    pub(crate) of: TriangleOf,
    pub(crate) forms: Forms,
    /// The number of its material.
    pub(crate) material: u32,
    pub(crate) has: AttributeMask,
    pub(crate) corners: [Corner; 3],
    own_light: OwnLight,
    /// Terms of its places that were needed last, by number.
    terms: Vec<(u32, PlaceTerms)>,
    /// The polygon in the window, where interpolation goes without perspective.
    pub(crate) outline: Option<Box<Outline>>,
}

/// The triangles that a thread has seen last, by their ids.
pub(crate) struct LitTriangles {
    /// None before the first is seen: plain pictures see none.
    entries: Vec<Option<LitTriangle>>,
}

/// Entries of the cache: 128 KiB, a part of a core's second-level cache.
const ENTRIES: usize = 256;
/// Most terms of places that a triangle keeps: neighbouring samples lie in the same pieces.
const MOST_TERMS: usize = 32;
/// Spreads ids over entries: 2^32 divided by the golden ratio (Knuth, The Art of Computer Programming 3, 6.4).
const MULTIPLIER: u32 = 0x9e37_79b9;

/// Where a cache of so many entries, a power of two, holds an id.
///
/// Low bits are numbers within a cluster: a wall's two triangles would share entries with the next wall's.
pub(super) fn entry_of(id: TriangleId, entries: usize) -> usize {
    (id.0.wrapping_mul(MULTIPLIER) >> (u32::BITS - entries.ilog2())) as usize
}

impl LitTriangles {
    pub(crate) fn new() -> Self {
        Self { entries: Vec::new() }
    }

    /// Forgets the triangles of another frame.
    pub(crate) fn begin_frame(&mut self) {
        self.entries.clear();
    }

    /// The triangle of an id; `None` for [`TriangleId::NONE`].
    pub(crate) fn get(
        &mut self,
        scene: &ShadingContext<'_>,
        id: TriangleId,
    ) -> Option<&mut LitTriangle> {
        if self.entries.is_empty() {
            self.entries.resize(ENTRIES, None);
        }
        let entry = &mut self.entries[entry_of(id, ENTRIES)];
        if entry.as_ref().is_none_or(|seen| seen.id != id) {
            let of = scene.frame.triangle(id)?;
            let mut seen = LitTriangle::new(scene, id, of);
            seen.light_elsewhere(scene);
            *entry = Some(seen);
        }
        entry.as_mut()
    }
}

impl LitTriangle {
    pub(super) fn new(scene: &ShadingContext<'_>, id: TriangleId, of: TriangleOf) -> Self {
        let frame = scene.frame;
        let space = scene.space(of.instance);
        let mesh = frame.instances()[of.instance].mesh;
        let positions = mesh.triangles[of.triangle as usize].map(|at| mesh.positions[at as usize]);
        let attributes = mesh.attribute_corners()[of.triangle as usize].map(|at| at as usize);
        let in_mesh = InstanceSpace::normals_in_mesh(mesh, attributes);
        let placed = PlacedCorners::new(frame.rays(), space, positions);
        let about_eye = placed.positions(space);
        let normals = placed.normals(space, in_mesh);
        let corner =
            |place: usize| corner(mesh, space, attributes[place], about_eye[place], normals[place]);
        Self {
            id,
            of,
            forms: Forms::new(frame.rays(), placed.in_view),
            material: mesh.parts[of.part].material.0,
            has: AttributeMask::of_mesh(mesh),
            corners: [corner(0), corner(1), corner(2)],
            own_light: OwnLight::None,
            terms: Vec::new(),
            outline: None,
        }
    }

    /// The corners of a triangle, lit there or, in flat shading, with the light of the whole. Given
    /// places in view space, they are lit there instead. Shading is flat or Gouraud: corners have no pieces.
    pub(crate) fn lit_corners(
        scene: &ShadingContext<'_>,
        of: TriangleOf,
        places: Option<[DVec3; 3]>,
    ) -> [Corner; 3] {
        debug_assert!(matches!(scene.shading.mode, ShadingMode::Flat | ShadingMode::Gouraud));
        let mut seen = Self::new(scene, TriangleId::NONE, of);
        let world_from_view = scene.space(of.instance).view().world_from_view;
        for (corner, place) in seen.corners.iter_mut().zip(places.into_iter().flatten()) {
            corner.position = (world_from_view * place).as_vec3().to_array();
        }
        seen.light_elsewhere(scene);
        if let OwnLight::Whole(whole) = &seen.own_light {
            for corner in &mut seen.corners {
                corner.light = whole.light;
            }
        }
        seen.corners
    }

    /// Computes what is not computed at pixels, as the shading mode asks.
    fn light_elsewhere(&mut self, scene: &ShadingContext<'_>) {
        let (has, material) = (self.has, self.material);
        let lit = |corner: &Corner| light_at(scene, corner, has, material, &mut Silent);
        match scene.shading.mode {
            _ if scene.lit_at(material as usize) == LitAt::Pixels => {}
            ShadingMode::Phong => {}
            ShadingMode::Flat => {
                let mut whole = self.whole(scene);
                whole.light = lit(&whole);
                self.own_light = OwnLight::Whole(Box::new(whole));
            }
            ShadingMode::Gouraud => {
                let light = [0, 1, 2].map(|at| lit(&self.corners[at]));
                for (corner, light) in self.corners.iter_mut().zip(light) {
                    corner.light = light;
                }
            }
            ShadingMode::Subdivided { tolerance } => {
                let space = scene.space(self.of.instance);
                let corners = &self.corners;
                let Size { width, height } = scene.frame.size();
                let light = TriangleLight { scene, corners, has, material };
                let asked = Asked {
                    tolerance,
                    light: &light,
                    comparison: Comparison {
                        level: scene.level,
                        display: scene.display,
                        encoding: scene.encoding,
                        texels: light.texels(),
                    },
                    size: [f64::from(width), f64::from(height)],
                    window: &|place| {
                        let about_eye = mixed(corners.map(|corner| corner.position), place);
                        let about_eye = DVec3::from_array(about_eye.map(f64::from));
                        scene
                            .frame
                            .rays()
                            .window(space.view().world_from_view.transpose() * about_eye)
                    },
                };
                let pieces = scene.subdivided.pieces(self.id, || Pieces::new(asked));
                self.own_light = OwnLight::Pieces(pieces);
            }
        }
        let interpolation = scene.shading.interpolation;
        if interpolation != Interpolation::Perspective {
            let scan = interpolation == Interpolation::Scanline;
            let mut around = self.around(scene, scan);
            if scene.shading.mode == ShadingMode::Gouraud {
                for (_, corner) in &mut around {
                    corner.light = lit(corner);
                }
            }
            let parallel = scene.space(self.of.instance).view().parallel;
            let rays = scene.frame.rays();
            self.outline = Some(Box::new(Outline::new(rays, scene.near, parallel, scan, &around)));
        }
    }

    /// The corners between which interpolation goes in the window, with their places in view space:
    /// the polygon's, or the triangle's.
    fn around(&self, scene: &ShadingContext<'_>, polygon: bool) -> Vec<(DVec3, Corner)> {
        let Self { of, .. } = *self;
        let instance = &scene.frame.instances()[of.instance];
        let polygons = scene.polygons[of.instance].filter(|_| polygon);
        let Some(polygons) = polygons else {
            return self.forms.corners().into_iter().zip(self.corners).collect();
        };
        let space = scene.space(of.instance);
        let mesh = instance.mesh;
        // All corners are turned as this triangle's are.
        let turned = self.is_turned(mesh, space);
        let corner_of = |(position, attribute): (u32, u32)| {
            let in_view = space.view_from_local.place(mesh.positions[position as usize]);
            let attribute = attribute as usize;
            let normal = match mesh.normals.get(attribute) {
                Some(&[x, y, z]) => {
                    let normal = space.unit_normal(Vec3::new(x, y, z));
                    if turned { -normal } else { normal }
                }
                None => {
                    let [x, y, z] = self.corners[0].normal;
                    Vec3::new(x, y, z)
                }
            };
            let about_eye = space.about_eye(in_view);
            (DVec3::from_array(in_view), corner(mesh, space, attribute, about_eye, normal))
        };
        polygons.outline(mesh, of.triangle).into_iter().map(corner_of).collect()
    }

    /// Whether the normals of the mesh were turned, as the triangle is seen from behind.
    fn is_turned(&self, mesh: &Mesh, space: &InstanceSpace) -> bool {
        let attribute = mesh.attribute_corners()[self.of.triangle as usize][0] as usize;
        let Some(&[x, y, z]) = mesh.normals.get(attribute) else { return false };
        let [seen_x, seen_y, seen_z] = self.corners[0].normal;
        space.unit_normal(Vec3::new(x, y, z)).dot(Vec3::new(seen_x, seen_y, seen_z)) < 0.0
    }

    /// The polygon as one place: its centroid, with its own normal and the mean of its corners' attributes.
    pub(super) fn whole(&self, scene: &ShadingContext<'_>) -> Corner {
        let around = match scene.polygons[self.of.instance] {
            Some(_) => self.around(scene, true),
            None => Vec::new(),
        };
        let around: Vec<Corner> = around.into_iter().map(|(_, corner)| corner).collect();
        let [position, normal] = WholePlaces::of(scene, self.of.instance).place(self.of.triangle);
        Corner {
            position,
            normal,
            ..Corner::mean(&around)
                .or_else(|| Corner::mean(&self.corners))
                .unwrap_or(self.corners[0])
        }
    }

    /// The light at a place, where it comes neither from pixels nor from the corners. That of pieces
    /// is the light under a texel, which `texel` samples.
    pub(crate) fn own_light(
        &self,
        barycentric: [f32; 3],
        texel: impl FnOnce() -> [f32; 3],
    ) -> Option<[f32; 3]> {
        match &self.own_light {
            OwnLight::None => None,
            OwnLight::Whole(whole) => Some(whole.light),
            OwnLight::Pieces(pieces) => Some(pieces.light(barycentric, texel())),
        }
    }

    /// Where the light at a place of the triangle was computed.
    pub(crate) fn lit_at(&self, barycentric: [f32; 3], position: [f64; 2]) -> Vec<LitPlace> {
        let numbered = |places: &[Corner], weights: &[f32]| -> Vec<LitPlace> {
            let places = (0..).zip(places).zip(weights);
            places
                .map(|((number, corner), weight)| LitPlace {
                    weight: *weight,
                    number,
                    corner: *corner,
                })
                .collect()
        };
        match (&self.own_light, &self.outline) {
            (OwnLight::Whole(whole), _) => numbered(&[**whole], &[1.0]),
            (OwnLight::Pieces(pieces), _) => {
                let (places, weights) = pieces.piece(barycentric);
                let places = places.into_iter().zip(weights);
                let lit = |((number, place), weight)| {
                    let corner = Corner::weighted(&self.corners, place);
                    LitPlace { weight, number, corner }
                };
                places.map(lit).collect()
            }
            (OwnLight::None, None) => numbered(&self.corners, &barycentric),
            (OwnLight::None, Some(outline)) => {
                let weights = outline.corner_weights(position);
                let mut places = numbered(&outline.corners, &weights);
                places.retain(|place| place.weight > 0.0);
                places
            }
        }
    }

    /// The terms of places: under a texel, where pieces are lit for every texel.
    pub(crate) fn terms(
        &mut self,
        scene: &ShadingContext<'_>,
        places: &[LitPlace],
        texel: [f32; 3],
    ) -> impl Iterator<Item = &PlaceTerms> {
        let is_textured = scene.lit_at(self.material as usize) == LitAt::PiecesUnderTexels;
        if is_textured || self.terms.len() > MOST_TERMS {
            self.terms.clear();
        }
        for LitPlace { number, corner, .. } in places {
            if self.terms.iter().all(|(known, _)| known != number) {
                let of = (self.has, self.material);
                let texel = is_textured.then_some(texel);
                self.terms.push((*number, PlaceTerms::of(scene, corner, of, texel)));
            }
        }
        let known = |place: &LitPlace| {
            let known = self.terms.iter().find(|(number, _)| *number == place.number);
            known.map(|(_, terms)| terms)
        };
        places.iter().filter_map(known)
    }

    /// The attributes at a position in pixels, interpolated in the window. The place stays where it is:
    /// only what lies upon it slides.
    pub(crate) fn in_window(&self, position: [f64; 2], barycentric: [f32; 3]) -> Attributes<f32> {
        let found = self.outline.as_ref().and_then(|outline| outline.at(position));
        let (corners, weights) = match found {
            Some(InWindow { corners, weights }) => (corners, weights),
            None => (self.corners, [barycentric; 3]),
        };
        let [here, right, below] = weights.map(|weights| Corner::weighted(&corners, weights));
        let [x, y, z] = interpolate_corners(&self.corners.map(|at| at.position), &barycentric);
        Attributes {
            position: Vec3::new(x, y, z),
            uv: [0, 1].map(|set| {
                let step = |to: &Corner| {
                    [to.uv[set][0] - here.uv[set][0], to.uv[set][1] - here.uv[set][1]]
                };
                [here.uv[set], step(&right), step(&below)]
            }),
            ..Attributes::at(&here, self.has)
        }
    }
}

/// A corner of a mesh in its place about the eye, not lit.
fn corner(
    mesh: &Mesh,
    space: &InstanceSpace,
    attribute: usize,
    about_eye: Vec3<f32>,
    normal: Vec3<f32>,
) -> Corner {
    let uv = |set: usize| mesh.uvs[set].get(attribute).copied().unwrap_or_default();
    Corner {
        position: about_eye.lane(0),
        normal: normal.lane(0),
        tangent: space.tangent(mesh, attribute),
        uv: [uv(0), uv(1)],
        color: mesh.colors.get(attribute).copied().unwrap_or([1.0; 4]),
        light: [0.0; 3],
    }
}
