//! Accessors: typed elements in a buffer (glTF 2.0 specification, section 3.6.2).
//!
//! Every range is checked before the first element is read, and every count before memory is taken
//! for it.

use super::buffers::{Buffers, View, item, malformed};
use crate::{Error, ErrorKind, Place};
use luxel_gltf::{Accessor, Sparse};
use std::borrow::Cow;

/// The type of a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    /// Maps OpenGL's constants, which glTF uses.
    pub(crate) fn from_code(code: u32) -> Option<Self> {
        Some(match code {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return None,
        })
    }

    const fn bytes(self) -> u64 {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    const fn is_unsigned(self) -> bool {
        matches!(self, Self::U8 | Self::U16 | Self::U32)
    }

    /// The first value in `bytes`, which must be long enough.
    #[inline]
    fn value(self, bytes: &[u8]) -> f64 {
        match self {
            Self::I8 => f64::from(bytes[0] as i8),
            Self::U8 => f64::from(bytes[0]),
            Self::I16 => f64::from(i16::from_le_bytes([bytes[0], bytes[1]])),
            Self::U16 => f64::from(u16::from_le_bytes([bytes[0], bytes[1]])),
            Self::U32 => f64::from(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
            Self::F32 => f64::from(f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
        }
    }

    /// The divisor of a normalized value (section 3.6.2.2).
    pub(crate) const fn full_scale(self) -> f64 {
        match self {
            Self::I8 => 127.0,
            Self::U8 => 255.0,
            Self::I16 => 32_767.0,
            Self::U16 => 65_535.0,
            Self::U32 => 4_294_967_295.0,
            Self::F32 => 1.0,
        }
    }
}

/// The elements of an accessor: located and checked, not yet read.
#[derive(Debug)]
pub(crate) struct Elements<'b> {
    bytes: Cow<'b, [u8]>,
    stride: usize,
    /// How many.
    pub(crate) count: usize,
    /// The components of each, counted.
    pub(crate) width: usize,
    /// Their type.
    pub(crate) component: Component,
    /// Whether integers stand for -1..1 or 0..1.
    pub(crate) normalized: bool,
}

/// The number of components of an element type.
fn width_of(kind: &str) -> Option<usize> {
    Some(match kind {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" | "MAT2" => 4,
        "MAT3" => 9,
        "MAT4" => 16,
        _ => return None,
    })
}

/// Locates the elements of accessor `index`; `referrer` points to the value that names it.
pub(crate) fn elements<'b>(
    buffers: &'b Buffers<'_>,
    index: u32,
    referrer: &dyn Fn() -> String,
) -> Result<Elements<'b>, Error> {
    let accessor = item(&buffers.document().accessors, index, "accessor", &referrer)?;
    let pointer = || format!("/accessors/{index}");
    let component = component_of(accessor.component_type, &pointer)?;
    let width = width_of(&accessor.kind).ok_or_else(|| {
        let message = format!("`{}` is not an accessor type: use SCALAR, VEC3, ...", accessor.kind);
        malformed(format!("{}/type", pointer()), message)
    })?;
    let padded = accessor.kind.starts_with("MAT") && component != Component::F32;
    if padded {
        let message = "luxel uses no accessor with matrices of integers";
        return Err(malformed(pointer(), message));
    }
    let element_bytes = component.bytes() * width as u64;
    let dense = match accessor.buffer_view {
        Some(view) => {
            let view = buffers.view(view, &pointer)?;
            Some(checked_range(
                view,
                accessor.byte_offset,
                element_bytes,
                accessor.count,
                &pointer,
            )?)
        }
        None => None,
    };
    let count_place = || Place::Pointer(format!("{}/count", pointer()));
    let (bytes, stride) = match (dense, &accessor.sparse) {
        (Some((bytes, stride)), None) => (Cow::Borrowed(bytes), stride),
        (dense, sparse) => {
            buffers.memory().take("an accessor", accessor.count, element_bytes, count_place())?;
            let size = element_bytes as usize;
            let mut packed = vec![0; accessor.count as usize * size];
            if let Some((bytes, stride)) = dense {
                for (to, from) in packed.chunks_exact_mut(size).zip(bytes.chunks(stride)) {
                    to.copy_from_slice(&from[..size]);
                }
            }
            if let Some(sparse) = sparse {
                replace(buffers, sparse, &mut packed, size, accessor, &pointer)?;
            }
            (Cow::Owned(packed), size)
        }
    };
    Ok(Elements {
        bytes,
        stride,
        count: accessor.count as usize,
        width,
        component,
        normalized: accessor.normalized,
    })
}

fn component_of(code: u32, pointer: &dyn Fn() -> String) -> Result<Component, Error> {
    Component::from_code(code).ok_or_else(|| {
        let message = format!("{code} is not a component type: use 5120 to 5123, 5125 or 5126");
        malformed(format!("{}/componentType", pointer()), message)
    })
}

/// The bytes from the first element to the end of the last, and the stride, if in range.
fn checked_range<'b>(
    view: View<'b>,
    offset: u64,
    element_bytes: u64,
    count: u64,
    pointer: &dyn Fn() -> String,
) -> Result<(&'b [u8], usize), Error> {
    let stride = view.stride.unwrap_or(element_bytes);
    if stride < element_bytes {
        let message = format!(
            "the buffer view's stride of {stride} bytes is less than an element's {element_bytes}"
        );
        return Err(malformed(pointer(), message));
    }
    let Some(before_last) = count.checked_sub(1) else { return Ok((&[], stride as usize)) };
    let end = before_last
        .checked_mul(stride)
        .and_then(|last| last.checked_add(element_bytes))
        .and_then(|length| length.checked_add(offset))
        .filter(|&end| end <= view.bytes.len() as u64);
    let Some(end) = end else {
        let message = format!(
            "{count} elements of {element_bytes} bytes, {stride} apart, from byte {offset} reach \
             beyond the buffer view's {} bytes",
            view.bytes.len()
        );
        return Err(malformed(pointer(), message));
    };
    Ok((&view.bytes[offset as usize..end as usize], stride as usize))
}

/// Overwrites the values that a sparse accessor replaces.
fn replace(
    buffers: &Buffers<'_>,
    sparse: &Sparse,
    packed: &mut [u8],
    size: usize,
    accessor: &Accessor,
    pointer: &dyn Fn() -> String,
) -> Result<(), Error> {
    let pointer = || format!("{}/sparse", pointer());
    let indices_pointer = || format!("{}/indices", pointer());
    let values_pointer = || format!("{}/values", pointer());
    let component = component_of(sparse.indices.component_type, &indices_pointer)?;
    let place = Place::Pointer(pointer());
    buffers.memory().take("a sparse accessor", sparse.count, 8, place)?;
    let view = buffers.view(sparse.indices.buffer_view, &indices_pointer)?;
    let offset = sparse.indices.byte_offset;
    let (bytes, stride) =
        checked_range(view, offset, component.bytes(), sparse.count, &indices_pointer)?;
    let count = sparse.count as usize;
    let indices =
        Elements { bytes: bytes.into(), stride, count, width: 1, component, normalized: false };
    let indices = indices.indices().map_err(|message| malformed(indices_pointer(), message))?;
    let view = buffers.view(sparse.values.buffer_view, &values_pointer)?;
    let offset = sparse.values.byte_offset;
    let (values, stride) = checked_range(view, offset, size as u64, sparse.count, &values_pointer)?;
    for (index, value) in indices.into_iter().zip(values.chunks(stride)) {
        let start = index as usize * size;
        let Some(to) = packed.get_mut(start..start + size) else {
            let index = i64::from(index);
            let kind = ErrorKind::OutOfRange { what: "element", index, count: accessor.count };
            return Err(Error::at(Place::Pointer(indices_pointer()), kind));
        };
        to.copy_from_slice(&value[..size]);
    }
    Ok(())
}

impl Elements<'_> {
    /// Elements of `N` numbers, normalized if the accessor is; `N` must be its width.
    pub(crate) fn vectors<const N: usize>(&self) -> Result<Vec<[f64; N]>, String> {
        self.check_width(N)?;
        let scale = if self.normalized { self.component.full_scale() } else { 1.0 };
        let size = self.component.bytes() as usize;
        let value = |bytes: &[u8]| {
            let value = self.component.value(bytes);
            if scale == 1.0 { value } else { (value / scale).max(-1.0) }
        };
        Ok(self.map(|bytes| std::array::from_fn(|place| value(&bytes[place * size..]))))
    }

    /// Like [`Self::vectors`], in `f32`.
    pub(crate) fn vectors_f32<const N: usize>(&self) -> Result<Vec<[f32; N]>, String> {
        if self.component == Component::F32 {
            self.check_width(N)?;
            return Ok(self.map(|bytes| {
                let (singles, _) = bytes.as_chunks();
                std::array::from_fn(|place| f32::from_le_bytes(singles[place]))
            }));
        }
        let vectors = self.vectors::<N>()?;
        Ok(vectors.into_iter().map(|vector| vector.map(|value| value as f32)).collect())
    }

    /// Unsigned indices. OpenGL's primitive restart (-1) isn't special: glTF forbids it.
    pub(crate) fn indices(&self) -> Result<Vec<u32>, String> {
        self.check_width(1)?;
        if !self.component.is_unsigned() {
            return Err("indices must be unsigned integers".to_owned());
        }
        Ok(self.map(|bytes| self.component.value(bytes) as u32))
    }

    /// Four unsigned integers per element: the joints of a skin.
    pub(crate) fn joints(&self) -> Result<Vec<[u32; 4]>, String> {
        if !self.component.is_unsigned() {
            return Err("joints must be unsigned integers".to_owned());
        }
        let vectors = self.vectors::<4>()?;
        Ok(vectors.into_iter().map(|vector| vector.map(|value| value as u32)).collect())
    }

    fn check_width(&self, wanted: usize) -> Result<(), String> {
        if self.width == wanted {
            return Ok(());
        }
        Err(format!("elements have {} components instead of {wanted}", self.width))
    }

    /// Decodes each element.
    fn map<T>(&self, decode: impl Fn(&[u8]) -> T) -> Vec<T> {
        self.bytes.chunks(self.stride.max(1)).map(decode).take(self.count).collect()
    }
}
