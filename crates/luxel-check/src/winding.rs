//! Winding of triangles, compared with their neighbours, their solid and their normals.

use crate::surface::{Edges, Surface, half_edge_of};
use luxel_scene::DVec3;

/// Faults of winding.
#[derive(Default)]
pub(crate) struct Winding {
    /// Triangles wound against most of their surface.
    pub(crate) inconsistent: Vec<u32>,
    /// Triangles whose front is inside their solid, or behind all of their normals.
    pub(crate) flipped: Vec<u32>,
    /// Half-edges at which a one-sided surface turns over.
    pub(crate) turnovers: Vec<u32>,
}

/// Union-find of triangles connected by edges of two triangles, each with its winding relative to the
/// set's root.
struct Sets {
    parent: Vec<u32>,
    /// Whether a triangle is wound against its parent.
    against: Vec<bool>,
}

impl Sets {
    fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect(), against: vec![false; count] }
    }

    /// The root, and whether the triangle is wound against it.
    fn find(&mut self, triangle: u32) -> (u32, bool) {
        // Finds the root, then compresses the path.
        let mut root = triangle;
        let mut against = false;
        while self.parent[root as usize] != root {
            against ^= self.against[root as usize];
            root = self.parent[root as usize];
        }
        let mut next = triangle;
        let mut rest = against;
        while self.parent[next as usize] != next {
            let up = self.parent[next as usize];
            let step = self.against[next as usize];
            self.parent[next as usize] = root;
            self.against[next as usize] = rest;
            rest ^= step;
            next = up;
        }
        (root, against)
    }

    /// Joins two neighbours; `false` if they are joined already with the opposite winding.
    fn join(&mut self, one: u32, other: u32, against: bool) -> bool {
        let (root, one_against) = self.find(one);
        let (other_root, other_against) = self.find(other);
        let between = one_against ^ other_against ^ against;
        if root == other_root {
            return !between;
        }
        // The lower index becomes the root, so that the order of joining doesn't matter.
        let (top, below) = (root.min(other_root), root.max(other_root));
        self.parent[below as usize] = top;
        self.against[below as usize] = between;
        true
    }
}

/// A connected surface.
#[derive(Clone, Default)]
struct Component {
    triangles: u64,
    against: u64,
    /// Half-edges without exactly one neighbour.
    open: u64,
    turns_over: bool,
    /// Six times the enclosed volume, by the majority's winding.
    volume: f64,
    /// The sum of magnitudes in `volume`, which bounds its rounding.
    size: f64,
    min: DVec3,
    max: DVec3,
}

/// Examines the winding. `normals` are those of each triangle's corners where the file has them.
pub(crate) fn examine(
    surface: &Surface<'_>,
    edges: &Edges,
    is_excluded: &[bool],
    normals: Option<&[[DVec3; 3]]>,
) -> Winding {
    let count = surface.triangles.len();
    let mut winding = Winding::default();
    let mut sets = Sets::new(count);
    let mut is_open = vec![false; count];
    for edge in edges.iter() {
        let [one, other] = *edge else {
            for side in edge {
                is_open[(half_edge_of(*side) / 3) as usize] = true;
            }
            continue;
        };
        let [one, other] = [one, other].map(half_edge_of);
        // Consistent neighbours traverse their edge in opposite directions.
        let against = surface.ends(one) == surface.ends(other);
        if !sets.join(one / 3, other / 3, against) {
            winding.turnovers.push(one.min(other));
        }
    }
    // Components are numbered in order of appearance.
    let mut number_of_root = vec![u32::MAX; count];
    let mut component_count = 0;
    let placed: Vec<(u32, bool)> = (0..count as u32)
        .map(|triangle| {
            let (root, against) = sets.find(triangle);
            let number = &mut number_of_root[root as usize];
            if *number == u32::MAX {
                *number = component_count;
                component_count += 1;
            }
            (*number, against)
        })
        .collect();
    let mut components = vec![Component::default(); component_count as usize];
    let kept = |triangle: &u32| !is_excluded[*triangle as usize];
    for half_edge in &winding.turnovers {
        components[placed[(half_edge / 3) as usize].0 as usize].turns_over = true;
    }
    for triangle in (0..count as u32).filter(kept) {
        let (root, against) = placed[triangle as usize];
        let component = &mut components[root as usize];
        if component.triangles == 0 {
            (component.min, component.max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        }
        component.triangles += 1;
        component.against += u64::from(against);
        component.open += u64::from(is_open[triangle as usize]);
        for corner in surface.corners(triangle) {
            component.min = component.min.min(corner);
            component.max = component.max.max(corner);
        }
    }
    let mut is_inconsistent = vec![false; count];
    for triangle in (0..count as u32).filter(kept) {
        let (root, against) = placed[triangle as usize];
        let component = &mut components[root as usize];
        // The majority is right; of two halves, the one with the lowest index.
        let majority_is_against = component.against * 2 > component.triangles;
        if !component.turns_over && against != majority_is_against {
            is_inconsistent[triangle as usize] = true;
            winding.inconsistent.push(triangle);
        }
        let middle = (component.min + component.max) * 0.5;
        let [a, b, c] = surface.corners(triangle).map(|corner| corner - middle);
        let volume = a.dot(b.cross(c));
        component.volume += if against == majority_is_against { volume } else { -volume };
        component.size += volume.abs();
    }
    let is_inside_out = inside_out(&components);
    let behind = |triangle: u32| {
        let face = surface.area_vector(triangle);
        let of = normals.map(|normals| &normals[triangle as usize]);
        of.is_some_and(|normals| normals.iter().all(|normal| normal.dot(face) < 0.0))
    };
    let is_flipped = |triangle: &u32| {
        let root = placed[*triangle as usize].0;
        // Triangles that disagree with their neighbours are reported already.
        !is_inconsistent[*triangle as usize] && (is_inside_out[root as usize] || behind(*triangle))
    };
    winding.flipped = (0..count as u32).filter(kept).filter(is_flipped).collect();
    winding
}

/// Which components are closed solids with their front inside, and not cavities of others.
fn inside_out(components: &[Component]) -> Vec<bool> {
    /// A volume below this fraction of its summands counts as zero: two coincident sheets enclose nothing.
    const LEAST: f64 = 1e-6;
    /// With more candidates, each is assumed to be a cavity instead of compared with all others.
    const MOST_COMPARED: usize = 512;
    let is_solid = |component: &Component| {
        component.triangles > 0 && component.open == 0 && !component.turns_over
    };
    let sign = |component: &Component| component.volume > LEAST * component.size;
    let right: Vec<&Component> =
        components.iter().filter(|component| is_solid(component) && sign(component)).collect();
    let is_cavity = |component: &Component| {
        right.len() > MOST_COMPARED
            || right.iter().any(|other| {
                other.min.cmple(component.min).all() && component.max.cmple(other.max).all()
            })
    };
    components
        .iter()
        .map(|component| {
            is_solid(component)
                && component.volume < -LEAST * component.size
                && !is_cavity(component)
        })
        .collect()
}
