//! Files of odd numbers: denormal, huge and almost equal ones in every attribute, with every filter, wrap and transform of
//! textures. A file is refused with an error, or drawn with the same bytes however it is run.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel::Settings;
use luxel::formats::{Format, Limits, read};
use luxel::math::SimdLevel;
use luxel::pick::{PhysicalPosition, PickView, Picker};
use luxel::render::{Execution, Renderer};
use luxel::scene::Size;
use luxel_testing::golden::Pixels;
use std::fmt::Write as _;
use std::sync::Arc;

/// How many files are read.
const FILES: u64 = 400;
const TINY: [f32; 10] = [0.0, -0.0, 1e-45, -1e-45, 1e-38, -1e-38, 1e-30, -1e-20, 1e-10, -1e-7];
const COMMON: [f32; 9] = [1.0, -1.0, 0.5, 0.25, 2.0, -3.0, 0.999_999, 1.000_000_1, 7.5];
const HUGE: [f32; 8] = [1e7, -1e8, 8_388_608.0, 16_777_217.0, 1e15, -1e20, 3e38, -3e38];

/// xorshift64* (Vigna 2016).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 16
    }

    fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.next() % choices.len() as u64) as usize]
    }

    /// Whether something happens that does in `percent` of all cases.
    fn in_percent(&mut self, percent: u64) -> bool {
        self.next() % 100 < percent
    }

    /// A number, a tiny one in `tiny` percent of all cases.
    fn number(&mut self, tiny: u64) -> f32 {
        if self.in_percent(tiny) {
            self.one_of(&TINY)
        } else if self.in_percent(4) {
            self.one_of(&HUGE)
        } else if self.in_percent(50) {
            self.one_of(&COMMON)
        } else {
            (self.next() % 4001) as f32 / 1000.0 - 2.0
        }
    }
}

/// A GLB in the making.
#[derive(Default)]
struct File {
    binary: Vec<u8>,
    views: String,
    accessors: String,
    attributes: String,
    count: usize,
}

impl File {
    /// Appends a buffer view; its number.
    fn view(&mut self, bytes: &[u8]) -> usize {
        let number = self.views.matches('{').count();
        let comma = if number > 0 { "," } else { "" };
        let (start, length) = (self.binary.len(), bytes.len());
        write!(self.views, r#"{comma}{{"buffer":0,"byteOffset":{start},"byteLength":{length}}}"#)
            .unwrap();
        self.binary.extend(bytes);
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        number
    }

    /// An attribute of floats; `bounds` is JSON with those of positions.
    fn attribute<const N: usize>(&mut self, name: &str, rows: &[[f32; N]], bounds: &str) {
        let bytes: Vec<u8> = rows.iter().flatten().flat_map(|value| value.to_le_bytes()).collect();
        let view = self.view(&bytes);
        let comma = if self.count > 0 { "," } else { "" };
        write!(self.attributes, r#"{comma}"{name}":{}"#, self.count).unwrap();
        let count = rows.len();
        write!(
            self.accessors,
            r#"{comma}{{"bufferView":{view},"componentType":5126,"count":{count},"type":"VEC{N}"{bounds}}}"#
        )
        .unwrap();
        self.count += 1;
    }
}

/// One file; whatever is drawn depends on `random` alone.
fn glb(random: &mut Random) -> Vec<u8> {
    let count = random.one_of(&[3, 6, 12, 30]);
    let mut file = File::default();
    let scale = random.one_of(&[1.0, 1.0, 1.0, 1e-20, 1e-30, 1e10, 1e18]);
    let positions: Vec<[f32; 3]> = (0..count)
        .map(|_| [(); 3].map(|()| (random.number(20).clamp(-1e4, 1e4) * scale).clamp(-3e38, 3e38)))
        .collect();
    let bound = |of: fn(f32, f32) -> f32| {
        [0, 1, 2].map(|axis| positions.iter().map(|place| place[axis]).reduce(of).unwrap())
    };
    let bounds = format!(r#","min":{:?},"max":{:?}"#, bound(f32::min), bound(f32::max));
    file.attribute("POSITION", &positions, &bounds);
    let mut rows =
        |tiny| (0..count).map(|_| [(); 4].map(|()| random.number(tiny))).collect::<Vec<_>>();
    let (normals, tangents, uvs, colors) = (rows(30), rows(30), rows(40), rows(20));
    if random.in_percent(60) {
        file.attribute(
            "NORMAL",
            &normals.iter().map(|&[x, y, z, _]| [x, y, z]).collect::<Vec<_>>(),
            "",
        );
    }
    if random.in_percent(40) {
        let signs =
            tangents.iter().map(|&[x, y, z, _]| [x, y, z, random.one_of(&[1.0, -1.0, 0.0, 1e-40])]);
        file.attribute("TANGENT", &signs.collect::<Vec<_>>(), "");
    }
    file.attribute("TEXCOORD_0", &uvs.iter().map(|&[u, v, ..]| [u, v]).collect::<Vec<_>>(), "");
    if random.in_percent(40) {
        let colors = colors.iter().map(|color| color.map(|channel| channel.abs().min(5.0)));
        file.attribute("COLOR_0", &colors.collect::<Vec<_>>(), "");
    }
    let [width, height] = random.one_of(&[[1, 1], [7, 3], [4, 4], [2, 9], [64, 1]]);
    let texel = |_| [(); 4].map(|()| (random.next() % 256) as u8);
    let image = Pixels { width, rgba: (0..width * height).map(texel).collect() }.to_png();
    let image = file.view(&image);

    let mut sampler = String::new();
    for (name, values) in [
        ("wrapS", &[10497, 33648, 33071][..]),
        ("wrapT", &[10497, 33648, 33071]),
        ("magFilter", &[9728, 9729]),
        ("minFilter", &[9728, 9729, 9984, 9985, 9986, 9987]),
    ] {
        if random.in_percent(80) {
            let comma = if sampler.is_empty() { "" } else { "," };
            write!(sampler, r#"{comma}"{name}":{}"#, random.one_of(values)).unwrap();
        }
    }
    let mut numbers = [(); 6].map(|()| random.number(30));
    let transform = if random.in_percent(50) {
        let [a, b, c, d, e, _] = numbers;
        format!(
            r#","extensions":{{"KHR_texture_transform":{{"offset":[{a:?},{b:?}],"scale":[{c:?},{d:?}],"rotation":{e:?}}}}}"#
        )
    } else {
        String::new()
    };
    let texture = format!(r#"{{"index":0{transform}}}"#);
    let roughness = random.one_of(&[0.0, 1e-30, 0.001, 0.5, 1.0]);
    let metallic = random.one_of(&[0.0, 0.5, 1.0]);
    let mut maps = String::new();
    if random.in_percent(40) {
        write!(maps, r#","normalTexture":{{"index":0{transform},"scale":{:?}}}"#, numbers[5])
            .unwrap();
    }
    if random.in_percent(30) {
        write!(maps, r#","emissiveTexture":{texture},"emissiveFactor":[1,0.5,0]"#).unwrap();
    }
    let metal_map = if random.in_percent(30) {
        format!(r#","metallicRoughnessTexture":{texture}"#)
    } else {
        String::new()
    };
    if random.in_percent(70) {
        numbers = [1.0; 6];
    }
    let [x, y, z, ..] = numbers;
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"extensionsUsed":["KHR_texture_transform"],"scene":0,"scenes":[{{"nodes":[0]}}],
        "nodes":[{{"mesh":0,"scale":[{x:?},{y:?},{z:?}]}}],
        "meshes":[{{"primitives":[{{"attributes":{{{attributes}}},"material":0,"mode":{mode}}}]}}],
        "materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{texture},"metallicFactor":{metallic:?},
        "roughnessFactor":{roughness:?}{metal_map}}},"alphaMode":"{alpha}","doubleSided":{sides}{maps}}}],
        "textures":[{{"source":0,"sampler":0}}],"samplers":[{{{sampler}}}],
        "images":[{{"bufferView":{image},"mimeType":"image/png"}}],
        "accessors":[{accessors}],"bufferViews":[{views}],"buffers":[{{"byteLength":{length}}}]}}"#,
        attributes = file.attributes,
        mode = random.one_of(&[4, 4, 4, 5, 6, 1, 0]),
        alpha = random.one_of(&["OPAQUE", "MASK", "BLEND"]),
        sides = random.in_percent(50),
        accessors = file.accessors,
        views = file.views,
        length = file.binary.len(),
    );
    let mut json = json.into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let word = |length: usize| (length as u32).to_le_bytes();
    let total = 12 + 8 + json.len() + 8 + file.binary.len();
    let header = [*b"glTF", word(2), word(total), word(json.len()), *b"JSON"];
    let between = [word(file.binary.len()), *b"BIN\0"];
    [header.as_flattened(), &json, between.as_flattened(), &file.binary].concat()
}

#[test]
fn files_of_odd_numbers_are_refused_or_have_the_same_bytes_however_they_are_run() {
    let mut drawn = 0;
    for number in 1..=FILES {
        let mut random = Random(number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let bytes = glb(&mut random);
        let Ok(loaded) = read(&bytes, Format::Glb, "odd", None, &Limits::default()) else {
            continue;
        };
        let scene = Arc::new(loaded.scene);
        let settings = [
            ("size", random.one_of(&["33x21", "16x16", "5x3"])),
            ("samples", random.one_of(&["1", "4"])),
            ("shading", random.one_of(&["flat", "gouraud", "phong", "subdivided"])),
        ];
        // What has no extent can't be seen.
        let Ok(view) = Settings::new(settings).unwrap().view(&scene) else { continue };
        let view = view.with_shadows(random.in_percent(30));
        let Size { width, height } = view.size;
        let mut first = None;
        for (threads, simd) in [1, 3, 2].into_iter().cycle().zip(SimdLevel::available()) {
            let execution = Execution { threads, simd, ..Execution::default() };
            let renderer = Renderer::new(Arc::clone(&scene), &execution).unwrap();
            let picture = renderer.rgba8(&view).unwrap().pixels;
            let places = [[0, 0], [width / 2, height / 2], [width / 3, height - 1]];
            for explained in renderer.explain_pixels(&view, &places).unwrap() {
                let [x, y] = explained.pixel;
                let shown = picture[(y * width + x) as usize];
                assert_eq!(explained.rgba8, shown, "file {number}, {simd}: {x}, {y}");
            }
            let first = first.get_or_insert_with(|| picture.clone());
            assert!(*first == picture, "file {number} differs at {simd}, {threads} threads");
        }
        let picker = Picker::new(Arc::clone(&scene)).unwrap();
        let picks = PickView::new(&picker, view.camera, view.size, view.cull).unwrap();
        let hits = picks.through(PhysicalPosition::centre_of(width / 2, height / 2));
        let distances: Vec<_> = hits.iter().map(|hit| hit.distance).collect();
        // Triangles of 1e-18 units have volumes below what f32 holds.
        let is_measurable = (1e-14..1e14).contains(&scene.bounds().radius());
        // The first is the one that is shown, by depths rounded to f32.
        let in_order = distances.is_sorted_by(|near, far| *near <= far * 1.0001);
        assert!(in_order || !is_measurable, "file {number}: {distances:?}");
        drawn += 1;
    }
    assert!(drawn > FILES / 2, "{drawn} of {FILES} are drawn");
}
