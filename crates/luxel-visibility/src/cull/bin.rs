//! Which clusters each tile has to look at, near ones first.

use super::cluster_cull::VisibleCluster;
use crate::types::TILE;
use luxel_scene::Size;
use rayon::prelude::*;

/// The clusters that may be seen, nearest first, and for each tile which of them reach it.
#[derive(Debug, Default)]
pub(crate) struct Bins {
    clusters: Vec<VisibleCluster>,
    /// Where each tile's part of `entries` begins; one more than there are tiles.
    starts: Vec<u32>,
    /// Places in `clusters`, tile by tile, nearest first.
    entries: Vec<u32>,
    tiles_across: usize,
}

/// Entries of all tiles together, at most: 256 MiB. A picture that would need more has its tiles
/// look through all clusters instead.
const MAX_ENTRIES: u64 = 1 << 26;

impl Bins {
    pub(crate) fn new(clusters: Vec<VisibleCluster>, size: Size) -> Self {
        Self::with_entries(clusters, size, MAX_ENTRIES)
    }

    /// With `most` entries.
    fn with_entries(mut clusters: Vec<VisibleCluster>, size: Size, most: u64) -> Self {
        // Sixteen classes an octave of depth: near ones hide far ones well enough, and within a
        // class memory is read in order.
        const CLASS_SHIFT: u32 = 23 - 4;
        let key = |cluster: &VisibleCluster| {
            let class = cluster.nearest.max(0.0).to_bits() >> CLASS_SHIFT;
            (std::cmp::Reverse(class), cluster.cluster)
        };
        clusters.par_sort_unstable_by_key(key);

        let tiles_across = (size.width as usize).div_ceil(TILE as usize);
        let tiles_down = (size.height as usize).div_ceil(TILE as usize);
        let mut bins = Self { clusters, starts: Vec::new(), entries: Vec::new(), tiles_across };
        let entries: u64 = bins.clusters.iter().map(|cluster| tiles_of(cluster).count()).sum();
        if entries > most {
            return bins;
        }
        let mut starts = vec![0_u32; tiles_across * tiles_down + 1];
        for cluster in &bins.clusters {
            tiles_of(cluster).for_each(tiles_across, |tile| starts[tile + 1] += 1);
        }
        for tile in 1..starts.len() {
            starts[tile] += starts[tile - 1];
        }
        let mut next = starts.clone();
        bins.entries = vec![0; entries as usize];
        for (number, cluster) in (0..).zip(&bins.clusters) {
            tiles_of(cluster).for_each(tiles_across, |tile| {
                bins.entries[next[tile] as usize] = number;
                next[tile] += 1;
            });
        }
        bins.starts = starts;
        bins
    }

    /// The clusters that reach a tile, nearest first.
    pub(crate) fn of_tile(&self, tile: usize) -> impl Iterator<Item = &VisibleCluster> {
        let (listed, all): (&[u32], &[VisibleCluster]) = match self.starts.get(tile..tile + 2) {
            Some(ends) => (&self.entries[ends[0] as usize..ends[1] as usize], &[]),
            None => (&[], &self.clusters),
        };
        let (x, y) = ((tile % self.tiles_across) as u16, (tile / self.tiles_across) as u16);
        let reaching = all.iter().filter(move |cluster| tiles_of(cluster).contains(x, y));
        listed.iter().map(|&number| &self.clusters[number as usize]).chain(reaching)
    }

    /// How many clusters a tile has to look at: what its work is estimated by. 0 if none reaches it.
    pub(crate) fn load(&self, tile: usize) -> u32 {
        let all = self.clusters.len() as u32;
        self.starts.get(tile..tile + 2).map_or(all, |ends| ends[1] - ends[0])
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.clusters.is_empty()
    }
}

/// The tiles that a cluster reaches.
struct Tiles {
    left: u16,
    top: u16,
    right: u16,
    bottom: u16,
}

fn tiles_of(cluster: &VisibleCluster) -> Tiles {
    let tile = TILE as u16;
    Tiles {
        left: cluster.left / tile,
        top: cluster.top / tile,
        right: cluster.right / tile,
        bottom: cluster.bottom / tile,
    }
}

impl Tiles {
    fn count(&self) -> u64 {
        u64::from(self.right - self.left + 1) * u64::from(self.bottom - self.top + 1)
    }

    fn contains(&self, x: u16, y: u16) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    fn for_each(&self, tiles_across: usize, mut visit: impl FnMut(usize)) {
        for y in usize::from(self.top)..=usize::from(self.bottom) {
            for x in usize::from(self.left)..=usize::from(self.right) {
                visit(y * tiles_across + x);
            }
        }
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
        let listed = Bins::new(clusters.clone(), size);
        let looked_through = Bins::with_entries(clusters, size, 3);
        assert!(looked_through.starts.is_empty());
        for tile in 0..5 * 4 {
            let reaching = |bins: &Bins| bins.of_tile(tile).copied().collect::<Vec<_>>();
            assert_eq!(reaching(&listed), reaching(&looked_through));
            assert_eq!(listed.load(tile) == 0, reaching(&listed).is_empty());
            assert!(looked_through.load(tile) > 0, "tile {tile} would be left out");
        }
        assert_eq!(Bins::default().load(0), 0);
    }
}
