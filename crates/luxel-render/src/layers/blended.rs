//! Terms of light where surfaces blend: each surface counts by its alpha and by what the surfaces before
//! it let through, as in the picture, so that the terms sum to the colour times alpha.

use super::elsewhere::terms_elsewhere;
use super::pass::{LayerWorker, Pass};
use super::planes::TileValues;
use super::witness::{LayerWitness, LightLanes};
use crate::frame::{ALL_BLOCKS, Worker};
use crate::interpolate::{Batch, nearest_sample};
use crate::shade::shade;
use luxel_math::{LANES, Simd, dispatch_long, f32x16, lanes_of, prelude::*};
use luxel_visibility::TriangleId;

/// What the samples of a tile see through all layers before it.
type Ids = Box<[[u32; LANES]; ALL_BLOCKS]>;

impl Pass<'_> {
    /// Draws the terms of a tile, over all its layers and what is opaque behind them.
    pub(super) fn draw_blended(&self, worker: &mut LayerWorker<'_>, tile: usize) {
        let level = self.renderer.level();
        let holes = self.alpha_test.finder(self.scene.frame, level);
        self.scene.frame.draw_opaque(level, tile, &holes, &mut worker.worker.opaque);
        let mut layers: Vec<Ids> = Vec::new();
        let listen =
            &mut |layer: &luxel_visibility::Tile| layers.push(layer.planes()[0].ids.clone());
        self.renderer.peel(self.scene, tile, &holes, &mut worker.worker, listen);
        dispatch_long!(level, simd => self.blend_tile(simd, worker, &layers));
    }

    #[inline(always)]
    fn blend_tile<S: Simd>(&self, simd: S, worker: &mut LayerWorker<'_>, layers: &[Ids]) {
        for block in 0..ALL_BLOCKS {
            self.fill_block(worker, block);
            let opaque = worker.worker.opaque.planes()[0].ids[block];
            let mut through = [1.0; LANES];
            for layer in layers {
                // Where there is no such layer, a tile keeps what is opaque.
                let mut ids = layer[block];
                for (id, opaque) in ids.iter_mut().zip(opaque) {
                    if *id == opaque {
                        *id = TriangleId::NONE.0;
                    }
                }
                self.add_surface(simd, worker, block, ids, &mut through);
            }
            self.add_surface(simd, worker, block, opaque, &mut through);
        }
    }

    /// Adds the terms of what the pixels of a block see, behind what lets this much of them `through`.
    #[inline(always)]
    fn add_surface<S: Simd>(
        &self,
        simd: S,
        worker: &mut LayerWorker<'_>,
        block: usize,
        ids: [u32; LANES],
        through: &mut [f32; LANES],
    ) {
        let vector = f32x16::splat(simd, 0.0);
        let lanes = !vector.eq_mask(&ids, TriangleId::NONE.0) & vector.all_lanes();
        if lanes == 0 {
            return;
        }
        let LayerWorker { worker, tiles, of_lights, .. } = worker;
        let Worker { opaque: tile, cache, .. } = &mut **worker;
        let within = nearest_sample(self.scene.frame.samples());
        let batch = Batch::even(tile, block, ids, within, false);
        of_lights.fill(LightLanes::NOTHING);
        let mut witness = LayerWitness::new(vector, [false, true], of_lights);
        let [.., alpha] = shade(vector, self.scene, &batch, cache, &mut witness);
        if self.is_lit_elsewhere {
            terms_elsewhere(self.scene, &batch, cache, lanes, &mut witness);
        }
        let mut weights = [0.0; LANES];
        for lane in lanes_of(lanes) {
            let alpha = alpha.lane(lane);
            weights[lane] = through[lane] * alpha;
            through[lane] *= 1.0 - alpha;
        }
        let seen = vector.mask_of(lanes);
        for (plane, values) in self.planes.iter().zip(tiles) {
            let TileValues::F32(values) = values else { continue };
            let mut terms = self.values(plane.layer, &witness, seen);
            for channel in &mut terms {
                for (term, weight) in channel.iter_mut().zip(weights) {
                    *term *= weight;
                }
            }
            plane.add_values(values, block, &terms);
        }
    }
}
