//! Pieces into areas of one colour, in an order that puts what is nearer on top, and without seams.
//!
//! An area grows from a piece over those neighbours that may be painted at the same time and whose
//! colours stay within the tolerance. Programs that draw vectors blend an edge's pixels with what
//! is there already, so that two areas that merely abut let a hairline of the background through.
//! So an area reaches up to a pixel further under each neighbour that is painted after it; outlines
//! against what lies behind stay where they are. Neighbours may be narrower than that, so areas are
//! painted upon coats: all that hangs together in its mean colour, and upon that, what is of roughly
//! one colour. What shines through between areas is then nearly their own colour.

use super::flatten::Piece;
use super::order::Order;
use super::web::{Color, Map, Mixing, Place, Web};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// How far an area reaches under what is painted after it, in pixels: what a pixel can be across.
const UNDER: f64 = 1.0;

/// An area of one colour.
pub(super) struct Area {
    /// Closed outlines, in pixels.
    pub(super) outlines: Vec<Vec<Place>>,
    /// In steps of 8 bits.
    pub(super) color: Color,
}

/// How far apart colours of one coat may be: anything, then so many times what an area may hold.
const COATS: [f32; 3] = [f32::INFINITY, 12.0, 1.0];

struct Painter<'a> {
    web: &'a Web,
    pieces: &'a [Piece],
    /// The piece to the right of each way from point to point.
    right_of: Map<[u32; 2], u32>,
    /// For each of the coats, and last the areas: the number of each piece's; 0 for none yet.
    groups: [Vec<u32>; COATS.len()],
    /// How many groups there are.
    count: u32,
    largest_range: f32,
}

/// Colours of pieces: the least and the greatest, and their sum.
struct Colors {
    low: Color,
    high: Color,
    sum: [f64; 4],
}

/// Which faces may be painted: those with nothing left to be painted before them.
struct Schedule {
    order: Order,
    /// Pieces of each face that aren't painted.
    left: Vec<u32>,
    /// The first piece of each face; those of one follow one another.
    first: Vec<u32>,
    ready: Vec<bool>,
    /// Pieces of faces that are ready, the first of the scene on top; all before one are painted.
    next: BinaryHeap<Reverse<u32>>,
}

impl Schedule {
    fn new(order: Order, pieces: &[Piece]) -> Self {
        let count = order.before.len();
        let mut schedule = Self {
            order,
            left: vec![0; count],
            first: vec![0; count],
            ready: vec![false; count],
            next: BinaryHeap::new(),
        };
        for (number, piece) in (0..).zip(pieces) {
            let face = piece.face as usize;
            if schedule.left[face] == 0 {
                schedule.first[face] = number;
            }
            schedule.left[face] += 1;
        }
        let free: Vec<u32> =
            (0..count as u32).filter(|&face| schedule.order.before[face as usize] == 0).collect();
        schedule.open(free);
        schedule
    }

    /// Makes faces ready, and those that only waited for faces without pieces.
    fn open(&mut self, mut faces: Vec<u32>) {
        while let Some(face) = faces.pop() {
            self.ready[face as usize] = true;
            if self.left[face as usize] > 0 {
                self.next.push(Reverse(self.first[face as usize]));
            } else {
                self.finish(face, &mut faces);
            }
        }
    }

    /// A face is painted: what only waited for it may follow.
    fn finish(&mut self, face: u32, opened: &mut Vec<u32>) {
        for &next in &self.order.later[face as usize] {
            let before = &mut self.order.before[next as usize];
            *before -= 1;
            if *before == 0 {
                opened.push(next);
            }
        }
    }

    /// The first piece that may be painted.
    fn seed(&mut self, groups: &[u32], pieces: &[Piece]) -> Option<u32> {
        while let Some(Reverse(piece)) = self.next.pop() {
            let following = piece + 1;
            let same_face = pieces
                .get(following as usize)
                .is_some_and(|next| next.face == pieces[piece as usize].face);
            if same_face {
                self.next.push(Reverse(following));
            }
            if groups[piece as usize] == 0 {
                return Some(piece);
            }
        }
        None
    }
}

/// Paints pieces, which stand in the order of their faces; gives each area as it is done.
pub(super) fn paint(
    web: &Web,
    pieces: &[Piece],
    order: Order,
    largest_range: f32,
    mut done: impl FnMut(&Area),
) {
    let mut right_of = Map::with_capacity_and_hasher(3 * pieces.len(), Mixing::default());
    let mut around = Vec::new();
    for (number, piece) in (0..).zip(pieces) {
        web.around(&piece.polygon, &mut around);
        for at in 0..around.len() {
            right_of.entry([around[at], around[(at + 1) % around.len()]]).or_insert(number);
        }
    }
    let groups = std::array::from_fn(|_| vec![0; pieces.len()]);
    let mut painter = Painter { web, pieces, right_of, groups, count: 0, largest_range };
    let mut schedule = Schedule::new(order, pieces);
    while let Some(seed) = schedule.seed(&painter.groups[0], pieces) {
        let (members, coat) = painter.coat(seed, 0, &schedule.ready);
        coat.iter().for_each(&mut done);
        let mut opened = Vec::new();
        for &member in &members {
            let face = pieces[member as usize].face;
            schedule.left[face as usize] -= 1;
            if schedule.left[face as usize] == 0 {
                schedule.finish(face, &mut opened);
            }
        }
        schedule.open(opened);
    }
}

impl Painter<'_> {
    /// The pieces of a coat, and what is painted for them: the coat, unless it is of one area, and
    /// the areas upon it.
    fn coat(&mut self, seed: u32, level: usize, ready: &[bool]) -> (Vec<u32>, Vec<Area>) {
        let (members, colors) = self.grow(seed, level, ready);
        let is_area = level + 1 == COATS.len();
        let opaque = self.is_opaque(seed);
        let color = std::array::from_fn(|at| {
            if is_area {
                (colors.low[at] + colors.high[at]) * 0.5
            } else {
                (colors.sum[at] / members.len() as f64) as f32
            }
        });
        let own = Area { outlines: self.outlines(&members, opaque), color };
        if is_area {
            return (members, vec![own]);
        }
        let mut areas = Vec::new();
        for &member in &members {
            if self.groups[level + 1][member as usize] == 0 {
                areas.extend(self.coat(member, level + 1, ready).1);
            }
        }
        if areas.len() > 1 && opaque {
            areas.insert(0, own);
        }
        (members, areas)
    }

    /// Takes a piece and those neighbours that belong into one group with it.
    fn grow(&mut self, seed: u32, level: usize, ready: &[bool]) -> (Vec<u32>, Colors) {
        let pieces = self.pieces;
        let largest_range = self.largest_range * COATS[level];
        let Piece { low, high, .. } = pieces[seed as usize];
        let mut colors = Colors { low, high, sum: [0.0; 4] };
        self.count += 1;
        let (group, opaque) = (self.count, self.is_opaque(seed));
        self.groups[level][seed as usize] = group;
        let mut members = vec![seed];
        let mut at = 0;
        let mut around = Vec::new();
        while let Some(&member) = members.get(at) {
            at += 1;
            let piece = &pieces[member as usize];
            for channel in 0..4 {
                colors.sum[channel] += f64::from(piece.low[channel] + piece.high[channel]) * 0.5;
            }
            self.web.around(&piece.polygon, &mut around);
            for corner in 0..around.len() {
                let way = [around[(corner + 1) % around.len()], around[corner]];
                let Some(&other) = self.right_of.get(&way) else { continue };
                let piece = &pieces[other as usize];
                let may = match level.checked_sub(1) {
                    None => ready[piece.face as usize] && self.is_opaque(other) == opaque,
                    Some(coat) => {
                        let coat = &self.groups[coat];
                        coat[other as usize] == coat[seed as usize]
                    }
                };
                if self.groups[level][other as usize] != 0 || !may {
                    continue;
                }
                let low: Color = std::array::from_fn(|at| colors.low[at].min(piece.low[at]));
                let high: Color = std::array::from_fn(|at| colors.high[at].max(piece.high[at]));
                if (0..4).all(|at| high[at] - low[at] <= largest_range) {
                    (colors.low, colors.high) = (low, high);
                    self.groups[level][other as usize] = group;
                    members.push(other);
                }
            }
        }
        (members, colors)
    }

    fn is_opaque(&self, piece: u32) -> bool {
        self.pieces[piece as usize].low[3] >= 254.5
    }

    /// The outlines of an area.
    fn outlines(&self, members: &[u32], opaque: bool) -> Vec<Vec<Place>> {
        let mut ways: Vec<[u32; 2]> = Vec::new();
        let mut around = Vec::new();
        for &member in members {
            self.web.around(&self.pieces[member as usize].polygon, &mut around);
            ways.extend((0..around.len()).map(|at| [around[at], around[(at + 1) % around.len()]]));
        }
        ways.sort_unstable();
        // Ways that two members go in opposite directions lie inside.
        let mut taken = vec![false; ways.len()];
        for at in 0..ways.len() {
            let [from, to] = ways[at];
            if from < to && !taken[at] {
                let back = ways.partition_point(|way| *way < [to, from]);
                let free = (back..ways.len()).take_while(|&back| ways[back] == [to, from]);
                if let Some(back) = { free }.find(|&back| !taken[back]) {
                    taken[at] = true;
                    taken[back] = true;
                }
            }
        }
        let mut outlines = Vec::new();
        for start in 0..ways.len() {
            if taken[start] {
                continue;
            }
            let mut outline = Vec::new();
            let mut at = start;
            loop {
                taken[at] = true;
                outline.push(ways[at]);
                let [_, to] = ways[at];
                let next = ways.partition_point(|way| *way < [to, 0]);
                let leaving = (next..ways.len()).take_while(|&next| ways[next][0] == to);
                match { leaving }.find(|&next| !taken[next]) {
                    Some(next) => at = next,
                    None => break,
                }
            }
            outlines.push(self.outline(&outline, opaque));
        }
        outlines
    }

    /// An outline's places, moved under what is painted later.
    ///
    /// The result is the outline, and a strip along each such way, all of them winding the same way
    /// round, so that nowhere do they take each other away.
    fn outline(&self, ways: &[[u32; 2]], opaque: bool) -> Vec<Place> {
        let under: Vec<Option<[Place; 2]>> =
            ways.iter().map(|&way| self.under(way).filter(|_| opaque)).collect();
        let mut places = Vec::with_capacity(ways.len() + 4);
        for at in 0..ways.len() {
            let before = (at + ways.len() - 1) % ways.len();
            let [x, y] = self.web.place(ways[at][0]);
            let moved = |[dx, dy]: Place| [x + dx, y + dy];
            let end = under[before].map(|[_, end]| end);
            let start = under[at].map(|[start, _]| start);
            match (end, start) {
                (None, None) => places.push([x, y]),
                (Some(end), None) => places.extend([moved(end), [x, y]]),
                (None, Some(start)) => places.extend([[x, y], moved(start)]),
                (Some(end), Some(start)) => {
                    places.push(moved(end));
                    // Straight on over an outer corner; into an inner one and out again.
                    if end[0] * start[1] - end[1] * start[0] < -1e-9 {
                        places.push([x, y]);
                    }
                    places.push(moved(start));
                }
            }
        }
        places
    }

    /// Whether a piece will be painted over what is painted now.
    fn is_later(&self, piece: u32) -> bool {
        self.groups[COATS.len() - 1][piece as usize] == 0 && self.is_opaque(piece)
    }

    /// Where the ends of a way go to lie under the piece beyond it, if that is painted later: along
    /// that piece's own edges.
    fn under(&self, [from, to]: [u32; 2]) -> Option<[Place; 2]> {
        let piece = *self.right_of.get(&[to, from])?;
        if !self.is_later(piece) {
            return None;
        }
        let mut around = Vec::new();
        self.web.around(&self.pieces[piece as usize].polygon, &mut around);
        let count = around.len();
        let at = (0..count).find(|&at| around[at] == to && around[(at + 1) % count] == from)?;
        let ([ax, ay], [bx, by]) = (self.web.place(from), self.web.place(to));
        let (dx, dy) = (bx - ax, by - ay);
        let length = (dx * dx + dy * dy).sqrt();
        if length < 1e-9 {
            return None;
        }
        // To the left of the way, which is where the piece lies.
        let (nx, ny) = (dy / length, -dx / length);
        let away = |origin: Place, next: u32, [away_x, away_y]: Place| {
            let [x, y] = self.web.place(next);
            let (ux, uy) = (x - origin[0], y - origin[1]);
            let size = (ux * ux + uy * uy).sqrt().max(f64::MIN_POSITIVE);
            let (ux, uy) = (ux / size, uy / size);
            let sine = ux * nx + uy * ny;
            if sine < 1e-3 && ux * away_x + uy * away_y > 0.0 {
                // The piece goes on beyond the end of the way: straight into it.
                let reach = UNDER.min(self.depth_of(&around, origin, [nx, ny]));
                return [nx * reach, ny * reach];
            }
            let reach = (UNDER / sine.max(0.25)).min(size);
            [ux * reach, uy * reach]
        };
        let (before, after) = (around[(at + count - 1) % count], around[(at + 2) % count]);
        Some([away([ax, ay], after, [-dx, -dy]), away([bx, by], before, [dx, dy])])
    }

    /// How far a piece goes from a place on its edge.
    fn depth_of(&self, around: &[u32], [x, y]: Place, [dx, dy]: Place) -> f64 {
        let mut depth = f64::INFINITY;
        for at in 0..around.len() {
            let [[ax, ay], [bx, by]] =
                [around[at], around[(at + 1) % around.len()]].map(|point| self.web.place(point));
            // Inside is to the right of each edge.
            let (ex, ey) = (bx - ax, by - ay);
            let towards = ex * dy - ey * dx;
            if towards < 0.0 {
                let distance = ex * (y - ay) - ey * (x - ax);
                depth = depth.min((distance / -towards).max(0.0));
            }
        }
        if depth.is_finite() { depth } else { 0.0 }
    }
}
