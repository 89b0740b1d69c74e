//! Polygons in the window that share points and lines, so that what abuts can be told from what
//! only lies near.
//!
//! Every edge of a polygon lies on a line between two points. Cutting a polygon puts a new point on
//! two lines; other polygons on those lines learn of it when their outlines are asked for. So no
//! corner of one polygon lies on another's edge without being a point of it.

use crate::vector::primitives::twice_area;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// A place in the window, in pixels from the upper left.
pub(super) type Place = [f64; 2];

/// Colour and alpha in steps of 8 bits, encoded.
pub(super) type Color = [f32; 4];

/// A table by our own numbers, that is looked into but never walked through.
pub(super) type Map<K, V> = HashMap<K, V, Mixing>;
/// Several times as fast as the standard's hash, which is for keys that others choose.
pub(super) type Mixing = BuildHasherDefault<Mixer>;

/// Multiplies and turns, word by word.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Mixer(u64);

impl Hasher for Mixer {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for bytes in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..bytes.len()].copy_from_slice(bytes);
            let mixed = (self.0 ^ u64::from_le_bytes(word)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            self.0 = mixed ^ (mixed >> 32);
        }
    }
}

/// Points of a line that lie nearer than this, in pixels, are one.
const SAME: f64 = 1e-6;

/// A corner of a polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    pub(super) point: u32,
    /// The line that holds the edge to the next corner.
    pub(super) line: u32,
    pub(super) color: Color,
}

/// A convex polygon; it runs clockwise to the eye.
pub(super) type Polygon = Vec<Corner>;

struct Line {
    ends: [u32; 2],
    /// Points between the ends, with their parts of the way, in order.
    between: Vec<(f64, u32)>,
}

/// All points and lines.
#[derive(Default)]
pub(super) struct Web {
    points: Vec<Place>,
    lines: Vec<Line>,
    by_place: HashMap<[u64; 2], u32>,
    by_ends: Map<[u32; 2], u32>,
}

impl Web {
    pub(super) fn place(&self, point: u32) -> Place {
        self.points[point as usize]
    }

    /// The corners' places.
    pub(super) fn places<'a>(
        &'a self,
        polygon: &'a [Corner],
    ) -> impl Iterator<Item = Place> + Clone + 'a {
        polygon.iter().map(|corner| self.place(corner.point))
    }

    /// A polygon between places, turned clockwise; `None` if it has no area to speak of.
    pub(super) fn polygon(&mut self, places: &[Place]) -> Option<Polygon> {
        let mut points: Vec<u32> = Vec::with_capacity(places.len());
        for &[x, y] in places {
            // Zero has two signs.
            let place = [x + 0.0, y + 0.0];
            let number = self.points.len() as u32;
            let point = *self.by_place.entry(place.map(f64::to_bits)).or_insert(number);
            if point == number {
                self.points.push(place);
            }
            if !points.contains(&point) {
                points.push(point);
            }
        }
        let area = twice_area(points.iter().map(|&point| self.place(point)));
        if points.len() < 3 || area.abs() < 1e-9 {
            return None;
        }
        if area < 0.0 {
            points.reverse();
        }
        Some(self.between_points(&points, &[[0.0; 4]; 16]))
    }

    /// The polygon between points, with their colours.
    pub(super) fn between_points(&mut self, points: &[u32], colors: &[Color]) -> Polygon {
        let count = points.len();
        let mut polygon = Vec::with_capacity(count);
        for at in 0..count {
            let line = self.line(points[at], points[(at + 1) % count]);
            let color = colors.get(at).copied().unwrap_or_default();
            polygon.push(Corner { point: points[at], line, color });
        }
        polygon
    }

    fn line(&mut self, from: u32, to: u32) -> u32 {
        let number = self.lines.len() as u32;
        let ends = [from.min(to), from.max(to)];
        let line = *self.by_ends.entry(ends).or_insert(number);
        if line == number {
            self.lines.push(Line { ends, between: Vec::new() });
        }
        line
    }

    /// The part of a line's way at which a place lies.
    fn part(&self, line: u32, [x, y]: Place) -> (f64, f64) {
        let [[ax, ay], [bx, by]] = self.lines[line as usize].ends.map(|end| self.place(end));
        let (dx, dy) = (bx - ax, by - ay);
        let squared = dx * dx + dy * dy;
        (((x - ax) * dx + (y - ay) * dy) / squared.max(f64::MIN_POSITIVE), squared.sqrt())
    }

    /// The point of a line at a place, known or new.
    fn point_on(&mut self, line: u32, place: Place) -> u32 {
        let (part, length) = self.part(line, place);
        let same = SAME / length.max(SAME);
        let Line { ends, between } = &self.lines[line as usize];
        if part <= same {
            return ends[0];
        }
        if part >= 1.0 - same {
            return ends[1];
        }
        let at = between.partition_point(|(other, _)| *other < part);
        let near = between[at.saturating_sub(1)..].iter().take(2);
        if let Some((_, known)) = near.clone().find(|(other, _)| (other - part).abs() <= same) {
            return *known;
        }
        let number = self.points.len() as u32;
        self.points.push(place);
        self.lines[line as usize].between.insert(at, (part, number));
        number
    }

    /// Cuts a polygon where values at its corners pass through 0: the part where they are positive,
    /// and the part where they are negative; empty where there is none.
    pub(super) fn cut(&mut self, polygon: &[Corner], values: &[f64]) -> [Polygon; 2] {
        if values.iter().all(|value| *value >= 0.0) {
            return [polygon.to_vec(), Vec::new()];
        }
        if values.iter().all(|value| *value <= 0.0) {
            return [Vec::new(), polygon.to_vec()];
        }
        let mut parts: [(Vec<u32>, Vec<Color>); 2] = Default::default();
        let mut put = |side: usize, point: u32, color: Color| {
            let (points, colors) = &mut parts[side];
            if !points.contains(&point) {
                points.push(point);
                colors.push(color);
            }
        };
        let count = polygon.len();
        for at in 0..count {
            let next = (at + 1) % count;
            let (here, there) = (polygon[at], polygon[next]);
            let (from, to) = (values[at], values[next]);
            if from >= 0.0 {
                put(0, here.point, here.color);
            }
            if from <= 0.0 {
                put(1, here.point, here.color);
            }
            if (from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0) {
                // From one end of the line always, so that both neighbours find the same place.
                let forwards = here.point < there.point;
                let (a, b, from, to) =
                    if forwards { (here, there, from, to) } else { (there, here, to, from) };
                let t = from / (from - to);
                let ([ax, ay], [bx, by]) = (self.place(a.point), self.place(b.point));
                let point = self.point_on(here.line, [ax + (bx - ax) * t, ay + (by - ay) * t]);
                let mixed = std::array::from_fn(|channel| {
                    a.color[channel] + (b.color[channel] - a.color[channel]) * t as f32
                });
                put(0, point, mixed);
                put(1, point, mixed);
            }
        }
        parts.map(|(points, colors)| {
            if points.len() < 3 {
                return Vec::new();
            }
            let mut part = self.between_points(&points, &colors);
            // Edges that were there stay on their lines.
            for at in 0..part.len() {
                let next = part[(at + 1) % part.len()].point;
                if let Some(line) = self.shared_line(polygon, part[at].point, next) {
                    part[at].line = line;
                }
            }
            part
        })
    }

    /// The line of a polygon that holds two points.
    fn shared_line(&self, polygon: &[Corner], from: u32, to: u32) -> Option<u32> {
        let holds = |line: u32, point: u32| {
            let Line { ends, between } = &self.lines[line as usize];
            ends.contains(&point) || between.iter().any(|(_, other)| *other == point)
        };
        polygon.iter().map(|corner| corner.line).find(|&line| holds(line, from) && holds(line, to))
    }

    /// The points around a polygon, those included that other polygons put on its edges.
    pub(super) fn around(&self, polygon: &[Corner], points: &mut Vec<u32>) {
        points.clear();
        for (at, corner) in polygon.iter().enumerate() {
            points.push(corner.point);
            let next = polygon[(at + 1) % polygon.len()].point;
            let Line { ends, between } = &self.lines[corner.line as usize];
            if between.is_empty() {
                continue;
            }
            // That of a point between is what was computed when it was put there.
            let part = |point: u32| match *ends {
                [first, _] if first == point => 0.0,
                [_, last] if last == point => 1.0,
                _ => self.part(corner.line, self.place(point)).0,
            };
            let (from, to) = (part(corner.point), part(next));
            let (low, high) = (from.min(to), from.max(to));
            let first = between.partition_point(|(t, _)| *t <= low);
            let inner = between[first..].iter().take_while(|(t, _)| *t < high);
            let begin = points.len();
            points.extend(inner.map(|(_, point)| *point));
            if from > to {
                points[begin..].reverse();
            }
        }
    }
}
