//! Read-only state of a frame that every stage of shading shares.

use crate::backdrop::Backdrop;
use crate::coverage::EdgeFlags;
use crate::polygons::Polygons;
use crate::shadow::Shadows;
use crate::subdivision::SubdividedTriangles;
use luxel_lighting::{
    Coefficients, Display, Fog, LightingEnvironment, PictureEncoding, PlacedLight, Reflection,
    SurfacePoint, Uniform,
};
use luxel_math::{Lanes, Level, Vec3};
use luxel_scene::{Mesh, Scene, SceneMaterial};
use luxel_view::{Edges, NormalLength, Shading, ShadingMode};
use luxel_visibility::{Frame, InstanceSpace, PlacedScene, ViewRays};

/// Where the light of a material's surfaces is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LitAt {
    Pixels,
    /// At centroids, or at corners of triangles or pieces; the texture of the base colour multiplies it.
    Elsewhere,
    /// At the corners of pieces, for every texel of the base colour: the texture colours what it colours
    /// at a pixel, not the highlight.
    PiecesUnderTexels,
}

/// Read-only state shared by all shading of a frame.
pub(crate) struct ShadingContext<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) frame: &'a Frame<'a>,
    /// The instances, before the camera.
    pub(crate) placed: &'a PlacedScene<'a>,
    pub(crate) lights: &'a [PlacedLight],
    pub(crate) ambient: [f32; 3],
    /// What shines on microfacet materials, and on all others, and the fog.
    pub(crate) lighting: [LightingEnvironment<'a>; 2],
    pub(crate) fog: Option<&'a Fog>,
    /// What keeps lights away, if the view asks for shadows.
    pub(crate) shadows: Option<&'a Shadows<'a>>,
    /// What each material reflects, where that is the same at all its points.
    pub(crate) uniform: &'a [Option<Coefficients<Uniform>>],
    /// The vertex attributes that each material reads.
    pub(crate) attributes_of_materials: &'a [AttributeMask],
    /// Whether a light has a place, or fog a distance: then surfaces need positions.
    pub(crate) needs_positions: bool,
    /// Whether every batch is lit at corners or pixels, of one material without textures and vertex
    /// colours.
    pub(crate) is_plain: bool,
    /// Whether plain batches need no more than normals.
    pub(crate) needs_normals_alone: bool,
    /// Whether all batches are of flat shading and need no more than the light of each polygon.
    pub(crate) needs_flat_light_alone: bool,
    /// Whether any surface has textures or vertex colours that its material reads.
    pub(crate) has_extras: bool,
    /// V over the window.
    pub(crate) view_rays: ViewRays,
    /// The viewing direction in world space.
    pub(crate) direction: [f32; 3],
    /// The colour and alpha behind everything, if that is the same everywhere.
    pub(crate) background: [f32; 4],
    /// What lies behind everything, if it isn't.
    pub(crate) backdrop: Option<&'a Backdrop<'a>>,
    /// Edges over the faces, with the polygons' edges of each instance.
    pub(crate) edges: Option<Edges>,
    pub(crate) edge_flags: &'a [Option<&'a EdgeFlags>],
    /// Where light is computed, and how it gets to the pixels between.
    pub(crate) shading: Shading,
    /// Exposure and tone curve, if they change anything.
    pub(crate) display: Option<Display>,
    /// What intensities are clamped to before they are interpolated: what the exposure makes white.
    pub(crate) white: f32,
    pub(crate) encoding: PictureEncoding,
    /// The distance of the near plane.
    pub(crate) near: f64,
    /// The polygons of each instance's mesh, where shading takes them whole.
    pub(crate) polygons: &'a [Option<&'a Polygons>],
    pub(crate) subdivided: &'a SubdividedTriangles,
    /// Whose kernels light places that aren't samples.
    pub(crate) level: Level,
}

impl ShadingContext<'_> {
    /// What shines on a material.
    #[inline(always)]
    pub(crate) fn lighting(&self, material: usize) -> &LightingEnvironment<'_> {
        let reflection = &self.scene.materials[material].constants.reflection;
        &self.lighting[usize::from(!matches!(reflection, Reflection::Microfacet))]
    }

    /// Where the light of a material's surfaces is computed.
    ///
    /// Subdivision leaves surfaces to their pixels whose light other textures shape: they differ from
    /// pixel to pixel, so that no piece would be larger than one.
    pub(crate) fn lit_at(&self, material: usize) -> LitAt {
        let SceneMaterial { base_color, ambient, specular, emission, .. } =
            &self.scene.materials[material];
        let SceneMaterial { metallic_roughness, occlusion, normal, .. } =
            &self.scene.materials[material];
        let others = [ambient, specular, emission, metallic_roughness, occlusion, normal];
        match self.shading.mode {
            ShadingMode::Phong => LitAt::Pixels,
            ShadingMode::Flat | ShadingMode::Gouraud => LitAt::Elsewhere,
            ShadingMode::Subdivided { .. } if others.into_iter().any(Option::is_some) => {
                LitAt::Pixels
            }
            ShadingMode::Subdivided { .. } if base_color.is_some() => LitAt::PiecesUnderTexels,
            ShadingMode::Subdivided { .. } => LitAt::Elsewhere,
        }
    }

    /// The spaces of an instance's positions and normals.
    #[inline(always)]
    pub(crate) fn space(&self, instance: usize) -> &InstanceSpace {
        self.placed.space(instance)
    }

    /// The surface point of a sample at (x, y) in the window, in pixels: N and V at unit length.
    ///
    /// V comes from the sample's ray, not from the place: it is right to the last digits however far
    /// the surface is, and surfaces without lights that have a place need no position at all.
    #[inline(always)]
    pub(crate) fn point_at_sample<N: Lanes>(
        &self,
        [x, y]: [N; 2],
        position: Vec3<N>,
        normal: Vec3<N>,
    ) -> SurfacePoint<N> {
        let (unit, view) = self.view_rays.unit_vectors([x, y], normal);
        self.point(position, normal, unit, view)
    }

    /// The surface point of a vertex, which is seen along the way from the eye to its position.
    #[inline(always)]
    pub(crate) fn point_at_vertex<N: Lanes>(
        &self,
        position: Vec3<N>,
        normal: Vec3<N>,
    ) -> SurfacePoint<N> {
        let view = match self.view_rays.parallel() {
            Some(towards_eye) => Vec3::splat(position.x, towards_eye),
            None => (-position).normalized_or_zero(),
        };
        self.point(position, normal, normal.normalized_or_zero(), view)
    }

    #[inline(always)]
    fn point<N: Lanes>(
        &self,
        position: Vec3<N>,
        normal: Vec3<N>,
        unit: Vec3<N>,
        view: Vec3<N>,
    ) -> SurfacePoint<N> {
        let normal = match self.shading.normal_length {
            NormalLength::Unit => unit,
            NormalLength::Interpolated => normal,
        };
        SurfacePoint { position, normal, view, depth: self.depth(position) }
    }

    /// The surface point of a sample whose light was computed elsewhere: its place, and neither N nor V.
    #[inline(always)]
    pub(crate) fn point_lit_elsewhere<N: Lanes>(&self, position: Vec3<N>) -> SurfacePoint<N> {
        let nothing = Vec3::splat(position.x, [0.0; 3]);
        SurfacePoint { position, normal: nothing, view: nothing, depth: self.depth(position) }
    }

    /// The distance of places from the eye along the viewing axis; 0 where no positions are needed.
    #[inline(always)]
    fn depth<N: Lanes>(&self, position: Vec3<N>) -> N {
        if self.needs_positions {
            position.dot(Vec3::splat(position.x, self.direction))
        } else {
            position.x.zero()
        }
    }
}

/// What a batch may need of its triangles: each an instantiation of the same code.
///
/// All attributes of sixteen samples are 40 vectors, where a processor has 16 registers: what a kernel has
/// no room for, it doesn't spill.
pub(crate) mod needs {
    /// Normals: one material without textures and vertex colours, lit at pixels by lights without a
    /// place.
    pub(crate) const NORMALS: u8 = 0;
    /// Also positions, light of corners, and what keeps light from pixels.
    pub(crate) const PLACES: u8 = 1;
    /// All attributes, of any materials.
    pub(crate) const ALL: u8 = 2;
}

/// What witnesses of a frame hear beside what shading needs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Heard {
    /// Barycentrics, or anything that is interpolated by them, as what follows is.
    pub(crate) surfaces: bool,
    pub(crate) positions: bool,
    pub(crate) attributes: AttributeMask,
}

impl Heard {
    pub(crate) const NOTHING: Self =
        Self { surfaces: false, positions: false, attributes: AttributeMask::NONE };
    /// Positions, and texture coordinates of the first set.
    pub(crate) const EVERYTHING: Self =
        Self { surfaces: true, positions: true, attributes: AttributeMask::UVS[0] };
}

/// Vertex attributes beside positions and normals, as bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct AttributeMask(u8);

impl AttributeMask {
    pub(crate) const NONE: Self = Self(0);
    pub(crate) const TANGENTS: Self = Self(1);
    pub(crate) const COLORS: Self = Self(2);
    /// The two sets of texture coordinates.
    pub(crate) const UVS: [Self; 2] = [Self(4), Self(8)];
    /// Textures: where a material has some, even if the mesh says nothing of where on them it lies.
    pub(crate) const TEXTURES: Self = Self(16);

    /// What a mesh has.
    pub(crate) fn of_mesh(mesh: &Mesh) -> Self {
        Self::TEXTURES
            .or_if(!mesh.tangents.is_empty(), Self::TANGENTS)
            .or_if(!mesh.uvs[0].is_empty(), Self::UVS[0])
            .or_if(!mesh.uvs[1].is_empty(), Self::UVS[1])
            .or_if(!mesh.colors.is_empty(), Self::COLORS)
    }

    /// What a material reads.
    pub(crate) fn of_material(material: &SceneMaterial) -> Self {
        let SceneMaterial { base_color, ambient, specular, emission, .. } = material;
        let SceneMaterial { metallic_roughness, occlusion, normal, opacity_map, .. } = material;
        let textures = [base_color, ambient, specular, emission, metallic_roughness, occlusion];
        let textures = textures.into_iter().chain([normal, opacity_map]).flatten();
        textures
            .fold(Self::NONE, |mask, used| {
                mask.or(Self::TEXTURES).or(Self::UVS[usize::from(used.uv_set & 1)])
            })
            .or_if(normal.is_some(), Self::TANGENTS)
            .or_if(material.vertex_colors, Self::COLORS)
    }

    /// What both have.
    #[inline(always)]
    pub(crate) fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// What either has.
    #[inline(always)]
    pub(crate) fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    fn or_if(self, condition: bool, other: Self) -> Self {
        if condition { self.or(other) } else { self }
    }

    /// Whether any attribute of `other` is among these.
    #[inline(always)]
    pub(crate) fn has(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// Whether there is any.
    #[inline(always)]
    pub(crate) fn any(self) -> bool {
        self.0 != 0
    }
}
