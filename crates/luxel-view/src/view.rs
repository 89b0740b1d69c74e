//! The view of a scene.

use crate::{Cull, EnvironmentChoice, Shading};
use luxel_lighting::{Display, Fog, PictureEncoding, Tone};
use luxel_scene::{Background, Camera, DEFAULT_AMBIENT, DVec3, SceneLight, Size, default_lights};

/// The default number of samples per pixel.
pub const DEFAULT_SAMPLES: u32 = 4;

/// The default number of rays to a light with an extent.
pub const DEFAULT_LIGHT_RAYS: u32 = 16;

/// The default side of points, in pixels.
pub const DEFAULT_POINT_SIZE: f32 = 3.0;

/// Ambient occlusion: ambient light and the environment reach a surface by its openness, the part of the
/// directions above it, weighted by the cosine to the normal, in which nothing is near.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AmbientOcclusion {
    /// How near things count, in the world's units, possibly infinite; `None`: a quarter of the radius of
    /// the scene's bounding sphere.
    pub radius: Option<f64>,
    /// The rays of a sample, at least 1.
    pub rays: u32,
}

impl AmbientOcclusion {
    /// The default number of rays.
    pub const RAYS: u32 = 16;
}

impl Default for AmbientOcclusion {
    fn default() -> Self {
        Self { radius: None, rays: Self::RAYS }
    }
}

/// The view of a scene: camera, lights, shading, output size.
///
/// [`View::new`] takes the required fields; all others are set by field, or by chained methods:
///
/// ```
/// use luxel_scene::{DVec3, Lens, SceneLight, Size, Viewpoint, demos, fit_view};
/// use luxel_view::{Shading, ShadingMode, View};
///
/// let scene = demos::demo("teapot").unwrap();
/// let size = Size { width: 640, height: 360 };
/// let viewpoint = Viewpoint { up: scene.up, azimuth_radians: 0.5, elevation_radians: 0.3 };
/// let camera = fit_view(&scene, &viewpoint, Lens::Perspective { fov_y_radians: 0.8 }, size);
/// let view = View::new(size, camera)
///     .with_lights(vec![SceneLight::directional(DVec3::new(-1.0, -2.0, -3.0), [0.8; 3])])
///     .with_background([1.0; 4])
///     .with_samples(16);
/// assert_eq!(view.lights.len(), 1);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct View {
    /// The picture's size.
    pub size: Size,
    /// The camera.
    pub camera: Camera,
    /// Samples per pixel: 1, 2, 4, 8 or 16.
    pub samples: u32,
    /// The faces to cull.
    pub cull: Cull,
    /// The lights, in the order in which they are added up.
    pub lights: Vec<SceneLight>,
    /// I_a: the scene's ambient light.
    pub ambient: [f32; 3],
    /// The environment: what mirrors and metals reflect and, of a map, what lights matt surfaces.
    pub environment: EnvironmentChoice,
    /// Whether the environment is seen behind everything, instead of the background. Where it is none, the
    /// background stays.
    pub environment_background: bool,
    /// Depth cueing.
    pub fog: Option<Fog>,
    /// What lies behind everything.
    pub background: Background,
    /// Whether a ground lies under the model that shows nothing but its shadow and its occlusion.
    pub ground: bool,
    /// What is up, for the ground and the studio; `None`: as in the scene. Of any length but 0.
    pub up: Option<DVec3>,
    /// The exposure of surfaces, in stops: each doubles their light. The background stays as it is.
    pub exposure: f32,
    /// The tone curve of surfaces, after the exposure.
    pub tone: Tone,
    /// The encoding of pixels.
    pub encoding: PictureEncoding,
    /// Edges of polygons, drawn or nothing but them.
    pub edges: Option<Edges>,
    /// The side of points, in pixels.
    pub point_size: f32,
    /// Shading mode and interpolation.
    pub shading: Shading,
    /// Whether surfaces keep directional, point and spot lights from others.
    pub shadows: bool,
    /// The rays from a sample to a light with an extent, for soft shadows; at least 1.
    pub light_rays: u32,
    /// Ambient occlusion.
    pub ambient_occlusion: Option<AmbientOcclusion>,
}

impl View {
    /// A view with the default lights and ambient light, a studio for microfacet materials,
    /// transparent background, four samples a pixel, sRGB, and light computed at every pixel; without
    /// exposure and tone curve.
    #[must_use]
    pub fn new(size: Size, camera: Camera) -> Self {
        Self {
            size,
            camera,
            samples: DEFAULT_SAMPLES,
            cull: Cull::Auto,
            lights: default_lights(),
            ambient: DEFAULT_AMBIENT,
            environment: EnvironmentChoice::StudioForMicrofacets,
            environment_background: false,
            fog: None,
            background: Background::TRANSPARENT,
            ground: false,
            up: None,
            exposure: 0.0,
            tone: Tone::None,
            encoding: PictureEncoding::Srgb,
            edges: None,
            point_size: DEFAULT_POINT_SIZE,
            shading: Shading::default(),
            shadows: false,
            light_rays: DEFAULT_LIGHT_RAYS,
            ambient_occlusion: None,
        }
    }

    /// The picture's size.
    #[must_use]
    pub fn with_size(self, size: Size) -> Self {
        Self { size, ..self }
    }

    /// The camera.
    #[must_use]
    pub fn with_camera(self, camera: Camera) -> Self {
        Self { camera, ..self }
    }

    /// Samples per pixel: 1, 2, 4, 8 or 16.
    #[must_use]
    pub fn with_samples(self, samples: u32) -> Self {
        Self { samples, ..self }
    }

    /// The faces to cull.
    #[must_use]
    pub fn with_cull(self, cull: Cull) -> Self {
        Self { cull, ..self }
    }

    /// The lights, in the order in which they are added up.
    #[must_use]
    pub fn with_lights(self, lights: Vec<SceneLight>) -> Self {
        Self { lights, ..self }
    }

    /// I_a: the scene's own ambient light, linear red, green, blue.
    #[must_use]
    pub fn with_ambient(self, ambient: [f32; 3]) -> Self {
        Self { ambient, ..self }
    }

    /// The environment that mirrors and metals reflect.
    #[must_use]
    pub fn with_environment(self, environment: EnvironmentChoice) -> Self {
        Self { environment, ..self }
    }

    /// Whether the environment is seen behind everything, instead of the background.
    #[must_use]
    pub fn with_environment_background(self, environment_background: bool) -> Self {
        Self { environment_background, ..self }
    }

    /// Depth cueing.
    #[must_use]
    pub fn with_fog(self, fog: Option<Fog>) -> Self {
        Self { fog, ..self }
    }

    /// What lies behind everything: a [`Background`], or linear red, green, blue, and alpha.
    #[must_use]
    pub fn with_background(self, background: impl Into<Background>) -> Self {
        Self { background: background.into(), ..self }
    }

    /// Whether a ground lies under the model, square to the scene's up direction, that shows nothing but
    /// its shadow and its occlusion over the background. Seen from below it isn't there.
    #[must_use]
    pub fn with_ground(self, ground: bool) -> Self {
        Self { ground, ..self }
    }

    /// What is up, for the ground and the studio.
    #[must_use]
    pub fn with_up(self, up: impl Into<Option<DVec3>>) -> Self {
        Self { up: up.into(), ..self }
    }

    /// The exposure of surfaces, in stops: each doubles their light. The background stays as it is.
    #[must_use]
    pub fn with_exposure(self, exposure: f32) -> Self {
        Self { exposure, ..self }
    }

    /// The tone curve of surfaces, after the exposure.
    #[must_use]
    pub fn with_tone(self, tone: Tone) -> Self {
        Self { tone, ..self }
    }

    /// What happens to the colours of surfaces on their way to the picture.
    #[must_use]
    pub fn display(&self) -> Display {
        Display::new(self.exposure, self.tone)
    }

    /// The encoding of pixels.
    #[must_use]
    pub fn with_encoding(self, encoding: PictureEncoding) -> Self {
        Self { encoding, ..self }
    }

    /// Edges of polygons, drawn or nothing but them.
    #[must_use]
    pub fn with_edges(self, edges: Option<Edges>) -> Self {
        Self { edges, ..self }
    }

    /// The side of points, in pixels, above 0.
    #[must_use]
    pub fn with_point_size(self, point_size: f32) -> Self {
        Self { point_size, ..self }
    }

    /// Shading mode and interpolation.
    #[must_use]
    pub fn with_shading(self, shading: Shading) -> Self {
        Self { shading, ..self }
    }

    /// Whether surfaces keep directional, point and spot lights from others.
    #[must_use]
    pub fn with_shadows(self, shadows: bool) -> Self {
        Self { shadows, ..self }
    }

    /// The rays from a sample to a light with an extent, for soft shadows; 0 counts as 1.
    #[must_use]
    pub fn with_light_rays(self, light_rays: u32) -> Self {
        Self { light_rays: light_rays.max(1), ..self }
    }

    /// Ambient occlusion.
    #[must_use]
    pub fn with_ambient_occlusion(self, ambient_occlusion: Option<AmbientOcclusion>) -> Self {
        Self { ambient_occlusion, ..self }
    }
}

/// How edges of polygons are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Edges {
    /// Only edges, with holes between them; else edges over the faces.
    pub wireframe: bool,
    /// Width in pixels.
    pub width: f32,
    /// Linear colour of edges over faces; wires are lit like their face.
    pub color: [f32; 3],
}

impl Edges {
    /// Wires a pixel and a half wide, lit like the faces.
    pub const WIREFRAME: Self = Self { wireframe: true, width: 1.5, color: [0.0; 3] };
    /// Thin dark lines over the faces.
    pub const OVER_FACES: Self = Self { wireframe: false, width: 1.0, color: [0.01; 3] };
}
