//! One picture of a scene, and the command line that draws the same.

use crate::GalleryError;
use crate::picture::Picture;
use luxel::formats::values::reflection_text;
use luxel::lighting::{Light, LightKind, Reflection, SHININESS};
use luxel::rays::{SceneRays, WorldRay};
use luxel::render::{
    Execution, ExplainedLight, Explanation, Interpolation, NormalLength, Renderer, Shading,
    ShadingMode, View,
};
use luxel::scene::{
    Camera, DVec3, Lens, NormalOptions, NormalSource, Placement, Projection, Restyle, Scene,
    SceneLight, Size, demos, fit_planes,
};
use luxel::view::{AmbientOcclusion, DEFAULT_LIGHT_RAYS};
use std::fmt::Write;
use std::sync::Arc;

/// The program that draws.
pub(crate) struct Studio {
    pub(crate) execution: Execution,
}

/// The size of most pictures.
pub(crate) const SIZE: Size = Size { width: 640, height: 480 };

/// The image settings of a command line.
#[derive(Clone, Debug)]
pub(crate) struct Shot {
    /// The name of the built-in scene.
    pub(crate) demo: &'static str,
    pub(crate) size: Size,
    pub(crate) samples: u32,
    pub(crate) shading: Shading,
    pub(crate) normals: NormalSource,
    /// Instead of the scene's camera: one on the z axis, with this direction upwards.
    pub(crate) rolled: Option<Rolled>,
    /// The scene's material changed.
    pub(crate) reflection: Option<Reflection>,
    pub(crate) color: Option<[f32; 3]>,
    pub(crate) shininess: Option<f32>,
    /// Instead of the scene's lights: one from far away, that travels this way.
    pub(crate) sun: Option<[f64; 3]>,
    /// The angle under which that one is seen, in degrees.
    pub(crate) angle: Option<f64>,
    pub(crate) shadows: bool,
    pub(crate) openness: bool,
    /// The rays of a sample to a sun that is seen under an angle, and those of openness.
    pub(crate) light_rays: u32,
    pub(crate) rays: u32,
}

/// A camera before the origin, at (0, 0, 7), rolled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rolled {
    /// The direction upwards, x and y.
    pub(crate) up: [f64; 2],
    /// The angle of view in degrees.
    pub(crate) fov: f64,
}

/// The position of a rolled camera.
const ROLLED_EYE: f64 = 7.0;

impl Shot {
    /// A built-in scene as it is.
    pub(crate) fn of(demo: &'static str) -> Self {
        Self {
            demo,
            size: SIZE,
            samples: 16,
            shading: Shading::default(),
            normals: NormalSource::File,
            rolled: None,
            reflection: None,
            color: None,
            shininess: None,
            sun: None,
            angle: None,
            shadows: false,
            openness: false,
            light_rays: DEFAULT_LIGHT_RAYS,
            rays: AmbientOcclusion::RAYS,
        }
    }

    pub(crate) fn mode(mut self, mode: ShadingMode) -> Self {
        self.shading.mode = mode;
        self
    }

    pub(crate) fn interpolation(mut self, interpolation: Interpolation) -> Self {
        self.shading.interpolation = interpolation;
        self
    }

    pub(crate) fn normal_length(mut self, normal_length: NormalLength) -> Self {
        self.shading.normal_length = normal_length;
        self
    }

    pub(crate) fn size(mut self, width: u32, height: u32) -> Self {
        self.size = Size { width, height };
        self
    }

    /// With shadows and openness.
    pub(crate) fn occluded(self) -> Self {
        Self { shadows: true, openness: true, ..self }
    }

    pub(crate) fn up(mut self, up: [f64; 2]) -> Self {
        self.rolled = Some(Rolled { up, fov: 25.0 });
        self
    }

    /// The scene as it is, with this command's changes.
    pub(crate) fn scene(&self) -> Scene {
        let mut scene = demos::demo(self.demo).unwrap_or_default();
        self.restyle(&mut scene);
        scene
    }

    /// Changes a scene by the command line.
    pub(crate) fn restyle(&self, scene: &mut Scene) {
        let Self { color, shininess, reflection, .. } = self.clone();
        let mut restyle = Restyle { color, reflection, ..Restyle::default() };
        if let Some(shininess) = shininess {
            restyle.set_parameter(&SHININESS, shininess);
        }
        for material in &mut scene.materials {
            restyle.apply(material);
        }
        let options = NormalOptions { source: self.normals, ..NormalOptions::default() };
        scene.compute_normals(&options);
        scene.compute_tangents();
    }

    /// The view of a scene by the command line.
    pub(crate) fn view(&self, scene: &Scene) -> View {
        let camera = if let Some(Rolled { up: [x, y], fov }) = self.rolled {
            let eye = DVec3::Z * ROLLED_EYE;
            let view_from_world = Camera::look_at(eye, DVec3::ZERO, DVec3::new(x, y, 0.0));
            let (near, far) = fit_planes(&scene.bounds(), &view_from_world);
            let lens = Lens::Perspective { fov_y_radians: fov.to_radians() };
            Camera { view_from_world, projection: Projection { lens, near, far } }
        } else {
            luxel::default_camera(scene, self.size)
        };
        let mut view = luxel::default_view_from(scene, camera, self.size);
        view.samples = self.samples;
        view.shading = self.shading;
        if let Some(direction) = self.sun {
            view.lights = vec![SceneLight {
                name: "0".into(),
                light: Light {
                    angle_degrees: self.angle.unwrap_or_default() as f32,
                    ..Light::new(LightKind::Directional, [1.0; 3])
                },
                placement: Placement::World,
                position: DVec3::ZERO,
                direction: DVec3::from_array(direction),
            }];
            view.ambient = [0.0; 3];
        }
        view.shadows = self.shadows;
        view.light_rays = self.light_rays;
        if self.openness {
            view.ambient_occlusion =
                Some(AmbientOcclusion { rays: self.rays, ..AmbientOcclusion::default() });
        }
        view
    }

    /// The words of the command line that draws this into a file.
    pub(crate) fn command(&self, file: &str) -> Vec<String> {
        let samples = self.samples;
        words(&format!("luxel render {} --samples {samples} -o {file}", self.flags()))
    }

    /// The command line that checks the scene with this image's settings.
    pub(crate) fn check_command(&self) -> Vec<String> {
        words(&format!("luxel check {}", self.flags()))
    }

    /// The scene and the flags that all commands take.
    fn flags(&self) -> String {
        let Self { size, shading, .. } = self;
        let mut line = format!("demo:{}", self.demo);
        let mut say = |words: &str| {
            let _ = write!(line, " {words}");
        };
        let by_default = Shading::default();
        if shading.mode != by_default.mode {
            say(&format!("--shading {}", shading.mode.name()));
        }
        if let ShadingMode::Subdivided { tolerance } = shading.mode {
            say(&format!("--tolerance {tolerance}"));
        }
        if shading.interpolation != by_default.interpolation {
            say(&format!("--interpolation {}", shading.interpolation.name()));
        }
        if shading.normal_length != by_default.normal_length {
            say(&format!("--normal-length {}", shading.normal_length.name()));
        }
        if self.normals == NormalSource::Mean {
            say("--normals mean");
        }
        if let Some(reflection) = &self.reflection {
            say(&format!("--reflection {}", reflection_text(reflection)));
        }
        if let Some([r, g, b]) = self.color {
            say(&format!("--color {r},{g},{b}"));
        }
        if let Some(shininess) = self.shininess {
            say(&format!("--shininess {shininess}"));
        }
        if let Some([x, y, z]) = self.sun {
            let angle = self.angle.map_or_else(String::new, |angle| format!(":angle={angle}"));
            say(&format!("--light directional:dir={x},{y},{z}{angle}"));
        }
        if let Some(Rolled { up: [x, y], fov }) = self.rolled {
            say(&format!("--eye 0,0,{ROLLED_EYE} --target 0,0,0 --fov {fov} --up {x},{y},0"));
        }
        if self.shadows {
            say("--shadows");
        }
        if self.light_rays != DEFAULT_LIGHT_RAYS {
            say(&format!("--light-rays {}", self.light_rays));
        }
        if self.openness {
            say("--ao");
        }
        if self.openness && self.rays != AmbientOcclusion::RAYS {
            say(&format!("--ao-rays {}", self.rays));
        }
        say(&format!("--size {}x{}", size.width, size.height));
        line
    }
}

fn words(line: &str) -> Vec<String> {
    line.split(' ').map(str::to_owned).collect()
}

impl Studio {
    /// A scene ready to be drawn from any view.
    pub(crate) fn stage(&self, scene: impl Into<Arc<Scene>>) -> Result<Stage, GalleryError> {
        Ok(Stage { renderer: Renderer::new(scene, &self.execution)? })
    }

    /// Draws a built-in scene.
    pub(crate) fn shoot(&self, shot: &Shot) -> Result<Picture, GalleryError> {
        self.stage(shot.scene())?.shoot(shot)
    }

    /// Renders a scene by a command line.
    pub(crate) fn shoot_scene(&self, shot: &Shot, scene: &Scene) -> Result<Picture, GalleryError> {
        self.stage(scene.clone())?.shoot(shot)
    }

    /// Where a scene covers pixels wholly.
    pub(crate) fn covered(&self, shot: &Shot, scene: &Scene) -> Result<Vec<bool>, GalleryError> {
        self.stage(scene.clone())?.covered(shot)
    }
}

/// A scene ready to be drawn.
pub(crate) struct Stage {
    pub(crate) renderer: Renderer,
}

impl Stage {
    /// Renders the scene by a command line.
    pub(crate) fn shoot(&self, shot: &Shot) -> Result<Picture, GalleryError> {
        let drawn = self.renderer.rgba8(&shot.view(self.renderer.scene()))?;
        let pixels = drawn.pixels.iter().map(|&[r, g, b, _]| [r, g, b]).collect();
        Ok(Picture { size: drawn.size, pixels })
    }

    /// The same with shadows as the triangles cast them: from the terms of each pixel's ledger, and rays that
    /// leave from the triangle itself. For views of one sample that sees an opaque surface or the background,
    /// and lights far away.
    pub(crate) fn shoot_without_terminator(&self, shot: &Shot) -> Result<Picture, GalleryError> {
        let mut view = shot.view(self.renderer.scene());
        view.shadows = false;
        let rays = SceneRays::new(self.renderer.scene().clone())
            .map_err(|error| GalleryError::Rays(error.to_string()))?;
        let Size { width, height } = view.size;
        let all: Vec<[u32; 2]> =
            (0..height).flat_map(|y| (0..width).map(move |x| [x, y])).collect();
        let pixel = |explained: Explanation| -> [u8; 3] {
            let seen = explained.samples.first().and_then(|sample| sample.seen[0].surface());
            let Some(surface) = seen else {
                let [r, g, b, _] = explained.rgba8;
                return [r, g, b];
            };
            let place = surface
                .triangle
                .and_then(|triangle| rays.places(surface.object, triangle))
                .map(|places| places.at(surface.barycentric));
            let is_visible = |light: &&ExplainedLight| {
                let direction = -DVec3::from_array(light.direction.map(f64::from));
                let eye = DVec3::from_array(surface.view.map(f64::from));
                let origin = place.map(|place| place.facing(eye).origin());
                origin.is_none_or(|origin| !rays.any(&WorldRay::new(origin, direction)))
            };
            let visible: Vec<_> = surface.lights.iter().filter(is_visible).collect();
            [0, 1, 2].map(|channel| {
                let of_light = |light: &&ExplainedLight| {
                    let terms = &light.terms;
                    terms.diffuse.lane(0)[channel] + terms.specular.lane(0)[channel]
                };
                let around = surface.scene_ambient[channel] + surface.emission[channel];
                view.encoding.byte(around + visible.iter().map(of_light).sum::<f32>())
            })
        };
        let explained = self.renderer.explain_pixels(&view, &all)?;
        Ok(Picture { size: view.size, pixels: explained.into_iter().map(pixel).collect() })
    }

    /// Where the scene covers pixels wholly.
    pub(crate) fn covered(&self, shot: &Shot) -> Result<Vec<bool>, GalleryError> {
        let mut view = shot.view(self.renderer.scene()).with_background([0.0; 4]);
        // Coverage doesn't depend on light.
        view.lights.clear();
        (view.shadows, view.ambient_occlusion) = (false, None);
        view.shading = Shading::default();
        Ok(self.renderer.rgba8(&view)?.pixels.iter().map(|pixel| pixel[3] == 255).collect())
    }
}

/// A scene prepared like in the program.
pub(crate) fn ready(mut scene: Scene) -> Scene {
    scene.compute_normals(&NormalOptions::default());
    scene.compute_tangents();
    scene
}

/// Where both are true.
pub(crate) fn both(a: &[bool], b: &[bool]) -> Vec<bool> {
    a.iter().zip(b).map(|(a, b)| *a && *b).collect()
}
