//! Surface attributes of a hit, on the unsnapped triangle, by the formulas of shading.

use crate::coverage_query::{CoveringTriangle, part_of};
use crate::view::PickView;
use crate::window::PhysicalPosition;
use glam::DVec3;
use luxel_math::{SUBPIXELS, SubPixel, Vec3};
use luxel_scene::{MaterialId, Mesh, TextureUse, mapped_normal};
use luxel_visibility::{
    Forms, InstanceSpace, TileForms, interpolate, interpolate_corners, interpolate_corners_step,
    sides, tile_of,
};

/// A surface at a window position.
#[derive(Clone, Debug, PartialEq)]
pub struct PickHit {
    /// The object, by its index in [`Picker::objects`](crate::Picker::objects).
    pub object: usize,
    /// The triangle, point or line.
    pub element: Element,
    /// Its material.
    pub material: MaterialId,
    /// Barycentric coordinates; (1, 0, 0) for points and lines.
    pub barycentric: [f32; 3],
    /// The position in world space.
    pub position: DVec3,
    /// The unit shading normal in world space, facing the eye.
    pub normal: [f32; 3],
    /// The unit normal of the triangle's plane in world space, facing the eye.
    pub geometric_normal: [f32; 3],
    /// Texture coordinates of the first set, if the mesh has any.
    pub uv: Option<[f32; 2]>,
    /// The interpolated vertex colour, linear, with alpha, if the mesh has any.
    pub color: Option<[f32; 4]>,
    /// The distance from the eye.
    pub distance: f64,
    /// The distance along the viewing axis.
    pub z: f32,
    /// Window depth, 0 near to 1 far, as `glDepthRange(0, 1)` gives it.
    pub depth: f64,
}

/// An element of an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// A triangle, by its index in the mesh.
    Triangle(u32),
    /// A point, by its index among all points of the mesh.
    Point(u32),
    /// A line segment, by its index among all segments of the mesh.
    Line(u32),
}

impl PickView<'_> {
    /// The visible surface at a window position, in pixels from the upper left, rounded to 1/256 pixel;
    /// `None` outside the window and on the background. Pixel n's centre is n + 0.5.
    ///
    /// ```
    /// use luxel_pick::{PickView, Picker};
    /// use luxel_scene::{demos, fit_view, Lens, Size, Viewpoint};
    /// use luxel_visibility::Cull;
    /// use std::sync::Arc;
    ///
    /// let scene = Arc::new(demos::demo("teapot").unwrap());
    /// let picker = Picker::new(Arc::clone(&scene))?;
    /// let size = Size { width: 640, height: 480 };
    /// let viewpoint =
    ///     Viewpoint { up: scene.up, azimuth_radians: 0.5, elevation_radians: 0.3 };
    /// let camera = fit_view(&scene, &viewpoint, Lens::Perspective { fov_y_radians: 0.8 }, size);
    /// let view = PickView::new(&picker, camera, size, Cull::Auto)?;
    /// let hit = view.at([320.5, 240.5]).unwrap();
    /// println!("{:?} of object {} at {}", hit.element, hit.object, hit.position);
    /// # Ok::<(), luxel_pick::PickError>(())
    /// ```
    #[must_use]
    pub fn at(&self, position: impl Into<PhysicalPosition>) -> Option<PickHit> {
        let position = self.steps(position.into())?;
        Some(self.surface_hit(&self.owner(position)?, position))
    }

    /// All surfaces at a window position, nearest first.
    ///
    /// The first is the one that a frame shows, by depths rounded to f32; the others are sorted by exact
    /// depths, those of one plane in the order of the scene.
    #[must_use]
    pub fn through(&self, position: impl Into<PhysicalPosition>) -> Vec<PickHit> {
        let Some(position) = self.steps(position.into()) else { return Vec::new() };
        let all = self.covering_triangles(position);
        let hit = |covering| {
            let hit = self.surface_hit(covering, position);
            (hit.depth + self.behind_plane(covering, position), hit)
        };
        let mut hits: Vec<(f64, PickHit)> = all.iter().map(hit).collect();
        if let Some((_, behind)) = hits.split_first_mut() {
            behind.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        hits.into_iter().map(|(_, hit)| hit).collect()
    }

    /// The visible object and element at a window position, without attributes.
    #[must_use]
    pub fn owner_at(&self, position: impl Into<PhysicalPosition>) -> Option<(usize, Element)> {
        let covering = self.owner(self.steps(position.into())?)?;
        Some(self.element_of(covering.instance, covering.triangle))
    }

    /// A window position in steps of 1/256 pixel.
    pub(crate) fn steps(&self, PhysicalPosition { x, y }: PhysicalPosition) -> Option<[i32; 2]> {
        let inside = |at: f64, side: u32| at >= 0.0 && at < f64::from(side);
        if !inside(x, self.size().width) || !inside(y, self.size().height) {
            return None;
        }
        let steps = |at: f64, side: u32| SubPixel::round(at).0.min(side as i32 * SUBPIXELS - 1);
        Some([steps(x, self.size().width), steps(y, self.size().height)])
    }

    /// The object and the element that a triangle of an instance belongs to.
    pub(crate) fn element_of(&self, number: usize, triangle: u32) -> (usize, Element) {
        let (object, in_object) = self.placed.object_of(number, triangle);
        if let Some(triangle) = in_object {
            return (object, Element::Triangle(triangle));
        }
        let element = self.element(number, triangle);
        let points = &self.picker.mesh(object).points;
        let points = points.iter().map(|points| points.indices.len()).sum::<usize>() as u32;
        let element = if element < points {
            Element::Point(element)
        } else {
            Element::Line(element - points)
        };
        (object, element)
    }

    pub(crate) fn forms(&self, covering: &CoveringTriangle) -> Forms {
        let space = self.placed.space(covering.instance);
        Forms::new(&self.rays, space.view_from_local.corners(covering.corners))
    }

    /// The attributes of a triangle at a sample that it covers.
    pub(crate) fn surface_hit(&self, covering: &CoveringTriangle, position: [i32; 2]) -> PickHit {
        self.surface_of(covering, tile_of(position)).hit(position)
    }

    /// What the samples of a triangle in a tile share.
    #[inline]
    pub(crate) fn surface_of(
        &self,
        covering: &CoveringTriangle,
        tile: [i32; 2],
    ) -> TriangleSurface<'_> {
        let &CoveringTriangle { instance, triangle, .. } = covering;
        let space = self.placed.space(instance);
        let geometry = self.geometry(instance);
        let mesh = geometry.mesh;
        let attributes = mesh.attribute_corners()[triangle as usize].map(|at| at as usize);
        let in_mesh = InstanceSpace::normals_in_mesh(mesh, attributes);
        let forms = self.forms(covering);
        let in_view = forms.corners();
        let corners = in_view.map(|corner| corner.to_array());
        let [second, third] = sides(&corners);
        let first = space.about_eye(corners[0]);
        let normals = space.facing_normals([second, third], forms.towards_eye(), in_mesh);
        let [a, b, c] = in_view.map(|corner| space.view().world_from_view * corner);
        let plane = (b - a).cross(c - a).normalize_or_zero();
        let to_eye = if space.view().parallel { space.view().world_from_view.z_axis } else { -a };
        let plane = if plane.dot(to_eye) < 0.0 { -plane } else { plane };
        let (object, element) = self.element_of(instance, triangle);
        TriangleSurface {
            view: self,
            mesh,
            space,
            attributes,
            in_tile: forms.in_tile(&self.rays, tile),
            forms,
            first,
            sides: [space.along_world(second), space.along_world(third)],
            normals: normals.map(|normal| normal.lane(0)),
            plane: plane.as_vec3().to_array(),
            material: mesh.parts[part_of(&geometry, triangle)].material,
            object,
            element,
        }
    }
}

/// A triangle of an instance before the camera, for its samples in one tile.
pub(crate) struct TriangleSurface<'v> {
    view: &'v PickView<'v>,
    mesh: &'v Mesh,
    space: &'v InstanceSpace,
    attributes: [usize; 3],
    forms: Forms,
    in_tile: TileForms<f32>,
    /// The first corner about the eye, and the ways to the others, along the world's axes.
    first: Vec3<f32>,
    sides: [Vec3<f32>; 2],
    /// Of the corners, facing the eye.
    normals: [[f32; 3]; 3],
    plane: [f32; 3],
    material: MaterialId,
    object: usize,
    element: Element,
}

impl TriangleSurface<'_> {
    /// The attributes at a sample that the triangle covers.
    #[inline]
    pub(crate) fn hit(&self, position: [i32; 2]) -> PickHit {
        let &Self { view, mesh, attributes, first, sides: [second, third], .. } = self;
        let weights = self.forms.barycentric_within(&self.in_tile, &view.rays, position);
        let about_eye = Vec3::new(
            interpolate(first.x, [second.x, third.x], &weights),
            interpolate(first.y, [second.y, third.y], &weights),
            interpolate(first.z, [second.z, third.z], &weights),
        );
        let along = view.camera().direction().as_vec3().to_array();
        let z = Vec3::new(about_eye.x, about_eye.y, about_eye.z)
            .dot(Vec3::new(along[0], along[1], along[2]));
        let [nx, ny, nz] = interpolate_corners(&self.normals, &weights);
        let at = position.map(|steps| steps as f32 / SUBPIXELS as f32);
        let (normal, _) = view.view_rays.unit_vectors(at, Vec3::new(nx, ny, nz));
        let normal = self.mapped(position, weights, normal);

        let eye = view.camera().eye();
        let position = {
            let Vec3 { x, y, z } = about_eye;
            DVec3::new(f64::from(x), f64::from(y), f64::from(z))
        };
        let is_triangle = matches!(self.element, Element::Triangle(_));
        let colors = |at: usize| mesh.colors.get(at).copied().unwrap_or([1.0; 4]);
        PickHit {
            object: self.object,
            element: self.element,
            material: self.material,
            barycentric: if is_triangle { weights } else { [1.0, 0.0, 0.0] },
            position: eye + position,
            normal: [normal.x, normal.y, normal.z],
            geometric_normal: self.plane,
            uv: (!mesh.uvs[0].is_empty())
                .then(|| interpolate_corners(&uvs(mesh, 0, attributes), &weights)),
            color: (!mesh.colors.is_empty())
                .then(|| interpolate_corners(&attributes.map(colors), &weights)),
            distance: position.length(),
            z,
            depth: view.camera().projection.window_depth(f64::from(z)),
        }
    }

    /// Applies the material's normal map.
    fn mapped(&self, position: [i32; 2], weights: [f32; 3], normal: Vec3<f32>) -> Vec3<f32> {
        let &Self { mesh, space, attributes, .. } = self;
        let material = &self.view.picker.scene().materials[self.material.index()];
        let Some(used) = material.normal.as_deref().filter(|_| !mesh.tangents.is_empty()) else {
            return normal;
        };
        let tangents = attributes.map(|at| space.tangent(mesh, at));
        let [x, y, z, sign] = interpolate_corners(&tangents, &weights);
        let [r, g, b, _] = self.texel(used, position, weights);
        mapped_normal(normal, (Vec3::new(x, y, z), sign), [r, g, b], used.strength)
    }

    /// Samples a texture, filtered over the pixel's footprint.
    fn texel(&self, used: &TextureUse, position: [i32; 2], weights: [f32; 3]) -> [f32; 4] {
        let steps = self.forms.steps(&self.view.rays, position);
        let at_corners = uvs(self.mesh, usize::from(used.uv_set & 1), self.attributes);
        let here = used.transformed(interpolate_corners(&at_corners, &weights));
        let [right, down] =
            steps.map(|step| used.transformed_step(interpolate_corners_step(&at_corners, &step)));
        let texture = &self.view.picker.scene().textures[used.texture.index()];
        texture.sample(here, right, down, 1)
    }
}

/// Texture coordinates of the corners; 0 if the mesh has none.
fn uvs(mesh: &Mesh, set: usize, attributes: [usize; 3]) -> [[f32; 2]; 3] {
    attributes.map(|at| mesh.uvs[set].get(at).copied().unwrap_or_default())
}
