//! Small glTF documents, written by the tests themselves.

#![allow(dead_code, reason = "each test program uses a part")]
#![allow(clippy::unwrap_used, reason = "tests may")]

use luxel_formats::{Error, ErrorKind, Format, Limits, Loaded, Place, read};
use serde_json::{Value, json};

/// A document under construction: JSON beside the bytes that it describes.
pub(crate) struct Document {
    /// The JSON text to be.
    pub(crate) json: Value,
    /// Buffer 0.
    pub(crate) bytes: Vec<u8>,
}

impl Document {
    /// A document of one node that shows mesh 0, which has one primitive without attributes.
    pub(crate) fn new() -> Self {
        let json = json!({
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {}}]}],
            "accessors": [], "bufferViews": [], "buffers": [],
        });
        Self { json, bytes: Vec::new() }
    }

    /// One with three positions, (0, 0, 0), (1, 0, 0) and (0, 1, 0).
    pub(crate) fn triangle() -> Self {
        let mut document = Self::new();
        let positions = document.floats("VEC3", &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        document.attribute("POSITION", positions);
        document
    }

    /// Appends a buffer view; its number.
    pub(crate) fn view(&mut self, bytes: &[u8]) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let view = json!({
            "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len(),
        });
        self.bytes.extend(bytes);
        self.push("bufferViews", view)
    }

    /// Appends an accessor over a new buffer view; its number.
    pub(crate) fn accessor(
        &mut self,
        kind: &str,
        component: u32,
        count: usize,
        bytes: &[u8],
    ) -> usize {
        let view = self.view(bytes);
        let accessor = json!({
            "bufferView": view, "componentType": component, "count": count, "type": kind,
        });
        self.push("accessors", accessor)
    }

    /// Appends an accessor of floats.
    pub(crate) fn floats(&mut self, kind: &str, values: &[f32]) -> usize {
        let width = match kind {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 16,
        };
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.accessor(kind, 5126, values.len() / width, &bytes)
    }

    /// Appends an accessor of 16-bit indices.
    pub(crate) fn indices(&mut self, values: &[u16]) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.accessor("SCALAR", 5123, values.len(), &bytes)
    }

    /// Appends to a list; the new thing's number.
    pub(crate) fn push(&mut self, list: &str, value: Value) -> usize {
        if self.json[list].is_null() {
            self.json[list] = json!([]);
        }
        let list = self.json[list].as_array_mut().unwrap();
        list.push(value);
        list.len() - 1
    }

    /// The first primitive.
    pub(crate) fn primitive(&mut self) -> &mut Value {
        &mut self.json["meshes"][0]["primitives"][0]
    }

    /// Gives the first primitive an attribute.
    pub(crate) fn attribute(&mut self, name: &str, accessor: usize) {
        self.primitive()["attributes"][name] = json!(accessor);
    }

    /// The bytes of a GLB.
    pub(crate) fn glb(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        if json["buffers"].as_array().is_some_and(Vec::is_empty) {
            json["buffers"] = json!([{"byteLength": self.bytes.len()}]);
        }
        let mut text = json.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let mut binary = self.bytes.clone();
        binary.resize(binary.len().next_multiple_of(4), 0);
        let length = 12 + 8 + text.len() + 8 + binary.len();
        let mut glb = b"glTF\x02\0\0\0".to_vec();
        glb.extend((length as u32).to_le_bytes());
        for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &binary)] {
            glb.extend((chunk.len() as u32).to_le_bytes());
            glb.extend(kind);
            glb.extend(chunk);
        }
        glb
    }

    /// The loaded document.
    pub(crate) fn read(&self) -> Result<Loaded, Error> {
        read(&self.glb(), Format::Glb, "test", None, &Limits::default())
    }

    /// The loaded document, which must be valid.
    pub(crate) fn load(&self) -> Loaded {
        self.read().unwrap_or_else(|error| panic!("{error}"))
    }

    /// The pointer and the message of the error that reading has to end in.
    pub(crate) fn fault(&self) -> (String, String) {
        let error = self.read().expect_err("the document is at fault");
        match error.place {
            Place::Pointer(pointer) => (pointer, error.kind.to_string()),
            place => panic!("no pointer but {place:?}: {}", error.kind),
        }
    }
}

/// Whether an error is about an unsupported feature.
pub(crate) fn is_unsupported(error: &Error) -> bool {
    matches!(error.kind, ErrorKind::Unsupported(_))
}
