//! Lights pixels by the entry that they see.

use super::batch::{Batch, Piece, Prepared};
use super::framebuffer::{TilePlanes, block_origin};
use super::log::Item;
use super::shade::{Shading, encode, shade};
use super::tile::Entry;
use luxel_math::{LANES, Simd, lanes_of, mask32x16, prelude::*, u32x16};
use luxel_visibility::PackedForms;
use std::sync::Arc;

/// Finds what shades an entry; each is prepared once.
pub(super) struct Lighter<'a> {
    items: &'a [Item],
    list: &'a [Entry],
    /// Of each entry the place in `prepared`, from 1 on.
    places: Vec<u32>,
    pub(super) prepared: Vec<Prepared>,
    /// For textures.
    pub(super) rows: Vec<PackedForms>,
}

impl<'a> Lighter<'a> {
    pub(super) fn new(items: &'a [Item], list: &'a [Entry]) -> Self {
        Self { items, list, places: vec![0; list.len()], prepared: Vec::new(), rows: Vec::new() }
    }

    /// What reaches the tile.
    pub(super) fn list(&self) -> &'a [Entry] {
        self.list
    }

    /// The item of the log that an entry belongs to.
    pub(super) fn item(&self, entry: &Entry) -> &'a Item {
        &self.items[entry.item as usize]
    }

    fn batch(&self, number: u32) -> Option<(&'a Batch, &'a Piece)> {
        let entry = self.list.get((number as usize).wrapping_sub(1))?;
        match &self.items[entry.item as usize] {
            Item::Batch(batch) => Some((batch, &batch.pieces[entry.piece as usize])),
            Item::Clear(_) => None,
        }
    }

    /// Prepares an entry, and returns its place.
    pub(super) fn prepare(&mut self, number: u32) -> usize {
        let at = number as usize - 1;
        if self.places[at] == 0
            && let Some((batch, piece)) = self.batch(number)
        {
            self.prepared.push(batch.prepare(piece, &mut self.rows));
            self.places[at] = self.prepared.len() as u32;
        }
        (self.places[at] as usize).saturating_sub(1)
    }
}

/// Lights what the pixels of a block see, each lane by its own primitive, and forgets it.
#[inline(never)]
pub(super) fn light_seen<S: Simd>(
    simd: S,
    origin: [i32; 2],
    block: usize,
    seen: &mut [u32; LANES],
    lighter: &mut Lighter<'_>,
    planes: &mut TilePlanes,
) {
    simd.vectorize(
        #[inline(always)]
        || {
            let mut left = 0;
            for lane in 0..LANES {
                left |= u32::from(seen[lane] != 0) << lane;
            }
            let [x, y] = block_origin(block);
            let place = [origin[0] + x, origin[1] + y];
            // Lanes of one pipeline together: nearly always all of them.
            while left != 0 {
                let leader = left.trailing_zeros() as usize & (LANES - 1);
                let Some((first, _)) = lighter.batch(seen[leader]) else { return };
                let mut together = 0;
                let mut alike = true;
                let mut places = [0; LANES];
                places[leader] = lighter.prepare(seen[leader]);
                for lane in lanes_of(left) {
                    let same = seen[lane] == seen[leader];
                    let belongs = same
                        || lighter.batch(seen[lane]).is_some_and(|(batch, _)| {
                            Arc::ptr_eq(&batch.pipeline, &first.pipeline)
                        });
                    if belongs {
                        together |= 1 << lane;
                        alike &= same;
                        places[lane] =
                            if same { places[leader] } else { lighter.prepare(seen[lane]) };
                    }
                }
                for lane in 0..LANES {
                    if together >> lane & 1 == 0 {
                        places[lane] = places[leader];
                    }
                }
                left &= !together;
                let prepared = &lighter.prepared;
                let shading = Shading {
                    textures: first.pipeline.textures.as_ref(),
                    rows: &lighter.rows,
                    fog: first.pipeline.fog.as_ref(),
                    primary: None,
                    lanes: together,
                };
                let colors = shade(
                    simd,
                    place,
                    #[inline(always)]
                    |lane| &prepared[places[lane & (LANES - 1)]],
                    alike,
                    shading,
                );
                let stored = u32x16::from_slice(simd, &planes.color[block]);
                let mask = mask32x16::from_bitmask(simd, u64::from(together));
                mask.select(encode(colors), stored).store_slice(&mut planes.color[block]);
            }
            *seen = [0; LANES];
        },
    );
}
