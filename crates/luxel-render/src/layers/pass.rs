//! The one pass that fills all layers, and the picture where both see the same.

use super::elsewhere::terms_elsewhere;
use super::planes::{BlockValues, Plane, TileValues, background, stored};
use super::sample::{RecentTriangles, Triangles};
use super::witness::{LayerWitness, LightLanes};
use crate::context::{AttributeMask, Heard, ShadingContext};
use crate::coverage::AlphaTest;
use crate::frame::{
    AHEAD, ALL_BLOCKS, Bands, BusyWorker, FrameNeeds, Picture, RenderError, Renderer, Stages,
    Subdivision, TilePixels, TileWork, Worker, for_tiles, lights_with_terms, look_ahead, put_block,
    unless_stopped,
};
use crate::interpolate::{Batch, Fragments, Wanted, nearest_sample};
use crate::resolve::{Bytes, Finish, empty_pixel, even_pixels, over_backdrop};
use crate::shade::{
    BlockWitness, ThreadCache, TriangleTerms, WantedTerms, all_fragments, geometry_of, is_studied,
    point_of, shade,
};
use luxel_lighting::PictureEncoding;
use luxel_math::{LANES, Mask, Rgb, Simd, Vec3, dispatch_long, f32x16, lanes_of, prelude::*};
use luxel_scene::{Projection, SceneLight};
use luxel_view::{Layer, LayerValues};
use luxel_view::{ShadingMode, View};
use luxel_visibility::{CoveragePolicy, TILE, TriangleId};
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::AtomicBool;

impl Renderer {
    /// Draws layers of a view, which all see the surfaces of `coverage`, and the picture if it is wanted.
    pub(super) fn one_pass(
        &self,
        stop: &AtomicBool,
        view: &View,
        layers: &[Layer],
        picture: Option<&mut Picture<[u8; 4]>>,
        values: &mut Vec<LayerValues>,
        coverage: CoveragePolicy,
    ) -> Result<(), RenderError> {
        let lights = lights_with_terms(view);
        for layer in layers {
            if let Layer::Light(name) | Layer::Shadow(name) = layer
                && !lights.iter().any(|light| light.name == *name)
            {
                let lights = lights.iter().map(|light| light.name.clone()).collect();
                return Err(RenderError::NoSuchLight { name: name.clone(), lights });
            }
        }
        let view = view.clone().with_samples(1).with_edges(None);
        let has_uvs = layers.contains(&Layer::Uv);
        let attributes = if has_uvs { AttributeMask::UVS[0] } else { AttributeMask::NONE };
        let has_places = |layer: &Layer| matches!(layer, Layer::Depth | Layer::Z | Layer::Position);
        let positions = layers.iter().any(has_places);
        let surfaces = positions || layers.iter().any(shows_surfaces);
        let heard = Heard { surfaces, positions, attributes };
        let start = self.now();
        let needs = FrameNeeds { coverage, heard, ..FrameNeeds::PICTURE };
        self.with_scene(&view, &needs, |scene, alpha_test| {
            let bin = self.now() - start;
            let sums = Mutex::new(Stages::default());
            let mut picture = picture;
            let mut pixels = picture.as_mut().map(|picture| &mut picture.pixels);
            values.resize_with(layers.len(), || LayerValues::F32(Vec::new()));
            values.truncate(layers.len());
            let planes = layers.iter().zip(values);
            let planes = planes.map(|(layer, values)| Plane::new(layer, values, view.size));
            let with_terms = layers.iter().any(Layer::is_lit);
            let at_pixels = scene.shading.mode == ShadingMode::Phong;
            let has_normals = layers.contains(&Layer::Normal);
            let maps_normals =
                has_normals && self.scene().materials.iter().any(|of| of.normal.is_some());
            let reads_attributes = has_uvs || maps_normals || is_studied(&scene.shading);
            let geometry = Wanted { position: heard.positions, normal: has_normals, light: false };
            let wanted = wanted_terms(layers);
            let are_mixed = with_terms && TriangleTerms::are_mixed(scene);
            let pass = Pass {
                renderer: self,
                scene,
                alpha_test,
                planes: planes.collect(),
                pixels: pixels.as_mut().map(|pixels| Bands::new(pixels, view.size, 1)),
                sums: &sums,
                lights,
                projection: view.camera.projection,
                eye: view.camera.eye().to_array(),
                is_blended: coverage == CoveragePolicy::DRAWN,
                maps_normals,
                geometry: (!reads_attributes).then_some(geometry),
                has_numbers: layers.iter().any(Layer::is_id),
                with_terms,
                is_lit_elsewhere: if are_mixed { wanted.any() } else { with_terms && !at_pixels },
                wanted: (are_mixed && wanted.any()).then_some(wanted),
                has_lights: layers.iter().any(shows_one_light),
            };
            let are_all_drawn = pass.pixels.is_some() && scene.backdrop.is_some();
            for_tiles(scene.frame, &|_| true, are_all_drawn, stop, || pass.worker(), &pass);
            drop(pass);
            if let Some(picture) = picture {
                picture.size = view.size;
                picture.encoding = view.encoding;
                picture.subdivision = Subdivision::of(scene);
                picture.stages = Stages { bin, ..sums.into_inner().unwrap_or_default() };
            }
        })?;
        unless_stopped(stop)
    }
}

/// What the pass reads beside the scene.
pub(super) struct Pass<'p> {
    pub(super) renderer: &'p Renderer,
    pub(super) scene: &'p ShadingContext<'p>,
    pub(super) alpha_test: &'p AlphaTest<'p>,
    pub(super) planes: Vec<Plane<'p>>,
    /// The picture, if it comes from this pass.
    pixels: Option<Bands<'p, [u8; 4]>>,
    /// What the stages take.
    sums: &'p Mutex<Stages>,
    /// The lights that have terms.
    lights: Vec<&'p SceneLight>,
    projection: Projection,
    /// The eye's place in the world, f64, which positions are about.
    eye: [f64; 3],
    maps_normals: bool,
    /// The attributes to interpolate, if the layers need no more than barycentrics, positions and normals.
    geometry: Option<Wanted>,
    /// Whether a layer shows numbers of objects or triangles.
    has_numbers: bool,
    /// Whether layers are sums over blended surfaces.
    is_blended: bool,
    /// Whether layers show terms of light.
    with_terms: bool,
    /// Whether layers show terms of light that may be computed elsewhere than at pixels.
    pub(super) is_lit_elsewhere: bool,
    /// What to keep of triangles' terms, where samples mix them and layers show any.
    wanted: Option<WantedTerms>,
    /// Whether layers show what comes of single lights.
    has_lights: bool,
}

/// Whether a layer shows what comes of one light.
fn shows_one_light(layer: &Layer) -> bool {
    matches!(layer, Layer::Light(_) | Layer::Shadow(_))
}

/// Whether a layer shows barycentrics, or what is interpolated by them beside places.
fn shows_surfaces(layer: &Layer) -> bool {
    matches!(layer, Layer::Barycentric | Layer::Normal | Layer::Uv)
}

/// The terms that layers show, or sums of them.
fn wanted_terms(layers: &[Layer]) -> WantedTerms {
    let is_wanted = |term: &Layer| layers.contains(term);
    let of_lights = layers.iter().any(|layer| matches!(layer, Layer::Light(_)));
    WantedTerms {
        ambient: of_lights || is_wanted(&Layer::Ambient),
        diffuse: of_lights || is_wanted(&Layer::Diffuse),
        specular: of_lights || is_wanted(&Layer::Specular),
        emission: is_wanted(&Layer::Emission),
        environment: is_wanted(&Layer::Environment),
        n_dot_l: is_wanted(&Layer::NDotL),
    }
}

/// What one thread draws with.
pub(super) struct LayerWorker<'w> {
    pub(super) worker: BusyWorker<'w>,
    pixels: Box<TilePixels<[u8; 4]>>,
    /// A tile of each layer.
    pub(super) tiles: Vec<TileValues>,
    pub(super) of_lights: Vec<LightLanes>,
    recent: RecentTriangles,
}

impl<'w> TileWork<LayerWorker<'w>> for Pass<'w> {
    fn draw(&self, worker: &mut LayerWorker<'w>, tile: usize) {
        if self.is_blended {
            self.draw_blended(worker, tile);
            for (plane, drawn) in self.planes.iter().zip(&worker.tiles) {
                plane.put(tile, drawn);
            }
            return;
        }
        let level = self.renderer.level();
        let frame = self.scene.frame;
        let alpha_tester = self.alpha_test.finder(frame, level);
        let begin = self.renderer.now();
        frame.draw_opaque(level, tile, &alpha_tester, &mut worker.worker.opaque);
        let visible = self.renderer.now();
        dispatch_long!(level, simd => self.shade_tile(simd, worker));
        if let Ok(mut sums) = self.sums.lock() {
            sums.visibility += visible - begin;
            sums.shade += self.renderer.now() - visible;
        }
        if let Some(pixels) = &self.pixels {
            pixels.put(tile, worker.pixels.as_slice());
        }
        for (plane, drawn) in self.planes.iter().zip(&worker.tiles) {
            plane.put(tile, drawn);
        }
    }

    fn fill(&self, band: usize, columns: &[Range<usize>]) {
        if let Some(pixels) = &self.pixels {
            pixels.fill(band, columns, self.finish().pixel(empty_pixel(self.scene)));
        }
        for plane in &self.planes {
            plane.fill(band, columns);
        }
    }
}

impl<'p> Pass<'p> {
    fn worker(&self) -> LayerWorker<'p> {
        let mut worker = self.renderer.worker(self.scene.frame.samples());
        if let Some(wanted) = self.wanted {
            worker.cache.terms.begin_frame(self.scene, wanted);
        }
        let lights = if self.has_lights { self.lights.len() } else { 0 };
        LayerWorker {
            worker,
            pixels: Box::new([[0; 4]; (TILE * TILE) as usize]),
            tiles: self.planes.iter().map(Plane::tile).collect(),
            of_lights: vec![LightLanes::NOTHING; lights],
            recent: RecentTriangles::new(),
        }
    }

    fn finish(&self) -> Bytes {
        let encoding: PictureEncoding = self.scene.encoding;
        Bytes(encoding)
    }

    #[inline(always)]
    fn shade_tile<S: Simd>(&self, simd: S, worker: &mut LayerWorker<'_>) {
        let is_flat = self.pixels.is_none() || self.scene.backdrop.is_none();
        for first in (0..ALL_BLOCKS).step_by(AHEAD) {
            let Worker { opaque, cache, .. } = &mut *worker.worker;
            let ahead = look_ahead(simd, self.scene, opaque, first, cache);
            if is_flat && ahead.are_empty() {
                self.fill_rows(worker, first);
                continue;
            }
            if self.wanted.is_some() {
                let Worker { opaque, cache, .. } = &mut *worker.worker;
                let blocks = opaque.planes()[0].ids[first..first + AHEAD].iter();
                cache.terms.look_ahead(f32x16::splat(simd, 0.0), self.scene, blocks);
            }
            for number in 0..AHEAD {
                if is_flat && ahead.is_empty(number) {
                    self.fill_block(worker, first + number);
                } else {
                    self.shade_block(simd, worker, first + number, ahead.is_single(number));
                }
            }
        }
    }

    /// Fills rows of blocks in which nothing is seen: rows of pixels, sixteen to a block.
    fn fill_rows(&self, worker: &mut LayerWorker<'_>, first: usize) {
        let LayerWorker { pixels, tiles, .. } = worker;
        let run = first * LANES..(first + AHEAD) * LANES;
        if self.pixels.is_some() {
            pixels[run.clone()].fill(self.finish().pixel(empty_pixel(self.scene)));
        }
        for (plane, values) in self.planes.iter().zip(tiles) {
            plane.fill_run(values, &run);
        }
    }

    /// Fills a block in which nothing is seen.
    pub(super) fn fill_block(&self, worker: &mut LayerWorker<'_>, block: usize) {
        let LayerWorker { pixels, tiles, .. } = worker;
        if self.pixels.is_some() {
            put_block(pixels, block, &[self.finish().pixel(empty_pixel(self.scene)); LANES]);
        }
        for (plane, values) in self.planes.iter().zip(tiles) {
            plane.fill_block(values, block);
        }
    }

    #[inline(always)]
    fn shade_block<S: Simd>(
        &self,
        simd: S,
        worker: &mut LayerWorker<'_>,
        block: usize,
        is_single: bool,
    ) {
        let Self { scene, .. } = *self;
        let LayerWorker { worker, pixels, tiles, of_lights, recent } = worker;
        let Worker { opaque: tile, cache, .. } = &mut **worker;
        let vector = f32x16::splat(simd, 0.0);
        let ids = tile.planes()[0].ids[block];
        let within = nearest_sample(scene.frame.samples());
        let batch = Batch::even(tile, block, ids, within, is_single);
        of_lights.fill(LightLanes::NOTHING);
        let needs = [self.maps_normals, self.with_terms];
        let mut witness = LayerWitness::new(vector, needs, of_lights);
        if self.pixels.is_some() || self.with_terms {
            let lit = shade(vector, scene, &batch, cache, &mut witness);
            if self.is_lit_elsewhere {
                let seen = !vector.eq_mask(&ids, TriangleId::NONE.0) & vector.all_lanes();
                terms_elsewhere(scene, &batch, cache, seen, &mut witness);
            }
            if self.pixels.is_some() {
                let color = even_pixels(simd, over_backdrop(simd, scene, &batch, lit, cache));
                put_block(pixels, block, &self.finish().block(simd, color));
            }
        } else {
            let seen = !vector.eq_mask(&ids, TriangleId::NONE.0) & vector.all_lanes();
            hear(vector, scene, &batch, cache, (seen, self.geometry), &mut witness);
        }
        let numbers = self.has_numbers.then(|| Triangles::of(vector, scene, &ids, recent));
        let seen = match &numbers {
            Some(numbers) => numbers.seen,
            None => !vector.eq_mask(&ids, TriangleId::NONE.0) & vector.all_lanes(),
        };
        let seen = vector.mask_of(seen);
        for (plane, values) in self.planes.iter().zip(tiles) {
            match values {
                TileValues::U32(values) => {
                    let Some(numbers) = &numbers else { continue };
                    let ids = match plane.layer {
                        Layer::Object => &numbers.objects,
                        _ => &numbers.triangles,
                    };
                    plane.put_values(values, block, &[*ids; 3]);
                }
                TileValues::F32(values) => {
                    let found = self.values(plane.layer, &witness, seen);
                    plane.put_values(values, block, &found);
                }
            }
        }
    }

    /// The values of a layer of numbers.
    #[inline(always)]
    pub(super) fn values<N: Lanes>(
        &self,
        layer: &Layer,
        witness: &LayerWitness<'_, N>,
        seen: N::Mask,
    ) -> BlockValues {
        let simd = witness.depth;
        let zero = simd.zero();
        let vector = |Vec3 { x, y, z }: Vec3<N>| [x, y, z];
        let light = |Rgb { r, g, b }: Rgb<N>| {
            let s = witness.fog_factor;
            [r * s, g * s, b * s]
        };
        let numbers = match layer {
            Layer::Depth => {
                let mut depths = stored([simd; 3], seen, 0.0);
                let bits = seen.bits();
                for (lane, depth) in depths[0].iter_mut().enumerate() {
                    let is_seen = bits >> lane & 1 == 1;
                    let z = f64::from(*depth);
                    let depth_there = || self.projection.window_depth(z) as f32;
                    *depth = if is_seen { depth_there() } else { background(layer) };
                }
                return depths;
            }
            Layer::Z => [simd; 3],
            Layer::Normal => vector(witness.normal),
            Layer::Position => return self.positions(witness.position, seen),
            Layer::Barycentric => witness.weights,
            Layer::Uv => [witness.uv[0], witness.uv[1], zero],
            Layer::Ambient => light(witness.ambient),
            Layer::Diffuse => light(witness.diffuse),
            Layer::Specular => light(witness.specular),
            Layer::Emission => light(witness.emission),
            Layer::Environment => light(witness.environment),
            Layer::Fog => {
                let Rgb { r, g, b } = witness.fog;
                [r, g, b]
            }
            Layer::NDotL => [witness.n_dot_l; 3],
            Layer::Openness => [witness.openness; 3],
            Layer::Shadow(name) => match self.of_light(name, witness) {
                Some(LightLanes { visibility, .. }) => [simd.load(visibility, 0); 3],
                None => return [[0.0; LANES]; 3],
            },
            Layer::Light(name) => {
                let Some(LightLanes { sum: sums, .. }) = self.of_light(name, witness) else {
                    return [[0.0; LANES]; 3];
                };
                light(Rgb::new(
                    simd.load(&sums[0], 0),
                    simd.load(&sums[1], 0),
                    simd.load(&sums[2], 0),
                ))
            }
            Layer::Object | Layer::Triangle => [zero; 3],
        };
        stored(numbers, seen, background(layer))
    }

    /// What was heard of the light of a name.
    #[inline(always)]
    fn of_light<'l, N: Lanes>(
        &self,
        name: &str,
        witness: &'l LayerWitness<'_, N>,
    ) -> Option<&'l LightLanes> {
        let index = self.lights.iter().position(|light| light.name == *name)?;
        witness.of_lights.get(index)
    }

    /// Places in the world, which are summed in f64.
    fn positions<N: Lanes>(&self, about_eye: Vec3<N>, seen: N::Mask) -> BlockValues {
        let Vec3 { x, y, z } = about_eye;
        let mut places = stored([x, y, z], seen, 0.0);
        for (axis, places) in places.iter_mut().enumerate() {
            for lane in lanes_of(seen.bits()) {
                places[lane] = (self.eye[axis] + f64::from(places[lane])) as f32;
            }
        }
        places
    }
}

/// Interpolates a block for its witness, without lighting it.
#[inline(always)]
fn hear<N: Lanes>(
    simd: N,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    cache: &mut ThreadCache,
    (seen, geometry): (u32, Option<Wanted>),
    witness: &mut LayerWitness<'_, N>,
) {
    let mut materials = [0; LANES];
    let mut found = Fragments::nothing(simd);
    match geometry {
        Some(wanted) if N::IS_SPECIALIZED => {
            let (setup, found) = (&mut cache.setup, &mut found);
            geometry_of(simd, scene, batch, setup, (seen, wanted), found, &mut materials);
        }
        _ => all_fragments(simd, scene, batch, cache, seen, &mut found, &mut materials),
    }
    let point = point_of(simd, scene, batch, &found);
    witness.fragments(scene, &found, &materials, &point, seen);
}
