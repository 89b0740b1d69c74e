//! Lights pixels by the entry that they see.

use super::batch::{Batch, Prepared};
use super::log::Item;
use super::pieces::{Piece, Pieces};
use super::shade::{Shading, encode, shade};
use super::tile::Entry;
use crate::plane::{Blocks, block_origin};
use luxel_math::{LANES, Simd, mask32x16, prelude::*, u32x16};
use luxel_visibility::PackedForms;
use std::sync::Arc;

/// What shades the entries of a tile's list that are seen.
#[derive(Debug, Default)]
pub(super) struct PreparedEntries {
    /// Of each entry the place in `all`, from 1 on.
    places: Vec<u32>,
    all: Vec<Prepared>,
    /// For textures.
    rows: Vec<PackedForms>,
}

/// Finds what shades an entry; each is prepared once.
pub(super) struct Lighter<'a> {
    items: &'a [Item],
    list: &'a [Entry],
    pub(super) prepared: PreparedEntries,
}

impl<'a> Lighter<'a> {
    pub(super) fn new(items: &'a [Item], list: &'a [Entry], mut prepared: PreparedEntries) -> Self {
        prepared.places.clear();
        prepared.places.resize(list.len(), 0);
        prepared.all.clear();
        prepared.rows.clear();
        Self { items, list, prepared }
    }

    /// What shades the entry at a place.
    pub(super) fn at(&self, place: usize) -> &Prepared {
        &self.prepared.all[place]
    }

    /// Rows for textures, of all that is prepared.
    pub(super) fn rows(&self) -> &[PackedForms] {
        &self.prepared.rows
    }

    /// What reaches the tile.
    pub(super) fn list(&self) -> &'a [Entry] {
        self.list
    }

    /// The item of the log that an entry belongs to.
    pub(super) fn item(&self, entry: &Entry) -> &'a Item {
        &self.items[entry.item as usize]
    }

    fn batch(&self, number: u32) -> Option<&'a Batch> {
        self.piece(number).map(|(batch, ..)| batch)
    }

    /// Whether an entry goes through a batch's pipeline, as `leader` does, which is of the batch.
    #[inline]
    fn is_of_pipeline(&self, number: u32, leader: u32, batch: &Batch) -> bool {
        let [own, other] = [number, leader].map(|number| self.list[number as usize - 1].item);
        own == other
            || self.batch(number).is_some_and(|own| Arc::ptr_eq(&own.pipeline, &batch.pipeline))
    }

    fn piece(&self, number: u32) -> Option<(&'a Batch, &'a Pieces, &'a Piece)> {
        let entry = self.list.get((number as usize).wrapping_sub(1))?;
        match &self.items[entry.item as usize] {
            Item::Batch(batch, pieces) => {
                Some((batch, pieces, &pieces.list()[entry.piece as usize]))
            }
            Item::Clear(_) => None,
        }
    }

    /// Prepares an entry, and returns its place.
    #[inline]
    pub(super) fn prepare(&mut self, number: u32) -> usize {
        let at = number as usize - 1;
        if self.prepared.places[at] == 0 {
            self.prepare_anew(number);
        }
        (self.prepared.places[at] as usize).saturating_sub(1)
    }

    /// Prepares the entries of those lanes that go through the first one's pipeline.
    #[inline(always)]
    pub(super) fn prepare_lanes<S: Simd>(
        &mut self,
        simd: S,
        numbers: &[u32; LANES],
        lanes: u32,
    ) -> Option<PreparedLanes<'a>> {
        let all = u32x16::from_slice(simd, &numbers[..]);
        let leader = numbers[lanes.trailing_zeros() as usize & (LANES - 1)];
        let batch = self.batch(leader)?;
        let first_place = self.prepare(leader) as u32;
        let mut places = u32x16::splat(simd, first_place);
        let (mut together, mut alike) = (0, true);
        let mut others = lanes;
        while others != 0 {
            let number = numbers[others.trailing_zeros() as usize & (LANES - 1)];
            let own = all.simd_eq(u32x16::splat(simd, number));
            let of_number = own.to_bitmask() as u32;
            others &= !of_number;
            if self.is_of_pipeline(number, leader, batch) {
                let place = self.prepare(number) as u32;
                alike &= place == first_place;
                places = own.select(u32x16::splat(simd, place), places);
                together |= of_number;
            }
        }
        let mut of = [0; LANES];
        places.store_slice(&mut of);
        Some(PreparedLanes { batch, lanes: together, alike, places: of })
    }

    /// What shades each lane.
    #[inline(always)]
    pub(super) fn of_lanes(&self, lanes: &PreparedLanes<'a>) -> [&Prepared; LANES] {
        let all = &self.prepared.all;
        let mut prepared = [&all[lanes.places[0] as usize]; LANES];
        if !lanes.alike {
            for (prepared, place) in prepared.iter_mut().zip(lanes.places) {
                *prepared = &all[place as usize];
            }
        }
        prepared
    }

    #[inline(never)]
    fn prepare_anew(&mut self, number: u32) {
        let Some((batch, pieces, piece)) = self.piece(number) else { return };
        let PreparedEntries { places, all, rows } = &mut self.prepared;
        all.push(Prepared::default());
        places[number as usize - 1] = all.len() as u32;
        if let Some(prepared) = all.last_mut() {
            batch.prepare(piece, pieces.shape(piece), rows, prepared);
        }
    }
}

/// The lanes that have an entry, a bit each.
#[inline(always)]
pub(super) fn lanes_with_entry<S: Simd>(numbers: u32x16<S>) -> u32 {
    (!numbers.simd_eq(0)).to_bitmask() as u32
}

/// Lanes of one pipeline.
pub(super) struct PreparedLanes<'a> {
    /// The first one's.
    batch: &'a Batch,
    /// A bit each.
    lanes: u32,
    /// Whether all are of one entry.
    pub(super) alike: bool,
    /// Where each is prepared; those that aren't among the lanes have the first one's.
    places: [u32; LANES],
}

/// Lights what the pixels of a block see, each lane by its own primitive, and forgets it.
#[inline(never)]
pub(super) fn light_seen<S: Simd>(
    simd: S,
    origin: [i32; 2],
    block: usize,
    seen: &mut [u32; LANES],
    lighter: &mut Lighter<'_>,
    color: &mut Blocks<u32>,
) {
    simd.vectorize(
        #[inline(always)]
        || {
            let mut left = lanes_with_entry(u32x16::from_slice(simd, &seen[..]));
            let [x, y] = block_origin(block);
            let first_pixel = [origin[0] + x, origin[1] + y];
            // Lanes of one pipeline together: nearly always all of them.
            while left != 0 {
                let Some(group) = lighter.prepare_lanes(simd, seen, left) else { return };
                left &= !group.lanes;
                let prepared = lighter.of_lanes(&group);
                let pipeline = &*group.batch.pipeline;
                let shading = Shading {
                    textures: pipeline.textures.as_ref(),
                    rows: lighter.rows(),
                    fog: pipeline.fog.as_ref(),
                    primary: None,
                    lanes: group.lanes,
                };
                let colors = shade(
                    simd,
                    first_pixel,
                    #[inline(always)]
                    |lane| prepared[lane & (LANES - 1)],
                    group.alike,
                    shading,
                );
                let stored = u32x16::from_slice(simd, &color[block]);
                let mask = mask32x16::from_bitmask(simd, u64::from(group.lanes));
                mask.select(encode(colors), stored).store_slice(&mut color[block]);
            }
            *seen = [0; LANES];
        },
    );
}
