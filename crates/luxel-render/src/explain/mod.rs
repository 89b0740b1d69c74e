//! Why a pixel has its colour: the drawing of one pixel, run again with the terms written down.
//!
//! The tile that holds the pixel is drawn as in every frame. What its samples see is then lit by the
//! same code that lights sixteen pixels at a time, this time one sample at a time and with a witness
//! that writes every term down; as one number and sixteen lanes give the same bits, the ledger's
//! colours are the picture's.

mod ground;
mod ledger;
mod occluded;
mod shadow;
mod vertex_terms;
mod written;

pub use ledger::{
    BlockedBy, EvaluatedAt, ExplainedGround, ExplainedLight, ExplainedMaterial, ExplainedSample,
    ExplainedShadow, ExplainedSurface, Explanation, Seen, Unlit,
};
pub use occluded::{Hidden, NEAREST_WITHIN, NearestObject, SurfaceBelow, Unseen};

use crate::context::{Heard, LitAt, ShadingContext};
use crate::frame::{FrameNeeds, RenderError, Renderer, lights_with_terms};
use crate::interpolate::Batch;
use crate::resolve::{self, Layered, bytes_of};
use crate::shade::{MixedTerms, ThreadCache, VisibleLights, shade};
use crate::shadow::Receiver;
use luxel_lighting::{Reflectance, SurfacePoint};
use luxel_math::{LANES, Rgb, SUBPIXELS};
use luxel_scene::{SceneLight, Size};
use luxel_view::View;
use luxel_visibility::{BLOCK, Region, Samples, TILE, Tile, TriangleId};
use shadow::openness_of;
use vertex_terms::{Interpolated, evaluated_at};
use written::Written;

/// What is asked about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum At {
    /// A pixel with all its samples: column and row.
    Pixel([u32; 2]),
    /// One sample at a point of the window, in pixels from its upper left corner, rounded to 1/256.
    Point([f64; 2]),
}

impl At {
    /// The pixel, and the place of its only sample; `None` outside of the window.
    fn place(self, size: Size) -> Option<([u32; 2], Option<[i32; 2]>)> {
        let (pixel, sample) = match self {
            Self::Pixel(pixel) => (pixel, None),
            Self::Point(point) => {
                let steps = steps_of(point, size)?;
                let pixel = steps.map(|steps| (steps / SUBPIXELS) as u32);
                (pixel, Some(steps.map(|steps| steps % SUBPIXELS)))
            }
        };
        (pixel[0] < size.width && pixel[1] < size.height).then_some((pixel, sample))
    }
}

/// A place of the window in steps of 1/256 pixel, the nearest ones in the window; `None` outside of it.
fn steps_of([x, y]: [f64; 2], size: Size) -> Option<[i32; 2]> {
    let steps = |place: f64, side: u32| {
        let step = (place * f64::from(SUBPIXELS)).round();
        let is_inside = step >= 0.0 && place < f64::from(side);
        is_inside.then(|| (step as i32).min(side as i32 * SUBPIXELS - 1))
    };
    Some([steps(x, size.width)?, steps(y, size.height)?])
}

/// The region that holds all of some pixels.
fn around(pixels: &[[u32; 2]]) -> Region {
    let side = |axis: usize| {
        let places = pixels.iter().map(|pixel| pixel[axis] as i32);
        let first = places.clone().min().unwrap_or_default();
        (first, places.max().map_or(0, |last| last - first + 1))
    };
    let ((x, width), (y, height)) = (side(0), side(1));
    Region { x, y, width, height }
}

impl Renderer {
    /// Explains a pixel of a view, or one sample of it: what is seen there, and every term of its
    /// light. [`Explanation::rgba8`] is the pixel of [`Renderer::rgba8`]. Edges aren't explained.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible, or the place lies outside of it.
    pub fn explain(&self, view: &View, at: At) -> Result<Explanation, RenderError> {
        let (pixel, only) = at.place(view.size).ok_or(RenderError::Outside(view.size))?;
        let explained = self.explain_places(view, &[pixel], only)?;
        explained.into_iter().next().ok_or(RenderError::Outside(view.size))
    }

    /// Explains pixels of a view, by column and row, as [`Renderer::explain`] does one. Those of one
    /// tile of 64x64 pixels, if they follow one another, are drawn at once.
    ///
    /// # Errors
    /// As [`Renderer::explain`].
    pub fn explain_pixels(
        &self,
        view: &View,
        pixels: &[[u32; 2]],
    ) -> Result<Vec<Explanation>, RenderError> {
        let outside = pixels.iter().any(|&pixel| At::Pixel(pixel).place(view.size).is_none());
        if outside {
            Err(RenderError::Outside(view.size))
        } else {
            self.explain_places(view, pixels, None)
        }
    }

    /// Explains pixels, each with all its samples or with one only, which lie inside of the view.
    fn explain_places(
        &self,
        view: &View,
        pixels: &[[u32; 2]],
        only: Option<[i32; 2]>,
    ) -> Result<Vec<Explanation>, RenderError> {
        let view = view.clone().with_edges(None);
        let needs = FrameNeeds {
            samples: only.map(Samples::one_at),
            heard: Heard::EVERYTHING,
            part: Some(around(pixels)),
            ..FrameNeeds::PICTURE
        };
        self.with_scene(&view, &needs, |scene, cutouts| {
            let mut worker = self.worker(scene.frame.samples());
            let mut kept = ThreadCache::new();
            let [across, _] = scene.frame.tiles();
            let tile_of = |side: u32| side as usize / TILE as usize;
            let (mut drawn, mut layers) = (None, Vec::new());
            let mut explain = |&pixel: &[u32; 2]| {
                let number = tile_of(pixel[1]) * across + tile_of(pixel[0]);
                if drawn != Some(number) {
                    let holes = cutouts.finder(scene.frame, self.level());
                    scene.frame.draw_opaque(self.level(), number, &holes, &mut worker.opaque);
                    layers.clear();
                    let mut keep = |layer: &Tile| layers.push(layer.clone());
                    self.peel(scene, number, &holes, &mut worker, &mut keep);
                    drawn = Some(number);
                }
                let place = Tile::place(pixel[0] as i32 % TILE, pixel[1] as i32 % TILE);
                PixelScene { scene, view: &view, renderer: self, place }.explain(
                    pixel,
                    only,
                    &worker.opaque,
                    &layers,
                    &mut kept,
                )
            };
            pixels.iter().map(&mut explain).collect()
        })
    }
}

/// For each sample of one pixel, what it sees and the sample at which that is lit.
struct SeenBySample(Vec<(TriangleId, u8)>);

impl SeenBySample {
    /// `is_flat`: the same lies behind all samples that see no surface.
    fn of(tile: &Tile, (block, lane): (usize, usize), samples: Samples, is_flat: bool) -> Self {
        let id = |sample: u8| tile.planes()[usize::from(sample)].ids[block][lane];
        let seen = (0..).zip(tile.planes()).map(|(sample, plane)| {
            let own = plane.ids[block][lane];
            if own == TriangleId::NONE.0 && !is_flat {
                return (TriangleId::NONE, sample);
            }
            // The nearest to the centre of those that see the same.
            let lit_at = samples.nearest_first().iter().find(|&&sample| id(sample) == own);
            (TriangleId(own), lit_at.map_or(0, |&sample| sample))
        });
        Self(seen.collect())
    }
}

/// One pixel of a frame.
struct PixelScene<'a> {
    scene: &'a ShadingContext<'a>,
    view: &'a View,
    renderer: &'a Renderer,
    /// Block and lane within the tile.
    place: (usize, usize),
}

impl PixelScene<'_> {
    fn explain(
        &self,
        pixel: [u32; 2],
        only: Option<[i32; 2]>,
        opaque: &Tile,
        layers: &[Tile],
        kept: &mut ThreadCache,
    ) -> Explanation {
        let (block, _) = self.place;
        let samples = self.scene.frame.samples();
        let is_flat = self.scene.backdrop.is_none();
        let layers: Vec<_> = layers
            .iter()
            .map(|layer| SeenBySample::of(layer, self.place, samples, is_flat))
            .collect();
        let behind = SeenBySample::of(opaque, self.place, samples, is_flat);
        // What each sample sees, nearest first; what doesn't cover it shows what lies behind all.
        let stacks: Vec<Vec<(TriangleId, u8)>> = (0..samples.count())
            .map(|sample| {
                let through = layers.iter().map(|layer| layer.0[sample]);
                let last = behind.0[sample];
                through.filter(|seen| seen.0 != last.0).chain([last]).collect()
            })
            .collect();
        let layered = stacks.iter().any(|stack| stack.len() > 1);
        let mut entries: Vec<(&Vec<(TriangleId, u8)>, ExplainedSample)> = Vec::new();
        for (sample, stack) in stacks.iter().enumerate() {
            if let Some((_, known)) = entries.iter_mut().find(|(other, _)| *other == stack) {
                known.covers.push(sample as u8);
                continue;
            }
            let seen = stack.iter().map(|&seen| self.seen(opaque, seen, kept)).collect();
            entries.push((stack, ExplainedSample::new(sample as u8, seen)));
        }
        let placed = |(stack, mut entry): (&Vec<(TriangleId, u8)>, ExplainedSample)| {
            entry.weight = entry.covers.len() as f32 / samples.count() as f32;
            let lit = stack.first().map(|seen| seen.1).filter(|lit| entry.covers.contains(lit));
            let sample = usize::from(lit.unwrap_or(entry.covers[0]));
            let inside = samples.positions()[sample];
            entry.at = [0, 1].map(|axis| {
                f64::from(pixel[axis]) + f64::from(inside[axis]) / f64::from(SUBPIXELS)
            });
            entry
        };
        let explained: Vec<_> = entries.into_iter().map(placed).collect();
        let linear = if layered {
            layered_pixel(&explained, samples.count())
        } else if self.scene.backdrop.is_none() && resolve::is_empty(opaque, block) {
            resolve::empty_pixel(self.scene)
        } else {
            even_pixel(&explained, samples.count())
        };
        Explanation {
            pixel,
            position: only.map(|inside| {
                let place = |axis: usize| {
                    f64::from(pixel[axis]) + f64::from(inside[axis]) / f64::from(SUBPIXELS)
                };
                [place(0), place(1)]
            }),
            samples: explained,
            display: self.view.display(),
            linear,
            rgba8: bytes_of(linear, self.view.encoding),
        }
    }

    /// What one sample sees of one triangle, or the background.
    fn seen(&self, tile: &Tile, (id, sample): (TriangleId, u8), kept: &mut ThreadCache) -> Seen {
        let scene = self.scene;
        let (block, lane) = self.place;
        let samples = scene.frame.samples();
        let batch =
            Batch::new(tile, block, [id.0; LANES], &[sample.into(); LANES], samples).only(lane);
        let eye = self.view.camera.eye().to_array();
        let lit = Lit::of(scene, eye, &lights_with_terms(self.view), &batch, kept);
        let (Some(of), Some(lit)) = (scene.frame.triangle(id), lit) else {
            let lights = lights_with_terms(self.view);
            return ground::background(scene, &batch, eye, &lights, kept);
        };
        let (object, triangle) = scene.placed.object_of(of.instance, of.triangle);
        let mesh = scene.frame.instances()[of.instance].mesh;
        let material = &scene.scene.materials[mesh.parts[of.part].material.index()];
        let mut reflectance =
            lit.reflectance.unwrap_or_else(|| Reflectance::of(0.0, &material.constants));
        if !lit.evaluated_at.is_empty() {
            let [r, g, b] = lit.texture;
            reflectance = reflectance.times_base_color(Rgb::new(r, g, b), &material.constants);
        }
        let point = |of: fn(&SurfacePoint<f32>) -> [f32; 3]| lit.point.as_ref().map(of);
        let position = point(|point| point.position.lane(0)).unwrap_or_default();
        let node = self.renderer.objects()[object].node;
        Seen::Surface(Box::new(ExplainedSurface {
            object,
            name: scene.scene.nodes[node.index()].name.to_string(),
            triangle,
            barycentric: lit.barycentric,
            texture: lit.texture,
            position: std::array::from_fn(|axis| eye[axis] + f64::from(position[axis])),
            normal: point(|point| point.normal.lane(0)).unwrap_or_default(),
            view: point(|point| point.view.lane(0)).unwrap_or_default(),
            z: lit.point.map_or(0.0, |point| point.depth),
            uv: lit.uv,
            openness: lit.openness,
            material: ExplainedMaterial {
                name: material.name.to_string(),
                constants: material.constants.clone(),
                reflectance,
            },
            ambient_light: scene.ambient,
            evaluated_at: lit.evaluated_at,
            lights: lit.terms.lights,
            emission: lit.terms.emission,
            scene_ambient: lit.terms.scene_ambient,
            environment: lit.terms.environment,
            mirrors: lit.terms.mirrors,
            environment_diffuse: lit.terms.environment_diffuse,
            diffused: lit.terms.diffused,
            sum: lit.sum,
            fog: lit.fog,
            color: lit.color,
            display: lit.display,
            alpha: lit.alpha,
        }))
    }
}

/// One sample, lit with its terms written down.
pub(crate) struct Lit {
    pub(crate) terms: Interpolated,
    pub(crate) fog: Option<(f32, [f32; 3])>,
    sum: [f32; 3],
    color: [f32; 3],
    display: [f32; 3],
    alpha: f32,
    point: Option<SurfacePoint<f32>>,
    reflectance: Option<Reflectance<f32>>,
    barycentric: [f32; 3],
    uv: Option<[f32; 2]>,
    pub(crate) openness: Option<f32>,
    texture: [f32; 3],
    evaluated_at: Vec<EvaluatedAt>,
}

impl Lit {
    /// Lights the first sample of a batch, the only one; `None` if it sees nothing.
    pub(crate) fn of(
        scene: &ShadingContext<'_>,
        eye: [f64; 3],
        lights: &[&SceneLight],
        batch: &Batch,
        kept: &mut ThreadCache,
    ) -> Option<Self> {
        let id = TriangleId(batch.ids[0]);
        scene.frame.triangle(id)?;
        let mut written = Written::default();
        let [r, g, b, alpha] = shade(0.0_f32, scene, batch, kept, &mut written);
        let barycentric = written.barycentric;
        let triangle = kept.lit.get(scene, id)?;
        let mut evaluated: Vec<EvaluatedAt> = Vec::new();
        let tint = written.tint.unwrap_or([1.0; 3]);
        let lit_at = scene.lit_at(triangle.material as usize);
        // What the texture colours, and what its product is a factor of.
        let (texel, texture) = match lit_at {
            LitAt::PiecesUnderTexels => (Some(tint), [1.0; 3]),
            LitAt::Pixels | LitAt::Elsewhere => (None, tint),
        };
        let (mut visible, mut mixed) = (None, None);
        if lit_at != LitAt::Pixels {
            let places = triangle.lit_at(barycentric, batch.position(0));
            let seen_at = (barycentric, batch.position(0));
            visible = VisibleLights::of(scene, id, seen_at, &places);
            for place in &places {
                let there = evaluated_at(scene, triangle, place, texel, (eye, lights));
                if evaluated.iter().all(|other| other.weight < place.weight) {
                    written.reflectance = Some(there.reflectance);
                }
                evaluated.push(there);
            }
            let terms = triangle.terms(scene, &places, tint);
            let weighted: Vec<_> = places.iter().map(|place| place.weight).zip(terms).collect();
            let terms = MixedTerms::of(&weighted, Rgb::splat(0.0, texture));
            mixed = Some(match &visible {
                Some(visible) => terms.visible(scene, visible),
                None => terms,
            });
        }
        let normal = match (&visible, &written.point) {
            (Some(visible), _) => visible.normal,
            (None, Some(point)) => point.normal.lane(0),
            (None, None) => [0.0; 3],
        };
        let smooth = if visible.is_some() { normal } else { written.smooth };
        let (position, is_between) = (batch.position(0), visible.is_some());
        let receiver = Receiver { id, barycentric, normal, smooth, position, is_between };
        let openness = openness_of(scene, &receiver);
        let terms = match (mixed, &visible) {
            (None, _) => Interpolated {
                emission: written.ledger.emission,
                scene_ambient: written.ledger.scene_ambient,
                environment: written.ledger.environment,
                mirrors: written.ledger.mirrors.clone(),
                environment_diffuse: written.ledger.environment_diffuse,
                diffused: written.ledger.diffused.clone(),
                lights: written.explained_lights(scene, eye, lights, Some(&receiver)),
            },
            (Some(mixed), None) => Interpolated::of(&evaluated, mixed),
            (Some(mixed), Some(visible)) => {
                Interpolated::of(&evaluated, mixed).in_shadow(scene, &receiver, visible)
            }
        };
        Some(Self {
            terms,
            fog: written.ledger.fog,
            sum: written.sum.unwrap_or(written.ledger.sum),
            color: written.ledger.color,
            display: [r, g, b],
            alpha,
            point: written.point,
            reflectance: written.reflectance,
            barycentric,
            uv: written.uv,
            openness,
            texture,
            evaluated_at: evaluated,
        })
    }
}

/// Samples without transparent surfaces become a pixel.
fn even_pixel(samples: &[ExplainedSample], count: usize) -> [f32; 4] {
    let mut sum = [0.0; 4];
    for sample in samples {
        let [r, g, b] = sample.display;
        let share = sample.covers.len() as f32 * (1.0 / count as f32);
        resolve::add_share(&mut sum, [r, g, b, sample.alpha], share);
    }
    resolve::straight(sum)
}

/// Samples with transparent surfaces become a pixel.
fn layered_pixel(entries: &[ExplainedSample], count: usize) -> [f32; 4] {
    let mut sum = [0.0; 4];
    for sample in 0..count as u8 {
        let Some(entry) = entries.iter().find(|entry| entry.covers.contains(&sample)) else {
            continue;
        };
        let (light, through) = entry.gathered();
        Layered::add_sample(&mut sum, light, through, 1.0 / count as f32);
    }
    resolve::straight(sum)
}

const _: () = assert!(TILE % BLOCK == 0, "a tile's pixels are those of its blocks");
