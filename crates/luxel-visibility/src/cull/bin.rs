//! Which clusters each tile has to look at, near ones first.

use super::cluster_cull::VisibleCluster;
use super::tile_lists::{TileLists, Tiles, nearest_first};
use crate::types::TILE;
use luxel_scene::Size;

/// The clusters that may be seen, nearest first, and for each tile which of them reach it.
#[derive(Debug)]
pub(crate) struct Bins {
    clusters: Vec<VisibleCluster>,
    /// Places in `clusters`; `None` where these were too many.
    lists: Option<TileLists>,
    tiles_across: usize,
}

/// Entries of all tiles together, at most: 256 MiB. A picture that would need more has its tiles
/// look through all clusters instead.
const MAX_ENTRIES: u64 = 1 << 26;

impl Bins {
    pub(crate) fn new(clusters: &[VisibleCluster], size: Size) -> Self {
        Self::with_entries(clusters, size, MAX_ENTRIES)
    }

    /// With `most` entries.
    fn with_entries(clusters: &[VisibleCluster], size: Size, most: u64) -> Self {
        let clusters = nearest_first(clusters, |cluster| cluster.nearest);
        let lists = TileLists::new(clusters.iter().map(VisibleCluster::tiles), size, most);
        Self { clusters, lists, tiles_across: (size.width as usize).div_ceil(TILE as usize) }
    }

    /// The clusters that reach a tile, nearest first.
    pub(crate) fn of_tile(&self, tile: usize) -> impl Iterator<Item = &VisibleCluster> {
        let (listed, all): (&[u32], &[VisibleCluster]) = match &self.lists {
            Some(lists) => (lists.of_tile(tile), &[]),
            None => (&[], &self.clusters),
        };
        let (x, y) = ((tile % self.tiles_across) as u16, (tile / self.tiles_across) as u16);
        let reaching = all.iter().filter(move |cluster| cluster.tiles().contains(x, y));
        listed.iter().map(|&number| &self.clusters[number as usize]).chain(reaching)
    }

    /// How many clusters a tile has to look at. 0 if none reaches it.
    pub(crate) fn load(&self, tile: usize) -> u32 {
        match &self.lists {
            Some(lists) => lists.of_tile(tile).len() as u32,
            None => self.clusters.len() as u32,
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.clusters.is_empty()
    }
}

impl VisibleCluster {
    /// The tiles that it reaches.
    pub(crate) fn tiles(&self) -> Tiles {
        Tiles::of_pixels([self.left, self.top, self.right, self.bottom])
    }

    /// What of it lies in some tiles; `None` if nothing does.
    pub(crate) fn within(self, tiles: Tiles) -> Option<Self> {
        let [left, top, right, bottom] = tiles.pixels();
        let (left, right) = (self.left.max(left), self.right.min(right));
        let (top, bottom) = (self.top.max(top), self.bottom.min(bottom));
        (left <= right && top <= bottom).then_some(Self { left, top, right, bottom, ..self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clusters_reach_the_same_tiles_where_entries_would_be_too_many() {
        let size = Size { width: 300, height: 200 };
        let cluster = |cluster: u32| {
            let left = (cluster * 37 % 280) as u16;
            let top = (cluster * 23 % 60) as u16;
            let (right, bottom) = (left + (cluster % 20) as u16, top + 40);
            let nearest = 1.0 / (1.0 + cluster as f32);
            VisibleCluster { cluster, left, top, right, bottom, nearest, clipped: false }
        };
        let clusters: Vec<_> = (0..20).map(cluster).collect();
        let listed = Bins::new(&clusters, size);
        let looked_through = Bins::with_entries(&clusters, size, 3);
        assert!(looked_through.lists.is_none());
        for tile in 0..5 * 4 {
            let reaching = |bins: &Bins| bins.of_tile(tile).copied().collect::<Vec<_>>();
            assert_eq!(reaching(&listed), reaching(&looked_through));
            assert_eq!(listed.load(tile) == 0, reaching(&listed).is_empty());
            assert!(looked_through.load(tile) > 0, "tile {tile} would be left out");
        }
        assert_eq!(Bins::new(&[], size).load(0), 0);
    }
}
