//! Faces: polygons, and triangle strips.

use super::header::{Element, Kind, Scalar};
use super::source::{RUN, Source, Table, each_row, word};
use super::vertices::{ColorColumns, Column};
use crate::{Error, ErrorKind, Limits, Place};
use luxel_parallel::first;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

/// Bytes of a polygon's corner: its index, its share of a triangle and of the list's end.
const BYTES_PER_CORNER: u64 = 4 + 12 + 4;

/// Faces in the file's order.
#[derive(Default)]
pub(super) struct Faces {
    /// The corners of all faces, if all are triangles.
    pub(super) triangles: Vec<[u32; 3]>,
    /// All faces, if one isn't a triangle.
    pub(super) polygons: Option<Polygons>,
    /// A linear colour for each face; empty if they have none.
    pub(super) colors: Vec<[f32; 4]>,
    vertex_count: u64,
    corners_left: u64,
    max_memory: u64,
    /// Whether faces form no table, and so can't be streamed from a file.
    pub(super) need_whole_file: bool,
}

/// Polygons with any number of corners.
#[derive(Default)]
pub(super) struct Polygons {
    /// The corners, polygon by polygon.
    pub(super) corners: Vec<u32>,
    /// The end of each polygon's corners.
    pub(super) ends: Vec<u32>,
}

/// Bytes of a triangle in memory, and the minimum of a larger face.
pub(super) fn bytes_each(element: &Element) -> u64 {
    if ColorColumns::of(element).is_some() { 12 + 16 + 3 * (12 + 16) } else { 12 }
}

/// Checks a vertex index.
pub(super) fn vertex_index(value: f64, vertex_count: u64) -> Result<u32, ErrorKind> {
    // Fractions and NaN change on the way to an integer and back.
    let index = value as u32;
    if f64::from(index) == value && u64::from(index) < vertex_count {
        return Ok(index);
    }
    Err(ErrorKind::OutOfRange { what: "vertex", index: value as i64, count: vertex_count })
}

/// The position and types of the list property with a face's vertices.
fn index_list(element: &Element) -> Option<(usize, Scalar, Scalar)> {
    element.properties.iter().enumerate().find_map(|(index, property)| match property.kind {
        Kind::List { count, item }
            if matches!(property.name.as_str(), "vertex_indices" | "vertex_index") =>
        {
            Some((index, count, item))
        }
        _ => None,
    })
}

/// The indices of the properties of faces, or of strips, that are read.
pub(super) fn used_properties(element: &Element) -> Vec<usize> {
    let list = index_list(element).map(|(index, ..)| index);
    let colors = ColorColumns::of(element).filter(|_| element.name == "face" && list.is_some());
    let colors = colors.into_iter().flat_map(ColorColumns::columns).map(|column| column.property);
    list.into_iter().chain(colors).collect()
}

impl Faces {
    pub(super) fn new(vertex_count: u64, limits: &Limits) -> Self {
        let max_memory = limits.max_memory;
        let corners_left = (max_memory / BYTES_PER_CORNER).min(u64::from(u32::MAX));
        Self { vertex_count, corners_left, max_memory, ..Self::default() }
    }

    /// Reads polygons.
    pub(super) fn read_polygons(
        &mut self,
        element: &Element,
        source: &mut Source<'_>,
    ) -> Result<(), Error> {
        let Some((list, count, item)) = index_list(element) else {
            return super::skip(element, source);
        };
        let color = ColorColumns::of(element);
        let is_first = self.triangles.is_empty() && self.polygons.is_none();
        let records = Records::of(element, list, [count, item], source).filter(|_| is_first);
        if let Some(records) = records
            && self.read_records(&records, color, source)?
        {
            return Ok(());
        }
        if source.is_streamed() {
            self.need_whole_file = true;
            return Ok(());
        }
        self.triangles.reserve_exact(element.count as usize);
        let mut corners = Vec::new();
        each_row(element, source, Some(list), |source, row| {
            corners.clear();
            for &value in &row.items {
                let index = vertex_index(value, self.vertex_count);
                corners.push(index.map_err(|kind| Error::at(source.place(), kind))?);
            }
            if let Some(color) = color {
                self.colors.push(color.decode(|column| row.values[column.property]));
            }
            self.push(&corners, || source.place())
        })
    }

    /// Reads triangle strips, which -1 restarts: each corner from the third on forms a triangle
    /// with the two before it; every second triangle swaps two corners.
    pub(super) fn read_strips(
        &mut self,
        element: &Element,
        source: &mut Source<'_>,
    ) -> Result<(), Error> {
        let Some((list, ..)) = index_list(element) else {
            return super::skip(element, source);
        };
        each_row(element, source, Some(list), |source, row| {
            let mut strip = [0; 2];
            let mut length = 0_u64;
            for &value in &row.items {
                if value == -1.0 {
                    length = 0;
                    continue;
                }
                let index = vertex_index(value, self.vertex_count)
                    .map_err(|kind| Error::at(source.place(), kind))?;
                let [a, b] = strip;
                if length >= 2 {
                    let triangle =
                        if length.is_multiple_of(2) { [a, b, index] } else { [b, a, index] };
                    self.push(&triangle, || source.place())?;
                }
                strip = [b, index];
                length += 1;
            }
            Ok(())
        })
    }

    fn push(&mut self, corners: &[u32], place: impl Fn() -> Place) -> Result<(), Error> {
        let Some(left) = self.corners_left.checked_sub(corners.len() as u64) else {
            let kind = ErrorKind::TooLarge {
                what: "the faces".to_owned(),
                needed: self.max_memory.saturating_add(1),
                limit: self.max_memory,
            };
            return Err(Error::at(place(), kind));
        };
        self.corners_left = left;
        match (&mut self.polygons, corners) {
            (None, &[a, b, c]) => self.triangles.push([a, b, c]),
            (None, _) => {
                let triangles = std::mem::take(&mut self.triangles);
                let ends = (1..=triangles.len() as u32).map(|face| face * 3).collect();
                let mut polygons = Polygons { corners: triangles.into_flattened(), ends };
                polygons.push(corners);
                self.polygons = Some(polygons);
            }
            (Some(polygons), _) => polygons.push(corners),
        }
        Ok(())
    }

    /// Reads triangles at a fixed stride in batches; `false` if a face is not a triangle.
    fn read_records(
        &mut self,
        records: &Records<'_>,
        color: Option<ColorColumns>,
        source: &mut Source<'_>,
    ) -> Result<bool, Error> {
        let table = &records.table;
        if !table.with_row(0, |row| records.is_triangle(row)) {
            return Ok(false);
        }
        let all_triangles = AtomicBool::new(true);
        let count = |row: &[u8]| {
            if !records.is_triangle(row) {
                all_triangles.store(false, Ordering::Relaxed);
            }
        };
        let corner_at = |corner: usize| records.first_item + corner * records.item.size();
        let index = |row: &[u8], corner| table.value(row, corner_at(corner), records.item);
        let checked = |value: f64| vertex_index(value, self.vertex_count).unwrap_or(u32::MAX);
        // As unsigned integers, negative ones exceed every index.
        let words = [(Scalar::I32, 1 << 31), (Scalar::U32, u32::MAX)];
        let words =
            words.into_iter().find(|&(scalar, _)| table.has_words_of(scalar, &[records.item]));
        self.triangles = if let Some((_, most)) = words {
            let most = u32::try_from(self.vertex_count).map_or(most, |count| count.min(most));
            let places = [0, 1, 2].map(corner_at);
            table.read([0; 3], |row| {
                count(row);
                let corner = |at: usize| u32::from_le_bytes(word(row, at));
                places.map(corner).map(|index| if index < most { index } else { u32::MAX })
            })
        } else {
            table.read([0; 3], |row| {
                count(row);
                [0, 1, 2].map(|corner| checked(index(row, corner)))
            })
        };
        if !all_triangles.into_inner() {
            self.triangles = Vec::new();
            return Ok(false);
        }
        // There are fewer vertices, so no vertex has this index.
        let wrong = |corners: &[u32; 3]| corners.contains(&u32::MAX);
        let wrong_of_run = |run: Range<usize>| {
            self.triangles[run.clone()].iter().position(wrong).map(|at| run.start + at)
        };
        if let Some(face) = first(self.triangles.len(), RUN, &wrong_of_run) {
            let corner = self.triangles[face].iter().position(|&index| index == u32::MAX);
            let corner = corner.unwrap_or(0);
            let value = table.with_row(face, |row| index(row, corner));
            let kind = vertex_index(value, self.vertex_count).err();
            let Place::Byte(start) = source.place() else { return Ok(true) };
            let byte = start + (table.row_at(face) + corner_at(corner)) as u64;
            return kind.map_or(Ok(true), |kind| Err(Error::at(Place::Byte(byte), kind)));
        }
        if let Some(color) = color {
            let value = |row: &[u8], column: Column| {
                let after_list = column.property > records.list;
                let shift = if after_list { records.list_size } else { 0 };
                table.value(row, column.offset + shift, column.scalar)
            };
            self.colors = table.read([0.0; 4], |row| color.decode(|column| value(row, column)));
        }
        source.skip(table);
        Ok(true)
    }
}

impl Polygons {
    fn push(&mut self, corners: &[u32]) {
        self.corners.extend_from_slice(corners);
        self.ends.push(self.corners.len() as u32);
    }
}

/// Rows with one list of three items each, which have a fixed size.
struct Records<'a> {
    /// The position of the list among the properties.
    list: usize,
    /// Bytes of the count and the three items.
    list_size: usize,
    /// The type of the count.
    count: Scalar,
    /// The type of the items, and the offset of the first in a row.
    item: Scalar,
    first_item: usize,
    table: Table<'a>,
}

impl<'a> Records<'a> {
    /// `Some` if the source is binary and long enough; each row shows whether it is a triangle.
    fn of(
        element: &Element,
        list: usize,
        [count, item]: [Scalar; 2],
        source: &Source<'a>,
    ) -> Option<Self> {
        let mut stride = 0_usize;
        let mut first_item = 0;
        let list_size = count.size() + 3 * item.size();
        for (index, property) in element.properties.iter().enumerate() {
            match property.kind {
                Kind::Scalar(scalar) => stride += scalar.size(),
                Kind::List { .. } if index == list => {
                    first_item = stride + count.size();
                    stride += list_size;
                }
                Kind::List { .. } => return None,
            }
        }
        let table = source.table(element.count, stride).filter(|_| element.count > 0)?;
        Some(Self { list, list_size, count, item, first_item, table })
    }

    /// Whether a row's list has three items.
    #[inline]
    fn is_triangle(&self, row: &[u8]) -> bool {
        let at = self.first_item - self.count.size();
        match self.count {
            Scalar::U8 => row.get(at) == Some(&3),
            _ => self.table.value(row, at, self.count) == 3.0,
        }
    }
}
