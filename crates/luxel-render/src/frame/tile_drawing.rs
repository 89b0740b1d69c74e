//! Pictures tile by tile: all tiles of a view, or those of a set.

use super::error::RenderError;
use super::finished_tile::{FinishTile, Pixels};
use super::frame_needs::FrameNeeds;
use super::picture::{Picture, Stages, Subdivision};
use super::renderer::Renderer;
use super::tiles::{Bands, NEVER, TilePixels, TileWork, for_tiles};
use super::workers::BusyWorker;
use crate::context::ShadingContext;
use crate::coverage::AlphaTest;
use crate::resolve::{Bytes, empty_pixel};
use luxel_view::View;
use luxel_visibility::TILE;
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::AtomicBool;

/// A view that is culled and binned, to be drawn in sets of tiles: see [`Renderer::with_tiles`].
pub struct TileDrawing<'d> {
    renderer: &'d Renderer,
    scene: &'d ShadingContext<'d>,
    alpha_test: &'d AlphaTest<'d>,
}

impl Renderer {
    /// Culls and bins a view once, for `work` to draw its tiles in sets.
    ///
    /// Tiles are squares of [`TILE_SIDE`](crate::TILE_SIDE) pixels, numbered row by row from the upper
    /// left; those at the right and at the bottom end with the picture. Whatever the sets are, a pixel has
    /// the bytes of [`Renderer::rgba8`].
    ///
    /// ```
    /// # use luxel_render::{Cull, EnvironmentChoice, Execution, Picture, Renderer, Shading, View};
    /// # use luxel_scene::{DVec3, Lens, Size, Viewpoint, default_lights, demos, fit_view};
    /// # let scene = demos::demo("spheres").unwrap();
    /// # let size = Size { width: 160, height: 100 };
    /// # let viewpoint = Viewpoint { up: DVec3::Y, azimuth_radians: 0.5, elevation_radians: 0.3 };
    /// # let view = View::new(size, fit_view(&scene, &viewpoint, Lens::Perspective { fov_y_radians: 0.8 }, size)).with_samples(1).with_cull(Cull::Auto).with_lights(default_lights()).with_ambient([0.1; 3]).with_environment(EnvironmentChoice::StudioForMicrofacets).with_fog(None).with_background([0.0; 4]).with_encoding(luxel_lighting::PictureEncoding::Srgb).with_edges(None).with_shading(Shading::default());
    /// let renderer = Renderer::new(scene, &Execution::default())?;
    /// let mut picture = Picture::default();
    /// renderer.with_tiles(&view, |tiles| {
    ///     // First what the user looks at, then the rest.
    ///     tiles.rgba8_into(|tile| tile == 1, &mut picture);
    ///     tiles.rgba8_into(|tile| tile != 1, &mut picture);
    /// })?;
    /// assert_eq!(picture.pixels, renderer.rgba8(&view)?.pixels);
    /// # Ok::<(), luxel_render::RenderError>(())
    /// ```
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub fn with_tiles<R: Send>(
        &self,
        view: &View,
        work: impl FnOnce(&TileDrawing<'_>) -> R + Send,
    ) -> Result<R, RenderError> {
        self.with_scene(view, &FrameNeeds::PICTURE, |scene, alpha_test| {
            work(&TileDrawing::new(self, scene, alpha_test))
        })
    }

    /// Draws the tiles of a view that a set holds, as [`Renderer::with_tiles`] numbers them, among several
    /// renderers of the same scene for example. Other pixels of `picture` stay, if it has the view's size;
    /// else they are transparent black.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible; the picture is then as before.
    pub fn rgba8_tiles_into(
        &self,
        view: &View,
        set: impl Fn(usize) -> bool + Sync + Send,
        picture: &mut Picture<[u8; 4]>,
    ) -> Result<(), RenderError> {
        let begin = self.now();
        self.with_tiles(view, |tiles| {
            let bin = self.now() - begin;
            tiles.rgba8_into(set, picture);
            picture.stages = Stages { bin, frame: self.now() - begin, ..picture.stages };
        })
    }
}

impl<'d> TileDrawing<'d> {
    pub(super) fn new(
        renderer: &'d Renderer,
        scene: &'d ShadingContext<'d>,
        alpha_test: &'d AlphaTest<'d>,
    ) -> Self {
        Self { renderer, scene, alpha_test }
    }

    /// Tiles across and down.
    #[must_use]
    pub fn count(&self) -> [usize; 2] {
        self.scene.frame.tiles()
    }

    /// Draws the tiles of a set. Other pixels of `picture` stay, if it has the view's size; else they
    /// are transparent black.
    pub fn rgba8_into(
        &self,
        set: impl Fn(usize) -> bool + Sync + Send,
        picture: &mut Picture<[u8; 4]>,
    ) {
        self.draw(&Bytes(self.scene.encoding), &set, &NEVER, picture);
    }

    /// Draws the tiles of a set, each block finished while it is in registers, until `stop` is set.
    pub(super) fn draw<F: FinishTile>(
        &self,
        finish: &F,
        set: &(dyn Fn(usize) -> bool + Sync),
        stop: &AtomicBool,
        picture: &mut Picture<F::Pixel>,
    ) {
        let Self { renderer, scene, alpha_test } = *self;
        let begin = renderer.now();
        let size = scene.frame.size();
        if picture.size != size {
            picture.size = size;
            picture.pixels.clear();
        }
        let sums = Mutex::new(Stages::default());
        let work = Drawing {
            renderer,
            scene,
            alpha_test,
            finish,
            background: finish.pixel(empty_pixel(scene)),
            bands: Bands::new(&mut picture.pixels, size, 1),
            sums: &sums,
        };
        let worker = || (renderer.worker(scene.frame.samples()), new_tile());
        for_tiles(scene.frame, set, scene.backdrop.is_some(), stop, worker, &work);
        let sums = sums.into_inner().unwrap_or_default();
        picture.encoding = scene.encoding;
        picture.stages = Stages { frame: renderer.now() - begin, ..sums };
        picture.subdivision = Subdivision::of(scene);
    }
}

/// A tile's pixels, yet to be drawn.
fn new_tile<T: Copy + Default>() -> Box<TilePixels<T>> {
    Box::new([T::default(); (TILE * TILE) as usize])
}

/// The drawing of a picture, tile by tile.
struct Drawing<'d, F: FinishTile> {
    renderer: &'d Renderer,
    scene: &'d ShadingContext<'d>,
    alpha_test: &'d AlphaTest<'d>,
    finish: &'d F,
    background: F::Pixel,
    bands: Bands<'d, F::Pixel>,
    sums: &'d Mutex<Stages>,
}

/// What one thread draws with: its worker, and the pixels of a tile.
type Painter<'w, T> = (BusyWorker<'w>, Box<TilePixels<T>>);

impl<'w, F: FinishTile> TileWork<Painter<'w, F::Pixel>> for Drawing<'_, F> {
    fn draw(&self, (worker, pixels): &mut Painter<'w, F::Pixel>, tile: usize) {
        let Self { renderer, scene, alpha_test, finish, .. } = *self;
        let begin = renderer.now();
        let mut kept = finish.tile(Pixels { pixels, background: self.background });
        let visible = renderer.draw_tile(scene, alpha_test, tile, worker, &mut kept);
        let end = renderer.now();
        if let Ok(mut sums) = self.sums.lock() {
            sums.visibility += visible - begin;
            sums.shade += end - visible;
        }
        self.bands.put(tile, pixels.as_slice());
    }

    fn fill(&self, band: usize, columns: &[Range<usize>]) {
        self.bands.fill(band, columns, self.background);
    }
}
