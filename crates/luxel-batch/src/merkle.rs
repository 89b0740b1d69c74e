//! The Merkle tree hash of RFC 6962, section 2.1, over digests.

use crate::Digest;

/// Begins the hash of a leaf.
const LEAF: &[u8] = &[0];
/// Begins the hash of an inner node.
const NODE: &[u8] = &[1];

/// The root of the tree over the sorted digests: of whatever order they come in, the same.
#[must_use]
pub fn root(digests: impl IntoIterator<Item = Digest>) -> Digest {
    let mut digests: Vec<Digest> = digests.into_iter().collect();
    digests.sort_unstable();
    let mut tree = Tree::default();
    digests.iter().for_each(|digest| tree.push(digest.as_bytes()));
    tree.root()
}

/// A tree that grows leaf by leaf, and keeps only the roots of its whole subtrees.
#[derive(Debug, Default)]
pub(crate) struct Tree {
    /// Roots of subtrees with a power of two of leaves, each smaller than the one before, and the power.
    subtrees: Vec<(Digest, u32)>,
}

impl Tree {
    /// Adds a leaf behind all others.
    pub(crate) fn push(&mut self, leaf: &[u8]) {
        let mut added = (Digest::of_parts(&[LEAF, leaf]), 0);
        while let Some(&(before, power)) = self.subtrees.last()
            && power == added.1
        {
            self.subtrees.pop();
            added = (node(&before, &added.0), power + 1);
        }
        self.subtrees.push(added);
    }

    /// The root: the largest power of two of leaves stays on the left, at every node.
    pub(crate) fn root(&self) -> Digest {
        let roots = self.subtrees.iter().rev().map(|(root, _)| *root);
        roots.reduce(|right, left| node(&left, &right)).unwrap_or_else(|| Digest::of(b""))
    }
}

fn node(left: &Digest, right: &Digest) -> Digest {
    Digest::of_parts(&[NODE, left.as_bytes(), right.as_bytes()])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The leaves of Certificate Transparency's reference tests, and the root of the first 1, 2, ... of them.
    const LEAVES: [&[u8]; 8] = [
        &[],
        &[0x00],
        &[0x10],
        &[0x20, 0x21],
        &[0x30, 0x31],
        &[0x40, 0x41, 0x42, 0x43],
        &[0x50, 0x51, 0x52, 0x53, 0x54, 0x55, 0x56, 0x57],
        &[
            0x60, 0x61, 0x62, 0x63, 0x64, 0x65, 0x66, 0x67, 0x68, 0x69, 0x6a, 0x6b, 0x6c, 0x6d,
            0x6e, 0x6f,
        ],
    ];
    const ROOTS: [&str; 8] = [
        "6e340b9cffb37a989ca544e6bb780a2c78901d3fb33738768511a30617afa01d",
        "fac54203e7cc696cf0dfcb42c92a1d9dbaf70ad9e621f4bd8d98662f00e3c125",
        "aeb6bcfe274b70a14fb067a5e5578264db0fa9b51af5e0ba159158f329e06e77",
        "d37ee418976dd95753c1c73862b9398fa2a2cf9b4ff0fdfe8b30cd95209614b7",
        "4e3bbb1f7b478dcfe71fb631631519a3bca12c9aefca1612bfce4c13a86264d4",
        "76e67dadbcdf1e10e1b74ddc608abd2f98dfb16fbce75277b5232a127f2087ef",
        "ddb89be403809e325750d3d263cd78929c2942b7942a34b77e122c9594a74c8c",
        "5dc9da79a70659a9ad559cb701ded9a2ab9d823aad2f4960cfe370eff4604328",
    ];

    #[test]
    fn the_trees_of_certificate_transparency_have_their_roots() {
        let mut tree = Tree::default();
        assert_eq!(tree.root(), Digest::of(b""));
        for (leaf, root) in LEAVES.iter().zip(ROOTS) {
            tree.push(leaf);
            assert_eq!(tree.root().to_string(), root);
        }
    }

    /// The definition of the RFC, word for word.
    fn by_definition(leaves: &[Digest]) -> Digest {
        match leaves {
            [] => Digest::of(b""),
            [leaf] => Digest::of_parts(&[&[0], leaf.as_bytes()]),
            leaves => {
                let split = leaves.len().next_power_of_two() / 2;
                let (left, right) = leaves.split_at(split);
                let [left, right] = [by_definition(left), by_definition(right)];
                Digest::of_parts(&[&[1], left.as_bytes(), right.as_bytes()])
            }
        }
    }

    #[test]
    fn trees_of_every_size_have_the_root_of_the_definition_in_any_order() {
        let mut sorted = Vec::new();
        for count in 0..130_u32 {
            let backwards = sorted.iter().rev().copied();
            assert_eq!(root(backwards), by_definition(&sorted), "{count} leaves");
            sorted.push(Digest::of(&count.to_le_bytes()));
            sorted.sort_unstable();
        }
    }

    #[test]
    fn an_output_that_is_listed_twice_counts_twice() {
        let [one, other] = [Digest::of(b"1"), Digest::of(b"2")];
        assert_ne!(root([one, other]), root([one, one, other]));
    }
}
