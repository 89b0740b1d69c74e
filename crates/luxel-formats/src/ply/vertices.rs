//! Vertices: positions, normals, texture coordinates and colours, under the names in use.

use super::header::{Element, Kind, Scalar};
use super::source::{Source, Table, each_row};
use crate::{Error, color};
use luxel_scene::Encoding;

/// Attributes of the vertices; missing ones are empty.
#[derive(Default)]
pub(super) struct Vertices {
    /// Positions, if the file has them in single precision.
    pub(super) singles: Vec<[f32; 3]>,
    /// Positions, if the file has them in another type.
    pub(super) doubles: Vec<[f64; 3]>,
    /// As in the file.
    pub(super) normals: Vec<[f32; 3]>,
    /// As in the file: the second coordinate points up.
    pub(super) uvs: Vec<[f32; 2]>,
    /// Linear, with alpha.
    pub(super) colors: Vec<[f32; 4]>,
}

/// A scalar property: its index, its type, and its offset in a binary row
/// without lists.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column {
    pub(super) property: usize,
    pub(super) scalar: Scalar,
    pub(super) offset: usize,
}

struct Columns {
    position: Option<[Column; 3]>,
    normal: Option<[Column; 3]>,
    uv: Option<[Column; 2]>,
    color: Option<ColorColumns>,
}

/// Red, green, blue, and perhaps alpha.
#[derive(Clone, Copy, Debug)]
pub(super) struct ColorColumns([Column; 3], Option<Column>);

fn column(element: &Element, name: &str) -> Option<Column> {
    let property = element.scalar(name)?;
    let size = |kind: Kind| match kind {
        Kind::Scalar(scalar) => scalar.size(),
        Kind::List { .. } => 0,
    };
    let before = &element.properties[..property];
    let offset = before.iter().map(|property| size(property.kind)).sum();
    let Kind::Scalar(scalar) = element.properties[property].kind else { return None };
    Some(Column { property, scalar, offset })
}

fn columns<const N: usize>(element: &Element, names: [&str; N]) -> Option<[Column; N]> {
    let found: Vec<_> = names.iter().filter_map(|name| column(element, name)).collect();
    found.try_into().ok()
}

impl ColorColumns {
    /// The colour columns, under the names that writers use.
    pub(super) fn of(element: &Element) -> Option<Self> {
        let rgb = [
            ["red", "green", "blue"],
            ["diffuse_red", "diffuse_green", "diffuse_blue"],
            ["r", "g", "b"],
        ];
        let rgb = rgb.into_iter().find_map(|names| columns(element, names))?;
        let alpha = ["alpha", "diffuse_alpha", "a"].into_iter().find_map(|n| column(element, n));
        Some(Self(rgb, alpha))
    }

    pub(super) fn columns(self) -> impl Iterator<Item = Column> {
        self.0.into_iter().chain(self.1)
    }

    /// The colour, linear.
    pub(super) fn decode(self, value: impl Fn(Column) -> f64) -> [f32; 4] {
        let channel = |column: Column| match column.scalar {
            Scalar::U8 => Encoding::Srgb.linear(value(column) as u8),
            _ => color::linear(unit(column.scalar, value(column))),
        };
        let [red, green, blue] = self.0.map(channel);
        let alpha = self.1.map_or(1.0, |column| unit(column.scalar, value(column)) as f32);
        [red, green, blue, alpha]
    }
}

/// Maps to 0 to 1 by type: floats unchanged, integers divided by 255, or by 65,535 if
/// they are unsigned 16-bit integers.
fn unit(scalar: Scalar, value: f64) -> f64 {
    let value = match scalar {
        Scalar::F32 | Scalar::F64 => value,
        Scalar::U16 => value / 65_535.0,
        _ => value / 255.0,
    };
    if value > 0.0 { value.min(1.0) } else { 0.0 }
}

impl Columns {
    fn of(element: &Element) -> Self {
        let uv = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"], ["texture_s", "texture_t"]];
        Self {
            position: columns(element, ["x", "y", "z"]),
            normal: columns(element, ["nx", "ny", "nz"]),
            uv: uv.into_iter().find_map(|names| columns(element, names)),
            color: ColorColumns::of(element),
        }
    }

    /// Whether positions are kept in single precision.
    fn single(&self) -> bool {
        self.position.is_none_or(|columns| columns.iter().all(|c| c.scalar == Scalar::F32))
    }
}

/// The indices of the properties that are read.
pub(super) fn used_properties(element: &Element) -> Vec<usize> {
    let Columns { position, normal, uv, color } = Columns::of(element);
    let used = position.into_iter().flatten().chain(normal.into_iter().flatten());
    let used = used
        .chain(uv.into_iter().flatten())
        .chain(color.into_iter().flat_map(ColorColumns::columns));
    used.map(|column| column.property).collect()
}

/// Bytes of a vertex in memory.
pub(super) fn bytes_each(element: &Element) -> u64 {
    let columns = Columns::of(element);
    let position = if columns.single() { 12 } else { 36 };
    let normal = if columns.normal.is_some() { 12 } else { 0 };
    let uv = if columns.uv.is_some() { 8 } else { 0 };
    let color = if columns.color.is_some() { 16 } else { 0 };
    position + normal + uv + color
}

impl Vertices {
    /// Reads the element; a vertex without coordinates is at the origin.
    pub(super) fn read(&mut self, element: &Element, source: &mut Source<'_>) -> Result<(), Error> {
        let columns = Columns::of(element);
        match element.stride().and_then(|stride| source.table(element.count, stride)) {
            Some(table) => {
                self.read_table(&columns, &table, element.count as usize);
                source.skip(&table);
                Ok(())
            }
            None => self.read_rows(&columns, element, source),
        }
    }

    fn read_table(&mut self, columns: &Columns, table: &Table<'_>, count: usize) {
        let value = |row: &[u8], column: Column| table.value(row, column.offset, column.scalar);
        match (columns.position, columns.normal) {
            (Some(position), Some(normal)) if columns.single() => {
                (self.singles, self.normals) = table.singles_of_two([position, normal]);
            }
            (position, normal) => {
                match position {
                    Some(position) if columns.single() => self.singles = table.singles(position),
                    Some(position) => {
                        self.doubles =
                            table.read([0.0; 3], |row| position.map(|column| value(row, column)));
                    }
                    None => self.singles = vec![[0.0; 3]; count],
                }
                self.normals = normal.map_or_else(Vec::new, |normal| table.singles(normal));
            }
        }
        if let Some(uv) = columns.uv {
            self.uvs = table.singles(uv);
        }
        if let Some(color) = columns.color {
            self.colors = table.read([0.0; 4], |row| color.decode(|column| value(row, column)));
        }
    }

    fn read_rows(
        &mut self,
        columns: &Columns,
        element: &Element,
        source: &mut Source<'_>,
    ) -> Result<(), Error> {
        // Rows without values take no space in the file, but would take some here.
        let count = if element.properties.is_empty() { 0 } else { element.count as usize };
        let single = columns.single();
        if single {
            self.singles.reserve_exact(count);
        } else {
            self.doubles.reserve_exact(count);
        }
        each_row(element, source, None, |_, row| {
            let value = |column: Column| row.values[column.property];
            let position = columns.position.map_or([0.0; 3], |position| position.map(value));
            if single {
                self.singles.push(position.map(|value| value as f32));
            } else {
                self.doubles.push(position);
            }
            if let Some(normal) = columns.normal {
                self.normals.push(normal.map(|column| value(column) as f32));
            }
            if let Some(uv) = columns.uv {
                self.uvs.push(uv.map(|column| value(column) as f32));
            }
            if let Some(color) = columns.color {
                self.colors.push(color.decode(value));
            }
            Ok(())
        })
    }
}
