//! Sixteen samples of a block into light.

use crate::corners::{Corners, lanes_of};
use crate::edges::{EdgeFlags, edge_distance};
use crate::pieces::PieceCount;
use crate::polygons::Polygons;
use crate::surface::{self, Interpolated, SurfaceWitness};
use crate::triangles::{Attributes, SeenTriangles, distinct};
use crate::vertex::VertexLight;
use crate::view::{Edges, Interpolation, Shading, ShadingMode};
use luxel_lighting::{Environment, Fog, PictureEncoding, PlacedLight, Surroundings};
use luxel_math::{LANES, Mask, Number, SUBPIXELS};
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
    pub(crate) corners: Corners,
    pub(crate) seen: SeenTriangles,
}

impl Kept {
    pub(crate) fn new(scene: &Scene16<'_>) -> Self {
        let attributes = Attributes::of(scene.scene);
        let lights = scene.shading.mode == ShadingMode::Gouraud;
        Self {
            corners: Corners::new(attributes, lights),
            seen: SeenTriangles::new(VertexLight::new(attributes)),
        }
    }
}

/// Sixteen samples to be lit, one for each pixel of a block.
pub(crate) struct Batch {
    /// The block's first pixel.
    pub(crate) origin: [i32; 2],
    /// What each sees.
    pub(crate) ids: [u32; LANES],
    /// Where each lies, in pixels from the block's corner.
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
        sample: &[u8; LANES],
        samples: Samples,
    ) -> Self {
        let [tile_x, tile_y] = tile.origin();
        let block = block as i32;
        let origin = [tile_x + block % BLOCKS * BLOCK, tile_y + block / BLOCKS * BLOCK];
        let mut batch = Self { origin, ids, x: [0.0; LANES], y: [0.0; LANES] };
        let positions = samples.positions();
        for lane in 0..LANES {
            let [x, y] = positions[usize::from(sample[lane]) & (positions.len() - 1)];
            let (column, row) = (lane as i32 % BLOCK, lane as i32 / BLOCK);
            batch.x[lane] = (column * SUBPIXELS + x) as f32 / SUBPIXELS as f32;
            batch.y[lane] = (row * SUBPIXELS + y) as f32 / SUBPIXELS as f32;
        }
        batch
    }

    /// One of the samples alone, in the first lane.
    pub(crate) fn only(&self, lane: usize) -> Self {
        let mut alone = Self { ids: [TriangleId::NONE.0; LANES], ..*self };
        alone.ids[0] = self.ids[lane];
        alone.x[0] = self.x[lane];
        alone.y[0] = self.y[lane];
        alone
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

/// Interpolates the surfaces that the samples see. Compiled once a kind of number, not into its
/// callers.
#[inline(never)]
pub(crate) fn interpolate<N: Number>(
    like: N,
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
) -> Interpolated<N> {
    like.vectorized(
        #[inline(always)]
        || interpolate_lanes(like, scene, batch, kept),
    )
}

#[inline(always)]
fn interpolate_lanes<N: Number>(
    like: N,
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
) -> Interpolated<N> {
    let Kept { corners, seen } = kept;
    let x = like.of_lanes(&batch.x);
    let y = like.of_lanes(&batch.y);
    let zero = like.zero();
    let mut interpolated = Interpolated {
        weights: [zero; 3],
        weights_right: [zero; 3],
        weights_below: [zero; 3],
        edge_distance: like.constant(f32::MAX),
        materials: [u32::MAX; LANES],
        seen: 0,
    };
    let one_triangle = batch.ids.iter().all(|id| *id == batch.ids[0]);
    let perspective = scene.shading.interpolation == Interpolation::Perspective;
    corners.reset(one_triangle && perspective);
    for (id, lanes) in distinct(&batch.ids) {
        let Some(triangle) = seen.get(scene, id) else { continue };
        let about = triangle.forms.about(batch.origin[0], batch.origin[1]);
        let mask = like.mask_of(lanes);
        let (mut weights, outside) = about.barycentric(x, y);
        let outside = outside.bits() & lanes;
        for lane in lanes_of(outside) {
            let nearest = triangle.forms.nearest_at(scene.frame.rays(), batch.steps(lane));
            for (weight, value) in weights.iter_mut().zip(nearest) {
                *weight = weight.with_lane(lane, value);
            }
        }
        merge(&mut interpolated.weights, weights, mask);
        if triangle.has.uvs[0] | triangle.has.uvs[1] {
            let right = normalized(about.weights(x + x.one(), y));
            let below = normalized(about.weights(x, y + y.one()));
            merge(&mut interpolated.weights_right, right, mask);
            merge(&mut interpolated.weights_below, below, mask);
        }
        if scene.edges.is_some()
            && let Some(flags) = scene.edge_flags[triangle.of.instance]
        {
            let distance = edge_distance(&about, flags.of(triangle.of.triangle), x, y);
            interpolated.edge_distance = distance.select(mask, interpolated.edge_distance);
        }
        for lane in lanes_of(lanes) {
            interpolated.materials[lane] = triangle.material;
        }
        interpolated.seen |= lanes;
        if perspective {
            corners.set(&triangle.corners, triangle.has, lanes);
        } else {
            for lane in lanes_of(lanes) {
                let barycentric = weights.map(
                    #[inline(always)]
                    |weight| weight.lane(lane),
                );
                let flat = triangle.in_window(batch.position(lane), barycentric);
                corners.set(&flat.corners, triangle.has, 1 << lane);
                put_lane(&mut interpolated.weights, lane, flat.weights);
                put_lane(&mut interpolated.weights_right, lane, flat.weights_right);
                put_lane(&mut interpolated.weights_below, lane, flat.weights_below);
            }
        }
        if triangle.has_own_light() {
            for lane in lanes_of(lanes) {
                let barycentric = weights.map(
                    #[inline(always)]
                    |weight| weight.lane(lane),
                );
                corners.set_light(lane, triangle.own_light(barycentric));
            }
        }
    }
    interpolated
}

/// Takes new values in one lane.
#[inline(always)]
fn put_lane<N: Number>(values: &mut [N; 3], lane: usize, new: [f32; 3]) {
    for (value, new) in values.iter_mut().zip(new) {
        *value = value.with_lane(lane, new);
    }
}

/// Takes new values where the mask is true.
#[inline(always)]
fn merge<N: Number>(values: &mut [N; 3], new: [N; 3], mask: N::Mask) {
    for (value, new) in values.iter_mut().zip(new) {
        *value = new.select(mask, *value);
    }
}

/// Weights that sum to 1, also outside of the triangle.
#[inline(always)]
fn normalized<N: Number>([a, b, c]: [N; 3]) -> [N; 3] {
    let scale = a.one() / (a + b + c);
    [a * scale, b * scale, c * scale]
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
    if batch.ids.iter().all(|id| *id == TriangleId::NONE.0) {
        return result;
    }
    let interpolated = interpolate(like, scene, batch, kept);
    let point = surface::point(scene, &interpolated, &kept.corners);
    let mut left = interpolated.seen;
    while left != 0 {
        let material = interpolated.materials[left.trailing_zeros() as usize];
        let mut lanes = 0;
        for (lane, other) in interpolated.materials.iter().enumerate() {
            lanes |= u32::from(*other == material) << lane;
        }
        let mask = like.mask_of(lanes);
        let number = material as usize;
        let corners = &kept.corners;
        let lit = if scene.shading.mode == ShadingMode::Phong {
            surface::lit(scene, &interpolated, corners, &point, number, lanes, witness)
        } else {
            surface::lit_elsewhere(scene, &interpolated, corners, &point, number, lanes, witness)
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
