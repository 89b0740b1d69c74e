//! Ids of triangles in a frame.

/// Bits of a triangle's slot number in an id.
pub(crate) const SLOT_BITS: u32 = 7;

/// The triangle that a sample sees.
///
/// Its number is the cluster's among those of all instances, times 128, plus the triangle's slot;
/// [`Frame`](crate::Frame) turns it into instance and triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TriangleId(pub u32);

impl TriangleId {
    /// Nothing: the background.
    pub const NONE: Self = Self(u32::MAX);

    pub(crate) const fn new(cluster: u32, slot: usize) -> Self {
        Self(cluster << SLOT_BITS | slot as u32)
    }

    pub(crate) const fn cluster(self) -> u32 {
        self.0 >> SLOT_BITS
    }

    pub(crate) const fn slot(self) -> usize {
        (self.0 & ((1 << SLOT_BITS) - 1)) as usize
    }
}
