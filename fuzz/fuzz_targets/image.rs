//! Any bytes as a texture, in the least GLB that shows one.

#![no_main]

use luxel_formats::{Format, Limits, read};

const LIMITS: Limits = Limits { max_memory: 64 << 20, max_depth: 64, progress: None };

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let length = bytes.len();
    let mut json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"material":0}}]}}],
        "accessors":[{{"componentType":5126,"count":3,"type":"VEC3"}}],
        "materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}}}}}}],
        "textures":[{{"source":0}}],"images":[{{"bufferView":0,"mimeType":"image/png"}}],
        "bufferViews":[{{"buffer":0,"byteLength":{length}}}],"buffers":[{{"byteLength":{length}}}]}}"#
    )
    .into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut binary = bytes.to_vec();
    binary.resize(length.next_multiple_of(4), 0);
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
    if let Ok(loaded) = read(&glb, Format::Glb, "stem", None, &LIMITS) {
        for texture in loaded.scene.textures {
            assert!(texture.image.levels.iter().all(|level| {
                level.texels.len() as u64 == u64::from(level.width) * u64::from(level.height)
            }));
        }
    }
});
