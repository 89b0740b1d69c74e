//! Pieces into areas of one colour, in an order that puts what is nearer on top, and without seams.
//!
//! An area grows from a piece over those neighbours that may be painted at the same time and whose
//! colours stay within the tolerance. Programs that draw vectors blend each pixel of an edge by the
//! part that is covered, as if the parts of different paths had nothing to do with one another. So
//! areas that merely abut let a hairline of what lies behind through, and what is painted twice up to an
//! edge looks heavier there than it is.
//!
//! - Where areas abut, what is painted first reaches a pixel further, under what is painted later.
//! - Areas may be narrower than that, so they are painted upon coats: all that hangs together in its
//!   mean colour, and upon that, what is of roughly one colour. Coats end before the outline.
//! - What shows the background beyond is cut out by the silhouette, once. Below everything lie a mean
//!   colour, and along outlines a line in the colour of each area, so that nothing lighter mixes in.

use super::flatten::Piece;
use super::order::Order;
use super::schedule::Schedule;
use super::ways::{Way, Ways, rings};
use super::web::{Color, Map, Place, Web};

/// How far an area reaches under what is painted after it, in pixels: what a pixel can be across.
pub(super) const UNDER: f64 = 1.0;

/// An area of one colour.
pub(super) struct Area {
    /// Closed outlines, in pixels.
    pub(super) outlines: Vec<Vec<Place>>,
    /// Where its surface ends: lines along the outlines, if it is opaque.
    pub(super) rims: Vec<Vec<Place>>,
    /// In steps of 8 bits.
    pub(super) color: Color,
}

/// How far from the ends of a way, in pixels, the first of those places between them lies at which is
/// asked how far to go.
const ENDS: f64 = 2.0;

/// The most pieces that an area reaches under at one place.
const MOST_UNDER: usize = 64;

/// What is covered, whatever covers it.
pub(super) struct Silhouette {
    /// By what hides all behind it.
    pub(super) opaque: Vec<Vec<Place>>,
    /// By the rest.
    pub(super) glass: Vec<Vec<Place>>,
    /// The mean colour of what is opaque.
    pub(super) color: Color,
}

/// How far apart colours of one coat may be: anything, then so many times what an area may hold.
const COATS: [f32; 3] = [f32::INFINITY, 12.0, 1.0];

/// How a way goes to lie under what is beyond it.
struct Under {
    /// How far its ends are moved.
    start: Place,
    end: Place,
    /// Places of the moved way between them.
    between: Vec<Place>,
}

struct Painter<'a> {
    web: &'a Web,
    pieces: &'a [Piece],
    ways: &'a Ways,
    /// For each of the coats, and last the areas: the number of each piece's; 0 for none yet.
    groups: [Vec<u32>; COATS.len()],
    /// How many groups there are.
    count: u32,
    /// For each cell of the window, the last group whose border it is near.
    borders: Map<[u32; 2], u32>,
    largest_range: f32,
}

/// Colours of pieces: the least and the greatest, and their sum.
struct Colors {
    low: Color,
    high: Color,
    sum: [f64; 4],
}

/// Paints pieces, which stand in the order of their faces; gives each area as it is done.
pub(super) fn paint(
    web: &Web,
    pieces: &[Piece],
    order: Order,
    largest_range: f32,
    mut done: impl FnMut(&Area),
) -> Silhouette {
    let ways = &Ways::new(web, pieces);
    let groups = std::array::from_fn(|_| vec![0; pieces.len()]);
    let borders = Map::default();
    let mut painter = Painter { web, pieces, ways, groups, count: 0, borders, largest_range };
    let silhouette = painter.silhouette();
    let mut schedule = Schedule::new(order, pieces);
    while let Some(seed) = schedule.seed(&painter.groups[0], pieces) {
        let (members, coat) = painter.coat(seed, 0, &schedule.ready);
        coat.iter().for_each(&mut done);
        schedule.painted(&members, pieces);
    }
    silhouette
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
        if is_area {
            let rings = rings(self.ways, &members);
            let outlines = rings.iter().map(|ring| self.outline(ring, opaque)).collect();
            let rims = if opaque { self.rims(&rings) } else { Vec::new() };
            return (members, vec![Area { outlines, rims, color }]);
        }
        let within = if opaque { self.within(&members, level) } else { Vec::new() };
        let outlines =
            rings(self.ways, &within).iter().map(|ring| self.outline(ring, true)).collect();
        let own = Area { outlines, rims: Vec::new(), color };
        let mut areas = Vec::new();
        for &member in &members {
            if self.groups[level + 1][member as usize] == 0 {
                areas.extend(self.coat(member, level + 1, ready).1);
            }
        }
        if areas.len() > 1 && !own.outlines.is_empty() {
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
        while let Some(&member) = members.get(at) {
            at += 1;
            let piece = &pieces[member as usize];
            for channel in 0..4 {
                colors.sum[channel] += f64::from(piece.low[channel] + piece.high[channel]) * 0.5;
            }
            for other in self.ways.around(member).iter().filter_map(|way| way.beyond()) {
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

    /// The members of a coat that don't lie along its border, within two pixels of it. Pixels of the
    /// border are covered by a part; the coat, which reaches under what is left out, would cover that
    /// part twice.
    fn within(&mut self, members: &[u32], level: usize) -> Vec<u32> {
        let group = members.first().map_or(0, |&member| self.groups[level][member as usize]);
        for way in members.iter().flat_map(|&member| self.ways.around(member)) {
            let is_inside = way.beyond().is_some_and(|beyond| {
                self.groups[level][beyond as usize] == group || self.is_later(beyond)
            });
            if is_inside {
                continue;
            }
            for [x, y] in cells_along(way.ends(self.web)) {
                for y in y.saturating_sub(1)..=y + 1 {
                    for x in x.saturating_sub(1)..=x + 1 {
                        self.borders.insert([x, y], group);
                    }
                }
            }
        }
        // Long pieces that only end at the border are not left out: little of them is near.
        let is_near = |member: u32| {
            let (mut near, mut all) = (0, 0);
            for way in self.ways.around(member) {
                for cell in cells_along(way.ends(self.web)) {
                    near += u32::from(self.borders.get(&cell) == Some(&group));
                    all += 1;
                }
            }
            near * 2 > all
        };
        members.iter().copied().filter(|&member| !is_near(member)).collect()
    }

    fn is_opaque(&self, piece: u32) -> bool {
        self.pieces[piece as usize].low[3] >= 254.5
    }

    /// The runs of ways beyond which there is no piece.
    fn rims(&self, rings: &[Vec<Way>]) -> Vec<Vec<Place>> {
        let mut rims: Vec<Vec<Place>> = Vec::new();
        for ring in rings {
            let mut goes_on = false;
            for way in ring {
                let is_rim = way.beyond().is_none();
                match rims.last_mut().filter(|_| goes_on) {
                    Some(rim) if is_rim => rim.push(self.web.place(way.to)),
                    _ if is_rim => {
                        rims.push(way.ends(self.web).to_vec());
                    }
                    _ => {}
                }
                goes_on = is_rim;
            }
        }
        rims
    }

    /// What all opaque pieces cover together, and what the others do.
    fn silhouette(&self) -> Silhouette {
        let all = 0..self.pieces.len() as u32;
        let outlines = |members: Vec<u32>| -> Vec<Vec<Place>> {
            let place = |way: &Way| self.web.place(way.from);
            rings(self.ways, &members).iter().map(|ring| ring.iter().map(place).collect()).collect()
        };
        let (opaque, glass): (Vec<u32>, Vec<u32>) = all.partition(|&piece| self.is_opaque(piece));
        let mut color = [0.0; 4];
        for &piece in &opaque {
            let Piece { low, high, .. } = &self.pieces[piece as usize];
            for at in 0..4 {
                color[at] += (low[at] + high[at]) * 0.5 / opaque.len() as f32;
            }
        }
        Silhouette { opaque: outlines(opaque), glass: outlines(glass), color }
    }

    /// An outline's places, moved under what is painted later.
    ///
    /// The result is the outline, and a strip along each such way, all of them winding the same way
    /// round, so that nowhere do they take each other away.
    fn outline(&self, ways: &[Way], opaque: bool) -> Vec<Place> {
        let under: Vec<Option<Under>> =
            ways.iter().map(|&way| self.under(way).filter(|_| opaque)).collect();
        let mut places = Vec::with_capacity(ways.len() + 4);
        for at in 0..ways.len() {
            let before = (at + ways.len() - 1) % ways.len();
            let [x, y] = self.web.place(ways[at].from);
            let moved = |[dx, dy]: Place| [x + dx, y + dy];
            let end = under[before].as_ref().map(|under| under.end);
            let start = under[at].as_ref().map(|under| under.start);
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
            places.extend(under[at].iter().flat_map(|under| &under.between));
        }
        places
    }

    /// Whether a piece will be painted over what is painted now.
    fn is_later(&self, piece: u32) -> bool {
        self.groups[COATS.len() - 1][piece as usize] == 0 && self.is_opaque(piece)
    }

    /// Where the ends of a way go to lie under what is beyond it, if that is painted later: along
    /// the edges of the piece there.
    fn under(&self, way: Way) -> Option<Under> {
        let Way { from, to, .. } = way;
        let piece = way.beyond()?;
        if !self.is_later(piece) {
            return None;
        }
        let around = self.ways.around(piece);
        let count = around.len();
        let at = around.iter().position(|back| (back.from, back.to) == (to, from))?;
        let [[ax, ay], [bx, by]] = way.ends(self.web);
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
            // Where the piece goes on beyond the end of the way: straight into it.
            let beyond = sine < 1e-3 && ux * away_x + uy * away_y > 0.0;
            let ([ux, uy], most) =
                if beyond { ([nx, ny], UNDER) } else { ([ux, uy], UNDER / sine.max(0.25)) };
            let reach = self.reach(piece, origin, [ux, uy], most);
            [ux * reach, uy * reach]
        };
        let (before, after) = (around[(at + count - 1) % count].from, around[(at + 1) % count].to);
        let (start, end) = (away([ax, ay], after, [-dx, -dy]), away([bx, by], before, [dx, dy]));
        // Ever farther from the ends, where outlines hold it back.
        let steps = std::iter::successors(Some(ENDS / length), |part| Some(part * 2.0));
        let first: Vec<f64> = steps.take_while(|part| *part < 0.5).collect();
        let middle = (length > 1.0).then_some(0.5);
        let last = first.iter().rev().map(|part| 1.0 - part);
        let parts = first.iter().copied().chain(middle).chain(last);
        let inwards = |part: f64| {
            let place = [ax + dx * part, ay + dy * part];
            let reach = self.reach(piece, place, [nx, ny], UNDER);
            [place[0] + nx * reach, place[1] + ny * reach]
        };
        Some(Under { start, end, between: parts.map(inwards).collect() })
    }

    /// How far a way into a piece leads through that piece and others that are painted later.
    fn reach(&self, mut piece: u32, origin: Place, [dx, dy]: Place, most: f64) -> f64 {
        let mut reached = 0.0;
        let mut place = None;
        for _ in 0..MOST_UNDER {
            let around = self.ways.around(piece);
            // Ways along an edge keep to the side on which they began.
            let [x, y] = *place.get_or_insert_with(|| {
                let share = 1.0 / around.len() as f64;
                let middle = around.iter().fold([0.0; 2], |[x, y], way| {
                    let [px, py] = self.web.place(way.from);
                    [x + px * share, y + py * share]
                });
                [0, 1].map(|axis| origin[axis] + (middle[axis] - origin[axis]) * 1e-3)
            });
            let mut leaves = (f64::INFINITY, None);
            for way in around {
                let [[ax, ay], [bx, by]] = way.ends(self.web);
                // Inside is to the right of each edge.
                let (ex, ey) = (bx - ax, by - ay);
                let towards = ex * dy - ey * dx;
                if towards < 0.0 {
                    let distance = (ex * (y - ay) - ey * (x - ax)) / -towards;
                    if distance < leaves.0 {
                        leaves = (distance.max(reached), way.beyond());
                    }
                }
            }
            let (distance, beyond) = leaves;
            if distance >= most || distance.is_infinite() {
                return most.min(distance.max(0.0));
            }
            reached = distance;
            match beyond {
                Some(next) if self.is_later(next) => piece = next,
                // At an outline, what reaches there is painted twice.
                _ => return (2.0 * reached - most).max(0.0),
            }
        }
        reached
    }
}

/// The cells of two by two pixels along a way, looked at every pixel.
fn cells_along([[ax, ay], [bx, by]]: [Place; 2]) -> impl Iterator<Item = [u32; 2]> {
    let (dx, dy) = (bx - ax, by - ay);
    let steps = (dx * dx + dy * dy).sqrt().ceil().max(1.0);
    (0..=steps as u32).map(move |step| {
        let part = f64::from(step) / steps;
        [(ax + dx * part) * 0.5, (ay + dy * part) * 0.5].map(|side| side.max(0.0) as u32)
    })
}
