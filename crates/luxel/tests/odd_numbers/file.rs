//! GLB files whose attributes, textures and materials are odd.

use crate::random::Random;
use luxel_testing::golden::Pixels;
use serde_json::{Map, Value, json};

/// Buffer views, and accessors of them.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Appends a view; its number.
    fn view(&mut self, bytes: &[u8]) -> usize {
        let (start, length) = (self.bytes.len(), bytes.len());
        self.views.push(json!({ "buffer": 0, "byteOffset": start, "byteLength": length }));
        self.bytes.extend(bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.views.len() - 1
    }

    /// Appends vectors of floats with an accessor; its number.
    fn vectors<const N: usize>(&mut self, rows: &[[f32; N]]) -> usize {
        let bytes: Vec<u8> = rows.iter().flatten().flat_map(|value| value.to_le_bytes()).collect();
        let view = self.view(&bytes);
        self.accessors.push(json!({
            "bufferView": view, "componentType": 5126, "count": rows.len(), "type": format!("VEC{N}"),
        }));
        self.accessors.len() - 1
    }
}

/// One file, of which everything depends on `random` alone.
pub(crate) fn glb(random: &mut Random) -> Vec<u8> {
    let mut buffer = Buffer::default();
    let attributes = attributes(random, &mut buffer);
    let image = image(random, &mut buffer);
    let scale = random.is_in_percent(30).then(|| [(); 3].map(|()| random.number(30)));
    let document = json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": ["KHR_texture_transform"],
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0, "scale": scale.unwrap_or([1.0; 3]) }],
        "meshes": [{ "primitives": [{
            "attributes": attributes,
            "material": 0,
            "mode": random.one_of(&[4, 4, 4, 5, 6, 1, 0]),
        }] }],
        "materials": [material(random)],
        "textures": [{ "source": 0, "sampler": 0 }],
        "samplers": [sampler(random)],
        "images": [{ "bufferView": image, "mimeType": "image/png" }],
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{ "byteLength": buffer.bytes.len() }],
    });
    container(document.to_string().into_bytes(), &buffer.bytes)
}

/// Positions and texture coordinates of some vertices, and sometimes normals, tangents and colours.
fn attributes(random: &mut Random, buffer: &mut Buffer) -> Map<String, Value> {
    let count = random.one_of(&[3, 6, 12, 30]);
    let unit = random.one_of(&[1.0, 1.0, 1.0, 1e-20, 1e-30, 1e10, 1e18]);
    let place = |random: &mut Random| random.vector(20).map(|side| side.clamp(-1e4, 1e4) * unit);
    let positions: Vec<[f32; 3]> = (0..count).map(|_| place(random)).collect();
    let bound = |of: fn(f32, f32) -> f32| {
        [0, 1, 2].map(|axis| positions.iter().map(|place| place[axis]).reduce(of))
    };
    let number = buffer.vectors(&positions);
    buffer.accessors[number]["min"] = json!(bound(f32::min));
    buffer.accessors[number]["max"] = json!(bound(f32::max));
    let mut attributes = Map::new();
    attributes.insert("POSITION".into(), number.into());
    let uvs: Vec<[f32; 2]> = (0..count).map(|_| random.vector(40)).collect();
    attributes.insert("TEXCOORD_0".into(), buffer.vectors(&uvs).into());
    if random.is_in_percent(60) {
        let normals: Vec<[f32; 3]> = (0..count).map(|_| random.vector(30)).collect();
        attributes.insert("NORMAL".into(), buffer.vectors(&normals).into());
    }
    if random.is_in_percent(40) {
        let tangent = |random: &mut Random| {
            let [x, y, z] = random.vector(30);
            [x, y, z, random.one_of(&[1.0, -1.0, 0.0, 1e-40])]
        };
        let tangents: Vec<[f32; 4]> = (0..count).map(|_| tangent(random)).collect();
        attributes.insert("TANGENT".into(), buffer.vectors(&tangents).into());
    }
    if random.is_in_percent(40) {
        let color = |random: &mut Random| random.vector(20).map(|channel| channel.abs().min(5.0));
        let colors: Vec<[f32; 4]> = (0..count).map(|_| color(random)).collect();
        attributes.insert("COLOR_0".into(), buffer.vectors(&colors).into());
    }
    attributes
}

/// The view of a small image.
fn image(random: &mut Random, buffer: &mut Buffer) -> usize {
    let [width, height] = random.one_of(&[[1, 1], [7, 3], [4, 4], [2, 9], [64, 1]]);
    let texel = |_| [(); 4].map(|()| (random.next() % 256) as u8);
    buffer.view(&Pixels { width, rgba: (0..width * height).map(texel).collect() }.to_png())
}

fn sampler(random: &mut Random) -> Map<String, Value> {
    let settings: [(&str, &[u32]); 4] = [
        ("wrapS", &[10497, 33648, 33071]),
        ("wrapT", &[10497, 33648, 33071]),
        ("magFilter", &[9728, 9729]),
        ("minFilter", &[9728, 9729, 9984, 9985, 9986, 9987]),
    ];
    let mut sampler = Map::new();
    for (name, values) in settings {
        if random.is_in_percent(80) {
            sampler.insert(name.into(), random.one_of(values).into());
        }
    }
    sampler
}

/// A material whose maps are the image, all transformed alike.
fn material(random: &mut Random) -> Value {
    let mut texture = json!({ "index": 0 });
    if random.is_in_percent(50) {
        let ([offset, scale], rotation) = ([(); 2].map(|()| random.vector(30)), random.number(30));
        let (offset, scale): ([f32; 2], [f32; 2]) = (offset, scale);
        let transform = json!({ "offset": offset, "scale": scale, "rotation": rotation });
        texture["extensions"] = json!({ "KHR_texture_transform": transform });
    }
    let mut material = json!({
        "pbrMetallicRoughness": {
            "baseColorTexture": texture,
            "metallicFactor": random.one_of(&[0.0, 0.5, 1.0]),
            "roughnessFactor": random.one_of(&[0.0, 1e-30, 0.001, 0.5, 1.0]),
        },
        "alphaMode": random.one_of(&["OPAQUE", "MASK", "BLEND"]),
        "doubleSided": random.is_in_percent(50),
    });
    if random.is_in_percent(30) {
        material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = texture.clone();
    }
    if random.is_in_percent(30) {
        material["emissiveTexture"] = texture.clone();
        material["emissiveFactor"] = json!([1.0, 0.5, 0.0]);
    }
    if random.is_in_percent(40) {
        material["normalTexture"] = texture;
        material["normalTexture"]["scale"] = json!(random.number(30));
    }
    material
}

/// The chunks of a GLB behind its header.
fn container(mut json: Vec<u8>, binary: &[u8]) -> Vec<u8> {
    json.resize(json.len().next_multiple_of(4), b' ');
    let word = |length: usize| (length as u32).to_le_bytes();
    let total = 12 + 8 + json.len() + 8 + binary.len();
    let header = [*b"glTF", word(2), word(total), word(json.len()), *b"JSON"];
    let between = [word(binary.len()), *b"BIN\0"];
    [header.as_flattened(), &json, between.as_flattened(), binary].concat()
}
