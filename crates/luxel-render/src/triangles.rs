//! Triangles that are seen, made ready for shading: looked up and transformed once, not for every
//! block.

use crate::outline::{InWindow, Outline};
use crate::pieces::{self, Asked, Pieces};
use crate::polygons::{self, Polygons};
use crate::shade::Scene16;
use crate::varying::Weights;
use crate::vertex::light_at;
use crate::view::{Interpolation, ShadingMode};
use glam::DVec3;
use luxel_lighting::Silent;
use luxel_math::Vec3;
use luxel_scene::{Mesh, Size};
use luxel_visibility::{Forms, InstanceSpace, TriangleId, TriangleOf};

/// What meshes carry beside positions and normals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Attributes {
    pub(crate) tangents: bool,
    pub(crate) uvs: [bool; 2],
    pub(crate) colors: bool,
}

impl Attributes {
    /// What a mesh carries.
    pub(crate) fn of_mesh(mesh: &Mesh) -> Self {
        Self {
            tangents: !mesh.tangents.is_empty(),
            uvs: [!mesh.uvs[0].is_empty(), !mesh.uvs[1].is_empty()],
            colors: !mesh.colors.is_empty(),
        }
    }

    /// Takes what another carries, too.
    pub(crate) fn join(&mut self, other: Self) {
        self.tangents |= other.tangents;
        self.colors |= other.colors;
        self.uvs[0] |= other.uvs[0];
        self.uvs[1] |= other.uvs[1];
    }
}

/// What interpolation mixes: a corner of a triangle, or any place between corners.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    /// About the eye, along the world's axes.
    pub(crate) position: [f32; 3],
    /// Of unit length, in world space, turned to the side that is seen.
    pub(crate) normal: [f32; 3],
    /// Of unit length, in world space, with the bitangent's sign.
    pub(crate) tangent: [f32; 4],
    pub(crate) uv: [[f32; 2]; 2],
    /// White where the mesh has none.
    pub(crate) color: [f32; 4],
    /// What goes to the eye, where light is computed at corners.
    pub(crate) light: [f32; 3],
}

impl Corner {
    /// The place a part `t` of the way to another.
    pub(crate) fn mixed(&self, other: &Self, t: f32) -> Self {
        self.scaled(1.0 - t).plus(&other.scaled(t))
    }

    /// Everything times a factor.
    pub(crate) fn scaled(&self, factor: f32) -> Self {
        Self {
            position: self.position.map(|value| value * factor),
            normal: self.normal.map(|value| value * factor),
            tangent: self.tangent.map(|value| value * factor),
            uv: self.uv.map(|set| set.map(|value| value * factor)),
            color: self.color.map(|value| value * factor),
            light: self.light.map(|value| value * factor),
        }
    }

    /// The sum of everything.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        fn sum<const N: usize>(a: [f32; N], b: [f32; N]) -> [f32; N] {
            std::array::from_fn(|at| a[at] + b[at])
        }
        Self {
            position: sum(self.position, other.position),
            normal: sum(self.normal, other.normal),
            tangent: sum(self.tangent, other.tangent),
            uv: [sum(self.uv[0], other.uv[0]), sum(self.uv[1], other.uv[1])],
            color: sum(self.color, other.color),
            light: sum(self.light, other.light),
        }
    }
}

/// Where the light of a triangle comes from, if not from its pixels or its corners.
#[derive(Clone)]
enum OwnLight {
    None,
    /// From the polygon's centroid.
    Whole(Box<Corner>),
    /// From the corners of smaller triangles.
    Pieces(Box<Pieces>),
}

/// A triangle with everything that interpolation wants.
#[derive(Clone)]
pub(crate) struct SeenTriangle {
    id: TriangleId,
    pub(crate) of: TriangleOf,
    pub(crate) forms: Forms,
    /// The number of its material.
    pub(crate) material: u32,
    pub(crate) has: Attributes,
    pub(crate) corners: [Corner; 3],
    own_light: OwnLight,
    /// The polygon in the window, where interpolation goes without perspective.
    pub(crate) outline: Option<Box<Outline>>,
}

/// The triangles that a thread has seen last, by the low bits of their ids.
pub(crate) struct SeenTriangles {
    /// None before the first is seen: plain pictures see none.
    entries: Vec<Option<SeenTriangle>>,
}

/// Entries of the cache: 128 KiB, a part of a core's second-level cache.
const ENTRIES: usize = 256;

impl SeenTriangles {
    pub(crate) fn new() -> Self {
        Self { entries: Vec::new() }
    }

    /// The triangle of an id; `None` for [`TriangleId::NONE`].
    pub(crate) fn get(&mut self, scene: &Scene16<'_>, id: TriangleId) -> Option<&SeenTriangle> {
        if self.entries.is_empty() {
            self.entries.resize(ENTRIES, None);
        }
        let entry = &mut self.entries[id.0 as usize % ENTRIES];
        if entry.as_ref().is_none_or(|seen| seen.id != id) {
            let of = scene.frame.triangle(id)?;
            let mut seen = SeenTriangle::new(scene, id, of);
            seen.light_elsewhere(scene);
            *entry = Some(seen);
        }
        entry.as_ref()
    }
}

impl SeenTriangle {
    fn new(scene: &Scene16<'_>, id: TriangleId, of: TriangleOf) -> Self {
        let frame = scene.frame;
        let space = &scene.spaces[of.instance];
        let mesh = frame.instances()[of.instance].mesh;
        let [a, b, c] = mesh.triangles[of.triangle as usize];
        let position = |corner: u32| mesh.positions[corner as usize];
        let positions = [position(a), position(b), position(c)];
        let [a, b, c] = mesh.attribute_corners()[of.triangle as usize];
        let attributes = [a as usize, b as usize, c as usize];
        let corners_in_view = space.view_from_local.corners(positions);
        let forms = Forms::new(frame.rays(), corners_in_view);
        let in_mesh = InstanceSpace::normals_in_mesh(mesh, attributes);
        let normals = space.facing_normals(&corners_in_view, forms.towards_eye(), in_mesh);
        let corner = |place: usize| {
            let about_eye = space.about_eye(corners_in_view[place]);
            corner(mesh, space, attributes[place], about_eye, normals[place])
        };
        Self {
            id,
            of,
            forms,
            material: mesh.parts[of.part].material.0,
            has: Attributes::of_mesh(mesh),
            corners: [corner(0), corner(1), corner(2)],
            own_light: OwnLight::None,
            outline: None,
        }
    }

    /// The corners of a triangle, lit there or, in flat shading, with the light of the whole. Given
    /// places in view space, they are lit there instead.
    pub(crate) fn lit_corners(
        scene: &Scene16<'_>,
        of: TriangleOf,
        places: Option<[DVec3; 3]>,
    ) -> [Corner; 3] {
        let mut seen = Self::new(scene, TriangleId::NONE, of);
        let world_from_view = scene.spaces[of.instance].world_from_view;
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
    fn light_elsewhere(&mut self, scene: &Scene16<'_>) {
        let (has, material) = (self.has, self.material);
        let lit = |corner: &Corner| light_at(scene, corner, has, material, &mut Silent);
        match scene.shading.mode {
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
                let space = &scene.spaces[self.of.instance];
                let corners = &self.corners;
                let Size { width, height } = scene.frame.size();
                let pieces = Pieces::new(Asked {
                    tolerance,
                    size: [f64::from(width), f64::from(height)],
                    encoding: scene.encoding,
                    light: &mut |place| lit(&within(corners, place)),
                    window: &|place| {
                        let about_eye = pieces::mixed(corners.map(|corner| corner.position), place);
                        let about_eye = DVec3::from_array(about_eye.map(f64::from));
                        scene.frame.rays().window(space.world_from_view.transpose() * about_eye)
                    },
                });
                if let Ok(mut counts) = scene.subdivided.lock() {
                    counts.insert(self.id.0, pieces.count);
                }
                self.own_light = OwnLight::Pieces(Box::new(pieces));
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
            let parallel = scene.spaces[self.of.instance].parallel;
            let rays = scene.frame.rays();
            self.outline = Some(Box::new(Outline::new(rays, scene.near, parallel, scan, &around)));
        }
    }

    /// The corners between which interpolation goes in the window, with their places in view space:
    /// the polygon's, or the triangle's.
    fn around(&self, scene: &Scene16<'_>, polygon: bool) -> Vec<(DVec3, Corner)> {
        let Self { of, .. } = *self;
        let instance = &scene.frame.instances()[of.instance];
        let polygons = scene.polygons[of.instance].filter(|_| polygon);
        let Some(polygons) = polygons else {
            return self.forms.corners().into_iter().zip(self.corners).collect();
        };
        let space = &scene.spaces[of.instance];
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

    /// The polygon as one place: its centroid, with its own normal.
    fn whole(&self, scene: &Scene16<'_>) -> Corner {
        let Self { of, .. } = *self;
        let instance = &scene.frame.instances()[of.instance];
        let space = &scene.spaces[of.instance];
        let mesh = instance.mesh;
        let (face, around) = match scene.polygons[of.instance] {
            Some(polygons) => (polygons.face(mesh, of.triangle), self.around(scene, true)),
            None => (Polygons::TRIANGLES.face(mesh, of.triangle), Vec::new()),
        };
        let around: Vec<Corner> = around.into_iter().map(|(_, corner)| corner).collect();
        let in_view = instance.view_from_mesh.transform_point3(face.centroid);
        let place = space.world_from_view * in_view;
        let normal = (space.normal_from_mesh * face.area).normalize_or_zero();
        let to_eye = if space.parallel { space.world_from_view.z_axis } else { -place };
        let normal = if normal.dot(to_eye) < 0.0 { -normal } else { normal };
        Corner {
            position: place.as_vec3().to_array(),
            normal: normal.as_vec3().to_array(),
            ..polygons::mean(&around)
                .or_else(|| polygons::mean(&self.corners))
                .unwrap_or(self.corners[0])
        }
    }

    /// The texture coordinates of the first set at a place.
    pub(crate) fn uv(&self, barycentric: [f32; 3]) -> [f32; 2] {
        within(&self.corners, barycentric).uv[0]
    }

    /// Whether the light comes neither from pixels nor from the corners.
    #[inline]
    pub(crate) fn has_own_light(&self) -> bool {
        !matches!(self.own_light, OwnLight::None)
    }

    /// The light at a place, where it comes neither from pixels nor from the corners.
    pub(crate) fn own_light(&self, barycentric: [f32; 3]) -> [f32; 3] {
        match &self.own_light {
            OwnLight::None => [0.0; 3],
            OwnLight::Whole(whole) => whole.light,
            OwnLight::Pieces(pieces) => pieces.light(barycentric),
        }
    }

    /// Where the light at a place of the triangle was computed, with the weights.
    pub(crate) fn lit_at(&self, barycentric: [f32; 3], position: [f64; 2]) -> Vec<(f32, Corner)> {
        match (&self.own_light, &self.outline) {
            (OwnLight::Whole(whole), _) => vec![(1.0, **whole)],
            (OwnLight::Pieces(pieces), _) => {
                let (places, weights) = pieces.piece(barycentric);
                let corners = places.map(|place| within(&self.corners, place));
                weights.into_iter().zip(corners).collect()
            }
            (OwnLight::None, None) => barycentric.into_iter().zip(self.corners).collect(),
            (OwnLight::None, Some(outline)) => {
                let weights = outline.corner_weights(position).into_iter();
                let corners = outline.corners.iter().copied();
                weights.zip(corners).filter(|(weight, _)| *weight > 0.0).collect()
            }
        }
    }

    /// What interpolation in the window starts from at a position in pixels: corners and weights.
    pub(crate) fn in_window(
        &self,
        position: [f64; 2],
        barycentric: [f32; 3],
    ) -> ([Corner; 3], Weights<f32>) {
        let here = within(&self.corners, barycentric).position;
        let found = self.outline.as_ref().and_then(|outline| outline.at(position));
        let all = Weights { here: barycentric, right: barycentric, below: barycentric };
        let (mut corners, weights) = match found {
            Some(InWindow { corners, weights }) => (corners, weights),
            None => (self.corners, all),
        };
        // The place stays where it is: only what lies upon it slides.
        for corner in &mut corners {
            corner.position = here;
        }
        (corners, weights)
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

/// A place within a triangle, by its barycentrics.
fn within([a, b, c]: &[Corner; 3], [u, v, w]: [f32; 3]) -> Corner {
    a.scaled(u).plus(&b.scaled(v)).plus(&c.scaled(w))
}
