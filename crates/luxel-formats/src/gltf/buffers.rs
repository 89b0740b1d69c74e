//! Buffers and the views into them: where the bytes of geometry and images come from.
//!
//! Both are read on first use, so that unused ones may be missing, such as the fallback buffers of
//! compressed data.

use super::meshopt;
use super::uri::{self, Target};
use crate::memory::Memory;
use crate::{Error, ErrorKind, Place, files};
use luxel_gltf::{BufferView, Document};
use std::borrow::Cow;
use std::cell::OnceCell;
use std::path::Path;

/// The bytes behind a document.
pub(crate) struct Buffers<'a> {
    document: &'a Document,
    binary: Option<&'a [u8]>,
    folder: Option<&'a Path>,
    memory: &'a Memory<'a>,
    buffers: Vec<OnceCell<Cow<'a, [u8]>>>,
    /// Views that had to be decompressed.
    decompressed: Vec<OnceCell<Vec<u8>>>,
}

/// A range of a buffer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View<'b> {
    /// The bytes.
    pub(crate) bytes: &'b [u8],
    /// Bytes from one element to the next; `None` if tightly packed.
    pub(crate) stride: Option<u64>,
}

/// A malformed value, by its pointer.
pub(crate) fn malformed(pointer: impl Into<String>, message: impl Into<String>) -> Error {
    Error::at(Place::Pointer(pointer.into()), ErrorKind::Malformed(message.into()))
}

/// Item `index` of a list, or an error at the pointer of the index.
pub(crate) fn item<'d, T>(
    list: &'d [T],
    index: u32,
    what: &'static str,
    pointer: &dyn Fn() -> String,
) -> Result<&'d T, Error> {
    list.get(index as usize).ok_or_else(|| {
        let kind =
            ErrorKind::OutOfRange { what, index: i64::from(index), count: list.len() as u64 };
        Error::at(Place::Pointer(pointer()), kind)
    })
}

impl<'a> Buffers<'a> {
    pub(crate) fn new(
        document: &'a Document,
        binary: Option<&'a [u8]>,
        folder: Option<&'a Path>,
        memory: &'a Memory<'a>,
    ) -> Self {
        Self {
            document,
            binary,
            folder,
            memory,
            buffers: document.buffers.iter().map(|_| OnceCell::new()).collect(),
            decompressed: document.buffer_views.iter().map(|_| OnceCell::new()).collect(),
        }
    }

    /// The bytes of a view; `referrer` is the pointer to the index, without `/bufferView`.
    pub(crate) fn view(
        &self,
        index: u32,
        referrer: &dyn Fn() -> String,
    ) -> Result<View<'_>, Error> {
        let view = item(&self.document.buffer_views, index, "buffer view", &|| {
            format!("{}/bufferView", referrer())
        })?;
        let pointer = format!("/bufferViews/{index}");
        if let Some(compressed) = &view.extensions.meshopt {
            let bytes = self.decompressed(index, view, &pointer)?;
            return Ok(View { bytes, stride: Some(compressed.byte_stride) });
        }
        let bytes = self.range(view.buffer, view.byte_offset, view.byte_length, &pointer)?;
        Ok(View { bytes, stride: view.byte_stride })
    }

    fn decompressed(&self, index: u32, view: &BufferView, pointer: &str) -> Result<&[u8], Error> {
        let cell = &self.decompressed[index as usize];
        if let Some(bytes) = cell.get() {
            return Ok(bytes);
        }
        let Some(meshopt) = &view.extensions.meshopt else { return Ok(&[]) };
        let pointer = format!("{pointer}/extensions/EXT_meshopt_compression");
        let stream =
            self.range(meshopt.buffer, meshopt.byte_offset, meshopt.byte_length, &pointer)?;
        let place = || Place::Pointer(format!("{pointer}/count"));
        self.memory.take("decompressed geometry", meshopt.count, meshopt.byte_stride, place())?;
        let bytes = meshopt::decompress(meshopt, stream)
            .map_err(|kind| Error::at(Place::Pointer(pointer.clone()), kind))?;
        Ok(cell.get_or_init(|| bytes))
    }

    /// `length` bytes of a buffer.
    fn range(&self, buffer: u32, offset: u64, length: u64, pointer: &str) -> Result<&[u8], Error> {
        let bytes = self.buffer(buffer, pointer)?;
        let end = offset.checked_add(length).filter(|&end| end <= bytes.len() as u64);
        end.map(|end| &bytes[offset as usize..end as usize]).ok_or_else(|| {
            let message = format!(
                "{length} bytes from byte {offset} reach beyond buffer {buffer}, which has {}",
                bytes.len()
            );
            malformed(pointer, message)
        })
    }

    fn buffer(&self, index: u32, referrer: &str) -> Result<&[u8], Error> {
        let buffer =
            item(&self.document.buffers, index, "buffer", &|| format!("{referrer}/buffer"))?;
        let cell = &self.buffers[index as usize];
        if let Some(bytes) = cell.get() {
            return Ok(bytes);
        }
        let pointer = format!("/buffers/{index}");
        let bytes = match &buffer.uri {
            Some(uri) => Cow::Owned(self.resource(uri, &format!("{pointer}/uri"))?),
            None => {
                let missing = || {
                    let meshopt = buffer.extensions.meshopt.as_ref();
                    let message = if meshopt.is_some_and(|meshopt| meshopt.fallback) {
                        "the buffer is a placeholder without data, but a buffer view needs them"
                    } else {
                        "the buffer has no `uri`, and the file has no binary chunk"
                    };
                    malformed(&*pointer, message)
                };
                let binary = (index == 0).then_some(self.binary).flatten();
                Cow::Borrowed(binary.ok_or_else(missing)?)
            }
        };
        let there = bytes.len() as u64;
        if there < buffer.byte_length {
            let message =
                format!("`byteLength` is {}, but the file has {there} bytes", buffer.byte_length);
            return Err(malformed(format!("{pointer}/byteLength"), message));
        }
        let wanted = buffer.byte_length as usize;
        let bytes = match bytes {
            Cow::Borrowed(bytes) => Cow::Borrowed(&bytes[..wanted]),
            Cow::Owned(mut bytes) => {
                bytes.truncate(wanted);
                Cow::Owned(bytes)
            }
        };
        Ok(cell.get_or_init(|| bytes))
    }

    /// The bytes behind a URI of a buffer or an image.
    pub(crate) fn resource(&self, uri: &str, pointer: &str) -> Result<Vec<u8>, Error> {
        let place = || Place::Pointer(pointer.to_owned());
        self.memory.take("data in a URI", uri.len() as u64, 1, place())?;
        let (decoded, literal) = match uri::resolve(uri).map_err(|text| malformed(pointer, text))? {
            Target::Data(bytes) => return Ok(bytes),
            Target::File { decoded, literal } => (decoded, literal),
        };
        let given = self.memory.given();
        let path = uri::file_in(self.folder, &decoded, &literal, given).map_err(|refusal| {
            // Nothing is there, or a model without a folder asks for it.
            let is_missing = !refusal.is_there && self.folder.is_some();
            let kind = match refusal.into() {
                ErrorKind::Reference(message) if is_missing => ErrorKind::Malformed(message),
                kind => kind,
            };
            Error::at(place(), kind)
        })?;
        let unreadable = |error: &std::io::Error| {
            let what = format!("`{decoded}` can't be read: {error}");
            Error::at(place(), std::io::Error::new(error.kind(), what).into())
        };
        let length = files::length(&path, given).map_err(|error| unreadable(&error))?;
        let what = format!("`{decoded}`");
        self.memory.take(&what, length, 1, place())?;
        let read = files::read_file(&path, &self.memory.left()).map(Cow::into_owned);
        read.map_err(|error| match error.kind {
            ErrorKind::Io(error) => unreadable(&error),
            kind => Error::at(place(), kind),
        })
    }

    /// The document that owns the buffers.
    pub(crate) const fn document(&self) -> &'a Document {
        self.document
    }

    /// Whether there is a folder for files beside the document.
    pub(crate) const fn has_folder(&self) -> bool {
        self.folder.is_some()
    }

    /// The remaining memory budget.
    pub(crate) const fn memory(&self) -> &'a Memory<'a> {
        self.memory
    }
}
