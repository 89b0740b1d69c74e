//! Sixteen samples of a block into light.

use crate::edges::{EdgeFlags, edge_distance};
use crate::gathered::{Gathered, Wanted, has_many};
use crate::pieces::PieceCount;
use crate::polygons::Polygons;
use crate::ready::Ready;
use crate::surface::{self, Interpolated, SurfaceWitness};
use crate::triangles::{SeenTriangle, SeenTriangles};
use crate::varying::{Varying, Weights, lanes_of, merge};
use crate::view::{Edges, Interpolation, Shading, ShadingMode};
use luxel_lighting::{
    Coefficients, Environment, Fog, PictureEncoding, PlacedLight, Surroundings, Uniform,
};
use luxel_math::{LANES, Mask, Number, SUBPIXELS, Wide};
use luxel_scene::{DVec3, Scene};
use luxel_visibility::{BLOCK, BLOCKS, Frame, InstanceSpace, Samples, Tile, TriangleId};
use std::collections::HashMap;
use std::sync::Mutex;

/// Everything that shading looks at.
pub(crate) struct Scene16<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) frame: &'a Frame<'a>,
    pub(crate) spaces: &'a [InstanceSpace],
    pub(crate) lights: &'a [PlacedLight],
    pub(crate) ambient: [f32; 3],
    /// What each material's mirror term sees.
    pub(crate) environments: &'a [Environment],
    pub(crate) fog: Option<&'a Fog>,
    /// What each material reflects, where that is the same at all its points.
    pub(crate) uniform: &'a [Option<Coefficients<Uniform>>],
    /// Whether all blocks are plain.
    pub(crate) is_plain: bool,
    /// The viewing direction in world space.
    pub(crate) direction: DVec3,
    pub(crate) background: [f32; 4],
    /// Edges over the faces, with the polygons' edges of each instance.
    pub(crate) edges: Option<Edges>,
    pub(crate) edge_flags: &'a [Option<&'a EdgeFlags>],
    /// The object that each instance shows.
    pub(crate) objects: &'a [usize],
    /// Where light is computed, and how it gets to the pixels between.
    pub(crate) shading: Shading,
    pub(crate) encoding: PictureEncoding,
    /// The distance of the near plane.
    pub(crate) near: f64,
    /// The polygons of each instance's mesh, where shading asks for them.
    pub(crate) polygons: &'a [Option<&'a Polygons>],
    /// What subdividing took, by triangle.
    pub(crate) subdivided: &'a Mutex<HashMap<u32, PieceCount>>,
}

impl Scene16<'_> {
    /// What shines on a material.
    #[inline(always)]
    pub(crate) fn surroundings(&self, material: usize) -> Surroundings<'_> {
        Surroundings {
            lights: self.lights,
            scene_ambient: self.ambient,
            environment: self.environments[material],
            fog: self.fog,
        }
    }
}

/// What a thread keeps from block to block.
pub(crate) struct Kept {
    pub(crate) seen: SeenTriangles,
    pub(crate) gathered: Gathered,
    pub(crate) ready: Ready,
}

impl Kept {
    pub(crate) fn new() -> Self {
        Self { seen: SeenTriangles::new(), gathered: Gathered::new(), ready: Ready::new() }
    }
}

/// Sixteen samples to be lit: mostly one for each pixel of a block.
pub(crate) struct Batch {
    /// The first pixel of the block, or of the tile.
    pub(crate) origin: [i32; 2],
    /// What each sees.
    pub(crate) ids: [u32; LANES],
    /// Where each lies, in pixels from the corner of that.
    pub(crate) x: [f32; LANES],
    pub(crate) y: [f32; LANES],
}

impl Batch {
    /// One sample of each pixel of a block: for each an id and the number of the sample.
    #[inline(always)]
    pub(crate) fn new(
        tile: &Tile,
        block: usize,
        ids: [u32; LANES],
        sample: &[u32; LANES],
        samples: Samples,
    ) -> Self {
        let mut batch =
            Self { origin: block_origin(tile, block), ids, x: [0.0; LANES], y: [0.0; LANES] };
        let positions = samples.positions();
        for lane in 0..LANES {
            let position = positions[sample[lane] as usize & (positions.len() - 1)];
            batch.put(lane, position);
        }
        batch
    }

    /// The same sample of each pixel of a block.
    #[inline(always)]
    pub(crate) fn even(
        tile: &Tile,
        block: usize,
        ids: [u32; LANES],
        sample: u8,
        samples: Samples,
    ) -> Self {
        let mut batch =
            Self { origin: block_origin(tile, block), ids, x: [0.0; LANES], y: [0.0; LANES] };
        let position = samples.positions()[usize::from(sample)];
        for lane in 0..LANES {
            batch.put(lane, position);
        }
        batch
    }

    /// Nothing in any lane.
    pub(crate) fn nothing() -> Self {
        let (ids, nowhere) = ([TriangleId::NONE.0; LANES], [0.0; LANES]);
        Self { origin: [0; 2], ids, x: nowhere, y: nowhere }
    }

    /// Puts a sample of any pixel of a tile into a lane: where it lies in its block's lane, in steps of
    /// 1/256 pixel, and what it sees. All of a batch are of one tile.
    #[inline(always)]
    pub(crate) fn put_sample(
        &mut self,
        lane: usize,
        tile: &Tile,
        (block, within): (usize, usize),
        [x, y]: [i32; 2],
        id: u32,
    ) {
        self.origin = tile.origin();
        let [left, top] = block_corner(block);
        let (column, row) = (within as i32 % BLOCK, within as i32 / BLOCK);
        self.ids[lane] = id;
        self.x[lane] = ((left + column) * SUBPIXELS + x) as f32 / SUBPIXELS as f32;
        self.y[lane] = ((top + row) * SUBPIXELS + y) as f32 / SUBPIXELS as f32;
    }

    /// Puts a lane's sample at a place of its pixel, in steps of 1/256 pixel.
    #[inline(always)]
    fn put(&mut self, lane: usize, [x, y]: [i32; 2]) {
        let (column, row) = (lane as i32 % BLOCK, lane as i32 / BLOCK);
        self.x[lane] = (column * SUBPIXELS + x) as f32 / SUBPIXELS as f32;
        self.y[lane] = (row * SUBPIXELS + y) as f32 / SUBPIXELS as f32;
    }

    /// One of the samples alone, in the first lane.
    pub(crate) fn only(&self, lane: usize) -> Self {
        let mut alone = Self { ids: [TriangleId::NONE.0; LANES], ..*self };
        alone.ids[0] = self.ids[lane];
        alone.x[0] = self.x[lane];
        alone.y[0] = self.y[lane];
        alone
    }

    /// The positions of all samples in the window, in pixels.
    #[inline(always)]
    pub(crate) fn places<N: Number>(&self, like: N) -> [N::Wide; 2] {
        self.places_from(like, 0)
    }

    /// Those from lane `first` on.
    #[inline(always)]
    pub(crate) fn places_from<N: Number>(&self, like: N, first: usize) -> [N::Wide; 2] {
        let x = like.load(&self.x, first).widened();
        let y = like.load(&self.y, first).widened();
        [x + x.constant(self.origin[0].into()), y + y.constant(self.origin[1].into())]
    }

    /// The position of a lane's sample in the window, in pixels.
    pub(crate) fn position(&self, lane: usize) -> [f64; 2] {
        self.steps(lane).map(|steps| f64::from(steps) / f64::from(SUBPIXELS))
    }

    /// The position of a lane's sample, in steps of 1/256 pixel.
    pub(crate) fn steps(&self, lane: usize) -> [i32; 2] {
        let steps =
            |pixel: i32, inside: f32| pixel * SUBPIXELS + (inside * SUBPIXELS as f32) as i32;
        [steps(self.origin[0], self.x[lane]), steps(self.origin[1], self.y[lane])]
    }
}

/// The first pixel of a block.
#[inline(always)]
fn block_origin(tile: &Tile, block: usize) -> [i32; 2] {
    let [tile_x, tile_y] = tile.origin();
    let [left, top] = block_corner(block);
    [tile_x + left, tile_y + top]
}

/// The first pixel of a block, within its tile.
#[inline(always)]
fn block_corner(block: usize) -> [i32; 2] {
    let block = block as i32;
    [block % BLOCKS * BLOCK, block / BLOCKS * BLOCK]
}

/// Interpolates the surfaces that the samples see, into what was [`Interpolated::nothing`]: it is
/// too large to be handed over by value. Compiled once a kind of number, not into its callers.
#[inline(never)]
pub(crate) fn interpolate<N: Number>(
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
    interpolated: &mut Interpolated<N>,
) {
    interpolated.edge_distance.vectorized(
        #[inline(always)]
        || interpolate_lanes(scene, batch, kept, interpolated),
    );
}

#[inline(always)]
fn interpolate_lanes<N: Number>(
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
    interpolated: &mut Interpolated<N>,
) {
    let Kept { seen, gathered, .. } = kept;
    let like = interpolated.edge_distance;
    let [x, y] = batch.places(like);
    let all = like.all_lanes() & !like.lanes_equal(&batch.ids, TriangleId::NONE.0);
    let perspective = scene.shading.interpolation == Interpolation::Perspective;
    let at_pixels = scene.shading.mode == ShadingMode::Phong && perspective;
    if at_pixels && scene.edges.is_none() && has_many(like, &batch.ids, all) {
        let mut left = all;
        while left != 0 {
            // Nearly always all.
            let Some(of) = gathered.meet(like, scene, batch, left, Wanted::Everything) else {
                break;
            };
            interpolated.take(gathered, of);
            left &= !of.lanes;
        }
        return;
    }
    let mut left = all;
    while left != 0 {
        let id = batch.ids[left.trailing_zeros() as usize & (LANES - 1)];
        let lanes = like.lanes_equal(&batch.ids, id);
        left &= !lanes;
        let Some(triangle) = seen.get(scene, TriangleId(id)) else { continue };
        let forms = triangle.forms.in_lanes(x);
        // What the first triangle gives to lanes of others is overwritten, and nobody asks for the
        // rest.
        let or_more = if interpolated.seen == 0 { like.all_lanes() } else { lanes };
        let (mut here, outside) = forms.told(x, y);
        for lane in lanes_of(outside.bits() & lanes) {
            let [x, y] = batch.position(lane);
            put_lane(&mut here, lane, triangle.forms.nearest_on_edges(scene.frame.rays(), x, y));
        }
        merge(&mut interpolated.weights, here, like.mask_of(or_more));
        if scene.edges.is_some()
            && let Some(flags) = scene.edge_flags[triangle.of.instance]
        {
            let distance = edge_distance(&triangle.forms, flags.of(triangle.of.triangle), x, y);
            let mask = like.mask_of(lanes);
            interpolated.edge_distance = distance.select(mask, interpolated.edge_distance);
        }
        interpolated.put_material(lanes, triangle.material);
        interpolated.seen |= lanes;
        let varying = &mut interpolated.varying;
        if perspective {
            let has_uvs = triangle.has.uvs[0] | triangle.has.uvs[1];
            let [right, below] = if has_uvs { forms.beside(x, y) } else { [here; 2] };
            let weights = Weights { here, right, below };
            let lights = scene.shading.mode == ShadingMode::Gouraud;
            varying.take(&triangle.corners, &weights, triangle.has, lights, [lanes, or_more]);
        } else {
            slide(scene, batch, triangle, here, lanes, varying);
        }
        if triangle.has_own_light() {
            for lane in lanes_of(lanes) {
                varying.take_light(lane, triangle.own_light(lane_of(&here, lane)));
            }
        }
    }
}

/// Interpolates in the window, without perspective: sample by sample, as it is there to be studied.
#[inline(never)]
fn slide<N: Number>(
    scene: &Scene16<'_>,
    batch: &Batch,
    triangle: &SeenTriangle,
    here: [N; 3],
    lanes: u32,
    varying: &mut Varying<N>,
) {
    let lights = scene.shading.mode == ShadingMode::Gouraud;
    for lane in lanes_of(lanes) {
        let (corners, weights) = triangle.in_window(batch.position(lane), lane_of(&here, lane));
        let mut one = Varying::nothing(0.0_f32);
        one.take(&corners, &weights, triangle.has, lights, [1; 2]);
        varying.take_lane(lane, &one);
    }
}

/// The weights of one lane.
#[inline(always)]
fn lane_of<N: Number>([a, b, c]: &[N; 3], lane: usize) -> [f32; 3] {
    [a.lane(lane), b.lane(lane), c.lane(lane)]
}

/// Takes new values in one lane.
#[inline(always)]
pub(crate) fn put_lane<N: Number>(values: &mut [N; 3], lane: usize, new: [f32; 3]) {
    for (value, new) in values.iter_mut().zip(new) {
        *value = value.with_lane(lane, new);
    }
}

/// The colour (straight) and alpha of the samples; the background's where nothing is seen.
/// Compiled once a kind of number, not into its callers.
#[inline(never)]
pub(crate) fn shade<N: Number, W: SurfaceWitness<N>>(
    like: N,
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
    witness: &mut W,
) -> [N; 4] {
    like.vectorized(
        #[inline(always)]
        || shade_lanes(like, scene, batch, kept, witness),
    )
}

#[inline(always)]
fn shade_lanes<N: Number, W: SurfaceWitness<N>>(
    like: N,
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
    witness: &mut W,
) -> [N; 4] {
    let [r, g, b, alpha] = scene.background;
    let mut result = [like.constant(r), like.constant(g), like.constant(b), like.constant(alpha)];
    let mut interpolated = Interpolated::nothing(like);
    interpolate(scene, batch, kept, &mut interpolated);
    let point = surface::point(scene, interpolated.varying.position, interpolated.varying.normal);
    let mut left = interpolated.seen;
    while left != 0 {
        let material = interpolated.materials[left.trailing_zeros() as usize];
        let lanes = like.lanes_equal(&interpolated.materials, material) & interpolated.seen;
        let mask = like.mask_of(lanes);
        let number = material as usize;
        let varying = &interpolated.varying;
        let lit = if scene.shading.mode == ShadingMode::Phong {
            surface::lit(scene, varying, &point, number, lanes, witness)
        } else {
            surface::lit_elsewhere(scene, varying, &point, number, lanes, witness)
        };
        for (result, lit) in result.iter_mut().zip(lit) {
            *result = lit.select(mask, *result);
        }
        left &= !lanes;
    }
    if let Some(edges) = scene.edges {
        // An edge covers the pixels within half its width, and fades over one pixel more.
        let half = edges.width * 0.5 + 0.5;
        let faded = like.constant(half) - interpolated.edge_distance;
        let cover = faded.limited(0.0, 1.0);
        for (result, color) in result.iter_mut().zip(edges.color) {
            let over = *result + (like.constant(color) - *result) * cover;
            let seen = like.mask_of(interpolated.seen);
            *result = over.select(seen, *result);
        }
    }
    result
}
