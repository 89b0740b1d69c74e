//! The renderer: a scene made ready once, then drawn from any view.

mod occluders;
mod prepared;

use super::error::{MAX_SIDE, RenderError};
use super::finished_tile::{FinishTile, FinishedTile};
use super::frame_needs::FrameNeeds;
use super::frame_setup;
use super::picture::{Picture, Stages};
use super::tile_drawing::TileDrawing;
use super::tile_shading::{Worker, add_layer, tile_pixels};
use super::tiles::{NEVER, unless_stopped};
use super::workers::{BusyWorker, Workers};
use crate::backdrop::{Around, Backdrop, Ground};
use crate::context::{AttributeMask, ShadingContext};
use crate::coverage::{AlphaTest, EdgeFlags};
use crate::execution::Execution;
use crate::polygons::Polygons;
use crate::resolve::{Bytes, Linear};
use crate::shade::is_studied;
use crate::subdivision::SubdividedTriangles;
use luxel_lighting::{Environment, LightKind, LightingEnvironment};
use luxel_math::{Level, dispatch_long};
use luxel_parallel::{Memo, ThreadPool};
use luxel_rays::{MeshTrees, SceneRays};
use luxel_scene::{AlphaMode, Bounds, CoplanarRanks, Mesh, Object, Part, Scene, SceneLight, Size};
use luxel_view::{EnvironmentChoice, Interpolation, Shading, ShadingMode, View};
use luxel_visibility::{
    Clusters, Frames, Holes, PlacedInstance, PlacedScene, Region, Samples, Tile, ViewRays,
};
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex};
use std::time::Duration;

pub use prepared::Prepared;

/// Most transparent layers over one another. Deeper ones are left out, so that a file can't keep a
/// machine busy for ever.
const MAX_LAYERS: usize = 1024;

/// A scene ready to be drawn. It shares the scene: a program can keep both.
pub struct Renderer {
    scene: Arc<Scene>,
    objects: Arc<Vec<Object>>,
    /// Those of the objects.
    ranks: Memo<CoplanarRanks>,
    /// The clusters of each mesh.
    clusters: Vec<Clusters>,
    /// The polygons of each mesh, once they are asked for.
    polygons_of_meshes: Vec<Memo<Box<Polygons>>>,
    /// The trees for shadows, once a view needs them.
    rays: Memo<Result<Box<SceneRays>, RenderError>>,
    /// Trees of the same meshes, for when they are needed again.
    kept_trees: Mutex<Option<MeshTrees>>,
    /// The memory that trees may take.
    max_memory: u64,
    /// The bounds of what is drawn, and how low it reaches, once a view needs them.
    bounds: Memo<Bounds>,
    lowest: Memo<f64>,
    level: Level,
    /// `None` where the thread that made it [takes part](luxel_parallel::take_part), or the machine has no threads.
    pool: Option<ThreadPool>,
    clock: fn() -> Duration,
    workers: Workers,
}

impl Renderer {
    /// Makes a scene ready: cuts its meshes into clusters.
    ///
    /// # Errors
    /// [`RenderError`] if the scene isn't [sound](Scene::check), or if the machine can't do what `execution` asks.
    pub fn new(scene: impl Into<Arc<Scene>>, execution: &Execution) -> Result<Self, RenderError> {
        let scene = scene.into();
        let level = execution.simd.resolve()?;
        let pool = luxel_parallel::pool(execution.threads);
        luxel_parallel::install(pool.as_ref(), || scene.check())?;
        let frames = if execution.one_frame { Frames::One } else { Frames::Many };
        let mut renderer = Self {
            objects: scene.objects().into(),
            ranks: Memo::new(),
            clusters: Vec::new(),
            polygons_of_meshes: scene.meshes.iter().map(|_| Memo::new()).collect(),
            rays: Memo::new(),
            kept_trees: Mutex::default(),
            max_memory: execution.max_memory,
            bounds: Memo::new(),
            lowest: Memo::new(),
            level,
            pool,
            clock: execution.clock,
            workers: Workers::default(),
            scene,
        };
        renderer.clusters = renderer.install(|| prepared::clusters(&renderer.scene, frames));
        Ok(renderer)
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// The objects, by whose places layers and instances are numbered.
    #[must_use]
    pub fn objects(&self) -> &[Object] {
        &self.objects
    }

    /// Draws only some of the scene's objects from now on, by their places in [`Scene::objects`]. Their
    /// order stays, and layers number those that are left.
    ///
    /// Objects that share a mesh get meshes of their own first, in a copy of the scene.
    pub fn draw_only(&mut self, is_drawn: impl Fn(usize) -> bool) {
        if self.scene.has_sections() {
            self.separate();
        }
        let objects = self.scene.objects().into_iter().enumerate();
        self.show_objects(
            objects.filter(|(at, _)| is_drawn(*at)).map(|(_, object)| object).collect(),
        );
    }

    /// Draws these objects from now on, instead of the scene's: any of its meshes, in any places. Layers number
    /// them.
    ///
    /// What is ready of the meshes stays, so that moving objects takes no longer than listing them.
    ///
    /// # Panics
    /// When drawing, if the scene lacks a mesh.
    pub fn show_objects(&mut self, objects: Vec<Object>) {
        self.objects = objects.into();
        self.kept_trees = Mutex::new(self.take_trees());
        self.ranks = Memo::new();
        self.bounds = Memo::new();
        self.lowest = Memo::new();
    }

    /// The threads that work.
    #[must_use]
    pub fn threads(&self) -> usize {
        self.install(luxel_parallel::threads)
    }

    /// The instruction set that runs.
    #[must_use]
    pub fn level(&self) -> Level {
        self.level
    }

    /// The time, by the clock of [`Execution`].
    pub(crate) fn now(&self) -> Duration {
        (self.clock)()
    }

    /// A worker for a frame with this many samples.
    pub(crate) fn worker(&self, samples: Samples) -> BusyWorker<'_> {
        self.workers.take(samples)
    }

    /// Whether a material lets light through.
    pub(crate) fn has_blended_materials(&self) -> bool {
        self.scene.materials.iter().any(|material| material.alpha_mode == AlphaMode::Blend)
    }

    /// Draws a view into linear colours with straight alpha, after exposure and tone curve, before
    /// clamping and encoding.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub fn linear(&self, view: &View) -> Result<Picture<[f32; 4]>, RenderError> {
        let mut picture = Picture::default();
        self.draw(view, &Linear, &NEVER, &mut picture)?;
        Ok(picture)
    }

    /// Draws a view into bytes: red, green, blue, alpha.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub fn rgba8(&self, view: &View) -> Result<Picture<[u8; 4]>, RenderError> {
        let mut picture = Picture::default();
        self.rgba8_into(view, &mut picture)?;
        Ok(picture)
    }

    /// As [`Renderer::rgba8`], in the memory of an earlier picture.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible; the picture is then as before.
    pub fn rgba8_into(
        &self,
        view: &View,
        picture: &mut Picture<[u8; 4]>,
    ) -> Result<(), RenderError> {
        self.rgba8_until(&NEVER, view, picture)
    }

    /// [`Renderer::rgba8_into`], which stops early once `stop` is set.
    pub(crate) fn rgba8_until(
        &self,
        stop: &AtomicBool,
        view: &View,
        picture: &mut Picture<[u8; 4]>,
    ) -> Result<(), RenderError> {
        let encoding = view.encoding;
        self.draw(view, &Bytes(encoding), stop, picture)
    }

    /// Draws a view, each block turned into what is kept of its pixels while it is in registers.
    fn draw<F: FinishTile>(
        &self,
        view: &View,
        finish: &F,
        stop: &AtomicBool,
        picture: &mut Picture<F::Pixel>,
    ) -> Result<(), RenderError> {
        let begin = self.now();
        self.with_scene(view, &FrameNeeds::PICTURE, |scene, alpha_test| {
            let bin = self.now() - begin;
            let drawing = TileDrawing::new(self, scene, alpha_test);
            drawing.draw(finish, &|_| true, stop, picture);
            picture.stages = Stages { bin, frame: self.now() - begin, ..picture.stages };
        })?;
        unless_stopped(stop)
    }

    /// Draws one tile; the time at which it was known what is seen.
    pub(crate) fn draw_tile(
        &self,
        scene: &ShadingContext<'_>,
        cutouts: &AlphaTest<'_>,
        number: usize,
        worker: &mut Worker,
        pixels: &mut FinishedTile<'_>,
    ) -> Duration {
        let holes = cutouts.finder(scene.frame, self.level());
        scene.frame.draw_opaque(self.level, number, &holes, &mut worker.opaque);
        let layered = self.peel(scene, number, &holes, worker, &mut |_| {});
        let visible = (self.clock)();
        dispatch_long!(self.level, simd => tile_pixels(simd, scene, worker, layered, pixels));
        visible
    }

    /// Gathers the transparent layers of a tile, nearest first; whether there are any.
    ///
    /// `listen` gets each layer as it is found.
    pub(crate) fn peel(
        &self,
        scene: &ShadingContext<'_>,
        number: usize,
        holes: &dyn Holes,
        worker: &mut Worker,
        listen: &mut dyn FnMut(&Tile),
    ) -> bool {
        if !scene.frame.has_blended() {
            return false;
        }
        let Worker { opaque, layers: [here, last], layered, cache, .. } = worker;
        for depth in 0..MAX_LAYERS {
            let behind = (depth > 0).then_some(&*last);
            if !scene.frame.draw_layer(self.level, number, holes, opaque, behind, here) {
                return depth > 0;
            }
            listen(here);
            if depth == 0 {
                layered.clear();
            }
            let deeper = dispatch_long!(self.level, simd => add_layer(simd, scene, here, opaque, layered, cache));
            if !deeper {
                break;
            }
            std::mem::swap(here, last);
        }
        true
    }

    /// Culls, bins and transforms the scene for `view`.
    pub(crate) fn with_scene<R: Send>(
        &self,
        view: &View,
        needs: &FrameNeeds,
        work: impl FnOnce(&ShadingContext<'_>, &AlphaTest<'_>) -> R + Send,
    ) -> Result<R, RenderError> {
        let mut work = Some(work);
        let mut result = None;
        self.prepare_frame(view, needs, &mut |scene, cutouts| {
            result = work.take().map(|work| work(scene, cutouts));
        })?;
        Ok(result.unwrap_or_else(|| unreachable!("the work is done once")))
    }

    /// [`Self::with_scene`], compiled once.
    fn prepare_frame(
        &self,
        view: &View,
        needs: &FrameNeeds,
        work: &mut (dyn FnMut(&ShadingContext<'_>, &AlphaTest<'_>) + Send),
    ) -> Result<(), RenderError> {
        let Size { width, height } = view.size;
        if !(1..=MAX_SIDE).contains(&width) || !(1..=MAX_SIDE).contains(&height) {
            return Err(RenderError::Size(width, height));
        }
        let samples = needs
            .samples
            .or_else(|| Samples::new(view.samples))
            .ok_or(RenderError::Samples(view.samples))?;
        self.install(|| {
            let rules = frame_setup::surface_rules(view, needs.coverage);
            let ranks = self.ranks.get_or_compute(|| CoplanarRanks::of(&self.scene, &self.objects));
            let darkens_surfaces = view.shadows || view.ambient_occlusion.is_some();
            if darkens_surfaces || view.ground {
                // Before the lists of the frame: building trees takes more memory for a while than they do.
                self.rays()?;
            }
            let objects = (&self.objects[..], ranks);
            let part = needs.part.unwrap_or_else(|| Region::whole(view.size));
            let placed = PlacedScene::new(&self.scene, objects, &view.camera, view.size, &rules);
            let frame = placed.frame(&self.clusters, part, samples, self.level)?;
            let lights = frame_setup::placed_lights(view, &self.scene);
            let floor = view.ground.then(|| self.floor(view));
            let of_surfaces = (view.shadows, view.ambient_occlusion);
            let shadows = match darkens_surfaces {
                true => Some(self.shadows(view, &frame, (&placed, &lights), of_surfaces, floor)?),
                false => None,
            };
            let meshes = if view.edges.is_some() { &self.scene.meshes[..] } else { &[] };
            let flags_of_meshes = luxel_parallel::gather(meshes.len(), 1, &|run, flags| {
                flags.extend(meshes[run].iter().map(EdgeFlags::new));
            });
            let flags_of = |instance: &PlacedInstance| {
                let mesh = self.objects[instance.first_object()].mesh;
                flags_of_meshes.get(mesh.index()).filter(|_| instance.strokes.is_none())
            };
            let edge_flags: Vec<Option<&EdgeFlags>> = match view.edges {
                Some(_) => placed.instances().iter().map(flags_of).collect(),
                None => Vec::new(),
            };
            let ambient = frame_setup::ambient(view);
            let fog = view.fog.as_ref();
            let environments = self.environments(view);
            let lighting = environments
                .each_ref()
                .map(|environment| LightingEnvironment::new(&lights, ambient, environment, fog));
            let ground = match floor {
                Some(floor) => {
                    let of_ground = (true, Some(view.ambient_occlusion.unwrap_or_default()));
                    let mut shadows =
                        self.shadows(view, &frame, (&placed, &lights), of_ground, None)?;
                    shadows.share_rays(samples.count());
                    let environment = match &view.environment {
                        EnvironmentChoice::Always(environment) => environment,
                        EnvironmentChoice::StudioForMicrofacets => &Environment::None,
                    };
                    let lighting = LightingEnvironment::new(&lights, ambient, environment, None);
                    let shown = (&view.camera, view.encoding);
                    Some(Ground::new(floor, shadows, (lighting, fog), self.bounds(), shown))
                }
                None => None,
            };
            let around = view.environment_background.then(|| Around {
                environment: view.environment.surroundings(self.up(view)),
                rays: ViewRays::new(&view.camera, frame.rays()),
                display: view.display(),
            });
            let backdrop = Backdrop::new((view.background, around), height, ground);
            let uniform = frame_setup::uniform(&self.scene.materials);
            let attributes_of_materials: Vec<AttributeMask> = self
                .scene
                .materials
                .iter()
                .map(|of| AttributeMask::of_material(of).or(needs.heard.attributes))
                .collect();
            let reads = |mesh: &Mesh, part: &Part| {
                let of_material = attributes_of_materials[part.material.index()];
                AttributeMask::of_mesh(mesh).and(of_material).any()
            };
            let has_extras = |mesh: &Mesh| mesh.parts.iter().any(|part| reads(mesh, part));
            let has_extras = frame.instances().iter().any(|instance| has_extras(instance.mesh));
            let edges = view.edges.filter(|edges| !edges.wireframe);
            let needs_positions = needs.heard.positions
                || view.fog.is_some()
                || lights.iter().any(|light| light.light().kind.has_place());
            let polygons = self.polygons(view, placed.instances());
            let (subdivided, level) = (SubdividedTriangles::default(), self.level);
            let scene = ShadingContext {
                scene: &self.scene,
                frame: &frame,
                placed: &placed,
                lights: &lights,
                ambient,
                lighting,
                fog,
                shadows: shadows.as_ref(),
                uniform: &uniform,
                attributes_of_materials: &attributes_of_materials,
                needs_positions,
                is_plain: self.scene.materials.len() == 1
                    && !has_extras
                    && !is_studied(&view.shading)
                    && edges.is_none(),
                needs_normals_alone: view.shading.mode == ShadingMode::Phong && !needs_positions,
                needs_flat_light_alone: view.shading.mode == ShadingMode::Flat
                    && view.shading.interpolation == Interpolation::Perspective
                    && !has_extras
                    && !needs.heard.surfaces
                    && fog.is_none()
                    && shadows.is_none(),
                has_extras,
                view_rays: ViewRays::new(&view.camera, frame.rays()),
                direction: view.camera.direction().as_vec3().to_array(),
                background: view.background.color(0.0),
                backdrop: backdrop.as_ref(),
                edges,
                edge_flags: &edge_flags,
                shading: view.shading,
                display: frame_setup::display(view),
                white: view.display().white(),
                encoding: view.encoding,
                near: view.camera.projection.near,
                polygons: &polygons,
                subdivided: &subdivided,
                level,
            };
            let cutouts = AlphaTest {
                scene: &self.scene,
                wires: view.edges.filter(|edges| edges.wireframe),
                edge_flags: &edge_flags,
            };
            work(&scene, &cutouts);
            Ok(())
        })
    }

    /// The polygons of each instance's mesh, if shading takes them whole.
    fn polygons(&self, view: &View, instances: &[PlacedInstance]) -> Vec<Option<&Polygons>> {
        let Shading { mode, interpolation, .. } = view.shading;
        let whole = mode == ShadingMode::Flat || interpolation == Interpolation::Scanline;
        let of = |instance: &PlacedInstance| {
            let mesh = self.objects[instance.first_object()].mesh.index();
            let made = || Box::new(Polygons::new(&self.scene.meshes[mesh]));
            let is_whole = whole && instance.strokes.is_none();
            is_whole.then(|| &**self.polygons_of_meshes[mesh].get_or_compute(made))
        };
        instances.iter().map(of).collect()
    }

    /// What mirror terms see: those of microfacet materials, and those of all others.
    fn environments(&self, view: &View) -> [Environment; 2] {
        match &view.environment {
            EnvironmentChoice::Always(environment) => [environment.clone(), environment.clone()],
            EnvironmentChoice::StudioForMicrofacets => {
                let up = self.up(view).as_vec3().to_array();
                [Environment::Studio { up }, Environment::None]
            }
        }
    }

    /// Does work on one of the renderer's threads. Many frames in a row are drawn faster from there:
    /// none of them has to be handed over to these threads, and its end waited for.
    pub fn install<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        luxel_parallel::install(self.pool.as_ref(), work)
    }

    /// Works on pieces on the calling thread and on all but one of the renderer's threads. The calling thread calls
    /// `proceed` after each of its pieces; once it returns false, the remaining pieces are skipped.
    ///
    /// # Panics
    /// If the work does.
    pub fn each_from_outside<T: Send>(
        &self,
        pieces: impl Iterator<Item = T> + Send,
        work: &(dyn Fn(T) + Sync),
        proceed: &mut dyn FnMut() -> bool,
    ) {
        luxel_parallel::each_from_outside(self.pool.as_ref(), pieces, work, proceed);
    }

    /// Runs `work` as [`Renderer::install`] does, and `meanwhile` on the calling thread, to watch for the user's
    /// cancellation for example. Returns when both have finished.
    pub fn install_while<R: Send>(
        &self,
        work: impl FnOnce() -> R + Send,
        meanwhile: impl FnOnce(),
    ) -> R {
        luxel_parallel::install_while(self.pool.as_ref(), work, meanwhile)
    }
}

/// The lights that have terms, in the order of the equation.
pub(crate) fn lights_with_terms(view: &View) -> Vec<&SceneLight> {
    let shines = |light: &&SceneLight| light.light.kind != LightKind::Ambient;
    view.lights.iter().filter(shines).collect()
}
