//! Which triangles meet where.

use crate::Mesh;
use luxel_parallel::{fill, sort_u128};

/// The corners that meet at each place of a mesh.
///
/// A *place* is a position, or several with equal coordinates: files split positions at seams of
/// their texture coordinates, and some (STL) give every triangle its own. Nothing is assumed of
/// the mesh; edges may have any number of faces.
///
/// Corner k of triangle t has the number 3 t + k.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Topology {
    places: Vec<u32>,
    starts: Vec<u32>,
    corners: Vec<u32>,
}

impl Topology {
    /// Finds the places of a mesh and sorts its corners by them, in order of their numbers.
    /// Triangles whose corners' numbers don't fit into 32 bits are left out.
    #[must_use]
    pub fn of(mesh: &Mesh) -> Self {
        let places = weld(&mesh.positions);
        let most = (u32::MAX / 3) as usize;
        let triangles = &mesh.triangles[..mesh.triangles.len().min(most)];
        // A counting sort: how many corners, where each place's begin, then each into its place.
        let mut starts = vec![0_u32; mesh.positions.len() + 1];
        for &position in triangles.as_flattened() {
            starts[places[position as usize] as usize + 1] += 1;
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut corners = vec![0; triangles.len() * 3];
        let mut next = starts.clone();
        for (corner, &position) in triangles.as_flattened().iter().enumerate() {
            let slot = &mut next[places[position as usize] as usize];
            corners[*slot as usize] = corner as u32;
            *slot += 1;
        }
        Self { places, starts, corners }
    }

    /// The place of a position: the first position with the same coordinates.
    ///
    /// # Panics
    /// If the mesh has no such position.
    #[must_use]
    #[inline]
    pub fn place(&self, position: u32) -> u32 {
        self.places[position as usize]
    }

    /// The corners at a place, in order; none for a position that is not a place.
    ///
    /// # Panics
    /// If the mesh has no such position.
    #[must_use]
    #[inline]
    pub fn corners_at(&self, place: u32) -> &[u32] {
        let place = place as usize;
        &self.corners[self.starts[place] as usize..self.starts[place + 1] as usize]
    }

    /// Where each position's corners begin in the list of all of them, and where the last ones end.
    pub(crate) fn starts(&self) -> &[u32] {
        &self.starts
    }
}

/// For each position the first one with the same coordinates; 0 and -0 are the same.
#[must_use]
pub fn weld(positions: &[[f32; 3]]) -> Vec<u32> {
    weld_by_hashing(positions).unwrap_or_else(|| weld_by_sorting(positions))
}

/// The bits of a position, equal for equal coordinates.
fn bits([x, y, z]: [f32; 3]) -> [u32; 3] {
    [x, y, z].map(|value| (value + 0.0).to_bits())
}

/// In one pass; `None` where positions get into each other's way more than chance would have it, as
/// a file made for that could bring about.
fn weld_by_hashing(positions: &[[f32; 3]]) -> Option<Vec<u32>> {
    const EMPTY: u32 = u32::MAX;
    /// Looks at a slot, for each position: with every other slot empty it takes two.
    const MOST_LOOKS: usize = 8;
    let slots = (positions.len() * 2).next_power_of_two().max(2);
    let mut firsts = vec![EMPTY; slots];
    let mut looks_left = positions.len().saturating_mul(MOST_LOOKS);
    let mut places = Vec::with_capacity(positions.len());
    for (number, &position) in (0..).zip(positions) {
        let key @ [x, y, z] = bits(position);
        // Multiplicative hashing (Knuth, volume 3, section 6.4) of three words.
        let mixed = (u64::from(x) | u64::from(y) << 32).wrapping_mul(0x9e37_79b9_7f4a_7c15)
            ^ u64::from(z).wrapping_mul(0xd6e8_feb8_6659_fd93);
        let hash = (mixed ^ mixed >> 32).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut slot = (hash >> (u64::BITS - slots.ilog2())) as usize;
        let place = loop {
            looks_left = looks_left.checked_sub(1)?;
            let first = &mut firsts[slot & (slots - 1)];
            if *first == EMPTY {
                *first = number;
                break number;
            }
            if bits(positions[*first as usize]) == key {
                break *first;
            }
            slot += 1;
        };
        places.push(place);
    }
    Some(places)
}

/// In time that no file can spoil.
fn weld_by_sorting(positions: &[[f32; 3]]) -> Vec<u32> {
    // Coordinates and number in one key: sorting brings equal places together, the first in front.
    let mut keys = vec![0; positions.len()];
    fill(&mut keys, 1 << 12, &|start, run| {
        for ((number, position), key) in (start..).zip(&positions[start..]).zip(run) {
            let [x, y, z] = bits(*position).map(u128::from);
            *key = x << 96 | y << 64 | z << 32 | number as u128;
        }
    });
    sort_u128(&mut keys);
    let mut places = vec![0; positions.len()];
    let mut first = 0;
    let mut last_coordinates = None;
    for key in keys {
        if last_coordinates != Some(key >> 32) {
            last_coordinates = Some(key >> 32);
            first = key as u32;
        }
        places[key as u32 as usize] = first;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn split_positions_are_one_place() {
        let positions = vec![
            [1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [-0.0, 0.0, -0.0],
            [1.0, 0.0, 0.0],
            [0.0, 0.0, 1e-30],
        ];
        assert_eq!(weld(&positions), [0, 1, 2, 1, 0, 5]);
        assert_eq!(weld_by_sorting(&positions), [0, 1, 2, 1, 0, 5]);
        let triangles = vec![[0, 1, 2], [3, 4, 5]];
        let topology = Topology::of(&Mesh { positions, triangles, ..Mesh::default() });
        assert_eq!(topology.corners_at(0), [0, 4]);
        assert_eq!(topology.corners_at(1), [1, 3]);
        assert_eq!(topology.corners_at(3), []);
        assert_eq!(topology.corners_at(5), [5]);
        assert_eq!(topology.place(3), 1);
    }

    #[test]
    fn hashing_and_sorting_find_the_same_places() {
        let numbers = |number: u32| {
            let mixed = number.wrapping_mul(2_654_435_769) >> 16;
            [mixed % 37, mixed % 11, number % 5].map(|value| value as f32 * 0.1)
        };
        let mut positions: Vec<[f32; 3]> = (0..20_000).map(numbers).collect();
        positions.extend([[f32::NAN; 3], [f32::INFINITY; 3], [f32::NAN; 3]]);
        assert_eq!(weld_by_hashing(&positions).unwrap(), weld_by_sorting(&positions));
    }

    #[test]
    fn an_empty_mesh_has_no_places() {
        assert_eq!(Topology::of(&Mesh::default()).starts(), [0]);
    }
}
