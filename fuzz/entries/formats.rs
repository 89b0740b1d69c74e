//! Any bytes as each format, and as what other files hold: textures, materials, compressed geometry.

#[path = "accepted.rs"]
mod accepted;

use accepted::{LIMITS, check, check_scene};
use luxel_formats::{Format, read, scene_settings};
use std::path::PathBuf;
use std::sync::OnceLock;

pub(crate) fn stl(bytes: &[u8]) {
    check(bytes, Format::Stl);
}

pub(crate) fn ply(bytes: &[u8]) {
    check(bytes, Format::Ply);
}

pub(crate) fn obj(bytes: &[u8]) {
    check(bytes, Format::Obj);
}

/// JSON, or one binary file.
pub(crate) fn gltf(bytes: &[u8]) {
    check(bytes, if bytes.starts_with(b"glTF") { Format::Glb } else { Format::Gltf });
}

pub(crate) fn scene(bytes: &[u8]) {
    check(bytes, Format::Toml);
    let _ = scene_settings(bytes, &LIMITS);
}

/// A library of materials beside an OBJ that uses some; textures that it names are missing.
pub(crate) fn mtl(bytes: &[u8]) {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| {
        let folder = std::env::temp_dir().join(format!("luxel-mtl-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder for the library");
        folder
    });
    std::fs::write(folder.join("m.mtl"), bytes).expect("the library is written");
    let obj = b"mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 2 3 1\n";
    if let Ok(loaded) = read(obj, Format::Obj, "stem", Some(folder), &LIMITS) {
        check_scene(&loaded.scene);
    }
}

/// A picture of an environment.
pub(crate) fn environment(bytes: &[u8]) {
    if let Ok((image, _)) = luxel_formats::decode_environment(bytes, &LIMITS) {
        assert_eq!(image.light.len() as u64, u64::from(image.width) * u64::from(image.height));
        let is_light = |channel: &f32| channel.is_finite() && *channel >= 0.0;
        assert!(image.light.as_flattened().iter().all(is_light));
    }
}

/// A texture in the least GLB that shows one.
pub(crate) fn image(bytes: &[u8]) {
    let json = format!(
        r#""nodes":[{{"mesh":0}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"material":0}}]}}],
        "accessors":[{{"componentType":5126,"count":3,"type":"VEC3"}}],
        "materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}}}}}}],
        "textures":[{{"source":0}}],"images":[{{"bufferView":0,"mimeType":"image/png"}}],
        "bufferViews":[{{"buffer":0,"byteLength":{0}}}],"buffers":[{{"byteLength":{0}}}]"#,
        bytes.len()
    );
    if let Ok(loaded) = read(&glb(&json, bytes), Format::Glb, "stem", None, &LIMITS) {
        for texture in loaded.scene.textures {
            assert!(texture.image.levels.iter().all(|level| {
                level.texels.len() as u64 == u64::from(level.width) * u64::from(level.height)
            }));
        }
    }
}

/// A Draco stream with the usual attributes.
pub(crate) fn draco(bytes: &[u8]) {
    let json = format!(
        r#""extensionsUsed":["KHR_draco_mesh_compression"],
        "extensionsRequired":["KHR_draco_mesh_compression"],"nodes":[{{"mesh":0}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":1,"NORMAL":2,"TEXCOORD_0":3,"COLOR_0":4}},
        "indices":0,"extensions":{{"KHR_draco_mesh_compression":{{"bufferView":0,
        "attributes":{{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"COLOR_0":3}}}}}}}}]}}],
        "accessors":[{{"type":"SCALAR","componentType":5123,"count":150}},
        {{"type":"VEC3","componentType":5126,"count":36}},{{"type":"VEC3","componentType":5126,"count":36}},
        {{"type":"VEC2","componentType":5126,"count":36}},
        {{"type":"VEC4","componentType":5121,"count":36,"normalized":true}}],
        "bufferViews":[{{"buffer":0,"byteLength":{0}}}],"buffers":[{{"byteLength":{0}}}]"#,
        bytes.len()
    );
    check(&glb(&json, bytes), Format::Glb);
}

/// A meshopt stream after four bytes that choose mode and filter, stride, and the count of elements.
pub(crate) fn meshopt(bytes: &[u8]) {
    let &[kind, stride, low, high, ref stream @ ..] = bytes else { return };
    let mode = ["ATTRIBUTES", "TRIANGLES", "INDICES"][usize::from(kind % 3)];
    let filter = ["NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"][usize::from(kind / 3 % 4)];
    let count = u16::from_le_bytes([low, high]);
    let (stride, accessors, attributes) = if mode == "ATTRIBUTES" {
        // Positions where they fit, else colours of one or two bytes a channel.
        let stride = [4, 8, 12, 16, 20, 32, 3, 252][usize::from(stride % 8)];
        let compressed = match stride {
            4 => r#"5121,"normalized":true,"type":"VEC4""#,
            8 => r#"5123,"normalized":true,"type":"VEC4""#,
            _ => r#"5126,"type":"VEC3""#,
        };
        let compressed =
            format!(r#"{{"bufferView":0,"count":{count},"componentType":{compressed}}}"#);
        let plain = format!(r#"{{"count":{count},"componentType":5126,"type":"VEC3"}}"#);
        let attributes = match stride {
            4 | 8 => r#""attributes":{"POSITION":1,"COLOR_0":0}"#,
            _ => r#""attributes":{"POSITION":0}"#,
        };
        (stride, format!("{compressed},{plain}"), attributes)
    } else {
        let (stride, component) = [(2, 5123), (4, 5125)][usize::from(stride % 2)];
        let indices = format!(
            r#"{{"bufferView":0,"count":{count},"componentType":{component},"type":"SCALAR"}}"#
        );
        let plain = r#"{"count":300,"componentType":5126,"type":"VEC3"}"#;
        (stride, format!("{indices},{plain}"), r#""attributes":{"POSITION":1},"indices":0"#)
    };
    let whole = u32::from(count) * stride;
    let length = stream.len();
    let json = format!(
        r#""extensionsUsed":["EXT_meshopt_compression"],
        "extensionsRequired":["EXT_meshopt_compression"],"nodes":[{{"mesh":0}}],
        "meshes":[{{"primitives":[{{{attributes}}}]}}],"accessors":[{accessors}],
        "bufferViews":[{{"buffer":1,"byteLength":{whole},"extensions":{{"EXT_meshopt_compression":{{
        "buffer":0,"byteLength":{length},"byteStride":{stride},"count":{count},"mode":"{mode}",
        "filter":"{filter}"}}}}}}],"buffers":[{{"byteLength":{length}}},
        {{"byteLength":{whole},"extensions":{{"EXT_meshopt_compression":{{"fallback":true}}}}}}]"#
    );
    check(&glb(&json, stream), Format::Glb);
}

/// A GLB of a document's members and a binary chunk.
fn glb(members: &str, binary: &[u8]) -> Vec<u8> {
    let asset = r#""asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}]"#;
    let mut json = format!("{{{asset},{members}}}").into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut binary = binary.to_vec();
    binary.resize(binary.len().next_multiple_of(4), 0);
    let total = 12 + 8 + json.len() + 8 + binary.len();
    let mut glb = Vec::with_capacity(total);
    glb.extend(b"glTF\x02\0\0\0");
    glb.extend((total as u32).to_le_bytes());
    glb.extend((json.len() as u32).to_le_bytes());
    glb.extend(b"JSON");
    glb.extend(json);
    glb.extend((binary.len() as u32).to_le_bytes());
    glb.extend(b"BIN\0");
    glb.extend(binary);
    glb
}
