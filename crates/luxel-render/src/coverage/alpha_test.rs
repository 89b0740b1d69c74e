//! Where a covered sample is nevertheless not hit: texels cut away, surfaces that are wholly
//! transparent, the space between wires.

use super::edges::{EdgeFlags, edge_distance};

use luxel_math::{
    LANES, Lanes, Level, Mask, SplitLanes, dispatch_long, f32x16, lanes_of, prelude::*,
};
use luxel_scene::{AlphaMode, OpacityCorners, Scene};
use luxel_view::Edges;
use luxel_visibility::{Asked, Forms, Frame, Holes, LinearForms, PackedForms, TriangleId};
use std::cell::RefCell;

/// What cuts holes in the triangles of one frame.
pub(crate) struct AlphaTest<'a> {
    pub(crate) scene: &'a Scene,
    /// Wires, if only they are drawn.
    pub(crate) wires: Option<Edges>,
    /// The edges of polygons of each instance, if wires are drawn; points and lines have none.
    pub(crate) edge_flags: &'a [Option<&'a EdgeFlags>],
}

impl AlphaTest<'_> {
    /// Who tells one thread of holes.
    pub(crate) fn finder<'f>(&'f self, frame: &'f Frame<'f>, level: Level) -> AlphaTester<'f> {
        AlphaTester { cutouts: self, frame, level, kept: RefCell::new(Vec::new()) }
    }
}

/// Tells of holes, and keeps for the next samples what it knows of triangles.
pub(crate) struct AlphaTester<'f> {
    cutouts: &'f AlphaTest<'f>,
    frame: &'f Frame<'f>,
    level: Level,
    /// None before anybody asked.
    kept: RefCell<Vec<Kept>>,
}

/// How many triangles are kept: samples of up to sixteen are asked about together.
const KEPT: usize = 64;

/// A triangle that may have holes.
#[derive(Clone, Copy)]
struct Kept {
    id: TriangleId,
    /// `None` if its material makes no holes.
    material: Option<u32>,
    forms: PackedForms,
    corners: OpacityCorners,
}

impl Kept {
    fn nothing() -> Self {
        Self {
            id: TriangleId::NONE,
            material: None,
            forms: [[0.0; 4]; 3],
            corners: OpacityCorners::default(),
        }
    }
}

impl Holes for AlphaTester<'_> {
    fn holes(&self, asked: &Asked) -> u32 {
        let between_wires = self.cutouts.wires.map_or(0, |wires| self.beside(asked, wires.width));
        between_wires | self.cut_away(asked, asked.lanes & !between_wires)
    }
}

impl AlphaTester<'_> {
    /// The lanes, of those whose bit is set, where the material says that there is nothing.
    fn cut_away(&self, asked: &Asked, lanes: u32) -> u32 {
        let mut kept = self.kept.borrow_mut();
        if kept.is_empty() {
            kept.resize(KEPT, Kept::nothing());
        }
        let mut holes = 0;
        let mut left = lanes;
        while left != 0 {
            // Those of one material, whose triangles have places of their own.
            let mut taken = 0_u64;
            let mut places = [0; LANES];
            let mut material = None;
            let mut now = 0;
            for lane in lanes_of(left) {
                let id = asked.ids[lane];
                let place = id.0 as usize % KEPT;
                if kept[place].id != id {
                    if taken >> place & 1 == 1 {
                        continue;
                    }
                    kept[place] = self.known(id);
                }
                let Some(its) = kept[place].material else {
                    left &= !(1 << lane);
                    continue;
                };
                if *material.get_or_insert(its) != its {
                    continue;
                }
                taken |= 1 << place;
                places[lane] = place;
                now |= 1 << lane;
            }
            let Some(material) = material else { continue };
            left &= !now;
            let first = places[now.trailing_zeros() as usize];
            let mut rows = [&kept[first]; LANES];
            for lane in lanes_of(now) {
                rows[lane] = &kept[places[lane]];
            }
            let one = taken.is_power_of_two();
            let mut cut = Cut { finder: self, asked, lanes: now, rows, one, material, holes: 0 };
            at_lanes(self.level, now, &mut cut);
            holes |= cut.holes;
        }
        holes
    }

    /// What there is to know of a triangle.
    fn known(&self, id: TriangleId) -> Kept {
        let mut kept = Kept { id, ..Kept::nothing() };
        let Some(of) = self.frame.triangle(id) else { return kept };
        let mesh = self.frame.instances()[of.instance].mesh;
        let number = mesh.parts[of.part].material.index();
        let material = &self.cutouts.scene.materials[number];
        if material.alpha_mode != AlphaMode::Opaque {
            kept.material = Some(number as u32);
            kept.corners = OpacityCorners::new(mesh, of.triangle, material);
            self.frame.forms(of).linear().pack(|_, row, values| kept.forms[row] = values);
        }
        kept
    }

    /// The lanes whose samples are farther than half a wire's width from every edge of their
    /// polygons.
    fn beside(&self, asked: &Asked, width: f32) -> u32 {
        let mut beside = 0;
        let mut left = asked.lanes;
        while left != 0 {
            let id = asked.ids[left.trailing_zeros() as usize % LANES];
            let same = (0..LANES).filter(|&lane| asked.ids[lane] == id);
            let here = left & same.fold(0, |lanes, lane| lanes | 1 << lane);
            left &= !here;
            let Some(of) = self.frame.triangle(id) else {
                beside |= here;
                continue;
            };
            let Some(flags) = self.cutouts.edge_flags[of.instance] else { continue };
            let forms = self.frame.forms(of);
            let flags = flags.of(of.triangle);
            let mut wires = Wires { forms, flags, asked, lanes: here, width, beside: 0 };
            at_lanes(self.level, here, &mut wires);
            beside |= wires.beside;
        }
        beside
    }

    /// The barycentrics of the nearest place on a triangle's edges to a lane's sample.
    #[cold]
    fn nearest_on_edges(&self, asked: &Asked, lane: usize) -> [f32; 3] {
        let Some(of) = self.frame.triangle(asked.ids[lane]) else { return [0.0; 3] };
        let [x, y] = [asked.x[lane], asked.y[lane]].map(f64::from);
        self.frame.forms(of).nearest_on_edges(self.frame.rays(), x, y)
    }
}

/// Does work at these lanes: at one as one number, at several in lanes.
fn at_lanes(level: Level, lanes: u32, work: &mut impl SplitLanes) {
    if lanes.is_power_of_two() {
        work.part(0.0_f32, lanes.trailing_zeros() as usize % LANES);
    } else {
        dispatch_long!(level, simd => f32x16::splat(simd, 0.0).in_parts(work));
    }
}

/// Samples of one material, and where they are cut away.
struct Cut<'c> {
    finder: &'c AlphaTester<'c>,
    asked: &'c Asked,
    lanes: u32,
    rows: [&'c Kept; LANES],
    /// Whether all of them are of one triangle.
    one: bool,
    material: u32,
    holes: u32,
}

impl SplitLanes for Cut<'_> {
    #[inline(always)]
    fn part<N: Lanes>(&mut self, simd: N, first: usize) {
        let lanes = self.lanes >> first & simd.all_lanes();
        if lanes == 0 {
            return;
        }
        let Self { finder, asked, rows, .. } = *self;
        let wide = simd.to_f64();
        let row = &rows[first];
        let (forms, corners) = if self.one {
            (LinearForms::everywhere(wide, &row.forms), row.corners.everywhere(simd))
        } else {
            let forms = LinearForms::unpacked(
                wide,
                #[inline(always)]
                |lane| &rows[(first + lane) % LANES].forms,
            );
            let corners = OpacityCorners::in_lanes(
                simd,
                #[inline(always)]
                |lane| &rows[(first + lane) % LANES].corners,
            );
            (forms, corners)
        };
        let (x, y) = (simd.load(&asked.x, first).to_f64(), simd.load(&asked.y, first).to_f64());
        let (mut weights, outside) = forms.barycentrics(x, y);
        simd.visit(
            outside.bits() & lanes,
            #[inline(always)]
            |lane| {
                let nearest = finder.nearest_on_edges(asked, (first + lane) % LANES);
                for (weight, nearest) in weights.iter_mut().zip(nearest) {
                    *weight = weight.with_lane(lane, nearest);
                }
            },
        );
        let scene = finder.cutouts.scene;
        let material = &scene.materials[self.material as usize];
        self.holes |= scene.holes(material, &corners, weights, lanes) << first;
    }
}

/// Samples of one triangle, and which of them lie between wires.
struct Wires<'w> {
    forms: Forms,
    flags: u8,
    asked: &'w Asked,
    lanes: u32,
    width: f32,
    beside: u32,
}

impl SplitLanes for Wires<'_> {
    #[inline(always)]
    fn part<N: Lanes>(&mut self, simd: N, first: usize) {
        let [x, y] = [&self.asked.x, &self.asked.y].map(|at| simd.load(at, first).to_f64());
        let distance = edge_distance(&self.forms, self.flags, x, y);
        let beside = simd.constant(self.width * 0.5).less(distance);
        self.beside |= (beside.bits() << first) & self.lanes;
    }
}

#[cfg(test)]
mod tests;
